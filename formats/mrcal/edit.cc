// SPDX-License-Identifier: BSD-3-Clause
// A camera as text: fresh, and in a file that specifies another.
#include "layout.h"

#include "../spelling.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/rig/rotation.h>

#include <algorithm>

namespace fca::mrcal {

using fields::Field;
using text::Node;

namespace {

constexpr double kRounding = 1e-9;       ///< Up to here a rotation and that of its vector are the same.
constexpr double kSameRotation = 1e-12;  ///< Elements of two rotations that differ by less say the same.

/// A rotation vector says a rotation only; a matrix printed with few digits is not quite one.
void list_restated(const std::string& frame, const Camera& camera, const Transform& T, Written& written) {
  const Transform said = pose_of(rt_of(T));
  if (largest_difference(said, T).distance <= kRounding) return;
  written.restated.push_back({camera.name, frame, said});
  written.losses.push_back(lost(Code::kPoseRecomputed, camera.name, std::string(kPoseKeys.back()), {frame}));
}

Field size_field(const ImageSize& size) {
  Field field;
  field.key = kImageSize;
  field.shape = fields::Shape::kList;
  field.tokens = {std::to_string(size.width), std::to_string(size.height)};
  return field;
}

/// What the file specifies under a key for the pose; nothing where it has no such key.
std::optional<std::array<double, 6>> stated_under(const Node& root, std::string_view key) {
  const Node* node = text::find(root, key, kDialect);
  if (node == nullptr) return std::nullopt;
  std::array<double, 6> rt{};
  for (std::size_t i = 0; i < std::min(rt.size(), node->items.size()); ++i)
    rt.at(i) = text::parse_real(node->items[i].value).value_or(0.0);
  return rt;
}

/// As the key that counts says it.
const Node* lens_node(const Node& root, std::string_view& key) {
  for (const std::string_view each : kLensKeys) {
    key = each;
    if (const Node* node = text::find(root, each, kDialect)) return node;
  }
  return nullptr;
}

/// The new pose next to those numbers of the old one that specify the same.
std::array<double, 6> moved(const std::array<double, 6>& there, const Transform& now) {
  std::array<double, 6> rt = rt_of(now);
  if (largest_difference(pose_of(there), now).distance <= kSameRotation) std::copy_n(there.begin(), 3, rt.begin());
  return rt;
}

/// Is any camera's place to another, or in the frame, known? Else each file is of a camera alone, at its own origin, and joined
/// they specify no pose.
bool has_poses(const Rig& rig, const std::string& frame) {
  return std::ranges::any_of(rig.cameras, [&rig, &frame](const Camera& camera) {
    return camera.name != frame && pose_in(frame, rig, camera).has_value();
  });
}

void list_stale(const Rig& old, std::vector<Loss>& losses) {
  for (const std::string_view key : {kInputs, kRegion}) {
    const std::string& owner = old.cameras.front().name;
    if (old.find_extra_field(owner, key) != nullptr) losses.push_back(lost(Code::kMrcalStale, owner, std::string(key)));
  }
}

}  // namespace

text::Document edited(const text::Document& base, const Rig& old, const Rig& rig, const Camera& camera, Written& written) {
  text::Document document = base;
  const Node& root = document.root();
  const Camera& before = old.cameras.front();
  std::vector<Field> from;
  std::vector<Field> to;
  if (camera.rays.empty()) {
    std::string_view lens_key;
    const LensModel& there = *find_lens(lens_node(root, lens_key)->value);
    const LensModel& lens = lens_for(camera.model, &there);
    from = {fields::quoted(std::string(lens_key), there.name), intrinsics_field(before.model, there)};
    to = {fields::quoted(std::string(lens_key), lens.name), intrinsics_field(camera.model, lens)};
  }
  if (before.model != camera.model) list_stale(old, written.losses);
  // Of a camera alone what the file says of its place goes on to be said.
  const std::string frame = reference_of(rig);
  const bool has_frame = frame == kReference || rig.cameras.size() > 1;
  const std::optional<Transform> now = has_frame ? pose_in(frame, rig, camera) : std::nullopt;
  if (now && old.poses.front().T_a_b != *now) {
    list_restated(frame, camera, *now, written);
    for (const std::string_view key : kPoseKeys) {
      const std::optional<std::array<double, 6>> rt = stated_under(root, key);
      if (!rt) continue;
      from.push_back(fields::list(std::string(key), *rt));
      to.push_back(fields::list(std::string(key), moved(*rt, *now)));
    }
  }
  from.push_back(size_field(*before.image_size));
  to.push_back(size_field(camera.image_size.value_or(*before.image_size)));
  fields::apply(document, root, kDialect, from, to);
  return document;
}

std::string composed(const Rig& rig, const Camera& camera, Written& written) {
  const LensModel& lens = lens_for(camera.model, nullptr);
  const std::string frame = reference_of(rig);
  const std::optional<Transform> T = pose_in(frame, rig, camera);
  if (T) {
    list_restated(frame, camera, *T, written);
  } else if (has_poses(rig, frame)) {
    written.defaults.push_back(
        {camera.name + " " + std::string(kPoseKeys.back()), Message{Code::kMrcalPoseUnknown, {frame}}, true, true});
  }
  const std::array<double, 6> rt = rt_of(T.value_or(Transform{}));
  constexpr std::size_t kIndentation = 4;
  const auto line = [](const Field& field) { return fields::spell(field, kIndentation, text::Syntax::kPython) + ","; };
  // As mrcal lays it out.
  return "{\n" + line(fields::quoted(std::string(kLensKeys.front()), lens.name)) + "\n\n" +
         "    # fx fy cx cy and OpenCV's distortion coefficients\n" + line(intrinsics_field(camera.model, lens)) + "\n\n" +
         "    # rotation vector and translation of the reference in the camera\n" +
         line(fields::list(std::string(kPoseKeys[0]), rt)) + "\n" + line(fields::list(std::string(kPoseKeys[1]), rt)) +
         "  # for mrcal before 2.5\n\n" + line(size_field(*camera.image_size)) + "\n}\n";
}

}  // namespace fca::mrcal
