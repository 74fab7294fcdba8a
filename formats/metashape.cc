// SPDX-License-Identifier: BSD-3-Clause
// Metashape's and PhotoScan's lenses as XML (Agisoft's manual, appendix on camera models). Read only: fca-io knows no program
// that would read the same from others.
//
//   <calibration>                 an exported lens; or, in a project or <document> of cameras, one for each <sensor>, of which
//                                 class="adjusted" counts before "initial"
//     projection (or type="")     frame, fisheye (equidistant_fisheye), equisolid_fisheye
//     width, height (or <resolution width height>)
//     f, b1, b2, cx, cy [px]      u = w/2 + cx + x (f + b1) + y b2,  v = h/2 + cy + y f, the image's corner being (0, 0)
//     k1 .. k4                    x (1 + k1 r^2 + ... + k4 r^8); (x, y) = (X, Y)/Z, or as long as the angle
//     p1 .. p4                    x gets (p1 (r^2 + 2 x^2) + 2 p2 x y)(1 + p3 r^2 + p4 r^4): OpenCV's p2 and p1
//
// A key that is not there is 0. What no model here holds (k4 or p3 of a frame lens, p1 of a fisheye) makes it a table of rays.
#include "metashape.h"

#include "column.h"
#include "fields.h"
#include "text/xml.h"

#include <fca/code.h>
#include <fca/convert/ray_table.h>
#include <fca/rig/limits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fca::metashape {

using text::Node;

namespace {

constexpr text::Dialect kDialect = text::Dialect::kOpenCv;

enum class Kind { kFrame, kEquidistant, kEquisolid };
struct Projection {
  std::string_view name;
  Kind kind;
};
constexpr std::array kProjections = {Projection{"frame", Kind::kFrame}, Projection{"fisheye", Kind::kEquidistant},
                                     Projection{"equidistant_fisheye", Kind::kEquidistant},
                                     Projection{"equisolid_fisheye", Kind::kEquisolid}};

/// A lens by the numbers of the file.
struct Lens {
  Kind kind = Kind::kFrame;
  ImageSize size;
  double f = 0.0, b1 = 0.0, b2 = 0.0, cx = 0.0, cy = 0.0;
  std::array<double, 4> k{};
  std::array<double, 4> p{};

  /// The pixel of the axis; the centre of the top-left pixel is (0, 0).
  [[nodiscard]] Pixel centre() const { return {size.width / 2.0 + cx - 0.5, size.height / 2.0 + cy - 0.5}; }

  [[nodiscard]] std::optional<Pixel> project(const Ray& ray) const {
    const double angle = angle_from_axis(ray);
    if (kind == Kind::kFrame && !(ray[2] > 0.0)) return std::nullopt;
    const double radius = kind == Kind::kFrame         ? std::tan(angle)
                          : kind == Kind::kEquidistant ? angle
                                                       : 2.0 * std::sin(angle / 2.0);
    const double sine = std::hypot(ray[0], ray[1]);
    const double x = sine > 0.0 ? radius * ray[0] / sine : 0.0;
    const double y = sine > 0.0 ? radius * ray[1] / sine : 0.0;
    const double r2 = x * x + y * y;
    const double radial = 1.0 + r2 * (k[0] + r2 * (k[1] + r2 * (k[2] + r2 * k[3])));
    const double growth = 1.0 + r2 * (p[2] + r2 * p[3]);
    const double bent_x = x * radial + (p[0] * (r2 + 2.0 * x * x) + 2.0 * p[1] * x * y) * growth;
    const double bent_y = y * radial + (p[1] * (r2 + 2.0 * y * y) + 2.0 * p[0] * x * y) * growth;
    const Pixel at = centre();
    return Pixel{at[0] + bent_x * (f + b1) + bent_y * b2, at[1] + bent_y * f};
  }

  /// The same as a model of the list; nothing where there is none.
  [[nodiscard]] std::optional<CameraModel> model() const {
    const auto [u, v] = centre();
    const bool has_tangential = p[0] != 0.0 || p[1] != 0.0;
    const bool has_growth = p[2] != 0.0 || p[3] != 0.0;
    std::optional<CameraModel> straight;
    if (kind == Kind::kFrame && k[3] == 0.0 && !has_growth)
      straight = Intrinsics<Radtan>{{f + b1, f, u, v, k[0], k[1], p[1], p[0], k[2]}};
    if (kind == Kind::kEquidistant && !has_tangential && !has_growth)
      straight = Intrinsics<Kb4>{{f + b1, f, u, v, k[0], k[1], k[2], k[3]}};
    return straight && b2 != 0.0 ? with_skew(*straight, b2) : straight;
  }
};

/// A lens of the file while it is read.
class Reading {
 public:
  Reading(fields::Reader& reader, const Node& calibration, std::vector<ExtraField>& kept)
      : reader_(reader), calibration_(calibration), kept_(kept) {}

