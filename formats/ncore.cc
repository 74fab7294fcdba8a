// SPDX-License-Identifier: BSD-3-Clause
// NVIDIA NCore's cameras as JSON (NVIDIA/ncore@77144a9 of 2026-05-06: data/types.py, sensors/camera.py; gsplat's files of the
// same kind). Read only.
//
//   <the camera's id>
//     camera_model_type   ftheta, opencv-pinhole or opencv-fisheye
//     resolution          [width, height]
//     T_sensor_rig        4 x 4: by the numbers of real files T_vehicle_camera, for all its name
//     intrinsics
//       principal_point   ftheta: the centre of the top-left pixel is (0, 0); elsewhere it is (0.5, 0.5)
//       focal_length, radial_coeffs, tangential_coeffs, thin_prism_coeffs    as OpenCV has them; forward_poly: radial_coeffs
//       angle_to_pixeldist_poly, pixeldist_to_angle_poly    c0 + c1 x + ...: rad, px
//       reference_poly    which of the two counts, 1 the second and 2 the first; the other is near its inverse
//       linear_cde        pixel - principal point = [c d; e 1] r (cos, sin); all 0: [1, 0, 0]
//       max_angle_rad     where the program ends the lens, here its formula does
//     external_distortion   of a windshield, before the lens: not read, with a warning
//
// By the first polynomial a lens is `ftheta`; by the second, or with a c0, it is no model here and read as a table of rays.
#include "ncore.h"

#include "fields.h"
#include "opencv/lens.h"

#include <fca/code.h>
#include <fca/convert/ray_table.h>
#include <fca/formats/opencv_coefficients.h>
#include <fca/rig/limits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fca::ncore {

using text::Node;

