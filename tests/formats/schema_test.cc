// SPDX-License-Identifier: BSD-3-Clause
// The rows that formats share, each in a table of its own: read after write is the identity, an edit touches the span that
// place_of() names and no other, and what a table has no key for is a loss.
#include "formats/rigs.h"
#include "formats/test_files.h"
#include "schema/keys.h"

#include <fca/code.h>

#include <rapidcheck/gtest.h>

#include <cmath>

namespace fca::test {
namespace {

using schema::Fact;
using schema::FactKind;
using schema::Key;
using schema::Schema;
using schema::Spread;

constexpr schema::Lens kLenses[] = {{"double sphere", "ds"}, {"fisheye", "kb4"}, {"limited", "rational", "limit", -1.0}};
constexpr std::array<std::string_view, 3> kXyz = {"x", "y", "z"};
constexpr std::array<std::string_view, 4> kQuaternion = {"qx", "qy", "qz", "qw"};
constexpr std::array<std::string_view, 1> kPosition = {"position"};
constexpr std::array<std::string_view, 1> kRotation = {"rotation"};
constexpr schema::PoseLayout kByKeys = {.frame = "imu0",
                                        .kind = FrameKind::kImu,
                                        .translation = kXyz,
                                        .rotation = kQuaternion,
                                        .restated = Code::kBasaltPoseRecomputed};
constexpr schema::PoseLayout kByLists = {
    .frame = "vehicle", .kind = FrameKind::kVehicle, .translation = kPosition, .rotation = kRotation, .rotation_first = true};

// Cameras in lists.
constexpr std::array kCameraKeys = {required(schema::lens_name("lens", kLenses)),
                                    required(schema::parameters("numbers", kLenses))};
constexpr schema::Mapping kCamera = {.keys = kCameraKeys};
constexpr std::array kRigKeys = {required(per_camera(Spread::kCounted, schema::object("cameras", kCamera))),
                                 per_camera(Spread::kEach, schema::image_size("size")),
                                 per_camera(Spread::kEach, schema::pose("pose", kByKeys)),
                                 schema::density("noise", &Imu::gyroscope_noise_density, 3, 0.25),
                                 schema::imu_number("rate", &Imu::rate_hz, 100.0),
                                 schema::kept_numbers("bias", 2),
                                 schema::common_time_offset("offset_us", 1e6)};
constexpr Schema kLists = {.what = "a test",
                           .dialect = text::Dialect::kOpenCv,
                           .root = {.keys = kRigKeys, .unread = ""},
                           .codes = {.offset_rounded = Code::kBasaltOffsetRounded, .further_imu = Code::kBasaltImuDropped}};

// One camera, fact by fact. (No reader of poses in lists: each format checks its quaternion in its own way.)
constexpr std::array kLensKeys = {schema::parameter("f", "fx"), schema::parameter("f_v", "fy"), schema::parameter("c", "cx"),
                                  schema::parameter("c_v", "cy")};
constexpr schema::Mapping kLens = {.keys = kLensKeys, .unread = "lens."};
constexpr std::array kOneKeys = {schema::camera_name("who"), required(schema::object("lens", kLens)),
                                 schema::image_width("w", false), schema::image_height("h", "w", true)};
constexpr Schema kOne = {.what = "a test",
                         .dialect = text::Dialect::kPyYaml,
                         .root = {.keys = kOneKeys, .unread = ""},
                         .codes = {},
                         .one_camera = true,
                         .numbers_in_lines = true};

double random_in(double low, double high) {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  return low + (high - low) * (static_cast<double>(bits >> 11U) * 0x1p-53);
}

Transform random_pose() {
  const Quaternion q = {random_in(-1.0, 1.0), random_in(-1.0, 1.0), random_in(-1.0, 1.0), random_in(-1.0, 1.0)};
  RC_PRE(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] > 0.01);
  return pose_of(normalised(q), {random_in(-5.0, 5.0), random_in(-5.0, 5.0), random_in(-5.0, 5.0)});
}

CameraModel random_model() {
  CameraModel model = sample_model(*rc::gen::element<std::string>("ds", "kb4"));
  for (double& value : parameter_values(model)) value *= random_in(0.9, 1.1);
  return model;
}

/// A rig that the table kLists holds.
Rig random_rig() {
  Rig rig;
  const int cameras = *rc::gen::inRange(1, 4);
  const double offset_s = *rc::gen::inRange(-1'000'000, 1'000'000) / 1e6;
  for (int i = 0; i < cameras; ++i) {
    Camera& camera = rig.cameras.emplace_back();
    camera.name = "cam" + std::to_string(i);
    camera.image_size = ImageSize{*rc::gen::inRange(1, 9000), *rc::gen::inRange(1, 9000)};
    camera.model = random_model();
    camera.time_offset_s = offset_s;
    rig.poses.push_back({"imu0", camera.name, random_pose()});
  }
  Imu& imu = rig.imus.emplace_back();
  imu.gyroscope_noise_density = random_in(1e-6, 1.0);
  imu.rate_hz = random_in(1.0, 1000.0);
  return rig;
}

text::Document fresh(const Schema& schema, const Rig& rig, Written& written) {
  return document_of(schema::composed_json(schema, rig, 0, written), "test.json");
}

Rig read_by(const Schema& schema, const text::Document& document) {
  Diagnostics diagnostics;
  const std::optional<Rig> rig = schema::read(schema, std::span(&document, 1), {}, diagnostics);
  EXPECT_TRUE(rig) << document.bytes();
  EXPECT_TRUE(diagnostics.entries().empty()) << document.bytes();
  return rig.value_or(Rig());
}

double largest_pose_difference(const Rig& a, const Rig& b) {
  double worst = 0.0;
  for (const PoseEdge& edge : a.poses) {
    const Transform* stated = b.stated(edge.a, edge.b);
    worst = std::max(worst, stated != nullptr ? test::element_difference(edge.T_a_b, *stated) : HUGE_VAL);
  }
  return worst;
}

RC_GTEST_PROP(Schema, ReadAfterWriteIsTheIdentity, ()) {
  const Rig rig = random_rig();
  Written written;
  const Rig back = read_by(kLists, fresh(kLists, rig, written));
  RC_ASSERT(written.defaults.empty());
  RC_ASSERT(written.losses.empty());
  RC_ASSERT(back.cameras == rig.cameras);
  RC_ASSERT(back.imus == rig.imus);
  RC_ASSERT(back.extra_fields.empty());
  RC_ASSERT(largest_pose_difference(rig, back) <= 4e-15);
}

/// A fact of the rig that is to be another one, and where it stands.
struct Change {
  Fact fact;
  std::size_t camera = 0;
};

Change change_one_fact(Rig& rig) {
  const auto index = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(rig.cameras.size())));
  Camera& camera = rig.cameras[index];
  switch (*rc::gen::inRange(0, 5)) {
    case 0: {
      const auto& parameters = model_info(camera.model).parameters;
      const auto p = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(parameters.size())));
      parameter_values(camera.model)[p] *= 1.0 + 1e-9;
      return {{.kind = FactKind::kParameter, .parameter = parameters[p].name}, index};
    }
    case 1:
      ++camera.image_size->height;
      return {{.kind = FactKind::kImageSize, .row = 1}, index};
    case 2:
      rig.poses[index].T_a_b(1, 3) += 1e-3;
      return {{.kind = FactKind::kPose, .row = 1, .column = 3}, index};
    case 3:
      rig.imus.front().rate_hz = *rig.imus.front().rate_hz + 0.5;
      return {{.kind = FactKind::kImu, .imu = &Imu::rate_hz}, index};
    default:
      for (Camera& each : rig.cameras) each.time_offset_s = *each.time_offset_s + 1e-6;
      return {{FactKind::kTimeOffset}, index};
  }
}

