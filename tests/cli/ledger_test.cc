// SPDX-License-Identifier: BSD-3-Clause
// The ledger of `fca-io formats --ledger` against what convert does: for every pair of formats files that hold what the format
// can hold are converted, and what comes out exact, fitted, dropped and defaulted is what the table says.
#include "cli/run_program.h"
#include "formats/rigs.h"

#include <fca/formats/calibration.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <rapidjson/document.h>

namespace fca::test {
namespace {

using Names = std::set<std::string>;

struct Classes {
  Names exact;
  Names fitted;
  Names dropped;
  Names defaulted;
};

/// Inputs that are one calibration, as words for the command.
using Input = std::vector<std::string>;

rapidjson::Document json_of(const std::string& text) {
  rapidjson::Document json;
  json.Parse(text.c_str(), text.size());
  EXPECT_FALSE(json.HasParseError()) << text;
  return json;
}

Names names_in(const rapidjson::Value& list) {
  Names names;
  for (const rapidjson::Value& name : list.GetArray()) names.insert(name.GetString());
  return names;
}

std::map<std::pair<std::string, std::string>, Classes> table() {
  const rapidjson::Document json = json_of(run_program({"formats", "--ledger", "--json"}).out);
  std::map<std::pair<std::string, std::string>, Classes> rows;
  for (const rapidjson::Value& row : json["ledger"].GetArray()) {
    rows[{row["from"].GetString(), row["to"].GetString()}] = {names_in(row["exact"]), names_in(row["fitted"]),
                                                              names_in(row["dropped"]), names_in(row["defaulted"])};
  }
  return rows;
}

/// The model of "radtan (k3 != 0)".
std::string model_in(const std::string& name) { return name.substr(0, name.find(" (")); }

/// Does the table say that such cameras stay exact? Of one on a condition ("radtan (k3 != 0)"), that they do without any.
bool says_exact(const Classes& expected, const std::string& name) {
  return std::ranges::any_of(expected.exact, [&name](const std::string& row) {
    const bool unconditional = row == model_in(row) || row.starts_with(model_in(row) + " (as ");
    return model_in(row) == model_in(name) && (name == model_in(name) || unconditional);
  });
}

/// What OpenCV's files of mei hold more than one of.
const std::string kButForAPair = " (mei, but for a pair)";

/// What the table calls a loss.
std::string fact_of(const std::string& code, const std::string& what, const Format& from, const Format& to) {
  static const std::map<std::string, std::string> kFacts = {{"imu-dropped", "IMU"},
                                                            {"time-offset-dropped", "time offset"},
                                                            {"topic-dropped", "topics"},
                                                            {"frame-rate-dropped", "frame rate"},
                                                            {"baseline-dropped", "baseline without poses"},
                                                            {"camera-dropped", "cameras beyond 2"}};
  if (code == "not-carried") {
    const auto named =
        std::ranges::find_if(from.own_facts, [&](std::string_view fact) { return contains(what, std::string(fact)); });
    return std::string(named == from.own_facts.end() ? from.own_facts.front() : *named);
  }
  if (code == "pose-dropped") {
    if (contains(what, "imu")) return "IMU";
    const std::string frame(from.frame);
    if (!frame.empty() && contains(what, frame)) return "poses in the frame " + frame;
    return "poses" + (to.id == "opencv" ? kButForAPair : "");
  }
  const auto found = kFacts.find(code);
  return found == kFacts.end() ? code : found->second;
}

/// What the table calls a value that is made up.
std::string value_of(const std::string& key) {
  static const std::pair<const char*, const char*> kValues[] = {
      {"Camera.fps", "frame rate"},       {"Camera.RGB", "colour order"},
      {"ThDepth", "depth threshold"},     {"overlapping", "overlapping columns"},
      {"ORBextractor", "ORBextractor.*"}, {"Viewer", "Viewer.*"},
      {"rostopic", "IMU topic"},          {"extrinsic", "pose in the vehicle"},
      {"T_imu_cam", "pose in the IMU"},   {"imu_update_rate", "IMU noise and rate"},
      {"_std", "IMU noise and rate"},     {"inverse polynomial", "inverse polynomial (fitted)"},
  };
  for (const auto& [part, value] : kValues) {
    if (contains(key, part)) return value;
  }
  return key;
}

/// `condition`: " (k3 != 0)", behind the models' names.
void convert_into(const Input& input, const Format& from, const Format& to, const std::string& condition, Classes& classes) {
  const TemporaryFolder folder;
  Input words = {"convert", "--from", std::string(from.id), "--to", std::string(to.id), "--json", "-o"};
  words.push_back(folder.path().string() + "/");
  if (std::ranges::find(input, "--max-angle") == input.end()) words.insert(words.end(), {"--max-angle", "30"});
  words.insert(words.end(), input.begin(), input.end());
  const RunResult run = run_program(words);
  EXPECT_EQ(run.code, 0) << input.front() << " -> " << to.id << run.out << run.err;
  if (run.code != 0) return;
  const rapidjson::Document json = json_of(run.out);
  for (const rapidjson::Value& camera : json["cameras"].GetArray())
    (camera["exact"].GetBool() ? classes.exact : classes.fitted).insert(camera["from_model"].GetString() + condition);
  std::string lost;
  for (const rapidjson::Value& loss : json["losses"].GetArray()) {
    const std::string what = loss["what"].GetString();
    classes.dropped.insert(fact_of(loss["code"].GetString(), what, from, to));
    if (!contains(loss["why"].GetString(), "to each other is kept")) lost += what + "; ";
  }
  // Of cameras that are posed by way of the IMU, their poses to each other go with it.
  if (contains(lost, "imu0_cam0") && contains(lost, "imu0_cam1"))
    classes.dropped.insert("poses" + (to.id == "opencv" ? kButForAPair : ""));
  for (const rapidjson::Value& value : json["defaults"].GetArray())
    classes.defaulted.insert(value_of(value["key"].GetString()));
  int files = 0;
  for (const rapidjson::Value& output : json["outputs"].GetArray()) files += output["cameras"].Empty() ? 0 : 1;
  if (files > 1 && std::ranges::find(input, "--join") == input.end())
    classes.dropped.insert("several cameras in one file" + (to.id == "opencv" ? kButForAPair : ""));
}

/// The rig as a file of the format; nothing where that cannot hold it, or is read as another model: Kalibr's ucm as the eucm
/// and its pinhole as the radtan that they are written as.
std::optional<Input> written(const TemporaryFolder& folder, const std::string& name, const Format& format, const Rig& rig) {
  Diagnostics ignored;
  const std::optional<Written> files = write_calibration(format, nullptr, rig, {}, ignored);
  if (!files) return std::nullopt;
  const text::Document& document = files->files.front().document;
  const std::optional<Rig> back = format.read(std::span(&document, 1), {}, ignored);
  if (!back || back->cameras.front().model.index() != rig.cameras.front().model.index()) return std::nullopt;
  return Input{folder.write(name + std::string(format.extension), document.bytes())};
}

Input good(const std::string& name) { return {testdata("formats/" + name)}; }

Input operator+(Input words, const Input& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// A stereo rig with its poses, or three cameras of one model.
Rig plain_rig(const std::string& model, int cameras) {
  Rig rig;
  for (int i = 0; i < cameras; ++i) {
    const std::string name = "cam" + std::to_string(i);
    rig.cameras.push_back({name, sample_size(model), sample_model(model, i % 2), std::nullopt, std::nullopt, ""});
    if (i > 0) rig.poses.push_back({name, "cam" + std::to_string(i - 1), T_cam1_cam0()});
  }
  return rig;
}

/// What files of the format can hold, file by file.
std::vector<Input> full_files(const TemporaryFolder& folder, const Format& format) {
  std::vector<Input> inputs;
  if (format.many_cameras) {
    for (const std::string model : {"kb4", "mei"}) {
      for (const int cameras : {2, 3}) {
        if (std::optional<Input> input = written(folder, model + std::to_string(cameras), format, plain_rig(model, cameras)))
          inputs.push_back(*std::move(input));
      }
    }
  }
  const Input with_imu = good("kalibr/good/tumvi.yaml") + Input{"--with"} + good("kalibr/good/imu.yaml");
  if (format.id == "kalibr") {
    const std::string shifted =
        with_replaced(read_file(testdata("formats/kalibr/good/tumvi.yaml")), "cam0:\n", "cam0:\n  timeshift_cam_imu: 0.0021\n");
    inputs.push_back(Input{folder.write("shifted.yaml", shifted), "--with"} + good("kalibr/good/imu.yaml"));
  }
  if (format.id == "tumvi") inputs.insert(inputs.end(), {with_imu, good("tumvi/good/pinhole.txt")});
  if (format.id == "opencv") {
    const std::string moved = with_replaced(read_file(testdata("formats/opencv/good/cameras.yml")),
                                            "data: [ 1., 0., 0., 0., 0., 1.,", "data: [ 1., 0., 0., 0.25, 0., 1.,");
    inputs.insert(inputs.end(), {good("opencv/good/calibration.yml"), Input{folder.write("moved.yml", moved)}});
  }
  if (format.id == "ocamcalib") {
    inputs.push_back(good("ocamcalib/good/toolbox.txt"));
    inputs.push_back(good("ocamcalib/good/toolbox.txt") + good("ocamcalib/good/free-layout.txt") +
                     good("ocamcalib/good/degree-eight.txt") + Input{"--join"});
  }
  if (format.id == "orbslam3")
    inputs.insert(inputs.end(), {good("orbslam3/good/v1-stereo-inertial.yaml"), good("orbslam3/good/v1-rectified.yaml")});
  if (format.id == "woodscape") {
    inputs.insert(inputs.end(), {good("woodscape/good/front.json"), good("woodscape/good/ints-and-more.json"),
                                 good("woodscape/good/front.json") + good("woodscape/good/crlf-tabs.json") +
                                     good("woodscape/good/one-line.json") + Input{"--join"}});
  }
  if (format.id == "basalt") {
    inputs.insert(inputs.end(), {good("basalt/good/pair.json"), good("basalt/good/mono-vignette.json")});
    // Within 30 deg a ucm is rational to 1e-10 px; a wide one is mei.
    if (std::optional<Input> input = written(folder, "ucm3", format, plain_rig("ucm", 3)))
      inputs.push_back(*input + Input{"--max-angle", "100"});
  }
  return inputs;
}

/// A file of a camera, and on what condition it is not as the others of its model.
struct ModelFile {
  Input input;
  std::string condition;  ///< " (k3 != 0)", or nothing.
};

/// Files for every model that the format stores, and of those parameters that not every format has.
std::vector<ModelFile> model_files(const TemporaryFolder& folder, const Format& format) {
  std::vector<ModelFile> files;
  if (format.id == "ocamcalib") files.push_back({good("ocamcalib/good/toolbox.txt"), ""});
  if (format.id == "woodscape") files.push_back({good("woodscape/good/front.json"), ""});
  const auto add = [&](const Rig& rig, const std::string& condition) {
    const std::string name = std::string(model_info(rig.cameras.front().model).id) + std::to_string(files.size());
    if (std::optional<Input> input = written(folder, name, format, rig)) files.push_back({*std::move(input), condition});
  };
  for (const StoredModel& stored : format.models) {
    const std::string model(stored.model);
    if (model == "ocamcalib" || model == "woodscape") continue;
    Rig rig = plain_rig(model == "rational" ? "radtan" : model, 1);
    if (model == "rational") {
      rig.cameras[0].model =
          model_of(model, {458.654, 457.296, 367.215, 248.375, -0.28, 0.07, 0.0002, 0.00002, 0.001, 0.01, 0.002, 0.0005});
    }
    add(rig, "");
    if (model == "radtan" && set_parameter(rig.cameras[0].model, "k3", 0.001)) add(rig, " (k3 != 0)");
    if (set_parameter(rig.cameras[0].model, "alpha", 1.0)) add(rig, " (alpha not in [0, 1))");
  }
  return files;
}

class Ledger : public testing::TestWithParam<const Format*> {};

TEST_P(Ledger, SaysWhatConvertDoes) {
  const Format& from = *GetParam();
  const auto rows = table();
  const TemporaryFolder folder;
  const std::vector<Input> full = full_files(folder, from);
  const std::vector<ModelFile> models = model_files(folder, from);
  for (const Format& to : all_formats()) {
    if (&from == &to) continue;
    SCOPED_TRACE(std::string(from.id) + " -> " + std::string(to.id));
    const Classes& expected = rows.at({std::string(from.id), std::string(to.id)});
    Classes facts;
    for (const Input& input : full) convert_into(input, from, to, "", facts);
    EXPECT_EQ(facts.dropped, expected.dropped);
    EXPECT_EQ(facts.defaulted, expected.defaulted);
    Classes got;
    for (const ModelFile& file : models) convert_into(file.input, from, to, file.condition, got);
    for (const std::string& name : got.exact) EXPECT_TRUE(says_exact(expected, name)) << name << " stays exact";
    for (const std::string& name : got.fitted) {
      if (to.id == "opencv" && model_in(name) == "ucm") continue;  // mei by the table, rational within 30 deg
      const bool said = expected.fitted.contains(name) || expected.fitted.contains(model_in(name));
      EXPECT_TRUE(said) << name << " is fitted";
    }
    // Of Kalibr's ucm and pinhole there is no file (see written()).
    const auto has_file = [](const std::string& name) { return model_in(name) != "ucm" && model_in(name) != "pinhole"; };
    for (const std::string& name : expected.exact)
      EXPECT_TRUE(got.exact.contains(model_in(name)) || !has_file(name)) << name << " is not exact";
    for (const std::string& name : expected.fitted)
      EXPECT_TRUE(got.fitted.contains(name) || !has_file(name)) << name << " is not fitted";
  }
}

std::vector<const Format*> formats() {
  std::vector<const Format*> result;
  for (const Format& format : all_formats()) result.push_back(&format);
  return result;
}

std::string name_of(const testing::TestParamInfo<const Format*>& format) { return std::string(format.param->id); }

INSTANTIATE_TEST_SUITE_P(From, Ledger, testing::ValuesIn(formats()), name_of);

}  // namespace
}  // namespace fca::test
