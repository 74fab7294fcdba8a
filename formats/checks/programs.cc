// SPDX-License-Identifier: BSD-3-Clause
#include "../lengths.h"
#include "../uncertainties.h"
#include "complaints.h"
#include "topics.h"

#include <fca/code.h>
#include <fca/formats/fix.h>
#include <fca/formats/program_names.h>
#include <fca/formats/text/dialect.h>
#include <fca/formats/verdict.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace fca::checks {

namespace {

using consumers::Complaint;
using consumers::Consumer;
using consumers::ConsumerView;

/// What a program reads from the file in one of its modes.
struct Attempt {
  std::string mode;  ///< Empty: it has none.
  ConsumerView view;
};

/// Sentences of a program that are told one by one: for each its parser is asked again and again for a fix.
constexpr std::size_t kMostSaid = 10;

bool has_fix(const Complaint& complaint) { return !info(complaint.facts.code).fix.empty(); }

bool names_program(const Complaint& complaint) {
  return find_clause(complaint.facts, [](const Message& each) { return info(each.code).names_program; }) != nullptr;
}

/// The modes that a file's keys speak for, the richest first; the others would not use what stands there.
std::string meant_mode(const text::Document& document) {
  const auto has = [&document](std::string_view key) {
    return text::find(document.root(), key, text::Dialect::kOpenCv) != nullptr;
  };
  const auto any = [&has](auto... keys) { return (has(keys) || ...); };
  std::string mode = "mono";
  if (any("Stereo.T_c1_c2", "Camera2.fx", "Tlr", "Stereo.b", "Camera.bf")) mode = "stereo";
  if (any("RGBD.DepthMapFactor", "DepthMapFactor")) mode = "rgbd";
  if (any("IMU.T_b_c1", "Tbc", "IMU.NoiseGyro")) mode += "-inertial";
  return mode;
}

class ProgramsCheck {
 public:
  ProgramsCheck(const text::Document& document, const Format& format, const Calibration* calibration,
                const CheckOptions& options, CheckReport& report)
      : document_(document), format_(format), calibration_(calibration), options_(options), report_(report), findings_(report) {
    if (calibration != nullptr) with_cameras_ = !calibration->rig.cameras.empty();
  }

  void run() {
    if (calibration_ != nullptr && is_uncertainty_alone(calibration_->rig)) {
      findings_.undecided(Code::kProgramNoneAlone);
      return;
    }
    report_.readers = ask_readers(format_.id, document_.source().bytes, with_cameras_, load_options(options_.reading, {}));
    const Consumer* own =
        options_.program != nullptr ? options_.program : consumers::own_program(format_.id, with_cameras_.value_or(true));
    if (own == nullptr) {
      if (with_cameras_) {
        findings_.undecided(Code::kProgramNoneAlone);
      }
      return;
    }
    if (!own->reads(format_.id)) {
      say_other_format(*own);
      return;
    }
    const std::vector<Attempt> attempts = attempt(*own);
    report_.checked.push_back({Code::kCheckedProgram, {own->program}});
    prove_meant_mode(*own);
    // What the keys are for counts; if that is refused, whatever starts.
    auto loaded = std::ranges::find(attempts, format_.modes.empty() ? "" : meant_mode(document_), &Attempt::mode);
    if (loaded == attempts.end() || !loaded->view.loads())
      loaded = std::ranges::find_if(attempts, [](const Attempt& each) { return each.view.loads(); });
    if (loaded == attempts.end()) {
      say_refusals(*own, attempts);
    } else {
      say_warnings(*own, *loaded);
      say_refused_mode(*own, attempts);
    }
  }

 private:
  [[nodiscard]] consumers::LoadOptions asked(const Consumer& program, std::string mode = {}) const {
    consumers::LoadOptions options = load_options(options_.reading, std::move(mode));
    const std::string& name = document_.source().name;
    const std::string_view right = program.writing.equidistant_file_name;
    // Else another program is meant, perhaps.
    if (options_.program != nullptr || (!right.empty() && name.ends_with(right))) options.file_name = name;
    return options;
  }

  [[nodiscard]] std::vector<Attempt> attempt(const Consumer& program) const {
    std::vector<Attempt> attempts;
    if (format_.modes.empty()) attempts.push_back({"", {}});
    for (const std::string_view mode : format_.modes) attempts.push_back({std::string(mode), {}});
    for (Attempt& each : attempts) each.view = program.load(document_.source().bytes, asked(program, each.mode));
    return attempts;
  }