RC_GTEST_PROP(Schema, AnEditTouchesTheSpanThatStatesTheFact, ()) {
  Written written;
  const text::Document base = fresh(kLists, random_rig(), written);
  const Rig old = read_by(kLists, base);
  Rig rig = old;
  Change change = change_one_fact(rig);
  if (change.fact.kind == FactKind::kPose) change.fact.pose = &old.poses[change.camera];
  const text::Document edited = schema::edited(base, {kLists, old}, {kLists, rig}, written);
  const text::Node* place = schema::place_of(kLists, base, old, change.camera, change.fact);
  RC_ASSERT(place != nullptr);
  RC_ASSERT(edited.edited_spans() == std::vector<text::Span>{place->span});
  const Rig back = read_by(kLists, document_of(edited.bytes(), "test.json"));
  RC_ASSERT(largest_pose_difference(rig, back) <= 1e-14);
  RC_ASSERT(back.imus == rig.imus);
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    RC_ASSERT(back.cameras[i].model == rig.cameras[i].model);
    RC_ASSERT(back.cameras[i].image_size == rig.cameras[i].image_size);
    RC_ASSERT(std::abs(*back.cameras[i].time_offset_s - *rig.cameras[i].time_offset_s) <= 1e-15);
  }
}

RC_GTEST_PROP(Schema, ARigThatIsTheSameEditsNothing, ()) {
  Written written;
  const text::Document base = fresh(kLists, random_rig(), written);
  const Rig rig = read_by(kLists, base);
  RC_ASSERT(!schema::edited(base, {kLists, rig}, {kLists, rig}, written).edited());
}

