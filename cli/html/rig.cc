// SPDX-License-Identifier: BSD-3-Clause
#include "sections.h"

#include "rig_drawing.h"
#include "shell/pose_words.h"
#include "shell/words.h"
#include "table.h"

#include <fca/formats/text/numbers.h>

namespace fca::cli {

namespace {

std::string stated(const std::optional<double>& value, const char* unit) {
  return value ? text::format_short(*value) + " " + unit : "not given";
}

}  // namespace

void put_poses(Html& html, const ReportContents& contents) {
  const Calibration& calibration = *contents.shown.calibration;
  const Rig& rig = calibration.rig;
  html.element("h2", {}, "Poses");
  if (rig.poses.empty()) {
    html.element("p", {}, rig.baseline_m ? "" : "The file contains no pose.");
  } else {
    const PlacedRig placed = placed_rig(rig);
    if (placed.frames.size() > 1)
      html.element("div", {{"class", "figures"}}, [&] { put_rig(html, placed, calibration.poses_without_unit.empty()); });
    if (!placed.unplaced.empty()) {
      html.element("p", {{"class", "warning"}},
                   "The file contains no pose of " + enumerated(placed.unplaced, "and") + " relative to " +
                       placed.frames.front().name + ".");
    }
    html.element("ul", {}, [&] {
      for (const PoseEdge& edge : rig.poses) {
        const std::string words = pose_in_words(edge, rig, !has_assumed_unit(edge, calibration));
        html.element("li", {}, [&] {
          html.element("code", {}, name_of(edge));
          html.text(": " + (words.empty() ? "its 3 x 3 part is singular" : words));
        });
      }
    });
  }
  if (rig.baseline_m) {
    html.element("p", {}, "Baseline of the rectified pair or depth sensor: " + text::format_short(*rig.baseline_m) + " m.");
  }
}

void put_imus(Html& html, const ReportContents& contents) {
  const Rig& rig = contents.shown.calibration->rig;
  if (rig.imus.empty()) return;
  html.element("h2", {}, "IMU");
  html.element("p", {{"class", "soft"}}, "Noise as continuous-time densities: standard deviations, not variances.");
  Table table{{"IMU", "gyroscope noise", "gyroscope random walk", "accelerometer noise", "accelerometer random walk", "rate"},
              {},
              "cards"};
  for (const Imu& imu : rig.imus) {
    table.rows.push_back({imu.name, stated(imu.gyroscope_noise_density, "rad/s/sqrt(Hz)"),
                          stated(imu.gyroscope_random_walk, "rad/s^2/sqrt(Hz)"),
                          stated(imu.accelerometer_noise_density, "m/s^2/sqrt(Hz)"),
                          stated(imu.accelerometer_random_walk, "m/s^3/sqrt(Hz)"), stated(imu.rate_hz, "Hz")});
  }
  put_table(html, table);
}

}  // namespace fca::cli
