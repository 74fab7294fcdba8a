// SPDX-License-Identifier: BSD-3-Clause
#include "kalibr.h"

#include "fields.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace fca::kalibr {

namespace {

using text::Node;

/// One number of intrinsics or distortion_coeffs: a parameter of our model, or a constant the layout demands.
struct Slot {
  std::string_view parameter;
  double constant = 0.0;
};

/// How Kalibr writes one of our models.
struct Layout {
  std::string_view model;
  std::string_view camera_model;
  std::string_view distortion_model;
  std::vector<Slot> intrinsics;
  std::vector<Slot> coefficients;
};

/// Reading takes the first row with the file's two names, writing the first row of the model.
const std::vector<Layout>& layouts() {
  static const std::vector<Slot> kFocalAndCentre = {{"fx"}, {"fy"}, {"cx"}, {"cy"}};
  static const std::vector<Layout> kLayouts = {
      {"radtan", "pinhole", "radtan", kFocalAndCentre, {{"k1"}, {"k2"}, {"p1"}, {"p2"}}},
      {"kb4", "pinhole", "equidistant", kFocalAndCentre, {{"k1"}, {"k2"}, {"k3"}, {"k4"}}},
      {"fov", "pinhole", "fov", kFocalAndCentre, {{"w"}}},
      // Written with four zeros: Kalibr reads pinhole-none, but its camera object then lacks a geometry (ConfigReader.py).
      {"pinhole", "pinhole", "radtan", kFocalAndCentre, {{""}, {""}, {""}, {""}}},
      {"pinhole", "pinhole", "none", kFocalAndCentre, {}},
      {"mei", "omni", "radtan", {{"xi"}, {"fx"}, {"fy"}, {"cx"}, {"cy"}}, {{"k1"}, {"k2"}, {"p1"}, {"p2"}}},
      {"mei", "omni", "none", {{"xi"}, {"fx"}, {"fy"}, {"cx"}, {"cy"}}, {}},
      {"eucm", "eucm", "none", {{"alpha"}, {"beta"}, {"fx"}, {"fy"}, {"cx"}, {"cy"}}, {}},
      {"ds", "ds", "none", {{"xi"}, {"alpha"}, {"fx"}, {"fy"}, {"cx"}, {"cy"}}, {}},
      {"ucm", "eucm", "none", {{"alpha"}, {"", 1.0}, {"fx"}, {"fy"}, {"cx"}, {"cy"}}, {}},
  };
  return kLayouts;
}

/// ConfigReader.py demands 0 <= alpha < 1; a radtan has no k3.
constexpr double kBelowOne = 1.0 - std::numeric_limits<double>::epsilon() / 2;
constexpr std::array kAlphaRange = {ParameterRange{"alpha", 0.0, kBelowOne}};
constexpr std::array kNoK3 = {ParameterRange{"k3", 0.0, 0.0}};

constexpr std::array kModels = {
    StoredModel{"radtan", "pinhole-radtan", true, "Kalibr", kNoK3},
    StoredModel{"kb4", "pinhole-equidistant", true, "Kalibr (rays inside 90 deg)", {}},
    StoredModel{"mei", "omni-radtan", true, "Kalibr", {}},
    StoredModel{"eucm", "eucm-none", true, "Kalibr", kAlphaRange},
    StoredModel{"ds", "ds-none", true, "Kalibr", kAlphaRange},
    StoredModel{"ucm", "eucm-none with beta = 1", true, "Kalibr", kAlphaRange},
    StoredModel{"fov", "pinhole-fov", true, "Kalibr (w in [0.5, 1.5])", {}},
    StoredModel{"pinhole", "pinhole-radtan with zeros", true, "Kalibr", {}},
};

text::Dialect dialect_of(const text::Document& document) {
  return document.syntax() == text::Syntax::kOpenCvYaml ? text::Dialect::kOpenCv : text::Dialect::kPyYaml;
}

std::string indexed(std::string_view prefix, std::size_t index) { return std::string(prefix) + std::to_string(index); }

/// "cam12" -> 12.
std::optional<std::size_t> index_in(std::string_view key, std::string_view prefix) {
  if (!key.starts_with(prefix) || key.size() == prefix.size()) return std::nullopt;
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(key.data() + prefix.size(), key.data() + key.size(), index);
  if (error != std::errc() || end != key.data() + key.size()) return std::nullopt;
  return index;
}

constexpr std::string_view kNoiseKeys[] = {"accelerometer_noise_density", "accelerometer_random_walk",
                                           "gyroscope_noise_density", "gyroscope_random_walk"};

/// The keys that become fields of a Rig.
constexpr std::string_view kCameraKeys[] = {"camera_model", "intrinsics",       "distortion_model", "distortion_coeffs",
                                            "resolution",   "rostopic",         "T_cam_imu",        "T_imu_cam",
                                            "T_cn_cnm1",    "timeshift_cam_imu"};
constexpr std::string_view kImuKeys[] = {"accelerometer_noise_density",
                                         "accelerometer_random_walk",
                                         "gyroscope_noise_density",
                                         "gyroscope_random_walk",
                                         "update_rate",
                                         "rostopic"};

bool holds_noise(const Node& mapping) {
  return std::ranges::any_of(
      kNoiseKeys, [&mapping](std::string_view key) { return text::find(mapping, key, text::Dialect::kPyYaml) != nullptr; });
}

ProbeResult probe(const text::Document& document) {
  const Node& root = document.root();
  for (const text::Entry& entry : root.entries) {
    if (!index_in(entry.key.value, "cam") || !entry.value.is_mapping()) continue;
    for (const std::string_view key : kCameraKeys) {
      if (text::find(entry.value, key, text::Dialect::kPyYaml) != nullptr) {
        return {90, "a top-level " + entry.key.value + " with " + std::string(key)};
      }
    }
  }
  for (const text::Entry& entry : root.entries) {
    if (index_in(entry.key.value, "cam")) return {60, "a top-level " + entry.key.value};
  }
  if (holds_noise(root)) return {80, "the noise keys of Kalibr's imu.yaml"};
  for (const text::Entry& entry : root.entries) {
    if (index_in(entry.key.value, "imu") && entry.value.is_mapping() && holds_noise(entry.value)) {
      return {80, "a top-level " + entry.key.value + " with noise densities"};
    }
  }
  return {};
}

// ---------------------------------------------------------------------------------------------------------------- reading

class ChainReader {
 public:
  ChainReader(const text::Document& document, const ReadOptions& options, Diagnostics& diagnostics)
      : reader_(document, dialect_of(document), diagnostics), options_(options) {}

