// SPDX-License-Identifier: BSD-3-Clause
#include "camera_info.h"
#include "ini.h"
#include "rectification.h"
#include "ros.h"

#include "../losses.h"
#include "../one_camera_files.h"

#include <fca/code.h>
#include <fca/formats/file_name.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>
#include <fca/normalised_id.h>

#include <algorithm>
#include <array>

namespace fca::ros {

using fields::Field;
using text::Node;

namespace {

/// A word that YAML takes for text; else in quotes.
std::string spelled_name(const std::string& name) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_/-";
  // What YAML takes for something else than text.
  constexpr std::array<std::string_view, 7> kWords = {"null", "true", "false", "yes", "no", "on", "off"};
  const bool word = std::ranges::find(kWords, normalised_id(name)) != kWords.end();
  const bool plain = name.find_first_not_of(kPlain) == std::string::npos && !text::parse_real(name) && !name.empty() &&
                     name.front() != '-' && !word;
  return plain ? name : fields::quote(name);
}

std::vector<Field> matrix_fields(std::span<const double> values, int rows) {
  return {fields::integer("rows", rows), fields::integer("cols", static_cast<int>(values.size()) / rows),
          fields::list("data", values)};
}

std::string matrix_text(std::string_view key, std::span<const double> values, int rows) {
  std::string text = std::string(key) + ":";
  for (const Field& field : matrix_fields(values, rows)) text += "\n" + fields::spell(field, 2);
  return text;
}

/// A fresh file, in the order of ROS's own.
std::string compose(const Camera& camera, const Rectified& rectified) {
  return "image_width: " + std::to_string(camera.image_size->width) +
         "\nimage_height: " + std::to_string(camera.image_size->height) + "\ncamera_name: " + spelled_name(camera.name) + "\n" +
         matrix_text(kMatrix, camera_matrix_of(camera.model), 3) + "\ndistortion_model: " + std::string(name_of(camera.model)) +
         "\n" + matrix_text(kCoefficients, coefficients_of(camera.model), 1) + "\n" +
         matrix_text(kRectification, rectified.R, 3) + "\n" + matrix_text(kProjection, rectified.P, 3) + "\n";
}

/// A base that is to say another camera. `old` and `now` are of the images that are published.
class Editor {
 public:
  Editor(text::Document& document, const CameraInfo& info) : document_(document), info_(info) {}

  void run(const Camera& old, const Camera& now, const Rectified& before, const Rectified& after) {
    const bool other_images = now.image_size && old.image_size != now.image_size;
    Reduction reduction = info_.reduction;
    if (other_images) edit_size(*now.image_size, reduction);
    edit_camera_matrix(old.model, now.model, reduction);
    if (old.model != now.model) edit_coefficients(now.model);
    edit_matrix(kRectification, info_.R, before.R, after.R);
    edit_matrix(kProjection, info_.P, whole(before.P, old.model, info_.reduction), whole(after.P, now.model, reduction));
  }

 private:
  /// Is P of the same image as K? Then it goes with it.
  [[nodiscard]] bool is_rectified_as_it_is() const {
    if (!info_.P) return false;
    const std::vector<double>& K = info_.K->values;
    const std::vector<double>& P = info_.P->values;
    return P[0] == K[0] && P[2] == K[2] && P[5] == K[4] && P[6] == K[5];
  }

  /// P as the file is to say it: of the whole sensor, where `planned` is of the part of it that is published.
  [[nodiscard]] Projection whole(const Projection& planned, const CameraModel& model, const Reduction& reduction) const {
    if (!info_.P || !info_.reduction.changes_pixels()) return planned;
    Projection P{};
    std::ranges::copy(info_.P->values, P.begin());
    if (is_rectified_as_it_is()) P = projection_of(camera_matrix_of(unreduced(model, reduction)));
    P[3] = P[0] * (planned[3] / planned[0]);
    P[7] = P[5] * (planned[7] / planned[5]);
    return P;
  }

  /// Images of another size are whole ones.
  void edit_size(const ImageSize& size, Reduction& reduction) {
    if (info_.width != nullptr) fields::set_scalar(document_, *info_.width, std::to_string(size.width));
    if (info_.height != nullptr) fields::set_scalar(document_, *info_.height, std::to_string(size.height));
    if (!reduction.changes_pixels() && !info_.part) return;
    reduction = {};
    const Node& root = document_.root();
    for (const std::string_view key : kReductionKeys) {
      if (const text::Entry* entry = text::find_entry(root, key, kDialect)) document_.remove_entry(root, *entry);
    }
  }

