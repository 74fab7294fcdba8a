// SPDX-License-Identifier: BSD-3-Clause
#include "camera_figures.h"

#include "chart.h"
#include "map_figure.h"
#include "shell/words.h"
#include "table.h"

#include <fca/toolkit/image_field.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fca::cli {

namespace {

constexpr double kNoticeableDeg = 0.5;

/// The largest angle from the axis that counts, in degrees.
double field_of_view_deg(const DrawnCamera& camera, const ImageField* angles) {
  if (camera.statistics != nullptr) return camera.statistics->coverage.max_angle_deg;
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

Chart radius_chart(const DrawnCamera& camera, double field_of_view) {
  constexpr double kBeyond = 1.06;  // what lies behind the field of view's end shows how a model goes on
  constexpr double kWhole = 180.0;
  const double to = std::min(kWhole, kBeyond * field_of_view);
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
  const bool alone = camera.target == nullptr;
  chart.curves.push_back(radius_of(camera.source.model, to, alone ? "alone" : "source", camera.source_label));
  if (!alone) chart.curves.push_back(radius_of(*camera.target, to, "target", camera.target_label));
  // Beyond the angle to which it was scored, a polynomial may grow without limit: the scale does not hold that.
  const double target_counts_to = camera.statistics != nullptr ? camera.scored_to_deg : to;
  double farthest = 0.0;
  for (const Curve& curve : chart.curves) {
    if (curve.style.starts_with("reference")) continue;
    const double counts_to = curve.style == "target" ? target_counts_to : to;
    for (const auto& [angle_deg, radius_px] : curve.points) {
      if (angle_deg <= counts_to) farthest = std::max(farthest, radius_px);
    }
  }
  constexpr double kAbove = 1.05;
  chart.y = {"px from the principal point", 0.0, farthest > 0.0 ? kAbove * farthest : 1.0};
  chart.marks.push_back({field_of_view, "view ends"});
  if (camera.statistics != nullptr && camera.scored_to_deg < field_of_view - kNoticeableDeg)
    chart.marks.push_back({camera.scored_to_deg, "scored to here"});
  return chart;
}

/// The curves of a profile, and the range of what it says.
struct Profile {
  std::vector<std::array<double, 2>> rms;
  std::vector<std::array<double, 2>> worst;
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0.0;
};

Profile profile_of(const DrawnCamera& camera, const Transform* rotation) {
  Profile profile;
  for (const ProfilePoint& point :
       error_profile(camera.source, *camera.target, camera.scored_to_deg / kDegreesPerRadian, rotation)) {
    profile.rms.push_back({point.angle_deg, point.rms_px});
    profile.worst.push_back({point.angle_deg, point.max_px});
    profile.largest = std::max(profile.largest, point.max_px);
    if (point.rms_px > 0.0) profile.smallest = std::min(profile.smallest, point.rms_px);
  }
  return profile;
}

Curve curve_of_bands(const ErrorStatistics& statistics, double scored_to_deg) {
  Curve curve{"reference", "rms of the table's bands", {}};
  for (const ErrorBand& band : statistics.bands) {
    if (band.share <= 0.0) continue;
    curve.points.push_back({band.from_deg, band.rms_px});
    curve.points.push_back({std::min({band.to_deg, statistics.coverage.max_angle_deg, scored_to_deg}), band.rms_px});
  }
  return curve;
}

/// One standard deviation of the source's own pixels, or what it is at most.
Curve uncertainty_of_bands(const DrawnCamera& camera) {
  const bool is_limit = camera.uncertainty->is_limit;
  Curve curve{
      "reference dotted", is_limit ? "calibration's own uncertainty, at most" : "calibration's own uncertainty, 1 sigma", {}};
  const std::vector<ErrorBand>& bands = camera.statistics->bands;
  for (std::size_t i = 0; i < std::min(bands.size(), camera.uncertainty->bands_px.size()); ++i) {
    if (bands[i].share <= 0.0 || camera.uncertainty->bands_px[i] <= 0.0) continue;
    const double end = std::min({bands[i].to_deg, camera.statistics->coverage.max_angle_deg, camera.scored_to_deg});
    curve.points.push_back({bands[i].from_deg, camera.uncertainty->bands_px[i]});
    curve.points.push_back({end, camera.uncertainty->bands_px[i]});
  }
  return curve;
}

Chart error_chart(const DrawnCamera& camera) {
  const ErrorStatistics& statistics = *camera.statistics;
  Chart chart;
  chart.title = camera.distance + " over angle";
  chart.what = camera.distance + " in pixels over the angle from the axis, for " + camera.source.name;
  const Profile profile = profile_of(camera, camera.turn);
  chart.curves = {curve_of_bands(statistics, camera.scored_to_deg),
                  {"max", "worst direction", profile.worst},
                  {"rms", "rms around the axis", profile.rms}};
  double smallest = profile.smallest;
  double highest = std::max(profile.largest, statistics.error.max);
  if (camera.uncertainty != nullptr) {
    chart.curves.push_back(uncertainty_of_bands(camera));
    for (const auto& point : chart.curves.back().points) {
      smallest = std::min(smallest, point[1]);
      highest = std::max(highest, point[1]);
    }
  }
  if (camera.rotation != nullptr) {
    const Profile rotated = profile_of(camera, camera.rotation);
    chart.curves.push_back({"rotated", "rms with the best rotation undone", rotated.rms});
    smallest = std::min(smallest, rotated.smallest);
  }
  constexpr double kMostDecades = 1e5;
  const double largest = std::clamp(highest, kSeenError, kLargestError);
  const double to = std::pow(10.0, std::ceil(std::log10(largest)));
  const double from = std::pow(10.0, std::floor(std::log10(std::clamp(smallest, to / kMostDecades, 0.1 * to))));
  chart.x = {"deg from the axis", 0.0, statistics.coverage.max_angle_deg};
  chart.y = {"px", from, to, true};
  if (camera.scored_to_deg < chart.x.to - kNoticeableDeg) chart.marks.push_back({camera.scored_to_deg, "scored to here"});
  return chart;
}

std::optional<MapFigure> error_map(const DrawnCamera& camera) {
  const double max_angle_rad = camera.scored_to_deg / kDegreesPerRadian;
  std::optional<ImageField> field =
      error_field(camera.source, *camera.target, camera.limit_rad, max_angle_rad, kPictureCells, camera.turn);
  std::optional<ImageField> coarse =
      error_field(camera.source, *camera.target, camera.limit_rad, max_angle_rad, kContourCells, camera.turn);
  if (!field || !coarse) return std::nullopt;
  const ErrorSummary& error = camera.statistics->error;
  MapFigure figure;
  figure.title = camera.distance + " over the image";
  figure.what = camera.distance + " in pixels of " + camera.target_label + " over the image of " + camera.source.name;
  figure.field = *std::move(field);
  figure.coarse = *std::move(coarse);
  const double diagonal = std::hypot(figure.field.image.width, figure.field.image.height);
  figure.scale = error_scale(std::min(error.max, diagonal));
  figure.marked = error.max_at;
  figure.mark_label = "max " + pixels(error.max, figure.field.image) + " px";
  figure.axis = principal_point(camera.source.model);
  figure.rim = camera.source.lens_circle;
  return figure;
}

std::optional<MapFigure> angle_map(const DrawnCamera& camera) {
  std::optional<ImageField> field = angle_field(camera.source, camera.limit_rad, kPictureCells);
  std::optional<ImageField> coarse = angle_field(camera.source, camera.limit_rad, kContourCells);
  if (!field || !coarse) return std::nullopt;
  MapFigure figure;
  figure.title = "Angle from the axis over the image";
  figure.what = "Angle from the axis over the image of " + camera.source.name;
  figure.scale = angle_scale(*field);
  figure.field = *std::move(field);
  figure.coarse = *std::move(coarse);
  figure.axis = principal_point(camera.source.model);
  figure.rim = camera.source.lens_circle;
  return figure;
}

void put_bands(Html& html, const DrawnCamera& camera) {
  Table table{{"deg from the axis", "share", "rms px", "max px"}, {}, "numbers"};
  if (camera.rotated != nullptr) table.titles.insert(table.titles.end(), {"turned rms", "turned max"});
  for (std::size_t i = 0; i < camera.statistics->bands.size(); ++i) {
    const ErrorBand& band = camera.statistics->bands[i];
    if (band.share <= 0.0) continue;
    std::vector<std::string>& row = table.rows.emplace_back();
    const std::optional<ImageSize>& size = camera.source.image_size;
    row = {fixed(band.from_deg, 0) + " to " + fixed(band.to_deg, 0), percent(band.share), pixels(band.rms_px, size),
           pixels(band.max_px, size)};
    if (camera.rotated == nullptr || i >= camera.rotated->bands.size()) continue;
    row.push_back(pixels(camera.rotated->bands[i].rms_px, size));
    row.push_back(pixels(camera.rotated->bands[i].max_px, size));
  }
  html.element("figure", {}, [&] {
    html.element("figcaption", {},
                 camera.distance + " in bands of angles" +
                     (camera.rotated != nullptr ? " (turned: with the best rotation undone)" : ""));
    put_table(html, table);
  });
}

}  // namespace

bool DrawnCamera::errs() const {
  return target != nullptr && statistics != nullptr &&
         (statistics->error.max > kSeenError || statistics->coverage.unrepresentable > 0.0);
}

void put_figures(Html& html, const DrawnCamera& camera) {
  const bool errs = camera.errs();
  const std::optional<MapFigure> map = errs ? error_map(camera) : angle_map(camera);
  const double field_of_view = field_of_view_deg(camera, map && !errs ? &map->field : nullptr);
  html.element("div", {{"class", "figures"}}, [&] {
    html.element("div", {{"class", "stack"}}, [&] {
      if (map) put_map(html, *map);
      if (errs) put_bands(html, camera);
    });
    html.element("div", {{"class", "stack"}}, [&] {
      put_chart(html, radius_chart(camera, field_of_view));
      if (errs) put_chart(html, error_chart(camera));
    });
  });
  if (map) return;
  html.element("p", {{"class", "warning"}},
               camera.source.image_size ? "No map: no pixel of the image has a ray."
                                        : "No map: the file contains no image size; --size WxH gives it.");
}

}  // namespace fca::cli
