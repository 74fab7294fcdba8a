// SPDX-License-Identifier: BSD-3-Clause
// Every good file, broken at random places: it keeps all promises (promises.h), and it never says something else without a
// word. What a file says may change silently only with a value that was changed, or with a key that is simply not there (or
// more there) now. A key that has become another one is no such thing: what it stated would be lost and nobody told.
#include "mutations.h"

#include "formats/test_files.h"
#include "promises.h"
#include "ruins.h"
#include "sanitized.h"

#include <fca/formats/text/numbers.h>

#include <cstdio>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace fca::test {
namespace {

/// Per file; the files are more than 70. Sanitizers look at what code does, for which fewer are enough.
int mutations() { return is_sanitized() ? 30 : 100; }

/// What every leaf of a document says, under the path of keys and numbers that leads to it.
using Leaves = std::map<std::string, std::string>;

// Recursive, but no deeper than text::kMaxDepth.
void collect(const text::Node& node, const std::string& path, Leaves& leaves) {
  for (std::size_t i = 0; i < node.items.size(); ++i) collect(node.items[i], path + "/" + std::to_string(i), leaves);
  for (const text::Entry& entry : node.entries) collect(entry.value, path + "/" + entry.key.value, leaves);
  if (!node.items.empty() || !node.entries.empty()) return;
  const std::optional<double> number = text::parse_real(node.value);
  leaves.emplace(path, number ? text::format_real(*number) : node.value);
}

Leaves leaves_of(const text::Document& document) {
  Leaves leaves;
  collect(document.root(), "", leaves);
  return leaves;
}

/// What has become of the leaves.
struct Change {
  int other = 0;  ///< Values.
  int gone = 0;
  int come = 0;  ///< That were not there under any path.
  [[nodiscard]] bool explains_another_meaning() const { return other > 0 || (gone > 0) != (come > 0); }
};

std::string last_key(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

Change change(const Leaves& before, const Leaves& after) {
  Change change;
  for (const auto& [path, value] : before) {
    const auto now = after.find(path);
    if (now == after.end()) ++change.gone;
    if (now != after.end() && now->second != value) ++change.other;
  }
  std::set<std::string> said;
  for (const auto& [path, value] : before) said.insert(last_key(path) + value);
  for (const auto& [path, value] : after) change.come += said.contains(last_key(path) + value) || before.contains(path) ? 0 : 1;
  return change;
}

/// All that is a fact of cameras and IMUs; what a Rig has no member for is kept as read and says itself.
Rig facts_of(Rig rig) {
  rig.extra_fields.clear();
  for (Uncertainty& each : rig.uncertainties) each.where = {};  // a place is no fact
  for (PoseUncertainty& each : rig.pose_uncertainties) each.where = {};
  return rig;
}

/// The same without the names of its cameras, which are keys in some files.
Rig unnamed(Rig rig) {
  std::map<std::string, std::string> names;
  for (Camera& camera : rig.cameras) {
    const std::string old = std::exchange(camera.name, std::to_string(names.size()));
    names.emplace(old, camera.name);
  }
  for (PoseEdge& edge : rig.poses) {
    for (std::string* end : {&edge.a, &edge.b}) {
      if (const auto name = names.find(*end); name != names.end()) *end = name->second;
    }
  }
  return rig;
}

class Mutated : public testing::TestWithParam<fs::path> {
 protected:
  void SetUp() override {
    bytes_ = read_file(GetParam());
    name_ = GetParam().filename().string();
    document_ = document_of(bytes_, name_);
    const Rig rig = calibration_of(bytes_, name_).rig;
    meant_ = facts_of(rig);
    for (const ExtraField& extra : rig.extra_fields) extra_keys_.insert(with_owner(extra));
    leaves_ = leaves_of(document_);
  }

  void evaluate(const Mutation& mutation) {
    for (const std::string& complaint : fuzz::read_promises(nullptr, mutation.bytes, name_, fuzz::Depth::kRoundTrip))
      ADD_FAILURE() << mutation.what << ": " << complaint << "\n" << mutation.bytes;
    Parsed parsed = parse(mutation.bytes, name_);
    if (!parsed.document) return;
    const std::optional<Calibration> calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
    if (!calibration) return;
    ++read_;
    const bool silent = parsed.diagnostics.entries().empty() && !names_more(calibration->rig.extra_fields);
    if (!silent || facts_of(calibration->rig) == meant_) return;
    EXPECT_TRUE(change(leaves_, leaves_of(*parsed.document)).explains_another_meaning())
        << mutation.what << ": the file says something else, and nobody is told\n"
        << mutation.bytes;
  }

  void TearDown() override { std::printf("  %d of %d mutations are read\n", read_, mutations()); }

  /// Is a key named that was none before? People see it: `show` lists it, `convert` says that it is lost.
  [[nodiscard]] bool names_more(const std::vector<ExtraField>& fields) const {
    return std::ranges::any_of(fields, [this](const ExtraField& extra) { return !extra_keys_.contains(with_owner(extra)); });
  }

  std::string bytes_;
  std::string name_;
  text::Document document_;
  Rig meant_;
  std::set<std::string> extra_keys_;
  Leaves leaves_;
  int read_ = 0;
};

TEST_P(Mutated, KeepsItsPromisesAndItsMeaning) {
  std::mt19937 random(static_cast<std::mt19937::result_type>(bytes_.size()));
  for (int i = 0; i < mutations(); ++i) {
    evaluate(i % 2 == 0 ? mutated_structure(document_, random) : Mutation{"a ruin", ruined(bytes_, random)});
  }
}

/// Every key of a document with its last letter lost.
std::vector<std::string> shortened_keys(const text::Document& document, const text::Node& node) {
  std::vector<std::string> texts;
  for (const text::Entry& entry : node.entries) {
    constexpr std::size_t kShortest = 4;  // what is shorter has too many neighbours: k1, K
    const std::size_t last = entry.key.span.end() - (entry.key.quoted ? 2 : 1);
    const bool letter = std::isalpha(static_cast<unsigned char>(document.source().bytes[last])) != 0;
    // XML's closing tag would have to go with it.
    if (letter && entry.key.value.size() >= kShortest && document.syntax() != text::Syntax::kXml) {
      text::Document edited = document;
      edited.replace({last, 1}, "");
      texts.push_back(edited.bytes());
    }
    for (std::string& text : shortened_keys(document, entry.value)) texts.push_back(std::move(text));
  }
  for (const text::Node& item : node.items) {
    for (std::string& text : shortened_keys(document, item)) texts.push_back(std::move(text));
  }
  return texts;
}

TEST_P(Mutated, AKeyThatLacksALetterIsTold) {
  const bool no_keys_prescribed = GetParam().parent_path().parent_path().filename() == "opencv";
  if (no_keys_prescribed) GTEST_SKIP() << "OpenCV's files may have any key";
  for (const std::string& text : shortened_keys(document_, document_.root())) {
    Parsed parsed = parse(text, name_);
    if (!parsed.document) continue;
    const std::optional<Calibration> calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
    if (!calibration || unnamed(facts_of(calibration->rig)) == unnamed(meant_)) continue;
    EXPECT_FALSE(parsed.diagnostics.entries().empty()) << text;
  }
}

std::string test_name(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.parent_path().parent_path().filename().string() + "_" + info.param.filename().string();
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Formats, Mutated, testing::ValuesIn(files_of_all_formats("good")), test_name);

}  // namespace
}  // namespace fca::test
