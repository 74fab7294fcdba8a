// SPDX-License-Identifier: BSD-3-Clause
// COLMAP's rigs: rigs.txt and rigs.bin of a model folder, and rig_config.json for its rig_configurator. From
// colmap/colmap@5d968cf (4.2.0.dev0, 2026-08-08), src/colmap/scene/ reconstruction_io_text.cc (ReadRigsText),
// reconstruction_io_binary.cc (ReadRigsBinary) and rig.cc (ReadRigConfig).
#include <rapidjson/document.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <locale>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "colmap.h"
#include "fca/code.h"
#include "quaternion_pose.h"

namespace fca::consumers::colmap {
namespace {

using Numbers = std::vector<double>;

class Rigs {
 public:
  explicit Rigs(ConsumerView& view) : view_(view) {}

  void run_text(std::string_view bytes) {
    std::istringstream lines{std::string(bytes)};
    int number = 0;
    for (std::string line; view_.loads() && std::getline(lines, line);) {
      const std::size_t first = line.find_first_not_of(" \t\r\v\f");
      if (first == std::string::npos || line[first] == '#') continue;
      std::istringstream words(line);
      words.imbue(std::locale::classic());
      if (!read_line(words, ++number)) refuse(Code::kColmapSaysNoRigLine, number);
    }
  }

  /// True if it takes all bytes.
  bool run_binary(std::string_view bytes) {
    Bytes stream(bytes);
    const std::uint64_t count = stream.number(8);
    for (std::uint64_t i = 1; view_.loads() && i <= count; ++i) {
      const auto number = static_cast<int>(i);
      stream.number(4);
      const std::uint64_t sensors = stream.number(4);
      std::string reference;
      for (std::uint64_t k = 0; k < sensors && view_.loads() && !stream.is_short(); ++k) {
        const std::string type = stream.number(4) == 0 ? "CAMERA" : "IMU";
        const std::string name = type + " " + std::to_string(stream.number(4));
        const bool has_pose = k > 0 && stream.number(1) != 0;
        Numbers numbers(has_pose ? 7 : 0);
        for (double& value : numbers) value = stream.real();
        if (!stream.is_short()) add(name, numbers, reference, number);
      }
      if (stream.is_short()) refuse(Code::kColmapSaysEnds, number);
    }
    return view_.loads() && stream.is_at_end();
  }

 private:
  void refuse(Code code, int number) {
    view_.refusals.emplace_back(code, "", std::vector<Argument>{number});
    view_.poses.clear();
  }

  bool read_line(std::istream& words, int number) {
    std::uint32_t id = 0;
    std::uint64_t sensors = 0;
    if (!(words >> id >> sensors)) return false;
    std::string reference;
    for (std::uint64_t k = 0; k < sensors && view_.loads(); ++k) {
      std::string type;
      int has_pose = 0;
      if (!(words >> type >> id) || (type != "CAMERA" && type != "IMU") || (k > 0 && !(words >> has_pose))) return false;
      Numbers numbers(has_pose == 1 ? 7 : 0);
      for (double& value : numbers) words >> value;
      if (!words) return false;
      add(type + " " + std::to_string(id), numbers, reference, number);
    }
    return true;
  }

  /// The first sensor of a rig is its reference.
  void add(const std::string& name, const Numbers& q, std::string& reference, int number) {
    if (reference.empty()) sensors_.clear();
    if (!sensors_.insert(name).second) return refuse(Code::kColmapSaysSensorTwice, number);
    if (reference.empty()) reference = name;
    if (!q.empty()) view_.poses.push_back({name, reference, pose_as_if_unit(q[0], {q[1], q[2], q[3]}, {q[4], q[5], q[6]})});
  }

  ConsumerView& view_;
  std::set<std::string> sensors_;
};

/// ReadRigConfig through boost::property_tree: keys in any order, further ones ignored.
class RigConfig {
 public:
  explicit RigConfig(ConsumerView& view) : view_(view) {}

  void run(std::string_view bytes) {
    rapidjson::Document document;
    document.Parse<rapidjson::kParseFullPrecisionFlag | rapidjson::kParseIterativeFlag>(bytes.data(), bytes.size());
    if (document.HasParseError() || !document.IsArray()) return refuse(Code::kColmapSaysNoRig);
    std::vector<const Json*> rigs;
    for (const Json& rig : document.GetArray()) {
      const Json* cameras = rig.IsObject() ? member(rig, "cameras") : nullptr;
      if (cameras == nullptr || !cameras->IsArray()) return refuse(Code::kColmapSaysNoRig);
      rigs.push_back(cameras);
      for (const Json& camera : cameras->GetArray()) {
        const Json* prefix = camera.IsObject() ? member(camera, "image_prefix") : nullptr;
        if (prefix == nullptr || !prefix->IsString()) return refuse(Code::kColmapSaysNoPrefix);
        ++last_folders_[last_folder(folder_of(prefix->GetString()))];
      }
    }
    for (const Json* cameras : rigs) {
      read_rig(*cameras);
      if (!view_.loads()) return;
    }
  }