  /// What the program reads of the cameras in the mode that the keys are for.
  void prove_meant_mode(const Consumer& program) {
    if (calibration_ == nullptr) return;
    const std::string mode = format_.modes.empty() ? "" : meant_mode(document_);
    report_.mode = mode;
    report_.proof = prove(program, document_.source().bytes, asked(program, mode), rig_in_stated_unit(),
                          options_.max_angle_rad.value_or(std::numbers::pi));
    if (report_.proof->loads || options_.program != nullptr) return;  // whoever asks for a program has that one
    for (const Readers::Program& other : report_.readers.programs) {
      if (other.loads && other.program != program.program) report_.proof->read_by.push_back(other.program);
    }
  }

  /// The program has no unit of lengths: what the file says is compared, in its own unit.
  [[nodiscard]] Rig rig_in_stated_unit() const {
    Rig rig = calibration_->rig;
    const double unit_m = format_.leaves_unit_open() ? options_.reading.length_unit_m.value_or(1.0) : 1.0;
    for (PoseEdge& edge : rig.poses) scale_translation(1.0 / unit_m, edge.T_a_b);
    return rig;
  }

  [[nodiscard]] SourceRange whole_file() const { return {document_.source().name, 0, 0}; }

  [[nodiscard]] SourceRange place_of(const Complaint& complaint) const {
    const text::Node* node = node_at(document_, complaint.key);
    if (node == nullptr) return whole_file();
    SourceRange where = document_.range(*node);
    if (!node->is_scalar()) where.length = std::min<std::size_t>(where.length, 1);
    return where;
  }

  [[nodiscard]] Message how_to_write_for(const Consumer& program) const {
    const consumers::Writing& writing = program.writing;
    const Format& to = *find_format(program.format);
    std::vector<Message> how;
    if (!writing.model.empty()) how.push_back({Code::kConvertWithModel, {writing.model}});
    if (!writing.layout.empty()) how.push_back({Code::kConvertWithLayout, {program.format, writing.layout}});
    // An input of that very format keeps its own text, where nothing else is asked for.
    if (&to == &format_ && writing.layout.empty()) how.push_back({Code::kConvertWithRewrite});
    const bool has_size = calibration_ == nullptr || std::ranges::all_of(calibration_->rig.cameras, [](const Camera& camera) {
                            return camera.image_size.has_value();
                          });
    if (!has_size) how.push_back({Code::kConvertWithSize});
    const bool has_several = calibration_ != nullptr && calibration_->rig.cameras.size() > 1;
    const bool has_imu_file = calibration_ != nullptr && !calibration_->rig.imus.empty() && to.imu_file;
    const bool has_further_files = has_several && (!to.many_cameras || to.poses_apart || !writing.file_name.empty());
    const bool has_name = !has_several && !writing.file_name.empty();
    if (has_imu_file || has_further_files) how.push_back({Code::kConvertToFiles});
    if (has_name) how.push_back({Code::kConvertUnderName, {writing.file_name}});
    if (!has_imu_file && !has_further_files && !has_name) how.push_back({Code::kConvertToFile, {to.extension}});
    const ProgramName* name = find_program_name(program.id);
    const std::string_view name_of_it =
        name != nullptr && (name->consumer == program.id || !name->extension.empty()) ? program.id : program.format;
    return {Code::kConvertFor, {document_.source().name, name_of_it, how}};
  }

  /// " (and 3 more)" after the first of several.
  static std::vector<Message> and_more(std::span<const Complaint> complaints) {
    if (complaints.size() < 2) return {};
    return {{Code::kAndMore, {complaints.size() - 1}}};
  }

  void say_other_format(const Consumer& program) {
    findings_.add(Code::kProgramOtherFormat, {format_.title, program.program, how_to_write_for(program)}, whole_file());
  }

  [[nodiscard]] std::optional<Fix> fix_for(const Consumer& program, const Attempt& attempt, const Complaint& complaint) const {
    const consumers::LoadOptions options = asked(program, attempt.mode);
    return find_fix(document_, attempt.view, complaint, [&](const std::string& bytes) { return program.load(bytes, options); });
  }

