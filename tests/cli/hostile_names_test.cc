// SPDX-License-Identifier: BSD-3-Clause
// Names that a file gives its cameras and topics: none drives the terminal, leads a file elsewhere, or breaks what is printed.
#include "cli/run_program.h"

#include <algorithm>

namespace fca::test {
namespace {

/// A ROS camera whose name is that text between double quotes of YAML.
std::string camera_called(const std::string& name) {
  return "image_width: 640\nimage_height: 480\ncamera_name: \"" + name +
         "\"\ncamera_matrix: {rows: 3, cols: 3, data: [511.5, 0.0, 321.75, 0.0, 512.25, 238.5, 0.0, 0.0, 1.0]}\n"
         "distortion_model: plumb_bob\n"
         "distortion_coefficients: {rows: 1, cols: 5, data: [-0.25, 0.0625, 0.0, 0.0, 0.0]}\n"
         "rectification_matrix: {rows: 3, cols: 3, data: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]}\n"
         "projection_matrix: {rows: 3, cols: 4, data: [478.5, 0.0, 322.0, 0.0, 0.0, 487.5, 238.0, 0.0, 0.0, 0.0, 1.0, 0.0]}\n";
}

/// As YAML spells them: each has something that a terminal, a path or a line gives a meaning.
const std::vector<std::string> kNames = {"front\\e[31mred",
                                         "front\\nwrote /etc/passwd",
                                         "front\\rback",
                                         "\\x9b31m",
                                         "..",
                                         "../../front",
                                         "/tmp/front",
                                         "front\\0back",
                                         "\\u2028",
                                         "a\\\"b: c"};

bool has_control_characters(const std::string& text) {
  return std::ranges::any_of(text, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\n') || byte == 0x7F;
  });
}

TEST(HostileNames, DoNotReachTheTerminal) {
  const TemporaryFolder folder;
  for (const std::string& name : kNames) {
    const std::string path = folder.write("camera.yaml", camera_called(name));
    for (const std::vector<std::string>& command : {std::vector<std::string>{"show"},
                                                    {"check"},
                                                    {"convert", "--to", "woodscape", "-o", folder / "out.json"},
                                                    {"convert", "--to", "kalibr", "-o", folder / "out.yaml"},
                                                    {"models"},
                                                    {"compare", path}}) {
      std::vector<std::string> words = command;
      words.insert(words.begin() + 1, path);
      const RunResult run = run_program(words);
      EXPECT_EQ(run.signal, 0) << name;
      EXPECT_FALSE(has_control_characters(run.out)) << command.front() << " " << name << "\n" << run.out;
      EXPECT_FALSE(has_control_characters(run.err)) << command.front() << " " << name << "\n" << run.err;
      EXPECT_EQ(run.out.find("\nwrote /etc/passwd"), std::string::npos) << "a line that the file made up\n" << run.out;
    }
  }
}

// A program's refusal quotes the file's keys; a file may be called anything.
TEST(HostileNames, OfKeysAndFilesMakeUpNoLine) {
  const TemporaryFolder folder;
  const std::string chain = read_file(testdata("formats/kalibr/good/block-style.yaml"));
  const std::string good = folder.write("good.yaml", chain);
  const std::string key = folder.write("key.yaml", chain + "\"x\\nerror: made up\\e[31m\": {a: 1}\n");
  const std::string name = folder.write("x\nerror: made up.yaml", chain);
  for (const std::string& path : {key, name}) {
    for (const std::vector<std::string>& command : {std::vector<std::string>{"show"},
                                                    {"show", "--for", "kalibr"},
                                                    {"check"},
                                                    {"compare", good},
                                                    {"convert", "--to", "kalibr", "-o", folder / "out.yaml", "--force"},
                                                    {"convert", "--to", "opencv", "-o", folder / "out.yml", "--force"}}) {
      std::vector<std::string> words = command;
      words.push_back(path);
      const RunResult run = run_program(words);
      EXPECT_EQ(run.signal, 0);
      EXPECT_FALSE(has_control_characters(run.out + run.err)) << command.front() << "\n" << run.out << run.err;
      EXPECT_FALSE(contains("\n" + run.out + "\n" + run.err, "\nerror: made up")) << command.front() << "\n"
                                                                                  << run.out << run.err;
    }
  }
}

TEST(HostileNames, StayInTheirFolder) {
  for (const std::string& name : kNames) {
    const TemporaryFolder folder;
    const std::string path = folder.write("camera.yaml", camera_called(name));
    const std::string other = folder.write("other.yaml", camera_called("other"));
    fs::create_directory(folder.path() / "out");
    const RunResult run =
        run_program({"convert", path, other, "--join", "--to", "woodscape", "-o", folder / "out/{camera}.json"});
    if (run.code != 0) {
      EXPECT_FALSE(run.err.empty());
      continue;
    }
    EXPECT_EQ(folder.names(), (std::set<std::string>{"camera.yaml", "other.yaml", "out"})) << name;
    const auto written = std::distance(fs::directory_iterator(folder.path() / "out"), fs::directory_iterator());
    EXPECT_EQ(written, 2) << name << "\n" << run.out;
  }
}

}  // namespace
}  // namespace fca::test
