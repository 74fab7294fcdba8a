// SPDX-License-Identifier: BSD-3-Clause
// OpenSfM's cameras, as OpenDroneMap has them, too (mapillary/OpenSfM@238744cd of 2026-07-13: io.py camera_from_json,
// geometry's camera_instances.h, camera_distortions_functions.h): camera_models.json, camera_models_overrides.json,
// cameras.json, and the "cameras" of a reconstruction.json. Read only: OpenSfM estimates them itself.
//
//   <the camera's id>
//     projection_type              perspective if it is not there
//     width, height
//     focal, or focal_x focal_y    in units of the longer side
//     c_x, c_y                     the same, from the middle of the image, ((w - 1) / 2, (h - 1) / 2)
//     k1 .. k6, p1 p2, s0 .. s3    0 where they are not there; p1 p2 as OpenCV has them
//
// Tangential distortion and thin prism of fisheye62 and fisheye624 are those of the point before its radial distortion, unlike
// Project Aria's: a lens that has them is read as a table of rays.
#include "opensfm.h"

#include "column.h"
#include "fields.h"

#include <fca/code.h>
#include <fca/convert/ray_table.h>
#include <fca/rig/limits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fca::opensfm {

using text::Node;

namespace {

/// A coefficient's key and our parameter.
struct Coefficient {
  std::string_view key;
  ParameterId id;
};

struct Projection {
  std::string_view name;
  std::string_view model;
  bool one_focal_length;  ///< And the axis in the middle of the image.
  std::span<const Coefficient> coefficients;
  std::size_t beside = 0;  ///< How many of kBeside it has, which its model has not.
};

constexpr std::array kRadial = {Coefficient{"k1", "k1"}, Coefficient{"k2", "k2"}};
constexpr std::array kBrown = {Coefficient{"k1", "k1"}, Coefficient{"k2", "k2"}, Coefficient{"p1", "p1"},
                               Coefficient{"p2", "p2"}, Coefficient{"k3", "k3"}};
constexpr std::array kFisheye = {Coefficient{"k1", "k1"}, Coefficient{"k2", "k2"}, Coefficient{"k3", "k3"},
                                 Coefficient{"k4", "k4"}};
constexpr std::array kSixRadial = {Coefficient{"k1", "k0"}, Coefficient{"k2", "k1"}, Coefficient{"k3", "k2"},
                                   Coefficient{"k4", "k3"}, Coefficient{"k5", "k4"}, Coefficient{"k6", "k5"}};
constexpr std::array<std::string_view, 6> kBeside = {"p1", "p2", "s0", "s1", "s2", "s3"};

constexpr std::array kProjections = {
    Projection{"perspective", "radtan", true, kRadial},
    Projection{"simple_radial", "radtan", false, std::span(kRadial).first(1)},
    Projection{"radial", "radtan", false, kRadial},
    Projection{"brown", "radtan", false, kBrown},
    Projection{"fisheye", "kb4", true, std::span(kFisheye).first(2)},
    Projection{"fisheye_opencv", "kb4", false, kFisheye},
    Projection{"fisheye62", "fisheye624", false, kSixRadial, 2},
    Projection{"fisheye624", "fisheye624", false, kSixRadial, kBeside.size()},
};

/// The camera of one entry while it is read.
class Reading {
 public:
  Reading(fields::Reader& reader, const Node& mapping, Camera& camera) : reader_(reader), mapping_(mapping), camera_(camera) {}

  /// False with errors.
  bool run() {
    const Node* type = reader_.find(mapping_, "projection_type");
    const std::string name = type != nullptr ? reader_.name(*type, label("projection_type")) : "perspective";
    const auto projection = std::ranges::find(kProjections, name, &Projection::name);
    if (projection == kProjections.end()) {
      reader_.say(type != nullptr ? *type : mapping_, Code::kTableUnknownWord,
                  {label("projection_type"), name, column(kProjections, &Projection::name)});
      return false;
    }
    return read_size() && read_pinhole(*projection) && read_coefficients(*projection);
  }

