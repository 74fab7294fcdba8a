// SPDX-License-Identifier: BSD-3-Clause
#include "convert_command.h"
#include "shell/option_hints.h"
#include "shell/program_words.h"
#include "shell/statistics_text.h"
#include "shell/uncertainty_text.h"
#include "shell/verdict_text.h"
#include "shell/words.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>

#include <algorithm>
#include <cmath>

namespace fca::cli {

namespace {

/// " without k3": what the target has no place for, of a model that stays.
std::string removed_in_words(const ConvertedCamera& camera) {
  const std::span<const Parameter> parameters = model_info(camera.source.model).parameters;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameter_values(camera.source.model)[i] != 0.0 && parameter_values(camera.target.model)[i] == 0.0)
      names.emplace_back(parameters[i].name);
  }
  return names.empty() ? "" : " without " + enumerated(names, "and");
}

}  // namespace

std::string models_in_words(const ConvertedCamera& camera) {
  const std::string from(camera.source.lens_id());
  const std::string to(camera.target.lens_id());
  if (from == to && camera.source.model == camera.target.model) return from;
  if (from == to) return from + removed_in_words(camera);
  const int degree = camera.report ? camera.report->degree : 0;
  return from + " -> " + to + (degree > 0 ? " of degree " + std::to_string(degree) : "");
}

std::string_view way_in_words(const ConvertedCamera& camera) {
  if (!camera.target.rays.empty()) return "kept";
  if (!camera.source.rays.empty()) return "fitted";
  if (camera.source.model == camera.target.model) return "kept";
  return camera.report && camera.report->exact ? "exact" : "fitted";
}

std::string camera_line(const ConvertedCamera& camera) {
  return models_in_words(camera) + ", " + std::string(way_in_words(camera));
}

