// SPDX-License-Identifier: BSD-3-Clause
// What a fit asks of a camera model, for any number of samples at a time: the fit itself is compiled once, for all models.
#pragma once

#include <fca/convert/parameter_range.h>
#include <fca/models/model_traits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace fca::internal {

/// A model with derivatives of its own (model_traits.h).
template <class M>
concept HasDerivatives = requires(const double* in, double* out) {
  { M::formula_and_derivatives(in, in, out, out, out) } -> std::same_as<bool>;
};

/// A model that is linear once fy / fx is given (model_traits.h).
template <class M>
concept HasTerms = requires(const double* in, const std::array<double, 2>& point, double* out) {
  { M::kTerms } -> std::convertible_to<std::size_t>;
  { M::terms(in, out, out) } -> std::same_as<bool>;
  { M::from_terms(in, double{}, point, out) } -> std::same_as<void>;
};

/// One that is linear once fy / fx and its shape are given (model_traits.h).
template <class M>
concept HasShapedTerms = requires(const double* in, const std::array<double, 2>& point, double* out) {
  { M::kTerms } -> std::convertible_to<std::size_t>;
  {std::span<const double>(M::kShapes)};
  { M::terms(double{}, in, out, out) } -> std::same_as<bool>;
  { M::from_terms(double{}, in, double{}, point, out) } -> std::same_as<void>;
};

/// As many as any model may have.
inline constexpr std::size_t kMostParameters = 19;
inline constexpr std::size_t kMostTerms = 6;

/// A model's parameters; 0 after its own.
using ParameterValues = std::array<double, kMostParameters>;

/// Numbers that are 0 outside [begin, end).
struct Column {
  const double* data = nullptr;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Residuals in pixels and their derivatives by each parameter, all times the root of the sample's weight. A column holds the
/// numbers of u for all samples, then those of v; the residuals are the last column, after one per parameter.
struct JacobianColumns {
  std::span<const double> roots;  ///< Of the samples' weights.
  double* numbers = nullptr;

  [[nodiscard]] std::size_t rows() const { return 2 * roots.size(); }
  [[nodiscard]] double* column(std::size_t i) const { return numbers + i * rows(); }
  void set(std::size_t sample, std::span<const double> du, std::span<const double> dv, double u, double v) const {
    const double root = roots[sample];
    const std::size_t below = roots.size() + sample;
    for (std::size_t i = 0; i < du.size(); ++i) {
      column(i)[sample] = root * du[i];
      column(i)[below] = root * dv[i];
    }
    column(du.size())[sample] = root * u;
    column(du.size())[below] = root * v;
  }
};

/// A camera model as a fit sees it. Parameters are `parameters().size()` numbers everywhere.
class FitTarget {
 public:
  virtual ~FitTarget() = default;

  [[nodiscard]] virtual std::span<const Parameter> parameters() const = 0;
  /// Left at its start unless a range is given.
  [[nodiscard]] virtual bool held(std::size_t parameter) const = 0;
  /// A parameter along which there are two minima with nearly the same pixels.
  [[nodiscard]] virtual std::optional<std::size_t> folded() const = 0;
  /// Of the first four parameters u depends on 0 and 2, v on 1 and 3, and linearly: u = p[0] m_x + p[2], v = p[1] m_y + p[3],
  /// where m depends on the others alone.
  [[nodiscard]] virtual bool focal_lengths_first() const = 0;
  /// Next to an angle before the edge of its domain pixels may leave for infinity.
  [[nodiscard]] virtual bool has_poles() const = 0;
  /// Derivatives cost hardly more than pixels.
  [[nodiscard]] virtual bool cheap_derivatives() const = 0;
  [[nodiscard]] virtual double max_angle(const double* p) const = 0;

  [[nodiscard]] virtual int starts() const = 0;
  virtual void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int start, double* p) const = 0;

  /// The formula's pixel of each ray, NaN where there is none. True if all have one.
  virtual bool pixels(const double* p, std::span<const Correspondence> samples, std::array<double, 2>* out) const = 0;
  /// One ray's pixel within the domain.
  virtual bool project(const double* p, const double* ray, double* pixel) const = 0;
  /// False where a sample has no pixel.
  virtual bool compute_jacobian(const double* p, std::span<const Correspondence> samples, const JacobianColumns& out) const = 0;

  /// How many terms the model is linear in once fy / fx and its shape, if it has one, are given; 0: it is not.
  [[nodiscard]] virtual std::size_t terms() const = 0;
  /// Shapes to begin with; none: the model has no shape, and any number will do below.
  [[nodiscard]] virtual std::span<const double> shapes() const = 0;
  virtual bool terms(double shape, const double* ray, double* along_u, double* along_v) const = 0;
  virtual void from_terms(double shape, const double* c, double aspect, const std::array<double, 2>& point,
                          double* p) const = 0;
};

