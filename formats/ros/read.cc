// SPDX-License-Identifier: BSD-3-Clause
#include "camera_info.h"
#include "ros.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>
#include <fca/normalised_id.h>

#include <algorithm>
#include <cmath>

namespace fca::ros {

namespace {

/// What a distortion_model says, and how many coefficients it may have.
enum class Family { kOpenCv, kFisheye };

class CameraReader {
 public:
  CameraReader(fields::Reader& reader, const CameraInfo& info, const ReadOptions& options)
      : reader_(reader), info_(info), options_(options) {}

  std::optional<Rig> run(const std::string& unnamed) {
    Rig rig;
    Camera camera;
    camera.name = info_.name.empty() ? unnamed : info_.name;
    const std::optional<CameraModel> lens = read_lens();
    bool good = lens.has_value() && check_camera_matrix(*info_.K);
    if (good) {
      camera.model = *lens;
      good = read_camera_matrix(camera.model);
    }
    good = read_size(camera) && good;
    if (!good) return std::nullopt;
    if (info_.reduction.changes_pixels()) camera.model = with_pixels(camera.model, info_.reduction.map());
    if (!read_place(camera, rig)) return std::nullopt;
    for (const ExtraField& extra : info_.extras) rig.extra_fields.push_back({camera.name, extra.key, extra.value});
    warn_of_zeros(camera);
    rig.cameras.push_back(std::move(camera));
    return rig;
  }

 private:
  bool check_camera_matrix(const Numbers& K) {
    const auto& k = K.values;
    if (k[2] == 0.0 && k[5] == 0.0 && (k[6] != 0.0 || k[7] != 0.0)) {
      reader_.say(*K.nodes[6], Code::kRosMatrixTransposed);
      return false;
    }
    for (const std::size_t place : {3U, 6U, 7U}) {
      if (k[place] == 0.0) continue;
      reader_.say(*K.nodes[place], Code::kRosNotACameraMatrix, {k[place]});
      return false;
    }
    if (k[8] != 1.0) reader_.say(*K.nodes[8], Code::kRosMatrixCorner, {k[8]});
    return true;
  }

  bool read_camera_matrix(CameraModel& model) {
    bool good = true;
    const auto take = [&](std::size_t place, ParameterId id) {
      good = reader_.parameter(*info_.K->nodes[place], kMatrix, id, info_.K->values[place], model) && good;
    };
    take(0, "fx");
    take(4, "fy");
    take(2, "cx");
    take(5, "cy");
    const double skew_px = info_.K->values[1];
    if (skew_px == 0.0) return good;
    model = with_skew(model, 0.0).value();  // of each model that ROS has
    take(1, "skew");
    reader_.say(*info_.K->nodes[1], Code::kRosSkewKept, {skew_px});
    return good;
  }

  std::optional<Family> family() {
    if (info_.counted) return Family::kOpenCv;
    if (info_.model == nullptr) {
      reader_.say(*info_.D->place, Code::kRosModelAssumed);
      return Family::kOpenCv;
    }
    const std::string& name = info_.model->value;
    const std::string_view known = model_of(name);
    if (!known.empty()) return known == "kb4" ? Family::kFisheye : Family::kOpenCv;
    return family_of_others(name);
  }

  /// Names of other programs for the same formulas: the parser loads them, and image_geometry throws at its first call.
  std::optional<Family> family_of_others(const std::string& name) {
    const std::string word = normalised_id(name);
    const ModelInfo* model = find_model(name);
    const std::string_view id = model != nullptr ? model->id : std::string_view();
    const bool fisheye = id == "kb4" || word.find("fisheye") != std::string::npos || word.find("kannala") != std::string::npos;
    constexpr std::size_t kFisheyeCount = 4;
    const bool none = (word.empty() || word == "none" || id == "pinhole") && info_.D->all_zero();
    std::string meant;
    if (fisheye && info_.D->values.size() == kFisheyeCount) meant = "equidistant";
    if (id == "radtan" || none) meant = "plumb_bob";
    if (id == "rational") meant = "rational_polynomial";
    constexpr std::size_t kShown = 40;
    if (meant.empty()) {
      const std::vector<std::string> names = {"plumb_bob", "rational_polynomial", "equidistant"};
      const std::vector<std::string> near = text::nearest(name.substr(0, kShown), names);
      reader_.say(*info_.model, near.empty() ? Code::kRosUnknownModel : Code::kRosModelMisspelt,
                  {name.substr(0, kShown), near});
      return std::nullopt;
    }
    reader_.say(*info_.model, Code::kRosModelOfOthers, {name.substr(0, kShown), meant});
    return meant == "equidistant" ? Family::kFisheye : Family::kOpenCv;
  }

