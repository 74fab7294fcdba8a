// SPDX-License-Identifier: BSD-3-Clause
// Trainers of Gaussian splats: which of COLMAP's cameras they take, and what they read of a transforms.json.
//
//   gsplat     nerfstudio-project/gsplat (2026-08-20), examples/datasets/colmap.py
//   3dgrut     nv-tlabs/3dgrut (2026-07-08), threedgrut/datasets/dataset_colmap.py and dataset_nerf.py
//   LichtFeld  MrNeRF/LichtFeld-Studio: colmap.cpp (2025-10-17); src/io/formats/transforms.cpp at 0673fd46. Until 2025-10 it
//              refused a transforms.json with coefficients above 0.
#include "nerf_file.h"

#include "programs.h"
#include "taken_models.h"

#include <fca/code.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace fca::consumers {
namespace {

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;
using Json = NerfFile::Json;

/// ncore's cameras (OpenCVPinholeCameraModel), which 3dgrut traces: a ray whose radial factor is outside these is invalid.
constexpr double kLeastFactor = 0.8;
constexpr double kLargestFactor = 1.2;

/// The factor by which a lens without a fisheye's angle moves a point at that ray away from its centre. `k`: k1, k2, and of
/// FULL_OPENCV p1 p2 k3 k4 k5 k6.
double radial_factor(std::span<const double> k, const Ray& ray) {
  const auto at = [&k](std::size_t index) { return index < k.size() ? k[index] : 0.0; };
  const double r2 = (ray[0] * ray[0] + ray[1] * ray[1]) / (ray[2] * ray[2]);
  const double above = 1.0 + r2 * (at(0) + r2 * (at(1) + r2 * at(4)));
  const double below = 1.0 + r2 * (at(5) + r2 * (at(6) + r2 * at(7)));
  return above / below;
}

/// Gives up the rays that ncore does.
void limit_radial_factor(const colmap::Model& model, const std::vector<double>& params, ConsumerCamera& camera) {
  constexpr std::array<std::string_view, 4> kRadial = {"SIMPLE_RADIAL", "RADIAL", "OPENCV", "FULL_OPENCV"};
  if (std::ranges::find(kRadial, model.name) == kRadial.end()) return;
  const std::vector<double> k(params.end() - static_cast<std::ptrdiff_t>(model.coefficients), params.end());
  camera.project = [k, whole = std::move(camera.project)](const Ray& ray) -> std::optional<Pixel> {
    const double factor = radial_factor(k, ray);
    return factor > kLeastFactor && factor < kLargestFactor ? whole(ray) : std::nullopt;
  };
}

constexpr std::array<std::string_view, 12> kIntrinsics = {"fl_x", "fl_y", "cx", "cy", "k1", "k2",
                                                          "k3",   "k4",   "p1", "p2", "w",  "h"};

/// True, with a warning, if frames have numbers of their own: neither of the two looks there.
bool warn_of_frames(NerfFile& file, const NerfCamera& camera) {
  const auto* const own = std::ranges::find_if(
      kIntrinsics, [&camera](std::string_view key) { return NerfFile::find(*camera.frame, key) != nullptr; });
  if (own != kIntrinsics.end()) file.warn(Code::kNerfSaysTopOnly, {*own}, "frames");
  return own != kIntrinsics.end();
}

bool is_fisheye(NerfFile& file, const NerfCamera& camera) {
  return file.is_named_fisheye() || file.flag(file.root(), "is_fisheye") || file.flag(*camera.frame, "is_fisheye");
}

double from_angle(double side, double angle) { return 0.5 * side / std::tan(0.5 * angle); }

/// What LichtFeld keeps for all images.
struct TopCamera {
  double w = 0.0, h = 0.0, fl_x = 0.0, fl_y = 0.0, cx = 0.0, cy = 0.0;
  double k1 = 0.0, k2 = 0.0, k3 = 0.0, p1 = 0.0, p2 = 0.0;
};

std::optional<Pixel> project(const TopCamera& c, const Ray& ray) {
  const std::optional<Pixel> plane = nerf_plane(ray);
  if (!plane) return std::nullopt;
  const auto [x, y] = *plane;
  const double r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (c.k1 + r2 * (c.k2 + r2 * c.k3));
  return Pixel{c.fl_x * (x * radial + 2.0 * c.p1 * x * y + c.p2 * (r2 + 2.0 * x * x)) + c.cx,
               c.fl_y * (y * radial + 2.0 * c.p2 * x * y + c.p1 * (r2 + 2.0 * y * y)) + c.cy};
}

TopCamera read_top(NerfFile& file, const LoadOptions& options) {
  TopCamera c;
  const auto real = [&file](std::string_view key) { return file.number(file.root(), key); };
  c.w = real("w").value_or(options.image_size[0]);
  c.h = real("h").value_or(options.image_size[1]);
  const std::optional<double> angle_x = real("camera_angle_x");
  const std::optional<double> angle_y = real("camera_angle_y");
  const std::optional<double> fl_x = real("fl_x");
  const std::optional<double> fl_y = real("fl_y");
  if (!fl_x && !angle_x) file.refuse(Code::kNerfSaysLacks, {"fl_x", 0}, "frames");
  c.fl_x = fl_x ? *fl_x : from_angle(c.w, angle_x.value_or(1.0));
  c.fl_y = fl_y ? *fl_y : angle_y ? from_angle(c.h, *angle_y) : c.fl_x;
  if (!fl_y && !angle_y && c.w != c.h) file.refuse(Code::kNerfSaysNotSquare, {}, "fl_x");
  c.cx = real("cx").value_or(0.5 * c.w);
  c.cy = real("cy").value_or(0.5 * c.h);
  c.k1 = real("k1").value_or(0.0);
  c.k2 = real("k2").value_or(0.0);
  c.k3 = real("k3").value_or(0.0);
  c.p1 = real("p1").value_or(0.0);
  c.p2 = real("p2").value_or(0.0);
  return c;
}

ConsumerView load_transforms_of_lichtfeld(std::string_view bytes, const LoadOptions& options) {
  ConsumerView view;
  NerfFile file(bytes, true, view);
  if (view.loads()) file.check_frames(4);
  if (!view.loads()) return view;
  const TopCamera top = read_top(file, options);
  for (const NerfCamera& camera : view.loads() ? file.cameras() : std::vector<NerfCamera>()) {
    ConsumerCamera seen = nerf_camera(camera, top.w, top.h, "PINHOLE", [top](const Ray& ray) { return project(top, ray); });
    const bool of_frames = warn_of_frames(file, camera);
    const bool fisheye = is_fisheye(file, camera);
    if (fisheye) file.warn(Code::kNerfSaysPinhole, {}, "camera_model");
    const bool by_list = file.warn_of_list(file.root()) || file.warn_of_list(*camera.frame);
    seen.misread = of_frames || fisheye || by_list;
    view.cameras.push_back(std::move(seen));
  }
  if (!view.loads()) view.cameras.clear();
  return view;
}

ConsumerView load_transforms_of_3dgrut(std::string_view bytes, const LoadOptions& options) {
  ConsumerView view;
  NerfFile file(bytes, false, view);
  if (view.loads()) file.check_frames(3);
  if (!view.loads()) return view;
  const std::optional<double> angle = file.number(file.root(), "camera_angle_x");
  if (!angle) file.refuse(Code::kNerfSaysLacks, {"camera_angle_x", 0}, "frames");
  for (const NerfCamera& camera : view.loads() ? file.cameras() : std::vector<NerfCamera>()) {
    TopCamera c;
    const auto side = [&](std::string_view key, double of_image) {
      const bool own = NerfFile::find(*camera.frame, key) != nullptr;
      return file.number(own ? *camera.frame : file.root(), key).value_or(of_image);
    };
    c.w = side("w", options.image_size[0]);
    c.h = side("h", options.image_size[1]);
    c.fl_x = c.fl_y = from_angle(c.w, *angle);
    c.cx = 0.5 * c.w;
    c.cy = 0.5 * c.h;
    ConsumerCamera seen = nerf_camera(camera, c.w, c.h, "pinhole", [c](const Ray& ray) { return project(c, ray); });
    file.warn(Code::kNerfSaysAngleOnly, {}, "camera_angle_x");
    seen.misread = true;
    view.cameras.push_back(std::move(seen));
  }
  if (!view.loads()) view.cameras.clear();
  return view;
}

}  // namespace

ConsumerView load_gsplat(std::string_view bytes, const LoadOptions& /*options*/) {
  return load_taken_of_colmap(bytes, "gsplat", kTakenByGsplat);
}

ConsumerView load_3dgrut(std::string_view bytes, const LoadOptions& options) {
  return is_json(bytes) ? load_transforms_of_3dgrut(bytes, options)
                        : load_taken_of_colmap(bytes, "3dgrut", kTakenBy3dgrut, &limit_radial_factor);
}

ConsumerView load_lichtfeld(std::string_view bytes, const LoadOptions& options) {
  return is_json(bytes) ? load_transforms_of_lichtfeld(bytes, options)
                        : load_taken_of_colmap(bytes, "LichtFeld Studio", kTakenByLichtfeld);
}

}  // namespace fca::consumers