  void read_into(Rig& rig) {
    const Node& root = reader_.document().root();
    if (holds_noise(root)) read_imu(root, "imu0", rig);
    for (const text::Entry& entry : root.entries) {
      const bool counts = text::find_entry(root, entry.key.value, reader_.dialect()) == &entry;
      if (!counts) {
        reader_.warning(entry.key, "duplicate-key", "the key " + entry.key.value + " stands twice; this one is not read");
        continue;
      }
      if (index_in(entry.key.value, "cam")) {
        read_camera(entry.value, entry.key, rig);
      } else if (index_in(entry.key.value, "imu") && entry.value.is_mapping()) {
        read_imu(entry.value, entry.key.value, rig);
      } else {
        read_named_pose(entry, rig);
      }
    }
    // Kalibr counts cam0, cam1, ... wherever they stand.
    std::ranges::stable_sort(rig.cameras, {}, [](const Camera& camera) { return *index_in(camera.name, "cam"); });
  }

 private:
  void read_camera(const Node& node, const Node& key, Rig& rig) {
    const std::string& name = key.value;
    if (!node.is_mapping()) {
      reader_.error(key, "not-a-mapping", name + " holds no keys");
      return;
    }
    Camera camera;
    camera.name = name;
    if (!read_model(node, key, camera)) return;
    read_size(node, name, camera);
    if (const Node* topic = reader_.find(node, "rostopic"); topic != nullptr && topic->is_scalar()) camera.topic = topic->value;
    if (const Node* shift = reader_.find(node, "timeshift_cam_imu")) {
      camera.time_offset_s = reader_.real(*shift, name + " timeshift_cam_imu");
    }
    read_poses(node, name, rig);
    keep_unread(node, name, kCameraKeys, rig);
    rig.cameras.push_back(std::move(camera));
  }