namespace {

constexpr text::Dialect kDialect = text::Dialect::kPyYaml;
constexpr std::string_view kVehicle = "vehicle";
constexpr std::string_view kToDistance = "angle_to_pixeldist_poly";
constexpr std::string_view kToAngle = "pixeldist_to_angle_poly";

using Numbers = std::vector<double>;

/// c0 + c1 x + c2 x^2 + ...
double value_at(const Numbers& polynomial, double x) {
  double value = 0.0;
  for (std::size_t i = polynomial.size(); i-- > 0;) value = value * x + polynomial[i];
  return value;
}

/// The x of [0, largest] at which the polynomial has that value; nothing where it is not reached. It grows there.
std::optional<double> inverse_at(const Numbers& polynomial, double value, double largest) {
  constexpr int kHalvings = 60;
  if (value_at(polynomial, 0.0) > value || value_at(polynomial, largest) < value) return std::nullopt;
  double low = 0.0;
  double high = largest;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (value_at(polynomial, middle) < value ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// From 0 to where the polynomial stops growing, but no further than that.
double grows_until(const Numbers& polynomial, double largest) {
  constexpr int kSteps = 4096;
  for (int i = 1; i <= kSteps; ++i) {
    if (!(value_at(polynomial, largest * i / kSteps) > value_at(polynomial, largest * (i - 1) / kSteps)))
      return largest * (i - 1) / kSteps;
  }
  return largest;
}

Numbers derivative_of(const Numbers& polynomial) {
  Numbers derivative;
  for (std::size_t i = 1; i < polynomial.size(); ++i) derivative.push_back(static_cast<double>(i) * polynomial[i]);
  return derivative;
}

/// What no value on [0, largest] exceeds in size.
double largest_value(const Numbers& polynomial, double largest) {
  double value = 0.0;
  for (std::size_t i = polynomial.size(); i-- > 0;) value = value * largest + std::abs(polynomial[i]);
  return value;
}

/// From a distance to its angle and back.
struct Disagreement {
  double found_px = 0.0;
  double bound_px = 0.0;   ///< No distance ends further off.
  double angle_rad = 0.0;  ///< As far as was asked.
  double end_px = 0.0;     ///< The distance there.
};

/// For distances up to `largest_px` whose angles are no larger than `max_angle_rad`. The bound: between two samples the
/// difference moves by its derivative there, which changes by no more than its steepest change allows.
Disagreement disagreement(const Numbers& to_distance, const Numbers& to_angle, double largest_px, double max_angle_rad) {
  constexpr int kSteps = 1 << 14;
  const double step = largest_px / kSteps;
  const Numbers distance_derivative = derivative_of(to_distance);
  const Numbers angle_derivative = derivative_of(to_angle);
  Disagreement result;
  double steepest = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double distance = i * step;
    const double angle = value_at(to_angle, distance);
    if (!(std::abs(angle) <= max_angle_rad)) break;
    result.found_px = std::max(result.found_px, std::abs(value_at(to_distance, angle) - distance));
    result.angle_rad = std::max(result.angle_rad, std::abs(angle));
    result.end_px = distance;
    steepest = std::max(steepest, std::abs(value_at(distance_derivative, angle) * value_at(angle_derivative, distance) - 1.0));
  }
  const double derivative = largest_value(angle_derivative, result.end_px);
  const double bend =
      largest_value(derivative_of(distance_derivative), result.angle_rad) * derivative * derivative +
      largest_value(distance_derivative, result.angle_rad) * largest_value(derivative_of(angle_derivative), result.end_px);
  result.bound_px = result.found_px + 0.5 * step * (steepest + 0.5 * step * bend);
  return result;
}

/// An f-theta lens as the file specifies it.
struct Polynomials {
  std::array<double, 2> centre{};
  Numbers to_distance;    ///< px of rad
  Numbers to_angle;       ///< rad of px
  bool by_angle = false;  ///< `to_angle` counts, else `to_distance`.
  std::array<double, 3> cde = {1.0, 0.0, 0.0};
  double max_angle_rad = 0.0;
  double corner_px = 0.0;   ///< The distance of the furthest corner of the image.
  double largest_px = 0.0;  ///< To which distance `to_angle` grows, up to there.

  /// A ray's distance from the centre.
  [[nodiscard]] std::optional<double> distance_of(double angle) const {
    return by_angle ? inverse_at(to_angle, angle, largest_px) : value_at(to_distance, angle);
  }

  [[nodiscard]] std::optional<Pixel> project(const Ray& ray) const {
    const std::optional<double> distance = distance_of(angle_from_axis(ray));
    if (!distance) return std::nullopt;
    const double sine = std::hypot(ray[0], ray[1]);
    const double x = sine > 0.0 ? *distance * ray[0] / sine : 0.0;
    const double y = sine > 0.0 ? *distance * ray[1] / sine : 0.0;
    const auto& [c, d, e] = cde;
    return Pixel{centre[0] + c * x + d * y, centre[1] + e * x + y};
  }
};

/// The camera of one entry while it is read.
class Reading {
 public:
  Reading(fields::Reader& reader, const Node& mapping, Rig& rig) : reader_(reader), mapping_(mapping), rig_(rig) {}

  /// False with errors.
  bool run(const std::string& name) {
    camera_.name = name;
    const Node* type = reader_.require(mapping_, "camera_model_type", name);
    const Node* intrinsics = reader_.require(mapping_, "intrinsics", name);
    if (type == nullptr || intrinsics == nullptr || !read_size()) return false;
    intrinsics_ = intrinsics;
    const std::string model = reader_.name(*type, label("camera_model_type"));
    bool good = false;
    if (model == "ftheta") {
      good = read_ftheta();
    } else if (model == "opencv-pinhole") {
      good = read_pinhole();
    } else if (model == "opencv-fisheye") {
      good = read_fisheye();
    } else {
      reader_.say(*type, Code::kTableUnknownWord,
                  {label("camera_model_type"), model, std::vector<std::string>{"ftheta", "opencv-pinhole", "opencv-fisheye"}});
    }
    if (!good || !read_pose()) return false;
    if (const Node* glass = text::find(mapping_, "external_distortion", kDialect); glass != nullptr && glass->is_mapping())
      reader_.say(*glass, Code::kNcoreGlass, {name});
    reader_.keep_unasked(mapping_, name, rig_.extra_fields);
    if (intrinsics_->is_mapping()) reader_.keep_unasked(*intrinsics_, name, rig_.extra_fields);
    rig_.cameras.push_back(std::move(camera_));
    return true;
  }

 private:
  [[nodiscard]] std::string label(std::string_view key) const { return camera_.name + " " + std::string(key); }

  bool read_size() {
    const Node* size = reader_.require(mapping_, "resolution", camera_.name);
    if (size == nullptr) return false;
    if (!size->is_sequence() || size->items.size() != 2) {
      reader_.say(*size, Code::kTableNoSize, {camera_.name});
      return false;
    }
    camera_.image_size = reader_.image_size(size->items[0], size->items[1], label("resolution "));
    return camera_.image_size.has_value();
  }

  bool read_pose() {
    const Node* pose = reader_.find(mapping_, "T_sensor_rig");
    if (pose == nullptr) return true;
    const std::optional<Transform> T = reader_.transform(*pose, label("T_sensor_rig"));
    if (!T) return false;
    rig_.add_frame(kVehicle, FrameKind::kVehicle);
    rig_.poses.push_back({std::string(kVehicle), camera_.name, *T});
    return true;
  }

  std::optional<Numbers> numbers(std::string_view key, std::size_t count) {
    const Node* node = reader_.require(*intrinsics_, key, label("intrinsics"));
    return node != nullptr ? reader_.reals(*node, count, label(key)) : std::nullopt;
  }

  /// One after the other, those of `ids`.
  bool set_all(std::string_view key, const Numbers& values, std::span<const ParameterId> ids) {
    const Node& list = *reader_.find(*intrinsics_, key);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (!reader_.parameter(list.items[i], label(key), ids[i], values[i], camera_.model)) return false;
    }
    return true;
  }

  bool read_focal_and_centre() {
    constexpr std::array<ParameterId, 2> kFocal = {"fx", "fy"};
    constexpr std::array<ParameterId, 2> kCentre = {"cx", "cy"};
    const std::optional<Numbers> focal = numbers("focal_length", kFocal.size());
    std::optional<Numbers> centre = numbers("principal_point", kCentre.size());
    if (!focal || !centre) return false;
    for (double& each : *centre) each -= 0.5;
    return set_all("focal_length", *focal, kFocal) && set_all("principal_point", *centre, kCentre);
  }

  bool read_pinhole() {
    constexpr std::array<ParameterId, 6> kRadial = {"k1", "k2", "k3", "k4", "k5", "k6"};
    constexpr std::array<ParameterId, 2> kTangential = {"p1", "p2"};
    constexpr std::array<ParameterId, 4> kPrism = {"s1", "s2", "s3", "s4"};
    camera_.model = make_model("opencv14").value();
    const std::optional<Numbers> radial = numbers("radial_coeffs", kRadial.size());
    const std::optional<Numbers> tangential = numbers("tangential_coeffs", kTangential.size());
    const std::optional<Numbers> prism = numbers("thin_prism_coeffs", kPrism.size());
    if (!radial || !tangential || !prism || !read_focal_and_centre() || !set_all("radial_coeffs", *radial, kRadial) ||
        !set_all("tangential_coeffs", *tangential, kTangential) || !set_all("thin_prism_coeffs", *prism, kPrism))
      return false;
    camera_.model = simplest(camera_.model);
    return true;
  }

  /// The same lens as the smallest model of cv::projectPoints that holds its coefficients.
  static CameraModel simplest(const CameraModel& model) {
    std::vector<double> coefficients;
    coefficients.reserve(kOpenCvCoefficients.size());
    for (const ParameterId id : kOpenCvCoefficients) coefficients.push_back(parameter(model, id).value());
    CameraModel simple = make_model(opencv::model_of_coefficients(coefficients)).value();
    for (const Parameter& row : model_info(simple).parameters)
      set_parameter(simple, ParameterId(row), parameter(model, ParameterId(row)).value());
    return simple;
  }

  bool read_fisheye() {
    camera_.model = make_model("kb4").value();
    const std::string_view key = reader_.find(*intrinsics_, "radial_coeffs") != nullptr ? "radial_coeffs" : "forward_poly";
    const std::optional<Numbers> radial = numbers(key, kFisheyeCoefficients.size());
    return radial && read_focal_and_centre() && set_all(key, *radial, kFisheyeCoefficients);
  }

  bool read_ftheta() {
    Polynomials lens;
    const Node* reference = reader_.require(*intrinsics_, "reference_poly", label("intrinsics"));
    const std::string which = reference != nullptr ? reader_.name(*reference, label("reference_poly")) : "";
    lens.by_angle = which == "1" || which == "PIXELDIST_TO_ANGLE";
    if (reference == nullptr) return false;
    if (!lens.by_angle && which != "2" && which != "ANGLE_TO_PIXELDIST") {
      reader_.say(*reference, Code::kTableUnknownWord, {label("reference_poly"), which, std::vector<std::string>{"1", "2"}});
      return false;
    }
    const std::optional<Numbers> centre = numbers("principal_point", lens.centre.size());
    const std::optional<double> angle = max_angle();
    if (!read_polynomial(kToDistance, !lens.by_angle, lens.to_distance) ||
        !read_polynomial(kToAngle, lens.by_angle, lens.to_angle) || !centre || !angle || !read_linear(lens))
      return false;
    std::ranges::copy(*centre, lens.centre.begin());
    lens.max_angle_rad = std::min(*angle, std::numbers::pi);
    lens.corner_px = corner_distance(lens);
    lens.largest_px = grows_until(lens.to_angle, lens.corner_px);
    const bool is_model = !lens.by_angle && lens.to_distance.front() == 0.0;
    if (!(is_model ? set_ftheta(lens) : set_table(lens))) return false;
    tell_inverse(lens);
    return true;
  }

  /// Of up to six coefficients; where it is not the one that counts, it need not be there.
  bool read_polynomial(std::string_view key, bool counts, Numbers& polynomial) {
    const Node* node = counts ? reader_.require(*intrinsics_, key, label("intrinsics")) : reader_.find(*intrinsics_, key);
    if (node == nullptr) return !counts;
    std::optional<Numbers> coefficients = reader_.reals(*node, 0, label(key));
    if (!coefficients) return false;
    constexpr std::size_t kMost = 6;
    if (coefficients->empty() || coefficients->size() > kMost) {
      reader_.say(*node, Code::kNumbersWanted, {label(key), coefficients->size(), kMost});
      return false;
    }
    polynomial = *std::move(coefficients);
    return true;
  }

  [[nodiscard]] double corner_distance(const Polynomials& lens) const {
    const auto [width, height] = *camera_.image_size;
    const auto& [c, d, e] = lens.cde;
    double furthest = 0.0;
    for (const double u : {-0.5, width - 0.5}) {
      for (const double v : {-0.5, height - 0.5}) {
        const double du = u - lens.centre[0];
        const double dv = v - lens.centre[1];
        furthest = std::max(furthest, std::hypot(du - d * dv, c * dv - e * du) / std::abs(c - d * e));
      }
    }
    return furthest;
  }

  /// How far the two polynomials are from each other's inverse, as far as the program uses them.
  void tell_inverse(const Polynomials& lens) {
    const auto is_absent = [](const Numbers& polynomial) {
      return std::ranges::all_of(polynomial, [](double each) { return each == 0.0; });
    };
    if (is_absent(lens.to_distance) || is_absent(lens.to_angle) || !std::isfinite(lens.corner_px)) return;
    const Disagreement found = disagreement(lens.to_distance, lens.to_angle, lens.largest_px, lens.max_angle_rad);
    const std::string counts(lens.by_angle ? kToAngle : kToDistance);
    const std::string other(lens.by_angle ? kToDistance : kToAngle);
    const Node& node = *reader_.find(*intrinsics_, other);
    const double angle_deg = found.angle_rad * 180.0 / std::numbers::pi;
    const std::string numbers = fields::value_text(node);
    rig_.extra_fields.push_back(
        {camera_.name, other, numbers, {Code::kNcoreInverse, {found.bound_px, counts, angle_deg, numbers}}});
    constexpr double kFar = 1.0;  // px
    constexpr double kMostOfIt = 0.9;
    const std::optional<double> end = lens.distance_of(lens.max_angle_rad);
    const bool ends_early = found.end_px < kMostOfIt * std::min(lens.corner_px, end.value_or(lens.corner_px));
    if (!(found.found_px <= kFar) || ends_early)
      reader_.say(node, Code::kNcoreInverseFarOff, {camera_.name, other, found.found_px, counts, angle_deg});
  }

  bool set_ftheta(const Polynomials& lens) {
    constexpr std::array<ParameterId, 5> kRadial = {"k1", "k2", "k3", "k4", "k5"};
    constexpr std::array<ParameterId, 3> kLinear = {"c", "d", "e"};
    constexpr std::array<ParameterId, 2> kCentre = {"cx", "cy"};
    camera_.model = make_model("ftheta").value();
    const Node& list = *reader_.find(*intrinsics_, kToDistance);
    for (std::size_t i = 1; i < lens.to_distance.size(); ++i) {
      if (!reader_.parameter(list.items[i], label(kToDistance), kRadial.at(i - 1), lens.to_distance[i], camera_.model))
        return false;
    }
    for (std::size_t i = 0; i < kLinear.size(); ++i) set_parameter(camera_.model, kLinear.at(i), lens.cde.at(i));
    return set_all("principal_point", {lens.centre.begin(), lens.centre.end()}, kCentre);
  }

  bool set_table(const Polynomials& lens) {
    const double end = lens.by_angle ? value_at(lens.to_angle, lens.largest_px) : std::numbers::pi;
    std::optional<Camera> table = measured(
        camera_, [&lens](const Ray& ray) { return lens.project(ray); }, std::min(end, std::numbers::pi));
    if (!table) {
      const Node& polynomial = *reader_.find(*intrinsics_, lens.by_angle ? kToAngle : kToDistance);
      reader_.say(polynomial, Code::kLensWithoutTable, {camera_.name, kFewestRays});
      return false;
    }
    camera_ = *std::move(table);
    return true;
  }

  std::optional<double> max_angle() {
    for (const std::string_view key : {"max_angle", "max_angle_rad"}) {
      const Node* node = reader_.find(*intrinsics_, key);
      if (node == nullptr) continue;
      rig_.extra_fields.push_back({camera_.name, std::string(key), fields::value_text(*node)});
      return reader_.positive(*node, label(key));
    }
    reader_.say(*intrinsics_, Code::kKeyMissing, {label("intrinsics"), "max_angle_rad"});
    return std::nullopt;
  }

  bool read_linear(Polynomials& lens) {
    const Node* node = reader_.find(*intrinsics_, "linear_cde");
    if (node == nullptr) return true;
    const std::optional<Numbers> cde = reader_.reals(*node, lens.cde.size(), label("linear_cde"));
    if (!cde) return false;
    constexpr std::array<std::string_view, 3> kNames = {"c", "d", "e"};
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      if (std::abs((*cde)[i]) <= kLargestParameter) continue;
      reader_.say(node->items[i], Code::kNotACamera,
                  {label("linear_cde"), Message{Code::kParameterTooLarge, {kNames.at(i), (*cde)[i]}}});
      return false;
    }
    if (std::ranges::any_of(*cde, [](double each) { return each != 0.0; })) std::ranges::copy(*cde, lens.cde.begin());
    const auto& [c, d, e] = lens.cde;
    if (c - d * e > 0.0) return true;
    reader_.say(*node, Code::kCalibResultsMirrors);
    return false;
  }

