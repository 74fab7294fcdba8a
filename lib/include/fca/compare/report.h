// SPDX-License-Identifier: BSD-3-Clause
// How two calibrations of the same cameras differ. "Reference" is the one that counts as right, "other" the one looked at.
#pragma once

#include <fca/convert/report.h>
#include <fca/message.h>
#include <fca/rig/rig.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fca {

/// No more than this many pixels apart, two cameras count as the same: less than a corner detector is off.
inline constexpr double kSamePx = 0.25;

/// A common mistake that explains a difference: with it undone the two agree, without they do not.
struct Mistake {
  Message message;                       ///< {0}: what it is about, in the other's names: "cam0", "T_imu0_cam0".
  std::optional<std::size_t> pose = {};  ///< Which of the other's poses it is about.

  /// The same mistake, of whatever else.
  [[nodiscard]] bool is_like(const Mistake& mistake) const;
};

/// Angles between the rays that the two give for the same pixel, between two angles from the reference's axis.
struct AngleBand {
  double from_deg = 0.0;
  double to_deg = 0.0;
  double rms_deg = 0.0;
  double max_deg = 0.0;
};

/// The same over all that was scored.
struct AngleSummary {
  double rms_deg = 0.0;
  double max_deg = 0.0;
  Pixel max_at{};  ///< The reference's pixel where it is.
  std::vector<AngleBand> bands;
};

/// How far two cameras are apart.
struct CameraDifference {
  ErrorStatistics statistics;  ///< As of a conversion: pixel -> ray by the reference -> pixel by the other.
  AngleSummary angle;
  /// No pixel up to that angle from the reference's axis is further off than kSamePx; the field of view's angle where none is
  /// at all.
  double same_to_deg = 0.0;
};

/// The rotation with which two cameras come nearest to each other, for points infinitely far away; at a distance, the rotation
/// and translation.
struct BestRotation {
  Transform T_other_reference;  ///< Takes points (rays, without a distance) in the reference's frame to the other's.
  double angle_rad = 0.0;
  std::array<double, 3> vector_rad{};     ///< Along its axis (x right, y down, z forward), as long as its angle.
  std::optional<double> distance_m = {};  ///< From the reference's projection centre to the points; nothing: infinite.
  std::array<double, 3> centre_m{};       ///< Where the other's projection centre is, in the reference's frame.
  CameraDifference difference;            ///< With the reference's rays (points) moved by it.
};

/// The differences between the rays of a region about the axis.
struct FocusComparison {
  double max_angle_deg = 0.0;  ///< From the reference's axis.
  CameraDifference difference;
  std::optional<CameraDifference> rotated;  ///< As CameraComparison::rotated.
};

/// One parameter of two camera models, by its name; of a model that has none of that name, nothing.
struct ParameterComparison {
  std::string name;  ///< "fx"
  std::optional<double> reference;
  std::optional<double> other;  ///< For images of the reference's size.
  [[nodiscard]] bool same_but_for_rounding() const;
};

/// Two cameras.
struct CameraComparison {
  std::string reference;  ///< Name.
  std::string other;
  std::string reference_model;
  std::string other_model;
  ImageSize size;             ///< The reference's image. All errors are in its pixels.
  bool size_assumed = false;  ///< Neither specifies a size: the image whose middle is the reference's principal point.
  std::optional<ImageSize> other_size;          ///< The other's image, where it was scaled to that.
  std::vector<ParameterComparison> parameters;  ///< Of both, the reference's first.
  bool identical = false;                       ///< Same model, parameters and image size, to the last bit.
  double scored_to_deg = 0.0;                   ///< Nothing further from the axis was scored.
  CameraDifference difference;
  std::optional<BestRotation> rotated;   ///< Nothing for identical cameras.
  std::optional<FocusComparison> focus;  ///< If CompareOptions::focus_rad says so.
  /// The other's poses of this camera turn back by what its lens is turned: together they see the world as the reference's do,
  /// but for what `rotated` leaves, which then is the whole lens's rotation, without a distance. Only in a comparison of rigs.
  bool turn_cancels = false;

  /// Of the rays that count: those in focus, or all.
  [[nodiscard]] const CameraDifference& counted() const { return focus ? focus->difference : difference; }
  /// The same with the best rotation undone; null where there is none.
  [[nodiscard]] const CameraDifference* counted_rotated() const;
  /// What a verdict is about: of the rays that count, and with the best rotation undone where poses cancel it.
  [[nodiscard]] const CameraDifference& decisive() const { return turn_cancels ? *counted_rotated() : counted(); }
};

/// How far two poses are apart.
struct PoseDistance {
  double angle_rad = 0.0;
  double distance_m = 0.0;
};

/// How the same two things sit to each other in the two rigs. T_a_b as each resolves it.
struct PoseComparison {
  std::string a;  ///< The reference's names.
  std::string b;
  double angle_rad = 0.0;           ///< Between the rotations.
  double distance_m = 0.0;          ///< Between the two positions of b in a.
  double reference_length_m = 0.0;  ///< How far b is from a.
  double other_length_m = 0.0;
  /// With the turns of its cameras that poses cancel (CameraComparison::turn_cancels) taken out; nothing where there is none.
  std::optional<PoseDistance> remaining = {};

  /// Up to 1e-9 rad and m: what remains where one rig specifies a pose and the other implies it.
  [[nodiscard]] bool same_but_for_rounding() const;
  /// What a verdict is about.
  [[nodiscard]] PoseDistance decisive() const { return remaining.value_or(PoseDistance{angle_rad, distance_m}); }
  /// How far apart they are, of decisive(); 1 is as far as two honest calibrations of one rig may be: 0.5 deg, and 5 mm or 5 %
  /// of the distance.
  [[nodiscard]] double apart() const;
  [[nodiscard]] bool alike() const { return apart() <= 1.0; }
};

/// A number that both specify.
struct FactComparison {
  std::string owner;  ///< The reference's name: "cam0", "imu0".
  std::string name;   ///< "time offset", "gyroscope noise"
  std::string unit;   ///< "s", "rad/s/sqrt(Hz)"
  double reference = 0.0;
  double other = 0.0;
  [[nodiscard]] bool same_but_for_rounding() const;
  /// How far apart they are; 1 is 1 ms of a time offset, 5 % of another number.
  [[nodiscard]] double apart() const;
  [[nodiscard]] bool alike() const { return apart() <= 1.0; }
};

/// Two rigs.
struct RigComparison {
  std::vector<CameraComparison> cameras;
  std::vector<PoseComparison> poses;
  std::vector<FactComparison> facts;  ///< Time offsets, IMU noise and rates, baseline, frame rates.
  std::vector<Mistake> mistakes;
  std::vector<Message> only_in_reference;  ///< What one of them does not say, clauses: "cam1", "imu0 rate".
  std::vector<Message> only_in_other;

  /// Does nothing that both say differ? Cameras and numbers to the last bit, poses but for rounding.
  [[nodiscard]] bool identical() const;
};

}  // namespace fca
