// SPDX-License-Identifier: BSD-3-Clause
#include "conversion.h"

#include "assumptions.h"
#include "at_once.h"
#include "camera_names.h"
#include "into.h"
#include "joined_files.h"
#include "options/option_use.h"
#include "provenance.h"
#include "proving.h"
#include "settings.h"
#include "shell/output_place.h"
#include "shell/words.h"
#include "stale_facts.h"
#include "stereo_order.h"

#include <fca/convert/reach.h>
#include <fca/formats/text/dialect.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <filesystem>

namespace fca::cli {

namespace {

/// A file without a camera was probably meant as a further part.
void explain_no_camera(const ConvertArguments& arguments, const std::string& input, const Calibration& calibration,
                       Diagnostics& diagnostics) {
  const bool imu = !calibration.rig.imus.empty();
  const std::string what = imu ? "an IMU and no camera" : calibration.rig.poses.empty() ? "no camera" : "a pose and no camera";
  const std::string main_file = calibration.format->id == "opencv" ? "intrinsics.yml" : "camchain.yaml";
  const std::string target = arguments.into.empty() ? " --to " + arguments.to : " --into " + arguments.into;
  diagnostics.error("no-camera", "the file holds " + what, {input, 0, 0},
                    "did you mean: fca-io convert " + shell_word(main_file) + " --with " + shell_word(input) + target);
}

Rig converted_rig(const Calibration& calibration, const std::vector<CameraOutcome>& cameras,
                  const ConvertArguments& arguments) {
  Rig rig = calibration.rig;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    rig.cameras[i] = cameras[i].target;
    if (arguments.fps) rig.cameras[i].frame_rate_hz = arguments.fps;
  }
  if (arguments.baseline_m) rig.baseline_m = arguments.baseline_m;
  return rig;
}

/// A model that does not suit the lens is the user's choice, but one to know of.
void warn_of_poor_fits(ConvertOutcome& outcome) {
  constexpr double kPoorRms = 1.0;   // px
  constexpr double kPoorMax = 10.0;  // px
  for (const CameraOutcome& camera : outcome.cameras) {
    if (!camera.report || camera.report->exact) continue;
    const ErrorSummary& error = camera.report->judgement.error;
    if (error.rms <= kPoorRms && error.max <= kPoorMax) continue;
    outcome.diagnostics.warning(
        "poor-fit",
        camera.source.name + ": " + camera.report->to_model + " does not describe this lens: rms " + pixels(error.rms) +
            " px, worst pixel " + pixels(error.max) + " px",
        {}, "fca-io models " + shell_word(outcome.input) + " compares all models; --max-angle DEG if the corners are black");
  }
}

void judge_limits(const ConvertArguments& arguments, ConvertOutcome& outcome) {
  for (const ProofResult& proof : outcome.proofs) {
    if (!arguments.max_error_px || proof.misread_px <= *arguments.max_error_px) continue;
    outcome.diagnostics.error("error-limit",
                              proof.program + " misreads a camera by up to " + pixels(proof.misread_px) +
                                  " px, more than --max-error " + pixels(*arguments.max_error_px),
                              {}, outcome.written.misread_remedy);
    outcome.code = ExitCode::kJudgedBad;
  }
  for (const CameraOutcome& camera : outcome.cameras) {
    if (!arguments.max_error_px || !camera.report) continue;
    // A pixel that is not there is off by more than any limit.
    constexpr double kNoticeable = 1e-3;
    const double missing = camera.report->judgement.coverage.unrepresentable;
    if (missing > kNoticeable || (camera.report->fitted_to_cone && missing > 0.0)) {
      const double reach_deg = camera.report->scored_to_deg;
      outcome.diagnostics.error("error-limit",
                                camera.source.name + ": " + percent(missing) + " of the image has no pixel or a wrong one as " +
                                    camera.report->to_model + ", and --max-error was given",
                                {},
                                "--max-angle " + text::format_short(std::floor(reach_deg), 3) +
                                    (arguments.reading.lens_circles.empty() ? "" : " in place of --lens-circle") +
                                    " if nothing further from the axis is needed");
      outcome.code = ExitCode::kJudgedBad;
    }
    const double worst = camera.report->judgement.error.max;
    if (camera.report->exact || worst <= *arguments.max_error_px) continue;
    outcome.diagnostics.error("error-limit", camera.source.name + ": the worst pixel is off by " + text::format_short(worst) +
                                                 " px, more than --max-error " + text::format_short(*arguments.max_error_px));
    outcome.code = ExitCode::kJudgedBad;
  }
  if (arguments.strict && !outcome.written.losses.empty()) {
    std::vector<std::string> what;
    for (const Loss& loss : outcome.written.losses) what.push_back(loss.what);
    outcome.diagnostics.error("strict-loss", "the target cannot carry " + enumerated(what) + ", and --strict was given");
    outcome.code = ExitCode::kJudgedBad;
  }
}

/// What is written into: the file of --into, or the input itself where the layout stays.
struct Base {
  const text::Document* document = nullptr;
  const Calibration* into = nullptr;
  bool adopted = false;  ///< The input, of another format with the same layout.
};

/// Does the text of --into's file have to stay?
bool keeps_text(const ConvertArguments& arguments, const Base& base) {
  return base.into != nullptr && !arguments.anew && arguments.orbslam3_layout.empty() && arguments.opencv_layout.empty();
}

/// Does a camera of --into's file stay, whose model the input's are to share? A mode that is asked for may leave it out.
bool shares_model(const ConvertArguments& arguments, const Base& base, const Rig& input, const Format& to) {
  return to.one_model && keeps_text(arguments, base) && arguments.sensor.empty() &&
         base.into->rig.cameras.size() > input.cameras.size();
}

/// The models to choose from for the file of --into: a fork's file is of the fork's own, one that keeps a camera of that
/// camera's, another of those that its layout holds; empty: no such limit.
std::vector<std::string> models_for(const ConvertArguments& arguments, const Base& base, const Rig& input, const Format& to) {
  std::vector<std::string> models;
  if (!keeps_text(arguments, base) || to.layout_holds == nullptr || base.into->rig.cameras.empty()) return models;
  const std::string_view own = model_info(base.into->rig.cameras.front().model).id;
  if (find_stored_model(to, own, true) == nullptr || shares_model(arguments, base, input, to)) return {std::string(own)};
  for (const StoredModel& stored : to.models) {
    if (stored.stock && to.layout_holds(*base.document, stored.model)) models.emplace_back(stored.model);
  }
  return models;
}

/// False with an error where --model asks for what the file of --into has no place for.
bool holds_model(const ConvertArguments& arguments, const Base& base, const Rig& input, const Format& to,
                 Diagnostics& diagnostics) {
  const ModelInfo* asked = arguments.model.empty() ? nullptr : find_model(arguments.model);
  const std::vector<std::string> models = models_for(arguments, base, input, to);
  if (asked == nullptr || models.empty()) return true;
  if (shares_model(arguments, base, input, to) && asked->id != models.front()) {
    diagnostics.error(
        "models-differ",
        "a camera stays, of the model " + models.front() + ", and " + std::string(to.title) + " have one model for all cameras",
        {arguments.into, 0, 0}, "--model " + models.front() + ", or an input that has all cameras");
    return false;
  }
  if (to.layout_holds(*base.document, asked->id)) return true;
  diagnostics.error("into-another-layout",
                    "this file's layout has no place for " + std::string(asked->id) + "; it holds " + enumerated(models),
                    {arguments.into, 0, 0}, "--model " + models.front() + " keeps the file's text, --anew writes another file");
  return false;
}

WriteOptions write_options(const ConvertArguments& arguments, const Base& base, std::vector<std::string> replaced) {
  WriteOptions options;
  options.keeps_layout = keeps_text(arguments, base);
  options.replaced = std::move(replaced);
  options.sensor = arguments.sensor;
  options.layout = arguments.orbslam3_layout.empty() ? arguments.opencv_layout : arguments.orbslam3_layout;
  options.frame_rate_hz = arguments.fps;
  options.max_angle_rad = max_angle_rad(arguments.reading);
  options.anew = arguments.anew;
  options.adopted = base.adopted;
  const std::string extension = std::filesystem::path(arguments.output).extension().string();
  options.extension = extension;
  return options;
}

/// Writes the rig in memory: into the base, or anew where its program would refuse what the base's own layout makes of it.
std::optional<Written> write_rig(const Calibration& source, const Rig& rig, const Base& base, const ConvertArguments& arguments,
                                 std::vector<std::string> replaced, ConvertOutcome& outcome) {
  WriteOptions options = write_options(arguments, base, std::move(replaced));
  if (source.documents.size() > 1 && base.into == nullptr && !arguments.anew && arguments.reading.join) {
    std::optional<Written> each;
    if (!changes_images(arguments.reading))
      each = write_each_into_its_own(source, rig, *outcome.to, options, outcome.diagnostics);
    if (each || outcome.diagnostics.has_errors()) return each;
    // The first file may be edited; the others' text is gone in any case.
    if (source.format == outcome.to) options.joined = std::span(source.documents).subspan(base.document != nullptr ? 1 : 0);
  }
  std::optional<Written> written = write_calibration(*outcome.to, base.document, rig, options, outcome.diagnostics);
  if (!written || base.document == nullptr || arguments.no_verify || arguments.anew) return written;
  const bool edited = written->files.front().document.edited();
  const bool loads = (edited || base.into != nullptr) && mend_kept_text(*written, outcome.diagnostics);
  if (loads || keeps_text(arguments, base)) return written;
  const bool asked_for = !options.layout.empty() || edited;
  // An input is to become a file that the program reads: OpenVINS' first line in a camchain is no base for Kalibr. A file that
  // is written into is its owner's, who has another program for it.
  const text::Document* owners = base.into != nullptr ? base.document : nullptr;
  const std::optional<std::string> refusal = asked_for ? newly_refused(*written, owners) : std::nullopt;
  if (!refusal) return written;
  options.anew = true;
  outcome.diagnostics.note("layout-not-kept",
                           "written anew, without the base's comments, because its layout cannot be kept: " + *refusal);
  return write_calibration(*outcome.to, base.document, rig, options, outcome.diagnostics);
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

/// False with an error where the file of --into, whose text is to stay, would be composed anew. Lines of words (DSO's
/// camera.txt) are never made a YAML file.
bool is_edit_of_base(const ConvertArguments& arguments, const Base& base, const Written& written, Diagnostics& diagnostics) {
  if (base.into == nullptr) return true;
  const text::Document& document = written.files.front().document;
  const bool words = base.document->syntax() == text::Syntax::kWords;
  const bool kept = words ? document.syntax() == text::Syntax::kWords
                          : document.source().bytes == base.document->source().bytes || !keeps_text(arguments, base);
  if (kept) return true;
  diagnostics.error("into-another-layout", "what the input says does not fit into the layout of this file",
                    {arguments.into, 0, 0},
                    words ? "--to " + std::string(base.into->format->id) + " -o OTHER.yaml writes another file"
                          : "--anew writes another file and lists what of this one goes");
  return false;
}

bool contradicts(const ConvertArguments& arguments, const Calibration& calibration, ConvertOutcome& outcome) {
  if (!arguments.baseline_m || calibration.rig.cameras.size() < 2) return false;
  outcome.diagnostics.error("baseline-contradicts",
                            "--baseline is for one camera of a rectified pair or depth sensor; here are " +
                                std::to_string(calibration.rig.cameras.size()) + " cameras with poses of their own",
                            {outcome.input, 0, 0}, "choose one with --camera");
  outcome.code = ExitCode::kUsage;
  return true;
}

/// The file of one IMU and the poses of another: where that one stands nobody said.
bool imu_is_another(const Rig& rig, const std::string& input, Diagnostics& diagnostics) {
  const auto is_posed = [&rig](const std::string& name) {
    return std::ranges::any_of(rig.poses, [&name](const PoseEdge& edge) { return edge.a == name || edge.b == name; });
  };
  const auto is_imu = [](const std::string& frame) { return frame.starts_with("imu"); };
  if (rig.imus.empty() || std::ranges::any_of(rig.imus, is_posed, &Imu::name)) return false;
  const auto other = std::ranges::find_if(rig.poses, [&](const PoseEdge& edge) { return is_imu(edge.a) || is_imu(edge.b); });
  if (other == rig.poses.end()) return false;
  const std::string& posed = is_imu(other->a) ? other->a : other->b;
  const std::string& given = rig.imus.front().name;
  diagnostics.error("imu-without-pose", "the cameras' poses are to " + posed + ", and the IMU that is given is " + given,
                    {input, 0, 0}, "give the file of " + posed + "'s noise, or rename " + given + " if it is that one");
  return true;
}

/// --into's file. Under --to, that must be its format. --size is about the input.
std::optional<Calibration> read_into(const ConvertArguments& arguments, Console& console, ConvertOutcome& outcome) {
  ReadingOptions reading;
  reading.opencv_model = arguments.reading.opencv_model;
  std::optional<Calibration> into = read_input(arguments.into, reading, console, outcome.diagnostics);
  if (into && into->rig.cameras.empty() && into->rig.poses.empty()) {
    outcome.diagnostics.error("into-without-camera", "there is no camera here that the input's could take the place of",
                              {arguments.into, 0, 0}, "--into wants the file that holds the cameras; -o FILE writes a new one");
    outcome.code = ExitCode::kUsage;
    return std::nullopt;
  }
  if (!into || arguments.to.empty() || find_format(arguments.to) == into->format) return into;
  outcome.diagnostics.error("into-another-format",
                            "the file is " + std::string(into->format->title) + ", and --to says " + arguments.to,
                            {arguments.into, 0, 0}, "leave out --to");
  outcome.code = ExitCode::kUsage;
  return std::nullopt;
}

/// stereo_calib's extrinsics.yml holds a pose and no camera: an input without one would change nothing in it.
bool has_use_for(const Calibration& into, const Rig& rig, const std::string& input, ConvertOutcome& outcome) {
  if (!into.rig.cameras.empty() || says_a_pose_of(into.rig, rig)) return true;
  const Rig& pose = into.rig;
  outcome.diagnostics.error(
      "pose-missing",
      input + " states no pose between two cameras" + (rig.cameras.size() < 2 ? " (it has one)" : "") + ", and " +
          into.documents.front().source().name + " holds only that of " + pose.poses.front().b + " and " + pose.poses.front().a,
      {input, 0, 0}, "an input of both cameras and their pose goes into it; --to opencv -o OTHER.yml writes the cameras");
  return false;
}

/// What the same fits would reach if the lens ended earlier, where nothing says where it ends.
void add_reach(const Format& to, const ModelChoice& choice, std::vector<CameraOutcome>& cameras) {
  at_once(cameras.size(), choice.jobs, [&](std::size_t i) {
    CameraOutcome& camera = cameras[i];
    const StoredModel* stored = find_stored_model(to, model_info(camera.target.model).id, false);
    if (!camera.report || camera.report->exact || stored == nullptr) return;
    Diagnostics told_already;
    camera.report->reach = reach_table(camera.source, options_for(*stored, choice), *camera.report, told_already);
  });
}

/// A base for images of one size is not silently made one for images of another, whose thresholds and columns differ: false
/// with an error. An input that is written into itself is the owner's to change.
bool sizes_agree(const Calibration& base, const Calibration& input, const Rig& rig, const ConvertArguments& arguments,
                 Diagnostics& diagnostics) {
  if (!arguments.reading.resize.empty()) return true;
  const auto& bytes = base.documents.front().source().bytes;
  if (changes_images(arguments.reading) && input.documents[input.with_cameras].source().bytes == bytes) return true;
  for (const Camera& camera : rig.cameras) {
    const Camera* before = base.rig.find_camera(camera.name);
    if (before == nullptr || !before->image_size || !camera.image_size || before->image_size == camera.image_size) continue;
    const auto resize = [](const ImageSize& size) {
      return "--resize " + std::to_string(size.width) + "x" + std::to_string(size.height);
    };
    diagnostics.error("size-contradicts",
                      camera.name + ": the base is for images of " + size_in_words(*before->image_size) +
                          " px, and the input's are of " + size_in_words(*camera.image_size) + " px",
                      {arguments.into, 0, 0},
                      resize(*before->image_size) + " if the base's images are the input's, scaled; " +
                          resize(*camera.image_size) + " if the base is to become one for the input's");
    return false;
  }
  return true;
}

/// Of joined files of the target's own format the first is edited, and takes the others' cameras.
bool edits_first(const Calibration& calibration, const ConvertArguments& arguments, const Format& to) {
  return arguments.reading.join && !arguments.anew && calibration.one_format && calibration.format == &to && to.many_cameras &&
         calibration.with_cameras == 0;
}

/// Of joined files the one that an output is an edit of; null if it is none.
const text::Document* input_of(const ConvertOutcome::Output& output, const Written& written, const Calibration& calibration) {
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
  Steps(const std::vector<std::string>& inputs, const ConvertArguments& arguments, Console& console, ConvertOutcome& outcome)
      : inputs_(inputs), arguments_(arguments), console_(console), outcome_(outcome) {}

  [[nodiscard]] bool run() {
    if (!read() || !fit() || !write() || !place_outputs(arguments_, outcome_)) return false;
    if (!arguments_.no_verify) prove();
    warn_of_poor_fits(outcome_);
    judge_limits(arguments_, outcome_);
    return true;
  }

 private:
  /// Into calibration_, into_ and base_.
  [[nodiscard]] bool read();
  [[nodiscard]] Base base() const;
  [[nodiscard]] ModelChoice choice() const;
  /// Into the outcome's cameras.
  [[nodiscard]] bool fit();
  /// Into rig_: the cameras that were fitted, in the rig of the input, or of --into's file.
  [[nodiscard]] bool put_together();
  /// Into the outcome's files.
  [[nodiscard]] bool write();
  void prove();

  const std::vector<std::string>& inputs_;
  const ConvertArguments& arguments_;
  Console& console_;
  ConvertOutcome& outcome_;
  std::optional<Calibration> into_;         ///< --into's file.
  std::future<void> programs_;              ///< Made ready while the input is read.
  std::optional<Calibration> calibration_;  ///< The input.
  Base base_;
  Rig rig_;    ///< What is written.
  Kept kept_;  ///< Of --into's file.
};

bool Steps::read() {
  if (!arguments_.into.empty()) {
    into_ = read_into(arguments_, console_, outcome_);
    if (!into_) return false;
  }
  outcome_.to = into_ ? into_->format : find_format(arguments_.to);
  if (const std::optional<std::string> problem = option_without_use(arguments_, *outcome_.to)) {
    outcome_.diagnostics.error("option-without-use", *problem);
    outcome_.code = ExitCode::kUsage;
    return false;
  }
  if (!arguments_.no_verify) programs_ = prepare_programs(*outcome_.to);
  calibration_ = read_input(inputs_, arguments_.reading, console_, outcome_.diagnostics);
  if (!calibration_) return false;
  outcome_.from = calibration_->format;
  outcome_.one_format = calibration_->one_format;
  const bool imu_file = outcome_.to->imu_file && !into_ && !calibration_->rig.imus.empty();
  if (calibration_->rig.cameras.empty() && !imu_file) {
    explain_no_camera(arguments_, outcome_.input, *calibration_, outcome_.diagnostics);
    return false;
  }
  if (contradicts(arguments_, *calibration_, outcome_)) return false;
  if (imu_is_another(calibration_->rig, outcome_.input, outcome_.diagnostics)) return false;
  if (into_ && !has_use_for(*into_, calibration_->rig, outcome_.input, outcome_)) return false;
  base_ = base();
  return true;
}

Base Steps::base() const {
  if (into_) return {&into_->documents.front(), &*into_};
  const text::Document& main_file = calibration_->documents[calibration_->with_cameras];
  const bool one_file = inputs_.size() == 1 || edits_first(*calibration_, arguments_, *outcome_.to);
  if (!one_file || !is_base_of(*calibration_->format, main_file, *outcome_.to)) return {};
  return {&main_file, nullptr, calibration_->format != outcome_.to};
}

ModelChoice Steps::choice() const {
  ModelChoice choice;
  choice.model = arguments_.model;
  choice.max_angle_rad = max_angle_rad(arguments_.reading);
  choice.every_pixel = arguments_.every_pixel;
  choice.jobs = arguments_.jobs;
  choice.objective = arguments_.objective == "max" ? Objective::kMax : Objective::kRms;
  choice.among = models_for(arguments_, base_, calibration_->rig, *outcome_.to);
  choice.same_format = calibration_->format == outcome_.to && calibration_->one_format;
  return choice;
}

bool Steps::fit() {
  if (!holds_model(arguments_, base_, calibration_->rig, *outcome_.to, outcome_.diagnostics)) return false;
  const ModelChoice chosen = choice();
  std::optional<std::vector<CameraOutcome>> cameras =
      convert_cameras(calibration_->rig.cameras, *outcome_.to, chosen, outcome_.diagnostics);
  if (!cameras) return false;
  outcome_.cameras = *std::move(cameras);
  add_reach(*outcome_.to, chosen, outcome_.cameras);
  return put_together();
}

bool Steps::put_together() {
  rig_ = converted_rig(*calibration_, outcome_.cameras, arguments_);
  if (!into_) return true;
  const bool order_given = arguments_.reading.cameras.value_or("").find(',') != std::string::npos;
  rig_ = put_into(into_->rig, std::move(rig_), order_given, kept_, outcome_.diagnostics);
  if (!sizes_agree(*into_, *calibration_, rig_, arguments_, outcome_.diagnostics)) return false;
  for (std::size_t i = 0; i < outcome_.cameras.size(); ++i) outcome_.cameras[i].source.name = rig_.cameras[i].name;
  return true;
}

bool Steps::write() {
  const Format& to = *outcome_.to;
  std::optional<Written> written = write_rig(*calibration_, rig_, base_, arguments_, kept_.replaced, outcome_);
  if (!written || !is_edit_of_base(arguments_, base_, *written, outcome_.diagnostics)) return false;
  if (into_) tell_of_kept(kept_, *written, to, outcome_.diagnostics);
  list_assumed_units(*calibration_, to, *written);
  if (!into_ && base_.document != nullptr && changes_images(arguments_.reading))
    list_facts_of_other_images(calibration_->rig, to, *written, outcome_.diagnostics);
  if (into_) list_facts_of_other_lenses(into_->rig, rig_, to, *written, outcome_.diagnostics);
  if (!have_place(arguments_, *written, outcome_)) return false;
  outcome_.written = *std::move(written);
  name_as_written(to, outcome_.written, outcome_.cameras);
  // Before --set: what that makes of a file is no edit of the input any more.
  add_provenance(arguments_, *calibration_, outcome_);
  if (!apply_settings(arguments_, to, outcome_.written, outcome_.diagnostics)) return false;
  for (Loss& loss : outcome_.written.losses) {
    loss.what = with_names_of_file(loss.what, outcome_.cameras);
    loss.remedy = with_names_of_file(loss.remedy, outcome_.cameras);
  }
  warn_of_wrong_side(rig_, arguments_, outcome_, outcome_.diagnostics);
  return true;
}

void Steps::prove() {
  const bool edits_it = base_.document != nullptr && base_.into == nullptr;  // then the proof says so
  if (!edits_it) warn_if_refused(*calibration_, arguments_.reading.opencv_model, outcome_.diagnostics);
  const Rig meant = as_restated(rig_, outcome_.written);
  for (const ConvertOutcome::Output& output : outcome_.outputs) {
    const text::Document* own = input_of(output, outcome_.written, *calibration_);
    verify(meant, output, arguments_, own != nullptr ? own : base_.document, outcome_);
  }
}

}  // namespace

ConvertOutcome convert_inputs(const std::vector<std::string>& inputs, const ConvertArguments& arguments, Console& console) {
  ConvertOutcome outcome;
  outcome.input = inputs.front();
  outcome.to = find_format(arguments.to);
  outcome.lens_given = max_angle_rad(arguments.reading).has_value() || !arguments.reading.lens_circles.empty();
  if (Steps(inputs, arguments, console, outcome).run()) return outcome;
  const ExitCode code = code_of(outcome.diagnostics);
  outcome.code = worse(outcome.code, code == ExitCode::kGood ? ExitCode::kBadInput : code);
  return outcome;
}

}  // namespace fca::cli
