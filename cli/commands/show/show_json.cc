// SPDX-License-Identifier: BSD-3-Clause
#include "shell/diagnostics_json.h"
#include "shell/json.h"
#include "shell/option_hints.h"
#include "shell/parameters_json.h"
#include "shell/pose_words.h"
#include "shell/program_words.h"
#include "shell/verdict_json.h"
#include "shell/words.h"
#include "show_command.h"

#include <fca/formats/wording.h>
#include <fca/rig/fields_of_view.h>
#include <fca/toolkit/format_name.h>

#include <cmath>

namespace fca::cli {

namespace {

void put_camera(Json& json, const Camera& camera, double limit_deg) {
  json.put("name", camera.name);
  json.put("model", camera.lens_id());
  const bool has_model = camera.rays.empty();
  put_parameters(json, camera);
  if (!has_model) json.put("rays", static_cast<long long>(camera.rays.size()));
  const std::vector<std::string> elsewhere = has_model ? names_elsewhere(camera.lens_id()) : std::vector<std::string>();
  json.put("names_elsewhere", std::span<const std::string>(elsewhere));
  if (camera.image_size) {
    json.put("width_px", camera.image_size->width);
    json.put("height_px", camera.image_size->height);
  } else {
    json.null("width_px");
    json.null("height_px");
  }
  const FieldsOfView view = has_model ? fields_of_view(camera, limit_deg / kDegreesPerRadian) : FieldsOfView();
  json.put("horizontal_fov_deg", in_degrees(view.horizontal));
  json.put("vertical_fov_deg", in_degrees(view.vertical));
  json.put("diagonal_fov_deg", in_degrees(view.diagonal));
  json.put("max_angle_deg", in_degrees(view.largest_from_axis));
  json.put("model_max_angle_deg", has_model ? std::optional(max_angle(camera.model) * kDegreesPerRadian) : std::nullopt);
  json.put("time_offset_s", camera.time_offset_s);
  json.put("frame_rate_hz", camera.frame_rate_hz);
  if (!camera.topic.empty()) json.put("topic", camera.topic);
}

void put_imu(Json& json, const Imu& imu) {
  json.put("name", imu.name);
  json.put("gyroscope_noise_density", imu.gyroscope_noise_density);
  json.put("gyroscope_random_walk", imu.gyroscope_random_walk);
  json.put("accelerometer_noise_density", imu.accelerometer_noise_density);
  json.put("accelerometer_random_walk", imu.accelerometer_random_walk);
  json.put("rate_hz", imu.rate_hz);
  if (!imu.topic.empty()) json.put("topic", imu.topic);
}

void put_uncertainty(Json& json, const Uncertainty& uncertainty) {
  json.put("camera", uncertainty.camera);
  json.put("source", uncertainty.where.file);
  json.put("reprojection_rms_px", uncertainty.reprojection_rms_px);
  if (uncertainty.sigmas.empty()) return;
  json.put("model", uncertainty.model);
  json.object("sigmas", [&] {
    const std::span<const Parameter> parameters = find_model(uncertainty.model)->parameters;
    for (std::size_t i = 0; i < uncertainty.sigmas.size(); ++i) json.put(parameters[i].name, uncertainty.sigmas[i]);
  });
  json.put("covariance", std::span<const double>(uncertainty.covariance));
}

void put_mode(Json& json, const ProgramReading::Mode& mode, bool lens_given) {
  const ProofResult& proof = mode.proof;
  json.put("modes", std::span<const std::string>(mode.names));
  put_verdict(json, mode.verdict);
  json.put("loads", proof.loads);
  json.put("refusals", sentences_of(proof.refusals, with_options));
  json.array("cameras", proof.cameras, [&json](const CameraProof& camera) {
    json.object([&] {
      json.put("name", camera.name);
      json.put("model", camera.model);
      json.put("width_px", camera.width);
      json.put("height_px", camera.height);
      json.put("compared_share", camera.compared_share);
      json.put("max_diff_px", camera.max_diff_px);
      json.put("agrees", camera.agrees);
    });
  });
  json.put("poses", std::span<const std::string>(proof.poses));
  json.put("max_diff_pose", proof.max_diff_pose);
  json.put("other_numbers", text::texts_of(proof.other_numbers, with_options));
  json.put("warnings", std::span<const std::string>(misreadings(proof, lens_given)));
}

/// As the file specifies it.
void put_rectified(Json& json, const std::optional<RectifiedPair>& pair) {
  if (!pair) return json.null("rectified");
  json.object("rectified", [&] {
    json.put("vertical", pair->is_vertical);
    json.put("fx", pair->focal_lengths[0]);
    json.put("fy", pair->focal_lengths[1]);
    json.put("baseline_m", std::abs(pair->offset_m));
    json.array("views", pair->views, [&](const RectifiedPair::View& view) {
      json.object([&] {
        json.put("camera", view.camera);
        json.put("cx", view.centre[0]);
        json.put("cy", view.centre[1]);
        json.put("T_rectified_camera", std::span<const double>(view.T_rectified_camera.values));
      });
    });
  });
}

void put_file(Json& json, const ShownFile& shown, const Console& console) {
  json.put("file", shown.file);
  if (shown.calibration) {
    const Calibration& calibration = *shown.calibration;
    json.put("format", name_of(*calibration.format, calibration.documents[calibration.with_cameras]).id);
    json.put("why", text::text_of(calibration.why, with_options));
    json.array("cameras", calibration.rig.cameras,
               [&](const Camera& camera) { json.object([&] { put_camera(json, camera, shown.limit_deg); }); });
    json.array("imus", calibration.rig.imus, [&](const Imu& imu) { json.object([&] { put_imu(json, imu); }); });
    json.array("poses", calibration.rig.poses, [&](const PoseEdge& edge) {
      json.object([&] {
        json.put("a", edge.a);
        json.put("b", edge.b);
        json.put("T_a_b", std::span<const double>(edge.T_a_b.values));
        json.put("in_words", pose_in_words(edge, calibration.rig, !has_assumed_unit(edge, calibration)));
      });
    });
    json.put("baseline_m", calibration.rig.baseline_m);
    put_rectified(json, calibration.rig.rectified);
    if (!calibration.rig.uncertainties.empty()) {
      json.array("uncertainties", calibration.rig.uncertainties,
                 [&](const Uncertainty& each) { json.object([&] { put_uncertainty(json, each); }); });
    }
    if (!calibration.rig.pose_uncertainties.empty()) {
      json.array("pose_uncertainties", calibration.rig.pose_uncertainties, [&](const PoseUncertainty& each) {
        json.object([&] {
          json.put("a", each.a);
          json.put("b", each.b);
          json.put("rotation_rad", std::span<const double>(each.rotation_rad));
          json.put("translation_m", std::span<const double>(each.translation_m));
        });
      });
    }
    json.array("also_in_file", calibration.rig.extra_fields, [&](const ExtraField& extra) {
      json.object([&] {
        json.put("key", with_owner(extra));
        json.put("value", value_of(extra, with_options));
      });
    });
    json.array("read_by", shown.readers.programs, [&](const Readers::Program& program) {
      json.object([&] {
        json.put("program", program.program);
        json.put("loads", program.loads);
        json.put("sensors", std::span<const std::string>(program.sensors));
        json.put("refusals", sentences_of(program.refusals, with_options));
        json.put("warnings", sentences_of(program.warnings, with_options));
      });
    });
    if (shown.asked) {
      json.object("for", [&] {
        json.put("program", shown.asked->program->program);
        json.put("reads_format", shown.asked->reads_format);
        constexpr double kWholeSphere = 180.0;
        json.array("as", shown.asked->modes, [&](const ProgramReading::Mode& mode) {
          json.object([&] { put_mode(json, mode, shown.limit_deg < kWholeSphere); });
        });
      });
    }
  }
  if (!shown.readings.empty()) {
    json.array("readings", shown.readings, [&](const ReadingAs& reading) {
      json.object([&] {
        if (reading.model) json.put("opencv_model", name_of(*reading.model));
        if (reading.image_size)
          json.put("size", std::to_string(reading.image_size->width) + "x" + std::to_string(reading.image_size->height));
        json.array("cameras", reading.calibration.rig.cameras,
                   [&](const Camera& camera) { json.object([&] { put_camera(json, camera, shown.limit_deg); }); });
      });
    });
  }
  put_diagnostics(json, shown.diagnostics, console);
}

}  // namespace

std::string show_json(const std::vector<ShownFile>& files, const Console& console) {
  Json json;
  json.object([&] {
    json.put("fca_io", FCA_VERSION);
    json.array("files", files, [&](const ShownFile& shown) { json.object([&] { put_file(json, shown, console); }); });
  });
  return json.document();
}

}  // namespace fca::cli
