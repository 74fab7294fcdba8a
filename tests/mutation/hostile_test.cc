// SPDX-License-Identifier: BSD-3-Clause
// Numbers and names that somebody chose to do harm: each number of each good file, and names with whatever a syntax, a path or
// a terminal gives a meaning.
#include "formats/rigs.h"
#include "formats/test_files.h"
#include "promises.h"
#include "sanitized.h"
#include "text/binary.h"

#include <fca/formats/read_back.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>

#include <array>
#include <set>

namespace fca::test {
namespace {

class HostileNumbers : public testing::TestWithParam<fs::path> {};

TEST_P(HostileNumbers, KeepThePromises) {
  constexpr std::array<const char*, 6> kNumbers = {"0", "-0.0", "4.9e-324", "1e308", ".inf", ".nan"};
  const std::string name = GetParam().filename().string();
  const text::Document document = document_of(read_file(GetParam()), name);
  if (has_numbers_inside_words(document)) GTEST_SKIP() << "no word is a number";
  // Each place gets some of the numbers, the next place the next ones: a file has many places alike.
  const std::size_t numbers_of_a_place = is_sanitized() ? 1 : 3;
  std::size_t place = 0;
  std::size_t turn = name.size();
  for (const text::Node* scalar : scalars_of(document)) {
    if (scalar->quoted || !text::parse_real(scalar->value)) continue;
    // Some are also checked: that asks the programs, and takes ten times as long.
    const fuzz::Depth depth = ++place % (is_sanitized() ? 7 : 5) == 0 ? fuzz::Depth::kChecked : fuzz::Depth::kRoundTrip;
    for (std::size_t i = 0; i < numbers_of_a_place; ++i) {
      const char* number = kNumbers[turn++ % kNumbers.size()];
      text::Document edited = document;
      const bool binary = document.syntax() == text::Syntax::kBinary;
      edited.replace(scalar->span, binary ? text::encoded(scalar->tag, number) : number);
      for (const std::string& complaint : fuzz::read_promises(nullptr, edited.bytes(), name, depth))
        ADD_FAILURE() << number << " for the number at byte " << scalar->span.offset << ": " << complaint;
    }
  }
  EXPECT_GT(place, 4U);
}

std::string test_name(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.parent_path().parent_path().filename().string() + "_" + info.param.filename().string();
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Formats, HostileNumbers, testing::ValuesIn(files_of_all_formats("good")), test_name);

const std::vector<std::string> kHostileNames = {"a\"b",
                                                "a'b",
                                                "a: b",
                                                "a\nb: c",
                                                "a\r\nb",
                                                "a\\",
                                                "../../etc/a",
                                                "/etc/a",
                                                "..",
                                                "-",
                                                "- a",
                                                "{a}",
                                                "[a]",
                                                "[image]",
                                                "image",
                                                "externals",
                                                "# a",
                                                "&a",
                                                "*a",
                                                "!a",
                                                "%YAML",
                                                "a,b",
                                                "</a>",
                                                "<!--",
                                                "]]>",
                                                "&amp;",
                                                "a\x1b[31mb",
                                                "a\x07",
                                                "a\x7f",
                                                "a\xff\xfe",
                                                "\xc2\x9b"
                                                "31m",
                                                "\xe2\x80\xa8",
                                                "true",
                                                "null",
                                                "~",
                                                "1e5",
                                                "017",
                                                " a ",
                                                "\t",
                                                "a\tb",
                                                "\xef\xbb\xbf"
                                                "a",
                                                "\xf0\x9f\x93\xb7",
                                                std::string(5000, 'a')};

/// The paths of keys and numbers to everything that a document says.
// Recursive, but no deeper than text::kMaxDepth.
void collect_paths(const text::Node& node, const std::string& path, std::multiset<std::string>& paths) {
  paths.insert(path);
  for (std::size_t i = 0; i < node.items.size(); ++i) collect_paths(node.items[i], path + "/" + std::to_string(i), paths);
  for (const text::Entry& entry : node.entries) collect_paths(entry.value, path + "/" + entry.key.value, paths);
}

/// A rig of two cameras, the first with that name and topic.
Rig named_rig(const std::string& first) {
  Rig rig = sample_rig("radtan", {true, true});
  for (PoseEdge& edge : rig.poses) {
    if (edge.a == rig.cameras.front().name) edge.a = first;
    if (edge.b == rig.cameras.front().name) edge.b = first;
  }
  rig.cameras.front().name = first;
  rig.cameras.front().topic = first;
  rig.imus.front().topic = first;
  return rig;
}

/// Everything that is said besides the files.
std::string said_of(const Written& written, const Diagnostics& diagnostics) {
  std::string text;
  for (const Loss& loss : written.losses) text += id_of(loss) + " " + what_of(loss) + " " + why_of(loss) + "\n";
  for (const DefaultedValue& value : written.defaults) text += text_of(value) + "\n";
  for (const Diagnostic& entry : diagnostics.entries()) text += message_of(entry) + "\n";
  return text;
}

struct NamedFiles {
  std::vector<std::multiset<std::string>> paths;  ///< Of each file.
  std::vector<std::string> cameras;               ///< Names as read back.
  std::vector<std::string> topics;
  std::string said;
  [[nodiscard]] bool operator==(const NamedFiles&) const = default;
};

/// Nothing where the rig is refused.
std::optional<NamedFiles> written_as(const Format& format, const Rig& rig, const std::string& extension) {
  Diagnostics diagnostics;
  WriteOptions options;
  options.extension = extension;
  const std::optional<Written> written = write_calibration(format, nullptr, rig, options, diagnostics);
  EXPECT_TRUE(written || diagnostics.has_errors());
  if (!written) return std::nullopt;
  NamedFiles files;
  files.said = said_of(*written, diagnostics);
  for (const Written::File& file : written->files) {
    if (file.of_defaults && file.programs.empty()) continue;  // COLMAP's images.txt, without an image
    const fs::path proposal = file.document.source().name;
    EXPECT_EQ(proposal.filename(), proposal) << "the name of a file leads elsewhere";
    EXPECT_NE(proposal, "..");
    Parsed parsed = parse(file.document.bytes(), proposal.string());
    EXPECT_TRUE(parsed.document) << parsed.rendered();
    if (!parsed.document) continue;
    files.paths.emplace_back();
    if (parsed.document->syntax() != text::Syntax::kWords) collect_paths(parsed.document->root(), "", files.paths.back());
    const std::optional<Rig> back = read_back(format, file);
    EXPECT_TRUE(back) << file.document.bytes();
    if (!back) continue;
    // A file of poses may say the lenses again (COLMAP's rig_config.json).
    EXPECT_TRUE(file.cameras.empty() || back->cameras.size() == file.cameras.size());
    for (const Camera& camera : back->cameras) {
      files.cameras.push_back(camera.name);
      files.topics.push_back(camera.topic);
    }
  }
  return files;
}

struct Target {
  const Format* format;
  std::string extension;
};

class HostileNames : public testing::TestWithParam<Target> {};

TEST_P(HostileNames, InjectNothingAndComeBackOrAreSaid) {
  const Format& format = *GetParam().format;
  const auto rig_named = [&](const std::string& name) {
    fuzz::Complaints complaints;
    const std::optional<Rig> rig = fuzz::as_stored(format, named_rig(name), complaints);
    EXPECT_TRUE(rig && complaints.empty());
    return rig.value_or(Rig());
  };
  const std::optional<NamedFiles> plain = written_as(format, rig_named("front"), GetParam().extension);
  ASSERT_TRUE(plain);
  const bool keeps_names = std::ranges::find(plain->cameras, "front") != plain->cameras.end();
  const bool keeps_topics = std::ranges::find(plain->topics, "front") != plain->topics.end();
  for (const std::string& name : kHostileNames) {
    SCOPED_TRACE(name.substr(0, 40));
    const std::optional<NamedFiles> files = written_as(format, rig_named(name), GetParam().extension);
    if (!files) continue;
    EXPECT_EQ(files->paths, plain->paths) << "another tree";
    const bool name_back = std::ranges::find(files->cameras, name) != files->cameras.end();
    EXPECT_TRUE(!keeps_names || name_back || files->said.find("camera_name") != std::string::npos)
        << "the name has become " << testing::PrintToString(files->cameras) << " and nothing is said";
    const bool topic_back = std::ranges::find(files->topics, name) != files->topics.end();
    EXPECT_TRUE(!keeps_topics || topic_back || files->said.find("topic") != std::string::npos)
        << "the topic has become " << testing::PrintToString(files->topics) << " and nothing is said";
  }
}

std::vector<Target> targets() {
  std::vector<Target> result;
  for (const Format& format : written_formats()) result.push_back({&format, ""});
  result.push_back({find_format("opencv"), ".xml"});
  result.push_back({find_format("opencv"), ".json"});
  result.push_back({find_format("ros"), ".ini"});
  return result;
}

INSTANTIATE_TEST_SUITE_P(Formats, HostileNames, testing::ValuesIn(targets()), [](const testing::TestParamInfo<Target>& target) {
  std::string name =
      std::string(target.param.format->id) + target.param.extension.substr(target.param.extension.empty() ? 0 : 1);
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace fca::test
