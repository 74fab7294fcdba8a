// SPDX-License-Identifier: BSD-3-Clause
#include "compare_command.h"
#include "shell/difference_words.h"
#include "shell/option_hints.h"
#include "shell/statistics_text.h"
#include "shell/words.h"

#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>
#include <fca/toolkit/format_name.h>

#include <algorithm>
#include <cmath>

namespace fca::cli {

std::string same_in_words(const CameraDifference& difference) {
  const std::string limit = "within " + text::format_short(kSamePx) + " px";
  if (difference.same_to_deg >= difference.statistics.coverage.max_angle_deg)
    return "the same camera everywhere (" + limit + ")";
  constexpr double kSmall = 0.1;
  if (difference.same_to_deg < kSmall)
    return "different even at the axis (by more than " + text::format_short(kSamePx) + " px)";
  return "the same camera up to " + fixed(difference.same_to_deg, 1) + " deg from the axis (" + limit + ")";
}

bool turning_helps(const CameraComparison& camera) {
  constexpr double kHelps = 0.9;
  const CameraDifference* rotated = camera.counted_rotated();
  return rotated != nullptr && rotated->statistics.error.rms < kHelps * camera.counted().statistics.error.rms;
}

namespace {

std::string heading(const CameraComparison& camera) {
  std::string text = "\npixels of " + names_of(camera) + ", in an image of " + size_in_words(camera.size) + " px";
  if (camera.size_assumed)
    text += " assumed: no file contains a size (--size does); the principal point lies in the middle of it";
  return text + "\n";
}

std::string focus_text(const CameraComparison& camera) {
  if (!camera.focus) return "";
  const CameraDifference& difference = camera.focus->difference;
  return "  focus:  up to " + fixed(camera.focus->max_angle_deg, 1) +
         " deg from the axis: " + error_text(difference.statistics, camera.size) + "\n          rms " +
         pixels(difference.angle.rms_deg) + " deg, max " + pixels(difference.angle.max_deg) + " deg\n";
}

std::string turned_text(const CameraComparison& camera) {
  if (!camera.rotated) return "";
  const bool same = camera.counted().same_to_deg >= camera.counted().statistics.coverage.max_angle_deg;
  const CameraDifference& turned = *camera.counted_rotated();
  if (is_larger_than(turned.statistics, camera.size)) return "";
  if (!turning_helps(camera)) return same ? "" : "  turned: no rotation reduces the difference\n";
  std::string text = "  turned: by " + rotation_in_words(*camera.rotated) + "\n          with that undone: rms " +
                     pixels(turned.statistics.error.rms, camera.size) + " px (the smallest), max " +
                     pixels(turned.statistics.error.max, camera.size) + " px; " + same_in_words(turned) + "\n";
  if (camera.focus) {
    const ErrorSummary& everywhere = camera.rotated->difference.statistics.error;
    text += "          everywhere: rms " + pixels(everywhere.rms, camera.size) + " px, max " +
            pixels(everywhere.max, camera.size) + " px\n";
  }
  return text + (camera.turn_cancels ? "          its poses turn back by as much: the two cancel\n" : "");
}

std::vector<BandColumn> further_columns(const CameraComparison& camera) {
  std::vector<BandColumn> columns = {{"rms deg", {}, false}, {"max deg", {}, false}};
  for (const AngleBand& band : camera.difference.angle.bands) {
    columns[0].values.push_back(band.rms_deg);
    columns[1].values.push_back(band.max_deg);
  }
  if (!turning_helps(camera)) return columns;
  columns.push_back({"turned rms", {}});
  columns.push_back({"max px", {}});
  for (const ErrorBand& band : camera.rotated->difference.statistics.bands) {
    columns[2].values.push_back(band.rms_px);
    columns[3].values.push_back(band.max_px);
  }
  return columns;
}

/// A file cannot tell black corners from glass, and what lies there drowns the rest.
std::string corners_text(const ErrorStatistics& statistics) {
  constexpr double kWide = 80.0;
  constexpr double kMostOfIt = 0.1;
  double inside = 0.0;
  double to_deg = 0.0;
  for (const ErrorBand& band : statistics.bands) {
    inside = std::max(inside, band.max_px);
    if (inside > kMostOfIt * statistics.error.max) break;
    to_deg = band.to_deg;
  }
  if (statistics.coverage.circle || to_deg < kWide || to_deg >= statistics.coverage.max_angle_deg ||
      statistics.error.max <= kSamePx)
    return "";
  const std::string limit = fixed(to_deg, 0);
  return "  if the corners are black beyond " + limit + " deg, --max-angle " + limit + " compares only the lens\n";
}

std::string camera_text(const CameraComparison& camera, bool with_bands) {
  if (camera.identical) return "";
  std::string text = heading(camera);
  const CameraDifference& difference = camera.difference;
  const ErrorStatistics& statistics = difference.statistics;
  text += field_of_view_text(statistics.coverage);
  text += "          " + coverage_text(statistics.coverage, camera.scored_to_deg) + "\n";
  if (!(statistics.coverage.scored > 0.0)) return text;
  text += "  error:  " + error_text(statistics, camera.size) + "\n";
  text += "          rms " + pixels(difference.angle.rms_deg) + " deg, max " + pixels(difference.angle.max_deg) + " deg\n";
  text += "          " + same_in_words(difference) + "\n";
  text += focus_text(camera) + turned_text(camera);
  if (with_bands) text += band_table(statistics.bands, further_columns(camera), camera.size);
  return text + corners_text(statistics);
}

/// Nothing of two that are alike.
std::string pair_text(const ComparedFile& compared) {
  constexpr double kNothingPx = 0.01;
  if (!compared.pair || compared.pair->max_px() < kNothingPx) return "";
  const PairError& pair = *compared.pair;
  return "\nstereo\n" +
         paragraph("images of " + pair.first + " and " + pair.second + " rectified by " + text::printable(compared.file) +
                       ": epipolar error rms " + pixels(pair.rms_px()) + " px, max " + pixels(pair.max_px()) + " px",
                   "  ");
}

std::string title_of(const Calibration& calibration) {
  return std::string(name_of(*calibration.format, calibration.documents[calibration.with_cameras]).title);
}

}  // namespace

std::string compare_text(const ReferenceFile& reference, const ComparedFile& compared, bool with_bands) {
  const RigComparison& comparison = *compared.comparison;
  const std::string reference_name = text::printable(reference.file);
  const std::string name = text::printable(compared.file);
  std::string text = name + " (" + title_of(*compared.calibration) + ") next to " + reference_name + " (" +
                     title_of(*reference.calibration) + ")\n";
  text += numbers_text(comparison);
  for (const CameraComparison& camera : comparison.cameras) text += camera_text(camera, with_bands);
  text += pair_text(compared);
  if (inverses_differ(compared)) {
    text += "\ninverse polynomials\n  world2cam uses them: its pixels of the same rays are up to " +
            pixels(*compared.inverse_px) + " px apart\n";
  }
  text += "\n";
  if (!comparison.only_in_reference.empty()) {
    const std::vector<std::string> only = text::texts_of(comparison.only_in_reference, with_options);
    text += paragraph("only in " + reference_name + ": " + enumerated(only, "and"), "");
  }
  if (!comparison.only_in_other.empty())
    text += paragraph("only in " + name + ": " + enumerated(text::texts_of(comparison.only_in_other, with_options), "and"), "");
  constexpr std::size_t kInVerdict = 3;
  if (comparison.mistakes.size() > kInVerdict) {
    for (const Mistake& mistake : comparison.mistakes) text += paragraph("explained: " + sentence(mistake), "");
  }
  return text + "verdict: " + name + ": " + verdict_of(compared) + "\n";
}

}  // namespace fca::cli
