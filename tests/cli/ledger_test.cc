// SPDX-License-Identifier: BSD-3-Clause
// The ledger of `fca-io formats --ledger` against what convert does: for every pair of formats files that hold what the format
// can hold are converted, and what comes out exact, fitted, dropped and defaulted is what the table says.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "formats/rigs.h"

#include <fca/code.h>
#include <fca/formats/calibration.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <sstream>
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

/// The same of formats that specify poses of pairs only.
const std::string kButForAStereoPair = "poses, but for a stereo pair";

/// What the table calls a loss.
std::string fact_of(const std::string& code, const std::string& what, const Format& from, const Format& to) {
  static const std::map<std::string, std::string> kFacts = {{"imu-dropped", "IMU"},
                                                            {"time-offset-dropped", "time offset"},
                                                            {"topic-dropped", "topics"},
                                                            {"frame-rate-dropped", "frame rate"},
                                                            {"baseline-dropped", "baseline without poses"},
                                                            {"camera-dropped", "cameras beyond 2"}};
  if (code == "not-carried") {
    const auto states = [&what](std::string_view key) { return contains(what, " " + std::string(key)); };
    const auto named =
        std::ranges::find_if(from.own_facts, [&states](const OwnFact& fact) { return std::ranges::any_of(fact.keys, states); });
    return std::string((named == from.own_facts.end() ? from.own_facts.front() : *named).name);
  }
  if (code == "pose-dropped") {
    if (contains(what, "imu")) return "IMU";
    const std::string frame(from.frame);
    if (!frame.empty() && contains(what, frame)) return "poses in the frame " + frame;
    if (to.pair_poses) return kButForAStereoPair;
    return "poses" + (to.id == "opencv" ? kButForAPair : "");
  }
  // A pair's rotations and its common image, R and P of both files.
  if (code == "rectification-dropped" && from.frame == "rectified") return std::string(from.own_facts.front().name);
  const auto found = kFacts.find(code);
  return found == kFacts.end() ? code : found->second;
}

/// What the table calls a value that is made up.
std::string value_of(const std::string& key, const Format& to) {
  const auto demand =
      std::ranges::find_if(to.demands, [&key](const Demand& candidate) { return contains(key, std::string(candidate.key)); });
  return demand == to.demands.end() ? key : std::string(demand->name);
}

/// Is it computed for a model that a lens of another one has become? The table tells of those that stay.
bool is_of_fitted(const std::string& key, const Format& from, const Format& to) {
  return std::ranges::any_of(to.demands, [&](const Demand& demand) {
    return !demand.of_model.empty() && to.models.size() > 1 && contains(key, std::string(demand.key)) &&
           find_stored_model(from, demand.of_model, true) == nullptr;
  });
}

/// " (k3 != 0)", or nothing: which of the parameters that not every format has the camera has.
std::string condition_of(const CameraModel& model) {
  constexpr std::array<ParameterId, 4> kBeyondDegreeFour = {"a5", "a6", "a7", "a8"};
  const auto has = [&model](ParameterId id) { return parameter(model, id).value_or(0.0) != 0.0; };
  if (std::ranges::any_of(kBeyondDegreeFour, has)) return " (a5 != 0 or a6 != 0 or a7 != 0 or a8 != 0)";
  if (model_info(model).id.starts_with("radtan") && has("k3")) return " (k3 != 0)";
  if (has("tau_x") || has("tau_y")) return " (tau_x != 0 or tau_y != 0)";
  if (parameter(model, "alpha").value_or(0.0) >= 1.0) return " (alpha not in [0, 1))";
  return "";
}

Rig rig_of(const std::string& path, const Format& format) {
  Diagnostics ignored;
  const std::optional<text::Document> document = text::parse_document({path, read_file(path)}, ignored);
  return document ? format.read(std::span(&*document, 1), {}, ignored).value_or(Rig()) : Rig();
}

