// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/rig.h>

#include "frame_graph.h"

#include <algorithm>

namespace fca {

std::string with_owner(const ExtraField& field) { return field.owner.empty() ? field.key : field.owner + " " + field.key; }

std::string_view Camera::lens_id() const { return rays.empty() ? model_info(model).id : "rays"; }

std::string_view Camera::lens_title() const { return rays.empty() ? model_info(model).title : "table of rays"; }

const Camera* Rig::find_camera(std::string_view name) const {
  const auto found = std::ranges::find(cameras, name, &Camera::name);
  return found == cameras.end() ? nullptr : &*found;
}

std::string Rig::unused_name(const std::string& name) const {
  std::string unused = name;
  for (int i = 2; find_camera(unused) != nullptr; ++i) unused = name + "_" + std::to_string(i);
  return unused;
}

const ExtraField* Rig::find_extra_field(std::string_view owner, std::string_view key) const {
  const auto found =
      std::ranges::find_if(extra_fields, [&](const ExtraField& field) { return field.owner == owner && field.key == key; });
  return found == extra_fields.end() ? nullptr : &*found;
}

const Uncertainty* Rig::find_uncertainty(std::string_view camera) const {
  const Uncertainty* found = nullptr;
  for (const Uncertainty& each : uncertainties) {
    if (each.camera != camera || each.sigmas.empty()) continue;
    if (found == nullptr || (each.has_covariance() && !found->has_covariance())) found = &each;
  }
  return found;
}

FrameKind Rig::kind_of(std::string_view frame) const {
  if (find_camera(frame) != nullptr) return FrameKind::kCamera;
  if (std::ranges::find(imus, frame, &Imu::name) != imus.end()) return FrameKind::kImu;
  const auto found = std::ranges::find(frames, frame, &Frame::name);
  return found == frames.end() ? FrameKind::kOther : found->kind;
}

void Rig::add_frame(std::string_view name, FrameKind kind) {
  if (std::ranges::find(frames, name, &Frame::name) == frames.end()) frames.push_back({std::string(name), kind});
}

const Transform* Rig::stated(std::string_view a, std::string_view b) const {
  const auto found = std::ranges::find_if(poses, [&](const PoseEdge& edge) { return edge.a == a && edge.b == b; });
  return found == poses.end() ? nullptr : &found->T_a_b;
}

std::optional<Transform> Rig::resolve(std::string_view a, std::string_view b) const {
  if (a == b) return Transform{};
  const internal::FrameGraph graph(poses);
  const std::optional<std::size_t> from = graph.find(a);
  const std::optional<std::size_t> to = graph.find(b);
  return from && to ? graph.from(*from, to).at(*to) : std::nullopt;
}

}  // namespace fca
