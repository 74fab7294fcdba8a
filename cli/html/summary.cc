// SPDX-License-Identifier: BSD-3-Clause
#include "sections.h"

#include "commands/convert/convert_command.h"
#include "shell/option_hints.h"
#include "shell/statistics_text.h"
#include "shell/verdict_text.h"
#include "shell/words.h"
#include "table.h"
#include "tile.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>
#include <fca/toolkit/format_name.h>

#include <algorithm>
#include <functional>

namespace fca::cli {

namespace {

std::string short_model_line(const Camera& camera) {
  const std::string size = camera.image_size ? ", " + size_in_words(*camera.image_size) + " px" : ", image size not given";
  return camera.name + ": " + std::string(camera.lens_id()) + size;
}

void put_rig_tile(Html& html, const Rig& rig) {
  std::vector<std::string> lines;
  for (const Camera& camera : rig.cameras) lines.push_back(short_model_line(camera));
  for (const Imu& imu : rig.imus)
    lines.push_back(imu.name + (imu.rate_hz ? ": IMU at " + text::format_short(*imu.rate_hz) + " Hz" : ": IMU"));
  put_tile(html, "In the file", counted(rig.cameras.size(), "camera"), lines);
}

void put_conversion_tile(Html& html, const ConvertResult& result, const ConvertedCamera& camera) {
  const std::string title = name_in_words(camera) + ": " + camera_line(camera);
  if (!camera.report || camera.source.model == camera.target.model) {
    put_tile(html, title, "kept", {"the same model and parameters"});
    return;
  }
  const ConversionReport& report = *camera.report;
  const ErrorSummary& error = report.statistics.error;
  std::vector<std::string> lines = {
      "worst pixel " + pixels(error.max) + " px at (" + fixed(error.max_at[0], 1) + ", " + fixed(error.max_at[1], 1) + ")",
      coverage_text(report.statistics.coverage, report.scored_to_deg)};
  if (const CameraDistance* distance = distance_of(result, camera)) {
    lines.push_back("as the program reads it: " + distance_in_words(distance->in_circle) + " in the inscribed circle, " +
                    distance_in_words(distance->in_image) + " " + std::string(image_in_words(*distance)));
  }
  put_tile(html, title, "rms " + pixels(error.rms) + " px", lines);
}

void put_findings_tile(Html& html, const ReportContents& contents) {
  std::size_t errors = 0;
  std::size_t warnings = 0;
  std::vector<std::string> lines;
  for (const CheckResult& file : contents.checks) {
    for (const Finding& finding : file.report.findings) {
      errors += finding.severity == Severity::kError ? 1 : 0;
      warnings += finding.severity == Severity::kWarning ? 1 : 0;
      if (finding.severity != Severity::kNote && std::ranges::find(lines, id_of(finding)) == lines.end())
        lines.emplace_back(id_of(finding));
    }
  }
  std::vector<std::string> parts;
  if (errors > 0) parts.push_back(counted(errors, "error"));
  if (warnings > 0) parts.push_back(counted(warnings, "warning"));
  if (lines.empty()) lines.emplace_back("see what was checked below");
  put_tile(html, "check", parts.empty() ? "nothing wrong found" : enumerated(parts), lines);
}

void put_losses_tile(Html& html, const ConvertResult& outcome) {
  const auto to_look_at = static_cast<std::size_t>(std::ranges::count(outcome.defaults, true, &DefaultedValue::look_at_it));
  std::vector<std::string> lines;
  if (to_look_at > 0) lines.push_back(counted(to_look_at, "value") + " to set by hand");
  for (const ProofResult& proof : outcome.proofs)
    lines.push_back(proof.program + (proof.loads ? " loads it" : " would refuse it"));
  std::size_t losses = outcome.losses.size();
  for (const ConvertedCamera& camera : outcome.cameras) {
    const double missing = camera.unrepresented_share();
    if (missing == 0.0) continue;
    ++losses;
    lines.push_back(name_in_words(camera) + ": " + percent(missing) + " of the image");
  }
  put_tile(html, "Lost in the conversion", losses == 0 ? "nothing" : counted(losses, "thing"), lines);
}

}  // namespace

void put_summary(Html& html, const ReportContents& contents) {
  const Calibration& calibration = *contents.shown.calibration;
  html.element("h1", {}, contents.title);
  html.element("p", {{"class", "soft"}},
               std::string(name_of(*calibration.format, calibration.documents[calibration.with_cameras]).title) + " (" +
                   text::text_of(calibration.why, with_options) + "), as fca-io " FCA_VERSION " reads it");
  put_verdict(html, contents);
  html.element("div", {{"class", "tiles"}}, [&] {
    put_rig_tile(html, calibration.rig);
    if (contents.conversion) {
      for (const ConvertedCamera& camera : contents.conversion->cameras)
        put_conversion_tile(html, *contents.conversion, camera);
    }
    put_findings_tile(html, contents);
    if (contents.conversion && contents.to != nullptr) put_losses_tile(html, *contents.conversion);
  });
}

void put_sources(Html& html, const ReportContents& contents) {
  html.element("h2", {}, "How this page was made");
  html.element("pre", {{"class", "command"}}, contents.command);
  if (!contents.convert.empty()) {
    html.element("p", {}, "The file itself:");
    html.element("pre", {{"class", "command"}}, contents.convert);
  }
  html.element("details", {}, [&] {
    html.element("summary", {}, "All that the file contains, as fca-io show prints it");
    html.element("pre", {}, show_text(contents.shown));
  });
}

}  // namespace fca::cli