namespace {

/// A file cannot tell black corners from glass, and the choice changes the error tenfold.
std::string max_angle_text(const std::vector<MaxAngleRow>& rows) {
  if (rows.empty()) return "";
  const auto is_same = [&rows](const MaxAngleRow& row) {
    return row.scored == rows.front().scored && row.rms_px == rows.front().rms_px;
  };
  if (rows.size() > 1 && std::ranges::all_of(rows, is_same))
    return "  if the lens ends earlier, but beyond 90 deg, the fit is the same\n";
  constexpr double kNoticeable = 0.05;  // deg
  constexpr std::size_t kWidth = 12;
  std::string text = "  if the lens ends earlier and the corners are black, --max-angle DEG fits only the lens:\n    " +
                     padded("DEG", kWidth) + padded("share", kWidth) + padded("rms px", kWidth) + "max px\n";
  for (const MaxAngleRow& row : rows) {
    text += "    " + padded(text::format_short(row.max_angle_deg, 4), kWidth) + padded(percent(row.scored), kWidth) +
            padded(pixels(row.rms_px), kWidth) + pixels(row.max_px) +
            (row.scored_to_deg < row.max_angle_deg - kNoticeable
                 ? "  (fitted and scored inside " + text::format_short(row.scored_to_deg, 3) + " deg only)"
                 : "") +
            "\n";
  }
  return text;
}

/// The program's reason, where it is the program's range that ends there and not the model's.
std::string why_at_bound(const ConversionReport& report, const Format& to, const CameraModel& target) {
  const StoredModel* stored = find_stored_model(to, report.to_model, false);
  if (stored == nullptr || stored->why == Code{}) return "";
  const bool programs = std::ranges::any_of(stored->ranges, [&](const ParameterRange& range) {
    const std::span<const Parameter> own = model_info(target).parameters;
    const auto parameter = std::ranges::find(own, range.parameter.name(), &Parameter::name);
    const std::optional<double> value = fca::parameter(target, range.parameter);
    if (parameter == own.end() || !value) return false;
    return (*value == range.lower && range.lower > parameter->lower) ||
           (*value == range.upper && range.upper < parameter->upper);
  });
  return programs ? " (" + text::text_of({stored->why}, with_options) + ")" : "";
}

/// What the search for a smaller worst pixel gained, and what it cost.
std::string objective_text(const ConversionReport& report) {
  if (!report.rms_fit) return "";
  if (report.rms_fit->kept) return "  objective max: nothing near the rms fit has a smaller worst pixel, so that is kept\n";
  const ErrorSummary& error = report.statistics.error;
  return "  objective max: worst pixel " + pixels(report.rms_fit->max_px) + " -> " + pixels(error.max) + " px, rms " +
         pixels(report.rms_fit->rms_px) + " -> " + pixels(error.rms) + " px\n";
}

/// What a fit with weights made small.
std::string weight_text(const ConversionReport& report) {
  if (!report.weighted) return "";
  return "  weight: rms " + pixels(report.weighted->rms_px) + " px " +
         (report.weighted->kind == WeightKind::kAngle ? "by solid angle" : "by the image's grey") +
         ", which the fit made small\n";
}

std::string report_text(const ConversionReport& report, const Format& to, const CameraModel& target) {
  const ErrorStatistics& j = report.statistics;
  std::string text = field_of_view_text(j.coverage);
  text += "          " + coverage_text(j.coverage, report.scored_to_deg) + "\n";
  text += "  error:  " + error_text(j) + "\n";
  if (!report.exact) {
    text += "          mean " + pixels(j.error.mean) + ", median " + pixels(j.error.p50) + ", 95 % " + pixels(j.error.p95) +
            ", 99 % " + pixels(j.error.p99) + "\n";
  }
  text += weight_text(report) + objective_text(report) + band_table(j.bands) + max_angle_text(report.max_angles);
  if (!report.at_bound.empty())
    text += "  at the edge of its range: " + enumerated(report.at_bound) + why_at_bound(report, to, target) + "\n";
  return text;
}

std::string losses_text(const std::vector<Loss>& losses) {
  if (losses.empty()) return "lost: nothing\n";
  std::string text = "lost:\n";
  for (const Loss& loss : losses) {
    text += "  " + text::printable(what_of(loss, with_options)) + ": " + why_of(loss, with_options) +
            "\n";  // a key of the file may hold line breaks
    const std::string remedy = remedy_of(loss, with_options);
    if (!remedy.empty()) text += "    do: " + remedy + "\n";
  }
  return text;
}

std::string defaults_text(const std::vector<DefaultedValue>& defaults) {
  std::string look;
  std::vector<std::string> rest;
  for (const DefaultedValue& value : defaults) {
    if (value.look_at_it) {
      look += "  " + text_of(value, with_options) + "\n";
    } else {
      rest.push_back(text_of(value, with_options));
    }
  }
  std::string text;
  if (!look.empty()) text += "not in the input, set them to your camera's:\n" + look;
  if (!rest.empty()) text += "defaults:\n" + wrapped(rest, "  ");
  return text;
}

std::string value_in_words(const CameraModel& model, std::string_view name) {
  const std::optional<ParameterId> id = ParameterId::find(name);
  const std::optional<double> value = id ? parameter(model, *id) : std::nullopt;
  return value ? text::format_real(*value) : "-";
}

/// Each parameter of either model, in the input and as written.
std::string parameter_table(const ConvertedCamera& camera) {
  constexpr std::size_t kWidth = 24;
  std::vector<std::string_view> names;
  for (const CameraModel* model : {&camera.source.model, &camera.target.model}) {
    for (const Parameter& parameter : model_info(*model).parameters) {
      if (std::ranges::find(names, parameter.name) == names.end()) names.push_back(parameter.name);
    }
  }
  std::string text = "    " + padded("parameter", kWidth / 2) + padded("input", kWidth) + "written\n";
  for (const std::string_view name : names) {
    text += "    " + padded(std::string(name), kWidth / 2) + padded(value_in_words(camera.source.model, name), kWidth) +
            value_in_words(camera.target.model, name) + "\n";
  }
  return text;
}

std::vector<std::string> rightly_read(const ProofResult& proof) {
  std::vector<std::string> names;
  for (const CameraProof& camera : proof.cameras) {
    if (!camera.misread) names.push_back(camera.name);
  }
  return names;
}

std::string verdict_of(const ProofResult& proof, const ConvertResult& outcome) {
  constexpr double kAll = 5e-4;
  if (!proof.loads) {
    const bool before = std::ranges::find(outcome.refused_before, proof.program) != outcome.refused_before.end();
    return std::string(before ? "refuses it, as it did before: " : "would refuse it: ") +
           text::printable(enumerated(sentences_of(proof.refusals, with_options)));
  }
  if (proof.all_misread) return "loads it and misreads it";
  if (proof.without_cameras) return "loads it";
  if (proof.agrees() && proof.compared_share == 0.0)
    return "loads it; no pixels were compared, as no input contains the image's size (--size WxH)";
  return "loads it; its pixels" + (proof.misread_px > 0.0 ? " of " + enumerated(rightly_read(proof)) : "") +
         " differ from the model above by at most " + pixels(proof.max_diff_px) + " px" +
         (proof.compared_share < 1.0 - kAll ? " over " + percent(proof.compared_share) + " of the image" : "");
}

std::vector<std::string> details_of(const ProofResult& proof, const ConvertResult& outcome) {
  std::vector<std::string> details;
  for (const std::string& warning : misreadings(proof, outcome.lens_given))
    details.push_back("warning: " + text::printable(warning));
  if (!(proof.misread_px > 0.0)) return details;
  details.push_back("which costs up to " + pixels(proof.misread_px) + " px with this calibration");
  return details;
}

std::string proofs_text(const ConvertResult& outcome) {
  std::string text;
  for (const ProofWords& proof : proofs_in_words(outcome)) {
    text += "proof: " + proof.verdict + "\n";
    for (const std::string& detail : proof.details) text += "  " + detail + "\n";
  }
  return text;
}

}  // namespace