 private:
  using Json = rapidjson::Value;

  static const Json* member(const Json& object, const char* key) {
    const auto found = object.FindMember(key);
    return found == object.MemberEnd() ? nullptr : &found->value;
  }

  static Numbers numbers_in(const Json* list) {
    Numbers numbers;
    if (list == nullptr || !list->IsArray()) return numbers;
    for (const Json& item : list->GetArray()) {
      if (item.IsNumber()) numbers.push_back(item.GetDouble());
      if (item.IsString()) numbers.push_back(std::strtod(item.GetString(), nullptr));
    }
    return numbers;
  }

  /// As boost::property_tree reads a bool: numbers and words alike.
  static bool is_true(const Json* value) {
    if (value == nullptr) return false;
    if (value->IsString()) return std::string_view(value->GetString()) == "true" || std::string_view(value->GetString()) == "1";
    return value->IsBool() ? value->GetBool() : value->IsInt() && value->GetInt() == 1;
  }

  /// "rig/cam0" of the prefix "rig/cam0/"
  static std::string folder_of(std::string prefix) {
    while (prefix.ends_with('/')) prefix.pop_back();
    return prefix;
  }
  static std::string last_folder(const std::string& folder) { return folder.substr(folder.rfind('/') + 1); }

  /// As fca names the camera: by the last folder of its prefix, by all of it where two end alike.
  std::string name_of(const std::string& prefix) const {
    const std::string folder = folder_of(prefix);
    const std::string last = last_folder(folder);
    return last_folders_.at(last) > 1 ? folder : last;
  }

  void refuse(Code code, std::vector<Argument> arguments = {}) {
    view_.refusals.emplace_back(code, "", std::move(arguments));
    view_.cameras.clear();
    view_.poses.clear();
  }

  /// The values under two keys that count together; nulls, with a warning where one alone is there.
  std::array<const Json*, 2> both(const Json& camera, const char* first, const char* second) {
    const std::array<const Json*, 2> found = {member(camera, first), member(camera, second)};
    if (found[0] != nullptr && found[1] != nullptr) return found;
    if (found[0] != found[1]) {
      const std::vector<Argument> which =
          found[0] != nullptr ? std::vector<Argument>{first, second} : std::vector<Argument>{second, first};
      view_.warnings.emplace_back(Code::kColmapSaysHalf, "", which);
    }
    return {nullptr, nullptr};
  }

  void read_rig(const Json& cameras) {
    std::size_t references = 0;
    std::string reference;
    for (const Json& camera : cameras.GetArray()) {
      if (!is_true(member(camera, "ref_sensor"))) continue;
      ++references;
      reference = name_of(member(camera, "image_prefix")->GetString());
    }
    if (references != 1) return refuse(Code::kColmapSaysReferences, {references});
    for (const Json& camera : cameras.GetArray()) {
      const std::string name = name_of(member(camera, "image_prefix")->GetString());
      const auto [rotation, translation] = both(camera, "cam_from_rig_rotation", "cam_from_rig_translation");
      const Numbers q = numbers_in(rotation);
      const Numbers t = numbers_in(translation);
      if (rotation != nullptr && name == reference) return refuse(Code::kColmapSaysReferencePose);
      if (q.size() == 4 && t.size() == 3)
        view_.poses.push_back({name, reference, pose_as_if_unit(q[0], {q[1], q[2], q[3]}, {t[0], t[1], t[2]})});
      read_lens(camera, name);
      if (!view_.loads()) return;
    }
  }

  void read_lens(const Json& camera, const std::string& name) {
    const auto [model_name, params] = both(camera, "camera_model_name", "camera_params");
    if (model_name == nullptr || !model_name->IsString()) return;
    const Model* model = find_model(model_name->GetString());
    if (model == nullptr) return refuse(Code::kColmapSaysUnknownModel, {0, model_name->GetString()});
    const Numbers numbers = numbers_in(params);
    if (numbers.size() == model->parameters()) view_.cameras.push_back(seen_camera(name, *model, numbers));
  }

  ConsumerView& view_;
  std::map<std::string, int> last_folders_;  ///< Of all cameras' prefixes, and how many end so.
};

}  // namespace

void read_rigs(std::string_view bytes, ConsumerView& view) { Rigs(view).run_text(bytes); }
bool read_binary_rigs(std::string_view bytes, ConsumerView& view) { return Rigs(view).run_binary(bytes); }
void read_rig_config(std::string_view bytes, ConsumerView& view) { RigConfig(view).run(bytes); }

}  // namespace fca::consumers::colmap
