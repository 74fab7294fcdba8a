// SPDX-License-Identifier: BSD-3-Clause
// Finding models and parameters by name.
#include "model_test_support.h"

#include <cctype>
#include <set>
#include <type_traits>

#include <rapidcheck/gtest.h>

namespace fca::test {
namespace {

std::string upper_case_with_underscores(std::string_view name) {
  std::string result;
  for (const char c : name) result += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

TEST(ModelLookup, EveryIdAndAliasInAnyCaseAndWithUnderscores) {
  for (const ModelInfo& info : all_models()) {
    std::vector<std::string_view> names(info.aliases.begin(), info.aliases.end());
    names.push_back(info.id);
    for (const std::string_view name : names) {
      EXPECT_EQ(find_model(name), &info) << name;
      EXPECT_EQ(find_model(upper_case_with_underscores(name)), &info) << name;
    }
  }
}

TEST(ModelLookup, NoNameBelongsToTwoModels) {
  std::set<std::string_view> seen;
  for (const ModelInfo& info : all_models()) {
    EXPECT_TRUE(seen.insert(info.id).second) << info.id;
    for (const std::string_view alias : info.aliases) EXPECT_TRUE(seen.insert(alias).second) << alias;
  }
}

TEST(ModelLookup, NamesOfOtherPrograms) {
  const std::vector<std::pair<std::string_view, std::string_view>> names = {{"KannalaBrandt8", "kb4"},
                                                                            {"pinhole-equi", "kb4"},
                                                                            {"equidistant", "kb4"},
                                                                            {"omni-radtan", "mei"},
                                                                            {"eucm-none", "eucm"},
                                                                            {"DoubleSphere", "ds"},
                                                                            {"ds-none", "ds"},
                                                                            {"pinhole-radtan", "radtan"},
                                                                            {"plumb_bob", "radtan"},
                                                                            {"pinhole-fov", "fov"},
                                                                            {"rational_polynomial", "rational"},
                                                                            {"scaramuzza", "ocamcalib"},
                                                                            {"radial_poly", "woodscape"},
                                                                            {"PinHole", "pinhole"}};
  for (const auto& [name, id] : names) {
    ASSERT_NE(find_model(name), nullptr) << name;
    EXPECT_EQ(find_model(name)->id, id) << name;
  }
}

TEST(ModelLookup, UnknownNamesFindNothing) {
  for (const std::string_view name : {"", " ", "kb", "kb4 ", "kb44", "k b4", "pin hole", "none-such", "\xff"}) {
    EXPECT_EQ(find_model(name) == nullptr, name != "kb") << name;
  }
  EXPECT_FALSE(make_model("KB4"));  // make_model takes exact ids only
  EXPECT_FALSE(make_model("equidistant"));
  EXPECT_FALSE(make_model(""));
}

TEST(ModelLookup, MadeModelsAreZeroAndOfTheirKind) {
  for (const ModelInfo& info : all_models()) {
    const auto model = make_model(info.id);
    ASSERT_TRUE(model);
    EXPECT_EQ(&model_info(*model), &info);
    EXPECT_EQ(parameter_values(*model).size(), info.parameters.size());
    for (const double value : parameter_values(*model)) EXPECT_EQ(value, 0.0);
  }
}

TEST(ModelLookup, ParametersByName) {
  for (const ModelInfo& info : all_models()) {
    CameraModel model = *make_model(info.id);
    double next = 1.0;
    for (const Parameter& p : info.parameters) EXPECT_TRUE(set_parameter(model, ParameterId(p), next++)) << p.name;
    next = 1.0;
    for (const Parameter& p : info.parameters) EXPECT_EQ(parameter(model, ParameterId(p)), next++) << p.name;
  }
}

TEST(ModelLookup, ParametersOfOtherModelsAreNeitherReadNorSet) {
  for (const ModelInfo& info : all_models()) {
    CameraModel model = *make_model(info.id);
    for (const ModelInfo& other : all_models()) {
      for (const Parameter& p : other.parameters) {
        const bool own = std::ranges::find(info.parameters, p.name, &Parameter::name) != info.parameters.end();
        EXPECT_EQ(parameter(model, ParameterId(p)).has_value(), own) << info.id << " " << p.name;
        const CameraModel before = model;
        EXPECT_EQ(set_parameter(model, ParameterId(p), 7.0), own) << info.id << " " << p.name;
        EXPECT_EQ(model == before, !own) << info.id << " " << p.name;
        set_parameter(model, ParameterId(p), 0.0);
      }
    }
  }
}

TEST(ModelLookup, IdsOfNamesAtRunTime) {
  for (const ModelInfo& info : all_models()) {
    for (const Parameter& p : info.parameters) EXPECT_EQ(ParameterId::find(p.name), ParameterId(p)) << p.name;
  }
  for (const std::string_view name : {"", " ", "f", "fx ", "FX", "fxx", "no_such_parameter"})
    EXPECT_FALSE(ParameterId::find(name)) << name;
  EXPECT_EQ(ParameterId::find("k1"), ParameterId("k1"));
  EXPECT_NE(ParameterId("k1"), ParameterId("k2"));
}

RC_GTEST_PROP(ModelLookup, OnlyNamesInTheTablesAreIds, (const std::string& text)) {
  const auto has_it = [&text](const ModelInfo& info) {
    return std::ranges::find(info.parameters, std::string_view(text), &Parameter::name) != info.parameters.end();
  };
  const std::optional<ParameterId> id = ParameterId::find(text);
  RC_ASSERT(id.has_value() == std::ranges::any_of(all_models(), has_it));
  if (id) RC_ASSERT(id->name() == text);
}

RC_GTEST_PROP(ModelLookup, WhatIsSetIsWhatIsReadAndNothingElse, (double value)) {
  const ModelInfo& info = all_models()[*rc::gen::inRange<std::size_t>(0, all_models().size())];
  CameraModel model = *make_model(info.id);
  const auto place = *rc::gen::inRange<std::size_t>(0, info.parameters.size());
  RC_ASSERT(set_parameter(model, ParameterId(info.parameters[place]), value));
  for (std::size_t i = 0; i < info.parameters.size(); ++i)
    RC_ASSERT(parameter(model, ParameterId(info.parameters[i])) == (i == place ? value : 0.0));
}

/// A name as a template argument, so that one may ask whether it compiles.
template <std::size_t N>
struct Literal {
  consteval Literal(const char (&letters)[N]) { std::copy_n(letters, N, text); }
  char text[N];
};
template <Literal kName>
concept NamesAParameter = requires {
  typename std::bool_constant<!ParameterId(kName.text).name().empty()>;
};

static_assert(NamesAParameter<"fx"> && NamesAParameter<"aspect_ratio"> && NamesAParameter<"a8">);
static_assert(!NamesAParameter<"fz"> && !NamesAParameter<"Fx"> && !NamesAParameter<"k7"> && !NamesAParameter<"">);

TEST(ModelLookup, EqualityIsOfKindAndValues) {
  CameraModel a = *make_model("radtan");
  CameraModel b = a;
  EXPECT_EQ(a, b);
  set_parameter(b, "k3", 1e-300);
  EXPECT_NE(a, b);
  EXPECT_NE(*make_model("ucm"), *make_model("fov"));
}

}  // namespace
}  // namespace fca::test
