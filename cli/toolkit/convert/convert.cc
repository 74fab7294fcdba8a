// SPDX-License-Identifier: BSD-3-Clause
#include "convert/assumptions.h"
#include "convert/base.h"
#include "convert/camera_names.h"
#include "convert/choose_model.h"
#include "convert/input_checks.h"
#include "convert/into.h"
#include "convert/limits.h"
#include "convert/placing.h"
#include "convert/provenance.h"
#include "convert/proving.h"
#include "convert/settings.h"
#include "convert/stale_facts.h"
#include "convert/stereo_order.h"
#include "convert/write_rig.h"
#include "parallel_for.h"

#include <fca/convert/reach.h>
#include <fca/formats/wording.h>
#include <fca/toolkit/convert.h>

#include <algorithm>

namespace fca {

namespace {

Rig converted_rig(const Calibration& calibration, const std::vector<ConvertedCamera>& cameras, const ConvertRequest& request) {
  Rig rig = calibration.rig;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    rig.cameras[i] = cameras[i].target;
    if (request.frame_rate_hz) rig.cameras[i].frame_rate_hz = request.frame_rate_hz;
  }
  if (request.baseline_m) rig.baseline_m = request.baseline_m;
  return rig;
}

/// The rig with the poses that the files say otherwise.
Rig as_restated(Rig rig, const Written& written) {
  for (const PoseEdge& edge : written.restated) {
    const auto stated =
        std::ranges::find_if(rig.poses, [&edge](const PoseEdge& other) { return other.a == edge.a && other.b == edge.b; });
    if (stated != rig.poses.end()) {
      stated->T_a_b = edge.T_a_b;
    } else {
      rig.poses.push_back(edge);
    }
  }
  return rig;
}

/// What the same fits would reach if the lens ended earlier, where nothing says where it ends.
void add_reach(const Format& to, const ModelChoice& choice, std::vector<ConvertedCamera>& cameras) {
  parallel_for(cameras.size(), choice.jobs, [&](std::size_t i) {
    ConvertedCamera& camera = cameras[i];
    const StoredModel* stored = find_stored_model(to, model_info(camera.target.model).id, false);
    if (!camera.report || camera.report->exact || stored == nullptr) return;
    Diagnostics told_already;
    camera.report->reach = reach_table(camera.source, options_for(*stored, choice), *camera.report, told_already);
  });
}

/// Of joined files the one that an output is an edit of; null if it is none.
const text::Document* input_of(const ConvertedFile& output, const Written& written, const Calibration& calibration) {
  const auto file = std::ranges::find(written.files, output.cameras, &Written::File::cameras);
  if (file == written.files.end()) return nullptr;
  const auto input = std::ranges::find_if(calibration.documents, [&file](const text::Document& document) {
    return document.source().bytes == file->document.source().bytes;
  });
  return input == calibration.documents.end() ? nullptr : &*input;
}

/// One conversion, step by step: each of them is false where there are errors.
class Steps {
 public:
  Steps(const ConvertRequest& request, Files& files, ConvertResult& result)
      : request_(request), files_(files), result_(result) {}

  [[nodiscard]] bool run() {
    if (!read() || !fit() || !write() || !place()) return false;
    if (request_.verify) prove();
    warn_of_poor_fits(request_, result_);
    apply_limits(request_, result_);
    return true;
  }

 private:
  /// Into input_, into_ and base_.
  [[nodiscard]] bool read();
  [[nodiscard]] ModelChoice choice() const;
  /// Into the result's cameras.
  [[nodiscard]] bool fit();
  /// Into rig_: the cameras that were fitted, in the rig of the input, or of the base.
  [[nodiscard]] bool put_together();
  /// Into written_.
  [[nodiscard]] bool write();
  /// What was written, into the result; its files where they go.
  [[nodiscard]] bool place();
  void prove();

