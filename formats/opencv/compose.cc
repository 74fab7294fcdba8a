// SPDX-License-Identifier: BSD-3-Clause
#include "compose.h"

#include "blocks.h"
#include "rectification.h"

#include <fca/code.h>
#include <fca/formats/file_name.h>
#include <fca/formats/text/read_document.h>
#include <fca/rectify/rectify.h>

#include <algorithm>

namespace fca::opencv {

namespace {

using text::Syntax;

bool all_of_kind(const Rig& rig, Kind kind) {
  return std::ranges::all_of(rig.cameras, [kind](const Camera& camera) { return kind_of(camera.model) == kind; });
}

bool any_omnidir(const Rig& rig) {
  return std::ranges::any_of(rig.cameras, [](const Camera& camera) { return kind_of(camera.model) == Kind::kOmnidir; });
}

bool one_size(const Rig& rig) {
  return std::ranges::all_of(rig.cameras,
                             [&rig](const Camera& camera) { return camera.image_size == rig.cameras.front().image_size; });
}

bool one_camera_per_file(std::string_view layout, const Rig& rig) {
  if (layout == "cameras") return false;
  return rig.cameras.size() == 1 || layout == "calibration" || (layout == "omnidir" && rig.cameras.size() != 2);
}

/// The text of a document with these fields, mappings in the order given.
class Text {
 public:
  explicit Text(Syntax syntax) : syntax_(syntax) {}

  void add(const fields::Field& field) { lines_.push_back(fields::spell(field, indentation_, syntax_)); }
  void add_map(const std::string& key, const std::vector<fields::Field>& fields) {
    constexpr std::size_t kDeeper = 4;
    const std::string blanks(indentation_, ' ');
    std::string lines;
    for (const fields::Field& field : fields) {
      if (!lines.empty()) lines += syntax_ == Syntax::kJson ? ",\n" : "\n";
      lines += fields::spell(field, indentation_ + kDeeper, syntax_);
    }
    if (syntax_ == Syntax::kXml) {
      lines_.push_back(blanks + "<" + key + ">\n" + lines + "\n" + blanks + "</" + key + ">");
    } else if (syntax_ == Syntax::kJson) {
      lines_.push_back(blanks + "\"" + key + "\": {\n" + lines + "\n" + blanks + "}");
    } else {
      lines_.push_back(blanks + key + ":\n" + lines);
    }
  }

  [[nodiscard]] std::string whole() const {
    const std::string separator = syntax_ == Syntax::kJson ? ",\n" : "\n";
    std::string body;
    for (const std::string& line : lines_) body += (body.empty() ? "" : separator) + line;
    if (syntax_ == Syntax::kXml) return "<?xml version=\"1.0\"?>\n<opencv_storage>\n" + body + "\n</opencv_storage>\n";
    if (syntax_ == Syntax::kJson) return "{\n" + body + "\n}\n";
    return "%YAML:1.0\n---\n" + body + "\n";
  }

