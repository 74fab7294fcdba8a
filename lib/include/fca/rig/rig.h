// SPDX-License-Identifier: BSD-3-Clause
// What a calibration means, whatever file it came from. Units: metres, radians, seconds, pixels.
#pragma once

#include <fca/message.h>
#include <fca/models/camera_model.h>
#include <fca/rig/lens_circle.h>
#include <fca/rig/transform.h>
#include <fca/rig/uncertainty.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca {

struct ImageSize {
  int width = 0;
  int height = 0;
  bool operator==(const ImageSize&) const = default;

  /// Between the centres of its outermost pixels, these included.
  [[nodiscard]] bool holds(const Pixel& pixel) const {
    return pixel[0] >= 0.0 && pixel[1] >= 0.0 && pixel[0] <= width - 1.0 && pixel[1] <= height - 1.0;
  }
};

/// A part of an image: its top-left pixel, and its size.
struct ImageRegion {
  int x = 0;
  int y = 0;
  ImageSize size;
  bool operator==(const ImageRegion&) const = default;
};

/// One camera. Pixel coordinates have their origin at the centre of the top-left pixel.
struct Camera {
  std::string name;                     ///< "cam0", "cam1", ... or the file's own name; unique in its rig.
  std::optional<ImageSize> image_size;  ///< Nothing where the file does not say.
  CameraModel model;
  std::optional<double> time_offset_s;  ///< t_imu = t_cam + time_offset_s
  std::optional<double> frame_rate_hz;
  std::string topic;                           ///< ROS topic; empty if none.
  std::optional<LensCircle> lens_circle = {};  ///< Where images show it; no file says it.
  /// Where the lens is known by rays and their pixels alone (kFewestRays or more; the weights sum to 1): `model` is then a
  /// pinhole with its centre (centre_of(), fca/convert/ray_table.h), and only a conversion makes a model of it.
  std::vector<Correspondence> rays = {};
  bool operator==(const Camera&) const = default;

  /// The id and title of its model, or those of a table of rays.
  [[nodiscard]] std::string_view lens_id() const;
  [[nodiscard]] std::string_view lens_title() const;
};

/// Noise of an IMU as continuous-time densities; nothing where the file does not say.
struct Imu {
  std::string name = "imu0";
  std::optional<double> gyroscope_noise_density;      ///< rad/s/sqrt(Hz)
  std::optional<double> gyroscope_random_walk;        ///< rad/s^2/sqrt(Hz)
  std::optional<double> accelerometer_noise_density;  ///< m/s^2/sqrt(Hz)
  std::optional<double> accelerometer_random_walk;    ///< m/s^3/sqrt(Hz)
  std::optional<double> rate_hz;
  std::string topic;
  bool operator==(const Imu&) const = default;
};

/// Something a file specifies that Rig has no member for (rolling shutter, a program's tuning).
struct ExtraField {
  std::string owner;  ///< The camera, IMU or mapping of the file that it is said of; empty: the file as a whole.
  std::string key;    ///< As the file spells it: "line_delay", "Viewer.PointSize".
  std::string value;  ///< A scalar as spelled; of lists and matrices what they say ("[1.0, 2.0]").
  Message said = {};  ///< What people are told in place of the value, where that is more; none: the value.
  Code kind = {};     ///< Code of the loss where a target cannot hold it; kNone: that of any value.
  bool operator==(const ExtraField&) const = default;
};

/// What people are told: the key after its owner's name, "cam0 line_delay".
[[nodiscard]] std::string with_owner(const ExtraField& field);

/// What a frame that poses speak of belongs to.
enum class FrameKind {
  kCamera,
  kImu,
  kVehicle,
  kOther,  ///< A board, a rectified image, a camera that is not in the rig.
};

/// A frame of the poses that is neither in Rig::cameras nor in Rig::imus: the IMU of a camchain, a vehicle.
struct Frame {
  std::string name;
  FrameKind kind = FrameKind::kOther;
  bool operator==(const Frame&) const = default;
};

/// The images of a stereo pair after its rectification: one pinhole camera for both, turned so that matches are in one row (in
/// one column, where one camera stands above the other).
struct RectifiedPair {
  struct View {
    std::string camera;                     ///< Its name in the rig, or in `sources`.
    Transform T_rectified_camera;           ///< A rotation, OpenCV's R1 or R2.
    Pixel centre{};                         ///< cx, cy of P1 or P2.
    std::optional<ImageRegion> valid = {};  ///< Of the rectified image: the camera sees each pixel of it.
    bool operator==(const View&) const = default;
  };
  std::array<View, 2> views;              ///< In the order of the file; the first is the origin.
  std::array<double, 2> focal_lengths{};  ///< fx, fy of both [px].
  std::optional<ImageSize> size = {};     ///< Nothing: that of the cameras' images.
  bool is_vertical = false;
  /// Where the second camera stands in the rectified frame [m]: to the right of the first, or below it where `is_vertical`
  /// (negative: left, above). -P2(0, 3) / fx, -P2(1, 3) / fy.
  double offset_m = 0.0;
  /// The two cameras, where the rig's own camera is the rectified one (ORB-SLAM2's LEFT.* and RIGHT.*); else empty.
  std::vector<Camera> sources = {};
  bool operator==(const RectifiedPair&) const = default;
};

/// Cameras, IMUs and how they sit to each other. May hold no camera (imu.yaml).
struct Rig {
  std::vector<Camera> cameras;
  std::vector<Imu> imus;
  /// Poses as edges of a graph, as read. A file that says both T_cam_imu and T_cn_cnm1 keeps both.
  std::vector<PoseEdge> poses;
  /// Of frames of `poses` that are no camera and no IMU above: what their reader knows them to be.
  std::vector<Frame> frames;
  /// A format that has no place for these lists them as lost.
  std::vector<ExtraField> extra_fields;
  /// Baseline of a rectified stereo pair or of an RGB-D sensor's virtual second camera, where the file specifies only that [m].
  std::optional<double> baseline_m;
  /// Where the files specify it.
  std::optional<RectifiedPair> rectified = {};
  /// Of cameras by their names; no target format holds any. Of several of one camera the first that specifies it counts.
  std::vector<Uncertainty> uncertainties = {};
  std::vector<PoseUncertainty> pose_uncertainties = {};

  /// `name`, or with "_2", "_3", ... after it where a camera is called so.
  [[nodiscard]] std::string unused_name(const std::string& name) const;
  [[nodiscard]] const Camera* find_camera(std::string_view name) const;
  /// The first statement of a camera's standard deviations, one with a covariance before others; null if there is none.
  [[nodiscard]] const Uncertainty* find_uncertainty(std::string_view camera) const;
  /// The first field of that owner ("": none) with that key; null if there is none.
  [[nodiscard]] const ExtraField* find_extra_field(std::string_view owner, std::string_view key) const;

  /// What a frame of `poses` is, by what the rig holds and never by how it is called.
  [[nodiscard]] FrameKind kind_of(std::string_view frame) const;
  /// A frame that poses are specified in, once.
  void add_frame(std::string_view name, FrameKind kind);

  /// The edge a-b exactly as a file stated it, in that direction; null if there is none.
  [[nodiscard]] const Transform* stated(std::string_view a, std::string_view b) const;

  /// T_a_b along the shortest path of edges (each taken forwards or inverted); nothing if a and b are not connected, or an
  /// inverse on the way does not exist. Among equally short paths the edge that was read first wins.
  [[nodiscard]] std::optional<Transform> resolve(std::string_view a, std::string_view b) const;

  bool operator==(const Rig&) const = default;
};

}  // namespace fca
