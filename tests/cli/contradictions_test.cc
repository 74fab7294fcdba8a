// SPDX-License-Identifier: BSD-3-Clause
// show, convert and check find the same contradictions of a rig, and all of them.
#include "cli/run_program.h"

#include <string>
#include <vector>

#include <rapidjson/document.h>

namespace fca::test {
namespace {

const std::string kQuad = testdata("checks/poses-contradict-thrice.yaml");
using Names = std::vector<std::string>;

/// The poses that entries of that code begin with.
Names blamed(const rapidjson::Value& entries) {
  Names names;
  for (const rapidjson::Value& entry : entries.GetArray()) {
    const std::string message = entry["message"].GetString();
    if (std::string(entry["code"].GetString()) == "poses-contradict") names.push_back(message.substr(0, message.find(' ')));
  }
  return names;
}

rapidjson::Document json_of(const std::vector<std::string>& arguments) {
  const RunResult run = run_program(arguments);
  rapidjson::Document document;
  document.Parse(run.out.c_str());
  EXPECT_FALSE(document.HasParseError()) << run.out << run.err;
  return document;
}

const Names kAll = {"T_cam1_imu0", "T_cam2_imu0", "T_cam3_imu0"};

TEST(Contradictions, ShowFindsAll) {
  const rapidjson::Document document = json_of({"show", kQuad, "--json"});
  EXPECT_EQ(blamed(document["files"][0]["diagnostics"]), kAll);
}

TEST(Contradictions, CheckFindsAll) {
  const rapidjson::Document document = json_of({"check", kQuad, "--json"});
  EXPECT_EQ(blamed(document["files"][0]["findings"]), kAll);
}

TEST(Contradictions, ConvertFindsAll) {
  const TemporaryFolder folder;
  const rapidjson::Document document = json_of({"convert", kQuad, "--to", "kalibr", "-o", folder / "out.yaml", "--json"});
  EXPECT_EQ(blamed(document["diagnostics"]), kAll);
}

}  // namespace
}  // namespace fca::test
