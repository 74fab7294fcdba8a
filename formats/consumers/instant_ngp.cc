// SPDX-License-Identifier: BSD-3-Clause
// instant-ngp: transforms.json. From NVlabs/instant-ngp@abe236e (2026-02-02): src/nerf_loader.cu (read_lens, read_focal_length,
// load_nerf) and common_device.cuh (the lenses' distortion, and rays at pixel + 0.5). It computes in float32. Of the text files
// of a COLMAP model its scripts/colmap2nerf.py makes such a file.
#include "nerf_file.h"

#include "programs.h"
#include "taken_models.h"

#include <fca/code.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca::consumers {
namespace {

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;
using Json = NerfFile::Json;

enum class LensMode { kPerspective, kOpenCv, kOpenCvFisheye, kOther };

struct Lens {
  LensMode mode = LensMode::kPerspective;
  std::array<float, 4> params{};  ///< k1 k2 p1 p2, or k1 k2 k3 k4.
};

struct Image {
  Lens lens;
  std::array<float, 2> principal_point = {0.5F, 0.5F};  ///< Over the size.
  std::array<float, 2> focal_length{};
  std::array<float, 2> resolution{};
};

float fov_to_focal_length(float resolution, float degrees) {
  return 0.5F * resolution / std::tan(0.5F * degrees * std::numbers::pi_v<float> / 180.0F);
}

std::optional<Pixel> project(const Image& image, const Ray& ray) {
  const std::optional<Pixel> plane = nerf_plane(ray);
  if (!plane || image.lens.mode == LensMode::kOther) return std::nullopt;
  auto [u, v] = *plane;
  const auto [a, b, c, d] = image.lens.params;
  const double r2 = u * u + v * v;
  if (image.lens.mode == LensMode::kOpenCv) {
    const double radial = a * r2 + b * r2 * r2;
    const double du = u * radial + 2.0 * c * u * v + d * (r2 + 2.0 * u * u);
    const double dv = v * radial + 2.0 * d * u * v + c * (r2 + 2.0 * v * v);
    u += du;
    v += dv;
  } else if (image.lens.mode == LensMode::kOpenCvFisheye && r2 > 0.0) {
    const double r = std::sqrt(r2);
    const double theta = std::atan(r);
    const double t2 = theta * theta;
    const double scale = theta * (1.0 + t2 * (a + t2 * (b + t2 * (c + t2 * d)))) / r;
    u *= scale;
    v *= scale;
  }
  const auto pixel = [&image](double point, std::size_t axis) {
    return image.focal_length.at(axis) * point +
           static_cast<double>(image.principal_point.at(axis)) * image.resolution.at(axis);
  };
  return Pixel{pixel(u, 0), pixel(v, 1)};
}

class Loader {
 public:
  Loader(NerfFile& file, const std::array<double, 2>& image_size, ConsumerView& view)
      : file_(file), image_size_(image_size), view_(view) {}

  void run() {
    file_.check_frames(3);
    if (!file_.loads()) return;
    Image base;
    read_lens(file_.root(), base);
    for (const NerfCamera& camera : file_.cameras()) {
      Image image = base;
      read_size(camera, image);
      const bool at_top = read_focal_length(file_.root(), image);
      const bool in_frame = read_focal_length(*camera.frame, image);
      if (!at_top && !in_frame) file_.refuse(Code::kNerfSaysNoFieldOfView, {camera.index}, "frames");
      read_lens(*camera.frame, image);
      if (!file_.loads()) return;
      ConsumerCamera seen = nerf_camera(camera, image.resolution[0], image.resolution[1],
                                        image.lens.mode == LensMode::kOpenCvFisheye ? "OpenCVFisheye" : "OpenCV",
                                        [image](const Ray& ray) { return project(image, ray); });
      const bool by_angle = warn_of_angles(file_.root()) || warn_of_angles(*camera.frame);
      const bool by_list = file_.warn_of_list(file_.root()) || file_.warn_of_list(*camera.frame);
      seen.misread = warn_of_lens(camera, image) || by_angle || by_list;
      view_.cameras.push_back(std::move(seen));
    }
  }

 private:
  static bool has(const Json& object, std::string_view key) { return NerfFile::find(object, key) != nullptr; }
  float real(const Json& object, std::string_view key) { return static_cast<float>(file_.number(object, key).value_or(0.0)); }

  /// The lens of an object on top of that which is known. k3 and p1 share a place, and k4 and p2.
  void read_lens(const Json& json, Image& image) {
    LensMode mode = LensMode::kPerspective;
    const LensMode opencv = file_.flag(json, "is_fisheye") ? LensMode::kOpenCvFisheye : LensMode::kOpenCv;
    constexpr std::array<std::pair<std::string_view, std::size_t>, 6> kPlaces = {
        {{"k1", 0}, {"k2", 1}, {"k3", 2}, {"k4", 3}, {"p1", 2}, {"p2", 3}}};
    for (const auto& [key, place] : kPlaces) {
      if (!has(json, key)) continue;
      image.lens.params.at(place) = real(json, key);
      if (image.lens.params.at(place) != 0.0F) mode = opencv;
    }
    read_centre(json, "cx", "w", image.principal_point[0]);
    read_centre(json, "cy", "h", image.principal_point[1]);
    for (const std::string_view key : {"ftheta_p0", "latlong", "equirectangular", "orthographic"}) {
      if (has(json, key)) mode = LensMode::kOther;
    }
    if (mode != LensMode::kPerspective) image.lens.mode = mode;
  }