 private:
  [[nodiscard]] std::string label(std::string_view key) const { return camera_.name + " " + std::string(key); }

  bool read_size() {
    const Node* width = reader_.require(mapping_, "width", camera_.name);
    const Node* height = reader_.require(mapping_, "height", camera_.name);
    if (width == nullptr || height == nullptr) return false;
    camera_.image_size = reader_.image_size(*width, *height, label(""));
    return camera_.image_size.has_value();
  }

  /// A number; `otherwise` where the key is not there.
  std::optional<double> number(std::string_view key, std::optional<double> otherwise) {
    const Node* node = otherwise ? reader_.find(mapping_, key) : reader_.require(mapping_, key, camera_.name);
    return node != nullptr ? reader_.real(*node, label(key)) : otherwise;
  }

  bool read_pinhole(const Projection& projection) {
    const auto [width, height] = *camera_.image_size;
    const double side = std::max(width, height);
    const std::array<std::string_view, 2> keys = {projection.one_focal_length ? "focal" : "focal_x",
                                                  projection.one_focal_length ? "focal" : "focal_y"};
    const std::array<ParameterId, 2> focal = {"fx", "fy"};
    const std::array<ParameterId, 2> centre = {"cx", "cy"};
    const std::array<std::string_view, 2> offsets = {"c_x", "c_y"};
    const std::array<double, 2> middle = {(width - 1) / 2.0, (height - 1) / 2.0};
    camera_.model = make_model(projection.model).value();
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::optional<double> length = number(keys.at(axis), {});
      const std::optional<double> offset = projection.one_focal_length ? 0.0 : number(offsets.at(axis), 0.0);
      if (!length || !offset) return false;
      const Node& node = *reader_.find(mapping_, keys.at(axis));
      if (!reader_.parameter(node, label(keys.at(axis)), focal.at(axis), *length * side, camera_.model)) return false;
      const Node* centre_node = reader_.find(mapping_, offsets.at(axis));
      if (!reader_.parameter(centre_node != nullptr ? *centre_node : node, label(offsets.at(axis)), centre.at(axis),
                             *offset * side + middle.at(axis), camera_.model))
        return false;
    }
    return true;
  }

  bool read_coefficients(const Projection& projection) {
    for (const auto& [key, id] : projection.coefficients) {
      const Node* node = reader_.find(mapping_, key);
      if (node != nullptr && !reader_.parameter(*node, label(key), id, camera_.model)) return false;
    }
    std::array<double, kBeside.size()> beside{};
    for (std::size_t i = 0; i < projection.beside; ++i) {
      const Node* node = reader_.find(mapping_, kBeside.at(i));
      const std::optional<double> value = number(kBeside.at(i), 0.0);
      if (!value) return false;
      if (std::abs(*value) > kLargestParameter) {
        reader_.say(*node, Code::kNotACamera,
                    {label(kBeside.at(i)), Message{Code::kParameterTooLarge, {kBeside.at(i), *value}}});
        return false;
      }
      beside.at(i) = *value;
    }
    return std::ranges::all_of(beside, [](double value) { return value == 0.0; }) || make_table(beside);
  }

  /// Of fisheye62 and fisheye624 with what stands next to the radial distortion.
  bool make_table(const std::array<double, kBeside.size()>& beside) {
    const CameraModel radial = camera_.model;
    const auto project = [radial, beside](const Ray& ray) -> std::optional<Pixel> {
      const std::optional<Pixel> pixel = fca::project(radial, ray);
      if (!pixel) return std::nullopt;
      const double theta = angle_from_axis(ray);
      const double sine = std::hypot(ray[0], ray[1]);
      const double x = sine > 0.0 ? theta * ray[0] / sine : 0.0;
      const double y = sine > 0.0 ? theta * ray[1] / sine : 0.0;
      const double q = x * x + y * y;
      const auto& [p1, p2, s0, s1, s2, s3] = beside;
      const double along_u = 2.0 * p1 * x * y + p2 * (q + 2.0 * x * x) + s0 * q + s1 * q * q;
      const double along_v = 2.0 * p2 * x * y + p1 * (q + 2.0 * y * y) + s2 * q + s3 * q * q;
      return Pixel{(*pixel)[0] + parameter(radial, "fx").value() * along_u,
                   (*pixel)[1] + parameter(radial, "fy").value() * along_v};
    };
    std::optional<Camera> table = measured(camera_, project, max_angle(radial));
    if (!table) {
      reader_.say(mapping_, Code::kLensWithoutTable, {camera_.name, kFewestRays});
      return false;
    }
    camera_ = *std::move(table);
    return true;
  }

