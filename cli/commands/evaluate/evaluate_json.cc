// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_command.h"
#include "shell/json.h"
#include "shell/parameters_json.h"

#include <cmath>

namespace fca::cli {

namespace {

void put_size(Json& json, const ImageSize& size) {
  json.put("width_px", size.width);
  json.put("height_px", size.height);
}

/// A model and its parameters, as an object.
void put_model(Json& json, std::string_view key, const CameraModel& model) {
  json.object(key, [&] {
    json.put("model", model_info(model).id);
    put_parameters(json, model);
  });
}

void put_statistics(Json& json, const ErrorStatistics& statistics) {
  json.object("domain", [&] {
    json.put("max_angle_deg", statistics.coverage.max_angle_deg);
    json.put("scored_pixels", statistics.coverage.scored_pixels);
    json.put("outside_lens_pixels", statistics.coverage.outside_lens_pixels);
    json.put("unrepresentable_pixels", statistics.coverage.unrepresentable_pixels);
  });
  json.object("error_px", [&] {
    json.put("rms", statistics.error.rms);
    json.put("mean", statistics.error.mean);
    json.put("p50", statistics.error.p50);
    json.put("p95", statistics.error.p95);
    json.put("p99", statistics.error.p99);
    json.put("max", statistics.error.max);
    json.put("max_at", std::span<const double>(statistics.error.max_at));
  });
}

void put_fit(Json& json, const FitSummary& fit, double time_us) {
  json.object("fit", [&] {
    json.put("samples", fit.samples);
    json.put("iterations", fit.iterations);
    json.put("time_us", time_us);
  });
}

void put_painted(Json& json, std::string_view key, const std::optional<PaintedImage>& painted) {
  if (!painted) return;
  json.object(key, [&] {
    json.put("psnr_db", painted->psnr_db);
    json.put("ssim", painted->ssim);
  });
}

void put_row(Json& json, const EvaluatedRow& row) {
  json.put("from", row.published.from.name);
  json.put("to", row.published.to.name);
  json.object("paper", [&] {
    json.put("time_ms", row.published.time_ms);
    json.put("reprojection_error_px", row.published.reprojection_error_px);
    json.put("parameter_error", row.published.parameter_error);
    json.put("psnr_db", row.published.psnr_db);
    json.put("ssim", row.published.ssim);
  });
  if (row.published.authors_over_image) {
    json.object("authors_program_over_image_px", [&] {
      json.put("mean", row.published.authors_over_image->mean_px);
      json.put("rms", row.published.authors_over_image->rms_px);
      json.put("max", row.published.authors_over_image->max_px);
    });
  } else {
    json.null("authors_program_over_image_px");
  }
  put_model(json, "source", row.source);
  put_model(json, "target", row.conversion.camera.model);
  put_statistics(json, row.conversion.report.statistics);
  json.object("paper_samples", [&] {
    json.put("count", row.on_samples.count);
    json.put("mean_px", row.on_samples.mean_px);
  });
  json.put("parameter_error", row.parameter_error);
  put_fit(json, row.conversion.report.fit, row.time_us);
  if (row.recovered) {
    json.object("recovered_image", [&] {
      json.put("identical", std::isinf(row.recovered->psnr_db));
      json.put("psnr_db", row.recovered->psnr_db);  // null where it is infinite
      json.put("ssim", row.recovered->ssim);
      json.put("compared_share", row.recovered->compared);
    });
  }
  put_painted(json, "painted_image", row.painted);
  json.put("why", row.published.why);
}

void put_sweep(Json& json, const SampleSweep& sweep) {
  json.put("from", sweep.from.name);
  json.put("to", sweep.to.name);
  json.array("points", sweep.points, [&](const SweepPoint& point) {
    json.object([&] {
      json.put("samples_asked", point.asked);
      json.put("samples", point.taken);
      json.put("parameter_error", point.parameter_error);
      json.put("rms_px", point.rms_px);
      json.put("time_us", point.time_us);
    });
  });
}

/// What is here in place of Table 4.
void put_replacement(Json& json, const EvaluateResult& evaluation) {
  const ErrorSummary& error = evaluation.slam_camera.statistics.error;
  json.put("number", 4);
  json.put("reproduced", false);
  json.put("rms_px", error.rms);
  json.put("max_px", error.max);
  json.put("bound_px", error.bound);
  json.put("max_angle_deg", paper::slam_camera().max_angle_deg);
  json.put("why", replacement_in_words(evaluation));
}

void put_polynomial(Json& json, const paper::Polynomial& polynomial) {
  json.object("polynomial", [&] {
    json.put("a0", polynomial.a0);
    json.put("a1", polynomial.a1);
    json.put("a2", polynomial.a2);
  });
}

void put_polynomials(Json& json, const EvaluatedPolynomials& polynomials) {
  json.put("number", 3);
  json.put("title", polynomials.published.title);
  put_size(json, polynomials.published.size);
  put_model(json, "source", polynomials.published.source);
  json.object("toolbox", [&] { put_polynomial(json, polynomials.published.toolbox); });
  json.array("rows", polynomials.rows, [&](const EvaluatedPolynomial& row) {
    json.object([&] {
      json.put("method", row.method);
      json.put("published", !row.fit.has_value());
      put_polynomial(json, row.polynomial);
      json.put("rmse", row.rmse);
      put_model(json, "target", row.model);
      put_statistics(json, row.statistics);
      if (row.fit) {
        put_fit(json, *row.fit, row.time_us);
      } else {
        json.null("fit");
      }
    });
  });
  json.object("sign_error", [&] {
    json.put("a2_on_axis", polynomials.sign.right_a2);
    json.put("a2_on_axis_with_wrong_sign", polynomials.sign.wrong_a2);
    json.put("why", sign_error_in_words(polynomials));
  });
}

}  // namespace

std::string evaluate_json(const EvaluateResult& evaluation) {
  Json json;
  json.object([&] {
    json.put("fca_io", FCA_VERSION);
    json.array("conversions", evaluation.conversions, [&](const EvaluatedTable& table) {
      json.object([&] {
        json.put("number", table.published.number);
        json.put("title", table.published.title);
        put_size(json, table.published.size);
        json.put("max_angle_deg", table.published.max_angle_deg);
        json.array("rows", table.rows, [&](const EvaluatedRow& row) { json.object([&] { put_row(json, row); }); });
        put_painted(json, "painted_noise", table.painted_noise);
        json.put("remark", table.published.remark);
      });
    });
    json.object("polynomials", [&] { put_polynomials(json, evaluation.polynomials); });
    json.array("samples", evaluation.sweeps, [&](const SampleSweep& sweep) { json.object([&] { put_sweep(json, sweep); }); });
    json.object("slam", [&] { put_replacement(json, evaluation); });
  });
  return json.document();
}

}  // namespace fca::cli