  /// What the file says and a Rig has no place for (line_delay, T_i_b, ...): a format without those keys must be able to say
  /// so.
  void keep_unread(const Node& node, const std::string& owner, std::span<const std::string_view> known, Rig& rig) {
    for (const text::Entry& entry : node.entries) {
      if (std::ranges::find(known, entry.key.value) != known.end()) continue;
      const std::string value = entry.value.is_scalar() ? " " + entry.value.value : "";
      rig.as_read.push_back(owner + " " + entry.key.value + value);
    }
  }

  bool read_model(const Node& node, const Node& key, Camera& camera) {
    const std::string& name = key.value;
    const auto string_at = [&](std::string_view k) -> std::optional<std::string> {
      const Node* value = reader_.find(node, k);
      if (value == nullptr) {
        reader_.error(key, "missing-key", name + " has no " + std::string(k));
        return std::nullopt;
      }
      return reader_.string(*value, name + " " + std::string(k));
    };
    const std::optional<std::string> camera_model = string_at("camera_model");
    const std::optional<std::string> distortion_model = string_at("distortion_model");
    if (!camera_model || !distortion_model) return false;

    const auto& rows = layouts();
    const bool known_camera = std::ranges::any_of(rows, [&](const Layout& l) { return l.camera_model == *camera_model; });
    const auto layout = std::ranges::find_if(
        rows, [&](const Layout& l) { return l.camera_model == *camera_model && l.distortion_model == *distortion_model; });
    if (!known_camera) {
      reader_.error(*reader_.find(node, "camera_model"), "unknown-model",
                    name + ": Kalibr has no camera_model '" + *camera_model + "'; it knows pinhole, omni, eucm and ds");
      return false;
    }
    if (layout == rows.end()) {
      reader_.error(
          *reader_.find(node, "distortion_model"), "unknown-model",
          name + ": Kalibr has no camera_model " + *camera_model + " with distortion_model '" + *distortion_model + "'");
      return false;
    }
    camera.model = *make_model(layout->model);
    if (!read_slots(node, key, "intrinsics", layout->intrinsics, camera) ||
        !read_slots(node, key, "distortion_coeffs", layout->coefficients, camera)) {
      return false;
    }
    const StoredModel* stored = find_stored_model(kFormat, layout->model, true);
    for (const ParameterRange& range : stored->ranges) {
      if (within(camera.model, std::span(&range, 1))) continue;
      reader_.warning(*reader_.find(node, "intrinsics"), "program-refuses",
                      name + ": Kalibr refuses " + std::string(range.parameter) + " = " +
                          text::format_short(*parameter(camera.model, range.parameter)) + "; it must be less than 1");
    }
    return true;
  }

  bool read_slots(const Node& node, const Node& key, std::string_view list_key, std::span<const Slot> slots, Camera& camera) {
    const Node* list = reader_.find(node, list_key);
    if (list == nullptr) {
      if (slots.empty()) return true;
      reader_.error(key, "missing-key", key.value + " has no " + std::string(list_key));
      return false;
    }
    const std::string what = key.value + " " + std::string(list_key);
    if (!list->is_sequence() || list->items.size() != slots.size()) {
      const std::string wanted = std::to_string(slots.size());
      reader_.error(*list, "wrong-length",
                    list->is_sequence()
                        ? what + " has " + std::to_string(list->items.size()) + " numbers; " + wanted + " are wanted"
                        : what + " must be a list of " + wanted + " numbers");
      return false;
    }
    bool good = true;
    for (std::size_t i = 0; i < slots.size(); ++i) {
      if (!slots[i].parameter.empty()) good = reader_.parameter(list->items[i], what, slots[i].parameter, camera.model) && good;
    }
    return good;
  }

