// SPDX-License-Identifier: BSD-3-Clause
#include "mistaken_camera.h"

#include "camera_difference.h"

#include <fca/code.h>
#include <fca/rig/image_change.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

namespace fca::internal {

namespace {

/// What the other would be without the mistake.
struct Candidate {
  Code code;
  CameraModel undone;
  std::vector<Argument> more = {};  ///< Behind the camera's name.
};
using Candidates = std::vector<Candidate>;

void add_shifts(const CameraModel& other, double scale, Candidates& candidates) {
  struct Shift {
    double own_px;
    Code code;
  };
  constexpr std::array kShifts = {Shift{0.5, Code::kHalfPixelTooFar}, Shift{-0.5, Code::kHalfPixelTooNear},
                                  Shift{1.0, Code::kOnePixelTooFar}, Shift{-1.0, Code::kOnePixelTooNear}};
  for (const Shift& shift : kShifts) {
    const double px = -shift.own_px * scale;
    candidates.push_back({shift.code, with_pixels(other, {{1.0, 1.0}, {px, px}})});
  }
  if (scale == 1.0) return;
  // Whoever scales cx alone forgets that the centre of the first pixel is half a pixel from its corner.
  const double px = 0.5 * (1.0 - scale);
  candidates.push_back({Code::kScaledWithoutHalfPixel, with_pixels(other, {{1.0, 1.0}, {px, px}})});
}

void add_exchanged_centre(const CameraModel& other, Candidates& candidates) {
  const Pixel centre = principal_point(other);
  const double difference = centre[1] - centre[0];
  if (difference == 0.0) return;
  candidates.push_back({Code::kCentreSwapped, with_pixels(other, {{1.0, 1.0}, {difference, -difference}})});
}

/// Programs that count from the middle of the image do so to the right and down, or up.
void add_mirrored_centre(const Camera& other, Candidates& candidates) {
  if (!other.image_size) return;
  const Pixel centre = principal_point(other.model);
  const double right = other.image_size->width - 1.0 - 2.0 * centre[0];
  const double down = other.image_size->height - 1.0 - 2.0 * centre[1];
  for (const double px : {0.0, 1.0}) {  // whoever takes it from the height is one pixel from the mirror
    candidates.push_back({Code::kCentreMirrored, with_pixels(other.model, {{1.0, 1.0}, {right + px, 0.0}}), {"cx"}});
    candidates.push_back({Code::kCentreMirrored, with_pixels(other.model, {{1.0, 1.0}, {0.0, down + px}}), {"cy"}});
  }
}

void add_scales(const CameraModel& other, double scale, Candidates& candidates) {
  const auto scaled_by = [&other](double factor) {
    const double shift = 0.5 * (factor - 1.0);
    return with_pixels(other, {{factor, factor}, {shift, shift}});
  };
  candidates.push_back({Code::kOfImagesTwiceThatSize, scaled_by(0.5)});
  candidates.push_back({Code::kOfImagesHalfThatSize, scaled_by(2.0)});
  if (scale != 1.0) candidates.push_back({Code::kOfImagesOfTheReference, scaled_by(1.0 / scale)});
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
    Code code;
    const char* first;   ///< A parameter, or the order in which they stand.
    const char* second;  ///< A parameter, or the names under which they stand.
  };
  static const std::vector<Order> kOrders = {
      {{"xi", "alpha"}, Code::kParametersExchanged, "xi", "alpha"},
      {{"alpha", "beta"}, Code::kParametersExchanged, "alpha", "beta"},
      {{"fx", "fy"}, Code::kParametersExchanged, "fx", "fy"},
      {{"p1", "p2"}, Code::kParametersExchanged, "p1", "p2"},
      {{"p1", "k3", "p2"}, Code::kCoefficientsInOrder, "k1 k2 k3 p1 p2", "k1 k2 p1 p2 k3"},
      {{"p1", "p2", "k3"}, Code::kCoefficientsInOrder, "k1 k2 p1 p2 k3", "k1 k2 k3 p1 p2"},
  };
  for (const Order& order : kOrders) {
    const std::optional<CameraModel> undone = cycled(other, order.cycle);
    if (undone && *undone != other) candidates.push_back({order.code, *undone, {order.first, order.second}});
  }
}

constexpr std::size_t kBeforeLens = 4;  // fx fy cx cy

bool has(const ModelInfo& model, std::string_view parameter) {
  return std::ranges::find(model.parameters, parameter, &Parameter::name) != model.parameters.end();
}

/// Where a model's numbers of the lens stand, with or without the mirror parameter of an omnidirectional camera, which files
/// keep elsewhere.
std::vector<std::size_t> places_of_lens(const ModelInfo& model, bool with_mirror) {
  const bool leaves_out = !with_mirror && has(model, "xi") && has(model, "k1");
  std::vector<std::size_t> places;
  for (std::size_t i = kBeforeLens; i < model.parameters.size(); ++i) {
    if (!leaves_out || model.parameters[i].name != "xi") places.push_back(i);
  }
  return places;
}

/// The other's numbers, in their order, as the reference's model has them.
void add_other_name(const CameraModel& reference, const CameraModel& other, Candidates& candidates) {
  const ModelInfo& right = model_info(reference);
  const ModelInfo& wrong = model_info(other);
  if (right.id == wrong.id || !right.focal_lengths_first || !wrong.focal_lengths_first) return;
  const std::span<const double> numbers = parameter_values(other);
  const auto add = [&](const std::vector<std::size_t>& from, const std::vector<std::size_t>& to) {
    const std::size_t count = std::min(from.size(), to.size());
    const auto is_zero = [&numbers](std::size_t place) { return numbers[place] == 0.0; };
    if (count == 0 || !std::ranges::all_of(std::span(from).subspan(count), is_zero)) return;
    CameraModel undone = reference;
    const std::span<double> values = parameter_values(undone);
    std::copy_n(numbers.begin(), kBeforeLens, values.begin());
    for (std::size_t i = 0; i < to.size(); ++i) values[to[i]] = i < count ? numbers[from[i]] : 0.0;
    candidates.push_back({Code::kUnderAnotherName, undone, {right.id, wrong.id}});
  };
  for (const bool with_mirror : {true, false}) {
    const std::vector<std::size_t> from = places_of_lens(wrong, with_mirror);
    std::vector<std::size_t> to = places_of_lens(right, with_mirror);
    add(from, to);
    // Double Sphere's two are xi alpha in most files, and alpha xi in some.
    if (with_mirror && to.size() == 2) add(from, {to[1], to[0]});
    if (with_mirror && from.size() == 2 && to.size() > 2) add({from[1], from[0]}, to);
  }
}

/// The lens of the reference, where the other has none.
void add_removed(const CameraModel& reference, const CameraModel& other, Candidates& candidates) {
  const ModelInfo& right = model_info(reference);
  const ModelInfo& wrong = model_info(other);
  if (!right.focal_lengths_first || !wrong.focal_lengths_first) return;
  const std::span<const double> numbers = parameter_values(other);
  if (std::ranges::any_of(numbers.subspan(kBeforeLens), [](double number) { return number != 0.0; })) return;
  CameraModel undone = reference;
  std::copy_n(numbers.begin(), kBeforeLens, parameter_values(undone).begin());
  candidates.push_back({Code::kDistortionRemoved, undone});
}

}  // namespace

