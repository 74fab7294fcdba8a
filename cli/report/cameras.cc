// SPDX-License-Identifier: BSD-3-Clause
#include "sections.h"

#include "../convert_command.h"
#include "../judgement_text.h"
#include "../words.h"
#include "chart.h"
#include "image_field.h"
#include "map_figure.h"
#include "table.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fca::cli {

namespace {

std::string degrees_or_dash(const std::optional<double>& value) { return value ? fixed(*value, 1) + " deg" : "-"; }

/// What is drawn of one camera: what it is, and what it becomes.
struct DrawnCamera {
  const Camera& source;
  const CameraOutcome* outcome = nullptr;  ///< Null where nothing was converted.

  [[nodiscard]] const ConversionReport* report() const {
    return outcome != nullptr && outcome->report ? &*outcome->report : nullptr;
  }
  [[nodiscard]] bool kept() const { return outcome == nullptr || outcome->source.model == outcome->target.model; }
  /// Is there anything to see of the error?
  [[nodiscard]] bool errs() const {
    return report() != nullptr && !kept() &&
           (report()->judgement.error.max > kSeenError || report()->judgement.coverage.unrepresentable > 0.0);
  }
};

/// The largest angle from the axis that counts, in degrees.
double domain_deg(const DrawnCamera& camera, const ImageField* angles) {
  if (camera.report() != nullptr) return camera.report()->judgement.coverage.max_angle_deg;
  if (angles != nullptr) return angle_scale(*angles).to;
  constexpr double kUsual = 90.0;
  return std::min(kUsual, max_angle(camera.source.model) * kDegreesPerRadian);
}

Curve radius_of(const CameraModel& model, double to_deg, std::string style, std::string name) {
  Curve curve{std::move(style), std::move(name), {}};
  for (const RadiusPoint& point : radius_curve(model, to_deg / kDegreesPerRadian))
    curve.points.push_back({point.angle_deg, point.radius_px});
  return curve;
}

/// A lens of the same focal length that follows a simple law.
template <class Law>
Curve law_of(double to_deg, const char* style, const char* name, Law&& radius) {
  Curve curve{style, name, {}};
  constexpr int kPoints = 360;
  for (int i = 0; i <= kPoints; ++i) {
    const double angle = to_deg * i / kPoints;
    curve.points.push_back({angle, radius(angle / kDegreesPerRadian)});
  }
  return curve;
}

Chart radius_chart(const DrawnCamera& camera, double domain) {
  constexpr double kBeyond = 1.06;  // what lies behind the domain's end shows how a model goes on
  constexpr double kWhole = 180.0;
  const double to = std::min(kWhole, kBeyond * domain);
  const std::string from_id(model_info(camera.source.model).id);
  Chart chart;
  chart.title = "Radius over angle";
  chart.what = "Distance from the principal point over the angle from the axis, for " + camera.source.name;
  chart.x = {"deg from the axis", 0.0, to};
  const std::array<double, 2> focal = central_focal_lengths(camera.source.model);
  const double f = 0.5 * (focal[0] + focal[1]);
  chart.curves.push_back(law_of(to, "reference", "equidistant: f times the angle", [f](double angle) { return f * angle; }));
  chart.curves.push_back(law_of(to, "reference dotted", "pinhole: f times its tangent", [f](double angle) {
    constexpr double kRight = 1.5707963267948966;
    return angle < kRight ? f * std::tan(angle) : std::numeric_limits<double>::quiet_NaN();
  }));
  chart.curves.push_back(radius_of(camera.source.model, to, camera.kept() ? "alone" : "source", from_id));
  if (!camera.kept()) {
    const CameraModel& target = camera.outcome->target.model;
    const std::string to_id(model_info(target).id);
    chart.curves.push_back(radius_of(target, to, "target", to_id == from_id ? to_id + " as converted" : to_id));
  }
  double farthest = 0.0;
  for (const Curve& curve : chart.curves) {
    if (curve.style.starts_with("reference")) continue;
    for (const auto& point : curve.points) farthest = std::max(farthest, point[1]);
  }
  constexpr double kAbove = 1.05;
  chart.y = {"px from the principal point", 0.0, farthest > 0.0 ? kAbove * farthest : 1.0};
  chart.marks.push_back({domain, "domain ends"});
  if (const ConversionReport* report = camera.report(); report != nullptr && report->scored_to_deg < domain - 0.5)
    chart.marks.push_back({report->scored_to_deg, "scored to here"});
  return chart;
}

Chart error_chart(const DrawnCamera& camera) {
  const ConversionReport& report = *camera.report();
  Chart chart;
  chart.title = "Error over angle";
  chart.what = "Error in pixels over the angle from the axis, for " + camera.source.name;
  Curve rms{"rms", "rms around the axis", {}};
  Curve worst{"max", "worst direction", {}};
  Curve bands{"reference", "rms of the table's bands", {}};
  double largest = report.judgement.error.max;
  double smallest = largest;
  for (const ProfilePoint& point :
       error_profile(camera.source, camera.outcome->target.model, report.scored_to_deg / kDegreesPerRadian)) {
    rms.points.push_back({point.angle_deg, point.rms_px});
    worst.points.push_back({point.angle_deg, point.max_px});
    largest = std::max(largest, point.max_px);
    if (point.rms_px > 0.0) smallest = std::min(smallest, point.rms_px);
  }
  for (const ErrorBand& band : report.judgement.bands) {
    if (band.share <= 0.0) continue;
    bands.points.push_back({band.from_deg, band.rms_px});
    bands.points.push_back({std::min(band.to_deg, report.judgement.coverage.max_angle_deg), band.rms_px});
  }
  constexpr double kMostDecades = 1e5;
  const auto decade = [](double value, double (*round)(double)) { return std::pow(10.0, round(std::log10(value))); };
  largest = std::max(largest, kSeenError);
  const double to = decade(largest, [](double x) { return std::ceil(x); });
  const double from = decade(std::max({smallest, to / kMostDecades, 1e-12}), [](double x) { return std::floor(x); });
  chart.x = {"deg from the axis", 0.0, report.judgement.coverage.max_angle_deg};
  chart.y = {"error, px", std::min(from, 0.1 * to), to, true};
  chart.curves = {bands, worst, rms};
  if (report.scored_to_deg < chart.x.to - 0.5) chart.marks.push_back({report.scored_to_deg, "scored to here"});
  return chart;
}

std::optional<MapFigure> error_map(const DrawnCamera& camera, std::optional<double> limit_rad) {
  const ConversionReport& report = *camera.report();
  const CameraModel& target = camera.outcome->target.model;
  const double reach = report.scored_to_deg / kDegreesPerRadian;
  std::optional<ImageField> field = error_field(camera.source, target, limit_rad, reach, kPictureCells);
  std::optional<ImageField> coarse = error_field(camera.source, target, limit_rad, reach, kContourCells);
  if (!field || !coarse) return std::nullopt;
  MapFigure figure;
  figure.title = "Error over the image";
  figure.what = "Error in pixels of " + report.to_model + " over the image of " + camera.source.name;
  figure.field = *std::move(field);
  figure.coarse = *std::move(coarse);
  figure.scale = error_scale(report.judgement.error.max);
  figure.marked = report.judgement.error.max_at;
  figure.mark_label = "max " + pixels(report.judgement.error.max) + " px";
  figure.axis = principal_point(camera.source.model);
  return figure;
}

std::optional<MapFigure> angle_map(const DrawnCamera& camera, std::optional<double> limit_rad) {
  std::optional<ImageField> field = angle_field(camera.source, limit_rad, kPictureCells);
  std::optional<ImageField> coarse = angle_field(camera.source, limit_rad, kContourCells);
  if (!field || !coarse) return std::nullopt;
  MapFigure figure;
  figure.title = "Angle from the axis over the image";
  figure.what = "Angle from the axis over the image of " + camera.source.name;
  figure.scale = angle_scale(*field);
  figure.field = *std::move(field);
  figure.coarse = *std::move(coarse);
  figure.axis = principal_point(camera.source.model);
  return figure;
}

void put_parameters(Html& html, const DrawnCamera& camera) {
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

void put_judgement(Html& html, const DrawnCamera& camera) {
  if (camera.report() == nullptr) return;
  const ConversionReport& report = *camera.report();
  const Judgement& j = report.judgement;
  const auto line = [&html](const char* what, const std::string& text) {
    html.element("p", {}, [&] {
      html.element("span", {{"class", "soft"}}, what);
      html.text(text);
    });
  };
  const std::string scored = camera.kept() ? "" : "; " + coverage_text(j.coverage, report.scored_to_deg);
  line("domain: ", angle_in_words(j.coverage.max_angle_deg) + ": " + j.coverage.why + scored);
  if (camera.kept()) {
    line("error: ", "none: the same model and parameters");
    return;
  }
  line("error: ", error_text(j.error) + (report.exact ? ""
                                                      : "; mean " + pixels(j.error.mean) + ", median " + pixels(j.error.p50) +
                                                            ", 95 % " + pixels(j.error.p95) + ", 99 % " + pixels(j.error.p99)));
  if (report.exact) return;
  if (!report.at_bound.empty()) line("at the edge of its range: ", enumerated(report.at_bound));
}

void put_bands(Html& html, const std::vector<ErrorBand>& bands) {
  Table table{{"deg from the axis", "share", "rms px", "max px"}, {}, "numbers"};
  for (const ErrorBand& band : bands) {
    if (band.share <= 0.0) continue;
    table.rows.push_back({fixed(band.from_deg, 0) + " to " + fixed(band.to_deg, 0), percent(band.share), pixels(band.rms_px),
                          pixels(band.max_px)});
  }
  html.element("figure", {}, [&] {
    html.element("figcaption", {}, "Error in bands of angles");
    put_table(html, table);
  });
}

void put_reach(Html& html, const std::vector<ReachRow>& rows) {
  if (rows.empty()) return;
  html.element("details", {}, [&] {
    html.element("summary", {}, "If the lens ends earlier and the corners are black: what --max-angle would reach");
    Table table{{"--max-angle", "share", "rms px", "max px", "scored to"}, {}, "numbers"};
    for (const ReachRow& row : rows) {
      table.rows.push_back({text::format_short(row.max_angle_deg, 4), percent(row.scored), pixels(row.rms_px),
                            pixels(row.max_px), text::format_short(row.scored_to_deg, 4)});
    }
    put_table(html, table);
  });
}

void put_camera(Html& html, const DrawnCamera& camera, std::optional<double> limit_rad) {
  const std::string name = camera.outcome != nullptr ? camera.outcome->name_in_words() : camera.source.name;
  const std::string line =
      camera.outcome != nullptr ? camera_line(*camera.outcome) : std::string(model_info(camera.source.model).title);
  html.element("h3", {}, name + ": " + line);
  if (!validate(camera.source.model).empty()) {
    html.element("p", {{"class", "error"}}, "No camera: " + enumerated(validate(camera.source.model)));
    return;
  }
  put_judgement(html, camera);
  put_parameters(html, camera);
  std::optional<MapFigure> map = camera.errs() ? error_map(camera, limit_rad) : angle_map(camera, limit_rad);
  const double domain = domain_deg(camera, map && !camera.errs() ? &map->field : nullptr);
  html.element("div", {{"class", "figures"}}, [&] {
    html.element("div", {{"class", "stack"}}, [&] {
      if (map) put_map(html, *map);
      if (camera.errs()) put_bands(html, camera.report()->judgement.bands);
    });
    html.element("div", {{"class", "stack"}}, [&] {
      put_chart(html, radius_chart(camera, domain));
      if (camera.errs()) put_chart(html, error_chart(camera));
    });
  });
  if (!map) {
    html.element("p", {{"class", "warning"}},
                 camera.source.image_size ? "No map: no pixel of the image has a ray."
                                          : "No map: the file states no image size; --size WxH gives it.");
  }
  if (camera.errs()) put_reach(html, camera.report()->reach);
}

/// What was written of that camera; a conversion may leave some out.
const CameraOutcome* outcome_of(const ReportContents& contents, const Camera& camera) {
  if (!contents.conversion) return nullptr;
  const auto& cameras = contents.conversion->cameras;
  const auto found =
      std::ranges::find_if(cameras, [&camera](const CameraOutcome& outcome) { return outcome.source.name == camera.name; });
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
    const FieldsOfView view = fields_of_view(camera, contents.shown.limit_deg);
    table.rows.push_back({camera.name, std::string(model_info(camera.model).title),
                          camera.image_size ? size_in_words(*camera.image_size) : "not stated",
                          degrees_or_dash(view.horizontal), degrees_or_dash(view.vertical), degrees_or_dash(view.diagonal),
                          degrees_or_dash(view.largest_from_axis),
                          camera.time_offset_s ? text::format_short(*camera.time_offset_s, 9) + " s" : "not stated"});
  }
  put_table(html, table);
}

void put_cameras(Html& html, const ReportContents& contents) {
  for (const Camera& camera : contents.shown.calibration->rig.cameras) {
    const CameraOutcome* outcome = outcome_of(contents, camera);
    html.element("section", {{"class", "camera"}}, [&] {
      put_camera(html, {outcome != nullptr ? outcome->source : camera, outcome}, contents.max_angle_rad);
    });
  }
}

}  // namespace fca::cli