  void read_size(const Node& node, const std::string& name, Camera& camera) {
    camera.image_size = options_.image_size;
    const Node* resolution = reader_.find(node, "resolution");
    if (resolution == nullptr) return;
    if (!resolution->is_sequence() || resolution->items.size() != 2) {
      reader_.error(*resolution, "wrong-length", name + " resolution must be [width, height]");
      return;
    }
    if (const std::optional<ImageSize> size = reader_.image_size(resolution->items[0], resolution->items[1], name + " "))
      camera.image_size = size;
  }

  void read_poses(const Node& node, const std::string& name, Rig& rig) {
    const std::optional<std::size_t> index = index_in(name, "cam");
    const auto read_edge = [&](std::string_view key, const std::string& a, const std::string& b) {
      const Node* value = reader_.find(node, key);
      if (value == nullptr) return;
      if (const std::optional<Transform> T = reader_.transform(*value, name + " " + std::string(key))) {
        rig.poses.push_back({a, b, *T});
      }
    };
    if (*index > 0) read_edge("T_cn_cnm1", name, indexed("cam", *index - 1));
    read_edge("T_cam_imu", name, "imu0");
    read_edge("T_imu_cam", "imu0", name);
  }

  /// A top-level T_cam1_cam0, as some forks and converters write it.
  void read_named_pose(const text::Entry& entry, Rig& rig) {
    const std::string& key = entry.key.value;
    const std::size_t split = key.find('_', 2);
    if (!key.starts_with("T_") || split == std::string::npos) return;
    const std::string a = key.substr(2, split - 2);
    const std::string b = key.substr(split + 1);
    if (!index_in(a, "cam") || !index_in(b, "cam")) return;
    if (const std::optional<Transform> T = reader_.transform(entry.value, key)) rig.poses.push_back({a, b, *T});
  }

  void read_imu(const Node& node, const std::string& name, Rig& rig) {
    Imu imu;
    imu.name = name;
    const auto read_number = [&](std::string_view key, std::optional<double>& target) {
      if (const Node* value = reader_.find(node, key)) target = reader_.positive(*value, name + " " + std::string(key));
    };
    read_number("accelerometer_noise_density", imu.accelerometer_noise_density);
    read_number("accelerometer_random_walk", imu.accelerometer_random_walk);
    read_number("gyroscope_noise_density", imu.gyroscope_noise_density);
    read_number("gyroscope_random_walk", imu.gyroscope_random_walk);
    read_number("update_rate", imu.rate_hz);
    if (const Node* topic = reader_.find(node, "rostopic"); topic != nullptr && topic->is_scalar()) imu.topic = topic->value;
    keep_unread(node, name, kImuKeys, rig);
    rig.imus.push_back(std::move(imu));
  }

  fields::Reader reader_;
  const ReadOptions& options_;
};

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  Rig rig;
  for (const text::Document& document : documents) {
    Diagnostics found;
    ChainReader(document, options, found).read_into(rig);
    for (const Diagnostic& entry : found.entries()) diagnostics.add(entry);
    if (found.has_errors()) return std::nullopt;
  }
  if (rig.cameras.empty() && rig.imus.empty()) {
    diagnostics.error("no-calibration", "neither a camera (cam0) nor an IMU's noise stands here",
                      {documents.front().source().name, 0, 0});
    return std::nullopt;
  }
  return rig;
}

// ---------------------------------------------------------------------------------------------------------------- writing

const Layout* layout_for(const CameraModel& model) {
  const auto& rows = layouts();
  const auto found = std::ranges::find(rows, model_info(model).id, &Layout::model);
  return found == rows.end() ? nullptr : &*found;
}

std::vector<double> slot_values(const CameraModel& model, std::span<const Slot> slots) {
  std::vector<double> values;
  for (const Slot& slot : slots) {
    values.push_back(slot.parameter.empty() ? slot.constant : parameter(model, slot.parameter).value_or(0.0));
  }
  return values;
}

