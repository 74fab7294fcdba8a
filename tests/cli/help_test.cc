// SPDX-License-Identifier: BSD-3-Clause
// --help fits a terminal, groups options by what they are about, and lists what they take.
#include "cli/run_program.h"

#include <fca/formats/format.h>
#include <fca/models/camera_model.h>

namespace fca::test {
namespace {

const std::vector<std::string> kCommands = {"convert", "show",      "check",   "compare", "report",   "remap",
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

TEST(Help, OptionsAreInGroups) {
  const std::string help = help_of({"convert", "--help"});
  std::size_t at = 0;
  for (const char* part :
       {"\nWhat to write:\n", "--to FORMAT", "\nHow to read the input:\n", "--unit m|cm|mm", "\nWhat counts as lens:\n",
        "--max-angle", "\nProof and limits:\n", "--accept", "\nOutput:\n", "--output PATH"}) {
    at = help.find(part, at);
    ASSERT_NE(at, std::string::npos) << part;
  }
}

TEST(Help, ListsFormatsAndModels) {
  for (const char* command : {"convert", "report"}) {
    const std::string help = help_of({command, "--help"});
    for (const Format& format : all_formats()) EXPECT_TRUE(contains(help, std::string(format.id))) << format.id;
    for (const ModelInfo& model : all_models()) EXPECT_TRUE(contains(help, std::string(model.id))) << model.id;
  }
}

}  // namespace
}  // namespace fca::test
