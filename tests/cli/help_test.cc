// SPDX-License-Identifier: BSD-3-Clause
// --help fits a terminal, groups options by what they are about, and lists what they take.
#include "cli/run_program.h"

#include <fca/formats/format.h>
#include <fca/models/camera_model.h>

namespace fca::test {
namespace {

const std::vector<std::string> kCommands = {"convert", "show",      "check",   "compare", "report",   "remap",   "rectify",
                                            "project", "unproject", "formats", "models",  "programs", "evaluate"};

std::string help_of(const std::vector<std::string>& words) {
  const RunResult run = run_program(words, {.in_full = false});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  return run.out;
}

TEST(Help, OfEveryCommandFits80Columns) {
  const std::string overview = help_of({"--help"});
  std::vector<std::string> helps = {overview};
  for (const std::string& command : kCommands) {
    EXPECT_TRUE(contains(overview, "\n  " + command + " ")) << command;
    helps.push_back(help_of({command, "-h"}));
  }
  for (const std::string& help : helps) {
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
  }
}

// The groups' titles, which begin at the edge and end with a colon, are in golden/convert.txt.
TEST(Help, OptionsAreInGroups) {
  std::vector<std::string> groups;
  std::istringstream lines(help_of({"convert", "--help"}));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(' ') && line.ends_with(':')) {
      groups.emplace_back();
    } else if (!groups.empty()) {
      groups.back() += line + "\n";
    }
  }
  const std::vector<const char*> options = {"--to FORMAT", "--unit m|cm|mm", "--max-angle DEG", "--accept CODE",
                                            "--output PATH"};
  std::size_t at = 0;
  for (const char* option : options) {
    while (at < groups.size() && !contains(groups[at], option)) ++at;
    ASSERT_LT(at, groups.size()) << option << " is in no group behind that of the one before";
    ++at;  // each is in a group of its own
  }
}

TEST(Help, ListsFormatsAndModels) {
  for (const char* command : {"convert", "report"}) {
    const std::string help = help_of({command, "--help"});
    for (const Format& format : written_formats()) EXPECT_TRUE(contains(help, std::string(format.id))) << format.id;
    for (const ModelInfo& model : all_models()) {
      // A model that only keeps a camera is no target.
      if (!model.kept_only) {
        EXPECT_TRUE(contains(help, std::string(model.id))) << model.id;
      }
    }
  }
}

}  // namespace
}  // namespace fca::test