/// What a camera's block says, in Kalibr's (alphabetic) order.
std::vector<fields::Field> camera_fields(const Rig& rig, std::size_t index) {
  const Camera& camera = rig.cameras[index];
  const Layout& layout = *layout_for(camera.model);
  std::vector<fields::Field> result;
  if (const std::optional<Transform> T = rig.resolve(camera.name, "imu0")) {
    const Transform* stated = rig.stated(camera.name, "imu0");
    result.push_back(fields::rows("T_cam_imu", stated != nullptr ? *stated : *T));
  }
  if (index > 0) {
    const std::string& previous = rig.cameras[index - 1].name;
    const Transform* stated = rig.stated(camera.name, previous);
    const std::optional<Transform> T = rig.resolve(camera.name, previous);
    if (T) result.push_back(fields::rows("T_cn_cnm1", stated != nullptr ? *stated : *T));
  }
  result.push_back(fields::scalar("camera_model", std::string(layout.camera_model)));
  result.push_back(fields::list("distortion_coeffs", slot_values(camera.model, layout.coefficients)));
  result.push_back(fields::scalar("distortion_model", std::string(layout.distortion_model)));
  result.push_back(fields::list("intrinsics", slot_values(camera.model, layout.intrinsics)));
  if (camera.image_size) {
    fields::Field size{"resolution", fields::Shape::kList, {}, 0, {}};
    size.tokens = {std::to_string(camera.image_size->width), std::to_string(camera.image_size->height)};
    result.push_back(std::move(size));
  }
  // Kalibr asks for the topic as soon as it opens a bag; a plain path needs no quotes, anything else gets them.
  const bool plain = !camera.topic.empty() && std::ranges::all_of(camera.topic, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '/' || c == '_';
  });
  if (!camera.topic.empty())
    result.push_back(fields::scalar("rostopic", plain && camera.topic[0] == '/' ? camera.topic : fields::quote(camera.topic)));
  if (camera.time_offset_s) result.push_back(fields::real("timeshift_cam_imu", *camera.time_offset_s));
  return result;
}

std::vector<fields::Field> imu_fields(const Imu& imu) {
  std::vector<fields::Field> result;
  const auto add = [&result](std::string_view key, const std::optional<double>& value) {
    if (value) result.push_back(fields::real(std::string(key), *value));
  };
  add("accelerometer_noise_density", imu.accelerometer_noise_density);
  add("accelerometer_random_walk", imu.accelerometer_random_walk);
  add("gyroscope_noise_density", imu.gyroscope_noise_density);
  add("gyroscope_random_walk", imu.gyroscope_random_walk);
  if (!imu.topic.empty()) result.push_back(fields::quoted("rostopic", imu.topic));
  add("update_rate", imu.rate_hz);
  return result;
}

/// A fresh camchain in Kalibr's own layout, but with the rows of transforms indented deeper than their key: OpenVINS then needs
/// only its first line added.
std::optional<text::Document> compose(const Rig& rig, Diagnostics& diagnostics) {
  std::string bytes;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    bytes += indexed("cam", i) + ":\n";
    for (const fields::Field& field : camera_fields(rig, i)) bytes += fields::spell(field, 2) + "\n";
  }
  return text::parse_document({"camchain.yaml", bytes}, diagnostics);
}

/// Chains are named cam0, cam1, ... in order: renames the rig's cameras so.
Rig renamed(const Rig& rig) {
  Rig result = rig;
  const auto new_name = [&rig](const std::string& name) {
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
      if (rig.cameras[i].name == name) return indexed("cam", i);
    }
    return name;
  };
  for (Camera& camera : result.cameras) camera.name = new_name(camera.name);
  for (PoseEdge& edge : result.poses) {
    edge.a = new_name(edge.a);
    edge.b = new_name(edge.b);
  }
  return result;
}

/// `edits`: the file is an edited input, so what a Rig has no place for is still there.
void list_losses(const Rig& rig, bool edits, Written& written) {
  for (const std::string& what : rig.as_read) {
    if (!edits) written.losses.push_back({"not-carried", what, "a camchain has no place for it", ""});
  }
  for (const Camera& camera : rig.cameras) {
    if (camera.frame_rate_hz) {
      written.losses.push_back({"frame-rate-dropped", camera.name + " " + text::format_short(*camera.frame_rate_hz) + " Hz",
                                "a camchain has no key for it", ""});
    }
  }
  if (rig.baseline_m) {
    written.losses.push_back({"baseline-dropped",
                              "baseline " + text::format_short(*rig.baseline_m) + " m of a rectified pair or depth sensor",
                              "a camchain states poses of cameras, and the second camera is not in the input", ""});
  }
}

