// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>

namespace fca {

namespace {

/// Another value of the same size: far enough that every writer sees a difference, near enough that none refuses it, and a
/// float, for which a matrix of floats (dt: f) need not become one of doubles.
double nudged(double value) { return static_cast<double>(static_cast<float>(value == 0.0 ? 1e-6 : value * (1.0 + 1e-6))); }

/// The first number of the tree that reads so.
const text::Node* number_reading(const text::Node& node, double value) {
  if (node.is_scalar() && text::parse_real(node.value) == value) return &node;
  for (const text::Node& item : node.items) {
    if (const text::Node* found = number_reading(item, value)) return found;
  }
  for (const text::Entry& entry : node.entries) {
    if (const text::Node* found = number_reading(entry.value, value)) return found;
  }
  return nullptr;
}

std::size_t count_reading(const text::Node& node, double value) {
  std::size_t count = node.is_scalar() && text::parse_real(node.value) == value ? 1 : 0;
  for (const text::Node& item : node.items) count += count_reading(item, value);
  for (const text::Entry& entry : node.entries) count += count_reading(entry.value, value);
  return count;
}

bool holds(const text::Span& span, std::size_t offset) { return offset >= span.offset && offset < span.end(); }

}  // namespace

const text::Node* node_at(const text::Node& root, std::size_t offset) {
  for (const text::Node& item : root.items) {
    if (const text::Node* found = node_at(item, offset)) return found;
  }
  for (const text::Entry& entry : root.entries) {
    for (const text::Node* node : {&entry.key, &entry.value}) {
      if (const text::Node* found = node_at(*node, offset)) return found;
    }
  }
  return holds(root.span, offset) ? &root : nullptr;
}

std::vector<text::Span> Places::edits_for(const Rig& rig) const {
  if (!calibration_->format->is_written()) return {};
  Diagnostics ignored;
  const std::optional<Written> written = calibration_->format->write(document_, rig, {}, ignored);
  for (const Written::File& file : written ? written->files : std::vector<Written::File>()) {
    if (file.document.source().bytes == document_->source().bytes) return file.document.edited_spans();
  }
  return {};
}

SourceRange Places::of(const std::function<void(Rig&)>& change, std::optional<double> value) const {
  const SourceRange nowhere = {document_->source().name, 0, 0};
  Rig changed = calibration_->rig;
  change(changed);
  // A rig of hundreds of cameras with as many findings would take minutes; the largest real one has 80.
  constexpr std::size_t kMostSearched = 32;
  constexpr int kMostAsked = 100;
  const bool ask = changed.cameras.size() <= kMostSearched && asked_++ < kMostAsked;
  if (!anyway_) anyway_ = ask ? edits_for(calibration_->rig) : std::vector<text::Span>();
  std::vector<text::Span> spans = ask ? edits_for(changed) : std::vector<text::Span>();
  std::erase_if(spans, [this](const text::Span& span) { return std::ranges::find(*anyway_, span) != anyway_->end(); });
  std::ranges::sort(spans, {}, &text::Span::offset);
  const text::Node* first = nullptr;
  for (const text::Span& span : spans) {
    const text::Node* node = node_at(document_->root(), span.offset);
    if (node == nullptr || !node->is_scalar()) continue;
    // A changed lens may bring keys that stood nowhere before: their place is a neighbour's.
    if (value && text::parse_real(node->value) == value) return document_->range(*node);
    if (first == nullptr) first = node;
  }
  // Two cameras may have the same number.
  if (!ask && value && count_reading(document_->root(), *value) > 1) return nowhere;
  const text::Node* same = value ? number_reading(document_->root(), *value) : nullptr;
  if (first == nullptr || (same != nullptr && !text::parse_real(first->value))) first = same;
  return first != nullptr ? document_->range(*first) : nowhere;
}

std::optional<SourceRange> Places::by_table(std::string_view camera, const schema::Fact& fact) const {
  const schema::Schema* table = calibration_->format->table;
  if (table == nullptr || calibration_->documents.size() != 1) return std::nullopt;
  const std::vector<Camera>& cameras = calibration_->rig.cameras;
  const auto index = static_cast<std::size_t>(std::ranges::find(cameras, camera, &Camera::name) - cameras.begin());
  if (index == cameras.size() && fact.kind != schema::FactKind::kImu) return std::nullopt;
  const text::Node* node = schema::place_of(*table, *document_, calibration_->rig, index, fact);
  return node != nullptr ? std::optional(document_->range(*node)) : std::nullopt;
}

SourceRange Places::parameter(const Camera& camera, ParameterId id) const {
  if (const auto place = by_table(camera.name, {.kind = schema::FactKind::kParameter, .parameter = id.name()})) return *place;
  return of(
      [&](Rig& rig) {
        const auto same = std::ranges::find(rig.cameras, camera.name, &Camera::name);
        if (same == rig.cameras.end()) return;
        if (const std::optional<double> value = fca::parameter(same->model, id)) set_parameter(same->model, id, nudged(*value));
      },
      fca::parameter(camera.model, id));
}

SourceRange Places::image_width(const Camera& camera) const {
  if (const auto place = by_table(camera.name, {schema::FactKind::kImageSize})) return *place;
  return of(
      [&](Rig& rig) {
        const auto same = std::ranges::find(rig.cameras, camera.name, &Camera::name);
        if (same != rig.cameras.end() && same->image_size) ++same->image_size->width;
      },
      camera.image_size ? std::optional<double>(camera.image_size->width) : std::nullopt);
}

SourceRange Places::time_offset(const Camera& camera) const {
  if (const auto place = by_table(camera.name, {schema::FactKind::kTimeOffset})) return *place;
  return of(
      [&](Rig& rig) {
        const auto same = std::ranges::find(rig.cameras, camera.name, &Camera::name);
        if (same != rig.cameras.end() && same->time_offset_s) same->time_offset_s = nudged(*same->time_offset_s);
      },
      camera.time_offset_s);
}

SourceRange Places::pose(std::size_t index, int row, int column) const {
  const PoseEdge& edge = calibration_->rig.poses[index];
  const schema::Fact fact = {.kind = schema::FactKind::kPose, .pose = &edge, .row = row, .column = column};
  for (const std::string& camera : {edge.b, edge.a}) {
    if (const auto place = by_table(camera, fact)) return *place;
  }
  return of(
      [&](Rig& rig) {
        double& element = rig.poses[index].T_a_b(row, column);
        element = nudged(element);
      },
      calibration_->rig.poses[index].T_a_b(row, column));
}

SourceRange Places::imu(std::optional<double> Imu::*member) const {
  if (const auto place = by_table("", {.kind = schema::FactKind::kImu, .imu = member})) return *place;
  return of(
      [&](Rig& rig) {
        if (!rig.imus.empty() && rig.imus.front().*member) rig.imus.front().*member = nudged(*(rig.imus.front().*member));
      },
      calibration_->rig.imus.empty() ? std::nullopt : calibration_->rig.imus.front().*member);
}

SourceRange Places::baseline() const {
  return of(
      [](Rig& rig) {
        if (rig.baseline_m) rig.baseline_m = nudged(*rig.baseline_m);
      },
      calibration_->rig.baseline_m);
}

}  // namespace fca
