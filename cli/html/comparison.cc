// SPDX-License-Identifier: BSD-3-Clause
#include "comparison.h"

#include "camera_figures.h"
#include "page.h"
#include "rig_drawing.h"
#include "said.h"
#include "shell/difference_words.h"
#include "shell/option_hints.h"
#include "shell/statistics_text.h"
#include "shell/words.h"
#include "table.h"

#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>
#include <fca/rig/image_change.h>
#include <fca/toolkit/format_name.h>

#include <algorithm>

namespace fca::cli {

namespace {

std::string both_names(const CameraComparison& camera) {
  return camera.reference == camera.other ? camera.reference : camera.reference + " and " + camera.other;
}

void put_tiles(Html& html, const RigComparison& comparison) {
  html.element("div", {{"class", "tiles"}}, [&] {
    for (const CameraComparison& camera : comparison.cameras) {
      const ErrorSummary& error = camera.decisive().statistics.error;
      html.element("div", {{"class", "tile"}}, [&] {
        html.element("div", {{"class", "soft"}}, both_names(camera));
        html.element("div", {{"class", "big"}},
                     camera.identical ? "identical" : "rms " + pixels(error.rms, camera.size) + " px");
        if (camera.identical) return;
        html.element("div", {{"class", "soft"}}, "worst pixel " + pixels(error.max, camera.size) + " px");
        html.element("div", {{"class", "soft"}}, same_in_words(camera.decisive()));
        if (camera.turn_cancels) html.element("div", {{"class", "soft"}}, "with a turn that its poses cancel");
      });
    }
  });
}

void put_line(Html& html, const char* what, const std::string& text) {
  html.element("p", {}, [&] {
    html.element("span", {{"class", "soft"}}, what);
    html.text(text);
  });
}

void put_words(Html& html, const CameraComparison& camera) {
  if (camera.other_size) put_line(html, "scaled from: ", size_in_words(*camera.other_size) + " px");
  if (camera.size_assumed) put_line(html, "size: ", "assumed, no file contains one (--size does)");
  if (camera.identical) {
    put_line(html, "difference: ", "none: the same model and parameters");
    return;
  }
  const CameraDifference& difference = camera.difference;
  const Coverage& coverage = difference.statistics.coverage;
  put_line(html, "field of view: ", field_of_view_in_words(coverage) + "; " + coverage_text(coverage, camera.scored_to_deg));
  put_line(html, "difference: ",
           error_text(difference.statistics, camera.size) + "; rms " + pixels(difference.angle.rms_deg) + " deg, max " +
               pixels(difference.angle.max_deg) + " deg");
  put_line(html, "", same_in_words(difference));
  if (camera.focus) {
    put_line(html, "focus: ",
             "up to " + fixed(camera.focus->max_angle_deg, 1) +
                 " deg from the axis: " + error_text(camera.focus->difference.statistics, camera.size));
  }
  if (!turning_helps(camera) || is_larger_than(camera.counted_rotated()->statistics, camera.size)) return;
  const ErrorSummary& turned = camera.counted_rotated()->statistics.error;
  put_line(html, "rotation between them: ",
           rotation_in_words(*camera.rotated) + "; with that undone rms " + pixels(turned.rms, camera.size) + " px, max " +
               pixels(turned.max, camera.size) + " px");
  if (camera.turn_cancels) put_line(html, "its poses: ", cancelled_turn_in_words(camera));
}

/// The parameters that differ, for images of one size.
void put_parameters(Html& html, const CameraComparison& camera) {
  Table table{{"parameter", "reference", "compared", "difference"}, {}, "cards"};
  const auto in_words = [](const std::optional<double>& value) { return value ? text::format_short(*value, 7) : "none"; };
  for (const ParameterComparison& row : camera.parameters) {
    if (row.same_but_for_rounding()) continue;
    table.rows.push_back({row.name, in_words(row.reference), in_words(row.other),
                          row.reference && row.other ? text::format_short(*row.other - *row.reference, 4) : ""});
  }
  if (!table.rows.empty()) put_table(html, table);
}

/// The other camera in the reference's pixels.
std::optional<Camera> in_pixels_of(const CameraComparison& compared, Camera other) {
  if (!compared.other_size) return other;
  other.image_size = compared.other_size;
  Diagnostics discarded;
  return with_changed_images(other, {.resize = compared.size}, discarded);
}

void put_camera(Html& html, const CameraComparison& compared, const Rig& reference, const Rig& other,
                std::optional<double> limit_rad) {
  const Camera* from = reference.find_camera(compared.reference);
  const Camera* to = other.find_camera(compared.other);
  html.element("h3", {},
               both_names(compared) + ": " + compared.reference_model + " and " + compared.other_model + ", " +
                   size_in_words(compared.size) + " px");
  put_parameters(html, compared);
  put_words(html, compared);
  if (from == nullptr || to == nullptr) return;
  Camera source = *from;
  source.image_size = compared.size;
  const std::optional<Camera> target = in_pixels_of(compared, *to);
  if (!target) return;
  DrawnCamera drawn{source, "reference (" + compared.reference_model + ")"};
  drawn.limit_rad = limit_rad;
  if (!compared.identical) {
    drawn.target = &target->model;
    drawn.target_label = "compared (" + compared.other_model + ")";
    drawn.statistics = &compared.difference.statistics;
    drawn.scored_to_deg = compared.scored_to_deg;
    drawn.distance = "Difference";
    // The curve is drawn for points infinitely far away.
    if (turning_helps(compared) && !compared.rotated->distance_m) {
      drawn.rotation = &compared.rotated->T_other_reference;
      drawn.rotated = &compared.rotated->difference.statistics;
    }
  }
  put_figures(html, drawn);
}

void put_rigs(Html& html, const ReferenceFile& reference, const ComparedFile& compared) {
  for (const Calibration* calibration : {&*reference.calibration, &*compared.calibration}) {
    const PlacedRig placed = placed_rig(calibration->rig);
    if (placed.frames.size() < 2) continue;
    const bool first = calibration == &*reference.calibration;
    html.element("h3", {}, file_in_words(first ? reference.file : compared.file) + (first ? " (reference)" : " (compared)"));
    html.element("div", {{"class", "figures"}}, [&] { put_rig(html, placed, calibration->poses_without_unit.empty()); });
  }
}

void put_poses(Html& html, const std::vector<PoseComparison>& poses) {
  if (poses.empty()) return;
  Table table{{"pose", "angle, deg", "position, mm", "reference's distance, mm", "compared one's, mm"}, {}, "cards"};
  const auto millimetres = [](double metres) { return text::format_short(1000.0 * metres, 5); };
  const auto with_rest = [](double whole, const std::optional<double>& rest) {
    return text::format_short(whole, 3) + (rest ? " (" + text::format_short(*rest, 3) + " with the turn)" : "");
  };
  for (const PoseComparison& pose : poses) {
    const bool same = pose.same_but_for_rounding();
    std::optional<double> rest_deg;
    std::optional<double> rest_mm;
    if (pose.remaining) {
      rest_deg = pose.remaining->angle_rad * kDegreesPerRadian;
      rest_mm = 1000.0 * pose.remaining->distance_m;
    }
    table.rows.push_back({"T_" + pose.a + "_" + pose.b,
                          same ? "the same" : with_rest(pose.angle_rad * kDegreesPerRadian, rest_deg),
                          same ? "the same" : with_rest(1000.0 * pose.distance_m, rest_mm),
                          millimetres(pose.reference_length_m), millimetres(pose.other_length_m)});
  }
  put_table(html, table);
}

void put_facts(Html& html, const std::vector<FactComparison>& facts) {
  if (facts.empty()) return;
  html.element("h2", {}, "Numbers");
  Table table{{"number", "reference", "compared", "unit"}, {}, "cards"};
  for (const FactComparison& fact : facts) {
    table.rows.push_back({(fact.owner.empty() ? "" : fact.owner + " ") + fact.name, text::format_short(fact.reference),
                          fact.same_but_for_rounding() ? "the same" : text::format_short(fact.other), fact.unit});
  }
  put_table(html, table);
}

void put_only(Html& html, const RigComparison& comparison) {
  if (!comparison.only_in_reference.empty())
    put_line(html, "only in the reference: ", enumerated(text::texts_of(comparison.only_in_reference, with_options), "and"));
  if (!comparison.only_in_other.empty())
    put_line(html, "only in the compared file: ", enumerated(text::texts_of(comparison.only_in_other, with_options), "and"));
}

void put_diagnostics(Html& html, const char* title, const Diagnostics& diagnostics) {
  if (!diagnostics.entries().empty()) html.element("h2", {}, title);
  for (const Diagnostic& entry : diagnostics.entries()) {
    put_said(html, {entry.severity, id_of(entry), message_of(entry, with_options), entry.where.file, "",
                    fix_of(entry, with_options)});
  }
}

std::string title_of(const Calibration& calibration) {
  return std::string(name_of(*calibration.format, calibration.documents[calibration.with_cameras]).title);
}

}  // namespace

std::string comparison_page(const ReferenceFile& reference, const ComparedFile& compared, std::optional<double> max_angle_rad,
                            const std::string& command) {
  const RigComparison& comparison = *compared.comparison;
  const std::string title = file_in_words(compared.file) + " next to " + file_in_words(reference.file);
  return page_around(title, [&](Html& html) {
    html.element("h1", {}, title);
    html.element("p", {{"class", "soft"}},
                 title_of(*compared.calibration) + " next to " + title_of(*reference.calibration) +
                     ", as fca-io " FCA_VERSION " reads them");
    html.element("p", {{"class", "strong verdict"}}, "Verdict: " + verdict_of(compared));
    for (const Mistake& mistake : comparison.mistakes)
      html.element("p", {{"class", "warning"}}, "Explained: " + sentence(mistake));
    put_tiles(html, comparison);
    html.element("h2", {}, "Cameras");
    for (const CameraComparison& camera : comparison.cameras) {
      html.element("section", {{"class", "camera"}},
                   [&] { put_camera(html, camera, reference.calibration->rig, compared.calibration->rig, max_angle_rad); });
    }
    if (!comparison.poses.empty()) {
      html.element("h2", {}, "Poses");
      put_poses(html, comparison.poses);
      put_rigs(html, reference, compared);
    }
    put_facts(html, comparison.facts);
    put_only(html, comparison);
    put_diagnostics(html, "Messages while reading the reference", reference.diagnostics);
    put_diagnostics(html, "Messages while comparing", compared.diagnostics);
    html.element("h2", {}, "How this page was made");
    html.element("pre", {{"class", "command"}}, command);
    html.element("details", {}, [&] {
      html.element("summary", {}, "All of it, as fca-io compare prints it");
      html.element("pre", {}, compare_text(reference, compared, true));
    });
  });
}

}  // namespace fca::cli