  void read_centre(const Json& json, std::string_view key, std::string_view side, float& share) {
    if (!has(json, key)) return;
    if (has(json, side)) {
      share = real(json, key) / real(json, side);
    } else {
      file_.refuse(Code::kNerfSaysCentreAlone, {key, side}, std::string(key));
    }
  }

  /// It takes the size of the image file, which is what w and h should say.
  void read_size(const NerfCamera& camera, Image& image) {
    constexpr std::array<std::string_view, 2> kSides = {"w", "h"};
    for (std::size_t i = 0; i < kSides.size(); ++i) {
      const Json& owner = has(*camera.frame, kSides.at(i)) ? *camera.frame : file_.root();
      image.resolution.at(i) = has(owner, kSides.at(i)) ? real(owner, kSides.at(i)) : static_cast<float>(image_size_.at(i));
    }
  }

  float focal_length(const Json& json, const std::string& axis, float side) {
    if (has(json, axis + "_fov")) return fov_to_focal_length(side, real(json, axis + "_fov"));
    if (has(json, "fl_" + axis)) return real(json, "fl_" + axis);
    if (!has(json, "camera_angle_" + axis)) return 0.0F;
    return fov_to_focal_length(side, real(json, "camera_angle_" + axis) * 180.0F / std::numbers::pi_v<float>);
  }

  /// Does an angle stand before a focal length?
  bool warn_of_angles(const Json& json) {
    bool found = false;
    for (const auto& [angle, length] : {std::pair{"x_fov", "fl_x"}, {"y_fov", "fl_y"}}) {
      if (!has(json, angle) || !has(json, length)) continue;
      file_.warn(Code::kNerfSaysAngleFirst, {angle, length}, angle);
      found = true;
    }
    return found;
  }

  bool read_focal_length(const Json& json, Image& image) {
    const float x = focal_length(json, "x", image.resolution[0]);
    const float y = focal_length(json, "y", image.resolution[1]);
    if (x == 0.0F && y == 0.0F) return false;
    image.focal_length = {x != 0.0F ? x : y, y != 0.0F ? y : x};
    return true;
  }

  /// Is the lens not what the file means?
  bool warn_of_lens(const NerfCamera& camera, const Image& image) {
    const bool named = file_.is_named_fisheye();
    const Json& lens = has(*camera.frame, "k1") ? *camera.frame : file_.root();
    const bool flagged = file_.flag(lens, "is_fisheye");
    if (named && !flagged) {
      file_.warn(Code::kNerfSaysTakenForPerspective, {"camera_model", "is_fisheye true next to the coefficients"},
                 "camera_model");
      return true;
    }
    if (!flagged) return false;
    const bool overwritten = (has(lens, "p1") && real(lens, "k3") != 0.0F) || (has(lens, "p2") && real(lens, "k4") != 0.0F);
    const bool straight = image.lens.mode == LensMode::kPerspective;
    if (overwritten) file_.warn(Code::kNerfSaysSlots, {}, has(lens, "p1") ? "p1" : "p2");
    if (straight) file_.warn(Code::kNerfSaysNoLens, {}, "is_fisheye");
    return overwritten || straight;
  }

  NerfFile& file_;
  const std::array<double, 2>& image_size_;
  ConsumerView& view_;
};

/// Any other model than colmap2nerf.py knows: a pinhole with the line's first focal length and the image's middle.
void take_for_pinhole(const colmap::Model& model, const std::vector<double>& params, ConsumerCamera& camera) {
  if (std::ranges::find(kTakenByNerfstudio, model.name) != kTakenByNerfstudio.end()) return;
  constexpr double kCentre = 0.5;
  const Pixel middle = {0.5 * camera.width - kCentre, 0.5 * camera.height - kCentre};
  camera.project = [f = params.front(), middle](const Ray& ray) -> std::optional<Pixel> {
    const std::optional<Pixel> plane = nerf_plane(ray);
    return plane ? std::optional(Pixel{f * (*plane)[0] + middle[0], f * (*plane)[1] + middle[1]}) : std::nullopt;
  };
  camera.misread = true;
}

ConsumerView load_colmap2nerf(std::string_view bytes) {
  constexpr std::string_view kProgram = "instant-ngp";
  std::string_view unknown;
  ConsumerView view =
      load_taken_of_colmap(bytes, kProgram, {}, [&unknown](const auto& model, const auto& params, auto& camera) {
        take_for_pinhole(model, params, camera);
        if (camera.misread && unknown.empty()) unknown = model.name;
      });
  if (view.loads() && bytes.find('\0') != std::string_view::npos) {
    view.refusals.emplace_back(Code::kColmapSaysTextOnly, "", std::vector<Argument>{kProgram});
    view.cameras.clear();
  }
  if (view.loads() && !unknown.empty())
    view.warnings.emplace_back(Code::kNerfSaysColmapPinhole, "", std::vector<Argument>{unknown});
  return view;
}

}  // namespace

ConsumerView load_instant_ngp(std::string_view bytes, const LoadOptions& options) {
  if (!is_json(bytes)) return load_colmap2nerf(bytes);
  ConsumerView view;
  NerfFile file(bytes, true, view);
  if (view.loads()) Loader(file, options.image_size, view).run();
  if (!view.loads()) view.cameras.clear();
  return view;
}

}  // namespace fca::consumers
