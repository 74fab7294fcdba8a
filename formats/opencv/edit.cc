// SPDX-License-Identifier: BSD-3-Clause
#include "edit.h"

#include "blocks.h"
#include "names.h"
#include "opencv.h"

#include "../sibling.h"

#include <fca/code.h>

#include <algorithm>
#include <array>

namespace fca::opencv {

namespace {

using text::Entry;
using text::Node;

constexpr std::size_t kNew = static_cast<std::size_t>(-1);

/// Where each of the rig's cameras was in the base. Nothing if they stand in another order.
std::optional<std::vector<std::size_t>> places_in(const Rig& old, const Rig& rig) {
  if (old.cameras.size() == 1 && rig.cameras.size() == 1) return std::vector<std::size_t>{0};
  std::vector<std::size_t> places;
  std::size_t next = 0;
  bool any = false;
  for (const Camera& camera : rig.cameras) {
    const auto found = std::ranges::find(old.cameras, camera.name, &Camera::name);
    if (found == old.cameras.end()) {
      places.push_back(kNew);
      continue;
    }
    // New cameras stand after the old ones.
    const auto place = static_cast<std::size_t>(found - old.cameras.begin());
    if (place < next || (!places.empty() && places.back() == kNew)) return std::nullopt;
    places.push_back(place);
    next = place + 1;
    any = true;
  }
  if (!any) return std::nullopt;
  return places;
}

/// The keys a camera is to have; nothing if its mapping and the base's way of saying the model cannot hold it.
bool adapt_keys(const Base& base, const Camera& before, const Camera& after, CameraKeys& keys) {
  const Kind was = kind_of(before.model);
  const Kind is = kind_of(after.model);
  const std::string_view id = lens_id(after.model);
  if (!keys.radial.empty()) {
    if (id != "radtan" && id != "pinhole") return false;
    const bool tangential = id == "radtan" && (parameter(after.model, "p1") != 0.0 || parameter(after.model, "p2") != 0.0);
    return !tangential || !keys.tangential.empty();
  }
  if (keys.distortion.empty() && id != "pinhole")
    keys.distortion = keys.map.empty() ? distortion_key_for(keys.matrix) : "distortion_vector";
  if (keys.distortion.empty() && id != "pinhole") return false;
  if (was == is) return true;
  const ModelKey& model = keys.model.key.empty() ? base.layout.model : keys.model;
  if (keys.fisheye || (!model.key.empty() && !model.numeric)) return false;  // the file says so in other words
  if (is == Kind::kOmnidir && keys.xi.empty()) {
    if (keys.matrix != "camera_matrix" || !keys.map.empty()) return false;
    keys.xi = "xi";
  }
  return true;
}

class Editor {
 public:
  Editor(const Base& base, const Rig& rig, std::vector<std::size_t> places)
      : base_(base), rig_(rig), places_(std::move(places)), after_(base.layout), document_(base.document) {}

  /// Chooses the keys of the result; false, with a reason, if there are none.
  bool plan(Message& why) {
    const bool same_cameras = places_.size() == base_.rig.cameras.size() && std::ranges::find(places_, kNew) == places_.end();
    if (!same_cameras && !can_change_cameras()) {
      why = {Code::kOpencvOtherCameras};
      return false;
    }
    renumbered_ = !same_cameras;
    after_.cameras.clear();
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const std::size_t like = places_[i] == kNew ? sibling_of(i) : places_[i];
      CameraKeys keys = base_.layout.cameras[like];
      const Camera& before = base_.rig.cameras[like];
      if (places_[i] == kNew && keys.model.key.empty()) keys.model.key = "distortion_type";
      if (!adapt_keys(base_, before, rig_.cameras[i], keys)) {
        why = {Code::kOpencvKeysCannotHoldModel, {model_info(rig_.cameras[i].model).id}};
        return false;
      }
      if (needs_model_key(before, rig_.cameras[i], keys)) {
        if (keys.map.empty()) {
          after_.model = {"fisheye_model", true, std::nullopt, false};
        } else {
          keys.model = {"distortion_type", true, std::nullopt, false};
        }
      }
      if (begins_to_say_size(i, keys)) keys.size = {"img_width", "img_height", "", false};
      after_.cameras.push_back(std::move(keys));
    }
    if (begins_to_say_size()) after_.size = size_keys();
    if (!base_.layout.in_maps() && !one_kind()) {
      why = {Code::kOpencvOneKind};
      return false;
    }
    if (!base_.layout.in_maps() && !one_size()) {
      why = {Code::kOpencvOneSize};
      return false;
    }
    if (base_.layout.rotation_vector && pose_changes()) {
      why = {Code::kOpencvRotationVector};
      return false;
    }
    // A pair whose file holds no pose can begin to.
    if (after_.cameras.size() == 2 && after_.cameras.front().pose.empty() && after_.rotation.empty() &&
        after_.translation.empty()) {
      after_.rotation = "R";
      after_.translation = "T";
    }
    return true;
  }

