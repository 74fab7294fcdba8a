// SPDX-License-Identifier: BSD-3-Clause
#include "rig_config.h"

#include "../fields.h"
#include "lines.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace fca::colmap {

using fields::Field;
using text::Node;

namespace {

constexpr std::string_view kCameras = "cameras";
constexpr std::string_view kPrefix = "image_prefix";
constexpr std::string_view kReference = "ref_sensor";
constexpr std::string_view kRotation = "cam_from_rig_rotation";
constexpr std::string_view kTranslation = "cam_from_rig_translation";
constexpr std::string_view kModelName = "camera_model_name";
constexpr std::string_view kParameters = "camera_params";
/// boost::property_tree finds the first of equal keys.
constexpr text::Dialect kDialect = text::Dialect::kOpenCv;

const Node* find(const Node& mapping, std::string_view key) { return text::find(mapping, key, kDialect); }

bool is_true(const Node* node) { return node != nullptr && (node->value == "true" || node->value == "1"); }

/// The list of a rig's cameras; null if it is none of objects.
const Node* cameras_of(const Node& rig) {
  const Node* cameras = rig.is_mapping() ? find(rig, kCameras) : nullptr;
  const bool is_list = cameras != nullptr && cameras->is_sequence() && !cameras->items.empty() &&
                       std::ranges::all_of(cameras->items, &Node::is_mapping);
  return is_list ? cameras : nullptr;
}

/// "rig/cam0" of "rig/cam0/"
std::string_view folder_of(std::string_view prefix) {
  while (prefix.ends_with('/')) prefix.remove_suffix(1);
  return prefix;
}
/// "cam0" of "rig/cam0/"
std::string last_folder(std::string_view prefix) {
  const std::string_view folder = folder_of(prefix);
  return std::string(folder.substr(folder.rfind('/') + 1));  // npos + 1 is 0
}

/// What cameras are called whose images are in these folders.
std::vector<std::string> names_by(const std::vector<std::string>& prefixes) {
  std::vector<std::string> names;
  names.reserve(prefixes.size());
  for (const std::string& prefix : prefixes) names.push_back(last_folder(prefix));
  const std::vector<std::string> last = names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::ranges::count(last, last[i]) > 1) names[i] = folder_of(prefixes[i]);
  }
  return names;
}

/// A rig of a file that can be read.
struct StatedRig {
  const std::vector<Node>& cameras;
  std::vector<std::string> names;
  std::string reference;
};

std::vector<StatedRig> stated_rigs(const Node& root) {
  std::vector<std::string> prefixes;
  for (const Node& rig : root.items) {
    for (const Node& camera : cameras_of(rig)->items) prefixes.push_back(find(camera, kPrefix)->value);
  }
  const std::vector<std::string> names = names_by(prefixes);
  std::vector<StatedRig> rigs;
  auto name = names.begin();
  for (const Node& rig : root.items) {
    rigs.push_back({cameras_of(rig)->items, {}, {}});
    for (const Node& camera : rigs.back().cameras) {
      rigs.back().names.push_back(*name++);
      if (is_true(find(camera, kReference))) rigs.back().reference = rigs.back().names.back();
    }
  }
  return rigs;
}

/// w x y z
std::array<double, 4> as_stated(const Quaternion& q) { return {q[3], q[0], q[1], q[2]}; }
Quaternion from_stated(const std::vector<double>& q) { return {q[1], q[2], q[3], q[0]}; }

/// The rotation that stands there; the identity where none does.
Quaternion stated_rotation(const Node& camera) {
  Quaternion q = {0.0, 0.0, 0.0, 1.0};
  const Node* node = find(camera, kRotation);
  if (node == nullptr || node->items.size() != q.size()) return q;
  std::vector<double> numbers;
  for (const Node& item : node->items) numbers.push_back(text::parse_real(item.value).value_or(0.0));
  return from_stated(numbers);
}

class RigConfigReader {
 public:
  RigConfigReader(const text::Document& document, const ReadOptions& options, Diagnostics& diagnostics)
      : reader_(document, kDialect, diagnostics), options_(options) {}

