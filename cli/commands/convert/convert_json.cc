// SPDX-License-Identifier: BSD-3-Clause
#include "conversion_json.h"
#include "convert_command.h"
#include "shell/base64.h"
#include "shell/diagnostics_json.h"
#include "shell/json.h"
#include "shell/option_hints.h"
#include "shell/pair_json.h"
#include "shell/parameters_json.h"
#include "shell/statistics_json.h"
#include "shell/uncertainty_text.h"
#include "shell/verdict_json.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>
#include <fca/rig/rotation.h>
#include <fca/toolkit/format_name.h>

#include <algorithm>

namespace fca::cli {

namespace {

void put_report(Json& json, const ConversionReport& report) {
  json.put("at_bound", std::span<const std::string>(report.at_bound));
  put_field_of_view(json, report.statistics.coverage, report.scored_to_deg);
  put_error(json, report.statistics.error);
  json.array("bands", report.statistics.bands, [&](const ErrorBand& band) { json.object([&] { put_band(json, band); }); });
  json.array("reach", report.max_angles, [&](const MaxAngleRow& row) {
    json.object([&] {
      json.put("max_angle_deg", row.max_angle_deg);
      json.put("scored_to_deg", row.scored_to_deg);
      json.put("scored_share", row.scored);
      json.put("unrepresentable_share", row.unrepresentable);
      json.put("rms_px", row.rms_px);
      json.put("max_px", row.max_px);
    });
  });
  json.put("objective", report.objective == Objective::kMax ? "max" : "rms");
  if (report.rms_fit) {
    json.object("rms_fit", [&] {
      json.put("rms_px", report.rms_fit->rms_px);
      json.put("max_px", report.rms_fit->max_px);
      json.put("kept", report.rms_fit->kept);
    });
  } else {
    json.null("rms_fit");
  }
  if (report.weighted) {
    json.object("weighted", [&] {
      json.put("weight", report.weighted->kind == WeightKind::kAngle ? "angle" : "image");
      json.put("rms_px", report.weighted->rms_px);
    });
  }
  if (report.turn) {
    json.object("turn", [&] {
      json.put("vector_rad", rotation_vector(report.turn->T_target_source));
      json.put("rms_before_px", report.turn->rms_before_px);
      json.put("max_before_px", report.turn->max_before_px);
    });
  }
  json.object("fit", [&] {
    json.put("samples", report.fit.samples);
    json.put("iterations", report.fit.iterations);
    if (report.degree > 0) json.put("degree", report.degree);
    json.put("time_us", report.fit.time_us);
  });
}

void put_proofs(Json& json, const ConvertOutcome& outcome) {
  json.array("proof", outcome.proofs, [&](const ProofResult& proof) {
    json.object([&] {
      json.put("program", proof.program);
      json.put("loads", proof.loads);
      json.put("agrees", proof.understood());
      json.put("max_diff_px", proof.max_diff_px);
      json.put("misread_px", proof.misread_px);
      json.put("compared_share", proof.compared_share);
      json.put("unanswered_share", proof.unanswered_share);
      json.put("wrong_ray_share", proof.wrong_ray_share);
      json.put("wrong_ray_px", proof.wrong_ray_px);
      json.put("max_diff_pose", proof.max_diff_pose);
      json.put("other_numbers", text::texts_of(proof.other_numbers, with_options));
      json.put("refusals", sentences_of(proof.refusals, with_options));
      json.put("warnings", sentences_of(proof.warnings, with_options));
    });
  });
}

/// Over a region, as the program that the files are for sees it; null where nobody was asked.
void put_seen(Json& json, std::string_view key, const PixelDistance* distance) {
  if (distance == nullptr) return json.null(key);
  json.object(key, [&] {
    json.put("rms", distance->rms);
    json.put("p99", distance->p99);
    json.put("max", distance->max);
    json.put("share", distance->region);
    json.put("no_rays_share", distance->no_rays);
  });
}

void put_defaults(Json& json, const ConvertOutcome& outcome) {
  json.array("defaults", outcome.defaults, [&](const DefaultedValue& value) {
    json.object([&] {
      json.put("key", value.key);
      const auto* const spelled = std::get_if<std::string>(&value.value.value);
      const std::optional<int> whole = spelled != nullptr ? text::parse_int(*spelled) : std::nullopt;
      const std::optional<double> number = spelled != nullptr ? text::parse_real(*spelled) : std::nullopt;
      if (whole) {
        json.put("value", *whole);
      } else if (number) {
        json.put("value", *number);
      } else {
        json.put("value", value_of(value, with_options));
      }
      json.put("look_at_it", value.look_at_it);
    });
  });
}

void put_losses(Json& json, const ConvertOutcome& outcome) {
  json.array("losses", outcome.losses, [&](const Loss& loss) {
    json.object([&] {
      json.put("code", id_of(loss));
      json.put("what", what_of(loss, with_options));
      json.put("why", why_of(loss, with_options));
      json.put("do", remedy_of(loss, with_options));
      json.put("matters", loss.matters);
    });
  });
}

/// What the file written calls a camera of the input.
std::string written_name(const ConvertOutcome& outcome, const std::string& name) {
  const auto camera =
      std::ranges::find_if(outcome.cameras, [&name](const ConvertedCamera& each) { return each.source.name == name; });
  return camera == outcome.cameras.end() ? name : camera->name();
}

/// `with_text`: also of files that have a path.
void put_outputs(Json& json, const char* key, const ConvertOutcome& outcome, const std::vector<ConvertedFile>& files,
                 bool with_text) {
  json.array(key, files, [&](const ConvertedFile& output) {
    json.object([&] {
      output.path.empty() ? json.null("path") : json.put("path", output.path);
      std::vector<std::string> names;
      for (const std::string& name : output.cameras) names.push_back(written_name(outcome, name));
      json.put("cameras", std::span<const std::string>(names));
      if (!with_text && !output.path.empty()) return;
      const bool binary = output.syntax == text::Syntax::kBinary;
      binary ? json.put("base64", base64(output.bytes)) : json.put("text", output.bytes);
    });
  });
}

/// What the input is called, by its bytes where they are at hand.
std::string_view name_of_input(const ConvertOutcome& outcome, std::span<const text::Source> sources) {
  const auto source = std::ranges::find(sources, outcome.input, &text::Source::name);
  return source != sources.end() ? name_of(*outcome.from, *source).id : outcome.from->id;
}

std::string_view name_of_output(const ConvertOutcome& outcome) {
  if (outcome.files.empty()) return outcome.to->id;
  const ConvertedFile& file = outcome.files.front();
  return name_of(*outcome.to, text::Source{file.name, file.bytes}).id;
}

}  // namespace

void put_conversion(Json& json, const ConvertOutcome& outcome, std::span<const text::Source> sources) {
  json.put("input", outcome.input);
  if (outcome.from != nullptr) json.put("from", name_of_input(outcome, sources));
  if (outcome.to != nullptr) json.put("to", name_of_output(outcome));
  if (outcome.headline.is_said()) json.put("headline", text::text_of(outcome.headline, with_options));
  if (outcome.status <= Status::kRejected) put_verdict(json, outcome.verdict);
  const std::vector<ConvertedFile> none;
  const bool is_refused = outcome.status == Status::kRejected;
  put_outputs(json, "outputs", outcome, outcome.code == ExitCode::kGood ? outcome.files : none, false);
  if (is_refused) put_outputs(json, "refused_outputs", outcome, outcome.files, true);
  json.put("exit_code", static_cast<int>(outcome.code));
  json.array("cameras", outcome.cameras, [&](const ConvertedCamera& camera) {
    json.object([&] {
      json.put("name", camera.name());
      json.put("input_name", camera.source.name);
      json.put("from_model", camera.source.lens_id());
      json.put("to_model", camera.target.lens_id());
      json.put("exact", !camera.report || camera.report->exact);
      put_parameters(json, camera.target);
      if (camera.report) {
        put_report(json, *camera.report);
        put_uncertainty(json, *camera.report, camera.target.model);
      } else {
        for (const char* key : {"domain", "error_px", "bands", "objective", "rms_fit", "fit"}) json.null(key);
      }
      const CameraDistance* distance = distance_of(outcome, camera);
      put_seen(json, "in_circle_px", distance != nullptr ? &distance->in_circle : nullptr);
      put_seen(json, "in_image_px", distance != nullptr ? &distance->in_image : nullptr);
    });
  });
  put_proofs(json, outcome);
  put_pair(json, outcome.pair);
  json.array("other_writings", outcome.others, [&](const OtherWriting& other) {
    json.object([&] {
      json.put("layout", other.layout);
      json.put("model", other.model);
      json.put("rms_px", other.rms_px);
      json.put("max_px", other.max_px);
    });
  });
  put_defaults(json, outcome);
  put_losses(json, outcome);
  put_diagnostics(json, outcome.diagnostics, sources);
}

std::string conversion_json(const ConvertOutcome& outcome, std::span<const text::Source> sources) {
  Json json;
  json.object([&] { put_conversion(json, outcome, sources); });
  return json.text();
}

}  // namespace fca::cli