  text::Document edited() {
    const Node& root = document_.root();
    const FieldMaker before(base_.rig, base_.layout, &base_.document);
    const FieldMaker after(rig_, after_, &base_.document);
    fields::apply(document_, root, kDialect, before.root(std::vector<bool>(base_.rig.cameras.size(), true)),
                  after.root(kept_lengths()));
    if (base_.layout.in_maps()) edit_maps(before, after);
    return std::move(document_);
  }

  /// What of the base no longer belongs to what the result says.
  [[nodiscard]] StaleKeys stale() const {
    StaleKeys stale;
    Changes any;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (places_[i] == kNew) continue;
      const Camera& before = base_.rig.cameras[places_[i]];
      const bool other_size =
          before.image_size && rig_.cameras[i].image_size && before.image_size != rig_.cameras[i].image_size;
      const Changes changes = {other_size || !same_lens(before.model, rig_.cameras[i].model), false};
      any.lens = any.lens || changes.lens;
      const std::string& map = base_.layout.cameras[places_[i]].map;
      if (!map.empty())
        stale.add(mapping_of(base_.document, base_.layout.cameras[places_[i]]), keys_of(base_.layout, map), changes, map + " ");
    }
    any.pose = base_.rig.stated("cam1", "cam0") != nullptr && rig_.cameras.size() == 2 && pose_changes();
    stale.add(base_.document.root(), keys_of(base_.layout, ""), any, "");
    return stale;
  }

  /// Does a reader still have to be told what four numbers are?
  [[nodiscard]] bool ambiguous() const {
    if (!base_.ambiguous || !after_.model.key.empty()) return false;
    for (std::size_t i = 0; i < rig_.cameras.size(); ++i) {
      const CameraKeys& keys = after_.cameras[i];
      if (keys.model.key.empty() && !keys.fisheye && kind_of(rig_.cameras[i].model) != Kind::kOmnidir) return true;
    }
    return false;
  }

  /// Of the result.
  [[nodiscard]] Layout layout() const {
    Layout result = after_;
    for (std::size_t i = 0; renumbered_ && i < result.cameras.size(); ++i)
      result.cameras[i].map = "camera_" + std::to_string(i);
    return result;
  }

 private:
  /// Whole cameras come and go where each has a mapping that nothing else speaks of.
  [[nodiscard]] bool can_change_cameras() const {
    if (!base_.layout.in_maps()) return false;
    for (std::size_t i = 0; i < base_.layout.cameras.size(); ++i) {
      if (base_.layout.cameras[i].map != "camera_" + std::to_string(i)) return false;
    }
    const bool renamed = std::ranges::any_of(places_, [this](const std::size_t& place) {
      return place != kNew && place != static_cast<std::size_t>(&place - places_.data());
    });
    // An XML element has its name twice: only what leaves the others' names alone is done there.
    return base_.document.syntax() != text::Syntax::kXml || !renamed;
  }

  [[nodiscard]] bool one_kind() const {
    const Kind kind = kind_of(rig_.cameras.front().model);
    return std::ranges::all_of(rig_.cameras, [kind](const Camera& camera) { return kind_of(camera.model) == kind; });
  }

  [[nodiscard]] bool one_size() const { return !base_.layout.size.stated() || sizes_agree(); }

  [[nodiscard]] bool sizes_agree() const {
    return std::ranges::all_of(rig_.cameras,
                               [this](const Camera& camera) { return camera.image_size == rig_.cameras.front().image_size; });
  }

  /// The base does not say how large images are, and the rig knows it of all cameras, or of one that has a mapping.
  [[nodiscard]] bool begins_to_say_size() const {
    return !base_.layout.in_maps() && !base_.layout.size.stated() && rig_.cameras.front().image_size && sizes_agree();
  }
  [[nodiscard]] bool begins_to_say_size(std::size_t i, const CameraKeys& keys) const {
    return base_.layout.in_maps() && !base_.layout.size.stated() && !keys.size.stated() && rig_.cameras[i].image_size;
  }

  /// In the spelling of the calibration sample that the base's other keys are of.
  [[nodiscard]] SizeKeys size_keys() const {
    if (base_.layout.cameras.front().matrix == "Camera_Matrix") return {"image_Width", "image_Height", "", false};
    return {"image_width", "image_height", "", false};
  }