/// compute_jacobian() by central differences: for a model outside the list without derivatives.
bool jacobian_by_differences(const FitTarget& target, const double* p, std::span<const Correspondence> samples,
                             const JacobianColumns& out);

/// Any model of the concept.
template <CameraModelType M>
class FitTargetOf : public FitTarget {
 public:
  static constexpr std::size_t kCount = kParameterCount<M>;
  static_assert(kCount <= kMostParameters);

  [[nodiscard]] std::span<const Parameter> parameters() const override { return M::kParameters; }
  [[nodiscard]] bool held(std::size_t parameter) const override { return held_in_fits<M>(M::kParameters[parameter].name); }
  [[nodiscard]] std::optional<std::size_t> folded() const override {
    if constexpr (requires { M::kFolded; }) {
      return M::kFolded;
    } else {
      return std::nullopt;
    }
  }
  [[nodiscard]] bool has_poles() const override {
    if constexpr (requires { M::kHasPoles; }) return M::kHasPoles;
    return false;
  }
  [[nodiscard]] bool focal_lengths_first() const override { return std::is_base_of_v<FocalLengthsFirst, M>; }
  [[nodiscard]] bool cheap_derivatives() const override { return HasDerivatives<M>; }
  [[nodiscard]] double max_angle(const double* p) const override { return M::max_angle(p); }

  [[nodiscard]] int starts() const override { return M::kStarts; }
  void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int start, double* p) const override {
    M::initialise(samples, centre, start, p);
  }

  bool pixels(const double* p, std::span<const Correspondence> samples, std::array<double, 2>* out) const override {
    bool all = true;
    for (const Correspondence& s : samples) {
      std::array<double, 2>& pixel = *out++;
      if (M::formula(p, s.ray.data(), pixel.data()) && std::isfinite(pixel[0]) && std::isfinite(pixel[1])) continue;
      pixel.fill(std::numeric_limits<double>::quiet_NaN());
      all = false;
    }
    return all;
  }
  bool project(const double* p, const double* ray, double* pixel) const override { return M::project(p, ray, pixel); }
  bool compute_jacobian(const double* p, std::span<const Correspondence> samples, const JacobianColumns& out) const override {
    if constexpr (HasDerivatives<M>) {
      for (std::size_t k = 0; k < samples.size(); ++k) {
        const Correspondence& s = samples[k];
        std::array<double, 2> pixel = s.pixel;
        std::array<double, kCount> du;
        std::array<double, kCount> dv;
        if (!M::formula_and_derivatives(p, s.ray.data(), pixel.data(), du.data(), dv.data())) return false;
        out.set(k, du, dv, pixel[0] - s.pixel[0], pixel[1] - s.pixel[1]);
      }
      return true;
    } else {
      return jacobian_by_differences(*this, p, samples, out);
    }
  }

  [[nodiscard]] std::size_t terms() const override {
    if constexpr (HasTerms<M> || HasShapedTerms<M>) {
      static_assert(M::kTerms <= kMostTerms);
      return M::kTerms;
    } else {
      return 0;
    }
  }
  [[nodiscard]] std::span<const double> shapes() const override {
    if constexpr (HasShapedTerms<M>) {
      return M::kShapes;
    } else {
      return {};
    }
  }
  bool terms([[maybe_unused]] double shape, [[maybe_unused]] const double* ray, [[maybe_unused]] double* along_u,
             [[maybe_unused]] double* along_v) const override {
    if constexpr (HasShapedTerms<M>) {
      return M::terms(shape, ray, along_u, along_v);
    } else if constexpr (HasTerms<M>) {
      return M::terms(ray, along_u, along_v);
    } else {
      return false;
    }
  }
  void from_terms([[maybe_unused]] double shape, [[maybe_unused]] const double* c, [[maybe_unused]] double aspect,
                  [[maybe_unused]] const std::array<double, 2>& point, [[maybe_unused]] double* p) const override {
    if constexpr (HasShapedTerms<M>) {
      M::from_terms(shape, c, aspect, point, p);
    } else if constexpr (HasTerms<M>) {
      M::from_terms(c, aspect, point, p);
    }
  }
};

/// The share of a field of view's area that a model may miss and still counts as reaching all of it: its radius may turn back
/// within a hair of the edge, where samples of no weight lie.
inline constexpr double kVeryEdge = 1e-3;

/// What a fit found.
struct FoundFit {
  ParameterValues parameters{};
  double rms_px = 0.0;
  int iterations = 0;
  bool reaches_all = true;  ///< Every sample projects, but for the very edge.
  std::vector<std::string> at_bound;
};

/// Fits a model from its own starts, given the centre of the lens; nothing if none leads to a camera.
std::optional<FoundFit> fit_target(const FitTarget& target, std::span<const Correspondence> samples, const LensCentre& centre,
                                   std::span<const ParameterRange> ranges);

}  // namespace fca::internal