  std::optional<CameraModel> read_lens() {
    const std::optional<Family> family = this->family();
    if (!family) return std::nullopt;
    return *family == Family::kFisheye ? read_fisheye() : read_opencv();
  }

  std::optional<CameraModel> read_fisheye() {
    constexpr std::size_t kCount = 4;
    if (info_.D->values.size() != kCount) {
      reader_.say(*info_.D->place, Code::kRosFisheyeCount, {info_.D->values.size()});
      return std::nullopt;
    }
    return with_coefficients(*make_model("kb4"), kCount);
  }

  std::optional<CameraModel> read_opencv() {
    constexpr std::array<std::size_t, 6> kCounts = {
        0, 4, kRadtanCount, kRationalCount, kPrismCount, kOpenCvCoefficients.size()};
    const std::vector<double>& d = info_.D->values;
    if (std::ranges::find(kCounts, d.size()) == kCounts.end()) {
      reader_.say(*info_.D->place, Code::kRosOpenCvCount, {d.size()});
      return std::nullopt;
    }
    if (info_.D->all_zero()) return make_model("pinhole");
    const bool named_rational = info_.counted || (info_.model != nullptr && model_of(info_.model->value) == "rational");
    // More than plumb_bob has.
    const auto is_set_from = [&d](std::size_t first) {
      return d.size() > first &&
             std::any_of(d.begin() + static_cast<std::ptrdiff_t>(first), d.end(), [](double value) { return value != 0.0; });
    };
    if (is_set_from(kRadtanCount) && !named_rational)
      reader_.say(*info_.D->nodes[kRadtanCount], Code::kRosRationalUnderPlumbBob, {d.size()});
    if (is_set_from(kRationalCount)) return with_coefficients(*make_model("opencv14"), d.size());
    const bool rational = is_set_from(kRadtanCount) || (named_rational && d.size() >= kRationalCount);
    return with_coefficients(*make_model(rational ? "rational" : "radtan"), rational ? kRationalCount : kRadtanCount);
  }

  /// The coefficients under their names; those that the file leaves out are 0.
  std::optional<CameraModel> with_coefficients(CameraModel model, std::size_t count) {
    const bool fisheye = model_info(model).id == "kb4";
    for (std::size_t i = 0; i < std::min(count, info_.D->values.size()); ++i) {
      const ParameterId id = fisheye ? kFisheyeCoefficients.at(i) : kOpenCvCoefficients.at(i);
      if (!reader_.parameter(*info_.D->nodes[i], kCoefficients, id, info_.D->values[i], model)) return std::nullopt;
    }
    return model;
  }

  bool read_size(Camera& camera) {
    if (info_.width == nullptr || info_.height == nullptr) {
      camera.image_size = options_.image_size;
      return true;
    }
    std::optional<ImageSize> size = reader_.image_size(*info_.width, *info_.height, "image_");
    if (!size) return false;
    const Reduction& reduction = info_.reduction;
    if (info_.part) {
      const bool inside = info_.part->width > 0 && info_.part->height > 0 && info_.part->width <= size->width - reduction.x &&
                          info_.part->height <= size->height - reduction.y;
      if (!inside) {
        reader_.say(*info_.roi, Code::kRosRoiOutside,
                    {info_.part->width, info_.part->height, reduction.x, reduction.y, size->width, size->height});
        return false;
      }
      size = info_.part;
    }
    camera.image_size = ImageSize{size->width / reduction.binning_x, size->height / reduction.binning_y};
    if (camera.image_size->width > 0 && camera.image_size->height > 0) return true;
    reader_.say(*info_.width, Code::kRosNoPixelLeft);
    return false;
  }