  [[nodiscard]] bool pose_changes() const {
    const Transform* was = base_.rig.stated("cam1", "cam0");
    const Transform* stated = rig_.stated(rig_.cameras[1].name, rig_.cameras[0].name);
    const std::optional<Transform> is = stated != nullptr ? *stated : rig_.resolve(rig_.cameras[1].name, rig_.cameras[0].name);
    return was == nullptr || !is || *was != *is;
  }

  /// Must the result say what its four numbers are, and does the base not say it?
  [[nodiscard]] bool needs_model_key(const Camera& before, const Camera& after, const CameraKeys& keys) const {
    const ModelKey& model = keys.model.key.empty() ? base_.layout.model : keys.model;
    if (!model.key.empty() || keys.fisheye) return false;
    if (kind_of(after.model) == Kind::kFisheye && kind_of(before.model) != Kind::kFisheye) return true;
    if (!base_.ambiguous || kind_of(after.model) == Kind::kOmnidir) return false;
    // Its coefficients are new: then it is known what they are.
    const auto coefficients = [](const CameraModel& m) { return parameter_values(m).subspan(4); };
    return before.model.index() != after.model.index() ||
           !std::ranges::equal(coefficients(before.model), coefficients(after.model));
  }

  [[nodiscard]] bool keeps_length(std::size_t i) const {
    return places_[i] != kNew && kind_of(base_.rig.cameras[places_[i]].model) == kind_of(rig_.cameras[i].model);
  }

  [[nodiscard]] std::vector<bool> kept_lengths() const {
    std::vector<bool> kept;
    for (std::size_t i = 0; i < places_.size(); ++i) kept.push_back(keeps_length(i));
    return kept;
  }

  void edit_maps(const FieldMaker& before, const FieldMaker& after) {
    const Node& root = document_.root();
    const Entry* last = nullptr;
    for (std::size_t old = 0; old < base_.rig.cameras.size(); ++old) {
      const Entry* entry = text::find_entry(root, base_.layout.cameras[old].map, kDialect);
      const auto now = std::ranges::find(places_, old);
      last = entry;
      if (now == places_.end()) {
        document_.remove_entry(root, *entry);
        continue;
      }
      const auto index = static_cast<std::size_t>(now - places_.begin());
      if (index != old) rename(*entry, index);
      fields::apply(document_, entry->value, kDialect, before.map(old, base_.layout.cameras[old], true),
                    after.map(index, after_.cameras[index], keeps_length(index)));
    }
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (places_[i] == kNew) document_.insert_after(root, *last, like_sibling(before, i));
    }
  }

  void rename(const Entry& entry, std::size_t index) {
    std::string name = "camera_" + std::to_string(index);
    if (entry.key.quoted) name = '"' + name + '"';
    document_.replace(entry.key.span, name);
  }

  /// The camera of the base whose style a new one takes: of its kind, if there is one, and the last of those.
  [[nodiscard]] std::size_t sibling_of(std::size_t index) const {
    const Kind kind = kind_of(rig_.cameras[index].model);
    std::size_t sibling = base_.rig.cameras.size() - 1;
    for (std::size_t i = 0; i < base_.rig.cameras.size(); ++i) {
      if (kind_of(base_.rig.cameras[i].model) == kind) sibling = i;
    }
    return sibling;
  }

  [[nodiscard]] std::string like_sibling(const FieldMaker& before, std::size_t index) const {
    const std::size_t sibling = sibling_of(index);
    const CameraKeys& there = base_.layout.cameras[sibling];
    CameraKeys keys = after_.cameras[index];
    keys.map = there.map;  // in the base, to be laid out as what stands there
    const bool one_kind = kind_of(base_.rig.cameras[sibling].model) == kind_of(rig_.cameras[index].model);
    std::vector<fields::Field> from = before.map(sibling, there, true);
    std::vector<fields::Field> to = FieldMaker(rig_, after_, &base_.document).map(index, keys, one_kind);
    const auto add_group = [&there](const Rig& rig, const Camera& camera, std::vector<fields::Field>& fields) {
      const std::optional<ReferencePose> pose = reference_pose(rig, camera);
      // Without a pose it is of no group.
      if (!there.group.empty() && pose) fields.push_back(fields::integer(there.group, pose->group));
    };
    add_group(base_.rig, base_.rig.cameras[sibling], from);
    add_group(rig_, rig_.cameras[index], to);
    const Entry& entry = *text::find_entry(base_.document.root(), there.map, kDialect);
    return fields::like_sibling(base_.document, base_.document.root(), entry, kDialect, "camera_" + std::to_string(index), from,
                                to);
  }

  const Base& base_;
  const Rig& rig_;
  std::vector<std::size_t> places_;
  Layout after_;             ///< The keys of the base under which the result's are found or made.
  bool renumbered_ = false;  ///< Cameras come or go, and the others are counted again.
  text::Document document_;
};

}  // namespace

