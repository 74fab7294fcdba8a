// SPDX-License-Identifier: BSD-3-Clause
// Asks the real programs (consumers/) what they read from bytes.
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/formats/consumers/consumer.h>
#include <fca/formats/pixel_distance.h>
#include <fca/rig/rig.h>

#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca {

struct ReadOptions;

/// What the user specifies about a file, for a program that is started in a mode ("": it has none).
[[nodiscard]] consumers::LoadOptions load_options(const ReadOptions& reading, std::string mode = {});

/// What one program reads of one camera.
struct CameraProof {
  std::string name;   ///< The rig's.
  std::string model;  ///< What the program takes the lens for, in its own words.
  int width = 0;      ///< Of the image the program works on, in pixels; 0 where the file does not specify it.
  int height = 0;
  bool misread = false;          ///< The program is known to take its numbers from the wrong place of a right file.
  bool agrees = true;            ///< To what the program's precision allows.
  double max_diff_px = 0.0;      ///< Between the program's pixels and ours, where both have one.
  double compared_share = 0.0;   ///< Of the image asked about, how much both answer.
  CameraDistance distance = {};  ///< From the camera as it was calibrated; zeros without an image size.
};

/// What one program reads from a file that is to contain `rig`.
struct ProofResult {
  std::string program;
  bool loads = false;
  double max_diff_px = 0.0;       ///< Between the program's pixels and ours, where both have one.
  double misread_px = 0.0;        ///< The same for cameras the program is known to misread; not held against the file.
  bool without_cameras = false;   ///< A file that holds none (imu.yaml).
  bool all_misread = false;       ///< There was no other camera to compare.
  double compared_share = 0.0;    ///< Of the image asked about, how much both answer.
  double unanswered_share = 0.0;  ///< Of the image asked about, how much the program has no right pixel for.
  double wrong_ray_share = 0.0;   ///< Of the image asked about, how much the program gives wrong rays though right pixels.
  double wrong_ray_px = 0.0;      ///< How far such a pixel lies, at most, from the pixel of the ray that it is given.
  Message wrong_ray_why;          ///< A clause; may say nothing.
  double max_diff_pose = 0.0;     ///< Largest difference of an element of a pose both specify.
  bool pixels_agree = false;      ///< To what its precision allows; also where there was nothing to compare (no image size).
  bool poses_agree = false;
  /// Numbers besides pixels and poses that the program holds otherwise than the rig: image sizes, time offsets, the IMU's noise
  /// and rate, a depth sensor's baseline. One each: owner, name, the program's number, the rig's ("cam0 time offset is 0.1, not
  /// 0.2").
  std::vector<Message> other_numbers;
  std::vector<CameraProof> cameras;  ///< Those that it sees, in its order.
  std::vector<std::string> poses;    ///< Those that it holds: "T_cam0_cam1".
  std::vector<consumers::Complaint> refusals;
  std::vector<consumers::Complaint> warnings;  ///< What it silently misreads or ignores.
  bool is_first = true;                        ///< The program that the file is written for; others may read it, too.
  bool undistorts_points = false;              ///< Its rays are cv::undistortPoints'; they are counted.
  std::string wanted_name = {};                ///< As ConsumerView's.
  std::vector<std::string> read_by = {};       ///< Where it refuses the file: other programs that read it.
  /// Is the file right? What the program is known to misread of right files is not held against it.
  [[nodiscard]] bool agrees() const { return loads && pixels_agree && poses_agree && other_numbers.empty(); }
  /// Does the program understand all that the file says?
  [[nodiscard]] bool understood() const { return agrees() && misread_px == 0.0; }
};

/// A camera before it was fitted to another model.
struct CalibratedCamera {
  Camera camera;
  /// How far from the axis the fit is one; beyond, the other model gives wrong pixels or none.
  double fitted_to_rad = std::numbers::pi;
  /// The rotation of the other model's frame, if it has another.
  std::optional<Transform> T_written_camera = {};
};

/// Calls body(0) .. body(count - 1), which have nothing to do with each other.
using ForEach = std::function<void(std::size_t count, const std::function<void(std::size_t)>& body)>;
void one_after_the_other(std::size_t count, const std::function<void(std::size_t)>& body);

/// Would `consumer` load these bytes and understand the rig's cameras (those named in `cameras`, in that order) as we mean
/// them? Compared are pixels, poses, and what other numbers both specify. Rays: a lattice over each camera's image, up to
/// `max_angle_rad` from the axis; what lies beyond is not asked about. `each_camera` may compare several at once. `calibrated`:
/// the cameras before they were fitted, from which CameraProof::distance is; those that are not among them are the rig's.
[[nodiscard]] ProofResult prove(const consumers::Consumer& consumer, std::string_view bytes,
                                const consumers::LoadOptions& options, const Rig& rig, std::span<const std::string> cameras,
                                double max_angle_rad = std::numbers::pi, const ForEach& each_camera = one_after_the_other,
                                std::span<const CalibratedCamera> calibrated = {});
/// The same of what the program has read from the bytes.
[[nodiscard]] ProofResult prove(const consumers::Consumer& consumer, const consumers::ConsumerView& view, const Rig& rig,
                                std::span<const std::string> cameras, double max_angle_rad, const ForEach& each_camera,
                                std::span<const CalibratedCamera> calibrated);
/// The same of all the rig's cameras.
[[nodiscard]] ProofResult prove(const consumers::Consumer& consumer, std::string_view bytes,
                                const consumers::LoadOptions& options, const Rig& rig, double max_angle_rad = std::numbers::pi,
                                const ForEach& each_camera = one_after_the_other,
                                std::span<const CalibratedCamera> calibrated = {});

/// Who reads a file, for people.
struct Readers {
  struct Program {
    std::string program;
    bool loads = false;
    bool other_syntax = false;                   ///< As consumers::Consumer's, of this format.
    std::vector<std::string> sensors;            ///< ORB-SLAM3 and kin: the modes it loads in.
    std::vector<consumers::Complaint> refusals;  ///< Of the mode that comes furthest.
    /// Of the first mode it loads in, then what further modes add: Code::kProgramAsMode ("as stereo: ...").
    std::vector<consumers::Complaint> warnings;
  };
  std::vector<Program> programs;
};

/// Asks every consumer of the format, in each of its modes; only those that read files with (or without) cameras, if that is
/// said.
[[nodiscard]] Readers ask_readers(std::string_view format, std::string_view bytes, std::optional<bool> with_cameras = {},
                                  const consumers::LoadOptions& options = {});

/// Why not one of those programs would load the file, as the first of them says it: "Kalibr: cam0/resolution ..."; says nothing
/// if one does, if there is none, or if all that they lack is keys of their own (another program's file).
[[nodiscard]] Message refused_by_all(std::string_view format, std::string_view bytes, bool with_cameras,
                                     const consumers::LoadOptions& options = {});

}  // namespace fca