  /// Nothing, with errors, where it is none. `sensor`: that holds it; may be null.
  std::optional<Camera> run(std::string name, const Node* sensor) {
    camera_.name = std::move(name);
    if (!read_kind() || !read_size(sensor) || !read_numbers()) return std::nullopt;
    (void)reader_.find(calibration_, text::attribute("class"));  // By which it was chosen.
    reader_.keep_unasked(calibration_, camera_.name, kept_);
    if (const std::optional<CameraModel> model = lens_.model()) {
      const std::vector<Message> problems = validate(*model);
      for (const Message& problem : problems) reader_.say(calibration_, Code::kNotACamera, {camera_.name, problem});
      camera_.model = *model;
      return problems.empty() ? std::optional(camera_) : std::nullopt;
    }
    const Lens lens = lens_;
    std::optional<Camera> table = measured(
        camera_, [lens](const Ray& ray) { return lens.project(ray); }, std::numbers::pi);
    if (!table) reader_.say(calibration_, Code::kLensWithoutTable, {camera_.name, kFewestRays});
    return table;
  }

 private:
  [[nodiscard]] std::string label(std::string_view key) const { return camera_.name + " " + std::string(key); }

  bool read_kind() {
    const Node* node = reader_.find(calibration_, "projection");
    if (node == nullptr) node = reader_.find(calibration_, text::attribute("type"));
    const std::string name = node != nullptr ? reader_.name(*node, label("projection")) : "frame";
    const auto found = std::ranges::find(kProjections, name, &Projection::name);
    if (found != kProjections.end()) {
      lens_.kind = found->kind;
      return true;
    }
    reader_.say(node != nullptr ? *node : calibration_, Code::kTableUnknownWord,
                {label("projection"), name, column(kProjections, &Projection::name)});
    return false;
  }

  bool read_size(const Node* sensor) {
    const Node* width = reader_.find(calibration_, "width");
    const Node* height = reader_.find(calibration_, "height");
    for (const Node* owner : {&calibration_, sensor}) {
      const Node* resolution = owner != nullptr && width == nullptr ? reader_.find(*owner, "resolution") : nullptr;
      if (resolution == nullptr) continue;
      width = reader_.find(*resolution, text::attribute("width"));
      height = reader_.find(*resolution, text::attribute("height"));
    }
    if (width == nullptr || height == nullptr) {
      reader_.say(calibration_, Code::kKeyMissing, {camera_.name, width == nullptr ? "width" : "height"});
      return false;
    }
    camera_.image_size = reader_.image_size(*width, *height, label(""));
    if (camera_.image_size) lens_.size = *camera_.image_size;
    return camera_.image_size.has_value();
  }

  bool read_numbers() {
    struct Number {
      std::string_view key;
      double& value;
    };
    const std::array numbers = {Number{"f", lens_.f},     Number{"b1", lens_.b1},   Number{"b2", lens_.b2},
                                Number{"cx", lens_.cx},   Number{"cy", lens_.cy},   Number{"k1", lens_.k[0]},
                                Number{"k2", lens_.k[1]}, Number{"k3", lens_.k[2]}, Number{"k4", lens_.k[3]},
                                Number{"p1", lens_.p[0]}, Number{"p2", lens_.p[1]}, Number{"p3", lens_.p[2]},
                                Number{"p4", lens_.p[3]}};
    for (const Number& each : numbers) {
      const Node* node = reader_.find(calibration_, each.key);
      if (node == nullptr) continue;
      const std::optional<double> value = reader_.real(*node, label(each.key));
      if (!value) return false;
      if (std::abs(*value) > kLargestParameter) {
        reader_.say(*node, Code::kNotACamera, {label(each.key), Message{Code::kParameterTooLarge, {each.key, *value}}});
        return false;
      }
      each.value = *value;
    }
    if (lens_.f > 0.0 && lens_.f + lens_.b1 > 0.0) return true;
    const Node* focal = reader_.require(calibration_, "f", camera_.name);
    if (focal != nullptr) reader_.say(*focal, Code::kValueNotPositive, {label("f"), focal->value, std::vector<Message>()});
    return false;
  }