  std::optional<Rig> run() {
    const Node& root = reader_.document().root();
    const auto is_rig = [](const Node& rig) { return cameras_of(rig) != nullptr; };
    if (!root.is_sequence() || root.items.empty() || !std::ranges::all_of(root.items, is_rig)) {
      reader_.say(root, Code::kColmapNoRig);
      return std::nullopt;
    }
    std::vector<std::string> folders;
    for (const Node& rig : root.items) {
      if (is_of_bundle_adjuster(rig) || !check_cameras(cameras_of(rig)->items, folders)) return std::nullopt;
    }
    bool good = true;
    for (const StatedRig& rig : stated_rigs(root)) {
      for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
        const std::string& name = rig.names[i];
        const std::string& prefix = find(rig.cameras[i], kPrefix)->value;
        if (prefix != name + "/") rig_.extra_fields.push_back({name, std::string(kPrefix), prefix});
        good = read_pose(rig.cameras[i], name, rig.reference) && good;
        good = read_lens_of(rig.cameras[i], name) && good;
      }
    }
    reader_.warn_of_misspelt();
    return good ? std::optional(std::move(rig_)) : std::nullopt;
  }

 private:
  /// Is it a rig of the program's before 3.12? Then with an error.
  bool is_of_bundle_adjuster(const Node& rig) {
    constexpr std::string_view kReferenceId = "ref_camera_id";
    const text::Entry* entry = text::find_entry(rig, kReferenceId, kDialect);
    if (entry != nullptr) reader_.say(entry->key, Code::kColmapOldRigs, {kReferenceId});
    return entry != nullptr;
  }

  /// Those of one rig; false, with errors, where COLMAP would stop. `folders`: of all that stand above.
  bool check_cameras(const std::vector<Node>& cameras, std::vector<std::string>& folders) {
    std::vector<const Node*> references;
    for (const Node& camera : cameras) {
      const Node* prefix = reader_.require(camera, kPrefix, "a camera");
      if (prefix == nullptr) return false;
      const std::string folder(folder_of(reader_.name(*prefix, kPrefix)));
      if (last_folder(folder).empty() || std::ranges::find(folders, folder) != folders.end()) {
        reader_.say(*prefix, folder.empty() ? Code::kColmapNoFolder : Code::kColmapPrefixTwice, {prefix->value.substr(0, 40)});
        return false;
      }
      folders.push_back(folder);
      if (is_true(reader_.find(camera, kReference))) references.push_back(&camera);
    }
    if (references.size() == 1) return true;
    reader_.say(references.empty() ? cameras.front() : *references.back(), Code::kColmapReferenceCount, {references.size()});
    return false;
  }

  /// Warns of one key of two that count together. Are both there?
  bool both(const Node& camera, std::string_view first, std::string_view second) {
    const Node* a = reader_.find(camera, first);
    const Node* b = reader_.find(camera, second);
    if (a != nullptr && b != nullptr) return true;
    if (a != nullptr) reader_.say(*a, Code::kColmapHalf, {first, second});
    if (b != nullptr) reader_.say(*b, Code::kColmapHalf, {second, first});
    return false;
  }

  bool read_pose(const Node& camera, const std::string& name, const std::string& reference) {
    if (!both(camera, kRotation, kTranslation)) return true;
    const Node& rotation = *find(camera, kRotation);
    const Node& translation = *find(camera, kTranslation);
    if (name == reference) {
      reader_.say(rotation, Code::kColmapReferencePose, {name});
      return false;
    }
    const std::string what = name + " " + std::string(kRotation);
    const std::optional<std::vector<double>> q = reader_.reals(rotation, 4, what);
    const std::optional<std::vector<double>> t = reader_.reals(translation, 3, name + " " + std::string(kTranslation));
    if (!q || !t) return false;
    const std::optional<Transform> checked = colmap::read_pose(*q, *t, {rotation, what}, {translation, name}, reader_);
    if (checked) rig_.poses.push_back({name, reference, *checked});
    return checked.has_value();
  }

  bool read_lens_of(const Node& node, const std::string& name) {
    if (!both(node, kModelName, kParameters)) return true;
    const Node& parameters = *find(node, kParameters);
    const Model* model = read_model(*find(node, kModelName), reader_);
    if (model == nullptr) return false;
    if (parameters.items.size() != model->parameters()) {
      reader_.say(parameters, Code::kColmapParameterCount,
                  {model->name, model->parameters(), parameters.items.size(), parameter_names(*model)});
      return false;
    }
    Camera camera;
    camera.name = name;
    camera.image_size = options_.image_size;
    if (!read_lens(parameters.items, *model, camera, reader_)) return false;
    rig_.cameras.push_back(std::move(camera));
    return true;
  }

  fields::Reader reader_;
  const ReadOptions& options_;
  Rig rig_;
};

/// Of q and -q, which are one rotation, the one that is nearer to `alike`.
std::vector<Field> pose_fields(const Rig& rig, const std::string& camera, const std::string& reference,
                               const Quaternion& alike = {0.0, 0.0, 0.0, 1.0}) {
  const std::optional<Transform> T = camera == reference ? std::nullopt : rig.resolve(camera, reference);
  if (!T) return {};
  return {fields::list(std::string(kRotation), stated_quaternion(*T, alike)),
          fields::list(std::string(kTranslation), translation_of(*T))};
}

/// `name`: of the model, as it stands there or is to stand.
std::vector<Field> lens_fields(const Camera& camera, const Model& model, std::string_view name) {
  return {fields::quoted(std::string(kModelName), name),
          fields::list(std::string(kParameters), parameters_in(model, camera).value())};
}

/// The model that the file names where it holds the lens, else that of a fresh file.
const Model& model_for(const Node& node, const Camera& camera) {
  const Node* name = find(node, kModelName);
  const Model* named = name != nullptr ? find_model(name->value) : nullptr;
  return named != nullptr && parameters_in(*named, camera) ? *named : *written_model(camera.model);
}

