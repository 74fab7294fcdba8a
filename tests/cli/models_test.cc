// SPDX-License-Identifier: BSD-3-Clause
// `models FILE` is what a conversion to each model would report.
#include "cli/run_program.h"

#include <rapidjson/document.h>

namespace fca::test {
namespace {

using Value = rapidjson::Value;

rapidjson::Document json_of(const RunResult& run) {
  rapidjson::Document document;
  document.Parse(run.out.c_str());
  EXPECT_FALSE(document.HasParseError()) << run.out << run.err;
  return document;
}

TEST(Models, SaysWhatConversionsReport) {
  const std::string tumvi = testdata("formats/kalibr/good/tumvi.yaml");
  const rapidjson::Document models = json_of(run_program({"models", tumvi, "--camera", "0", "--max-angle", "97.5", "--json"}));
  int compared = 0;
  for (const Value& candidate : models["cameras"][0]["targets"].GetArray()) {
    const std::string model = candidate["model"].GetString();
    if (model != "radtan" && model != "eucm" && model != "kb4") continue;
    ++compared;
    SCOPED_TRACE(model);
    const std::string format = model == "eucm" ? "kalibr" : "opencv";
    const rapidjson::Document report = json_of(run_program(
        {"convert", tumvi, "--camera", "0", "--max-angle", "97.5", "--to", format, "--model", model, "--dry-run", "--json"}));
    const Value& camera = report["cameras"][0];
    EXPECT_EQ(candidate["rms_px"].GetDouble(), camera["error_px"]["rms"].GetDouble());
    EXPECT_EQ(candidate["max_px"].GetDouble(), camera["error_px"]["max"].GetDouble());
    for (const char* key : {"max_angle_deg", "scored_to_deg", "scored_share", "outside_lens_share", "unrepresentable_share"})
      EXPECT_EQ(candidate[key].GetDouble(), camera["domain"][key].GetDouble()) << key;
  }
  EXPECT_EQ(compared, 3);
}

}  // namespace
}  // namespace fca::test