  fields::Reader& reader_;
  const Node& calibration_;
  std::vector<ExtraField>& kept_;
  Camera camera_;
  Lens lens_;
};

/// Every mapping under that key of a mapping, in order.
std::vector<const Node*> all_under(const Node& mapping, std::string_view key) {
  std::vector<const Node*> found;
  for (const text::Entry& entry : mapping.entries) {
    if (entry.key.value == key && entry.value.is_mapping()) found.push_back(&entry.value);
  }
  return found;
}

/// That of a sensor which counts; null where it has none.
const Node* calibration_of(const Node& sensor) {
  const std::vector<const Node*> all = all_under(sensor, "calibration");
  const auto adjusted = std::ranges::find_if(all, [](const Node* each) {
    const Node* name = text::find(*each, text::attribute("class"), kDialect);
    return name != nullptr && name->value == "adjusted";
  });
  if (adjusted != all.end()) return *adjusted;
  return all.empty() ? nullptr : all.front();
}

/// What people called the sensor, or its number.
std::string name_of(fields::Reader& reader, const Node& sensor, const Rig& rig) {
  const Node* label = reader.find(sensor, text::attribute("label"));
  const Node* id = reader.find(sensor, text::attribute("id"));
  const std::string number = "sensor" + (id != nullptr ? reader.name(*id, "id") : std::to_string(rig.cameras.size()));
  const std::string name = label != nullptr ? reader.name(*label, "label") : "";
  return rig.unused_name(name.empty() || rig.find_camera(name) != nullptr ? number : name);
}

bool read_document(const text::Document& document, Rig& rig, Diagnostics& diagnostics) {
  fields::Reader reader(document, kDialect, diagnostics);
  const Node& root = document.root();
  const auto take = [&](const Node& calibration, std::string name, const Node* sensor) {
    std::optional<Camera> camera = Reading(reader, calibration, rig.extra_fields).run(std::move(name), sensor);
    if (!camera) return false;
    rig.cameras.push_back(*std::move(camera));
    return true;
  };
  if (root.tag == "calibration") return take(root, "cam0", nullptr);
  for (const Node* chunk : all_under(root, "chunk")) {
    for (const Node* sensors : all_under(*chunk, "sensors")) {
      for (const Node* sensor : all_under(*sensors, "sensor")) {
        const Node* calibration = calibration_of(*sensor);
        if (calibration != nullptr && !take(*calibration, name_of(reader, *sensor, rig), sensor)) return false;
      }
    }
  }
  if (rig.cameras.empty()) diagnostics.add(Code::kTableNoCameraList, {"sensors"}, {document.source().name, 0, 0});
  return !rig.cameras.empty();
}

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& /*options*/, Diagnostics& diagnostics) {
  Rig rig;
  for (const text::Document& document : documents) {
    if (!read_document(document, rig, diagnostics)) return std::nullopt;
  }
  return rig;
}

ProbeResult probe(const text::Document& document) {
  if (document.syntax() != text::Syntax::kXml) return {};
  const Node& root = document.root();
  const bool is_lens = root.tag == "calibration" && text::find(root, "f", kDialect) != nullptr;
  const bool is_project = root.tag == "document" && text::find(root, "chunk", kDialect) != nullptr;
  if (!is_lens && !is_project) return {};
  return {evidence::kCamera, {Code::kFoundKeys, {std::vector<std::string>{root.tag, is_lens ? "f" : "chunk"}}}};
}

constexpr std::array kModels = {
    StoredModel{"radtan", "frame", true, "Metashape", {}},
    StoredModel{"kb4", "equidistant fisheye", true, "Metashape", {}},
    StoredModel{"radtan-skew", "frame with b2", true, "Metashape", {}},
    StoredModel{"kb4-skew", "equidistant fisheye with b2", true, "Metashape", {}},
};
constexpr std::array kOwnFacts = {OwnFact{"covariance, date, other keys of a lens"}};

}  // namespace

const Format kFormat = {
    .id = "metashape",
    .title = "Metashape lenses",
    .group = FormatGroup::kReconstruction,
    .syntaxes = "XML",
    .extension = ".xml",
    .program = "Metashape",
    .main_file = "cameras.xml",
    .extrinsics = false,
    .imu = false,
    .own_facts = kOwnFacts,
    .models = kModels,
    .probe = probe,
    .read = read,
};

}  // namespace fca::metashape