 private:
  Syntax syntax_;
  std::size_t indentation_ = syntax_ == Syntax::kJson ? 4 : 0;
  std::vector<std::string> lines_;
};

/// cv::stereoRectify and cv::fisheye::stereoRectify have these matrices, cv::omnidir others. The file's cameras are the pair's,
/// in its order.
bool holds_rectification(std::string_view layout, const Rig& rig) {
  return layout == "stereo" && !any_omnidir(rig) && states_rectification(rig) &&
         rig.rectified->views[0].camera == rig.cameras[0].name;
}

std::optional<Written::File> compose_file(const Rig& rig, const std::string& name, Syntax syntax, const std::string& file_name,
                                          Diagnostics& diagnostics) {
  Layout layout = new_layout(name, rig.cameras.size(), all_of_kind(rig, Kind::kOmnidir));
  // Poses to several references: which one is each to?
  const bool groups = layout.in_maps() && std::ranges::any_of(rig.cameras, [&rig](const Camera& camera) {
                        const std::optional<ReferencePose> pose = reference_pose(rig, camera);
                        return pose && pose->group != 0;
                      });
  for (CameraKeys& keys : layout.cameras) {
    if (groups) keys.group = "camera_group";
  }
  const FieldMaker maker(rig, layout, nullptr);
  Text text(syntax);
  for (const fields::Field& field : maker.root(std::vector<bool>(rig.cameras.size(), false))) text.add(field);
  if (holds_rectification(name, rig)) {
    for (const fields::Field& field : rectification_fields(*rig.rectified)) text.add(field);
  }
  if (layout.in_maps()) {
    for (std::size_t i = 0; i < rig.cameras.size(); ++i)
      text.add_map(layout.cameras[i].map, maker.map(i, layout.cameras[i], false));
  }
  std::optional<text::Document> document = text::parse_document({file_name, text.whole()}, diagnostics);
  if (!document) return std::nullopt;
  Written::File file{*std::move(document), {}, {"opencv"}};
  for (const Camera& camera : rig.cameras) file.cameras.push_back(camera.name);
  return file;
}

}  // namespace

bool names_syntax(std::string_view extension) {
  return extension == ".yml" || extension == ".yaml" || extension == ".xml" || extension == ".json";
}

Syntax syntax_for(std::string_view extension) {
  if (extension == ".xml") return Syntax::kXml;
  return extension == ".json" ? Syntax::kJson : Syntax::kOpenCvYaml;
}

bool same_syntax(Syntax a, Syntax b) {
  const auto plain = [](Syntax syntax) { return syntax == Syntax::kYaml ? Syntax::kOpenCvYaml : syntax; };
  return plain(a) == plain(b);
}

Message problem_with_layout(std::string_view layout, const Rig& rig) {
  const bool omnidir = any_omnidir(rig);
  if (layout == "omnidir") return all_of_kind(rig, Kind::kOmnidir) ? Message{} : Message{Code::kOpencvMeiAlone};
  if (layout == "calibration") return {};
  if (layout == "cameras") return omnidir ? Message{Code::kOpencvNoKeyForXi} : Message{};
  if (rig.cameras.size() != 2) return {Code::kOpencvTwoCameras, {rig.cameras.size()}};
  if (!one_size(rig)) return {Code::kOpencvSizesDiffer};
  if (layout == "left-right" && omnidir) return {Code::kOpencvNoKeyForXi};
  const Kind kind = kind_of(rig.cameras.front().model);
  return all_of_kind(rig, kind) ? Message{} : Message{Code::kOpencvKindsDiffer};
}

std::string default_layout(const Rig& rig) {
  const bool all_omnidir = all_of_kind(rig, Kind::kOmnidir);
  if (rig.cameras.size() == 1) return all_omnidir ? "omnidir" : "calibration";
  const bool posed = rig.cameras.size() == 2 && rig.resolve(rig.cameras[1].name, rig.cameras[0].name).has_value();
  if (posed && !problem_with_layout("stereo", rig).is_said()) return all_omnidir ? "omnidir" : "stereo";
  if (any_omnidir(rig)) return "calibration";
  return "cameras";
}

bool compose(const Rig& rig, const std::string& layout, Syntax syntax, std::string extension, Written& written,
             Diagnostics& diagnostics) {
  if (syntax == Syntax::kYaml) syntax = Syntax::kOpenCvYaml;
  if (extension.empty()) extension = syntax == Syntax::kXml ? ".xml" : syntax == Syntax::kJson ? ".json" : ".yml";
  if (!one_camera_per_file(layout, rig)) {
    const std::string name = layout == "cameras" ? "cameras" : "stereo";
    std::optional<Written::File> file = compose_file(rig, layout, syntax, name + extension, diagnostics);
    if (!file) return false;
    written.files.push_back(*std::move(file));
    written.states_rectification = holds_rectification(layout, rig);
    return true;
  }
  for (const Camera& camera : rig.cameras) {
    Rig one;
    one.cameras = {camera};
    std::optional<Written::File> file =
        compose_file(one, "calibration", syntax, as_file_name(camera.name) + extension, diagnostics);
    if (!file) return false;
    written.files.push_back(*std::move(file));
  }
  return true;
}

}  // namespace fca::opencv
