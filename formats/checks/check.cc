// SPDX-License-Identifier: BSD-3-Clause
#include "deduplicate.h"
#include "exchange.h"
#include "parts.h"
#include "subject.h"
#include "tab_fix.h"
#include "topics.h"

#include <fca/code.h>
#include <fca/convert/field_of_view.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>
#include <fca/formats/verdict.h>
#include <fca/formats/wording.h>
#include <fca/rig/contradictions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace fca {

namespace checks {

void Findings::add(Finding finding) {
  if (consequence_of(finding).empty()) {
    if (const CodeInfo* general = find_check_code(id_of(finding))) finding.outcome = {general->code};
  }
  report_.findings.push_back(std::move(finding));
}

void Findings::add(Code code, std::vector<Argument> arguments, SourceRange where) {
  add(info(code).severity, code, std::move(arguments), std::move(where));
}

void Findings::add(Severity severity, Code code, std::vector<Argument> arguments, SourceRange where) {
  Finding finding;
  finding.severity = severity;
  finding.where = std::move(where);
  finding.facts = {code, std::move(arguments)};
  add(std::move(finding));
}

void Findings::add(Code code, std::vector<Argument> arguments, SourceRange where, SpanEdit edit) {
  Finding finding;
  finding.severity = info(code).severity;
  finding.where = std::move(where);
  finding.facts = {code, std::move(arguments)};
  finding.edit = std::move(edit);
  add(std::move(finding));
}

bool Findings::has(Code code, const SourceRange& where) const {
  return std::ranges::any_of(report_.findings, [&](const Finding& finding) {
    return same_id(code_of(finding), code) && finding.where.offset == where.offset && finding.where.file == where.file;
  });
}

bool Findings::has(Code code, const std::function<SourceRange()>& where) const {
  return has_any(std::span(&code, 1)) && has(code, where());
}

bool Findings::has_any(std::span<const Code> codes) const {
  return std::ranges::any_of(report_.findings, [codes](const Finding& finding) { return same_id(code_of(finding), codes); });
}

bool Findings::has_any(std::span<const Code> codes, const Rig& rig, const std::string& camera) const {
  return std::ranges::any_of(report_.findings, [&](const Finding& finding) {
    if (finding.severity == Severity::kNote || !same_id(code_of(finding), codes)) return false;
    const auto* name =
        finding.facts.arguments.empty() ? nullptr : std::get_if<std::string>(&finding.facts.arguments.front().value);
    return name == nullptr || *name == camera || rig.find_camera(*name) == nullptr;
  });
}

namespace {

struct Topic {
  Code checked;  ///< Of a file that gave it something to look at.
  bool (*check)(const Subject&, Findings&);
  bool Format::*of = nullptr;  ///< It is about what formats with this hold; null: about the cameras, which all hold.
};

constexpr std::array kTopics = {
    Topic{Code::kCheckedImage, &check_image},
    Topic{Code::kCheckedLens, &check_lens},
    Topic{Code::kCheckedFamily, &check_family},
    Topic{Code::kCheckedUndistortion, &check_undistortion},  // not with numbers that those before do not believe
    Topic{Code::kCheckedRotations, &check_rotations, &Format::extrinsics},
    Topic{Code::kCheckedPoses, &check_redundant_poses, &Format::extrinsics},
    Topic{Code::kCheckedDistances, &check_distances, &Format::extrinsics},  // not those that the poses before have named
    Topic{Code::kCheckedImu, &check_imu, &Format::imu},
    Topic{Code::kCheckedTime, &check_time, &Format::time_offset},
    Topic{Code::kCheckedOcamcalib, &check_ocamcalib},
    Topic{Code::kCheckedOrbslam3, &check_orbslam3},
    Topic{Code::kCheckedStella, &check_stella},
};

/// Why the reader gives up, where the fault is ours: the file may be right.
constexpr std::array kBeyondUs = {Code::kAnySkew};

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// The edits that certainly fix what parsers and readers report.
std::optional<SpanEdit> edit_for(const Diagnostic& entry, const text::Source& source) {
  if (source.is_binary()) return std::nullopt;
  const text::Span span = {entry.where.offset, entry.where.length};
  if (entry.facts.code == Code::kYamlBlankMissing) return SpanEdit{{span.offset, 0}, " "};
  if (same_id(code_of(entry), Code::kAnyNotAnInteger)) {
    const std::optional<double> value = text::parse_real(source.text(span));
    constexpr double kLargest = 1e9;
    if (!value || *value != std::floor(*value) || std::abs(*value) > kLargest) return std::nullopt;
    return SpanEdit{span, std::to_string(static_cast<long long>(*value))};
  }
  if (entry.facts.code == Code::kYamlTab) {
    const std::optional<Fix> fix = tab_fix(source);
    if (!fix) return std::nullopt;
    text::Source blanks = source;
    blanks.bytes.replace(fix->span.offset, fix->span.length, fix->text);
    Diagnostics discarded;
    if (text::parse_document(std::move(blanks), discarded)) return SpanEdit{fix->span, fix->text};
  }
  return std::nullopt;
}

/// What the reader said. A pose that is only roughly a rotation is a topic's affair, a grossly wrong one the reader's.
void take_over(const Diagnostics& diagnostics, const text::Source& source, bool topics_follow, Findings& findings) {
  for (const Diagnostic& entry : diagnostics.entries()) {
    if (topics_follow && reports_contradiction(code_of(entry))) continue;  // a topic says it at its place
    if (entry.facts.code == Code::kRotationRough || entry.facts.code == Code::kRotationMirrors) continue;
    const Severity severity = same_id(code_of(entry), kBeyondUs) ? Severity::kWarning : entry.severity;
    findings.add({.severity = severity,
                  .facts = entry.facts,
                  .where = entry.where,
                  .edit = edit_for(entry, source),
                  .kind = entry.kind,
                  .remedy = entry.remedy});
  }
}

bool is_ambiguous(const Diagnostics& diagnostics) {
  return std::ranges::any_of(diagnostics.entries(),
                             [](const Diagnostic& entry) { return entry.facts.code == Code::kFormatAmbiguous; });
}

/// "84 deg across the image" of a camera under one reading of its four numbers.
Message view_as(const text::Document& document, const CheckOptions& options, OpenCvModel model, std::size_t index) {
  const std::string_view reading = name_of(model);
  CheckOptions as = options;
  as.reading.opencv_model = model;
  Diagnostics ignored;
  const std::optional<Calibration> calibration = read_calibration({document}, options.from, as.reading, ignored);
  if (!calibration || calibration->rig.cameras.size() <= index) return {Code::kAsLensNoCamera, {reading}};
  const Camera& camera = calibration->rig.cameras[index];
  if (!camera.image_size) return {Code::kAsLensNoSize, {reading}};
  const double row = principal_point(camera.model)[1];
  const std::optional<Ray> left = unproject(camera.model, {0.0, row});
  const std::optional<Ray> right = unproject(camera.model, {camera.image_size->width - 1.0, row});
  if (!left || !right) return {Code::kAsLensNoRay, {reading}};
  const double degrees = (angle_from_axis(*left) + angle_from_axis(*right)) * 180.0 / std::numbers::pi;
  return {Code::kAsLensView, {reading, degrees}};
}

/// A parameter out of its range is often its neighbour in the list.
void suggest_exchanges(const text::Document& document, const Format& format, const CheckOptions& options, CheckReport& report) {
  for (Finding& finding : report.findings) {
    if (!same_id(code_of(finding), Code::kAnyNotACamera) || !fix_of(finding).empty()) continue;
    const text::Node* other = exchanged_with(document, format, options.reading, finding.where.offset);
    if (other != nullptr) finding.remedy = {Code::kExchangeNeighbours, {other->value}};
  }
}

/// Nothing in the file says which of OpenCV's two lenses four numbers are: both readings, by what they would see.
void show_both_readings(const text::Document& document, const CheckOptions& options, CheckReport& report) {
  std::size_t camera = 0;  // in the file's order, as the findings
  for (Finding& finding : report.findings) {
    if (!same_id(code_of(finding), Code::kAnyAmbiguousModel)) continue;
    finding.severity = Severity::kWarning;
    for (const OpenCvModel model : {OpenCvModel::kPinhole, OpenCvModel::kFisheye})
      finding.details.push_back(view_as(document, options, model, camera));
    ++camera;
  }
}

/// What usually fixes it, where a finding has nothing more exact to say.
void add_usual_fixes(CheckReport& report) {
  for (Finding& finding : report.findings) {
    const CodeInfo* general =
        fix_of(finding).empty() && finding.severity != Severity::kNote ? find_check_code(id_of(finding)) : nullptr;
    if (general != nullptr && !general->fix.empty()) finding.remedy = {general->code};
  }
}

/// A few keys that only calibrations have: is a file that no parser takes one all the same?
bool mentions_calibration(std::string_view bytes) {
  constexpr std::array<std::string_view, 12> kWords = {"camera_model", "distortion_coeffs", "noise_density", "Camera.fx",
                                                       "Camera1.fx",   "camera_matrix",     "Camera_Matrix", "cx_offset",
                                                       "K1: !!opencv", "M1: !!opencv",      "intrinsics",    "omnidirectional"};
  return std::ranges::any_of(kWords, [bytes](std::string_view word) { return contains(bytes, word); });
}

void sort_by_place(std::vector<Finding>& findings) {
  const auto before = [](const Finding& a, const Finding& b) {
    if (a.where.offset != b.where.offset) return a.where.offset < b.where.offset;
    return a.severity > b.severity;
  };
  std::ranges::stable_sort(findings, before);
}

/// `to`: null for all topics, else only those about what that format holds.
void run_topics(const text::Document& document, const Calibration& calibration, const CheckOptions& options, const Format* to,
                CheckReport& report) {
  // Topics ask models.
  if (std::ranges::any_of(calibration.rig.cameras, [](const Camera& camera) { return !camera.rays.empty(); })) return;
  const Subject subject{document, calibration, options, Places(document, calibration)};
  Findings findings(report);
  for (const Topic& topic : kTopics) {
    if (to != nullptr && topic.of != nullptr && !(to->*topic.of)) continue;
    if (topic.check(subject, findings)) report.checked.push_back({topic.checked});
  }
}

}  // namespace

}  // namespace checks

