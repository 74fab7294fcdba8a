// SPDX-License-Identifier: BSD-3-Clause
// Files that are composed come with their tree: it must be the one that the parser makes of their bytes, node by node and span
// by span.
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <composed.h>
#include <orbslam3/layout.h>
#include <orbslam3/settings.h>

#include <fca/formats/format.h>
#include <fca/formats/text/limits.h>

#include <array>
#include <set>
#include <sstream>
#include <string_view>

#include <rapidcheck/gtest.h>

namespace fca::test {
namespace {

void describe(const text::Node& node, const std::string& indentation, std::ostream& out) {
  out << static_cast<int>(node.kind) << " at " << node.span.offset << "+" << node.span.length << (node.flow ? " flow" : "")
      << (node.quoted ? " quoted" : "") << " tag '" << node.tag << "' '" << node.value << "'\n";
  for (const text::Node& item : node.items) {
    out << indentation << "- ";
    describe(item, indentation + "  ", out);
  }
  for (const text::Entry& entry : node.entries) {
    out << indentation << "key ";
    describe(entry.key, indentation + "  ", out);
    out << indentation << "value ";
    describe(entry.value, indentation + "  ", out);
  }
}

/// All that a document's tree says, as text.
std::string tree_of(const text::Document& document) {
  std::ostringstream out;
  out << "syntax " << static_cast<int>(document.syntax()) << "\n";
  describe(document.root(), "", out);
  return out.str();
}

std::string tree_as_parsed(const text::Document& document) {
  return tree_of(document_of(document.bytes(), document.source().name));
}

/// Rewrites the rig; true if the format holds it.
bool trees_are_as_parsed(const Format& format, const Rig& rig, const WriteOptions& options) {
  Diagnostics diagnostics;
  const std::optional<Written> written = format.write(nullptr, rig, options, diagnostics);
  if (!written) return false;
  for (const Written::File& file : written->files)
    EXPECT_EQ(tree_of(file.document), tree_as_parsed(file.document)) << file.document.bytes();
  return true;
}

/// One and two cameras of a model, with and without an IMU, a baseline, time offsets, topics and frame rates.
std::vector<Rig> rigs_of(const std::string& model) {
  std::vector<Rig> rigs;
  for (const RigShape& shape : {RigShape{}, RigShape{true, false}, RigShape{false, true}, RigShape{true, true}}) {
    Rig rig = sample_rig(model, shape);
    rigs.push_back(rig);
    for (Camera& camera : rig.cameras) {
      camera.time_offset_s = -0.00123;
      camera.frame_rate_hz = 29.97;
    }
    if (!shape.two) rig.baseline_m = 0.11;
    rigs.push_back(rig);
  }
  return rigs;
}

template <class T>
std::vector<T> or_default(std::span<const T> all) {
  return all.empty() ? std::vector<T>{T()} : std::vector<T>(all.begin(), all.end());
}

TEST(Composed, EveryModelLayoutAndMode) {
  for (const std::string_view id : {"kalibr", "openvins", "orbslam3", "vins"}) {
    const Format& format = *find_format(id);
    int written = 0;
    for (const ModelInfo& model : all_models()) {
      for (const Rig& rig : rigs_of(std::string(model.id))) {
        for (const std::string_view layout : or_default(format.layouts)) {
          for (const std::string_view mode : or_default(format.modes)) {
            SCOPED_TRACE(std::string(format.id) + " " + std::string(model.id) + " " + std::string(layout) + " " +
                         std::string(mode));
            WriteOptions options;
            options.layout = layout;
            options.sensor = mode;
            written += trees_are_as_parsed(format, rig, options) ? 1 : 0;
          }
        }
      }
    }
    EXPECT_GT(written, 0) << format.id;
  }
}

TEST(Composed, EveryModelOfEveryStyleOfOrbSlam3) {
  const Format& format = *find_format("orbslam3");
  for (const orbslam3::StyleName& style : orbslam3::kStyleNames) {
    for (const orbslam3::Layout& layout : orbslam3::layouts()) {
      if (layout.style != style.style) continue;
      SCOPED_TRACE(std::string(style.name) + " " + std::string(layout.model));
      WriteOptions options;
      options.layout = style.name;
      EXPECT_TRUE(trees_are_as_parsed(format, sample_rig(std::string(layout.model), {}), options));
    }
  }
}

TEST(Composed, EveryModeOfOrbSlam3) {
  std::set<std::string_view> written;
  for (const orbslam3::Sensor& sensor : orbslam3::kSensors) {
    for (const Rig& rig : rigs_of("radtan")) {
      WriteOptions options;
      options.sensor = sensor.id;
      if (trees_are_as_parsed(*find_format("orbslam3"), rig, options)) written.insert(sensor.id);
    }
  }
  EXPECT_EQ(written.size(), orbslam3::kSensors.size());
}

TEST(Composed, EveryGoodFileInEveryFormatThatHoldsIt) {
  int written = 0;
  for (const fs::path& path : files_of_all_formats("good")) {
    Diagnostics diagnostics;
    const std::optional<text::Document> document = text::read_document(path.string(), diagnostics);
    if (!document) continue;
    const std::optional<Calibration> calibration = read_calibration({*document}, nullptr, {}, diagnostics);
    if (!calibration) continue;
    for (const Format& format : written_formats()) {
      SCOPED_TRACE(path.string() + " to " + std::string(format.id));
      written += trees_are_as_parsed(format, calibration->rig, {}) ? 1 : 0;
    }
  }
  EXPECT_GT(written, 100);
}

TEST(Composed, CommentsAndMappings) {
  ComposedYaml composed("%YAML:1.0\n# \xC2\xB0 key: [value\n---\n\n");
  composed.add(fields::quoted("name", "[a: #b, 'c'"));
  composed.add_comments("\n# Camera.fx: 3\n");
  composed.add_mapping("inner", {fields::list("none", {}), fields::matrix("M", std::array{1.0, 2.0, -3e-20, 0.0}, 2, "d")}, 3);
  composed.add(fields::rows("T", Transform{}));
  composed.add_comments("# end\n");
  Diagnostics diagnostics;
  const std::optional<text::Document> document = std::move(composed).document("c.yaml", diagnostics);
  ASSERT_TRUE(document);
  EXPECT_EQ(document->bytes(),
            "%YAML:1.0\n# \xC2\xB0 key: [value\n---\n\nname: \"[a: #b, 'c'\"\n\n# Camera.fx: 3\ninner:\n   none: []\n"
            "   M: !!opencv-matrix\n     rows: 2\n     cols: 2\n     dt: d\n     data: [1.0, 2.0,\n            -3.0e-20, 0.0]\n"
            "T:\n  - [1.0, 0.0, 0.0, 0.0]\n  - [0.0, 1.0, 0.0, 0.0]\n  - [0.0, 0.0, 1.0, 0.0]\n  - [0.0, 0.0, 0.0, 1.0]\n"
            "# end\n");
  EXPECT_EQ(tree_of(*document), tree_as_parsed(*document));
}

/// A number or a word; sometimes with something in it that YAML takes for something else.
std::string random_token() {
  static const std::vector<std::string> kPlain = {"0", "-1.5", "2.0e-07", "word", "/cam0/image_raw", "a.b_c", "-x", "e+"};
  static const std::vector<std::string> kOdd = {
      "",  "null", "NULL", "~",    "yes",  ":",  ": ", " #", " ", "\"", "\\", "'",  "[",    "]",   "{",   ",",  "!", "&",
      "*", "|",    "%",    "\xC3", "\xA9", "\n", "?",  "@",  "`", ">",  "<",  "\t", "\x01", "...", "---", "- ", "."};
  const std::string token = *rc::gen::elementOf(kPlain);
  switch (*rc::gen::weightedElement<int>({{30, 0}, {1, 1}, {1, 2}, {1, 3}})) {
    case 1:
      return *rc::gen::elementOf(kOdd) + token;
    case 2:
      return token + *rc::gen::elementOf(kOdd);
    case 3:
      return *rc::gen::elementOf(kOdd);
    default:
      return token;
  }
}

fields::Field random_field(bool words) {
  const auto token = [words] { return words ? random_token() : fields::quote(random_token()); };
  fields::Field field = fields::scalar(random_token(), token());
  field.shape = *rc::gen::elementOf(
      std::vector{fields::Shape::kScalar, fields::Shape::kList, fields::Shape::kRows, fields::Shape::kMatrix});
  for (int i = *rc::gen::inRange(0, 8); i > 0; --i) field.tokens.push_back(token());
  field.columns = *rc::gen::inRange(0, 4);
  field.element_type = *rc::gen::elementOf(std::vector<std::string>{"f", "f", "d", "null"});
  return field;
}

void is_as_parsed(const std::vector<fields::Field>& some, bool in_mapping, const std::string& head) {
  ComposedYaml composed(head);
  std::string bytes = head;
  if (in_mapping) bytes += "outer:\n";
  for (const fields::Field& field : some) {
    bytes += fields::spell(field, in_mapping ? 2 : 0) + "\n";
    if (!in_mapping) composed.add(field);
  }
  if (in_mapping) composed.add_mapping("outer", some, 2);
  Diagnostics said;
  const std::optional<text::Document> document = std::move(composed).document("c.yaml", said);
  const Parsed parsed = parse(bytes, "c.yaml");
  RC_LOG(bytes);
  RC_ASSERT(document.has_value() == parsed.document.has_value());
  RC_ASSERT(said.entries().size() == parsed.diagnostics.entries().size());
  if (!document) return;
  RC_ASSERT(document->bytes() == bytes);
  RC_ASSERT(tree_of(*document) == tree_of(*parsed.document));
}

RC_GTEST_PROP(Composed, AnyFieldsAreAsParsed, ()) {
  for (int run = 0; run < 10; ++run) {
    const bool words = *rc::gen::arbitrary<bool>();
    std::vector<fields::Field> some;
    for (int i = *rc::gen::inRange(0, 8); i > 0; --i) some.push_back(random_field(words));
    is_as_parsed(some, *rc::gen::arbitrary<bool>(),
                 *rc::gen::elementOf(std::vector<std::string>{"", "%YAML:1.0\n", "%YAML:1.0\n---\n", "# comment\n\n"}));
  }
}

// The parser's limits are the composed file's, too.
TEST(Composed, WhatIsTooLongIsRefused) {
  const auto document_with = [](const fields::Field& field) {
    ComposedYaml composed("");
    composed.add(field);
    Diagnostics diagnostics;
    return std::move(composed).document("c.yaml", diagnostics);
  };
  fields::Field list{"list", fields::Shape::kList, std::vector<std::string>(text::kLongestList, "1"), 0, {}};
  EXPECT_TRUE(document_with(list));
  list.tokens.emplace_back("1");
  EXPECT_FALSE(document_with(list));
  EXPECT_TRUE(document_with(fields::integer(std::string(1000, 'k'), 1)));
  EXPECT_FALSE(document_with(fields::integer(std::string(2000, 'k'), 1)));
}

}  // namespace
}  // namespace fca::test
