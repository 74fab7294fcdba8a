// SPDX-License-Identifier: BSD-3-Clause
#include "compare_command.h"
#include "shell/diagnostics_json.h"
#include "shell/difference_words.h"
#include "shell/json.h"
#include "shell/option_hints.h"
#include "shell/pair_json.h"
#include "shell/statistics_json.h"
#include "shell/words.h"

#include <fca/toolkit/format_name.h>

#include <cmath>
#include <limits>

namespace fca::cli {

namespace {

std::array<double, 2> pair_of(const ImageSize& size) {
  return {static_cast<double>(size.width), static_cast<double>(size.height)};
}

/// Distances that no image holds are as good as infinite: null.
void remove_beyond(const ImageSize& image, ErrorStatistics& statistics) {
  const auto remove = [most = std::hypot(image.width, image.height)](double& px) {
    if (px > most) px = std::numeric_limits<double>::infinity();
  };
  ErrorSummary& error = statistics.error;
  for (double* px : {&error.rms, &error.mean, &error.p50, &error.p95, &error.p99, &error.max, &error.bound}) remove(*px);
  for (ErrorBand& band : statistics.bands) {
    remove(band.rms_px);
    remove(band.max_px);
  }
}

void put_difference(Json& json, CameraDifference difference, const ImageSize& image, bool identical) {
  remove_beyond(image, difference.statistics);
  if (!identical && !(difference.statistics.coverage.scored > 0.0)) {  // no pixel has a ray in both
    for (const char* key : {"error_px", "error_deg", "bands", "same_to_deg"}) json.null(key);
    return;
  }
  put_error(json, difference.statistics.error);
  json.object("error_deg", [&] {
    json.put("rms", difference.angle.rms_deg);
    json.put("max", difference.angle.max_deg);
    json.put("max_at", std::span<const double>(difference.angle.max_at));
  });
  std::size_t i = 0;
  json.array("bands", difference.statistics.bands, [&](const ErrorBand& band) {
    json.object([&] {
      put_band(json, band);
      const bool known = i < difference.angle.bands.size();
      json.put("rms_deg", known ? std::optional(difference.angle.bands[i].rms_deg) : std::nullopt);
      json.put("max_deg", known ? std::optional(difference.angle.bands[i].max_deg) : std::nullopt);
      ++i;
    });
  });
  json.put("same_to_deg", difference.same_to_deg);
}

void put_focus(Json& json, const CameraComparison& camera) {
  if (!camera.focus) return json.null("focus");
  json.object("focus", [&] {
    json.put("max_angle_deg", camera.focus->max_angle_deg);
    put_difference(json, camera.focus->difference, camera.size, camera.identical);
    if (!camera.focus->rotated) return json.null("rotated");
    json.object("rotated", [&] { put_difference(json, *camera.focus->rotated, camera.size, false); });
  });
}

void put_camera(Json& json, const CameraComparison& camera) {
  json.put("name", camera.reference);
  json.put("other_name", camera.other);
  json.put("from_model", camera.reference_model);
  json.put("to_model", camera.other_model);
  json.put("image_size_px", std::span<const double>(pair_of(camera.size)));
  json.put("size_assumed", camera.size_assumed);
  if (camera.other_size) {
    json.put("scaled_from_px", std::span<const double>(pair_of(*camera.other_size)));
  } else {
    json.null("scaled_from_px");
  }
  json.array("parameters", camera.parameters, [&](const ParameterComparison& parameter) {
    json.object([&] {
      json.put("name", parameter.name);
      json.put("reference", parameter.reference);
      json.put("value", parameter.other);
    });
  });
  json.put("identical", camera.identical);
  put_field_of_view(json, camera.difference.statistics.coverage, camera.scored_to_deg);
  put_difference(json, camera.difference, camera.size, camera.identical);
  put_focus(json, camera);
  if (!camera.rotated) {
    json.null("rotated");
    return;
  }
  json.object("rotated", [&] {
    json.put("angle_deg", camera.rotated->angle_rad * kDegreesPerRadian);
    const auto& vector = camera.rotated->vector_rad;
    json.put("vector_rad", std::span<const double>(vector));
    json.put("distance_m", camera.rotated->distance_m);
    if (camera.rotated->distance_m) {
      json.put("centre_m", std::span<const double>(camera.rotated->centre_m));
    } else {
      json.null("centre_m");
    }
    json.put("in_words", rotation_in_words(*camera.rotated));
    json.put("cancels", camera.turn_cancels);
    put_difference(json, camera.rotated->difference, camera.size, false);
  });
}

/// Is there nothing that differs, or that only one of them says?
bool is_identical(const ComparedFile& compared) {
  return compared.comparison && exit_code(compared.status) <= ExitCode::kRejected && compared.comparison->identical() &&
         !inverses_differ(compared) && compared.comparison->only_in_reference.empty() &&
         compared.comparison->only_in_other.empty();
}

void put_comparison(Json& json, const RigComparison& comparison) {
  json.array("mistakes", comparison.mistakes, [&](const Mistake& mistake) {
    json.object([&] {
      json.put("code", id_of(mistake.message));
      json.put("subject", subject_of(mistake));
      json.put("message", sentence(mistake));
    });
  });
  json.array("cameras", comparison.cameras,
             [&](const CameraComparison& camera) { json.object([&] { put_camera(json, camera); }); });
  json.array("poses", comparison.poses, [&](const PoseComparison& pose) {
    json.object([&] {
      json.put("a", pose.a);
      json.put("b", pose.b);
      json.put("rotation_deg", pose.angle_rad * kDegreesPerRadian);
      json.put("translation_m", pose.distance_m);
      json.put("remaining_rotation_deg",
               pose.remaining ? std::optional(pose.remaining->angle_rad * kDegreesPerRadian) : std::nullopt);
      json.put("remaining_translation_m", pose.remaining ? std::optional(pose.remaining->distance_m) : std::nullopt);
      json.put("reference_length_m", pose.reference_length_m);
      json.put("length_m", pose.other_length_m);
      json.put("identical", pose.same_but_for_rounding());
    });
  });
  json.array("numbers", comparison.facts, [&](const FactComparison& fact) {
    json.object([&] {
      json.put("owner", fact.owner);
      json.put("name", fact.name);
      json.put("unit", fact.unit);
      json.put("reference", fact.reference);
      json.put("value", fact.other);
    });
  });
  const std::vector<std::string> in_reference = text::texts_of(comparison.only_in_reference, with_options);
  const std::vector<std::string> in_other = text::texts_of(comparison.only_in_other, with_options);
  json.put("only_in_reference", std::span<const std::string>(in_reference));
  json.put("only_in_file", std::span<const std::string>(in_other));
}

std::string_view format_of(const Calibration& calibration) {
  return name_of(*calibration.format, calibration.documents[calibration.with_cameras]).id;
}

}  // namespace

std::string compare_json(const ReferenceFile& reference, const std::vector<ComparedFile>& files, const Console& console) {
  Json json;
  json.object([&] {
    json.put("fca_io", FCA_VERSION);
    json.put("reference", reference.file);
    reference.calibration ? json.put("format", format_of(*reference.calibration)) : json.null("format");
    json.array("files", files, [&](const ComparedFile& compared) {
      json.object([&] {
        json.put("file", compared.file);
        compared.calibration ? json.put("format", format_of(*compared.calibration)) : json.null("format");
        json.put("exit_code", static_cast<int>(exit_code(compared.status)));
        json.put("verdict", verdict_of(compared));
        json.put("identical", is_identical(compared));
        json.put("inverse_px", compared.inverse_px);
        put_pair(json, compared.pair);
        put_comparison(json, compared.comparison.value_or(RigComparison()));
        put_diagnostics(json, compared.diagnostics, console);
      });
    });
    put_diagnostics(json, reference.diagnostics, console);
  });
  return json.document();
}

}  // namespace fca::cli