  /// Numbers that the edit leaves as they are keep their spelling, and what binning turns them into, their last digit.
  void edit_camera_matrix(const CameraModel& old, const CameraModel& now, const Reduction& reduction) {
    const Matrix3 before = camera_matrix_of(old);
    const Matrix3 after = camera_matrix_of(now);
    const Matrix3 whole = camera_matrix_of(unreduced(now, reduction));
    const bool reduced_alike = reduction.changes_pixels() == info_.reduction.changes_pixels();
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (before.at(i) != after.at(i) || !reduced_alike) set(*info_.K->nodes[i], whole.at(i));
    }
  }

  void set(const Node& number, double value) {
    if (text::parse_real(number.value) != value) fields::set_scalar(document_, number, text::format_real(value));
  }

  void edit_coefficients(const CameraModel& now) {
    std::vector<double> values = coefficients_of(now);
    const Numbers& there = *info_.D;
    // plumb_bob may go without its k3, and any list end in zeros; an .ini says the model by the count.
    const bool opencv = straight_id(now) != "kb4";
    const auto last = std::ranges::find_if(values.rbegin(), values.rend(), [](double value) { return value != 0.0; });
    const auto meant = static_cast<std::size_t>(values.rend() - last);
    constexpr std::size_t kFewest = 4;
    const bool may_stay = opencv && !info_.counted && there.nodes.size() >= kFewest && there.nodes.size() >= meant;
    if (may_stay) values.resize(there.nodes.size(), 0.0);
    if (values.size() == there.nodes.size()) {
      for (std::size_t i = 0; i < values.size(); ++i) set(*there.nodes[i], values[i]);
    } else if (info_.counted) {
      std::string line;
      for (const double value : values) line += (line.empty() ? "" : " ") + text::format_real(value);
      document_.replace(there.place->span, line);
    } else {
      fields::apply(document_, *there.place, kDialect, {}, matrix_fields(values, 1));
    }
    if (!info_.counted) edit_model(now);
  }

  void edit_model(const CameraModel& now) {
    const std::string name(name_of(now));
    if (info_.model == nullptr && model_of(name) == "radtan") return;  // as the parser takes it
    const Field field = fields::scalar(std::string(kModel), name);
    fields::apply(document_, document_.root(), kDialect, {}, std::span(&field, 1));
  }

  /// Only where the rig says another one; a file that has none gets one where it is not what everybody assumes.
  template <std::size_t N>
  void edit_matrix(std::string_view key, const std::optional<Numbers>& there, const std::array<double, N>& before,
                   const std::array<double, N>& after) {
    if (there) {
      for (std::size_t i = 0; i < N; ++i) {
        if (before.at(i) != after.at(i)) set(*there->nodes[i], after.at(i));
      }
      return;
    }
    const text::Entry* last = text::find_entry(document_.root(), kCoefficients, kDialect);
    const bool new_place = key == kRectification ? before != after : before[3] != after[3];
    if (new_place && last != nullptr) document_.insert_after(document_.root(), *last, matrix_text(key, after, 3));
  }

  text::Document& document_;
  const CameraInfo& info_;
};

void list_restated(const Rectification& rectification, Written& written) {
  if (!rectification.restated) return;
  const PoseEdge& edge = *rectification.restated;
  written.restated.push_back(edge);
  written.losses.push_back(lost(Code::kPoseRecomputed, edge.b, std::string(kRectification), {edge.a}));
}

/// The file that is written into, with whatever cameras of the rig are its own.
class BaseFile {
 public:
  BaseFile(const text::Document& base, const Rig& old)
      : document_(base),
        old_(old),
        before_(rectification_of(old)),
        reader_(base, kDialect, ignored_),
        infos_(*find_camera_infos(reader_)) {}

  /// False if the camera is none of the file's.
  bool edit(const Rig& rig, const Camera& camera, const Rectified& rectified) {
    const std::optional<std::size_t> index = index_of(rig, camera);
    if (!index) return false;
    Editor(document_, infos_[*index]).run(old_.cameras[*index], camera, before_.cameras[*index], rectified);
    cameras_.push_back(camera.name);
    return true;
  }

  [[nodiscard]] const text::Document& document() const { return document_; }
  [[nodiscard]] const std::vector<std::string>& cameras() const { return cameras_; }

  [[nodiscard]] std::vector<std::string> programs() const {
    return infos_.size() == 1 ? std::vector<std::string>{"ros"} : std::vector<std::string>();
  }

 private:
  [[nodiscard]] std::optional<std::size_t> index_of(const Rig& rig, const Camera& camera) const {
    if (old_.cameras.size() == 1) return is_camera_of(old_, rig, camera) ? std::optional<std::size_t>(0) : std::nullopt;
    const auto found = std::ranges::find(old_.cameras, camera.name, &Camera::name);
    if (found == old_.cameras.end()) return std::nullopt;
    return static_cast<std::size_t>(found - old_.cameras.begin());
  }

