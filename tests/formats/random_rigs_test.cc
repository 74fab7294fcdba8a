// SPDX-License-Identifier: BSD-3-Clause
// Random rigs through the formats that hold several cameras, poses and an IMU: what is written reads back bit for bit.
#include "formats/oracle_table.h"
#include "formats/rigs.h"

#include <fca/formats/wording.h>
#include <fca/rig/stereo_order.h>
#include <fca/rig/stereo_pair.h>

#include <cmath>

#include <rapidcheck/gtest.h>

namespace fca::test {
namespace {

/// A number in [low, high] with all the digits of a double.
double random_in(double low, double high) {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  return low + (high - low) * (static_cast<double>(bits >> 11U) * 0x1p-53);
}

/// A number of either sign, from 1e-13 to 0.1 or exactly 0: lens coefficients are spelled with exponents, too.
double random_coefficient() {
  const int decade = *rc::gen::inRange(0, 14);
  return decade == 13 ? 0.0 : random_in(-1.0, 1.0) * std::pow(10.0, -1.0 - decade);
}

Transform random_pose() {
  std::array<double, 4> q{};
  double norm = 0.0;
  for (double& value : q) {
    value = random_in(-1.0, 1.0);
    norm += value * value;
  }
  norm = std::sqrt(norm);
  RC_PRE(norm > 0.1);
  const double x = q[0] / norm;
  const double y = q[1] / norm;
  const double z = q[2] / norm;
  const double w = q[3] / norm;
  return {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), random_in(-2.0, 2.0),  //
           2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), random_in(-2.0, 2.0),  //
           2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), random_in(-2.0, 2.0),  //
           0, 0, 0, 1}};
}

CameraModel random_model(const std::string& id) {
  CameraModel model = *make_model(id);
  const double fx = random_in(100.0, 900.0);
  for (const Parameter& p : model_info(model).parameters) {
    const std::string name(p.name);
    double value = random_coefficient();
    if (name == "fx") value = fx;
    if (name == "fy") value = fx * random_in(0.9, 1.1);
    if (name == "cx") value = random_in(200.0, 440.0);
    if (name == "cy") value = random_in(150.0, 330.0);
    if (name == "alpha") value = random_in(0.01, 0.99);
    if (name == "beta") value = random_in(0.5, 1.5);
    if (name == "xi") value = id == "mei" ? random_in(0.1, 2.0) : random_in(-0.3, 0.3);
    if (name == "w") value = random_in(0.6, 1.3);
    if (name == "k3" && id == "radtan") value = 0.0;
    RC_ASSERT(set_parameter(model, ParameterId(p), value));
  }
  return model;
}

/// What random rigs of a format look like.
struct Shape {
  std::string format;
  std::vector<std::string> models;
  int most_cameras = 4;
  bool one_model = false;
  bool topics = false;
  bool time_offsets = false;
  bool frame_rate = false;
  int fewest_cameras = 1;
};

Rig random_rig(const Shape& shape) {
  Rig rig;
  const int count = *rc::gen::inRange(shape.fewest_cameras, shape.most_cameras + 1);
  std::string model = *rc::gen::elementOf(shape.models);
  for (int i = 0; i < count; ++i) {
    if (!shape.one_model) model = *rc::gen::elementOf(shape.models);
    Camera camera;
    camera.name = "cam" + std::to_string(i);
    camera.image_size = ImageSize{640, 480};
    camera.model = random_model(model);
    if (shape.topics) camera.topic = "/camera" + std::to_string(i) + "/image_raw";
    if (shape.time_offsets) camera.time_offset_s = random_in(-0.1, 0.1);
    if (shape.frame_rate) camera.frame_rate_hz = *rc::gen::inRange(5, 120);
    if (i > 0 && shape.frame_rate) camera.frame_rate_hz = rig.cameras.front().frame_rate_hz;
    rig.cameras.push_back(std::move(camera));
  }
  return rig;
}

void add_random_imu(Rig& rig, bool topic) {
  rig.imus.push_back({"imu0", random_in(1e-5, 1e-3), random_in(1e-6, 1e-4), random_in(1e-4, 1e-2), random_in(1e-5, 1e-3),
                      *rc::gen::inRange(50, 1000), topic ? "/imu0" : ""});
}

