// SPDX-License-Identifier: BSD-3-Clause
// Which syntax a file is read as: by what it begins with, then by its name.
#include "formats/text_checks.h"
#include "text/syntax.h"

#include <chrono>
#include <iostream>
#include <map>

namespace fca::test {
namespace {

using text::Syntax;

const char* name_of(Syntax syntax) {
  switch (syntax) {
    case Syntax::kYaml:
      return "YAML";
    case Syntax::kOpenCvYaml:
      return "OpenCV YAML";
    case Syntax::kXml:
      return "XML";
    case Syntax::kJson:
      return "JSON";
    case Syntax::kWords:
      return "words";
    case Syntax::kBinary:
      return "binary";
    case Syntax::kPython:
      return "Python";
  }
  return "?";
}

/// What the collected files of that name are.
Syntax wanted(const fs::path& path, const std::string& bytes) {
  if (path.extension() == ".xml") return Syntax::kXml;
  if (path.extension() == ".json") return Syntax::kJson;
  if (path.extension() == ".cameramodel") return Syntax::kPython;
  if (path.extension() == ".txt" || path.extension() == ".ini") return Syntax::kWords;
  return bytes.find("%YAML:") < 4 ? Syntax::kOpenCvYaml : Syntax::kYaml;
}

TEST(TextSyntax, OfEveryCorpusFile) {
  if (!fs::exists(shared_dir() / "corpus")) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  std::map<std::string, int> counts;
  std::map<std::string, int> refused;
  for (const fs::directory_entry& each : fs::recursive_directory_iterator(shared_dir() / "corpus")) {
    if (!each.is_regular_file() || each.path().parent_path().filename() == "corpus") continue;
    SCOPED_TRACE(each.path());
    const std::string bytes = read_file(each.path());
    const Syntax chosen = text::choose_syntax({each.path(), bytes});
    // What a camera's maker calls .txt or .conf is his own syntax, whatever it comes nearest to.
    const std::string folder = each.path().parent_path().filename();
    const bool makers_own = folder == "realsense" || folder == "zed_conf";
    const bool binary = each.path().extension() == ".bin";
    if (!makers_own && !binary) {
      EXPECT_STREQ(name_of(chosen), name_of(wanted(each.path(), bytes)));
    }
    const Parsed parsed = parse(bytes, each.path());
    ++(parsed.document ? counts : refused)[name_of(parsed.document ? parsed.document->syntax() : chosen)];
    if (!parsed.document) {
      // Some are broken YAML as found (CORPUS: README.md), or XML of programs other than OpenCV; what the readers refuse
      // besides is a finding.
      const bool yaml = chosen == Syntax::kYaml || chosen == Syntax::kOpenCvYaml;
      const bool others_xml = chosen == Syntax::kXml && bytes.find("<opencv_storage") == std::string::npos;
      EXPECT_TRUE(yaml || others_xml) << parsed.rendered();
      continue;
    }
    EXPECT_EQ(parsed.document->bytes(), bytes);
    if (parsed.document->syntax() == Syntax::kYaml || parsed.document->syntax() == Syntax::kOpenCvYaml) continue;
    expect_nested_spans(parsed.document->root(), bytes.size());
    if (binary) continue;  // a word's bytes are not what it says
    EXPECT_GT(expect_scalar_spans(*parsed.document), 0);
    expect_edits_stay_in_their_place(*parsed.document, static_cast<unsigned>(bytes.size()));
  }
  for (const auto& [syntax, count] : counts) std::cout << "  " << syntax << ": " << count << " files read\n";
  for (const auto& [syntax, count] : refused) std::cout << "  " << syntax << ": " << count << " files refused\n";
  EXPECT_GE(counts["XML"], 20);
  EXPECT_GE(counts["JSON"], 15);
  EXPECT_GE(counts["words"], 50);
  EXPECT_GE(counts["binary"], 5);
  EXPECT_GE(counts["Python"], 12);
}

TEST(TextSyntax, OfSmallFiles) {
  struct Row {
    const char* bytes;
    const char* name;
    Syntax syntax;
  };
  const Row kRows[] = {
      // By content, whatever the name.
      {"%YAML:1.0\na: 1\n", "a.xml", Syntax::kOpenCvYaml},
      {"%YAML 1.2\n---\na: 1\n", "a.json", Syntax::kYaml},
      {"<?xml version=\"1.0\"?>", "a.yaml", Syntax::kXml},
      {"\xEF\xBB\xBF\r\n <opencv_storage>", "a", Syntax::kXml},
      {"{\"a\": 1}", "a.yaml", Syntax::kJson},
      {"[1, 2]", "<stdin>", Syntax::kJson},
      {"[ {", "a.txt", Syntax::kJson},
      {"a: 1\n", "a.txt", Syntax::kYaml},
      {"a:\n", "a.json", Syntax::kYaml},
      {"- a\n", "a.txt", Syntax::kYaml},
      {"---\na: 1\n", "a.txt", Syntax::kYaml},
      {"# c\n\n'a b': 1\n", "a.txt", Syntax::kYaml},
      {"# 1 2 3\na: 1\n", "a.txt", Syntax::kYaml},
      {"- 1 2 3\n", "a.yaml", Syntax::kYaml},
      {"a: 1 2 3\n", "a", Syntax::kYaml},
      {"#polynomial\n\n5 -2.8e+02 0.0 1e-3\n", "<stdin>", Syntax::kWords},
      {"#polynomial: of b\r\n\r\n5 -2.8e+02 0.0 1e-3\r\n", "calib.yaml", Syntax::kWords},
      {"polynomial coefficients\n\n5 -2.8e+02 0.0 1e-3\n", "<stdin>", Syntax::kWords},
      {"EquiDistant 0.5 0.5 0.5 0.5 0 0 0 0\n512 512\n", "camera", Syntax::kWords},
      {"458.6 457.2 367.2 248.3\n752 480\ncrop\n640 480\n", "a.yaml", Syntax::kWords},
      {"Pinhole 1 2 3 4 0", "a", Syntax::kWords},
      // mrcal's, by name, and by its quotes under any name that says nothing else.
      {"{\"a\": 1}", "a.cameramodel", Syntax::kPython},
      {"cahvor", "a.cameramodel", Syntax::kPython},
      {"{'a': 1}", "a", Syntax::kPython},
      {"{'a': 1}", "a.json", Syntax::kJson},
      {"{'a': 1}", "a.yaml", Syntax::kJson},
      {"# c\r\n# {\n\n{ # d\n  'a': 1}", "<stdin>", Syntax::kPython},
      {"# c\n{'a': 1}", "a.yml", Syntax::kYaml},
      {"['a', 1]", "a", Syntax::kJson},
      // By name, where the content is cut off or broken.
      {"#polynomial coefficients", "calib_results.txt", Syntax::kWords},
      {"Pinh", "camera.TXT", Syntax::kWords},
      {"opencv_storage>", "a.xml", Syntax::kXml},
      {"\"value0\"", "a.json", Syntax::kYaml},
      {"value0", "a.json", Syntax::kJson},
      {"camera", "a.yaml", Syntax::kYaml},
      {"camera model\n1 2 3\n", "a.yml", Syntax::kYaml},
      {"garbage", "/a.b/c", Syntax::kYaml},
      // Sections before lines of text: an .ini. A list of YAML is one before anything else.
      {"# [image]\n[image]\nwidth\n640\n", "a.ini", Syntax::kWords},
      {"[image]\n\n#comment\nwidth\n640\n", "a", Syntax::kWords},
      {"[narrow stereo/left]\ncamera matrix\n1 2 3\n", "a.txt", Syntax::kWords},
      {"[image]\nwidth: 640\n", "a.ini", Syntax::kYaml},
      {"[a, b]\nwidth\n", "a.yaml", Syntax::kYaml},
      {"[image]\n", "a.ini", Syntax::kYaml},
      {"<<<<<<< HEAD\na: 1\n", "a.yaml", Syntax::kYaml},
  };
  for (const Row& row : kRows)
    EXPECT_STREQ(name_of(text::choose_syntax({row.name, row.bytes})), name_of(row.syntax)) << row.name << ": " << row.bytes;
}

TEST(TextSyntax, ABracketMayBeYaml) {
  EXPECT_EQ(parse("{a: 1, b: [1,]}\n", "a.yaml").document.value().syntax(), Syntax::kYaml);
  EXPECT_EQ(parse("{a: 1}\n", "<stdin>").document.value().syntax(), Syntax::kYaml);
  EXPECT_EQ(parse("{ # c\n 'a': x,\n}\n", "a.model").document.value().syntax(), Syntax::kYaml);
  EXPECT_EQ(parse("{\"a\": 1, # c\n}\n", "a.yml").document.value().syntax(), Syntax::kYaml);
  EXPECT_EQ(parse("{\"a\": 1}\n", "a.yaml").document.value().syntax(), Syntax::kJson);
  // JSON with a fault stays JSON.
  EXPECT_EQ(parse("{\"a\": 1,}\n", "a.json").codes(), "json-syntax");
  EXPECT_EQ(parse("{\"a\": 1,}\n", "<stdin>").codes(), "json-syntax");
  EXPECT_EQ(parse("{a: 1}\n", "a.json").codes(), "json-syntax");
  // And YAML with a fault YAML.
  EXPECT_EQ(parse("{a: 1\n", "a.yaml").codes(), "yaml-syntax");
}

TEST(TextSyntax, EverySyntaxHasItsLimits) {
  const std::string blanks(text::kMaxFileBytes, ' ');
  EXPECT_EQ(parse("{\"a\": 1}" + blanks, "a.json").codes(), "too-large");
  EXPECT_EQ(parse("<opencv_storage><a>1</a></opencv_storage>" + blanks, "a.xml").codes(), "too-large");
  EXPECT_EQ(parse("Pinhole 1 2 3 4 0\n" + blanks, "a.txt").codes(), "too-large");
  EXPECT_EQ(parse("{'a': 1}" + blanks, "a.cameramodel").codes(), "too-large");
  for (const char* name : {"a.json", "a.xml", "a.txt", "a.cameramodel"}) {
    EXPECT_EQ(parse("", name).codes(), "empty-file");
    EXPECT_EQ(parse(std::string("<a>\0</a>", 8), name).codes(), "binary-file");
  }
  for (const char* start : {"{\"a\": 1,\n", "{'a': 1,\n", "<opencv_storage>\n", "#poly\n5 1 2 3 4 5\n"})
    EXPECT_EQ(parse(std::string(start) + "<<<<<<< HEAD\n", "a").codes(), "merge-conflict");
}

// Just below the limit nothing takes long: no reader is quadratic in what a file can hold.
TEST(TextSyntax, LargeFilesAreReadInTime) {
  const auto repeated = [](const std::string& start, const std::string& part, const std::string& end) {
    std::string bytes = start;
    while (bytes.size() + part.size() + end.size() < 350'000) bytes += part;
    return bytes + end;
  };
  const std::string kFiles[] = {
      repeated("{\"a\": [1", ", 1.5", "]}"),
      repeated("{\"a\": 1", ",\n\"b\": \"c\"", "}"),
      repeated("{'a': (1", ", 1.5", "\n)}"),
      repeated("{'a': 'b'", "\n#\n'c'", "}"),
      repeated("{'a': b'", "\\\\", "'}"),
      repeated("# c\n", "# c\n", "{'a': 1}"),
      repeated("<opencv_storage><a>", "1.5 ", "</a></opencv_storage>"),
      repeated("<opencv_storage>", "<a>1</a>\n", "</opencv_storage>"),
      repeated("<opencv_storage><a>", "<_>1</_>", "</a></opencv_storage>"),
      repeated("<opencv_storage><a>1", "<!-- -->", "</a></opencv_storage>"),
      repeated("<opencv_storage><a>", "&lt;", "</a></opencv_storage>"),
      repeated("#p\n5 ", "1.5 ", "\n"),
  };
  const auto start = std::chrono::steady_clock::now();
  for (const std::string& bytes : kFiles) EXPECT_TRUE(parse(bytes, "large").document) << bytes.substr(0, 60);
  // Refusals, too: of what has too many lines, opens without end, or never closes.
  EXPECT_FALSE(parse(repeated("#p\n5\n", "\n", ""), "large").document);
  EXPECT_FALSE(parse(repeated("[", "[", ""), "large").document);
  EXPECT_FALSE(parse(repeated("{", "\"a\":{", ""), "large").document);
  EXPECT_FALSE(parse(repeated("{", "'a':{", ""), "large").document);
  EXPECT_FALSE(parse(repeated("{'a': ", "'", ""), "large").document);
  EXPECT_FALSE(parse(repeated("<a>", "<a>", ""), "large").document);
  EXPECT_FALSE(parse(repeated("<", "<", ""), "large").document);
  EXPECT_FALSE(parse(repeated("<opencv_storage><a>", "\" ", ""), "large").document);
  EXPECT_FALSE(parse(repeated("<opencv_storage><a>", "& ", "</a></opencv_storage>"), "large").document);
  // Half a second on the machine this was written on; a sanitizer makes it ten times that, a quadratic reader a hundred times.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

}  // namespace
}  // namespace fca::test
