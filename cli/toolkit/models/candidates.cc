// SPDX-License-Identifier: BSD-3-Clause
#include "models/best_first.h"
#include "models/model_advice.h"

#include <fca/code.h>
#include <fca/convert/field_of_view.h>
#include <fca/formats/verdict.h>
#include <fca/toolkit/models.h>
#include <fca/toolkit/read.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca {

namespace {

/// The formats that store the model. Each has a reason if the parameters are outside the ranges that the format can store.
std::vector<StoringFormat> stored_by(const CameraModel& model) {
  std::vector<StoringFormat> formats;
  for (const Format& format : written_formats()) {
    const StoredModel* row = find_stored_model(format, model_info(model).id, false);
    if (row == nullptr) continue;
    const StoringFormat one{name_in(format, *row), within(model, row->ranges) ? Code::kNone : row->why};
    if (std::ranges::find(formats, one) == formats.end()) formats.push_back(one);
  }
  return formats;
}

/// True if the fit covers the whole lens and its errors in the decisive region are unnoticeable (the verdict would be "ready").
bool is_good_as_whole(const Candidate& candidate) {
  return !candidate.conversion->report.angle_reduced && word_of(candidate.distance.decisive()) == VerdictWord::kReady;
}

/// True if `a` is a better choice than `b`. Exact conversions come first, and among these the camera's own model.
bool is_better_choice(const Candidate& a, const Candidate& b) {
  const ConversionReport& of_a = a.conversion->report;
  const ConversionReport& of_b = b.conversion->report;
  if (of_a.exact != of_b.exact) return of_a.exact;
  if (of_a.exact) return of_a.from_model == of_a.to_model && of_b.from_model != of_b.to_model;
  if (reaches_all(a) != reaches_all(b)) return reaches_all(a);
  if (!reaches_all(a)) return is_better(of_a, of_b);
  // A good fit to the whole lens comes before a fit to a part of it.
  if (is_good_as_whole(a) != is_good_as_whole(b)) return is_good_as_whole(a);
  return a.decisive().rms < b.decisive().rms;
}

/// The distance of `model` from the camera, measured as if a program had read `model` from a file.
CameraDistance distance_to(const Camera& camera, const CameraModel& model, std::optional<double> max_angle_rad) {
  consumers::ConsumerCamera reader;
  reader.project = [&model](const Ray& ray) { return project(model, ray); };
  return distance_of(camera, model, reader, {.asked = max_angle_rad.value_or(std::numbers::pi)});
}

/// Fits the candidate's model again, but only to the inscribed circle of the image. nullopt if the lens is not wide or if the
/// new fit is not worth it.
std::optional<CircleFit> fitted_in_circle(const Camera& camera, const Candidate& candidate) {
  const std::optional<double> degrees = degrees_in_circle(camera);
  if (!degrees || !candidate.distance.is_wide || is_good_as_whole(candidate)) return std::nullopt;
  ConvertOptions options;
  options.model = candidate.model->id;
  options.max_angle_rad = *degrees * std::numbers::pi / 180.0;
  options.bound = false;
  Diagnostics discarded;  // those of the fit to the whole lens suffice
  const std::optional<Conversion> conversion = convert(camera, options, discarded);
  if (!conversion || conversion->report.angle_reduced) return std::nullopt;
  const PixelDistance distance = distance_to(camera, conversion->camera.model, std::nullopt).in_circle;
  const PixelDistance& whole = candidate.distance.in_circle;
  const bool is_worth_it =
      reaches_all(candidate) ? is_worth_a_nearer_fit(whole.rms, distance.rms) : distance.no_rays <= whole.no_rays;
  return is_worth_it ? std::optional(CircleFit{*degrees, distance}) : std::nullopt;
}

/// The best of the candidates that have a conversion and for which admits(candidate) is true. Null if there is none.
template <class Admits>
const Candidate* best(const std::vector<Candidate>& candidates, Admits&& admits) {
  const Candidate* result = nullptr;
  for (const Candidate& candidate : candidates) {
    if (!candidate.conversion || !admits(candidate)) continue;
    if (result == nullptr || is_better_choice(candidate, *result)) result = &candidate;
  }
  return result;
}

}  // namespace