/// All files that were written, read again as one calibration.
std::optional<Calibration> read_back(const Written& written, const Format& format, std::string& said) {
  std::vector<text::Document> documents;
  for (const Written::File& file : written.files)
    documents.push_back(document_of(file.document.bytes(), file.document.source().name));
  Diagnostics diagnostics;
  ReadOptions options;
  options.join = !format.many_cameras;
  std::optional<Calibration> calibration = read_calibration(documents, &format, options, diagnostics);
  for (const Diagnostic& entry : diagnostics.entries()) said += message_of(entry) + "\n";
  return calibration;
}

void reads_back_bit_equal(const Shape& shape, const Rig& rig) {
  const Format& format = *find_format(shape.format);
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(format, nullptr, rig, {}, diagnostics);
  RC_ASSERT(written.has_value());
  RC_ASSERT(written->losses.empty());
  std::string said;
  const std::optional<Calibration> back = read_back(*written, format, said);
  RC_LOG(said);
  RC_ASSERT(back.has_value());
  RC_ASSERT(back->rig.cameras == rig.cameras);
  RC_ASSERT(back->rig.imus == rig.imus);
  for (const PoseEdge& edge : rig.poses) {
    const Transform* stated = back->rig.stated(edge.a, edge.b);
    RC_ASSERT(stated != nullptr);
    RC_ASSERT(*stated == edge.T_a_b);
  }
}

/// Side by side, the same way: a stereo pair.
Transform random_pair_pose() {
  const double angle = random_in(-0.1, 0.1);
  const double beside = random_in(-2.0, 2.0);
  return {{std::cos(angle), -std::sin(angle), 0.0, beside,                        //
           std::sin(angle), std::cos(angle), 0.0, beside * random_in(-0.5, 0.5),  //
           0.0, 0.0, 1.0, random_in(-2.0, 2.0),                                   //
           0.0, 0.0, 0.0, 1.0}};
}

/// Two cameras that see little in common are not written as a stereo pair.
void require_common_view(const Rig& rig) {
  if (rig.cameras.size() > 1) RC_PRE(may_be_stereo(rig, rig.cameras[0], rig.cameras[1]) && !second_below_first(rig));
}

/// As a camchain specifies poses: each camera to the one before it, the first to the IMU.
void chain(Rig& rig) {
  for (std::size_t i = 1; i < rig.cameras.size(); ++i)
    rig.poses.push_back({rig.cameras[i].name, rig.cameras[i - 1].name, random_pose()});
  if (!rig.imus.empty()) rig.poses.push_back({"cam0", "imu0", random_pose()});
}

RC_GTEST_PROP(RandomRigs, ThroughKalibr, ()) {
  const Shape shape = {"kalibr", {"radtan", "kb4", "mei", "eucm", "ds", "fov"}, 4, false, true, true, false};
  Rig rig = random_rig(shape);
  if (*rc::gen::arbitrary<bool>()) add_random_imu(rig, true);
  chain(rig);
  reads_back_bit_equal(shape, rig);
}

RC_GTEST_PROP(RandomRigs, ThroughTumVi, ()) {
  const Shape shape = {"tumvi", {"kb4", "mei", "radtan", "fov"}, 4, false, true, false, false};
  Rig rig = random_rig(shape);
  if (*rc::gen::arbitrary<bool>()) add_random_imu(rig, true);
  chain(rig);
  reads_back_bit_equal(shape, rig);
}

// Stereo.T_c1_c2 and IMU.T_b_c1 are read in that direction.
RC_GTEST_PROP(RandomRigs, ThroughOrbSlam3, ()) {
  const Shape shape = {"orbslam3", {"radtan", "kb4"}, 2, true, false, false, true};
  Rig rig = random_rig(shape);
  if (rig.cameras.size() > 1) rig.poses.push_back({"cam0", "cam1", random_pair_pose()});
  require_common_view(rig);
  if (*rc::gen::arbitrary<bool>()) {
    add_random_imu(rig, false);
    rig.poses.push_back({"imu0", "cam0", random_pose()});
  }
  reads_back_bit_equal(shape, rig);
}

/// The rig as a format says it; its losses are added.
Rig through(const Rig& rig, const char* id, std::vector<Loss>& losses) {
  const Format& format = *find_format(id);
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(format, nullptr, rig, {}, diagnostics);
  RC_ASSERT(written.has_value());
  losses.insert(losses.end(), written->losses.begin(), written->losses.end());
  std::string said;
  const std::optional<Calibration> back = read_back(*written, format, said);
  RC_LOG(said);
  RC_ASSERT(back.has_value());
  return back->rig;
}