std::vector<ProofWords> proofs_in_words(const ConvertResult& outcome) {
  std::vector<ProofWords> proofs;
  for (const std::string& path : outcome.unproven)
    proofs.push_back({"none: no program that fca-io knows reads " + (path.empty() ? "such keys" : path), {}});
  for (const ProofResult& proof : outcome.proofs)
    proofs.push_back({proof.program + " " + verdict_of(proof, outcome), details_of(proof, outcome)});
  return proofs;
}

std::string convert_text(const ConvertOutcome& outcome, bool written, bool with_parameters) {
  std::string text = (outcome.one_of_many ? outcome.input + ": " : "") + text::text_of(outcome.headline, with_options) + "\n";
  for (const ConvertedCamera& camera : outcome.cameras) {
    text += "\n" + name_in_words(camera) + ": " + camera_line(camera) + "\n" + parameters_in_words(camera.target.model, "  ");
    const bool kept = camera.source.model == camera.target.model;
    if (camera.report) {
      text += kept ? field_of_view_text(camera.report->statistics.coverage)
                   : report_text(*camera.report, *outcome.to, camera.target.model);
    }
    if (kept) text += "  error:  none: the same model and parameters\n";
    const std::string own = camera.report ? uncertainty_in_words(*camera.report) : "";
    if (!own.empty()) text += "  against: " + own + "\n";
    if (const CameraDistance* distance = distance_of(outcome, camera)) {
      text += "  seen:   " + distance_in_words(distance->in_circle) + " in the inscribed circle, as the program reads it;\n" +
              "          " + distance_in_words(distance->in_image) + " " + std::string(image_in_words(*distance)) + "\n";
    }
    if (with_parameters) text += parameter_table(camera);
  }
  text += "\n" + losses_text(outcome.losses) + defaults_text(outcome.defaults) + proofs_text(outcome);
  if (outcome.code == ExitCode::kGood && written) {
    for (const ConvertedFile& output : outcome.files) {
      if (!output.path.empty()) text += "wrote " + output.path + "\n";
    }
  }
  return text;
}

}  // namespace fca::cli
