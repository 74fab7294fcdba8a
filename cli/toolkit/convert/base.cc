// SPDX-License-Identifier: BSD-3-Clause
#include "base.h"

#include "into.h"
#include "words.h"

#include <algorithm>

namespace fca {

std::optional<Calibration> read_into(const ConvertRequest& request, Files& files, ConvertResult& result) {
  Inputs inputs;  // The input's size and changes are not the base's.
  inputs.files = {request.into};
  inputs.opencv_model = request.inputs.opencv_model;
  std::optional<Calibration> into = read_calibration(inputs, files, result.diagnostics);
  if (into && into->rig.cameras.empty() && into->rig.poses.empty()) {
    result.diagnostics.error("into-without-camera", "there is no camera here that the input's could take the place of",
                             {request.into, 0, 0}, "--into wants the file that holds the cameras; -o FILE writes a new one");
    result.status = Status::kBadRequest;
    return std::nullopt;
  }
  if (!into || request.to == nullptr || request.to == into->format) return into;
  result.diagnostics.error("into-another-format",
                           "the file is " + std::string(into->format->title) + ", and --to says " + std::string(request.to->id),
                           {request.into, 0, 0}, "leave out --to");
  result.status = Status::kBadRequest;
  return std::nullopt;
}

bool has_use_for(const Calibration& into, const Rig& rig, const std::string& input, ConvertResult& result) {
  if (!into.rig.cameras.empty() || says_a_pose_of(into.rig, rig)) return true;
  const Rig& pose = into.rig;
  result.diagnostics.error(
      "pose-missing",
      input + " states no pose between two cameras" + (rig.cameras.size() < 2 ? " (it has one)" : "") + ", and " +
          into.documents.front().source().name + " holds only that of " + pose.poses.front().b + " and " + pose.poses.front().a,
      {input, 0, 0}, "an input of both cameras and their pose goes into it; --to opencv -o OTHER.yml writes the cameras");
  return false;
}

bool keeps_text(const ConvertRequest& request, const Base& base) {
  return base.into != nullptr && !request.rewrite && request.layout.name.empty();
}

namespace {

/// Does a camera of --into's file stay, whose model the input's are to share? A mode that is asked for may leave it out.
bool shares_model(const ConvertRequest& request, const Base& base, const Rig& input, const Format& to) {
  return to.one_model && keeps_text(request, base) && request.mode.empty() &&
         base.into->rig.cameras.size() > input.cameras.size();
}

/// Of joined files of the target's own format the first is edited, and takes the others' cameras.
bool edits_first(const Calibration& calibration, const ConvertRequest& request, const Format& to) {
  return request.inputs.join && !request.rewrite && calibration.one_format && calibration.format == &to && to.many_cameras &&
         calibration.with_cameras == 0;
}

}  // namespace

std::vector<std::string> models_for(const ConvertRequest& request, const Base& base, const Rig& input, const Format& to) {
  std::vector<std::string> models;
  if (!keeps_text(request, base) || to.layout_holds == nullptr || base.into->rig.cameras.empty()) return models;
  const std::string_view own = model_info(base.into->rig.cameras.front().model).id;
  if (find_stored_model(to, own, true) == nullptr || shares_model(request, base, input, to)) return {std::string(own)};
  for (const StoredModel& stored : to.models) {
    if (stored.stock && to.layout_holds(*base.document, stored.model)) models.emplace_back(stored.model);
  }
  return models;
}

bool holds_model(const ConvertRequest& request, const Base& base, const Rig& input, const Format& to,
                 Diagnostics& diagnostics) {
  const ModelInfo* asked = request.model;
  const std::vector<std::string> models = models_for(request, base, input, to);
  if (asked == nullptr || models.empty()) return true;
  if (shares_model(request, base, input, to) && asked->id != models.front()) {
    diagnostics.error(
        "models-differ",
        "a camera stays, of the model " + models.front() + ", and " + std::string(to.title) + " have one model for all cameras",
        {request.into, 0, 0}, "--model " + models.front() + ", or an input that has all cameras");
    return false;
  }
  if (to.layout_holds(*base.document, asked->id)) return true;
  diagnostics.error("into-another-layout",
                    "this file's layout has no place for " + std::string(asked->id) + "; it holds " + enumerated(models),
                    {request.into, 0, 0}, "--model " + models.front() + " keeps the file's text, --anew writes another file");
  return false;
}

bool sizes_agree(const Calibration& base, const Calibration& input, const Rig& rig, const ConvertRequest& request,
                 Diagnostics& diagnostics) {
  if (request.inputs.change.resize) return true;
  const auto& bytes = base.documents.front().source().bytes;
  if (!request.inputs.change.changes_nothing() && input.documents[input.with_cameras].source().bytes == bytes) return true;
  for (const Camera& camera : rig.cameras) {
    const Camera* before = base.rig.find_camera(camera.name);
    if (before == nullptr || !before->image_size || !camera.image_size || before->image_size == camera.image_size) continue;
    const auto resize = [](const ImageSize& size) {
      return "--resize " + std::to_string(size.width) + "x" + std::to_string(size.height);
    };
    diagnostics.error("size-contradicts",
                      camera.name + ": the base is for images of " + size_in_words(*before->image_size) +
                          " px, and the input's are of " + size_in_words(*camera.image_size) + " px",
                      {request.into, 0, 0},
                      resize(*before->image_size) + " if the base's images are the input's, scaled; " +
                          resize(*camera.image_size) + " if the base is to become one for the input's");
    return false;
  }
  return true;
}

bool is_edit_of_base(const ConvertRequest& request, const Base& base, const Written& written, Diagnostics& diagnostics) {
  if (base.into == nullptr) return true;
  const text::Document& document = written.files.front().document;
  const bool words = base.document->syntax() == text::Syntax::kWords;
  const bool kept = words ? document.syntax() == text::Syntax::kWords
                          : document.source().bytes == base.document->source().bytes || !keeps_text(request, base);
  if (kept) return true;
  diagnostics.error("into-another-layout", "what the input says does not fit into the layout of this file",
                    {request.into, 0, 0},
                    words ? "--to " + std::string(base.into->format->id) + " -o OTHER.yaml writes another file"
                          : "--anew writes another file and lists what of this one goes");
  return false;
}

Base base_of(const ConvertRequest& request, const Calibration& input, const std::optional<Calibration>& into,
             const Format& to) {
  if (into) return {&into->documents.front(), &*into};
  const text::Document& main_file = input.documents[input.with_cameras];
  const bool one_file = request.inputs.files.size() == 1 || edits_first(input, request, to);
  if (!one_file || !is_base_of(*input.format, main_file, to)) return {};
  return {&main_file, nullptr, input.format != &to};
}

}  // namespace fca