  /// Where the camera sits in its rectified frame.
  bool read_place(const Camera& camera, Rig& rig) {
    if (info_.P) {
      const Projection P = projection();
      const Projection own = projection_of(matrix(*info_.K));
      const bool same = P[0] == own[0] && P[2] == own[2] && P[5] == own[5] && P[6] == own[6];
      if (!same) {
        const std::vector<double>& values = info_.P->values;
        rig.extra_fields.push_back({camera.name, std::string(kProjection), printed(values)});
      }
    }
    if (!info_.P || !check_projection(*info_.P) || !info_.R) return true;
    if (info_.R->all_zero()) {
      reader_.say(*info_.R->place, Code::kRosRectificationOfZeros);
      return true;
    }
    const Transform T = pose_of(matrix(*info_.R), projection());
    const std::optional<Transform> checked =
        reader_.checked(T, {*info_.R->place, kRectification}, {*info_.P->place, kProjection});
    if (!checked) return false;
    rig.poses.push_back({frame_of(projection()), camera.name, *checked});
    return true;
  }

  static std::string printed(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "[" : ", ") + text::format_real(value);
    return text + "]";
  }

  [[nodiscard]] Projection projection() const {
    Projection P{};
    std::ranges::copy(info_.P->values, P.begin());
    return P;
  }

  static Matrix3 matrix(const Numbers& numbers) {
    Matrix3 result{};
    std::ranges::copy(numbers.values, result.begin());
    return result;
  }

  /// Is it [fx 0 cx, 0 fy cy, 0 0 1] with a column after? A warning if not: the camera is known without it.
  bool check_projection(const Numbers& P) {
    if (P.values[0] == 0.0 || P.values[5] == 0.0) {
      reader_.say(*P.place, P.all_zero() ? Code::kRosProjectionOfZeros : Code::kRosProjectionNoFocalLength);
      return false;
    }
    for (const std::size_t place : {8U, 9U, 10U, 11U}) {
      const double wanted = place == 10U ? 1.0 : 0.0;
      if (P.values[place] == wanted) continue;
      reader_.say(*P.nodes[place], Code::kRosProjectionLastRow, {place - 8, P.values[place], wanted});
      return false;
    }
    return true;
  }

  /// image_geometry takes a camera whose coefficients are all 0 for one that is rectified already: by P, without R.
  void warn_of_zeros(const Camera& camera) {
    if (!info_.D->all_zero() || !info_.P || info_.P->values[0] == 0.0) return;
    if (straight_id(camera.model) == "kb4") {
      reader_.say(*info_.D->place, Code::kRosFisheyeOfZeros);
      return;
    }
    const Projection own = projection_of(matrix(*info_.K));
    bool rectified = !info_.R || std::ranges::equal(info_.R->values, kIdentity);
    for (const std::size_t place : {0U, 2U, 5U, 6U}) rectified = rectified && info_.P->values[place] == own.at(place);
    if (!rectified) reader_.say(*info_.D->place, Code::kRosCoefficientsOfZeros);
  }

  fields::Reader& reader_;
  const CameraInfo& info_;
  const ReadOptions& options_;
};

}  // namespace

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  if (documents.size() != 1) {
    diagnostics.add(Code::kRosOneFile);
    return std::nullopt;
  }
  fields::Reader reader(documents.front(), kDialect, diagnostics);
  const std::optional<std::vector<CameraInfo>> infos = find_camera_infos(reader);
  if (!infos) return std::nullopt;
  Rig rig;
  for (const CameraInfo& info : *infos) {
    const std::optional<Rig> part = CameraReader(reader, info, options).run("cam" + std::to_string(rig.cameras.size()));
    if (!part) return std::nullopt;
    if (rig.find_camera(part->cameras.front().name) != nullptr) {
      reader.say(*info.K->place, Code::kRosCameraTwice, {part->cameras.front().name});
      return std::nullopt;
    }
    rig.cameras.push_back(part->cameras.front());
    rig.poses.insert(rig.poses.end(), part->poses.begin(), part->poses.end());
    rig.extra_fields.insert(rig.extra_fields.end(), part->extra_fields.begin(), part->extra_fields.end());
  }
  return rig;
}

std::optional<Camera> as_stated(const text::Document& document, const Camera& camera) {
  Diagnostics said_already;
  fields::Reader reader(document, kDialect, said_already);
  const std::optional<std::vector<CameraInfo>> infos = find_camera_infos(reader);
  if (!infos || infos->size() != 1) return std::nullopt;
  const CameraInfo& info = infos->front();
  const bool other_images = info.reduction.changes_pixels() || info.part;
  if (!other_images || info.width == nullptr || info.height == nullptr) return std::nullopt;
  Camera whole = camera;
  whole.model = unreduced(camera.model, info.reduction);
  whole.image_size = reader.image_size(*info.width, *info.height, "image_");
  return whole;
}

}  // namespace fca::ros