namespace {

/// A file as it reads. Where it does not say what its four numbers are, `fisheye` does, and `ambiguous` is set.
std::optional<Rig> read_anyhow(const text::Document& document, bool fisheye, bool& ambiguous) {
  Diagnostics ignored;
  std::optional<Rig> rig = read(std::span(&document, 1), {}, ignored);
  ambiguous = std::ranges::any_of(ignored.entries(), [](const Diagnostic& entry) {
    return entry.facts.code == Code::kOpencvAmbiguousModel || entry.facts.code == Code::kOpencvForeignModel;
  });
  if (rig || !ambiguous) return rig;
  ReadOptions options;
  options.opencv_model = fisheye ? OpenCvModel::kFisheye : OpenCvModel::kPinhole;
  return read(std::span(&document, 1), options, ignored);
}

}  // namespace

std::optional<Base> read_base(const text::Document& document, const Rig& rig) {
  const std::optional<Layout> layout = find_layout(document);
  if (!layout || layout->cameras.empty()) return std::nullopt;
  const bool fisheye =
      std::ranges::any_of(rig.cameras, [](const Camera& camera) { return kind_of(camera.model) == Kind::kFisheye; });
  bool ambiguous = false;
  std::optional<Rig> old = read_anyhow(document, fisheye, ambiguous);
  if (!old) return std::nullopt;
  return Base{document, *layout, *std::move(old), ambiguous};
}

std::vector<ExtraField> extras_of(const text::Document& document) {
  bool ambiguous = false;
  const std::optional<Rig> rig = read_anyhow(document, false, ambiguous);
  return rig ? rig->extra_fields : std::vector<ExtraField>();
}

std::optional<Edited> edit(const Base& base, const Rig& rig, Message& why) {
  std::optional<std::vector<std::size_t>> places = places_in(base.rig, rig);
  if (!places) {
    why = {Code::kOpencvOtherCameras};
    return std::nullopt;
  }
  Editor editor(base, rig, *std::move(places));
  if (!editor.plan(why)) return std::nullopt;
  text::Document document = editor.edited();
  return Edited{std::move(document), base.rig, editor.layout(), editor.stale(), editor.ambiguous()};
}

std::string name_of_layout(const Layout& layout) {
  if (layout.in_maps()) return "cameras";
  const bool omnidir = !layout.cameras.empty() && !layout.cameras.front().xi.empty();
  if (omnidir) return "omnidir";
  if (layout.cameras.size() < 2) return "calibration";
  return name_of(layout.cameras.front().matrix).side.starts_with("l") ? "left-right" : "stereo";
}

bool samples_read(const Layout& layout, const Rig& rig, bool told) {
  struct Known {
    std::string_view matrix;
    std::string_view distortion;
  };
  // formats/consumers/opencv.cc is written from the samples, independently of this.
  constexpr std::array<Known, 17> kKnown = {{{"camera_matrix", "distortion_coefficients"},
                                             {"camera_matrix", "dist_coeffs"},
                                             {"camera_matrix", "distortion_coeffs"},
                                             {"Camera_Matrix", "Distortion_Coefficients"},
                                             {"M1", "D1"},
                                             {"M2", "D2"},
                                             {"K1", "D1"},
                                             {"K2", "D2"},
                                             {"camera_matrix_1", "distortion_coefficients_1"},
                                             {"camera_matrix_2", "distortion_coefficients_2"},
                                             {"camera_matrix_left", "dist_coeffs_left"},
                                             {"camera_matrix_left", "distortion_coeffs_left"},
                                             {"camera_matrix_left", "distortion_coefficients_left"},
                                             {"camera_matrix_right", "dist_coeffs_right"},
                                             {"camera_matrix_right", "distortion_coeffs_right"},
                                             {"camera_matrix_right", "distortion_coefficients_right"},
                                             {"camera_matrix", "distortion_vector"}}};
  for (std::size_t i = 0; i < layout.cameras.size(); ++i) {
    const CameraKeys& keys = layout.cameras[i];
    const bool in_map = !keys.map.empty();
    if (in_map && (keys.map != "camera_" + std::to_string(i) || keys.distortion != "distortion_vector")) return false;
    const bool known = std::ranges::any_of(kKnown, [&keys](const Known& row) {
      return row.matrix == keys.matrix && (keys.distortion.empty() || row.distortion == keys.distortion);
    });
    if (!known || (!in_map && keys.distortion == "distortion_vector")) return false;
    const bool says_fisheye = in_map ? keys.model.key == "distortion_type" : layout.model.key == "fisheye_model";
    if (kind_of(rig.cameras[i].model) == Kind::kFisheye && !says_fisheye && !told) return false;
  }
  return !layout.cameras.empty();
}

}  // namespace fca::opencv
