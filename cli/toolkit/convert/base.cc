// SPDX-License-Identifier: BSD-3-Clause
#include "base.h"

#include "into.h"

#include <fca/code.h>
#include <fca/toolkit/inputs.h>

#include <algorithm>

namespace fca {

std::optional<Calibration> read_into(const ConvertRequest& request, Files& files, ConvertResult& result) {
  if (const std::vector<std::string> rig_files = rig_files_in(request.into); !rig_files.empty()) {
    result.diagnostics.add(Code::kIntoFolder, {rig_files.size(), rig_files}, {request.into, 0, 0});
    result.status = Status::kBadRequest;
    return std::nullopt;
  }
  Inputs inputs;  // The input's image size and changes do not apply to the base.
  inputs.files = {request.into};
  inputs.opencv_model = request.inputs.opencv_model;
  std::optional<Calibration> into = read_calibration(inputs, files, result.diagnostics);
  if (into && into->rig.cameras.empty() && into->rig.poses.empty()) {
    result.diagnostics.add(Code::kIntoWithoutCamera, {}, {request.into, 0, 0});
    result.status = Status::kBadRequest;
    return std::nullopt;
  }
  if (into && !into->format->is_written()) {
    result.diagnostics.add(Code::kFormatIsReadOnly, {into->format->title}, {request.into, 0, 0});
    result.status = Status::kBadRequest;
    return std::nullopt;
  }
  if (!into || request.to == nullptr || request.to == into->format) return into;
  result.diagnostics.add(Code::kIntoAnotherFormat, {into->format->title, request.to->id}, {request.into, 0, 0});
  result.status = Status::kBadRequest;
  return std::nullopt;
}

namespace {

/// The names of the frames that the poses connect, each once, in the order of the poses.
std::vector<std::string> frames_of(const Rig& rig) {
  std::vector<std::string> frames;
  for (const PoseEdge& pose : rig.poses) {
    for (const std::string& frame : {pose.b, pose.a}) {
      if (std::ranges::find(frames, frame) == frames.end()) frames.push_back(frame);
    }
  }
  return frames;
}

}  // namespace

bool base_poses_are_known(const Calibration& into, const Rig& rig, const std::string& input, ConvertResult& result) {
  if (!into.rig.cameras.empty() || has_common_pose(into.rig, rig)) return true;
  std::vector<Message> reason;
  if (rig.cameras.size() < 2) reason.push_back({Code::kHasOneCamera});
  result.diagnostics.add(Code::kIntoWithoutPose, {input, reason, into.documents.front().source().name, frames_of(into.rig)},
                         {input, 0, 0});
  return false;
}

bool keeps_text(const ConvertRequest& request, const Base& base) {
  return base.into != nullptr && !request.rewrite && !request.layout;
}

namespace {

/// True if the input's cameras must get the model of the base's cameras: the format has one model for all cameras of a file,
/// and a camera of the base stays in the file. If the request gives a mode, the writer may drop that camera.
bool needs_model_of_base(const ConvertRequest& request, const Base& base, const Rig& input, const Format& to) {
  return to.one_model && keeps_text(request, base) && !request.mode && base.into->rig.cameras.size() > input.cameras.size();
}

/// True if the first of several joined input files is edited and the cameras of the others are added to it. For this, all files
/// must have the target's format, and that format must hold several cameras in one file.
bool edits_first_file(const Calibration& calibration, const ConvertRequest& request, const Format& to) {
  return request.inputs.join && !request.rewrite && calibration.one_format && calibration.format == &to && to.many_cameras &&
         calibration.with_cameras == 0;
}

}  // namespace

std::vector<std::string> models_for(const ConvertRequest& request, const Base& base, const Rig& input, const Format& to) {
  std::vector<std::string> models;
  if (!keeps_text(request, base) || to.layout_holds == nullptr || base.into->rig.cameras.empty()) return models;
  const std::string_view model_of_base = model_info(base.into->rig.cameras.front().model).id;
  if (find_stored_model(to, model_of_base, true) == nullptr || needs_model_of_base(request, base, input, to))
    return {std::string(model_of_base)};
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
  if (needs_model_of_base(request, base, input, to) && asked->id != models.front()) {
    diagnostics.add(Code::kModelsDiffer, {models.front(), to.title}, {request.into, 0, 0});
    return false;
  }
  if (to.layout_holds(*base.document, asked->id)) return true;
  diagnostics.add(Code::kLayoutWithoutModel, {asked->id, models, models.front()}, {request.into, 0, 0});
  return false;
}

bool sizes_agree(const Calibration& base, const Calibration& input, const Rig& rig, const ConvertRequest& request,
                 Diagnostics& diagnostics) {
  if (request.inputs.change.resize) return true;
  const auto& base_bytes = base.documents.front().source().bytes;
  if (!request.inputs.change.changes_nothing() && input.documents[input.with_cameras].source().bytes == base_bytes) return true;
  const bool has_size =
      std::ranges::any_of(base.rig.cameras, [](const Camera& camera) { return camera.image_size.has_value(); });
  for (const Camera& camera : input.rig.cameras) {
    if (!has_size || camera.image_size) continue;
    diagnostics.add(Code::kImageSizeNotKnown, {camera.name}, {request.inputs.files.front(), 0, 0});
    return false;
  }
  for (const Camera& camera : rig.cameras) {
    const Camera* before = base.rig.find_camera(camera.name);
    if (before == nullptr || !before->image_size || !camera.image_size || before->image_size == camera.image_size) continue;
    diagnostics.add(Code::kSizesContradict,
                    {camera.name, before->image_size->width, before->image_size->height, camera.image_size->width,
                     camera.image_size->height},
                    {request.into, 0, 0});
    return false;
  }
  return true;
}

bool is_edit_of_base(const ConvertRequest& request, const Base& base, const Written& written, Diagnostics& diagnostics) {
  if (base.into == nullptr) return true;
  const text::Document& document = written.files.front().document;
  const bool is_plain_text = base.document->syntax() == text::Syntax::kWords;
  const bool kept = is_plain_text ? document.syntax() == text::Syntax::kWords
                                  : document.source().bytes == base.document->source().bytes || !keeps_text(request, base);
  if (kept) return true;
  diagnostics.add(is_plain_text ? Code::kIntoDoesNotFitWords : Code::kIntoDoesNotFit, {base.into->format->id},
                  {request.into, 0, 0});
  return false;
}

Base base_of(const ConvertRequest& request, const Calibration& input, const std::optional<Calibration>& into,
             const Format& to) {
  if (into) return {&into->documents.front(), &*into};
  const text::Document& main_file = input.documents[input.with_cameras];
  const bool one_file = request.inputs.files.size() == 1 || edits_first_file(input, request, to);
  if (!one_file || !is_base_of(*input.format, main_file, to)) return {};
  return {&main_file, nullptr, input.format != &to};
}

}  // namespace fca