Code code_of(const Finding& finding) { return finding.kind != Code::kNone ? finding.kind : finding.facts.code; }

bool CheckReport::has(Severity severity) const {
  return std::ranges::any_of(findings, [severity](const Finding& finding) { return finding.severity == severity; });
}

namespace {

/// As far as the file can be read: text, format, calibration, which goes into `calibration`.
CheckReport looked_at(const text::Source& source, CheckOptions options, std::optional<Calibration>& calibration) {
  CheckReport report;
  checks::Findings findings(report);
  Diagnostics diagnostics;
  std::optional<text::Document> document = parse_calibration(source, diagnostics);
  if (!document) {
    checks::take_over(diagnostics, source, false, findings);
    report.is_calibration = options.from != nullptr || checks::mentions_calibration(source.bytes);
    return report;
  }
  std::optional<DetectedFormat> detected;
  if (options.from != nullptr) {
    detected = DetectedFormat{options.from, {}};
  } else {
    detected = detect_format(*document, diagnostics);
  }
  if (!detected) {
    checks::take_over(diagnostics, source, false, findings);
    report.is_calibration = checks::is_ambiguous(diagnostics);
    return report;
  }
  report.format = detected->format;
  report.why = detected->why;
  calibration = read_calibration({*document}, detected->format, options.reading, diagnostics);
  if (const std::vector<ImageSize> sizes = offered_sizes(diagnostics); !sizes.empty()) {
    options.reading.image_size = sizes.front();  // what is wrong with one is wrong with all, as a rule
    Diagnostics of_size;
    calibration = read_calibration({*document}, detected->format, options.reading, of_size);
    for (const Diagnostic& entry : diagnostics.entries())
      of_size.add(Severity::kNote, entry.facts.code, entry.facts.arguments, entry.where);
    diagnostics = std::move(of_size);
  }
  checks::take_over(diagnostics, source, calibration.has_value(), findings);
  report.holds_no_camera = calibration && calibration->rig.cameras.empty();
  // What the reader refuses for a fault of the file is said; programs would stumble over the same place.
  if (calibration || !report.has(Severity::kError)) {
    checks::check_programs(*document, *detected->format, calibration ? &*calibration : nullptr, options, report);
  }
  if (calibration) {
    checks::run_topics(*document, *calibration, options, nullptr, report);
    if (options.parts) checks::check_parts(*document, *detected->format, options, report);
  } else {
    if (report.findings.empty()) {
      findings.undecided(Code::kRestNotLookedAt);
    } else {
      findings.undecided_as(report.findings.front().facts.code, Code::kRestNotLookedAt);
    }
    checks::show_both_readings(*document, options, report);
    checks::suggest_exchanges(*document, *detected->format, options, report);
  }
  return report;
}

bool is_ignored(const std::string& id, const CheckOptions& options) {
  return std::ranges::any_of(options.ignored, [&id](Code code) { return info(code).id == id; });
}

Verdict verdict_on(const CheckReport& report, const Rig* rig, const CheckOptions& options) {
  VerdictFacts facts;
  facts.to = report.format;
  facts.mode = report.mode;
  if (report.proof) facts.proofs = std::span(&*report.proof, 1);
  facts.has_reader = report.has_reader;
  facts.findings = report.findings;
  facts.rig = report.format != nullptr ? rig : nullptr;
  facts.is_read = rig != nullptr;
  Verdict verdict = decide(facts);
  if (!facts.is_read) return verdict;
  std::erase_if(verdict.reasons, [&options](const Reason& reason) { return is_ignored(id_of(reason), options); });
  verdict.word = VerdictWord::kReady;
  for (const Reason& reason : verdict.reasons) verdict.word = std::max(verdict.word, reason.word);
  return verdict;
}

}  // namespace