  fields::Reader& reader_;
  const Node& mapping_;
  Rig& rig_;
  const Node* intrinsics_ = nullptr;
  Camera camera_;
};

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& /*options*/, Diagnostics& diagnostics) {
  Rig rig;
  for (const text::Document& document : documents) {
    if (!document.root().is_mapping()) {
      diagnostics.add(Code::kTableWrongSyntax, {}, {document.source().name, 0, 0});
      return std::nullopt;
    }
    fields::Reader reader(document, kDialect, diagnostics);
    if (document.root().entries.size() > kMostCameras) {
      diagnostics.add(Code::kTooManyCameras, {document.root().entries.size(), kMostCameras}, {document.source().name, 0, 0});
      return std::nullopt;
    }
    reader.warn_of_duplicates(document.root());
    for (const text::Entry& entry : document.root().entries) {
      if (text::find_entry(document.root(), entry.key.value, reader.dialect()) != &entry) continue;
      const std::string name = rig.unused_name(reader.name(entry.key, entry.key.value));
      if (!entry.value.is_mapping()) {
        reader.say(entry.value, Code::kTableNoObject, {name});
        return std::nullopt;
      }
      if (!Reading(reader, entry.value, rig).run(name)) return std::nullopt;
    }
    reader.warn_of_misspelt();
  }
  return rig;
}

