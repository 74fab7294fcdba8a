// SPDX-License-Identifier: BSD-3-Clause
#include "writing.h"

#include "assumptions.h"
#include "camera_names.h"
#include "choose_model.h"
#include "common_lens.h"
#include "into.h"
#include "pair_fit.h"
#include "parallel_for.h"
#include "placing.h"
#include "provenance.h"
#include "proving.h"
#include "settings.h"
#include "stale_facts.h"
#include "stereo_order.h"
#include "turned_poses.h"
#include "write_rig.h"

#include <fca/code.h>
#include <fca/convert/max_angle_table.h>
#include <fca/convert/uncertainty.h>
#include <fca/formats/counted_cameras.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace fca {

namespace {

/// The rig of the input with the fitted cameras, their rotations in its poses, and the frame rate and baseline of the request.
Rig converted_rig(const Calibration& calibration, const std::vector<ConvertedCamera>& cameras, const ConvertRequest& request) {
  Rig rig = calibration.rig;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    rig.cameras[i] = cameras[i].target;
    if (request.frame_rate_hz) rig.cameras[i].frame_rate_hz = request.frame_rate_hz;
  }
  if (request.baseline_m) rig.baseline_m = request.baseline_m;
  turn_poses(cameras, rig);
  return rig;
}

/// The rig that programs must read from the files: `rig`, but with the poses that were deliberately written with other values.
Rig rig_in_files(Rig rig, const Written& written) {
  for (const PoseEdge& edge : written.restated) {
    const auto pose =
        std::ranges::find_if(rig.poses, [&edge](const PoseEdge& other) { return other.a == edge.a && other.b == edge.b; });
    if (pose != rig.poses.end()) {
      pose->T_a_b = edge.T_a_b;
    } else {
      rig.poses.push_back(edge);
    }
  }
  return rig;
}

/// Adds ConversionReport::max_angles to the report of each fitted camera: the errors of the fit if the lens ended at a smaller
/// angle. max_angle_table.h says when this table is empty.
void add_max_angles(const Format& to, const ModelChoice& choice, std::vector<ConvertedCamera>& cameras) {
  parallel_for(cameras.size(), choice.request.jobs, [&](std::size_t i) {
    ConvertedCamera& camera = cameras[i];
    const StoredModel* stored = find_stored_model(to, model_info(camera.target.model).id, false);
    if (!camera.report || camera.report->exact || stored == nullptr) return;
    Diagnostics discarded;
    camera.report->max_angles = max_angle_table(camera.source, options_for(*stored, choice), *camera.report, discarded);
  });
}

/// Adds the uncertainty of the calibration to the report of each conversion.
void add_uncertainties(const Rig& rig, const ConvertRequest& request, std::vector<ConvertedCamera>& cameras) {
  parallel_for(cameras.size(), request.jobs, [&](std::size_t i) {
    ConvertedCamera& camera = cameras[i];
    if (!camera.report) return;
    camera.report->uncertainty = pixel_uncertainty(camera.source, camera.target, *camera.report,
                                                   rig.find_uncertainty(camera.source.name), request.inputs.max_angle_rad);
  });
}

/// The input document whose edit is the output; null if the output is a fresh file. Documents are recognised by the bytes that
/// they had before the edit.
const text::Document* input_of(const ConvertedFile& output, const Written& written, const Calibration& calibration) {
  const auto file = std::ranges::find(written.files, output.cameras, &Written::File::cameras);
  if (file == written.files.end()) return nullptr;
  const auto input = std::ranges::find_if(calibration.documents, [&file](const text::Document& document) {
    return document.source().bytes == file->document.source().bytes;
  });
  return input == calibration.documents.end() ? nullptr : &*input;
}

/// Ids of the format's models that the program accepts; empty: all models.
std::vector<std::string> models_accepted_by(const consumers::Consumer& program, const Format& format) {
  std::vector<std::string> models;
  const auto& accepted = program.writing.models_taken;
  for (const StoredModel& stored : format.models) {
    if (std::ranges::find(accepted, stored.file_name) != accepted.end()) models.emplace_back(stored.model);
  }
  return models;
}