  /// One refusal or warning, at its place, with the fix if there is a certain one.
  void say(Finding finding, const Consumer& program, const Attempt& attempt, const Complaint& complaint) {
    finding.where = place_of(complaint);
    if (const std::optional<Fix> fix = fix_for(program, attempt, complaint)) {
      finding.kind = fix->remedy.code;
      const text::Span line = document_.source().line_at(fix->span.offset);
      // A line that is put in before is wanted where the first one stands.
      const std::size_t length = std::min(std::max<std::size_t>(fix->span.length, 1), line.end() - fix->span.offset);
      finding.where = document_.source().range({fix->span.offset, length});
      finding.edit = SpanEdit{fix->span, fix->text};
      finding.remedy = fix->remedy;
    }
    findings_.add(std::move(finding));
  }

  void say_refusal(const Consumer& program, const Attempt& attempt, const Complaint& complaint) {
    Finding finding;
    if (names_program(complaint)) {
      finding.facts = {Code::kProgramRefusesInItsWords, {complaint.facts}};
    } else {
      std::vector<Message> in_mode;
      if (!attempt.mode.empty() && attempt.mode != "mono") in_mode = {{Code::kInMode, {attempt.mode}}};
      finding.facts = {Code::kProgramRefuses, {program.program, in_mode, complaint.facts}};
    }
    // Whoever asks for a program may have the file of another.
    const bool others_read =
        options_.program != nullptr && std::ranges::any_of(report_.readers.programs, &Readers::Program::loads);
    if (has_fix(complaint) && !others_read) {
      finding.remedy = complaint.facts;
    } else if (calibration_ != nullptr && !calibration_->rig.cameras.empty()) {
      finding.remedy = {Code::kCorrectOrRewrite, {how_to_write_for(program)}};
    }
    say(std::move(finding), program, attempt, complaint);
  }

  void say_refusals(const Consumer& own, const std::vector<Attempt>& attempts) {
    const auto fewest = std::ranges::min_element(attempts, {}, [](const Attempt& each) { return each.view.refusals.size(); });
    const std::vector<Complaint>& refusals = fewest->view.refusals;
    if (fewest->view.finds_no_camera && with_cameras_.value_or(false)) {
      findings_.add(Code::kProgramFindsNoCamera, {refusals.front().facts}, whole_file());
      if (options_.program != nullptr) return;
      report_.proof.reset();
      report_.has_reader = false;
      return;
    }
    const bool another_reads =
        options_.program == nullptr && std::ranges::any_of(report_.readers.programs, [](const Readers::Program& program) {
          return program.loads && !program.other_syntax;
        });
    if (another_reads) {
      say_read_by_another(own, *fewest);
      return;
    }
    if (raise_wrong_parser()) return;
    // One that lacks that much is laid out for another program.
    const bool is_for_another =
        refusals.size() > kMostSaid && std::ranges::any_of(report_.readers.programs, &Readers::Program::loads);
    const std::size_t most = is_for_another ? 1 : kMostSaid;
    for (std::size_t i = 0; i < std::min(most, refusals.size()); ++i) say_refusal(own, *fewest, refusals[i]);
    if (is_for_another) {
      if (!report_.findings.back().edit) report_.findings.back().remedy = how_to_write_for(own);
      return;
    }
    say_more(refusals.size(), most, Code::kProgramRefusesMore);
  }

  void say_more(std::size_t count, std::size_t said, Code code) {
    if (count > said) findings_.add(code, {count - said}, whole_file());
  }

  /// With the wrong parser chosen every key is missing: one reason for all refusals, which the reader has said.
  bool raise_wrong_parser() {
    for (Finding& finding : report_.findings) {
      const bool missing = finding.facts.code == Code::kOrbslam3VersionMissing;
      if (!missing && finding.facts.code != Code::kOrbslam3VersionNotString) continue;
      finding.severity = Severity::kError;
      if (missing) {
        const std::size_t first = document_.source().line_at(document_.root().entries.front().key.span.offset).offset;
        finding.edit = SpanEdit{{first, 0}, "File.version: \"1.0\"" + std::string(document_.source().line_break())};
        finding.remedy = {Code::kAddFileVersion};
      }
      const text::Node* version = text::find(document_.root(), "File.version", text::Dialect::kOpenCv);
      if (version != nullptr && version->value == "1.0") finding.edit = SpanEdit{version->span, "\"1.0\""};
      return true;
    }
    return false;
  }