ProbeResult probe(const text::Document& document) {
  const Node& root = document.root();
  if (!root.is_mapping() || root.entries.empty() || !root.entries.front().value.is_mapping()) return {};
  const Node& first = root.entries.front().value;
  for (const std::string_view key : {"camera_model_type", "T_sensor_rig", "shutter_type"}) {
    if (text::find(first, key, kDialect) == nullptr || text::find(first, "intrinsics", kDialect) == nullptr) continue;
    return {evidence::kCamera, {Code::kFoundKeys, {std::vector<std::string>{std::string(key), "intrinsics"}}}};
  }
  return {};
}

constexpr std::array kModels = {
    StoredModel{"ftheta", "ftheta", true, "NCore", {}},           StoredModel{"opencv14", "opencv-pinhole", true, "NCore", {}},
    StoredModel{"rational", "opencv-pinhole", true, "NCore", {}}, StoredModel{"radtan", "opencv-pinhole", true, "NCore", {}},
    StoredModel{"pinhole", "opencv-pinhole", true, "NCore", {}},  StoredModel{"kb4", "opencv-fisheye", true, "NCore", {}},
};
constexpr std::array kOwnFacts = {OwnFact{"shutter, windshield, largest angle, the other polynomial"}};

}  // namespace

const Format kFormat = {
    .id = "ncore",
    .title = "NVIDIA NCore cameras (f-theta)",
    .group = FormatGroup::kDatasets,
    .syntaxes = "JSON",
    .extension = ".json",
    .program = "NCore",
    .imu = false,
    .frame = kVehicle,
    .own_facts = kOwnFacts,
    .models = kModels,
    .probe = probe,
    .read = read,
};

}  // namespace fca::ncore