  text::Document document_;
  const Rig& old_;
  Rectification before_;
  Diagnostics ignored_;
  fields::Reader reader_;
  std::vector<CameraInfo> infos_;
  std::vector<std::string> cameras_;
};

/// False with an error for every camera whose model an .ini does not hold.
bool can_store_in_ini(const Rig& rig, Diagnostics& diagnostics) {
  bool good = true;
  for (const Camera& camera : rig.cameras) {
    const std::string_view model = straight_id(camera.model);
    if (ini_holds(model)) continue;
    diagnostics.add(Code::kRosIniHasNoModel, {camera.name, model});
    good = false;
  }
  return good;
}

bool ini_holds_all(const Rig& rig) {
  return std::ranges::all_of(rig.cameras, [](const Camera& camera) { return ini_holds(straight_id(camera.model)); });
}

constexpr std::string_view kIniExtension = ".ini";

/// ROS goes by a file's name; nothing of one that says neither syntax.
std::optional<bool> names_ini(std::string_view extension) {
  if (extension == kIniExtension) return true;
  return extension == ".yaml" || extension == ".yml" ? std::optional(false) : std::nullopt;
}

Message headline(const Rig& rig, const Rectification& rectification) {
  if (rig.cameras.size() == 1) return {Code::kRosWroteCamera};
  if (rectification.is_vertical) return {Code::kRosWroteNoPair, {rig.cameras[0].name, rig.cameras[1].name}};
  if (!rectification.chosen) return {Code::kRosWroteCameras};
  const Projection& P = rectification.cameras.front().P;
  return {Code::kRosWrotePair, {P[0], P[2], P[6], rig.cameras[0].name, rig.cameras[1].name}};
}

}  // namespace

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  if (!writable_alone(kFormat, rig, Message{Code::kRosDemandsSize}, diagnostics)) return std::nullopt;
  const std::optional<bool> named_ini = names_ini(options.extension);
  const bool base_ini = base != nullptr && base->syntax() == text::Syntax::kWords;
  // A message is printed by ROS, and no file that it reads.
  const bool base_message = base != nullptr && !base_ini && is_message(*base);
  const bool ini = named_ini.value_or(base_ini && ini_holds_all(rig));
  if (ini && !can_store_in_ini(rig, diagnostics)) return std::nullopt;
  Diagnostics ignored;
  const std::optional<Rig> old = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  const bool edits = old && !options.rewrite && ini == base_ini && !base_message;
  const Rectification rectification = rectification_of(rig);
  Written written;
  std::vector<ExtraField> said;
  std::optional<BaseFile> base_file;
  if (edits) base_file.emplace(*base, *old);
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const Camera& camera = rig.cameras[i];
    const Rectified& rectified = rectification.cameras[i];
    if (base_file && base_file->edit(rig, camera, rectified)) continue;
    const std::string text = ini ? compose_ini(camera, rectified) : compose(camera, rectified);
    std::optional<text::Document> document = text::parse_document(
        {as_file_name(camera.name) + std::string(ini ? kIniExtension : kFormat.extension), text}, diagnostics);
    if (!document) return std::nullopt;
    if (ini && section_of(camera.name) != camera.name) {
      written.losses.push_back(lost(Code::kRosCameraRenamed, camera.name, "camera_name", {section_of(camera.name)}));
    }
    if (rectified.stated) {
      const ExtraField* extra = rig.find_extra_field(camera.name, kProjection);
      if (extra != nullptr) said.push_back(*extra);
    }
    written.files.push_back({*std::move(document), {camera.name}, {"ros"}});
  }
  if (base_file && !base_file->cameras().empty()) {
    written.files.insert(written.files.begin(), {base_file->document(), base_file->cameras(), base_file->programs()});
    said.insert(said.end(), old->extra_fields.begin(), old->extra_fields.end());
  }
  list_restated(rectification, written);
  written.states_rectification = rectification.stated;
  list_camera_losses(rig, "ROS", written.losses);
  add_beyond_base(rig.extra_fields, said, Message{Code::kRosHasNoPlace}, written.losses);
  if (old && !edits) {
    const Message why = ini != base_ini ? Message{Code::kRosAnotherSyntax} : Message{};
    add_rewritten(*base, written.files.front().document, why, written.losses);
    add_not_carried(extras_beyond(extras_beyond(old->extra_fields, rig.extra_fields), said), Message{Code::kFileRewritten},
                    written.losses);
  }
  written.headline = headline(rig, rectification);
  return written;
}

}  // namespace fca::ros