  const ConvertRequest& request_;
  Files& files_;
  ConvertResult& result_;
  std::optional<Calibration> into_;  ///< The request's base.
  std::jthread programs_;            ///< Made ready while the input is read.
  std::optional<Calibration> input_;
  Base base_;
  Rig rig_;    ///< What is written.
  Kept kept_;  ///< Of the base.
  Written written_;
};

bool Steps::read() {
  if (!request_.into.empty()) {
    into_ = read_into(request_, files_, result_);
    if (!into_) return false;
  }
  result_.to = into_ ? into_->format : request_.to;
  if (const Message problem = without_use(request_, *result_.to); problem.is_said()) {
    result_.diagnostics.add(problem.code, problem.arguments);
    result_.status = Status::kBadRequest;
    return false;
  }
  if (request_.verify) programs_ = prepare_programs(*result_.to);
  input_ = read_calibration(request_.inputs, files_, result_.diagnostics);
  if (!input_) return false;
  result_.from = input_->format;
  result_.one_format = input_->one_format;
  if (!serves(request_, *input_, result_)) return false;
  if (into_ && !has_use_for(*into_, input_->rig, request_.inputs.files.front(), result_)) return false;
  base_ = base_of(request_, *input_, into_, *result_.to);
  return true;
}

ModelChoice Steps::choice() const {
  ModelChoice choice;
  choice.model = request_.model;
  choice.max_angle_rad = request_.inputs.max_angle_rad;
  choice.every_pixel = request_.every_pixel;
  choice.jobs = request_.jobs;
  choice.objective = request_.objective;
  choice.among = models_for(request_, base_, input_->rig, *result_.to);
  choice.same_format = input_->format == result_.to && input_->one_format;
  return choice;
}

bool Steps::fit() {
  if (!holds_model(request_, base_, input_->rig, *result_.to, result_.diagnostics)) return false;
  const ModelChoice chosen = choice();
  std::optional<std::vector<ConvertedCamera>> cameras =
      convert_cameras(input_->rig.cameras, *result_.to, chosen, result_.diagnostics);
  if (!cameras) return false;
  result_.cameras = *std::move(cameras);
  add_reach(*result_.to, chosen, result_.cameras);
  return put_together();
}

bool Steps::put_together() {
  rig_ = converted_rig(*input_, result_.cameras, request_);
  if (!into_) return true;
  const bool order_given = request_.inputs.cameras && request_.inputs.cameras->size() > 1;
  rig_ = put_into(into_->rig, std::move(rig_), order_given, kept_, result_.diagnostics);
  if (!sizes_agree(*into_, *input_, rig_, request_, result_.diagnostics)) return false;
  for (std::size_t i = 0; i < result_.cameras.size(); ++i) result_.cameras[i].source.name = rig_.cameras[i].name;
  return true;
}

bool Steps::write() {
  const Format& to = *result_.to;
  std::optional<Written> written = write_rig(*input_, rig_, base_, request_, kept_.replaced, result_);
  if (!written || !is_edit_of_base(request_, base_, *written, result_.diagnostics)) return false;
  if (into_) tell_of_kept(kept_, *written, to, result_.diagnostics);
  list_assumed_units(*input_, to, *written);
  const bool edits_input = !into_ && base_.document != nullptr;
  if (edits_input && !request_.inputs.change.changes_nothing())
    list_facts_of_other_images(input_->rig, to, *written, result_.diagnostics);
  if (into_) list_facts_of_other_lenses(into_->rig, rig_, to, *written, result_.diagnostics);
  written_ = *std::move(written);
  name_as_written(to, written_, result_.cameras);
  // Before the settings: what those make of a file is no edit of the input any more.
  add_provenance(request_, *input_, written_, result_);
  if (!apply_settings(request_, to, written_, result_.diagnostics)) return false;
  for (Loss& loss : written_.losses) name_as_in_file(loss, result_.cameras);
  warn_of_wrong_side(rig_, request_, written_.first_is_left, result_);
  return true;
}

bool Steps::place() {
  result_.headline = written_.headline;
  result_.misread_remedy = written_.misread_remedy;
  result_.losses = written_.losses;
  result_.defaults = written_.defaults;
  for (const Written::File& file : written_.files) {
    result_.files.push_back({file.document.source().name, "", file.document.bytes(), file.document.syntax(), file.cameras,
                             file.programs, file.named});
  }
  if (!place_files(request_, result_)) return false;
  // Cameras that no file holds are listed as lost; their fits are nobody's business.
  std::erase_if(result_.cameras, [this](const ConvertedCamera& camera) {
    return std::ranges::none_of(result_.files, [&camera](const ConvertedFile& file) {
      return std::ranges::find(file.cameras, camera.source.name) != file.cameras.end();
    });
  });
  return true;
}

void Steps::prove() {
  const bool edits_it = base_.document != nullptr && base_.into == nullptr;  // then the proof says so
  if (!edits_it) warn_if_refused(*input_, request_.inputs, result_.diagnostics);
  const Rig meant = as_restated(rig_, written_);
  for (const ConvertedFile& file : result_.files) {
    const text::Document* own = input_of(file, written_, *input_);
    verify(meant, file, request_, written_, own != nullptr ? own : base_.document, result_);
  }
}

}  // namespace

ConvertResult convert(const ConvertRequest& request, Files& files) {
  ConvertResult result;
  result.to = request.to;
  result.lens_given = request.inputs.max_angle_rad.has_value() || !request.inputs.lens_circles.empty();
  if (Steps(request, files, result).run()) return result;
  const Status status = status_of(result.diagnostics);
  result.status = worse(result.status, status == Status::kDone ? Status::kBadInput : status);
  return result;
}

}  // namespace fca
