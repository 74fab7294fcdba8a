// SPDX-License-Identifier: BSD-3-Clause
#include "seeded_defects.h"

namespace fca::test {
namespace {

/// A defect, and where it can be told. `plant` changes the rig, or says that this one has no such fact.
struct Defect {
  const char* name;
  std::vector<std::string> codes;  ///< One of them must be reported.
  std::function<bool(Rig&)> plant;
  int at_least = 20;
  const char* format = nullptr;  ///< Whose program minds; null: any.
  const char* absent = nullptr;  ///< What must not stand in the file.
  bool number_is_known = true;   ///< False: nobody can tell which of several is wrong.
  bool of_matrices = false;      ///< A quaternion is a rotation whatever its numbers are.
};

bool states_quaternions(const Good& good) {
  return good.calibration.format->id == "colmap" || bytes_of(good).find("\"qw\"") != std::string::npos;
}

/// A pose that its file specifies, perhaps as a matrix.
bool has_matrix(const Rig& rig) { return !rig.poses.empty() && rig.poses.front().a != "vehicle"; }

bool has_size(const Rig& rig) { return !rig.cameras.empty() && rig.cameras.front().image_size; }

/// Is the first camera's principal point near the middle? If not, nobody can tell which number is wrong.
bool is_centred(const Rig& rig) {
  const Pixel centre = principal_point(rig.cameras.front().model);
  const ImageSize& size = *rig.cameras.front().image_size;
  return std::abs(2.0 * centre[0] / size.width - 1.0) < 0.08 && std::abs(2.0 * centre[1] / size.height - 1.0) < 0.08;
}

bool scale_parameter(Rig& rig, ParameterId name, double factor) {
  if (rig.cameras.empty()) return false;
  const std::optional<double> value = parameter(rig.cameras.front().model, name);
  return value && set_parameter(rig.cameras.front().model, name, *value * factor);
}

/// T_cam1_cam0 next to T_cam0_imu and T_cam1_imu; null where a rig has no such thing.
PoseEdge* stated_twice(Rig& rig) {
  if (rig.poses.size() < 3 || rig.cameras.size() < 2) return nullptr;
  const auto found = std::ranges::find_if(
      rig.poses, [&rig](const PoseEdge& edge) { return edge.a == rig.cameras[1].name && edge.b == rig.cameras[0].name; });
  return found == rig.poses.end() ? nullptr : &*found;
}

std::vector<Defect> defects() {
  const auto imu = [](std::optional<double> Imu::*member, double factor) {
    return [member, factor](Rig& rig) {
      if (rig.imus.empty() || !(rig.imus.front().*member)) return false;
      *(rig.imus.front().*member) *= factor;
      return true;
    };
  };
  // The variance of an inflated noise is still a noise.
  const auto variance = [imu](std::optional<double> Imu::*member) {
    return [member, of = imu(member, 1e-4)](Rig& rig) {
      constexpr double kInflated = 0.02;
      return !rig.imus.empty() && (rig.imus.front().*member).value_or(1.0) < kInflated && of(rig);
    };
  };
  return {
      {"focal length in millimetres",
       {"focal-length-not-in-pixels"},
       [](Rig& rig) {
         if (!has_size(rig) || !parameter(rig.cameras.front().model, "fx")) return false;
         return scale_parameter(rig, "fx", 0.005) && scale_parameter(rig, "fy", 0.005);
       }},
      {"principal point outside",
       {"centre-outside", "size-unlike-centre"},
       [](Rig& rig) { return has_size(rig) && scale_parameter(rig, "cx", 3.0); }},
      {"a wrong digit in fy",
       {"focal-lengths-differ"},
       [](Rig& rig) { return has_size(rig) && scale_parameter(rig, "fy", 1.5); }},
      {"width and height exchanged",
       {"size-swapped", "centre-swapped"},  // in OCamCalib's files either may be the one
       [](Rig& rig) {
         if (!has_size(rig)) return false;
         ImageSize& size = *rig.cameras.front().image_size;
         if (!is_centred(rig) || std::max(size.width, size.height) < 1.3 * std::min(size.width, size.height)) return false;
         std::swap(size.width, size.height);
         return true;
       }},
      {"the size of another resolution",
       {"size-unlike-centre"},
       [](Rig& rig) {
         if (!has_size(rig) || !is_centred(rig)) return false;
         rig.cameras.front().image_size->width *= 2;
         rig.cameras.front().image_size->height *= 2;
         return true;
       }},
      {"a principal point far from the middle",
       {"centre-off", "centre-outside", "size-unlike-centre", "size-swapped"},
       [](Rig& rig) {
         if (!has_size(rig)) return false;
         const double middle = 0.5 * rig.cameras.front().image_size->height;
         const double cy = principal_point(rig.cameras.front().model)[1];
         return std::abs(1.6 * cy / middle - 1.0) > 0.4 && scale_parameter(rig, "cy", 1.6);
       }},
      {"a fisheye's third number as tangential term",
       {"wrong-family", "tangential-too-large"},
       [](Rig& rig) {
         if (rig.cameras.empty() || model_info(rig.cameras.front().model).id != std::string_view("radtan")) return false;
         return set_parameter(rig.cameras.front().model, "p1", -0.11);
       }},
      {"tangential terms beside numbers of no fisheye",
       {"tangential-too-large"},
       [](Rig& rig) {
         if (rig.cameras.empty() || model_info(rig.cameras.front().model).id != std::string_view("radtan")) return false;
         CameraModel& model = rig.cameras.front().model;
         return set_parameter(model, "p1", 0.03) && set_parameter(model, "k1", -0.4);
       }},
      {"a distortion that folds",
       {"folds-inside-image", "undistortion-inexact"},
       [](Rig& rig) {
         if (!has_size(rig) || model_info(rig.cameras.front().model).id != std::string_view("radtan")) return false;
         CameraModel& model = rig.cameras.front().model;
         const double fx = parameter(model, "fx").value_or(1.0);
         const double fy = parameter(model, "fy").value_or(1.0);
         const double corner =
             std::hypot(0.5 * rig.cameras.front().image_size->width / fx, 0.5 * rig.cameras.front().image_size->height / fy);
         if (corner < 0.3) return false;  // a narrow lens never gets there
         // The radius r + k1 r^3 ends at 2/3 of the corner's.
         return set_parameter(model, "k1", -1.0 / (3.0 * corner * corner)) && set_parameter(model, "k2", 0.0);
       }},
      {"translation in millimetres",
       {"translation-in-mm", "units-not-stated"},
       [](Rig& rig) {
         if (rig.poses.empty()) return false;
         Transform& T = rig.poses.front().T_a_b;
         double length = 0.0;
         for (int row = 0; row < 3; ++row) {
           length = std::max(length, std::abs(T(row, 3)));
           T(row, 3) *= 1000.0;
         }
         return length > 0.02 && length < 100.0;
       }},
      {"a row of a rotation mirrored",
       {"left-handed"},
       [](Rig& rig) {
         if (!has_matrix(rig) || rotation_determinant(rig.poses.front().T_a_b) < 0.0) return false;
         for (int column = 0; column < 3; ++column) rig.poses.front().T_a_b(0, column) *= -1.0;
         return true;
       },
       20,
       nullptr,
       nullptr,
       true,
       true},
      {"a digit lost in a rotation",
       {"not-a-rotation"},
       [](Rig& rig) {
         if (!has_matrix(rig)) return false;
         Transform& T = rig.poses.front().T_a_b;
         for (int column = 0; column < 3; ++column) {
           if (std::abs(T(0, column)) < 0.9) continue;
           T(0, column) *= 0.96;
           return true;
         }
         return false;
       },
       20,
       nullptr,
       nullptr,
       true,
       true},
      {"gyroscope noise as a variance", {"imu-noise-too-small"}, variance(&Imu::gyroscope_noise_density)},
      {"gyroscope noise in degrees and discrete",
       {"imu-noise-too-large", "imu-sensors-swapped"},
       imu(&Imu::gyroscope_noise_density, 810.0)},
      {"random walk in the noise's place",
       {"imu-walk-above-noise"},
       [](Rig& rig) {
         if (rig.imus.empty() || !rig.imus.front().gyroscope_noise_density || !rig.imus.front().gyroscope_random_walk)
           return false;
         std::swap(rig.imus.front().gyroscope_noise_density, rig.imus.front().gyroscope_random_walk);
         return true;
       }},
      {"accelerometer noise as a variance", {"imu-noise-too-small"}, variance(&Imu::accelerometer_noise_density)},
      {"one of two statements of a pose inverted",
       {"pose-inverted", "poses-contradict"},
       [](Rig& rig) {
         PoseEdge* edge = stated_twice(rig);
         const std::optional<Transform> other_way = edge == nullptr ? std::nullopt : inverse(edge->T_a_b);
         if (other_way) edge->T_a_b = *other_way;
         return other_way.has_value();
       },
       5},  // few files specify a pose twice
      {"one of two statements of a pose transposed",
       {"pose-transposed"},
       [](Rig& rig) {
         PoseEdge* edge = stated_twice(rig);
         if (edge == nullptr) return false;
         const Transform T = edge->T_a_b;
         for (int row = 0; row < 3; ++row) {
           for (int column = 0; column < 3; ++column) edge->T_a_b(row, column) = T(column, row);
         }
         return std::abs(T(0, 1) - T(1, 0)) + std::abs(T(0, 2) - T(2, 0)) + std::abs(T(1, 2) - T(2, 1)) > 0.05;
       },
       5,
       nullptr,
       nullptr,
       false},
      {"one of two statements of a pose moved",
       {"poses-contradict"},
       [](Rig& rig) {
         PoseEdge* edge = stated_twice(rig);
         if (edge == nullptr) return false;
         edge->T_a_b(0, 3) += 0.07;
         return true;
       },
       5,
       nullptr,
       nullptr,
       false},
      {"the second camera on the left",
       {"stereo-order"},
       [](Rig& rig) {
         if (rig.cameras.size() != 2) return false;
         for (PoseEdge& edge : rig.poses) {
           if (edge.a.starts_with("imu") || edge.b.starts_with("imu")) continue;
           const std::optional<Transform> other_way = inverse(edge.T_a_b);
           if (other_way) edge.T_a_b = *other_way;
           return other_way.has_value();
         }
         return false;
       },
       20,
       "orbslam3"},
      {"the second camera below the first",
       {"stereo-vertical"},
       [](Rig& rig) {
         if (rig.cameras.size() != 2 || model_info(rig.cameras.front().model).id == std::string_view("kb4")) return false;
         for (PoseEdge& edge : rig.poses) {
           if (edge.a.starts_with("imu") || edge.b.starts_with("imu")) continue;
           std::swap(edge.T_a_b(0, 3), edge.T_a_b(1, 3));
           return true;
         }
         return false;
       },
       1,
       "orbslam3",
       nullptr,
       false},
      {"the second camera's images turned",
       {"pair-rolled"},
       [](Rig& rig) {
         if (rig.cameras.size() != 2) return false;
         for (PoseEdge& edge : rig.poses) {
           if (edge.a.starts_with("imu") || edge.b.starts_with("imu")) continue;
           Transform turn;
           turn(0, 0) = turn(1, 1) = 0.0;
           turn(0, 1) = -1.0;
           turn(1, 0) = 1.0;
           edge.T_a_b = edge.T_a_b * turn;
           return true;
         }
         return false;
       },
       1,
       "orbslam3",
       nullptr,
       false},
      {"the second camera looks aside",
       {"pair-turned"},
       [](Rig& rig) {
         if (rig.cameras.size() != 2) return false;
         for (PoseEdge& edge : rig.poses) {
           if (edge.a.starts_with("imu") || edge.b.starts_with("imu")) continue;
           Transform turn;
           turn(0, 0) = turn(2, 2) = 0.0;
           turn(0, 2) = 1.0;
           turn(2, 0) = -1.0;
           edge.T_a_b = edge.T_a_b * turn;
           return true;
         }
         return false;
       },
       1,
       "orbslam3",
       nullptr,
       false},
      {"a pose that is not the rectification's",
       {"rectification-contradicts"},
       [](Rig& rig) {
         if (!rig.rectified || rig.cameras.size() != 2 || rig.stated("cam1", "cam0") == nullptr) return false;
         for (PoseEdge& edge : rig.poses) {
           if (edge.a == "cam1") edge.T_a_b(0, 3) *= 1.3;
         }
         return true;
       },
       1,
       "opencv",
       nullptr,
       false},
      {"a baseline of another head",
       {"pair-far-apart"},
       [](Rig& rig) {
         const Transform* T = rig.cameras.size() == 2 ? rig.stated("cam1", "cam0") : nullptr;
         if (T == nullptr || std::abs((*T)(0, 3)) > 0.3) return false;
         for (PoseEdge& edge : rig.poses) {
           if (edge.a == "cam1") edge.T_a_b(0, 3) = -2.7;
         }
         rig.rectified.reset();
         return true;
       },
       1,
       "opencv",
       nullptr,
       false},
      {"k1 copied over k2",
       {"coefficient-repeated"},
       [](Rig& rig) {
         const std::optional<double> k1 = rig.cameras.empty() ? std::nullopt : parameter(rig.cameras.front().model, "k1");
         const bool long_enough = k1 && std::round(*k1 * 1e4) != *k1 * 1e4;
         return long_enough && parameter(rig.cameras.front().model, "k2") &&
                set_parameter(rig.cameras.front().model, "k2", *k1);
       }},
      {"EUCM's alpha and beta under radial terms",
       {"eucm-without-type"},
       [](Rig& rig) {
         if (rig.cameras.empty() || model_info(rig.cameras.front().model).id != std::string_view("radtan")) return false;
         CameraModel& model = rig.cameras.front().model;
         return set_parameter(model, "k1", 0.629) && set_parameter(model, "k2", 1.0418) && set_parameter(model, "p1", 0.0) &&
                set_parameter(model, "p2", 0.0) && set_parameter(model, "k3", 0.0);
       },
       15,
       "orbslam3",
       "Camera.type"},
      {"a camera forty metres above the road",
       {"pose-implausible"},
       [](Rig& rig) {
         if (rig.poses.empty()) return false;
         rig.poses.front().T_a_b(2, 3) = 40.0;
         return true;
       },
       5,
       "woodscape"},
      {"time offset in milliseconds",
       {"time-offset-large"},
       [](Rig& rig) {
         if (rig.cameras.empty() || !rig.cameras.front().time_offset_s || std::abs(*rig.cameras.front().time_offset_s) < 2e-4)
           return false;
         *rig.cameras.front().time_offset_s *= 1000.0;
         return true;
       }},
  };
}

/// The bytes of the file with the defect in it; nothing where the writer refuses it or writes another file.
std::optional<std::string> planted(const Good& good, const Defect& defect) {
  if (defect.format != nullptr && good.calibration.format->id != defect.format) return std::nullopt;
  if (defect.absent != nullptr && bytes_of(good).find(defect.absent) != std::string::npos) return std::nullopt;
  if (defect.of_matrices && states_quaternions(good)) return std::nullopt;
  Rig rig = good.calibration.rig;
  if (!defect.plant(rig)) return std::nullopt;
  Diagnostics diagnostics;
  const std::optional<Written> written =
      good.calibration.format->write(&good.calibration.documents.front(), rig, {}, diagnostics);
  if (!written || written->files.size() != 1) return std::nullopt;
  return written->files.front().document.bytes();
}

}  // namespace

std::vector<SeededDefect> seeded_facts() {
  std::vector<SeededDefect> result;
  for (const Defect& defect : defects()) {
    const auto plant = [defect](const Good& good) { return planted(good, defect); };
    SeededDefect seeded{defect.name, defect.codes, plant, {}, defect.at_least};
    if (defect.number_is_known) seeded.is_placed = is_new_number;
    result.push_back(std::move(seeded));
  }
  return result;
}

}  // namespace fca::test