/// Makes `program` the first of the programs that are asked about the files with cameras. If it recognises lenses by file
/// names, gives the files such names. Adds its name to the headline.
void put_first(const consumers::Consumer& program, const Rig& rig, Written& written) {
  bool is_new = false;
  for (Written::File& file : written.files) {
    if (!program.cameras || file.programs.empty() || file.cameras.empty() || file.programs.front() == program.id) continue;
    std::erase(file.programs, program.id);
    file.programs.emplace(file.programs.begin(), program.id);
    is_new = true;
  }
  for (Written::File& file : written.files) {
    const Camera* camera = file.cameras.empty() || file.place.empty() ? nullptr : rig.find_camera(file.cameras.front());
    if (camera == nullptr || program.writing.equidistant_file_name.empty() || model_info(camera->model).id != "kb4") continue;
    file.place = std::filesystem::path(file.place).replace_filename(program.writing.equidistant_file_name).string();
  }
  const bool recognises_names = !program.writing.equidistant_file_name.empty();  // other programs of the format do not
  if (is_new || recognises_names) written.headline = {Code::kHeadlineOfReader, {written.headline, program.program}};
}

/// The steps from the request to files that programs have read. Each step returns false after an error.
class Writing {
 public:
  Writing(const ConvertRequest& request, const Start& start, ModelChoice choice, ConvertResult& result)
      : request_(request),
        input_(start.input),
        into_(start.into),
        base_(start.base),
        choice_(std::move(choice)),
        views_(*start.views),
        result_(result) {}

  /// Takes all steps. prove() returns nothing: its errors and the status kRejected are in result_, and the files remain.
  [[nodiscard]] bool run() {
    if (!fit() || !write() || !place()) return false;
    if (request_.verify) prove();
    return true;
  }

 private:
  /// Fits the cameras to models that the target can store, and puts them into the rig. Fills result_.cameras and rig_.
  [[nodiscard]] bool fit();
  /// Fills rig_ with the rig of the input and the fitted cameras and, with --into, the rest of the base.
  [[nodiscard]] bool assemble_rig();
  /// Makes the files and the notes about them. Fills written_.
  [[nodiscard]] bool write();
  /// Copies written_ to result_ and gives each file its path.
  [[nodiscard]] bool place();
  /// Checks each file with the readers of its programs.
  void prove();

  const ConvertRequest& request_;
  const Calibration& input_;
  const std::optional<Calibration>& into_;
  const Base& base_;
  ModelChoice choice_;
  LoadedViews& views_;
  ConvertResult& result_;
  Rig rig_;    ///< The rig to write.
  Kept kept_;  ///< What was kept of the file of --into.
  Written written_;
};

bool Writing::fit() {
  if (!may_fit_pair(request_, *result_.to, result_.diagnostics)) return false;
  if (!holds_model(request_, base_, input_.rig, *result_.to, result_.diagnostics)) return false;
  const std::vector<std::string> accepted =
      request_.program != nullptr ? models_accepted_by(*request_.program, *result_.to) : std::vector<std::string>();
  if (request_.model != nullptr && !accepted.empty() && std::ranges::find(accepted, request_.model->id) == accepted.end()) {
    result_.diagnostics.add(Code::kModelNotStorable, {request_.program->program, request_.model->id, accepted});
    return false;
  }
  std::optional<std::vector<ConvertedCamera>> cameras =
      convert_cameras(input_.rig.cameras, *result_.to, choice_, result_.diagnostics);
  if (!cameras) return false;
  result_.cameras = *std::move(cameras);
  if (!share_lens(request_, *result_.to, choice_.most_cameras, result_.cameras, result_.diagnostics)) return false;
  if (!fit_as_pair(input_.rig, *result_.to, choice_, result_.cameras, result_.diagnostics)) return false;
  if (request_.in_detail) add_max_angles(*result_.to, choice_, result_.cameras);
  add_uncertainties(input_.rig, request_, result_.cameras);
  return assemble_rig();
}

bool Writing::assemble_rig() {
  rig_ = converted_rig(input_, result_.cameras, request_);
  if (!into_) return true;
  const bool order_given = request_.inputs.cameras && request_.inputs.cameras->size() > 1;
  rig_ = put_into(into_->rig, std::move(rig_), order_given, kept_, result_.diagnostics);
  if (!sizes_agree(*into_, input_, rig_, request_, result_.diagnostics)) return false;
  for (std::size_t i = 0; i < result_.cameras.size(); ++i) result_.cameras[i].source.name = kept_.names[i];
  return true;
}

