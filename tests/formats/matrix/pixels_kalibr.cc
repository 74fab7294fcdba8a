// SPDX-License-Identifier: BSD-3-Clause
// Camchains as Kalibr computes with them. Source of the keys, the order of the intrinsics and the formulas: FORMATS.md
// section 1.1 (ethz-asl/kalibr@1f60227: kalibr_common/ConfigReader.py, aslam_cameras' PinholeProjection, OmniProjection,
// ExtendedUnified- Projection, DoubleSphereProjection, RadialTangentialDistortion, EquidistantDistortion, FovDistortion). Where
// Kalibr divides by z first and so ends at 90 deg, the angle is taken here instead: its limit is its own affair, the formula
// goes on.
#include "pixels_kalibr.h"

#include "storage.h"

#include <yaml-cpp/yaml.h>

namespace fca::matrix::kalibr {

namespace {

/// One camera's entries, whichever parser found them.
struct Entries {
  std::string camera_model;
  std::string distortion_model;
  std::vector<double> intrinsics;
  std::vector<double> distortion;
  std::vector<double> resolution;
  std::vector<double> T_cn_cnm1;
  std::vector<double> T_cam_imu;
  std::vector<double> T_imu_cam;
};

void flatten(const YAML::Node& node, std::vector<double>& into) {
  if (!node) return;
  if (node.IsScalar()) {
    into.push_back(node.as<double>());
    return;
  }
  for (const YAML::Node& item : node) flatten(item, into);
}

std::optional<Entries> by_yaml_cpp(const std::string& bytes, std::size_t index) {
  try {
    const YAML::Node camera = YAML::Load(bytes)["cam" + std::to_string(index)];
    if (!camera || !camera.IsMap()) return std::nullopt;
    Entries entries;
    entries.camera_model = camera["camera_model"].as<std::string>();
    entries.distortion_model = camera["distortion_model"].as<std::string>();
    flatten(camera["intrinsics"], entries.intrinsics);
    flatten(camera["distortion_coeffs"], entries.distortion);
    flatten(camera["resolution"], entries.resolution);
    flatten(camera["T_cn_cnm1"], entries.T_cn_cnm1);
    flatten(camera["T_cam_imu"], entries.T_cam_imu);
    flatten(camera["T_imu_cam"], entries.T_imu_cam);
    return entries;
  } catch (const YAML::Exception&) {
    return std::nullopt;
  }
}

/// OpenVINS' layout, which plain YAML parsers refuse (FORMATS.md 1.3).
std::optional<Entries> by_opencv(const std::string& bytes, std::size_t index) {
  const cv::FileStorage storage = open_storage(bytes);
  if (!storage.isOpened()) return std::nullopt;
  const cv::FileNode camera = storage["cam" + std::to_string(index)];
  if (!camera.isMap()) return std::nullopt;
  Entries entries;
  entries.camera_model = static_cast<std::string>(camera["camera_model"]);
  entries.distortion_model = static_cast<std::string>(camera["distortion_model"]);
  entries.intrinsics = numbers(camera["intrinsics"]);
  entries.distortion = numbers(camera["distortion_coeffs"]);
  entries.resolution = numbers(camera["resolution"]);
  entries.T_cn_cnm1 = numbers(camera["T_cn_cnm1"]);
  entries.T_cam_imu = numbers(camera["T_cam_imu"]);
  entries.T_imu_cam = numbers(camera["T_imu_cam"]);
  return entries;
}

std::optional<Entries> entries_of(const std::string& bytes, std::size_t index) {
  if (std::optional<Entries> entries = by_yaml_cpp(bytes, index)) return entries;
  return by_opencv(bytes, index);
}

/// A point of the plane before the distortion, with the ray it came from for the angle.
using Plane = std::function<std::optional<Pixel>(const Ray&)>;
using Distortion = std::function<Pixel(const Pixel&)>;

double norm(const Ray& p) { return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]); }

std::optional<Pixel> over(const Ray& p, double denominator) {
  if (!(denominator > 0.0)) return std::nullopt;
  return Pixel{p[0] / denominator, p[1] / denominator};
}

Plane omni(double xi) {
  return [xi](const Ray& p) -> std::optional<Pixel> {
    const double d = norm(p);
    if (xi > 1.0 && p[2] * xi <= -d) return std::nullopt;  // behind this the mirror's image turns back
    return over(p, p[2] + xi * d);
  };
}

Plane eucm(double alpha, double beta) {
  return [alpha, beta](const Ray& p) {
    const double d = std::sqrt(beta * (p[0] * p[0] + p[1] * p[1]) + p[2] * p[2]);
    return over(p, alpha * d + (1.0 - alpha) * p[2]);
  };
}

Plane ds(double xi, double alpha) {
  return [xi, alpha](const Ray& p) {
    const double k = xi * norm(p) + p[2];
    const double d2 = std::sqrt(p[0] * p[0] + p[1] * p[1] + k * k);
    return over(p, alpha * d2 + (1.0 - alpha) * k);
  };
}