std::optional<Mistake> mistake_in(const Camera& reference, const Camera& other, double scale,
                                  const CameraDifference& difference, const FieldOfView& field_of_view) {
  constexpr double kNoArea = 1e-3;
  if (difference.statistics.error.max <= kSamePx && difference.statistics.coverage.unrepresentable <= kNoArea)
    return std::nullopt;
  Candidates candidates;
  add_shifts(other.model, scale, candidates);
  add_exchanged_centre(other.model, candidates);
  add_mirrored_centre(other, candidates);
  add_scales(other.model, scale, candidates);
  add_other_orders(other.model, candidates);
  add_other_name(reference.model, other.model, candidates);
  add_removed(reference.model, other.model, candidates);

  // A guess must come as near as two honest calibrations of one camera rarely do.
  constexpr double kNear = 1.0;
  double best = std::min(kNear, kExplained * misfit_px(reference.model, other.model, field_of_view));
  std::optional<Mistake> mistake;
  for (const Candidate& candidate : candidates) {
    if (!validate(candidate.undone).empty()) continue;
    const double misfit = misfit_px(reference.model, candidate.undone, field_of_view);
    if (!(misfit <= best)) continue;
    best = misfit;
    mistake = Mistake{Message{candidate.code, {other.name}}};
    mistake->message.arguments.insert(mistake->message.arguments.end(), candidate.more.begin(), candidate.more.end());
  }
  return mistake;
}

}  // namespace fca::internal