// What differs by less than rounding is no other rotation.
RC_GTEST_PROP(Schema, AnotherRotationEditsItsQuaternion, ()) {
  Written written;
  const text::Document base = fresh(kLists, random_rig(), written);
  const Rig old = read_by(kLists, base);
  Rig rig = old;
  Transform& T = rig.poses.front().T_a_b;
  T = pose_of(quaternion_of(random_pose()), translation_of(T));
  const text::Document edited = schema::edited(base, {kLists, old}, {kLists, rig}, written);
  RC_ASSERT(edited.edited_spans().size() <= 4U);
  RC_ASSERT(largest_pose_difference(rig, read_by(kLists, document_of(edited.bytes(), "test.json"))) <= 1.1e-12);
}

// Of another lens the name and all its numbers are other ones; a key that only that lens has comes and goes with it.
TEST(Schema, AnotherLensTakesTheOnesPlace) {
  Written written;
  const Rig old = sample_rig("ds", {.imu = true});
  const text::Document base = fresh(kLists, old, written);
  const Rig there = read_by(kLists, base);
  Rig rig = there;
  rig.cameras.front().model =
      model_of("rational", {458.6, 457.3, 367.2, 248.4, -0.28, 0.07, 0.0002, 0.00002, 0.001, 0.01, 0.002, 0.0005});
  const text::Document limited =
      document_of(schema::edited(base, {kLists, there}, {kLists, rig}, written).bytes(), "test.json");
  EXPECT_NE(limited.bytes().find("\"limit\": -1.0"), std::string::npos);
  EXPECT_EQ(read_by(kLists, limited).cameras, rig.cameras);
  EXPECT_EQ(schema::edited(limited, {kLists, rig}, {kLists, there}, written).bytes(), base.bytes());
}

TEST(Schema, WhatNobodyStatesIsMadeUpAndListed) {
  Rig rig = sample_rig("ds", {.two = true});
  rig.imus.clear();
  rig.poses.clear();
  Written written;
  const Rig back = read_by(kLists, fresh(kLists, rig, written));
  std::vector<std::string> keys;
  for (const DefaultedValue& value : written.defaults) keys.push_back(value.key);
  EXPECT_EQ(keys, (std::vector<std::string>{"cam0 pose", "cam1 pose", "noise", "rate"}));
  EXPECT_EQ(back.imus.front().gyroscope_noise_density, 0.25);
  EXPECT_EQ(back.imus.front().rate_hz, 100.0);
}

std::vector<Code> losses_of(const Schema& schema, const Rig& rig) {
  std::vector<Loss> losses;
  schema::list_losses(schema, rig, Message{Code::kBasaltNoPlace}, losses);
  std::vector<Code> codes;
  for (const Loss& loss : losses) codes.push_back(loss.kind);
  return codes;
}

TEST(Schema, WhatTheTableHasNoKeyForIsALoss) {
  Rig rig = sample_rig("ds", {.imu = true});
  Camera& camera = rig.cameras.front();
  camera.topic = "/cam0";
  camera.frame_rate_hz = 30.0;
  camera.time_offset_s = 0.25;
  rig.imus.front().topic = "/imu0";
  rig.imus.push_back(rig.imus.front());
  rig.baseline_m = 0.1;
  EXPECT_EQ(losses_of(kLists, rig), (std::vector{Code::kTopicDropped, Code::kFrameRateDropped, Code::kTopicDropped,
                                                 Code::kBasaltImuDropped, Code::kBaselineDropped}));
  EXPECT_EQ(losses_of(kOne, rig), (std::vector{Code::kTimeOffsetDropped, Code::kTopicDropped, Code::kFrameRateDropped,
                                               Code::kImuDropped, Code::kImuDropped, Code::kBaselineDropped}));
}

