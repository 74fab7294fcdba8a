// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"
#include "woodscape.h"

#include "../fields.h"
#include "../losses.h"
#include "../one_camera_files.h"

#include <fca/code.h>
#include <fca/formats/file_name.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>

namespace fca::woodscape {

using fields::Field;
using text::Node;

namespace {

/// The keys of intrinsic in their order, which omnidet depends on.
std::vector<Field> intrinsic_fields(const Camera& camera) {
  const auto value = [&camera](ParameterId id) { return parameter(camera.model, id).value(); };
  return {fields::real("aspect_ratio", value("aspect_ratio")),
          fields::real("cx_offset", offset_of(value("cx"), camera.image_size->width)),
          fields::real("cy_offset", offset_of(value("cy"), camera.image_size->height)),
          fields::real("height", camera.image_size->height),
          fields::real("k1", value("k1")),
          fields::real("k2", value("k2")),
          fields::real("k3", value("k3")),
          fields::real("k4", value("k4")),
          fields::quoted("model", "radial_poly"),
          fields::integer("poly_order", 4),
          fields::real("width", camera.image_size->width)};
}

std::vector<Field> extrinsic_fields(const Transform& T) {
  return {fields::list("quaternion", quaternion_of(T)), fields::list("translation", translation_of(T))};
}

/// The dataset's own layout: two blanks deeper per level, one number per line.
std::string compose(const Camera& camera, const Transform& T) {
  const auto members = [](const std::vector<Field>& fields) {
    std::string text;
    for (const Field& field : fields) {
      text += (text.empty() ? "" : ",") + std::string("\n    \"") + field.key + "\": ";
      if (field.shape == fields::Shape::kScalar) {
        text += field.tokens.front();
        continue;
      }
      for (std::size_t i = 0; i < field.tokens.size(); ++i) text += (i == 0 ? "[\n      " : ",\n      ") + field.tokens[i];
      text += "\n    ]";
    }
    return text;
  };
  const Field name = fields::quoted("name", camera.name);
  return "{\n  \"extrinsic\": {" + members(extrinsic_fields(T)) + "\n  },\n  \"intrinsic\": {" +
         members(intrinsic_fields(camera)) + "\n  },\n  " + fields::spell(name, 0, text::Syntax::kJson) + "\n}\n";
}

/// Number by number: to Python 3 and 3.0 are one, and what has not changed keeps its spelling.
void edit_translation(text::Document& document, const Node& list, const std::array<double, 3>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Node& number = list.items.at(i);
    if (text::parse_real(number.value) != values.at(i)) document.replace(number.span, text::format_real(values.at(i)));
  }
}

/// What the file says; zeros where it says none.
Quaternion stated_quaternion(const Node& extrinsic) {
  const Node* list = text::find(extrinsic, "quaternion", text::Dialect::kPyYaml);
  Quaternion q{};
  for (std::size_t i = 0; list != nullptr && i < std::min(q.size(), list->items.size()); ++i)
    q.at(i) = text::parse_real(list->items[i].value).value_or(0.0);
  return q;
}

/// Takes the base from saying `old` to saying `camera` at that pose. Its own name and, where the rotation is the same, its own
/// quaternion stay.
text::Document edited(const text::Document& base, const Rig& old, const Camera& camera, const std::optional<Transform>& pose) {
  text::Document document = base;
  constexpr text::Dialect kDialect = text::Dialect::kPyYaml;
  const Node& root = document.root();
  const Camera& before = old.cameras.front();
  const Node* intrinsic = text::find(root, "intrinsic", kDialect);
  fields::apply(document, *intrinsic, kDialect, intrinsic_fields(before), intrinsic_fields(camera));

  const Transform* stated = old.stated(kVehicle, before.name);
  if (!pose || (stated != nullptr && *stated == *pose)) return document;
  const text::Entry* extrinsic = text::find_entry(root, "extrinsic", kDialect);
  std::vector<Field> from = stated != nullptr ? extrinsic_fields(*stated) : std::vector<Field>();
  std::vector<Field> to = extrinsic_fields(*pose);
  constexpr double kSameRotation = 1e-12;
  if (stated != nullptr && largest_difference(*stated, *pose).distance <= kSameRotation) to.front() = from.front();
  if (stated != nullptr && to.front().tokens != from.front().tokens)
    to.front() = fields::list("quaternion", signed_as(quaternion_of(*pose), stated_quaternion(extrinsic->value)));
  if (stated != nullptr) {
    edit_translation(document, *text::find(extrinsic->value, "translation", kDialect), translation_of(*pose));
    from.pop_back();
    to.pop_back();
  }
  if (extrinsic != nullptr && extrinsic->value.is_mapping() && !extrinsic->value.entries.empty()) {
    fields::apply(document, extrinsic->value, kDialect, from, to);
  } else if (extrinsic == nullptr) {
    const std::string keys = fields::spell(to[0], 0, text::Syntax::kJson) + ", " + fields::spell(to[1], 0, text::Syntax::kJson);
    document.insert_after(root, root.entries.front(), "\"extrinsic\": {" + keys + "}");
  }
  return document;
}

/// CARLA's translation is the same pose in another frame: beside a new one it no longer holds.
void list_stale_translation(const text::Document& base, const Rig& old, const std::string& camera, const Transform& pose,
                            std::vector<Loss>& losses) {
  const Transform* stated = old.stated(kVehicle, camera);
  if (stated != nullptr && *stated == pose) return;
  const Node* extrinsic = text::find(base.root(), "extrinsic", text::Dialect::kPyYaml);
  if (extrinsic == nullptr || text::find(*extrinsic, kCarlaTranslation, text::Dialect::kPyYaml) == nullptr) return;
  losses.push_back(lost(Code::kWoodscapeStaleTranslation, camera, std::string(kCarlaTranslation)));
}

/// What the input says beside its rig and the file, which says `there`, does not.
void list_extras(std::span<const ExtraField> extras, std::span<const ExtraField> there, std::vector<Loss>& losses) {
  std::vector<ExtraField> others(extras.begin(), extras.end());
  const auto halves = std::stable_partition(others.begin(), others.end(), [](const ExtraField& extra) {
    return !extra.key.ends_with("extrinsic.quaternion") && !extra.key.ends_with("extrinsic.translation");
  });
  const auto count = static_cast<std::size_t>(halves - others.begin());
  add_beyond_base(std::span(others).first(count), there, Message{Code::kWoodscapeJsonNoPlace}, losses);
  add_beyond_base(std::span(others).subspan(count), there, Message{Code::kWoodscapeJsonHalfAPose}, losses);
}

/// The frame that stands for the vehicle: its own, else the first camera's. Identities for all would state that they sit in one
/// place.
std::string reference_frame(const Rig& rig) {
  const bool in_vehicle =
      std::ranges::any_of(rig.cameras, [&rig](const Camera& camera) { return rig.resolve(kVehicle, camera.name).has_value(); });
  return in_vehicle ? std::string(kVehicle) : rig.cameras.front().name;
}

}  // namespace

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  const Message size_use = {Code::kWoodscapeJsonCentreFromMiddle};
  if (!writable_alone(kFormat, rig, size_use, diagnostics)) return std::nullopt;

  Diagnostics ignored;
  const std::optional<Rig> old = base != nullptr && !options.anew ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  Written written;
  const std::string frame = reference_frame(rig);
  for (const Camera& camera : rig.cameras) {
    const bool of_base = is_camera_of(old, rig, camera);
    const std::string_view parent = of_base ? kVehicle : std::string_view(frame);
    const Transform* stated = rig.stated(parent, camera.name);
    const std::optional<Transform> pose = stated != nullptr ? *stated : rig.resolve(parent, camera.name);
    std::optional<text::Document> document;
    std::vector<std::string> programs = {"woodscape"};
    if (of_base) {
      document = edited(*base, *old, camera, pose);
      // SynWoodScape's JSONs, for one, belong to other programs: no pose is made up to please this one.
      if (document->edited() && !pose) programs.clear();
      if (pose && document->edited()) list_stale_translation(*base, *old, camera.name, *pose, written.losses);
    } else {
      document = fresh_file(kFormat, camera, {as_file_name(camera.name) + ".json", compose(camera, pose.value_or(Transform{}))},
                            diagnostics);
      if (frame != kVehicle || !pose) {
        const bool known = pose && frame != camera.name;
        const Message value = known ? Message{Code::kOpenvinsChainPoseInFrame, {frame}} : Message{Code::kIdentity};
        written.defaults.push_back({camera.name + " extrinsic", Message{Code::kWoodscapeJsonPoseMadeUp, {value}}, true, true});
      }
    }
    if (!document) return std::nullopt;
    written.files.push_back({*std::move(document), {camera.name}, std::move(programs)});
  }
  list_camera_losses(rig, "WoodScape", written.losses);
  list_extras(rig.extra_fields, old ? std::span<const ExtraField>(old->extra_fields) : std::span<const ExtraField>(),
              written.losses);
  if (const std::optional<Rig> replaced =
          base != nullptr && options.anew ? read(std::span(base, 1), {}, ignored) : std::nullopt)
    add_not_carried(extras_beyond(replaced->extra_fields, rig.extra_fields), Message{Code::kComposedAnew}, written.losses);
  const bool for_projection_py =
      std::ranges::none_of(written.files, [](const Written::File& file) { return file.programs.empty(); });
  written.headline = {!for_projection_py        ? Code::kWoodscapeJsonHeadlineNoPose
                      : rig.cameras.size() == 1 ? Code::kWoodscapeJsonHeadline
                                                : Code::kWoodscapeJsonHeadlineEach};
  return written;
}

}  // namespace fca::woodscape