CheckReport check_file(const text::Source& source, const CheckOptions& options) {
  std::optional<Calibration> calibration;
  CheckReport report = looked_at(source, options, calibration);
  checks::deduplicate(report);
  // Of a file that cannot be read, that stays the finding.
  const bool is_read = calibration.has_value();
  std::erase_if(report.findings, [&](const Finding& finding) {
    return is_ignored(id_of(finding), options) && (is_read || finding.severity != Severity::kError);
  });
  checks::sort_by_place(report.findings);
  const auto says_copies = [](const Finding& finding) { return finding.facts.code == Code::kYamlCopies; };
  if (std::ranges::any_of(report.findings, says_copies)) {  // a change here would change what else is shared
    for (Finding& finding : report.findings) finding.edit.reset();
  }
  checks::add_usual_fixes(report);
  report.verdict = verdict_on(report, calibration ? &calibration->rig : nullptr, options);
  return report;
}

std::vector<Finding> findings_about_meaning(const text::Document& document, const Calibration& calibration,
                                            const Diagnostics& diagnostics, const CheckOptions& options, const Format& to) {
  CheckReport report;
  report.format = calibration.format;
  checks::Findings findings(report);
  checks::take_over(diagnostics, document.source(), true, findings);
  checks::run_topics(document, calibration, options, &to, report);
  checks::deduplicate(report);
  return std::move(report.findings);
}

std::optional<text::Source> fixed_source(const text::Source& source, const CheckOptions& options) {
  text::Source result = source;
  std::set<std::string> before = {source.bytes};
  constexpr int kMostRounds = 20;  // after a header that is fixed a program sees the rest for the first time
  for (int round = 0; round < kMostRounds; ++round) {
    const CheckReport report = check_file(result, options);
    text::Document document(result, text::Syntax::kYaml, {});
    std::size_t free_from = 0;
    for (const Finding& finding : report.findings) {  // by place
      if (!finding.edit || finding.edit->span.offset < free_from) continue;
      document.replace(finding.edit->span, finding.edit->text);
      free_from = finding.edit->span.end() + 1;
    }
    if (!document.edited()) break;
    result.bytes = document.bytes();
    // Two programs that want it each in their own way: neither fix is certain.
    if (!before.insert(result.bytes).second) return std::nullopt;
  }
  return result.bytes != source.bytes ? std::optional(result) : std::nullopt;
}

}  // namespace fca