// What a row rounds it says.
TEST(Schema, AnOffsetFinerThanTheUnitIsALoss) {
  Rig rig = sample_rig("ds", {});
  rig.cameras.front().topic.clear();
  rig.cameras.front().time_offset_s = 0.25;
  EXPECT_TRUE(losses_of(kLists, rig).empty());
  rig.cameras.front().time_offset_s = 0.2500000001;
  EXPECT_EQ(losses_of(kLists, rig), std::vector{Code::kBasaltOffsetRounded});
}

RC_GTEST_PROP(Schema, OneCameraKeyByKey, ()) {
  Rig rig;
  Camera& camera = rig.cameras.emplace_back();
  camera.name = "left";
  camera.image_size = ImageSize{*rc::gen::inRange(1, 9000), *rc::gen::inRange(1, 9000)};
  camera.model =
      model_of("pinhole", {random_in(1.0, 900.0), random_in(1.0, 900.0), random_in(0.0, 900.0), random_in(0.0, 900.0)});
  Written written;
  const text::Document document = fresh(kOne, rig, written);
  const Rig back = read_by(kOne, document);
  RC_ASSERT(back.cameras == rig.cameras);
  RC_ASSERT(document.bytes().find("\"h\": " + std::to_string(camera.image_size->height) + ".0") != std::string::npos);
  Rig wider = rig;
  ++wider.cameras.front().image_size->width;
  const text::Document edited = schema::edited(document, {kOne, rig}, {kOne, wider}, written);
  const text::Node* width = schema::place_of(kOne, document, rig, 0, {.kind = FactKind::kImageSize, .row = 0});
  RC_ASSERT(width != nullptr);
  RC_ASSERT(edited.edited_spans() == std::vector<text::Span>{width->span});
}

TEST(Schema, KeysThatNoRowReadsAreKept) {
  const text::Document document = document_of(
      R"({"lens": {"f": 1, "f_v": 1.0, "c": 0, "c_v": 0, "age": [1, 2]}, "w": 2, "h": 3, "place": "roof"})", "test.json");
  const Rig rig = read_by(kOne, document);
  EXPECT_EQ(rig.extra_fields, (std::vector<ExtraField>{{"", "place", "roof"}, {"", "lens.age", "[1, 2]"}}));
}

TEST(Schema, AMisspeltKeyIsSaid) {
  Written written;
  const std::string bytes = fresh(kLists, sample_rig("ds", {.imu = true}), written).bytes();
  const text::Document document = document_of(with_replaced(bytes, "\"noise\"", "\"niose\""), "test.json");
  Diagnostics diagnostics;
  const std::optional<Rig> rig = schema::read(kLists, std::span(&document, 1), {}, diagnostics);
  ASSERT_TRUE(rig);
  EXPECT_FALSE(rig->imus.front().gyroscope_noise_density);
  ASSERT_EQ(diagnostics.entries().size(), 1U);
  EXPECT_EQ(id_of(diagnostics.entries().front()), "key-misspelt");
}

RC_GTEST_PROP(Schema, APoseInLists, ()) {
  constexpr static std::array kKeys = {schema::pose("pose", kByLists)};
  constexpr static Schema kSchema = {
      .what = "a test", .dialect = text::Dialect::kPyYaml, .root = {.keys = kKeys}, .codes = {}, .one_camera = true};
  Rig rig;
  rig.cameras.emplace_back().name = "cam0";
  rig.poses.push_back({"vehicle", "cam0", random_pose()});
  Written written;
  const text::Document document = fresh(kSchema, rig, written);
  RC_ASSERT(document.root().entries.front().value.entries.front().key.value == "rotation");
  Rig moved = rig;
  moved.poses.front().T_a_b(2, 3) += 0.5;
  const text::Document edited = schema::edited(document, {kSchema, rig}, {kSchema, moved}, written);
  const text::Node* place =
      schema::place_of(kSchema, document, rig, 0, {.kind = FactKind::kPose, .pose = &rig.poses.front(), .row = 2, .column = 3});
  RC_ASSERT(place != nullptr);
  RC_ASSERT(edited.edited_spans() == std::vector<text::Span>{place->span});
}

}  // namespace
}  // namespace fca::test
