// SPDX-License-Identifier: BSD-3-Clause
#include "sections.h"

#include "chart.h"
#include "map_figure.h"
#include "shell/model_words.h"
#include "shell/option_hints.h"
#include "shell/recommendation.h"
#include "shell/words.h"
#include "table.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>
#include <fca/toolkit/image_field.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fca::cli {

namespace {

/// Is it about how a program reads the file, and not about what the file contains?
bool is_about_program(const Finding& finding) {
  constexpr std::array kOfPrograms = {Code::kAnyProgramFindsNoCamera, Code::kAnyProgramIgnores, Code::kAnyProgramMisreads,
                                      Code::kAnyProgramOtherFormat, Code::kAnyProgramRefuses};
  return same_id(code_of(finding), kOfPrograms);
}

/// Does check warn of anything in the file?
bool is_doubted(const ReportContents& contents) {
  return std::ranges::any_of(contents.checks, [](const CheckResult& file) {
    return std::ranges::any_of(file.report.findings, [](const Finding& finding) {
      return finding.severity != Severity::kNote && !is_about_program(finding);
    });
  });
}

/// How to get a fit to the circle alone.
std::string limit_of(const Candidate& candidate) {
  return candidate.in_circle ? " (--max-angle " + text::format_short(candidate.in_circle->max_angle_deg) + ")" : "";
}

void put_candidate_table(Html& html, const std::vector<Candidate>& candidates, const Candidate* best) {
  const bool is_wide = std::ranges::any_of(candidates, [](const Candidate& each) { return each.distance.is_wide; });
  Table table{{"model", is_wide ? "rms px, inscribed circle" : "rms px", "whole image: rms px", "max px", "scored",
               "unreachable", "stored by"},
              {},
              "cards"};
  std::vector<const Candidate*> rows = ranked(candidates);
  for (const Candidate& candidate : candidates) {
    if (!candidate.conversion) rows.push_back(&candidate);
  }
  for (const Candidate* row : rows) {
    const Candidate& candidate = *row;
    const std::string id = std::string(candidate.model->id) + (&candidate == best ? " \u2190 recommended" : "");
    if (!candidate.conversion) {
      const std::vector<Diagnostic>& why = candidate.diagnostics.entries();
      table.rows.push_back(
          {id, "", "", "", "", "",
           "not fitted: " + (why.empty() ? "it does not describe the lens" : message_of(why.back(), with_options))});
      continue;
    }
    const ErrorStatistics& j = candidate.conversion->report.statistics;
    const bool exact = candidate.conversion->report.exact;
    table.rows.push_back({id,
                          exact                    ? "exact"
                          : reaches_all(candidate) ? pixels(candidate.decisive().rms) + limit_of(candidate)
                                                   : "",
                          exact ? "exact" : pixels(j.error.rms), exact ? "exact" : pixels(j.error.max),
                          percent(j.coverage.scored), percent(j.coverage.unrepresentable),
                          enumerated(stored_by_in_words(candidate))});
  }
  put_table(html, table);
}

/// The errors of the best that err, in one chart.
void put_errors(Html& html, const Camera& camera, const std::vector<Candidate>& candidates) {
  Chart chart;
  chart.title = "Error over angle: rms around the axis";
  chart.what = "Error of each model over the angle from the axis, for " + camera.name;
  double largest = 0.0;
  double field_of_view = 0.0;
  std::size_t colour = 0;
  constexpr std::size_t kMostCurves = 4;
  for (const Candidate* candidate : ranked(candidates)) {
    if (candidate->conversion->report.exact || chart.curves.size() == kMostCurves) continue;
    const ConversionReport& report = candidate->conversion->report;
    field_of_view = std::max(field_of_view, report.statistics.coverage.max_angle_deg);
    Curve curve{"c" + std::to_string(colour++), std::string(candidate->model->id), {}};
    for (const ProfilePoint& point :
         error_profile(camera, candidate->conversion->camera.model, report.scored_to_deg / kDegreesPerRadian)) {
      curve.points.push_back({point.angle_deg, point.rms_px});
      largest = std::max(largest, point.rms_px);
    }
    chart.curves.push_back(std::move(curve));
  }
  if (!(largest > 0.0)) return;
  constexpr double kDecades = 1e6;
  const double to = std::pow(10.0, std::ceil(std::log10(std::min(largest, kLargestError))));
  chart.x = {"deg from the axis", 0.0, field_of_view};
  chart.y = {"error, px", to / kDecades, to, true};
  put_chart(html, chart);
}

}  // namespace

void put_recommendations(Html& html, const ReportContents& contents) {
  for (const ModelsResult::OfCamera& model : contents.models)
    html.element("p", {{"class", "strong"}}, model.camera.name + ": " + recommendation(model.candidates, contents.to));
}

void put_candidates(Html& html, const ReportContents& contents) {
  const std::vector<Camera>& cameras = contents.shown.calibration->rig.cameras;
  if (contents.models.empty()) return;
  html.element("h2", {}, "Which model?");
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const std::vector<Candidate>& all = contents.models[i].candidates;
    html.element("section", {{"class", "candidates"}}, [&] {
      html.element("h3", {}, cameras[i].name + " (" + std::string(model_info(cameras[i].model).id) + ")");
      html.element("p", {{"class", "strong recommendation"}},
                   recommendation(all, contents.to) + (is_doubted(contents) ? " If the file is right: check doubts it." : ""));
      put_candidate_table(html, all, recommended(all, contents.to));
      put_errors(html, cameras[i], all);
    });
  }
}

}  // namespace fca::cli