void convert_into(const Input& input, const Format& from, const Format& to, Classes& classes) {
  const TemporaryFolder folder;
  Input words = {"convert", "--from", std::string(from.id), "--to", std::string(to.id), "--json", "-o"};
  words.push_back(folder.path().string() + "/");
  words.insert(words.end(), {"--accept", "pose-missing"});
  // ROS takes the images of pinholes for rectified ones.
  if (!from.is_written() && to.pair_poses) words.insert(words.end(), {"--accept", "pixels-off"});
  if (std::ranges::find(input, "--max-angle") == input.end()) words.insert(words.end(), {"--max-angle", "30"});
  words.insert(words.end(), input.begin(), input.end());
  const RunResult run = run_program(words);
  EXPECT_EQ(run.code, 0) << input.front() << " -> " << to.id << run.out << run.err;
  if (run.code != 0) return;
  const rapidjson::Document json = json_of(run.out);
  const Rig source = rig_of(input.front(), from);
  for (const rapidjson::Value& camera : json["cameras"].GetArray()) {
    const Camera* read = source.find_camera(camera["input_name"].GetString());
    if (read != nullptr && !read->rays.empty()) continue;  // a lens that is no model of the list
    const std::string condition = read != nullptr ? condition_of(read->model) : "";
    (camera["exact"].GetBool() ? classes.exact : classes.fitted).insert(camera["from_model"].GetString() + condition);
  }
  std::string lost;
  const std::string_view kept = info(Code::kPosesOfGroupsKept).text;  // of its words, those after the cameras
  const std::string poses_are_kept(kept.substr(kept.rfind('}') + 1));
  for (const rapidjson::Value& loss : json["losses"].GetArray()) {
    const std::string what = loss["what"].GetString();
    // The place in the IMU of a camera that has none: the table is of rigs with one.
    if (loss["code"] == "pose-dropped" && contains(what, "imu") && to.imu) continue;
    // Where the mode that keeps it is not asked for, a baseline alone goes.
    if (loss["code"] == "baseline-dropped" && to.baseline) continue;
    if (loss["code"] == "pose-recomputed" || loss["code"] == "frame-rate-rounded") continue;  // the fact stays
    classes.dropped.insert(fact_of(loss["code"].GetString(), what, from, to));
    if (!contains(loss["why"].GetString(), poses_are_kept)) lost += what + "; ";
    if (to.pair_poses && from.many_cameras && contains(what, "_cam2")) classes.dropped.insert(kButForAStereoPair);
  }
  // Of cameras that are posed by way of the IMU, their poses to each other go with it.
  constexpr std::string_view kInImu = "T_imu0_";
  const std::size_t first = lost.find(kInImu);
  if (first != std::string::npos && lost.find(kInImu, first + 1) != std::string::npos)
    classes.dropped.insert(to.pair_poses ? kButForAStereoPair : "poses" + (to.id == "opencv" ? kButForAPair : ""));
  // So do those of a pair whose place in the rectified images, or in the vehicle, is told.
  const std::string in_frame = "T_" + std::string(from.frame) + (from.is_written() ? "(" : "_");
  const std::size_t told = from.frame.empty() ? std::string::npos : lost.find(in_frame);
  if (from.many_cameras && told != std::string::npos && lost.find(in_frame, told + 1) != std::string::npos) {
    if (!to.extrinsics) classes.dropped.insert("poses");
    if (to.pair_poses && !from.is_written()) classes.dropped.insert(kButForAStereoPair);
  }
  for (const rapidjson::Value& value : json["defaults"].GetArray()) {
    if (!is_of_fitted(value["key"].GetString(), from, to)) classes.defaulted.insert(value_of(value["key"].GetString(), to));
  }
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

/// The words of a line, file names as paths.
Input words_of(const std::string& line, const fs::path& folder) {
  std::istringstream words(line);
  Input input;
  for (std::string word; words >> word;) input.push_back(fs::exists(folder / word) ? (folder / word).string() : word);
  return input;
}

/// What files of the format can hold, file by file.
std::vector<Input> full_files(const TemporaryFolder& folder, const Format& format) {
  std::vector<Input> inputs;
  if (format.many_cameras && !format.needs_imu) {
    for (const std::string model : {"kb4", "mei"}) {
      for (const int cameras : {2, 3}) {
        if (std::optional<Input> input = written(folder, model + std::to_string(cameras), format, plain_rig(model, cameras)))
          inputs.push_back(*std::move(input));
      }
    }
  }
  const fs::path whole = testdata("formats/" + std::string(format.id) + "/whole.txt");
  std::istringstream lines(read_file(whole));
  for (std::string line; std::getline(lines, line);) {
    const fs::path good = whole.parent_path() / "good";  // a format of another's layout has none
    if (!line.starts_with('#')) inputs.push_back(words_of(line, fs::exists(good) ? good : whole.parent_path()));
  }
  return inputs;
}

/// A camera of the model; of those whose numbers are many, that of a file.
Rig one_camera(const std::string& model) {
  if (model == "ocamcalib") return rig_in(read_file(testdata("formats/ocamcalib/good/toolbox.txt")));
  if (model == "woodscape") return rig_in(read_file(testdata("formats/woodscape/good/front.json")));
  if (model == "opencv14") {  // without its tilt
    Rig rig = rig_in(read_file(testdata("formats/ros/good/tilted.yaml")));
    for (const ParameterId tilt : {ParameterId("tau_x"), ParameterId("tau_y")}) set_parameter(rig.cameras[0].model, tilt, 0.0);
    return rig;
  }
  constexpr std::string_view kSkew = "-skew";
  if (model.ends_with(kSkew)) {
    Rig rig = one_camera(model.substr(0, model.size() - kSkew.size()));
    rig.cameras[0].model = with_skew(rig.cameras[0].model, 0.75).value();
    return rig;
  }
  if (model != "rational") return plain_rig(model, 1);
  Rig rig = plain_rig("radtan", 1);
  rig.cameras[0].model =
      model_of(model, {458.654, 457.296, 367.215, 248.375, -0.28, 0.07, 0.0002, 0.00002, 0.001, 0.01, 0.002, 0.0005});
  return rig;
}

/// Files for every model that the format stores, and of those parameters that not every format has. Of one that is only read
/// its good files.
std::vector<Input> model_files(const TemporaryFolder& folder, const Format& format) {
  std::vector<Input> files;
  if (!format.is_written()) {
    for (const auto& entry : fs::directory_iterator(testdata("formats/" + std::string(format.id) + "/good"))) {
      const Rig rig = rig_of(entry.path(), format);
      if (!rig.cameras.empty() && rig.cameras.front().image_size) files.push_back({entry.path().string()});
    }
    return files;
  }
  const auto add = [&](const Rig& rig) {
    const std::string name = std::string(model_info(rig.cameras.front().model).id) + std::to_string(files.size());
    if (std::optional<Input> input = written(folder, name, format, rig)) files.push_back(*std::move(input));
  };
  for (const StoredModel& stored : format.models) {
    const std::string model(stored.model);
    Rig rig = one_camera(model);
    add(rig);
    if (model == "ocamcalib") add(rig_in(read_file(testdata("formats/ocamcalib/good/degree-eight.txt"))));
    if (model == "radtan" && set_parameter(rig.cameras[0].model, "k3", 0.001)) add(rig);
    if (set_parameter(rig.cameras[0].model, "tau_x", 0.002)) add(rig);
    if (set_parameter(rig.cameras[0].model, "alpha", 1.0)) add(rig);
  }
  return files;
}

class Ledger : public testing::TestWithParam<const Format*> {};

TEST_P(Ledger, SaysWhatConvertDoes) {
  const Format& from = *GetParam();
  const auto rows = table();
  const TemporaryFolder folder;
  const std::vector<Input> full = full_files(folder, from);
  const std::vector<Input> models = model_files(folder, from);
  Names read;
  for (const Format& to : written_formats()) {
    if (&from == &to) continue;
    SCOPED_TRACE(std::string(from.id) + " -> " + std::string(to.id));
    const Classes& expected = rows.at({std::string(from.id), std::string(to.id)});
    Classes facts;
    for (const Input& input : full) convert_into(input, from, to, facts);
    Names dropped = expected.dropped;
    // Whether a lens becomes mei is the fit's choice; formats that are written have files that hold one.
    if (!from.is_written())
      std::erase_if(dropped,
                    [&](const std::string& fact) { return fact.ends_with(kButForAPair) && !facts.dropped.contains(fact); });
    EXPECT_EQ(facts.dropped, dropped);
    EXPECT_EQ(facts.defaulted, expected.defaulted);
    Classes got;
    for (const Input& file : models) convert_into(file, from, to, got);
    for (const Names* names : {&got.exact, &got.fitted}) {
      for (const std::string& name : *names) read.insert(model_in(name));
    }
    for (const std::string& name : got.exact) EXPECT_TRUE(says_exact(expected, name)) << name << " stays exact";
    // Several cameras in a good file, of which these formats take two, or make one model.
    if (!from.is_written() && (to.one_model || to.most_cameras == 2)) continue;
    for (const std::string& name : got.fitted) {
      // mei by the table, rational within 30 deg
      if ((to.id == "opencv" || to.id == "vins" || to.id == "colmap") && model_in(name) == "ucm") continue;
      const bool said = expected.fitted.contains(name) || expected.fitted.contains(model_in(name));
      EXPECT_TRUE(said) << name << " is fitted";
    }
    if (!from.is_written()) continue;
    // Of Kalibr's ucm and pinhole there is no file (see written()).
    const auto has_file = [](const std::string& name) { return model_in(name) != "ucm" && model_in(name) != "pinhole"; };
    for (const std::string& name : expected.exact)
      EXPECT_TRUE(got.exact.contains(model_in(name)) || !has_file(name)) << name << " is not exact";
    for (const std::string& name : expected.fitted)
      EXPECT_TRUE(got.fitted.contains(name) || !has_file(name)) << name << " is not fitted";
  }
  for (const StoredModel& stored : from.is_written() ? std::span<const StoredModel>() : from.models)
    EXPECT_TRUE(read.contains(std::string(stored.model))) << stored.model << ": no good file has it";
}

std::vector<const Format*> formats() {
  std::vector<const Format*> result;
  for (const Format& format : all_formats()) {
    if (!format.models.empty()) result.push_back(&format);
  }
  return result;
}

std::string name_of(const testing::TestParamInfo<const Format*>& format) {
  std::string name(format.param->id);
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(From, Ledger, testing::ValuesIn(formats()), name_of);

}  // namespace
}  // namespace fca::test
