// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/camera_model.h>

#include <fca/code.h>
#include <fca/normalised_id.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fca {

namespace {

template <CameraModelType M>
constexpr ModelInfo info_of() {
  ModelInfo info = {M::kId, M::kTitle, M::kAliases, M::kParameters, std::is_base_of_v<internal::FocalLengthsFirst, M>};
  if constexpr (requires { M::kHigherTerms; }) {
    info.least_degree = M::kLeastDegree;
    info.most_degree = M::kLeastDegree + static_cast<int>(M::kHigherTerms.size());
  }
  if constexpr (requires { M::kKeptOnly; }) info.kept_only = M::kKeptOnly;
  return info;
}

template <CameraModelType... Ms>
constexpr auto info_table(internal::TypeList<Ms...> /*models*/) {
  return std::array{info_of<Ms>()...};
}

constexpr auto kModels = info_table(ModelList{});

/// "lie in [0, 1]", "be greater than -1", ...
Message range_of(const Parameter& p) {
  if (!std::isfinite(p.lower)) return {p.open ? Code::kBeLessThan : Code::kBeAtMost, {p.upper}};
  if (std::isfinite(p.upper)) return {p.open ? Code::kLieBetween : Code::kLieWithin, {p.lower, p.upper}};
  return {p.open ? Code::kBeGreaterThan : Code::kBeAtLeast, {p.lower}};
}

bool is_finite(const Ray& ray) { return std::isfinite(ray[0]) && std::isfinite(ray[1]) && std::isfinite(ray[2]); }

/// Scaled to a length near 1 (by a power of two, so exactly) if its square would over- or underflow.
Ray of_usable_length(const Ray& ray) {
  const double largest = std::max({std::abs(ray[0]), std::abs(ray[1]), std::abs(ray[2])});
  constexpr double kSmallest = 1e-60;
  constexpr double kLargest = 1e60;
  if (!(largest > 0.0) || (largest > kSmallest && largest < kLargest)) return ray;
  const int exponent = std::ilogb(largest);
  return {std::scalbn(ray[0], -exponent), std::scalbn(ray[1], -exponent), std::scalbn(ray[2], -exponent)};
}

}  // namespace

std::span<const ModelInfo> all_models() { return kModels; }

const ModelInfo* find_model(std::string_view name) {
  const std::string word = normalised_id(name);
  const auto matches = [&word](const ModelInfo& info) {
    return normalised_id(info.id) == word ||
           std::ranges::any_of(info.aliases, [&word](std::string_view alias) { return normalised_id(alias) == word; });
  };
  const auto* const found = std::ranges::find_if(kModels, matches);
  return found == kModels.end() ? nullptr : found;
}

std::optional<ParameterId> ParameterId::find(std::string_view name) {
  const std::string_view found = internal::name_among(name, ModelList{});
  if (found.empty()) return std::nullopt;
  return ParameterId(found);
}

std::optional<CameraModel> make_model(std::string_view id) {
  std::optional<CameraModel> result;
  ModelList::for_each([&]<CameraModelType M>() {
    if (M::kId == id) result = Intrinsics<M>{};
  });
  return result;
}

const ModelInfo& model_info(const CameraModel& model) { return kModels[model.index()]; }

std::span<const double> parameter_values(const CameraModel& model) {
  return std::visit([](const auto& m) { return std::span<const double>(m.values); }, model);
}

std::span<double> parameter_values(CameraModel& model) {
  return std::visit([](auto& m) { return std::span<double>(m.values); }, model);
}

namespace {

std::optional<std::size_t> index_of(const CameraModel& model, ParameterId id) {
  const std::span<const Parameter> parameters = model_info(model).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].name == id.name()) return i;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> parameter(const CameraModel& model, ParameterId id) {
  const std::optional<std::size_t> index = index_of(model, id);
  if (!index) return std::nullopt;
  return parameter_values(model)[*index];
}

bool set_parameter(CameraModel& model, ParameterId id, double value) {
  const std::optional<std::size_t> index = index_of(model, id);
  if (!index) return false;
  parameter_values(model)[*index] = value;
  return true;
}

