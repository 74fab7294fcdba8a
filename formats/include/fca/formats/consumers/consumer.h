// SPDX-License-Identifier: BSD-3-Clause
// A consumer imitates a real program (Kalibr, ORB-SLAM3, ...): would it load those bytes, and what would it read from them?
//
// Consumers are written from the program's documented or observed behaviour and share no code with fca's models or text layer.
// That independence is their whole worth: a mistake of ours cannot hide in both.
#pragma once

#include <fca/formats/opencv_model.h>
#include <fca/message.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fca::consumers {

/// A camera as the program holds it after loading.
struct ConsumerCamera {
  std::string name;  ///< As fca names it: "cam0", "cam1", ...
  int width = 0;     ///< Size of the image the program works on, after its own rescaling.
  int height = 0;
  /// The program's own formula in its own precision. `ray`: x right, y down, z forward, any length. Result: pixel (u, v) at
  /// width x height, centre of the first pixel = (0, 0). Nothing where the program itself calls the ray invalid; where the
  /// program returns a wrong pixel without noticing, so does this.
  std::function<std::optional<std::array<double, 2>>(const std::array<double, 3>& ray)> project;
  /// Factor from pixels of the file's calibration to pixels of the program's image (1, 1 without rescaling), applied as the
  /// program does it: u' = u * scale[0], v' = v * scale[1], without a half-pixel shift.
  std::array<double, 2> scale = {1.0, 1.0};
  /// The program is known to take this camera's numbers from the wrong place of a right file (`warnings` says how): a
  /// difference from the file's meaning is the program's, not the file's.
  bool misread = false;
  /// Where the program approximates its own formula: by how much, in pixels.
  double approximation_px = 0.0;
  /// The other direction, pixel to ray (not normalised), where the program's own is known to go wrong; empty elsewhere.
  std::function<std::optional<std::array<double, 3>>(const std::array<double, 2>& pixel)> unproject = {};
  Message unproject_fault = {};  ///< In what way that one goes wrong, a clause.
  std::string model = {};        ///< What the program takes the lens for, in its own words: "KannalaBrandt8", "cv::fisheye".
  std::optional<double> time_offset_s = {};  ///< t_imu = t_cam + time_offset_s, where the program reads it.
};

/// T_a_b as the program holds it: takes points in b to points in a. Row-major 4 x 4, metres.
struct ConsumerPose {
  std::string a;
  std::string b;
  std::array<double, 16> T_a_b{};
};

/// An IMU's noise as the program holds it: continuous-time densities in SI units; nothing where it reads none.
struct ConsumerImu {
  std::optional<double> gyroscope_noise_density;      ///< rad/s/sqrt(Hz)
  std::optional<double> gyroscope_random_walk;        ///< rad/s^2/sqrt(Hz)
  std::optional<double> accelerometer_noise_density;  ///< m/s^2/sqrt(Hz)
  std::optional<double> accelerometer_random_walk;    ///< m/s^3/sqrt(Hz)
  std::optional<double> rate_hz;
};

/// What a program reports about one place of a file. fca/formats/wording.h words it.
struct Complaint {
  Complaint(Code code, std::string place, std::vector<Argument> arguments = {})
      : key(std::move(place)), facts{code, std::move(arguments)} {}

  bool operator==(const Complaint&) const = default;

  /// The path of what it is about, '/' between its keys: "cam0/intrinsics"; empty: none, or no keys (lines). With a '/' after
  /// it, it is about the key, whatever its value.
  std::string key;
  Message facts = {};
  bool costs_pixels = false;  ///< All that it means is that a misread camera's pixels are off.
};

/// What the program reads from a file.
struct ConsumerView {
  std::vector<Complaint> refusals;      ///< Why the program would not run with it. Empty: it loads.
  std::vector<Complaint> warnings;      ///< What it would silently misread or ignore.
  std::vector<ConsumerCamera> cameras;  ///< Empty where it refuses.
  std::vector<ConsumerPose> poses;
  std::optional<ConsumerImu> imu;
  std::optional<double> baseline_m;  ///< Of a depth sensor's virtual second camera; a pair's is among the poses.
  /// It refuses only because no camera stands under the keys it looks for; a program of one's own may look elsewhere (OpenCV
  /// prescribes no keys).
  bool finds_no_camera = false;
  /// The name of the file under which it reads the numbers so; empty: under any, or its name is known (LoadOptions::file_name).
  std::string_view wanted_name = {};
  [[nodiscard]] bool loads() const { return refusals.empty(); }
};

