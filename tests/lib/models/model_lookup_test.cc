// SPDX-License-Identifier: BSD-3-Clause
// Finding models and parameters by name.
#include "model_test_support.h"

#include <cctype>
#include <set>

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
    for (const Parameter& p : info.parameters) EXPECT_TRUE(set_parameter(model, p.name, next++)) << p.name;
    next = 1.0;
    for (const Parameter& p : info.parameters) EXPECT_EQ(parameter(model, p.name), next++) << p.name;
    const CameraModel copy = model;
    EXPECT_FALSE(set_parameter(model, "no_such_parameter", 7.0));
    EXPECT_EQ(model, copy);
    EXPECT_FALSE(parameter(model, "no_such_parameter"));
    EXPECT_FALSE(parameter(model, ""));
  }
}

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