bool Writing::write() {
  const Format& to = *result_.to;
  std::optional<Written> written = write_rig(input_, rig_, base_, request_, kept_.replaced, views_, result_);
  if (written && request_.program != nullptr) put_first(*request_.program, rig_, *written);
  if (!written || !is_edit_of_base(request_, base_, *written, result_.diagnostics)) return false;
  if (into_) report_kept(kept_, *written, result_.diagnostics);
  list_assumed_units(input_, to, *written);
  const bool edits_input = !into_ && base_.document != nullptr;
  if (edits_input && !request_.inputs.change.changes_nothing())
    list_facts_of_other_images(input_.rig, to, *written, result_.diagnostics);
  if (into_) list_facts_of_other_lenses(into_->rig, rig_, to, *written, result_.diagnostics);
  written_ = *std::move(written);
  name_as_written(to, written_, result_.cameras);
  // The comment must be added before --set is applied: applying it replaces the original bytes, by which inputs are recognised.
  add_provenance(request_, input_, written_, result_);
  if (!apply_settings(request_, to, written_, result_.diagnostics)) return false;
  warn_of_wrong_side(rig_, request_, written_.first_is_left, result_);
  return true;
}

bool Writing::place() {
  result_.headline = written_.headline;
  result_.mode = written_.sensor;
  result_.poses = written_.poses;
  report_turns(result_.poses, result_.cameras, result_.diagnostics);
  result_.losses = written_.losses;
  result_.defaults = written_.defaults;
  for (const Written::File& file : written_.files) {
    result_.files.push_back({file.document.source().name, "", file.document.bytes(), file.document.syntax(), file.cameras,
                             file.programs, file.named, file.place, file.of_defaults});
  }
  if (!place_files(request_, result_)) return false;
  // Cameras that no file contains are listed as losses; their fits are not reported.
  std::erase_if(result_.cameras, [this](const ConvertedCamera& camera) {
    return std::ranges::none_of(result_.files, [&camera](const ConvertedFile& file) {
      return std::ranges::find(file.cameras, camera.source.name) != file.cameras.end();
    });
  });
  return true;
}

void Writing::prove() {
  const bool edits_input = base_.document != nullptr && base_.into == nullptr;  // verify() then reports a refused input
  if (request_.in_detail && !edits_input) warn_if_refused(input_, request_.inputs, result_.diagnostics);
  const Rig expected = rig_in_files(rig_, written_);
  for (const ConvertedFile& file : result_.files) {
    if (file.is_filler()) continue;
    const text::Document* edited_input = input_of(file, written_, input_);
    const bool is_configuration = file.cameras.empty() && result_.to->facts_apart;
    verify(is_configuration ? with_counted_cameras(expected, written_) : expected, file, request_, written_,
           edited_input != nullptr ? edited_input : base_.document, views_, result_);
  }
}

}  // namespace

ModelChoice choice_of(const ConvertRequest& request, const Start& start, const Format& to) {
  ModelChoice choice{.request = request};
  choice.known = start.known.get();
  choice.errors_of_kept = request.errors_of_kept || !start.input.rig.uncertainties.empty();
  choice.among =
      request.layout ? models_of_layout(to, request.layout->name()) : models_for(request, start.base, start.input.rig, to);
  const bool is_fresh = start.base.document == nullptr && to.cameras_held != nullptr;
  choice.most_cameras =
      is_fresh ? to.cameras_held(start.input.rig, name_of(request.mode), name_of(request.layout)) : to.most_cameras;
  choice.same_format = start.input.format == &to && start.input.one_format;
  if (request.program == nullptr) return choice;
  choice.unread = request.program->writing.unread;
  if (const std::vector<std::string> accepted = models_accepted_by(*request.program, to); !accepted.empty()) {
    if (choice.among.empty()) choice.among = accepted;
    std::erase_if(choice.among,
                  [&accepted](const std::string& model) { return std::ranges::find(accepted, model) == accepted.end(); });
    choice.same_format = false;
  }
  return choice;
}

bool write_as_asked(const ConvertRequest& request, const Start& start, ConvertResult& result, Partial partial) {
  ModelChoice choice = choice_of(request, start, *result.to);
  choice.partial = partial;
  return Writing(request, start, std::move(choice), result).run();
}

}  // namespace fca