/// How the program is started; programs without modes ignore it.
struct LoadOptions {
  /// ORB-SLAM3's sensor: "mono", "stereo", "rgbd", "mono-inertial", "stereo-inertial", "rgbd-inertial".
  std::string sensor = "mono";
  /// Which of OpenCV's functions the program calls: a caller knows, a file with four coefficients need not say. Nothing: what
  /// the file says (fisheye_model, distortion_type), else pinhole. Files with xi are cv::omnidir's in any case.
  std::optional<OpenCvModel> opencv_model = {};
  /// Of the file, where that decides what its numbers are (cuVSLAM); empty: the name that fits them.
  std::string file_name = {};
  /// Width and height of the image files, in pixels, which some programs take where a file specifies none; zeros: unknown.
  std::array<double, 2> image_size = {};
  bool operator==(const LoadOptions&) const = default;
};

/// A parameter of a model that a program does not read: it is written as what the program takes it for.
struct UnreadParameter {
  std::string_view model;
  std::string_view parameter;
  double taken_for = 0.0;
};

/// How a file is written so that a program reads the result, besides the format.
struct Writing {
  std::string_view model = {};      ///< Empty: the best that the program reads.
  std::string_view layout = {};     ///< One of Format::layouts; empty: the usual one.
  std::string_view file_name = {};  ///< Of the file, where that decides the syntax.
  /// Of a file of an equidistant lens, kb4, in a folder of the format's own: by the usual name it would be taken for another
  /// lens.
  std::string_view equidistant_file_name = {};
  /// The file's names of the models that it takes, where it reads fewer than the format stores; empty: all of those.
  std::span<const std::string_view> models_taken = {};
  std::span<const UnreadParameter> unread = {};
  bool lenses_alone = false;  ///< It reads nothing of how cameras sit to each other.
};

/// How it is known that a reader does what its program does.
enum class ReaderCheck : std::uint8_t {
  kRealProgram,  ///< tests/programs gives our files to the program itself, whenever .ci/run runs.
  kBuiltOnce,    ///< The program was built once. Tests compare with the pixels that it printed then.
  kFromSource,   ///< Its source was read. It was never run.
};

/// The program that a reader imitates, and how the reader was checked. What is not known is empty.
struct ReaderSource {
  std::string_view repository;    ///< "ethz-asl/kalibr"
  std::string_view commit = {};   ///< Its first digits: "1f60227".
  std::string_view version = {};  ///< The release: "V1.0"; "2.7-20" is 20 commits later.
  std::string_view date = {};     ///< Of the commit, else of the version: 2024-03-08 or 2024-03.
  ReaderCheck check = ReaderCheck::kFromSource;
  std::string_view checked_with = {};  ///< Of kRealProgram, what runs: "OpenCV 4.6.0".
  std::string_view checked_on;         ///< Of kRealProgram the day since when it runs; else the day of the check.
  bool operator==(const ReaderSource&) const = default;
};

/// "ethz-asl/kalibr@1f60227 (2024-03-08)": as much as is known.
[[nodiscard]] std::string source_words(const ReaderSource& source);

/// A row of the table of consumers.
struct Consumer {
  std::string_view id;       ///< "kalibr", "orbslam3", ...
  std::string_view program;  ///< As printed: "ORB-SLAM3 V1.0".
  std::string_view format;   ///< Id of the format it reads.
  double tolerance_px;       ///< What its own precision allows: 1e-9 for double, 2e-4 (times max(1, |u| / 1000)) for float.
  ConsumerView (*load)(std::string_view bytes, const LoadOptions& options);
  bool cameras = true;  ///< false: it reads files without a camera (Kalibr's imu.yaml).
  /// Id of a second format whose files it reads, or "": TUM-VI's chains are Kalibr's.
  std::string_view second_format = {};
  /// It reads the second format's keys in another syntax than that format's own program: a file that only it reads has that
  /// format's keys and is not of the format (OpenVINS: Kalibr's keys through cv::FileStorage).
  bool other_syntax = false;
  /// It goes by a second statement of the lens, an inverse polynomial, which the read model knows nothing of.
  bool by_inverse = false;
  Writing writing = {};
  ReaderSource source = {};
  /// What load() waits for at its first call (a library that is loaded), beforehand; any thread may call it. Null: nothing.
  void (*prepare)() = nullptr;
  [[nodiscard]] constexpr bool reads(std::string_view format_id) const {
    return !format_id.empty() && (format_id == format || format_id == second_format);
  }
};

/// All consumers, in the order in which they are asked.
[[nodiscard]] std::span<const Consumer> all_consumers();

/// The consumer of that id, or null.
[[nodiscard]] const Consumer* find_consumer(std::string_view id);

/// The format's own program: the first of the table that reads such files, with cameras or without; null: there is none.
[[nodiscard]] const Consumer* own_program(std::string_view format, bool cameras);

}  // namespace fca::consumers
