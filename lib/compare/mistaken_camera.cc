// SPDX-License-Identifier: BSD-3-Clause
#include "mistaken_camera.h"

#include "camera_difference.h"

#include <fca/rig/image_change.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace fca::internal {

namespace {

/// What the other would be without the slip.
struct Candidate {
  std::string code;
  std::string message;
  CameraModel undone;
};
using Candidates = std::vector<Candidate>;

void add_shifts(const CameraModel& other, double scale, Candidates& candidates) {
  struct Shift {
    double own_px;
    const char* code;
    const char* message;
  };
  constexpr std::array kShifts = {
      Shift{
          0.5, "half-pixel",
          "has its principal point half a pixel too far to the lower right: it counts from the corner of the first pixel, not "
          "from its centre"},
      Shift{-0.5, "half-pixel",
            "has its principal point half a pixel too far to the upper left: half a pixel was taken off that belongs to it"},
      Shift{1.0, "one-pixel",
            "has its principal point one pixel too far to the lower right: it counts from 1, as MATLAB does, not from 0"},
      Shift{-1.0, "one-pixel", "has its principal point one pixel too far to the upper left: 1 was subtracted once too often"}};
  for (const Shift& shift : kShifts) {
    const double px = -shift.own_px * scale;
    candidates.push_back({shift.code, shift.message, with_pixels(other, {{1.0, 1.0}, {px, px}})});
  }
  if (scale == 1.0) return;
  // Whoever scales cx alone forgets that the centre of the first pixel is half a pixel from its corner.
  const double px = 0.5 * (1.0 - scale);
  candidates.push_back({"scaled-without-half-pixel",
                        "was scaled from the larger or smaller image as cx s; pixels are areas: (cx + 0.5) s - 0.5",
                        with_pixels(other, {{1.0, 1.0}, {px, px}})});
}

void add_exchanged_centre(const CameraModel& other, Candidates& candidates) {
  const Pixel centre = principal_point(other);
  const double difference = centre[1] - centre[0];
  if (difference == 0.0) return;
  candidates.push_back({"centre-swapped", "has row and column of its principal point exchanged",
                        with_pixels(other, {{1.0, 1.0}, {difference, -difference}})});
}

void add_scales(const CameraModel& other, double scale, Candidates& candidates) {
  const auto scaled_by = [&other](double factor) {
    const double shift = 0.5 * (factor - 1.0);
    return with_pixels(other, {{factor, factor}, {shift, shift}});
  };
  for (const double factor : {0.5, 2.0}) {
    candidates.push_back({"other-resolution",
                          std::string("holds the numbers of images ") + (factor < 1.0 ? "twice" : "half") + " that size",
                          scaled_by(factor)});
  }
  if (scale != 1.0) {
    candidates.push_back(
        {"other-resolution", "states another image size and holds the numbers of the reference's", scaled_by(1.0 / scale)});
  }
}

/// The model with the value of `parameters[i]` where `parameters[i + 1]` is, and the last one's where the first is.
std::optional<CameraModel> cycled(const CameraModel& model, std::span<const ParameterId> parameters) {
  CameraModel result = model;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::optional<double> value = parameter(model, parameters[i]);
    if (!value || !set_parameter(result, parameters[(i + 1) % parameters.size()], *value)) return std::nullopt;
  }
  return result;
}

void add_other_orders(const CameraModel& other, Candidates& candidates) {
  struct Order {
    std::vector<ParameterId> cycle;
    const char* message;
  };
  static const std::vector<Order> kOrders = {
      {{"xi", "alpha"}, "has xi and alpha exchanged"},
      {{"alpha", "beta"}, "has alpha and beta exchanged"},
      {{"fx", "fy"}, "has fx and fy exchanged"},
      {{"p1", "p2"}, "has p1 and p2 exchanged"},
      {{"p1", "k3", "p2"}, "has its coefficients in the order k1 k2 k3 p1 p2 under the names k1 k2 p1 p2 k3"},
      {{"p1", "p2", "k3"}, "has its coefficients in the order k1 k2 p1 p2 k3 under the names k1 k2 k3 p1 p2"},
  };
  for (const Order& order : kOrders) {
    const std::optional<CameraModel> undone = cycled(other, order.cycle);
    if (undone && *undone != other) candidates.push_back({"parameters-swapped", order.message, *undone});
  }
}

/// The other's numbers, in their order, as the reference's model has them.
void add_other_name(const CameraModel& reference, const CameraModel& other, Candidates& candidates) {
  const ModelInfo& right = model_info(reference);
  const ModelInfo& wrong = model_info(other);
  if (right.id == wrong.id || !right.focal_lengths_first || !wrong.focal_lengths_first) return;
  constexpr std::size_t kBefore = 4;
  const std::span<const double> numbers = parameter_values(other);
  CameraModel undone = reference;
  const std::span<double> values = parameter_values(undone);
  const std::size_t count = std::min(numbers.size(), values.size());
  if (count <= kBefore || std::ranges::any_of(numbers.subspan(count), [](double value) { return value != 0.0; })) return;
  std::fill(values.begin(), values.end(), 0.0);
  std::copy_n(numbers.begin(), count, values.begin());
  const std::string message = "holds the numbers of " + std::string(right.id) + " under the name of " + std::string(wrong.id);
  candidates.push_back({"wrong-model", message, undone});
  if (count != kBefore + 2) return;
  // Double Sphere's two are xi alpha in most files, and alpha xi in some.
  std::swap(values[kBefore], values[kBefore + 1]);
  candidates.push_back({"wrong-model", message, undone});
}

}  // namespace

std::optional<Mistake> mistake_in(const Camera& reference, const Camera& other, double scale,
                                  const CameraDifference& difference, const Domain& domain) {
  constexpr double kNoArea = 1e-3;
  if (difference.judgement.error.max <= kSamePx && difference.judgement.coverage.unrepresentable <= kNoArea)
    return std::nullopt;
  Candidates candidates;
  add_shifts(other.model, scale, candidates);
  add_exchanged_centre(other.model, candidates);
  add_scales(other.model, scale, candidates);
  add_other_orders(other.model, candidates);
  add_other_name(reference.model, other.model, candidates);

  // A guess must come as near as two honest calibrations of one camera rarely do.
  constexpr double kNear = 1.0;
  double best = std::min(kNear, kExplained * misfit_px(reference.model, other.model, domain));
  std::optional<Mistake> mistake;
  for (const Candidate& candidate : candidates) {
    if (!validate(candidate.undone).empty()) continue;
    const double misfit = misfit_px(reference.model, candidate.undone, domain);
    if (!(misfit <= best)) continue;
    best = misfit;
    mistake = {candidate.code, other.name, candidate.message, {}};
  }
  return mistake;
}

}  // namespace fca::internal