  /// A fork's file: right for the fork, and not for the format's own program.
  void say_read_by_another(const Consumer& own, const Attempt& closest) {
    std::vector<std::string> readers;
    for (const Readers::Program& program : report_.readers.programs) {
      if (program.loads) readers.push_back(program.program);
    }
    const std::vector<Complaint>& refusals = closest.view.refusals;
    findings_.add(Code::kReadByAnother,
                  {readers, own.program, refusals.front().facts, and_more(refusals), how_to_write_for(own)},
                  place_of(refusals.front()));
  }

  void say_warnings(const Consumer& own, const Attempt& attempt) {
    if (format_.reader_warns) return;
    const ConsumerView& view = attempt.view;
    for (std::size_t i = 0; i < std::min(kMostSaid, view.warnings.size()); ++i) {
      const Complaint& warning = view.warnings[i];
      Finding finding;
      finding.severity = severity_of(view, warning);
      if (names_program(warning)) {
        finding.facts = {Code::kProgramMisreadsInItsWords, {warning.facts}};
      } else {
        finding.facts = {Code::kProgramMisreads, {own.program, warning.facts}};
      }
      if (has_fix(warning)) {
        finding.outcome = {Code::kWhatNeedsItStops};
        finding.remedy = warning.facts;
      }
      say(std::move(finding), own, attempt, warning);
    }
    say_more(view.warnings.size(), kMostSaid, Code::kProgramMisreadsMore);
  }

  /// As far as the program's pixels of the camera are off that the warning is about; where no warning names that camera, it may
  /// be any. A warning where no camera is known to be misread.
  [[nodiscard]] Severity severity_of(const ConsumerView& view, const Complaint& warning) const {
    const std::size_t known = report_.proof ? std::min(view.cameras.size(), report_.proof->cameras.size()) : 0;
    std::optional<Severity> worst;
    for (std::size_t i = 0; i < known; ++i) {
      const consumers::ConsumerCamera& camera = view.cameras[i];
      const auto names_it = [&camera](const Complaint& each) { return each.key.starts_with(camera.name + "/"); };
      const bool is_about_it = names_it(warning) || std::ranges::none_of(view.warnings, names_it);
      const PixelDistance& distance = report_.proof->cameras[i].distance.decisive();
      if (!camera.misread || !is_about_it || !(distance.region > 0.0)) continue;
      constexpr double kSeen = 1.0;  // px
      const VerdictWord word = word_of(distance);
      const bool is_small = warning.costs_pixels && word == VerdictWord::kReady && distance.max <= kSeen;
      const Severity severity = word == VerdictWord::kDoNotUse ? Severity::kError
                                : is_small                     ? Severity::kNote
                                                               : Severity::kWarning;
      worst = std::max(worst.value_or(severity), severity);
    }
    return worst.value_or(Severity::kWarning);
  }

  /// It loads in some mode, but not in the one for which its keys stand there.
  void say_refused_mode(const Consumer& own, const std::vector<Attempt>& attempts) {
    if (format_.modes.empty()) return;
    const std::string mode = meant_mode(document_);
    const auto meant = std::ranges::find(attempts, mode, &Attempt::mode);
    if (meant == attempts.end() || meant->view.loads()) return;
    std::vector<std::string> modes;
    for (const Attempt& each : attempts) {
      if (each.view.loads()) modes.push_back(each.mode);
    }
    const std::vector<Complaint>& refusals = meant->view.refusals;
    Finding finding;
    finding.severity = Severity::kWarning;
    finding.facts = {Code::kModeRefused, {mode, own.program, modes, refusals.front().facts, and_more(refusals)}};
    finding.where = place_of(refusals.front());
    if (const std::optional<Fix> fix = fix_for(own, *meant, refusals.front())) {
      finding.remedy = fix->remedy;
      finding.edit = SpanEdit{fix->span, fix->text};
    }
    findings_.add(std::move(finding));
  }

  const text::Document& document_;
  const Format& format_;
  const Calibration* calibration_;
  std::optional<bool> with_cameras_;
  const CheckOptions& options_;
  CheckReport& report_;
  Findings findings_;
};

}  // namespace

void check_programs(const text::Document& document, const Format& format, const Calibration* calibration,
                    const CheckOptions& options, CheckReport& report) {
  ProgramsCheck(document, format, calibration, options, report).run();
}

}  // namespace fca::checks
