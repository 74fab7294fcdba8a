// SPDX-License-Identifier: BSD-3-Clause
#include "shell/option_hints.h"
#include "shell/pose_words.h"
#include "shell/program_words.h"
#include "shell/verdict_text.h"
#include "shell/words.h"
#include "show_command.h"

#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>
#include <fca/formats/wording.h>
#include <fca/rig/fields_of_view.h>
#include <fca/toolkit/format_name.h>

#include <algorithm>
#include <cmath>

namespace fca::cli {

namespace {

std::string degrees_or(const std::optional<double>& value) {
  return value ? fixed(*value, 1) + " deg" : std::string("not covered");
}

/// "+ 0.0021", "- 0.0003"
std::string signed_in_words(double value) { return (value < 0.0 ? "- " : "+ ") + text::format_short(std::abs(value), 9); }

/// Does what was read next to the representation speak of that camera?
bool is_of(const ExtraField& extra, const Camera& camera) { return extra.owner == camera.name; }

/// What is known of a lens without a model.
std::string rays_text(const Camera& camera) {
  double furthest = 0.0;
  for (const Correspondence& entry : camera.rays) furthest = std::max(furthest, angle_from_axis(entry.ray));
  std::string text = "\n" + camera.name + ": " + std::string(camera.lens_title()) + "\n";
  text += "  rays     " + std::to_string(camera.rays.size()) + ", up to " + angle_in_words(furthest * kDegreesPerRadian) + "\n";
  const Pixel centre = principal_point(camera.model);
  return text + "  axis     at about (" + text::format_short(centre[0], 5) + ", " + text::format_short(centre[1], 5) +
         ") px\n" +
         (camera.image_size ? "  image    " + std::to_string(camera.image_size->width) + " x " +
                                  std::to_string(camera.image_size->height) + " px\n"
                            : "");
}

/// What the model and the image size say.
std::string model_text(const Camera& camera, double limit_deg) {
  const ModelInfo& model = model_info(camera.model);
  std::string text = "\n" + camera.name + ": " + std::string(model.title) + " (" + std::string(model.id) + ")\n";
  const std::vector<std::string> elsewhere = names_elsewhere(model.id);
  if (!elsewhere.empty()) text += "  called   " + enumerated(elsewhere, "and") + "\n";
  text += parameters_in_words(camera.model, "  ");
  if (camera.image_size) {
    text +=
        "  image    " + std::to_string(camera.image_size->width) + " x " + std::to_string(camera.image_size->height) + " px\n";
    const FieldsOfView view = fields_of_view(camera, limit_deg / kDegreesPerRadian);
    text += "  view     horizontal " + degrees_or(in_degrees(view.horizontal)) + ", vertical " +
            degrees_or(in_degrees(view.vertical)) + ", diagonal " + degrees_or(in_degrees(view.diagonal)) + "\n";
    if (view.largest_from_axis)
      text += "           up to " + angle_in_words(*view.largest_from_axis * kDegreesPerRadian) + "\n";
  } else {
    text += "  image    size not given (--size WxH)\n";
  }
  text += "  model    " +
          (validate(camera.model).empty() ? "valid up to " + angle_in_words(max_angle(camera.model) * kDegreesPerRadian)
                                          : enumerated(text::texts_of(validate(camera.model), with_options))) +
          "\n";
  return text;
}

/// "458.654 +- 0.31": the parameters that a file specifies standard deviations of.
std::string sigmas_text(const Uncertainty& uncertainty) {
  std::string text;
  if (!uncertainty.sigmas.empty()) {
    const std::span<const Parameter> parameters = find_model(uncertainty.model)->parameters;
    std::vector<std::string> words;
    for (std::size_t i = 0; i < uncertainty.sigmas.size(); ++i) {
      if (uncertainty.sigmas[i] > 0.0)
        words.push_back(std::string(parameters[i].name) + " " + text::format_short(uncertainty.sigmas[i], 3));
    }
    text += "  sigma    " + enumerated(words, "and") + (uncertainty.has_covariance() ? ", with correlations" : "") + "\n";
  }
  if (uncertainty.reprojection_rms_px)
    text += "  residual " + pixels(*uncertainty.reprojection_rms_px) + " px rms (reprojection)\n";
  return text;
}

std::string camera_text(const Camera& camera, std::span<const ExtraField> extras, double limit_deg) {
  std::string text = camera.rays.empty() ? model_text(camera, limit_deg) : rays_text(camera);
  if (camera.time_offset_s) text += "  time     t_imu = t_cam " + signed_in_words(*camera.time_offset_s) + " s\n";
  if (camera.frame_rate_hz) text += "  rate     " + text::format_short(*camera.frame_rate_hz) + " Hz\n";
  if (!camera.topic.empty()) text += "  topic    " + camera.topic + "\n";
  for (const ExtraField& extra : extras) {
    if (is_of(extra, camera)) text += "  " + extra.key + ": " + text::shortened(value_of(extra, with_options)) + "\n";
  }
  return text;
}

/// A density of the IMU, and what it is for one sample: white noise grows with the root of the rate, the step of a random walk
/// shrinks with it.
std::string noise_line(std::string_view name, const std::optional<double>& density, std::string_view unit,
                       const std::optional<double>& per_sample, std::string_view sample_unit) {
  std::string text = "  " + padded(name, 26);
  if (!density) return text + "not given\n";
  text += text::format_short(*density) + " " + std::string(unit);
  if (per_sample) text += " (" + text::format_short(*per_sample, 3) + " " + std::string(sample_unit) + " per sample)";
  return text + "\n";
}

std::string imu_text(const Imu& imu) {
  const auto white = [&imu](const std::optional<double>& density) {
    return density && imu.rate_hz ? std::optional(*density * std::sqrt(*imu.rate_hz)) : std::nullopt;
  };
  const auto walk = [&imu](const std::optional<double>& density) {
    return density && imu.rate_hz ? std::optional(*density / std::sqrt(*imu.rate_hz)) : std::nullopt;
  };
  const Imu& i = imu;
  return "\n" + imu.name + ": noise as continuous-time densities (standard deviations, not variances)\n" +
         noise_line("gyroscope noise", i.gyroscope_noise_density, "rad/s/sqrt(Hz)", white(i.gyroscope_noise_density), "rad/s") +
         noise_line("gyroscope random walk", i.gyroscope_random_walk, "rad/s^2/sqrt(Hz)", walk(i.gyroscope_random_walk),
                    "rad/s") +
         noise_line("accelerometer noise", i.accelerometer_noise_density, "m/s^2/sqrt(Hz)",
                    white(i.accelerometer_noise_density), "m/s^2") +
         noise_line("accelerometer random walk", i.accelerometer_random_walk, "m/s^3/sqrt(Hz)",
                    walk(i.accelerometer_random_walk), "m/s^2") +
         "  " + padded("rate", 26) + (imu.rate_hz ? text::format_short(*imu.rate_hz) + " Hz" : "not given") + "\n" +
         (imu.topic.empty() ? "" : "  " + padded("topic", 26) + imu.topic + "\n");
}

/// "T_cam0_imu0: imu0 -> cam0, takes points in imu0 to points in cam0" and what that means.
std::string pose_text(const PoseEdge& edge, const Calibration& calibration) {
  std::string text = "  T_" + edge.a + "_" + edge.b + ": " + edge.b + " -> " + edge.a + ", takes points in " + edge.b +
                     " to points in " + edge.a;
  const std::string meaning = pose_in_words(edge, calibration.rig, !has_assumed_unit(edge, calibration));
  if (meaning.empty()) return text + "; its 3 x 3 part is singular\n";
  text += "\n    " + meaning;
  const double defect = rotation_defect(edge.T_a_b);
  constexpr double kPrintedRotation = 1e-3;
  if (defect > kPrintedRotation || rotation_determinant(edge.T_a_b) < 0.0)
    text += " (NOT a rotation: off by " + text::format_short(defect, 2) + ")";
  return text + "\n";
}

/// Those of poses, and those of a file without cameras.
std::string uncertainties_text(const Rig& rig) {
  std::string text;
  for (const Uncertainty& each : rig.uncertainties) {
    if (rig.find_camera(each.camera) == nullptr) text += "\n" + text::printable(each.camera) + "\n" + sigmas_text(each);
  }
  for (const PoseUncertainty& each : rig.pose_uncertainties) {
    const auto listed = [](const std::array<double, 3>& values, double unit) {
      std::vector<std::string> words(values.size());
      std::ranges::transform(values, words.begin(), [unit](double value) { return text::format_short(value * unit, 3); });
      return enumerated(words);
    };
    text += "\nT_" + each.a + "_" + each.b + "\n  sigma    rotation " + listed(each.rotation_rad, kDegreesPerRadian) +
            " deg, translation " + listed(each.translation_m, 1000.0) + " mm\n";
  }
  return text;
}

/// What the file says and the representation has no place for, by name.
std::string others_text(const Rig& rig) {
  std::vector<std::string> keys;
  for (const ExtraField& extra : rig.extra_fields) {
    if (std::ranges::none_of(rig.cameras, [&extra](const Camera& camera) { return is_of(extra, camera); }))
      keys.push_back(text::printable(with_owner(extra)));
  }
  return keys.empty() ? "" : "\nalso in the file\n" + wrapped(keys, "  ");
}

std::string readers_text(const Readers& readers) {
  if (readers.programs.empty()) return "";  // of a format that is only read
  std::string text = "\nread by\n";
  for (const Readers::Program& program : readers.programs) {
    text += "  " + program.program + ": ";
    if (program.loads) {
      text += program.sensors.empty() ? "yes\n" : "yes, as " + enumerated(program.sensors) + "\n";
      constexpr std::size_t kMostWarnings = 2;
      for (std::size_t i = 0; i < std::min(kMostWarnings, program.warnings.size()); ++i)
        text += "    but: " + text::printable(sentence_of(program.warnings[i], with_options)) + "\n";
      if (program.warnings.size() > kMostWarnings)
        text += "    and " + std::to_string(program.warnings.size() - kMostWarnings) + " more (--json lists them)\n";
    } else {
      text += "no: " + (program.refusals.empty() ? "it gives no reason"
                                                 : text::printable(sentence_of(program.refusals.front(), with_options)));
      if (program.refusals.size() > 1) text += " (and " + std::to_string(program.refusals.size() - 1) + " more)";
      text += "\n";
    }
  }
  return text;
}

/// What a part without cameras holds: Kalibr's imu.yaml, stereo_calib's extrinsics.yml.
std::string parts_in_words(const Rig& rig) {
  if (!rig.cameras.empty()) return "";
  if (!rig.imus.empty()) return ", an IMU without cameras";
  if (!rig.uncertainties.empty()) return ", the uncertainty of cameras";
  if (rig.poses.empty()) return ", without cameras and poses";
  return rig.poses.size() == 1 ? ", a pose without cameras" : ", poses without cameras";
}

/// "ready, for Kalibr; ", or "ready (mono) and do not use (stereo), for ORB-SLAM3 V1.0; ".
std::string verdict_in_words(const ShownFile& shown) {
  if (!shown.asked) return "";
  std::vector<std::string> words;
  for (const VerdictWord word : {VerdictWord::kReady, VerdictWord::kUseWithCare, VerdictWord::kDoNotUse}) {
    std::vector<std::string> modes;
    std::size_t count = 0;
    for (const ProgramReading::Mode& mode : shown.asked->modes) {
      if (mode.verdict.word != word) continue;
      ++count;
      modes.insert(modes.end(), mode.names.begin(), mode.names.end());
    }
    if (count == 0) continue;
    const bool is_of_all = count == shown.asked->modes.size();
    words.push_back(std::string(cli::in_words(word)) + (is_of_all ? "" : " (" + enumerated(modes) + ")"));
  }
  if (words.empty()) words.emplace_back(cli::in_words(VerdictWord::kDoNotUse));
  return enumerated(words) + ", for " + std::string(shown.asked->program->program) + "; ";
}

/// A file whose four coefficients may be those of two lenses, or that has a lens for each size of images: its cameras as each.
std::string readings_text(const ShownFile& shown) {
  const bool is_of_sizes = shown.readings.front().image_size.has_value();
  std::string text =
      text::printable(shown.file) + ": " + std::string(shown.readings.front().calibration.format->title) + "; " +
      (is_of_sizes ? "a lens for each size of images\n" : "which lens its four coefficients are, it does not say\n");
  for (const ReadingAs& reading : shown.readings) {
    if (reading.model) text += "\nwith --opencv-model " + std::string(name_of(*reading.model)) + "\n";
    if (const auto& size = reading.image_size)
      text += "\nwith --size " + std::to_string(size->width) + "x" + std::to_string(size->height) + "\n";
    for (const Camera& camera : reading.calibration.rig.cameras)
      text += camera_text(camera, reading.calibration.rig.extra_fields, shown.limit_deg);
  }
  return text;
}

std::string rectified_text(const RectifiedPair& pair) {
  return "\nrectified pair\n" +
         paragraph(pair.views[0].camera + " and " + pair.views[1].camera + ": fx " + text::format_short(pair.focal_lengths[0]) +
                       ", cx " + text::format_short(pair.views[0].centre[0]) + ", cy " +
                       text::format_short(pair.views[0].centre[1]) + " px, baseline " +
                       text::format_short(std::abs(pair.offset_m)) + " m; fca-io rectify uses it",
                   "  ");
}

}  // namespace

std::string show_text(const ShownFile& shown) {
  if (!shown.readings.empty()) return readings_text(shown);
  const Calibration& calibration = *shown.calibration;
  std::string text = text::printable(shown.file) + ": " + verdict_in_words(shown) +
                     std::string(name_of(*calibration.format, calibration.documents[calibration.with_cameras]).title) +
                     parts_in_words(calibration.rig) + " (" + text::text_of(calibration.why, with_options) + ")\n";
  constexpr double kWholeSphere = 180.0;
  if (shown.asked) text += program_reading_text(*shown.asked, calibration, shown.file, shown.limit_deg < kWholeSphere);
  for (const Camera& camera : calibration.rig.cameras) {
    text += camera_text(camera, calibration.rig.extra_fields, shown.limit_deg);
    for (const Uncertainty& each : calibration.rig.uncertainties) text += each.camera == camera.name ? sigmas_text(each) : "";
  }
  text += uncertainties_text(calibration.rig);
  for (const Imu& imu : calibration.rig.imus) text += imu_text(imu);
  if (calibration.rig.baseline_m)
    text += "\nbaseline of the rectified pair or depth sensor: " + text::format_short(*calibration.rig.baseline_m) + " m\n";
  if (calibration.rig.rectified) text += rectified_text(*calibration.rig.rectified);
  if (!calibration.rig.poses.empty()) text += "\nposes\n";
  for (auto edge = calibration.rig.poses.begin(); edge != calibration.rig.poses.end(); ++edge) {
    // Two files of one calibration may specify the same pose.
    if (std::find(calibration.rig.poses.begin(), edge, *edge) == edge) text += pose_text(*edge, calibration);
  }
  text += others_text(calibration.rig);
  return text + readers_text(shown.readers);
}

}  // namespace fca::cli
