// SPDX-License-Identifier: BSD-3-Clause
#include "camera_info.h"
#include "ros.h"

#include <fca/folded_name.h>
#include <fca/formats/text/numbers.h>

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
      reader_.error(*K.nodes[6], "matrix-transposed", "camera_matrix is transposed: its principal point stands in the last row",
                    "write fx 0 cx, 0 fy cy, 0 0 1 row by row");
      return false;
    }
    if (k[1] != 0.0) {
      reader_.error(*K.nodes[1], "skew",
                    "camera_matrix has a skew of " + text::format_short(k[1]) +
                        " px at (0, 1), which no model here holds; image_geometry ignores it, others do not",
                    "calibrate without skew, or write 0 there");
      return false;
    }
    for (const std::size_t place : {3U, 6U, 7U}) {
      if (k[place] == 0.0) continue;
      reader_.error(*K.nodes[place], "not-a-camera-matrix",
                    "camera_matrix has " + text::format_short(k[place]) + " where a camera matrix has 0");
      return false;
    }
    if (k[8] != 1.0) {
      reader_.warning(*K.nodes[8], "matrix-corner", "camera_matrix(2, 2) is " + text::format_short(k[8]) + ", not 1",
                      "write 1.0");
    }
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
    return good;
  }

  std::optional<Family> family() {
    if (info_.counted) return Family::kOpenCv;
    if (info_.model == nullptr) {
      reader_.warning(*info_.D->place, "key-assumed",
                      "there is no distortion_model: ROS's parser takes plumb_bob, with a warning of its own",
                      "add  distortion_model: plumb_bob");
      return Family::kOpenCv;
    }
    const std::string& name = info_.model->value;
    const std::string_view known = model_of(name);
    if (!known.empty()) return known == "kb4" ? Family::kFisheye : Family::kOpenCv;
    return family_of_others(name);
  }

  /// Names of other programs for the same formulas: the parser loads them, and image_geometry throws at its first call.
  std::optional<Family> family_of_others(const std::string& name) {
    const std::string word = folded(name);
    const ModelInfo* model = find_model(name);
    const std::string_view id = model != nullptr ? model->id : std::string_view();
    const bool fisheye = id == "kb4" || word.find("fisheye") != std::string::npos || word.find("kannala") != std::string::npos;
    constexpr std::size_t kFisheyeCount = 4;
    const bool none = (word.empty() || word == "none" || id == "pinhole") && info_.D->all_zero();
    std::string meant;
    if (fisheye && info_.D->values.size() == kFisheyeCount) meant = "equidistant";
    if (id == "radtan" || none) meant = "plumb_bob";
    if (id == "rational") meant = "rational_polynomial";
    const std::string problem = "distortion_model '" + name.substr(0, 40) + "' is none that image_geometry knows (plumb_bob, " +
                                "rational_polynomial, equidistant): it throws at the first point or image";
    if (meant.empty()) {
      reader_.error(*info_.model, "unknown-model", problem, "convert the camera from the file of the program that made it");
      return std::nullopt;
    }
    reader_.warning(*info_.model, "program-refuses", problem + "; read as " + meant, "write " + meant);
    return meant == "equidistant" ? Family::kFisheye : Family::kOpenCv;
  }

  std::optional<CameraModel> read_lens() {
    const std::optional<Family> family = this->family();
    if (!family) return std::nullopt;
    return *family == Family::kFisheye ? read_fisheye() : read_opencv();
  }

  bool wrong_count(std::string_view wanted) {
    reader_.error(
        *info_.D->place, "wrong-length",
        std::string(kCoefficients) + " has " + std::to_string(info_.D->values.size()) + " numbers; " + std::string(wanted));
    return false;
  }

  std::optional<CameraModel> read_fisheye() {
    constexpr std::size_t kCount = 4;
    if (info_.D->values.size() != kCount &&
        !wrong_count("equidistant has k1 k2 k3 k4, and cv::fisheye stops at any other count"))
      return std::nullopt;
    return with_coefficients(*make_model("kb4"), kCount);
  }

  std::optional<CameraModel> read_opencv() {
    constexpr std::size_t kRadtan = 5;
    constexpr std::size_t kRational = 8;
    constexpr std::size_t kThinPrism = 12;
    constexpr std::array<std::size_t, 6> kCounts = {0, 4, kRadtan, kRational, kThinPrism, 14};
    const std::vector<double>& d = info_.D->values;
    if (std::ranges::find(kCounts, d.size()) == kCounts.end() &&
        !wrong_count("cv::projectPoints, which image_geometry calls, takes 4, 5, 8, 12 or 14"))
      return std::nullopt;
    for (std::size_t i = kRational; i < d.size(); ++i) {
      if (d[i] == 0.0) continue;
      const bool tilt = i >= kThinPrism;
      reader_.error(*info_.D->nodes[i], tilt ? "tilted-sensor" : "thin-prism",
                    "distortion_coefficients(" + std::to_string(i) + ") is " + text::format_short(d[i]) + ": " +
                        (tilt ? "a tilted sensor" : "thin-prism distortion") + ", which no model here holds",
                    "calibrate without it");
      return std::nullopt;
    }
    if (info_.D->all_zero()) return make_model("pinhole");
    const bool named_rational = info_.counted || (info_.model != nullptr && model_of(info_.model->value) == "rational");
    const bool eight = d.size() >= kRational && (d[5] != 0.0 || d[6] != 0.0 || d[7] != 0.0);
    if (eight && !named_rational) {
      reader_.warning(*info_.D->nodes[kRadtan], "program-ignores",
                      "plumb_bob has 5 coefficients, and here are " + std::to_string(d.size()) +
                          ": image_geometry computes rational_polynomial, whatever the name",
                      "write  distortion_model: rational_polynomial");
    }
    const bool rational = eight || (named_rational && d.size() >= kRational);
    return with_coefficients(*make_model(rational ? "rational" : "radtan"), rational ? kRational : kRadtan);
  }

  /// The coefficients under their names; those that the file leaves out are 0.
  std::optional<CameraModel> with_coefficients(CameraModel model, std::size_t count) {
    constexpr std::array<ParameterId, 8> kOpenCv = {"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
    constexpr std::array<ParameterId, 4> kFisheye = {"k1", "k2", "k3", "k4"};
    const bool fisheye = model_info(model).id == "kb4";
    for (std::size_t i = 0; i < std::min(count, info_.D->values.size()); ++i) {
      const ParameterId id = fisheye ? kFisheye.at(i) : kOpenCv.at(i);
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
        reader_.error(*info_.roi, "out-of-range",
                      "the roi of " + std::to_string(info_.part->width) + " x " + std::to_string(info_.part->height) +
                          " pixels at (" + std::to_string(reduction.x) + ", " + std::to_string(reduction.y) +
                          ") does not lie in an image of " + std::to_string(size->width) + " x " + std::to_string(size->height),
                      "all zeros mean the whole image");
        return false;
      }
      size = info_.part;
    }
    camera.image_size = ImageSize{size->width / reduction.binning_x, size->height / reduction.binning_y};
    if (camera.image_size->width > 0 && camera.image_size->height > 0) return true;
    reader_.error(*info_.width, "image-size-invalid", "binned, not one pixel of the image is left");
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
      reader_.warning(*info_.R->place, "program-misreads", "rectification_matrix is all 0: every rectified point is nan",
                      "of a camera that is no part of a stereo pair it is the identity");
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

  /// Is it [fx 0 cx, 0 fy cy, 0 0 1] with a column behind? A warning if not: the camera is known without it.
  bool check_projection(const Numbers& P) {
    if (P.values[0] == 0.0 || P.values[5] == 0.0) {
      reader_.warning(*P.place, "program-refuses",
                      P.all_zero()
                          ? "projection_matrix is all 0: image_geometry divides by its focal length, and every point is nan"
                          : "projection_matrix has a focal length of 0: image_geometry divides by it",
                      "of a camera that is no part of a stereo pair it is camera_matrix with a column of zeros");
      return false;
    }
    for (const std::size_t place : {8U, 9U, 10U, 11U}) {
      const double wanted = place == 10U ? 1.0 : 0.0;
      if (P.values[place] == wanted) continue;
      reader_.warning(*P.nodes[place], "program-refuses",
                      "projection_matrix(2, " + std::to_string(place - 8) + ") is " + text::format_short(P.values[place]) +
                          ", not " + text::format_short(wanted) + ": image_geometry does not compute with such a camera",
                      "write 0 0 1 0 as the last row");
      return false;
    }
    return true;
  }

  /// image_geometry takes a camera whose coefficients are all 0 for one that is rectified already: by P, without R.
  void warn_of_zeros(const Camera& camera) {
    if (!info_.D->all_zero() || !info_.P || info_.P->values[0] == 0.0) return;
    if (model_info(camera.model).id == "kb4") {
      reader_.warning(*info_.D->place, "program-misreads",
                      "all coefficients are 0, which image_geometry takes for no distortion at all: a pinhole, not equidistant",
                      "write a coefficient that bends nothing but is not 0, such as k4 = 1.0e-12");
      return;
    }
    const Projection own = projection_of(matrix(*info_.K));
    bool rectified = !info_.R || std::ranges::equal(info_.R->values, kIdentity);
    for (const std::size_t place : {0U, 2U, 5U, 6U}) rectified = rectified && info_.P->values[place] == own.at(place);
    if (rectified) return;
    reader_.warning(*info_.D->place, "program-misreads",
                    "all coefficients are 0, which image_geometry takes for images that are rectified already: it applies "
                    "neither rectification_matrix nor projection_matrix to them",
                    "write a coefficient that bends nothing but is not 0, such as k1 = 1.0e-12");
  }

  fields::Reader& reader_;
  const CameraInfo& info_;
  const ReadOptions& options_;
};

}  // namespace

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  if (documents.size() != 1) {
    diagnostics.error("wrong-syntax", "a camera_info is one file");
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
      reader.error(*info.K->place, "stated-twice", "a camera " + part->cameras.front().name + " stands here and before");
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