  fields::Reader& reader_;
  const Node& mapping_;
  Camera& camera_;
};

/// The mapping of all cameras; null where the document has none.
const Node* cameras_of(const text::Document& document) {
  const Node& root = document.root();
  const Node& first = root.is_sequence() && !root.items.empty() ? root.items.front() : root;
  if (const Node* cameras = text::find(first, "cameras", text::Dialect::kPyYaml))
    return cameras->is_mapping() ? cameras : nullptr;
  return first.is_mapping() ? &first : nullptr;
}

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& /*options*/, Diagnostics& diagnostics) {
  Rig rig;
  for (const text::Document& document : documents) {
    const Node* cameras = cameras_of(document);
    if (cameras == nullptr) {
      diagnostics.add(Code::kTableWrongSyntax, {}, {document.source().name, 0, 0});
      return std::nullopt;
    }
    fields::Reader reader(document, text::Dialect::kPyYaml, diagnostics);
    if (cameras->entries.size() > kMostCameras) {
      diagnostics.add(Code::kTooManyCameras, {cameras->entries.size(), kMostCameras}, {document.source().name, 0, 0});
      return std::nullopt;
    }
    reader.warn_of_duplicates(*cameras);
    for (const text::Entry& entry : cameras->entries) {
      if (text::find_entry(*cameras, entry.key.value, reader.dialect()) != &entry) continue;
      Camera camera;
      camera.name = rig.unused_name(reader.name(entry.key, entry.key.value));
      if (!entry.value.is_mapping()) {
        reader.say(entry.value, Code::kTableNoObject, {camera.name});
        return std::nullopt;
      }
      if (!Reading(reader, entry.value, camera).run()) return std::nullopt;
      reader.keep_unasked(entry.value, camera.name, rig.extra_fields);
      rig.cameras.push_back(std::move(camera));
    }
    reader.warn_of_misspelt();
  }
  return rig;
}

ProbeResult probe(const text::Document& document) {
  const Node* cameras = document.syntax() == text::Syntax::kJson ? cameras_of(document) : nullptr;
  if (cameras == nullptr || cameras->entries.empty() || !cameras->entries.front().value.is_mapping()) return {};
  const Node& first = cameras->entries.front().value;
  const auto has = [&first](std::string_view key) { return text::find(first, key, text::Dialect::kPyYaml) != nullptr; };
  for (const char* side : {"width", "height"}) {
    if (has("projection_type") && has(side))
      return {evidence::kCamera, {Code::kFoundKeys, {std::vector<std::string>{"projection_type", side}}}};
  }
  return {};
}

constexpr std::array kModels = {
    StoredModel{"radtan", "perspective, simple_radial, radial, brown", true, "OpenSfM", {}},
    StoredModel{"kb4", "fisheye, fisheye_opencv", true, "OpenSfM", {}},
    StoredModel{"fisheye624", "fisheye62, fisheye624 without tangential", true, "OpenSfM", {}},
};
constexpr std::array kOwnFacts = {OwnFact{"other keys of a camera"}};

}  // namespace

const Format kFormat = {
    .id = "opensfm",
    .title = "OpenSfM cameras",
    .group = FormatGroup::kReconstruction,
    .syntaxes = "JSON",
    .extension = ".json",
    .program = "OpenSfM",
    .main_file = "camera_models.json",
    .extrinsics = false,
    .imu = false,
    .own_facts = kOwnFacts,
    .models = kModels,
    .probe = probe,
    .read = read,
};

}  // namespace fca::opensfm