/// Can a camchain hold the models? One that is already there (in `old`) is not asked again.
bool check_models(const Rig& rig, const Rig* old, Diagnostics& diagnostics) {
  bool good = true;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const Camera& camera = rig.cameras[i];
    if (old != nullptr && old->cameras[i].model == camera.model) continue;
    if (layout_for(camera.model) != nullptr) {
      good = stored_within(kFormat, camera, diagnostics) && good;
      continue;
    }
    diagnostics.error("model-not-storable",
                      camera.name + ": Kalibr has no " + std::string(model_info(camera.model).id) + " model");
    good = false;
  }
  return good;
}

bool check_sizes(const Rig& rig, Diagnostics& diagnostics) {
  bool good = true;
  for (const Camera& camera : rig.cameras) {
    if (camera.image_size) continue;
    diagnostics.error("image-size-missing", camera.name + ": Kalibr demands a resolution and the input has none", {},
                      "give it: --size WIDTHxHEIGHT");
    good = false;
  }
  return good;
}

/// `base` with what differs between the two rigs changed.
text::Document edited(const text::Document& base, const Rig& old, const Rig& rig) {
  text::Document document = base;
  const text::Dialect dialect = dialect_of(base);
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const Node* node = text::find(document.root(), old.cameras[i].name, dialect);
    if (node != nullptr) fields::apply(document, *node, dialect, camera_fields(old, i), camera_fields(rig, i));
  }
  return document;
}

std::optional<Written> write(const text::Document* base, const Rig& rig_as_named, const WriteOptions& /*options*/,
                             Diagnostics& diagnostics) {
  const Rig rig = renamed(rig_as_named);
  Diagnostics ignored;
  std::optional<Rig> old;
  if (base != nullptr) old = read(std::span(base, 1), {}, ignored);
  if (base != nullptr && rig.cameras.empty()) {  // an imu.yaml: there is nothing in it that a conversion changes
    Written unchanged;
    unchanged.files.push_back({*base, {}});
    unchanged.headline = "an imu.yaml for Kalibr";
    unchanged.programs = {"kalibr-imu"};
    return unchanged;
  }
  if (rig.cameras.empty()) {
    diagnostics.error("no-camera", "a camchain needs a camera and the input has none");
    return std::nullopt;
  }
  const bool edits = old && std::ranges::equal(old->cameras, rig_as_named.cameras, {}, &Camera::name, &Camera::name);
  // A base that never stated a size need not begin to.
  if (!check_models(rig, edits ? &*old : nullptr, diagnostics) || (!edits && !check_sizes(rig, diagnostics)))
    return std::nullopt;
  std::optional<text::Document> document = edits ? edited(*base, *old, rig) : compose(rig, diagnostics);
  if (!document) return std::nullopt;

  Written written;
  Written::File file{*std::move(document), {}};
  for (const Camera& camera : rig.cameras) file.cameras.push_back(camera.name);
  written.files.push_back(std::move(file));
  if (!edits) {
    for (const Imu& imu : rig.imus) {
      std::string bytes;
      for (const fields::Field& field : imu_fields(imu)) bytes += fields::spell(field) + "\n";
      std::optional<text::Document> imu_document =
          bytes.empty() ? std::nullopt : text::parse_document({"imu.yaml", bytes}, diagnostics);
      if (imu_document) written.files.push_back({*std::move(imu_document), {}});
    }
  }
  list_losses(rig, edits, written);
  written.headline = "a camchain for Kalibr";
  written.programs = {"kalibr"};
  return written;
}

}  // namespace

const Format kFormat = {
    .id = "kalibr",
    .title = "Kalibr camchain",
    .syntaxes = "YAML",
    .program = "Kalibr",
    .many_cameras = true,
    .extrinsics = true,
    .imu = true,
    .image_size = true,
    .models = kModels,
    .probe = probe,
    .read = read,
    .write = write,
};

}  // namespace fca::kalibr
