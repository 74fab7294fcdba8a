// SPDX-License-Identifier: BSD-3-Clause
// nerfstudio: transforms.json. From nerfstudio-project/nerfstudio@50e0e3c7 (2025-07-28): nerfstudio_dataparser.py (which object
// specifies what), cameras/cameras.py (CAMERA_MODEL_TO_TYPE, generate_rays) and camera_utils.py (the distortion, whose inverse
// it finds by Newton's method). It computes in float32, and its pixels begin at 0.5. Of a COLMAP model ns-process-data makes
// such a file (process_data/colmap_utils.py), of the models that it knows without a loss.
#include "nerf_file.h"

#include "programs.h"
#include "taken_models.h"

#include <fca/code.h>

#include <algorithm>
#include <cmath>

namespace fca::consumers {
namespace {

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;
using Json = NerfFile::Json;

enum class CameraType { kPerspective, kFisheye, kOther };

struct NamedType {
  std::string_view name;
  CameraType type = CameraType::kOther;
};

constexpr std::array kTypes = {NamedType{"SIMPLE_PINHOLE", CameraType::kPerspective},
                               NamedType{"PINHOLE", CameraType::kPerspective},
                               NamedType{"SIMPLE_RADIAL", CameraType::kPerspective},
                               NamedType{"RADIAL", CameraType::kPerspective},
                               NamedType{"OPENCV", CameraType::kPerspective},
                               NamedType{"OPENCV_FISHEYE", CameraType::kFisheye},
                               NamedType{"EQUIRECTANGULAR"},
                               NamedType{"OMNIDIRECTIONALSTEREO_L"},
                               NamedType{"OMNIDIRECTIONALSTEREO_R"},
                               NamedType{"VR180_L"},
                               NamedType{"VR180_R"},
                               NamedType{"ORTHOPHOTO"},
                               NamedType{"FISHEYE624"}};

struct Numbers {
  double fl_x = 0.0, fl_y = 0.0, cx = 0.0, cy = 0.0, w = 0.0, h = 0.0;
  double k1 = 0.0, k2 = 0.0, k3 = 0.0, k4 = 0.0, p1 = 0.0, p2 = 0.0;
};

/// The forward model that radial_and_tangential_undistort inverts.
Pixel distorted(const Numbers& n, const Pixel& point) {
  const auto [x, y] = point;
  const double r = x * x + y * y;
  const double factor = 1.0 + r * (n.k1 + r * (n.k2 + r * (n.k3 + r * n.k4)));
  return {factor * x + 2.0 * n.p1 * x * y + n.p2 * (r + 2.0 * x * x),
          factor * y + 2.0 * n.p2 * x * y + n.p1 * (r + 2.0 * y * y)};
}

std::optional<Pixel> project(const Numbers& n, CameraType type, const Ray& ray) {
  std::optional<Pixel> point = nerf_plane(ray);
  if (type == CameraType::kFisheye) {
    const double radius = std::hypot(ray[0], ray[1]);
    const double theta = std::atan2(radius, ray[2]);
    point = radius > 0.0 ? Pixel{theta * ray[0] / radius, theta * ray[1] / radius} : Pixel{0.0, 0.0};
    if (radius == 0.0 && !(ray[2] > 0.0)) return std::nullopt;
  }
  if (!point) return std::nullopt;
  const Pixel bent = distorted(n, *point);
  return Pixel{n.fl_x * bent[0] + n.cx, n.fl_y * bent[1] + n.cy};
}

class Dataparser {
 public:
  Dataparser(NerfFile& file, ConsumerView& view) : file_(file), view_(view) {}

  void run() {
    file_.check_frames(3);
    if (!file_.loads()) return;
    const std::optional<CameraType> type = camera_type();
    if (!type) return;
    for (const NerfCamera& camera : file_.cameras()) {
      const Numbers numbers = read_numbers(camera);
      if (!file_.loads()) return;
      ConsumerCamera seen = nerf_camera(camera, numbers.w, numbers.h, type == CameraType::kFisheye ? "FISHEYE" : "PERSPECTIVE",
                                        [numbers, type = *type](const Ray& ray) { return project(numbers, type, ray); });
      if (type == CameraType::kOther) seen.project = [](const Ray&) { return std::optional<Pixel>(); };
      const bool flagged = file_.flag(file_.root(), "is_fisheye") || file_.flag(*camera.frame, "is_fisheye");
      if (flagged && NerfFile::find(file_.root(), "camera_model") == nullptr) {
        seen.misread = true;
        file_.warn(Code::kNerfSaysTakenForPerspective, {"is_fisheye", "camera_model OPENCV_FISHEYE"}, "is_fisheye");
      }
      view_.cameras.push_back(std::move(seen));
    }
  }

 private:
  std::optional<CameraType> camera_type() {
    const Json* name = NerfFile::find(file_.root(), "camera_model");
    if (name == nullptr) return CameraType::kPerspective;
    const std::string_view text = name->IsString() ? name->GetString() : "";
    const auto* const found = std::ranges::find(kTypes, text, &NamedType::name);
    if (found != kTypes.end()) return found->type;
    file_.refuse(Code::kNerfSaysUnknownModel, {text.substr(0, 40)}, "camera_model");
    return std::nullopt;
  }

  Numbers read_numbers(const NerfCamera& camera) {
    Numbers n;
    const auto fixed_or_own = [&](std::string_view key) {
      const Json& owner = NerfFile::find(file_.root(), key) != nullptr ? file_.root() : *camera.frame;
      if (NerfFile::find(owner, key) == nullptr) file_.refuse(Code::kNerfSaysLacks, {key, camera.index}, "frames");
      return file_.number_or_text(owner, key).value_or(0.0);
    };
    n.fl_x = fixed_or_own("fl_x");
    n.fl_y = fixed_or_own("fl_y");
    n.cx = fixed_or_own("cx");
    n.cy = fixed_or_own("cy");
    n.h = fixed_or_own("h");
    n.w = fixed_or_own("w");
    constexpr std::array<std::string_view, 6> kFixing = {"k1", "k2", "k3", "p1", "p2", "distortion_params"};
    const bool fixed =
        std::ranges::any_of(kFixing, [this](std::string_view key) { return NerfFile::find(file_.root(), key) != nullptr; });
    const Json& lens = fixed ? file_.root() : *camera.frame;
    if (const std::optional<std::vector<double>> list = file_.coefficient_list(lens)) {
      n.k1 = (*list)[0];
      n.k2 = (*list)[1];
      n.k3 = (*list)[2];
      n.k4 = (*list)[3];
      n.p1 = (*list)[4];
      n.p2 = (*list)[5];
      return n;
    }
    const auto coefficient = [&](std::string_view key) { return file_.number_or_text(lens, key).value_or(0.0); };
    n.k1 = coefficient("k1");
    n.k2 = coefficient("k2");
    n.k3 = coefficient("k3");
    n.k4 = coefficient("k4");
    n.p1 = coefficient("p1");
    n.p2 = coefficient("p2");
    return n;
  }

  NerfFile& file_;
  ConsumerView& view_;
};

}  // namespace

ConsumerView load_nerfstudio(std::string_view bytes, const LoadOptions& /*options*/) {
  if (!is_json(bytes)) return load_taken_of_colmap(bytes, "nerfstudio", kTakenByNerfstudio);
  ConsumerView view;
  NerfFile file(bytes, false, view);
  if (view.loads()) Dataparser(file, view).run();
  if (!view.loads()) view.cameras.clear();
  return view;
}

}  // namespace fca::consumers