/// A lens that is a function of the angle only, f(tan theta) in Kalibr, f(theta) here.
Plane radial(const std::function<double(double)>& radius_of_angle) {
  return [radius_of_angle](const Ray& p) -> std::optional<Pixel> {
    const double r = std::hypot(p[0], p[1]);
    if (r == 0.0) return p[2] > 0.0 ? std::optional(Pixel{0.0, 0.0}) : std::nullopt;
    const double m = radius_of_angle(std::atan2(r, p[2]));
    return Pixel{m * p[0] / r, m * p[1] / r};
  };
}

Distortion radtan(const std::vector<double>& k) {
  return [k](const Pixel& m) {
    const double r2 = m[0] * m[0] + m[1] * m[1];
    const double s = 1.0 + k[0] * r2 + k[1] * r2 * r2;
    return Pixel{m[0] * s + 2.0 * k[2] * m[0] * m[1] + k[3] * (r2 + 2.0 * m[0] * m[0]),
                 m[1] * s + k[2] * (r2 + 2.0 * m[1] * m[1]) + 2.0 * k[3] * m[0] * m[1]};
  };
}

Pixel undistorted(const Pixel& m) { return m; }

struct Lens {
  Plane plane;
  Distortion distortion = undistorted;
};

std::optional<Lens> pinhole(const std::string& distortion, const std::vector<double>& k) {
  const Plane plane = [](const Ray& p) { return over(p, p[2]); };
  if (distortion == "none" && k.empty()) return Lens{plane};
  if (distortion == "radtan" && k.size() == 4) return Lens{plane, radtan(k)};
  if (distortion == "equidistant" && k.size() == 4) {
    return Lens{radial([k](double t) {
      const double t2 = t * t;
      return t * (1.0 + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3]))));
    })};
  }
  if (distortion == "fov" && k.size() == 1) {
    const double w = k[0];
    if (w == 0.0) return Lens{plane};
    // atan(2 r tan(w/2)) / w with r = sin/cos of the angle
    return Lens{radial([w](double t) { return std::atan2(2.0 * std::sin(t) * std::tan(0.5 * w), std::cos(t)) / w; })};
  }
  return std::nullopt;
}

std::optional<Lens> lens_of(const Entries& entries) {
  const std::string& model = entries.camera_model;
  const std::vector<double>& i = entries.intrinsics;
  const std::vector<double>& k = entries.distortion;
  if (model == "pinhole" && i.size() == 4) return pinhole(entries.distortion_model, k);
  if (model == "omni" && i.size() == 5) {
    if (entries.distortion_model == "radtan" && k.size() == 4) return Lens{omni(i[0]), radtan(k)};
    if (entries.distortion_model == "none") return Lens{omni(i[0])};
    return std::nullopt;
  }
  if (entries.distortion_model != "none") return std::nullopt;
  if (model == "eucm" && i.size() == 6) return Lens{eucm(i[0], i[1])};
  if (model == "ds" && i.size() == 6) return Lens{ds(i[0], i[1])};
  return std::nullopt;
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const std::optional<Entries> entries = entries_of(bytes, index);
  if (!entries) return std::nullopt;
  const std::optional<Lens> lens = lens_of(*entries);
  if (!lens) return std::nullopt;
  // The last four: fu fv pu pv
  const std::size_t n = entries->intrinsics.size();
  const std::array<double, 4> f = {entries->intrinsics[n - 4], entries->intrinsics[n - 3], entries->intrinsics[n - 2],
                                   entries->intrinsics[n - 1]};
  PixelFormula formula;
  formula.pixel = [lens = *lens, f](const Ray& p) -> std::optional<Pixel> {
    const std::optional<Pixel> plane = lens.plane(p);
    if (!plane) return std::nullopt;
    const Pixel m = lens.distortion(*plane);
    return Pixel{f[0] * m[0] + f[2], f[1] * m[1] + f[3]};
  };
  if (entries->resolution.size() == 2) {
    formula.size = Size{static_cast<int>(entries->resolution[0]), static_cast<int>(entries->resolution[1])};
  }
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  std::vector<Pose> result;
  for (const std::string& bytes : files) {
    const std::optional<Entries> first = entries_of(bytes, 0);
    const std::optional<Entries> second = entries_of(bytes, 1);
    if (!first || !second) continue;
    if (const std::optional<Pose> pose = pose_of(second->T_cn_cnm1)) result.push_back(*pose);
    const std::optional<Pose> imu0 = pose_of(first->T_cam_imu);
    const std::optional<Pose> imu1 = pose_of(second->T_cam_imu);
    if (imu0 && imu1) result.push_back(*imu1 * inverse(*imu0));
    const std::optional<Pose> cam0 = pose_of(first->T_imu_cam);
    const std::optional<Pose> cam1 = pose_of(second->T_imu_cam);
    if (cam0 && cam1) result.push_back(inverse(*cam1) * *cam0);
  }
  return result;
}

}  // namespace fca::matrix::kalibr
