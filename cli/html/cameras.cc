// SPDX-License-Identifier: BSD-3-Clause
#include "sections.h"

#include "camera_figures.h"
#include "commands/convert/convert_command.h"
#include "shell/option_hints.h"
#include "shell/statistics_text.h"
#include "shell/uncertainty_text.h"
#include "shell/words.h"
#include "table.h"

#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>
#include <fca/rig/fields_of_view.h>

#include <algorithm>

namespace fca::cli {

namespace {

constexpr std::string_view kNotCovered = "not covered";

std::string degrees_of(const Camera& camera, const std::optional<double>& radians) {
  if (!camera.image_size) return "not given";
  return radians ? fixed(*radians * kDegreesPerRadian, 1) + " deg" : std::string(kNotCovered);
}

/// A camera, and what became of it.
struct ShownCamera {
  const Camera& source;
  const ConvertedCamera* outcome = nullptr;  ///< Null where nothing was converted.

  [[nodiscard]] const ConversionReport* report() const {
    return outcome != nullptr && outcome->report ? &*outcome->report : nullptr;
  }
  [[nodiscard]] bool kept() const { return outcome == nullptr || outcome->source.model == outcome->target.model; }
};

void put_parameters(Html& html, const ShownCamera& camera) {
  const auto put = [&html](const char* whose, const CameraModel& model) {
    html.element("p", {}, [&] {
      html.element("span", {{"class", "soft"}}, std::string(whose) + std::string(model_info(model).title) + ": ");
      std::string text = parameters_in_words(model, "");
      std::ranges::replace(text, '\n', ' ');
      html.element("code", {}, text);
    });
  };
  put(camera.kept() ? "" : "from ", camera.source.model);
  if (!camera.kept()) put("to ", camera.outcome->target.model);
}

void put_statistics(Html& html, const ShownCamera& camera) {
  const auto line = [&html](const char* what, const std::string& text) {
    html.element("p", {}, [&] {
      html.element("span", {{"class", "soft"}}, what);
      html.text(text);
    });
  };
  if (camera.report() == nullptr) {
    if (camera.source.lens_circle) line("lens: ", circle_in_words(*camera.source.lens_circle));
    return;
  }
  const ConversionReport& report = *camera.report();
  const ErrorStatistics& j = report.statistics;
  const std::string scored = camera.kept() ? "" : "; " + coverage_text(j.coverage, report.scored_to_deg);
  line("field of view: ", field_of_view_in_words(j.coverage) + scored);
  if (const std::string own = uncertainty_in_words(report); !own.empty()) line("against: ", own);
  if (camera.kept()) {
    line("error: ", "none: the same model and parameters");
    return;
  }
  line("error: ", error_text(j) + (report.exact ? ""
                                                : "; mean " + pixels(j.error.mean) + ", median " + pixels(j.error.p50) +
                                                      ", 95 % " + pixels(j.error.p95) + ", 99 % " + pixels(j.error.p99)));
  if (report.exact) return;
  if (!report.at_bound.empty()) line("at the edge of its range: ", enumerated(report.at_bound));
}

void put_max_angles(Html& html, const std::vector<MaxAngleRow>& rows) {
  if (rows.empty()) return;
  html.element("details", {}, [&] {
    html.element("summary", {}, "If the lens ends earlier and the corners are black: the errors with --max-angle");
    Table table{{"--max-angle", "share", "rms px", "max px", "scored to"}, {}, "numbers"};
    for (const MaxAngleRow& row : rows) {
      table.rows.push_back({text::format_short(row.max_angle_deg, 4), percent(row.scored), pixels(row.rms_px),
                            pixels(row.max_px), text::format_short(row.scored_to_deg, 4)});
    }
    put_table(html, table);
  });
}

void put_camera(Html& html, const ShownCamera& camera, std::optional<double> limit_rad) {
  const std::string name = camera.outcome != nullptr ? name_in_words(*camera.outcome) : camera.source.name;
  const std::string line = camera.outcome != nullptr ? camera_line(*camera.outcome) : std::string(camera.source.lens_title());
  html.element("h3", {}, name + ": " + line);
  if (!validate(camera.source.model).empty()) {
    html.element("p", {{"class", "error"}},
                 "No camera: " + enumerated(text::texts_of(validate(camera.source.model), with_options)));
    return;
  }
  put_statistics(html, camera);
  put_parameters(html, camera);
  DrawnCamera drawn{camera.source, std::string(camera.source.lens_id())};
  drawn.limit_rad = limit_rad;
  if (const ConversionReport* report = camera.report()) {
    drawn.statistics = &report->statistics;
    drawn.scored_to_deg = report->scored_to_deg;
    if (report->turn) drawn.turn = &report->turn->T_target_source;
    if (report->uncertainty) drawn.uncertainty = &*report->uncertainty;
  }
  if (!camera.kept()) {
    drawn.target = &camera.outcome->target.model;
    const std::string id(model_info(*drawn.target).id);
    drawn.target_label = id == drawn.source_label ? id + " as converted" : id;
  }
  put_figures(html, drawn);
  if (drawn.errs()) put_max_angles(html, camera.report()->max_angles);
}

/// What was written of that camera; a conversion may leave some out.
const ConvertedCamera* outcome_of(const ReportContents& contents, const Camera& camera) {
  if (!contents.conversion) return nullptr;
  const auto& cameras = contents.conversion->cameras;
  const auto found =
      std::ranges::find_if(cameras, [&camera](const ConvertedCamera& outcome) { return outcome.source.name == camera.name; });
  return found == cameras.end() ? nullptr : &*found;
}

}  // namespace

void put_camera_table(Html& html, const ReportContents& contents) {
  const Rig& rig = contents.shown.calibration->rig;
  if (rig.cameras.empty()) return;
  html.element("h2", {}, "Cameras");
  Table table{{"camera", "model", "image, px", "horizontal", "vertical", "diagonal", "largest from the axis", "time offset"},
              {},
              "cards"};
  for (const Camera& camera : rig.cameras) {
    const FieldsOfView view = fields_of_view(camera, contents.shown.limit_deg / kDegreesPerRadian);
    table.rows.push_back({camera.name, std::string(camera.lens_title()),
                          camera.image_size ? size_in_words(*camera.image_size) : "not given",
                          degrees_of(camera, view.horizontal), degrees_of(camera, view.vertical),
                          degrees_of(camera, view.diagonal), degrees_of(camera, view.largest_from_axis),
                          camera.time_offset_s ? text::format_short(*camera.time_offset_s, 9) + " s" : "not given"});
  }
  put_table(html, table);
  const auto is_short = [](const std::vector<std::string>& row) { return std::ranges::find(row, kNotCovered) != row.end(); };
  if (std::ranges::none_of(table.rows, is_short)) return;
  html.element("p", {{"class", "soft"}}, std::string(kNotCovered) + ": the lens ends before the border of the image there");
}

void put_cameras(Html& html, const ReportContents& contents) {
  for (const Camera& camera : contents.shown.calibration->rig.cameras) {
    const ConvertedCamera* outcome = outcome_of(contents, camera);
    html.element("section", {{"class", "camera"}}, [&] {
      put_camera(html, {outcome != nullptr ? outcome->source : camera, outcome}, contents.max_angle_rad);
    });
  }
}

}  // namespace fca::cli