bool reaches_all(const Candidate& candidate) {
  constexpr double kNoticeableShare = 0.01;  // share of the region
  const bool ends_early = !candidate.in_circle && candidate.conversion->report.angle_reduced;
  return !ends_early && candidate.decisive().no_rays <= kNoticeableShare;
}

std::vector<const Candidate*> ranked(const std::vector<Candidate>& candidates) {
  std::vector<const Candidate*> result;
  for (const Candidate& candidate : candidates) {
    if (candidate.conversion) result.push_back(&candidate);
  }
  // Inexact models that cover the whole region are ranked by their errors alone.
  const auto is_ranked_by_error = [](const Candidate& each) { return !each.conversion->report.exact && reaches_all(each); };
  const auto comes_first = [&](const Candidate* a, const Candidate* b) {
    return is_ranked_by_error(*a) && is_ranked_by_error(*b) ? a->decisive().rms < b->decisive().rms : is_better_choice(*a, *b);
  };
  put_best_first(result, comes_first);
  return result;
}

std::vector<Candidate> candidates(const Camera& camera, std::optional<double> max_angle_rad) {
  std::vector<Candidate> result;
  for (const ModelInfo& model : all_models()) {
    if (model.kept_only && model.id != model_info(camera.model).id) continue;
    Candidate candidate;
    candidate.model = &model;
    ConvertOptions options;
    options.model = model.id;
    options.max_angle_rad = max_angle_rad;
    candidate.conversion = convert(camera, options, candidate.diagnostics);
    if (candidate.conversion) {
      candidate.stored_by = stored_by(candidate.conversion->camera.model);
      candidate.distance = distance_to(camera, candidate.conversion->camera.model, max_angle_rad);
      if (!max_angle_rad && !camera.lens_circle) candidate.in_circle = fitted_in_circle(camera, candidate);
    }
    result.push_back(std::move(candidate));
  }
  return result;
}

const Candidate* recommended(const std::vector<Candidate>& candidates, const Format* format) {
  return best(candidates, [format](const Candidate& candidate) {
    return format == nullptr || find_stored_model(*format, candidate.model->id, true) != nullptr;
  });
}

const Candidate* recommended_beside(const std::vector<Candidate>& candidates, const Candidate& other) {
  return best(candidates, [&other](const Candidate& candidate) { return &candidate != &other; });
}

std::optional<std::vector<ModelsResult::OfCamera>> compare_models(const std::vector<Camera>& cameras,
                                                                  std::optional<double> max_angle_rad,
                                                                  Diagnostics& diagnostics) {
  // Errors that concern every model are reported once, here.
  bool all_have_fields_of_view = true;
  for (const Camera& camera : cameras)
    all_have_fields_of_view = field_of_view_of(camera, max_angle_rad, diagnostics).has_value() && all_have_fields_of_view;
  if (!all_have_fields_of_view) return std::nullopt;
  std::vector<ModelsResult::OfCamera> result;
  result.reserve(cameras.size());
  for (const Camera& camera : cameras) result.push_back({camera, candidates(camera, max_angle_rad)});
  return result;
}

ModelsResult compare_models(const Inputs& inputs, Files& files) {
  ModelsResult result;
  const std::optional<Calibration> calibration = read_calibration(inputs, files, result.diagnostics);
  if (calibration && calibration->rig.cameras.empty()) result.diagnostics.add(Code::kFileWithoutCamera, {inputs.files.front()});
  if (calibration && !result.diagnostics.has_errors()) {
    auto cameras = compare_models(calibration->rig.cameras, inputs.max_angle_rad, result.diagnostics);
    if (cameras) result.cameras = *std::move(cameras);
  }
  result.status = status_of(result.diagnostics);
  if (result.cameras.empty() && result.status == Status::kDone) result.status = Status::kBadInput;
  return result;
}

}  // namespace fca
