// SPDX-License-Identifier: BSD-3-Clause
#include "camera_file.h"
#include "compose.h"
#include "config.h"
#include "scaramuzza.h"
#include "vins.h"

#include "../losses.h"
#include "../ocamcalib/ocamcalib.h"
#include "../one_camera_files.h"

#include <fca/code.h>
#include <fca/formats/file_name.h>

#include <algorithm>
#include <utility>

namespace fca::vins {

using fields::Field;
using text::Node;

namespace {

bool same_keys(const Section& a, const Section& b) {
  return std::ranges::equal(a.fields, b.fields, {}, &Field::key, &Field::key);
}

/// Does one inverse polynomial serve both? It knows neither centre nor size.
bool same_lens(const Camera& before, const Camera& after) {
  Camera moved = before;
  for (const ParameterId id : ParameterIds{"cx", "cy"}) set_parameter(moved.model, id, parameter(after.model, id).value());
  return moved.model == after.model;
}

/// Takes a camera file from saying `old` to saying `camera`.
class Editor {
 public:
  Editor(text::Document base, const Camera& old, const Camera& camera)
      : document_(std::move(base)), root_(document_.root()), old_(old), camera_(camera) {}

  text::Document run(Written& written, Diagnostics& diagnostics) {
    std::vector<Field> before = head_of(old_, "");
    std::vector<Field> after = head_of(camera_, "");
    const Node* type = text::find(root_, "model_type", kDialect);
    if (type != nullptr && after.front() == before.front())
      before.front() = after.front() = fields::scalar("model_type", type->value);
    for (std::vector<Field>* head : {&before, &after})
      std::erase_if(*head, [](const Field& field) { return field.key == "camera_name"; });
    fields::apply(document_, root_, kDialect, before, after);
    edit_sections(written, diagnostics);
    return std::move(document_);
  }

 private:
  void edit_sections(Written& written, Diagnostics& diagnostics) {
    const std::vector<double> stated = stated_inverse(document_);
    const bool lacks_inverse = is_scaramuzza(camera_) && stated.empty();
    if (old_.model == camera_.model && !lacks_inverse) return;
    const bool keeps_inverse = is_scaramuzza(camera_) && !stated.empty() && same_lens(old_, camera_);
    const std::vector<Section> from = sections_of(old_, stated);
    const std::vector<Section> to =
        sections_of(camera_, keeps_inverse ? stated : fitted_inverse(camera_, written, diagnostics));
    std::vector<Section> added;
    const text::Entry* behind = entry_before(from);
    for (const Section& section : to) {
      const auto was = std::ranges::find(from, section.name, &Section::name);
      const text::Entry* entry = was != from.end() ? text::find_entry(root_, section.name, kDialect) : nullptr;
      if (entry == nullptr || !same_keys(*was, section)) {
        added.push_back(section);
        continue;
      }
      insert(*behind, added);
      fields::apply(document_, entry->value, kDialect, was->fields, section.fields);
      behind = entry;
    }
    insert(*behind, added);
    for (const Section& section : from) {
      const auto now = std::ranges::find(to, section.name, &Section::name);
      if (now != to.end() && same_keys(section, *now)) continue;
      if (const text::Entry* entry = text::find_entry(root_, section.name, kDialect)) document_.remove_entry(root_, *entry);
    }
  }

  /// The entry before the first section, or the first one that is no section.
  const text::Entry* entry_before(const std::vector<Section>& sections) const {
    const text::Entry* result = nullptr;
    for (const text::Entry& entry : root_.entries) {
      const bool is_section = std::ranges::find(sections, entry.key.value, &Section::name) != sections.end();
      if (is_section && result != nullptr) return result;
      if (!is_section) result = &entry;
    }
    return result;
  }

  void insert(const text::Entry& behind, std::vector<Section>& sections) {
    for (const Section& section : sections) document_.insert_after(root_, behind, spelled(section, root_.flow));
    sections.clear();
  }

  text::Document document_;
  const Node& root_;
  const Camera& old_;
  const Camera& camera_;
};

/// What a camera file has no place for.
void list_losses(const Rig& rig, std::vector<Loss>& losses) {
  const Message no_place{Code::kVinsFilesHaveNoPlace};
  const std::size_t first = losses.size();
  for (const Camera& camera : rig.cameras) add_stream(camera, no_place, losses);
  for (Loss& loss : std::span(losses).subspan(first)) {
    if (loss.kind == Code::kTimeOffsetDropped) loss.kind = Code::kVinsTimeOffsetDropped;  // which can be had
  }
  for (const Imu& imu : rig.imus) losses.push_back(lost(Code::kVinsImuDropped, imu.name, "", {no_place}));
  if (rig.baseline_m) losses.push_back(lost(Code::kVinsBaselineDropped, "", "baseline", {*rig.baseline_m, no_place}));
}

/// An inverse polynomial that was read is no loss: the same lens has one fitted to it again.
void list_extras(const Rig& rig, const std::optional<Rig>& old, Written& written) {
  std::vector<ExtraField> extras = rig.extra_fields;
  std::erase_if(extras, [](const ExtraField& extra) { return extra.key == ocamcalib::kInverse; });
  add_beyond_base(extras, old ? old->extra_fields : std::vector<ExtraField>(), Message{Code::kVinsCameraFilesHaveNoPlace},
                  written.losses);
}

}  // namespace

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  if (base != nullptr && is_config(*base)) return write_config(*base, rig, diagnostics);
  if (!writable_alone(kFormat, rig, Message{Code::kVinsFilesStateSize}, diagnostics)) return std::nullopt;
  Diagnostics ignored;
  const std::optional<Rig> replaced = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  const std::optional<Rig> old = options.rewrite ? std::nullopt : replaced;
  Written written;
  for (const Camera& camera : rig.cameras) {
    std::optional<text::Document> document;
    if (is_camera_of(old, rig, camera)) {
      document = Editor(*base, old->cameras.front(), camera).run(written, diagnostics);
    } else {
      document = fresh_camera_file(camera, camera.name, as_file_name(camera.name) + ".yaml", written, diagnostics);
    }
    if (!document) return std::nullopt;
    written.files.push_back({*std::move(document), {camera.name}, {"vins"}});
  }
  list_losses(rig, written.losses);
  list_extras(rig, old, written);
  if (replaced && options.rewrite)
    add_not_carried(extras_beyond(replaced->extra_fields, rig.extra_fields), Message{Code::kFileRewritten}, written.losses);
  written.pose_remedy = {Code::kVinsIntoConfiguration};
  written.headline = {rig.cameras.size() == 1 ? Code::kVinsCameraFile : Code::kVinsCameraFiles};
  return written;
}

}  // namespace fca::vins