/// The keys and values of a camera of a fresh file.
std::string lines_of_camera(const Rig& rig, std::size_t index, const std::string& reference) {
  const Camera& camera = rig.cameras[index];
  // As cameras.txt, which has no names, is read.
  std::vector<Field> fields = {fields::quoted(std::string(kPrefix), "cam" + std::to_string(index) + "/")};
  if (camera.name == reference) fields.push_back(fields::scalar(std::string(kReference), "true"));
  std::ranges::move(pose_fields(rig, camera.name, reference), std::back_inserter(fields));
  std::ranges::move(lens_fields(camera, *written_model(camera.model), written_model(camera.model)->name),
                    std::back_inserter(fields));
  constexpr std::size_t kInObject = 8;
  std::string lines;
  for (const Field& field : fields)
    lines += (lines.empty() ? "" : ",\n") + fields::spell(field, kInObject, text::Syntax::kJson);
  return lines;
}

}  // namespace

std::optional<Transform> read_pose(const std::vector<double>& wxyz, const std::vector<double>& translation,
                                   const fields::Reader::Place& of_rotation, const fields::Reader::Place& of_translation,
                                   fields::Reader& reader) {
  const double length = std::hypot(std::hypot(wxyz[0], wxyz[1]), std::hypot(wxyz[2], wxyz[3]));
  constexpr double kPrinted = 1e-3;
  constexpr double kShortest = 0.5;
  if (length < kShortest) {
    reader.say(of_rotation.node, Code::kColmapNoRotation, {of_rotation.what, length});
    return std::nullopt;
  }
  if (std::abs(length - 1.0) > kPrinted)
    reader.say(of_rotation.node, Code::kColmapQuaternionLength, {of_rotation.what, length});
  const Transform T = pose_of(normalised(from_stated(wxyz)), {translation[0], translation[1], translation[2]});
  return reader.checked(T, of_rotation, of_translation);
}

std::array<double, 4> stated_quaternion(const Transform& T, const Quaternion& alike) {
  return as_stated(signed_as(quaternion_of(T), alike));
}

ProbeResult probe_rig_config(const text::Document& document) {
  const Node& root = document.root();
  const Node* cameras = root.is_sequence() && !root.items.empty() ? cameras_of(root.items.front()) : nullptr;
  const bool named = cameras != nullptr && find(cameras->items.front(), kPrefix) != nullptr;
  return named ? ProbeResult{evidence::kCamera, Message{Code::kColmapRigs}} : ProbeResult{};
}

std::optional<Rig> read_rig_config(const text::Document& document, const ReadOptions& options, Diagnostics& diagnostics) {
  return RigConfigReader(document, options, diagnostics).run();
}

std::optional<std::string> composed_rig_config(const Rig& rig) {
  std::vector<bool> placed(rig.cameras.size());
  std::string rigs;
  for (std::size_t first = 0; first < rig.cameras.size(); ++first) {
    const std::string& reference = rig.cameras[first].name;
    std::vector<std::size_t> members;
    for (std::size_t i = first; i < rig.cameras.size(); ++i) {
      if (!placed[i] && rig.resolve(rig.cameras[i].name, reference)) members.push_back(i);
    }
    if (placed[first]) continue;
    if (members.size() < 2) return std::nullopt;
    std::string objects;
    for (const std::size_t i : members) {
      placed[i] = true;
      objects += (objects.empty() ? "      {\n" : ",\n      {\n") + lines_of_camera(rig, i, reference) + "\n      }";
    }
    rigs += (rigs.empty() ? "  {\n" : ",\n  {\n") + ("    \"cameras\": [\n" + objects) + "\n    ]\n  }";
  }
  return rigs.empty() ? std::nullopt : std::optional("[\n" + rigs + "\n]\n");
}

text::Document edited_rig_config(const text::Document& base, const Rig& old, const Rig& rig) {
  text::Document document = base;
  for (const StatedRig& stated : stated_rigs(base.root())) {
    for (std::size_t i = 0; i < stated.cameras.size(); ++i) {
      const Node& node = stated.cameras[i];
      const std::string& name = stated.names[i];
      const Quaternion alike = stated_rotation(node);
      std::vector<Field> before = pose_fields(old, name, stated.reference, alike);
      std::vector<Field> after = pose_fields(rig, name, stated.reference, alike);
      const Camera* old_camera = old.find_camera(name);
      const Camera* camera = rig.find_camera(name);
      if (old_camera != nullptr && camera != nullptr) {
        const Model& model = model_for(node, *camera);
        std::ranges::move(lens_fields(*old_camera, model_for(node, *old_camera), find(node, kModelName)->value),
                          std::back_inserter(before));
        std::ranges::move(lens_fields(*camera, model, model.name), std::back_inserter(after));
      }
      fields::apply(document, node, kDialect, before, after);
    }
  }
  return document;
}

}  // namespace fca::colmap