bool loses(const std::vector<Loss>& losses, const std::string& code) {
  return std::ranges::any_of(losses, [&code](const Loss& loss) { return id_of(loss) == code; });
}

void same_poses(const Rig& a, const Rig& b, double tolerance) {
  for (const PoseEdge& edge : a.poses) {
    const std::optional<Transform> T = b.resolve(edge.a, edge.b);
    RC_ASSERT(T.has_value());
    RC_ASSERT(element_difference(*T, edge.T_a_b) <= tolerance);
  }
}

// Two cameras and an IMU come home from settings; time offsets do not, and that is reported.
RC_GTEST_PROP(RandomRigs, KalibrToOrbSlam3AndBack, ()) {
  const Shape shape = {"kalibr", {"radtan", "kb4"}, 2, true, true, true, false, 2};
  Rig rig = random_rig(shape);
  add_random_imu(rig, true);
  rig.poses.push_back({"cam1", "cam0", random_pair_pose()});
  require_common_view(rig);
  rig.poses.push_back({"cam0", "imu0", random_pose()});
  std::vector<Loss> losses;
  const Rig back = through(through(rig, "orbslam3", losses), "kalibr", losses);
  RC_ASSERT(back.cameras.size() == rig.cameras.size());
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) RC_ASSERT(back.cameras[i].model == rig.cameras[i].model);
  Imu imu = rig.imus.front();
  imu.topic = back.imus.at(0).topic;
  RC_ASSERT(back.imus.front() == imu);
  same_poses(rig, back, 1e-6);
  RC_ASSERT(loses(losses, "time-offset-dropped"));
  RC_ASSERT(loses(losses, "topic-dropped"));
}

// A chain has no IMU in OpenCV's files, and all else.
RC_GTEST_PROP(RandomRigs, KalibrToOpenCvAndBack, ()) {
  const Shape shape = {"kalibr", {"radtan", "kb4"}, 4, true, false, false, false};
  Rig rig = random_rig(shape);
  chain(rig);
  std::vector<Loss> losses;
  const Rig back = through(through(rig, "opencv", losses), "kalibr", losses);
  RC_ASSERT(back.cameras.size() == rig.cameras.size());
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) RC_ASSERT(back.cameras[i].model == rig.cameras[i].model);
  same_poses(rig, back, 1e-12);
  RC_ASSERT(losses.empty());
}

// Each camera in the vehicle, as a quaternion, and back by way of R and T between cameras. OpenCV has no vehicle, which is
// said; the models are WoodScape's alone and come home next to the poses.
RC_GTEST_PROP(RandomRigs, WoodScapeToOpenCvAndBack, ()) {
  const Shape shape = {"woodscape", {"kb4"}, 4, true, false, false, false, 2};
  Rig rig = random_rig(shape);
  for (const Camera& camera : rig.cameras) rig.poses.push_back({"vehicle", camera.name, random_pose()});
  const auto as_woodscape = [](Rig of) {
    for (Camera& camera : of.cameras) {
      const std::span<const double> p = parameter_values(camera.model);
      camera.model = Intrinsics<Woodscape>{{340.0, -30.0, 50.0, -7.0, 0.5 + p[1] / 1000.0, p[2], p[3]}};
    }
    return of;
  };
  std::vector<Loss> losses;
  const Rig read = through(as_woodscape(rig), "woodscape", losses);
  RC_ASSERT(read.cameras == as_woodscape(rig).cameras);
  same_poses(rig, read, 1e-12);
  RC_ASSERT(losses.empty());

  Rig in_opencv = read;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) in_opencv.cameras[i].model = rig.cameras[i].model;
  const Rig opencv = through(in_opencv, "opencv", losses);
  RC_ASSERT(loses(losses, "pose-dropped"));
  Rig home = opencv;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) home.cameras[i].name = rig.cameras[i].name;
  const Rig back = through(as_woodscape(home), "woodscape", losses);
  RC_ASSERT(back.cameras.size() == rig.cameras.size());
  for (std::size_t i = 1; i < rig.cameras.size(); ++i) {
    const std::optional<Transform> before = rig.resolve(rig.cameras[i].name, rig.cameras[0].name);
    const std::optional<Transform> after = back.resolve(back.cameras[i].name, back.cameras[0].name);
    RC_ASSERT(before && after);
    RC_ASSERT(element_difference(*after, *before) <= 1e-12);
  }
}

}  // namespace
}  // namespace fca::test
