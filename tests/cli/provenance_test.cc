// SPDX-License-Identifier: BSD-3-Clause
// The comment that says where a written file comes from.
#include "cli/run_program.h"
#include "cli/told.h"

#include <fca/formats/calibration.h>
#include <fca/formats/text/message.h>
#include <fca/formats/text/read_document.h>

#include <fstream>
#include <sstream>

namespace fca::test {
namespace {

// An input, and what sha256sum prints of it.
constexpr const char* kBytes =
    "cam0:\n  camera_model: pinhole\n  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]\n  distortion_model: equidistant\n"
    "  intrinsics: [200.0, 200.0, 255.5, 255.5]\n  resolution: [512, 512]\n";
constexpr const char* kHash = "7ab9e383e59f3713dffa21cde3450379a7f5cdb574e086e046f4730e0ec78163";

/// What the comment says of the camera, up to the end of its line.
std::string said_of(const std::string& camera, const std::string& bytes) {
  const std::size_t at = bytes.find(camera + ": ");
  EXPECT_NE(at, std::string::npos) << bytes;
  return at == std::string::npos ? std::string() : bytes.substr(at, bytes.find('\n', at) - at);
}

// The sentences: golden/convert.txt.
TEST(Provenance, SaysTheInputTheCommandAndTheError) {
  const TemporaryFolder folder;
  const std::string input = folder.write("chain.yaml", kBytes);
  const RunResult run = run_program({"convert", input, "--to", "orbslam3", "--max-angle", "60"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "chain.yaml, SHA-256 " + std::string(kHash))) << run.out;
  EXPECT_TRUE(contains(run.out, "# by fca-io convert " + input + " --to orbslam3 --max-angle 60\n")) << run.out;
  const std::string kept = said_of("cam0", run.out);
  EXPECT_TRUE(contains(kept, "kb4")) << kept;
  EXPECT_FALSE(contains(kept, " px")) << kept;
  const Told fitted({"convert", kDs, "--to", "orbslam3", "--max-angle", "50"});
  const std::string with_error = said_of("cam0", fitted.bytes());
  const auto& error = fitted.json()["cameras"][0]["error_px"];
  const auto in_px = [](const rapidjson::Value& value) {
    return text::filled("{0:px} px", std::vector<Argument>{value.GetDouble()});
  };
  for (const std::string& value : {std::string("ds -> kb4"), in_px(error["rms"]), in_px(error["max"]), std::string(" 50 deg")})
    EXPECT_TRUE(contains(with_error, value)) << value << " is not in " << with_error;
  // A model that cannot reach the whole lens is scored inside a cone.
  const RunResult cone = run_program({"convert", kTumvi, "--camera", "0", "--to", "opencv", "--model", "radtan"});
  EXPECT_TRUE(contains(said_of("cam0", cone.out), " 67 deg")) << cone.out;
}

TEST(Provenance, IsTheSameInEveryRunAndCanBeLeftOut) {
  const std::vector<std::string> words = {"convert", kTumvi, "--to", "opencv"};
  const std::string with = run_program(words).out;
  EXPECT_TRUE(contains(with, "SHA-256"));
  EXPECT_EQ(run_program(words).out, with);
  std::vector<std::string> without = words;
  without.emplace_back("--no-provenance");
  EXPECT_FALSE(contains(run_program(without).out, "fca-io")) << run_program(without).out;
}

TEST(Provenance, EditsHaveItOnlyWhenAsked) {
  const std::vector<std::string> words = {"convert", kTumvi, "--to", "kalibr", "--camera", "0"};
  EXPECT_FALSE(contains(run_program(words).out, "SHA-256"));
  const RunResult set = run_program({"convert", kTumvi, "--to", "kalibr", "--set", "cam1/rostopic=/right"});
  EXPECT_FALSE(contains(set.out, "SHA-256")) << set.out;
  std::vector<std::string> asked = words;
  asked.emplace_back("--provenance");
  EXPECT_TRUE(contains(run_program(asked).out, "SHA-256"));
}

// What was true of a file as it was written is not kept where it is edited.
TEST(Provenance, AnEditReplacesWhatStandsThere) {
  const TemporaryFolder folder;
  for (const std::string name : {"one.yml", "one.xml", "one.txt"}) {
    SCOPED_TRACE(name);
    const std::string path = folder / name;
    const std::string format = name.ends_with("txt") ? "ocamcalib" : "opencv";
    ASSERT_EQ(run_program({"convert", kTumvi, "--camera", "cam0", "--to", format, "-o", path}).code, 0);
    const std::string written = read_file(path);
    EXPECT_TRUE(contains(written, "tumvi.yaml, SHA-256"));
    // Nothing is edited: nothing changes.
    EXPECT_EQ(run_program({"convert", path, "--to", format}).out, written);
    const RunResult edited = run_program({"convert", path, "--to", format, "--binning", "2"});
    EXPECT_EQ(edited.code, 0) << edited.err;
    EXPECT_FALSE(contains(edited.out, "tumvi.yaml")) << edited.out;
    EXPECT_TRUE(contains(edited.out, name + ", SHA-256")) << edited.out;
    // The parameters are not those of the input's images any more.
    const RunResult unchanged = run_program({"convert", path, "--to", format, "--provenance", "--rewrite"});
    EXPECT_NE(said_of("cam0", edited.out), said_of("cam0", unchanged.out));
    EXPECT_EQ(edited.out.find("SHA-256"), edited.out.rfind("SHA-256"));
    const RunResult without = run_program({"convert", path, "--to", format, "--no-provenance"});
    EXPECT_FALSE(contains(without.out, "fca-io")) << without.out;
    const std::string plain =
        run_program({"convert", kTumvi, "--camera", "cam0", "--to", format, "-o", folder / ("plain" + name), "--no-provenance"})
            .err;
    EXPECT_EQ(without.out, read_file(folder / ("plain" + name))) << plain;
  }
}

// cv::FileStorage's XML and YAML, and formats without comments.
TEST(Provenance, EverySyntaxIsReadAsWithoutIt) {
  const TemporaryFolder folder;
  struct Syntax {
    const char* format;
    const char* file;
    bool comments;
  };
  for (const Syntax& syntax :
       {Syntax{"opencv", "c.xml", true}, Syntax{"opencv", "c.yml", true}, Syntax{"opencv", "c.json", false},
        Syntax{"kalibr", "c.yaml", true}, Syntax{"orbslam3", "s.yaml", true}, Syntax{"ocamcalib", "o.txt", true},
        Syntax{"woodscape", "w.json", false}, Syntax{"tumvi", "t.yaml", true}}) {
    std::string said;
    const auto written = [&](const char* option) {
      const std::string path = folder / syntax.file;
      const RunResult run = run_program({"convert", kTumvi, "--camera", "0", "--to", syntax.format, "--rewrite", "--max-angle",
                                         "60", "-o", path, "--force", option});
      EXPECT_EQ(run.code, 0) << syntax.format << run.err;  // proven by the program that reads it
      if (std::string(option) == "--provenance") said = run.err;
      return read_file(path);
    };
    const std::string with = written("--provenance");
    EXPECT_EQ(contains(with, "SHA-256"), syntax.comments) << with;
    EXPECT_EQ(says(said, "provenance-not-written"), !syntax.comments) << said;
    const std::string without = written("--no-provenance");
    Diagnostics diagnostics;
    const auto rig = [&](const std::string& bytes) {
      std::optional<text::Document> document = text::parse_document({syntax.file, bytes}, diagnostics);
      return document ? read_calibration({*document}, find_format(syntax.format), {}, diagnostics) : std::nullopt;
    };
    ASSERT_TRUE(rig(with) && rig(without)) << with;
    EXPECT_EQ(rig(with)->rig, rig(without)->rig) << with;
  }
}

// get_ocam_model skips one line before each block, of up to 1023 characters.
TEST(Provenance, OCamCalibKeepsOneLineOfCommentBeforeEachBlock) {
  const TemporaryFolder folder;
  const auto comments = [](const std::string& bytes) {
    std::vector<std::size_t> lengths;
    std::istringstream stream(bytes);
    for (std::string line; std::getline(stream, line);) {
      if (line.starts_with('#')) lengths.push_back(line.size());
    }
    return lengths;
  };
  const std::string input = testdata("formats/ocamcalib/good/toolbox.txt");
  const RunResult edited = run_program({"convert", input, "--to", "ocamcalib", "--provenance"});
  ASSERT_EQ(edited.code, 0) << edited.err;
  EXPECT_TRUE(contains(first_line(edited.out), "toolbox.txt, SHA-256 ")) << edited.out;
  EXPECT_EQ(comments(edited.out).size(), comments(read_file(input)).size());
  // What does not fit is not written, and that is reported.
  const std::string deep = folder / (std::string(200, 'a') + "/" + std::string(200, 'b') + "/" + std::string(200, 'c'));
  fs::create_directories(deep);
  const std::string far = deep + "/" + std::string(200, 'd') + ".txt";
  std::ofstream(far) << read_file(input);
  const RunResult run = run_program({"convert", far, "--to", "ocamcalib", "--provenance"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, read_file(input));
  EXPECT_TRUE(says(run.err, "provenance-not-written")) << run.err;
}

// A file's name cannot end the comment.
TEST(Provenance, NamesCannotBreakOut) {
  const TemporaryFolder folder;
  const std::string input = folder.write("a\nFile.version: '2.0' -->", kBytes);
  const RunResult run = run_program({"convert", input, "--to", "orbslam3"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_FALSE(contains(run.out, "\nFile.version: '2.0'")) << run.out;
  const RunResult xml = run_program({"convert", input, "--to", "opencv", "-o", folder / "c.xml"});
  EXPECT_EQ(xml.code, 0) << xml.err;
}

// Whatever the name, whatever the program: it loads the file, and finds in it what it finds without the comment. U+2028 ends a
// line to PyYAML, and with it a comment.
TEST(Provenance, EveryProgramReadsPastAnyName) {
  const TemporaryFolder folder;
  const std::string name = "a\"--> \n]]>&\xC3\xA9\xFF\t%YAML\r\nx: 1 <b> --\\\x7F\xE2\x80\xA8x: [\xC2\x85{'";
  const std::string input = folder.write(name, kBytes);
  struct Target {
    const char* format;
    const char* file;
  };
  for (const Target& target : {Target{"opencv", "c.xml"}, Target{"opencv", "c.yml"}, Target{"opencv", "c.json"},
                               Target{"kalibr", "c.yaml"}, Target{"orbslam3", "s.yaml"}, Target{"ocamcalib", "o.txt"},
                               Target{"woodscape", "w.json"}, Target{"tumvi", "t.yaml"}, Target{"tumvi", "t.txt"}}) {
    const std::string path = folder / target.file;
    const Told run({"convert", input, "--camera", "0", "--to", target.format, "--rewrite", "--provenance", "--max-angle", "60",
                    "-o", path});
    EXPECT_EQ(run.code(), 0) << target.file << run.text();
    EXPECT_TRUE(run.loads()) << target.file << run.text();
    const std::string bytes = read_file(path);
    for (const char* line_end : {"\xE2\x80\xA8", "\xC2\x85", "\r"}) EXPECT_FALSE(contains(bytes, line_end)) << target.file;
    EXPECT_FALSE(contains(bytes, "\nx: 1")) << bytes;
  }
}

// The program that proves a camchain sees what PyYAML sees.
TEST(Provenance, ALineSeparatorInACommentIsRefusedAsByPyYaml) {
  const RunResult run = run_program({"check", "-"}, {.input = std::string("# a\xE2\x80\xA8x: [\n") + kBytes});
  EXPECT_EQ(run.code, 1) << run.out;
  EXPECT_TRUE(says(run.out, "program-refuses", "U+2028")) << run.out;
}

}  // namespace
}  // namespace fca::test