namespace {

template <CameraModelType M>
std::optional<Pixel> projected(const Intrinsics<M>& model, const Ray& ray) {
  if (!is_finite(ray)) return std::nullopt;
  const Ray usable = of_usable_length(ray);
  Pixel pixel{};
  if (!M::project(model.values.data(), usable.data(), pixel.data())) return std::nullopt;
  if (!std::isfinite(pixel[0]) || !std::isfinite(pixel[1])) return std::nullopt;
  return pixel;
}

template <CameraModelType M>
std::optional<Ray> unprojected(const Intrinsics<M>& model, const Pixel& pixel) {
  Ray ray{};
  if (!M::unproject(model.values.data(), pixel.data(), ray.data())) return std::nullopt;
  return ray;
}

}  // namespace

std::optional<Pixel> project(const CameraModel& model, const Ray& ray) {
  return std::visit([&ray](const auto& m) { return projected(m, ray); }, model);
}

std::optional<Ray> unproject(const CameraModel& model, const Pixel& pixel) {
  return std::visit([&pixel](const auto& m) { return unprojected(m, pixel); }, model);
}

double max_angle(const CameraModel& model) {
  return std::visit([]<class M>(const Intrinsics<M>& m) { return M::max_angle(m.values.data()); }, model);
}

Pixel principal_point(const CameraModel& model) {
  return std::visit([]<class M>(const Intrinsics<M>& m) { return M::principal_point(m.values.data()); }, model);
}

std::array<double, 2> central_focal_lengths(const CameraModel& model) {
  return std::visit([]<class M>(const Intrinsics<M>& m) { return M::central_focal_lengths(m.values.data()); }, model);
}

SkewedModel without_skew(const CameraModel& model) {
  return std::visit(
      []<class M>(const Intrinsics<M>& skewed) -> SkewedModel {
        if constexpr (kIsSkewed<M>) {
          return {Intrinsics<typename M::Straight>{M::straight(skewed.values)}, skewed.values[M::kSkew]};
        } else {
          return {skewed};
        }
      },
      model);
}

std::optional<CameraModel> with_skew(const CameraModel& model, double skew_px) {
  if (const auto* pinhole = std::get_if<Intrinsics<Pinhole>>(&model)) {
    const auto& [fx, fy, cx, cy] = pinhole->values;
    return with_skew(Intrinsics<Radtan>{{fx, fy, cx, cy}}, skew_px);
  }
  std::optional<CameraModel> result;
  ModelList::for_each([&]<class M>() {
    if constexpr (kIsSkewed<M>) {
      const auto* straight = std::get_if<Intrinsics<typename M::Straight>>(&model);
      if (straight == nullptr) return;
      Intrinsics<M> skewed;
      std::ranges::copy(straight->values, skewed.values.begin());
      skewed.values[M::kSkew] = skew_px;
      result = skewed;
    }
  });
  return result;
}

std::string_view straight_id(const CameraModel& model) { return model_info(without_skew(model).straight).id; }

Message problem_with(const Parameter& parameter, double value) {
  const auto problem = [&](Code code) { return Message{code, {parameter.name, value}}; };
  if (!std::isfinite(value)) return problem(Code::kParameterNotFinite);
  if (std::abs(value) > kLargestParameter) return problem(Code::kParameterTooLarge);
  const bool positive = parameter.group == ParameterGroup::kFocalLength && parameter.lower == 0.0;
  if (positive && !(value > 0.0)) return problem(Code::kFocalLengthNotPositive);
  constexpr double kSmallestFocalLength = 1e-6;  // px: less comes out as 0 where it is multiplied
  if (positive && value < kSmallestFocalLength) return problem(Code::kParameterTooSmall);
  const bool at_open_end = parameter.open && (value == parameter.lower || value == parameter.upper);
  if (value >= parameter.lower && value <= parameter.upper && !at_open_end) return {};
  return {Code::kParameterOutOfRange, {parameter.name, value, range_of(parameter)}};
}

std::vector<Message> validate(const CameraModel& model) {
  std::vector<Message> problems;
  const std::span<const Parameter> parameters = model_info(model).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    Message problem = problem_with(parameters[i], parameter_values(model)[i]);
    if (problem.is_said()) problems.push_back(std::move(problem));
  }
  return problems;
}

double angle_from_axis(const Ray& ray) { return std::atan2(std::hypot(ray[0], ray[1]), ray[2]); }

}  // namespace fca
