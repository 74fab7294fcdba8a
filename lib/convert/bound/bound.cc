// SPDX-License-Identifier: BSD-3-Clause
// The search for an error bound. README.md has the derivation.
#include "bound.h"

#include "field.h"
#include "polar.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace fca::internal {

namespace {

/// A cell is not divided further if its bound is at most kGoodEnoughRatio times the largest known error, or if it exceeds this
/// error by at most kNegligiblePx.
constexpr double kGoodEnoughRatio = 1.01;
constexpr double kNegligiblePx = 2e-10;
/// A strip is narrow enough if the remainder of its polynomials is at most this fraction of the largest known error, or at most
/// kNegligibleRemainderPx.
constexpr double kRemainderShare = 0.005;
constexpr double kNegligibleRemainderPx = 5e-11;

using Vector = std::array<double, 2>;

/// The length of the vector (x, y). It is faster than std::hypot, and correct for numbers that are infinite or far from
/// overflow. Its rounding error is smaller than the amounts that are added to all bounds below.
double length(double x, double y) { return std::sqrt(x * x + y * y); }

/// A range of angles from the axis, centre +- half [rad], on which polynomials replace both models.
template <std::size_t N>
struct Strip {
  double centre = 0.0;
  double half = 0.0;
  Field<N> source;              ///< The source's pixel.
  Field<N> error;               ///< The target's pixel minus the source's.
  double series_rest_px = 0.0;  ///< The part of the error's remainder that does not shrink when the strip is divided.
  /// An upper bound of the distance of the error vector from its polynomials [px].
  [[nodiscard]] double remainder() const { return length(error.remainder[0], error.remainder[1]); }
  /// True if all remainders are finite.
  [[nodiscard]] bool finite() const {
    return std::isfinite(remainder()) && std::isfinite(source.remainder[0]) && std::isfinite(source.remainder[1]);
  }
};

/// A rectangle of rays: angles t +- dt [rad], relative to the strip's centre, and azimuths phi +- dphi [rad].
struct Cell {
  std::size_t strip = 0;  ///< The index of the strip that contains the cell.
  double t = 0.0;
  double dt = 0.0;
  double phi = 0.0;
  double dphi = 0.0;
  double bound = 0.0;        ///< An upper bound of the error in the cell [px].
  bool split_angle = false;  ///< The cell is to be divided along the angle; otherwise along the azimuth.
};

/// The harmonics of the azimuth and their first derivatives at a cell's centre, and their largest absolute values in the cell.
template <std::size_t N>
struct Harmonics {
  std::array<double, N> value;
  std::array<double, N> first;
  std::array<double, N> value_max;
  std::array<double, N> first_max;

  Harmonics(double phi, double dphi) {
    const double c = std::cos(phi);
    const double s = std::sin(phi);
    const double c2 = c * c - s * s;
    const double s2 = 2.0 * s * c;
    std::ranges::copy(std::array{1.0, c, s, c2, s2}, value.begin());
    std::ranges::copy(std::array{0.0, -s, c, -4.0 * s * c, 2.0 * c2}, first.begin());
    for (std::size_t j = kHarmonics; j < N; j += 2) {
      const auto n = static_cast<double>(frequency_of(j));
      value[j] = std::cos(n * phi);
      value[j + 1] = std::sin(n * phi);
      first[j] = -n * value[j + 1];
      first[j + 1] = n * value[j];
    }
    for (std::size_t j = 0; j < N; ++j) {
      const auto n = static_cast<double>(frequency_of(j));
      value_max[j] = std::min(1.0, std::abs(value[j]) + n * dphi);
      first_max[j] = std::min(n, std::abs(first[j]) + n * n * dphi);
    }
  }
};

/// The tangent plane of a field at a cell's centre, and bounds of the distance of the field from this plane in the cell. Both
/// components of a pixel.
struct Plane {
  Vector value{};       ///< The value at the centre [px].
  Vector by_angle{};    ///< The derivative with respect to the angle [px/rad].
  Vector by_azimuth{};  ///< The derivative with respect to the azimuth [px/rad].
  Vector rest{};        ///< The bound of the distance from the plane [px].
  Vector angle_rest{};  ///< The part of `rest` that depends only on dt: the second-order term of the angle.

  /// An upper bound, in the cell, of the length of the pixel's derivative with respect to the angle [px/rad].
  [[nodiscard]] double steepest(double dt) const {
    return length(std::abs(by_angle[0]) + 2.0 * angle_rest[0] / dt, std::abs(by_angle[1]) + 2.0 * angle_rest[1] / dt);
  }
};

/// The values and derivatives of a field's polynomials at an angle t, and their bounds on t +- dt. Cells with the same range of
/// angles share them.
template <std::size_t N>
struct Radial {
  using PerHarmonic = std::array<std::array<double, N>, 2>;
  PerHarmonic value{};
  PerHarmonic first{};
  // Bounds of the absolute values on t +- dt:
  PerHarmonic value_max{};
  PerHarmonic first_max{};
  PerHarmonic second_max{};

  Radial(const Field<N>& field, double t, double dt) {
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < N; ++j) {
        const Polynomial& c = field.of[i][j];
        double half_second = 0.0;
        for (std::size_t k = field.terms[i][j]; k-- > 0;) {
          half_second = half_second * t + first[i][j];
          first[i][j] = first[i][j] * t + value[i][j];
          value[i][j] = value[i][j] * t + c[k];
        }
        second_max[i][j] = 2.0 * std::abs(half_second) + field.third[i][j] * dt;
        first_max[i][j] = std::abs(first[i][j]) + second_max[i][j] * dt;
        value_max[i][j] = std::abs(value[i][j]) + first_max[i][j] * dt;
      }
    }
  }
};

/// The tangent plane of a field in a cell. `radial`, `harmonics`: those of the cell's angles and azimuths.
template <std::size_t N>
Plane plane_of(const Field<N>& field, const Radial<N>& radial, const Cell& cell, const Harmonics<N>& harmonics) {
  Plane plane;
  const double dt = cell.dt;
  const double dphi = cell.dphi;
  for (std::size_t i = 0; i < 2; ++i) {
    double angle_rest = 0.0;
    double azimuth_rest = 0.0;
    double mixed_rest = 0.0;
    for (std::size_t j = 0; j < N; ++j) {
      if (field.terms[i][j] == 0) continue;
      const auto n = static_cast<double>(frequency_of(j));
      plane.value[i] += radial.value[i][j] * harmonics.value[j];
      plane.by_angle[i] += radial.first[i][j] * harmonics.value[j];
      plane.by_azimuth[i] += radial.value[i][j] * harmonics.first[j];
      angle_rest += radial.second_max[i][j] * harmonics.value_max[j];
      mixed_rest += radial.first_max[i][j] * harmonics.first_max[j];
      azimuth_rest += n * n * radial.value_max[i][j] * harmonics.value_max[j];
    }
    plane.angle_rest[i] = 0.5 * angle_rest * dt * dt;
    plane.rest[i] = plane.angle_rest[i] + mixed_rest * dt * dphi + 0.5 * azimuth_rest * dphi * dphi + field.remainder[i];
  }
  return plane;
}

/// The values of the polynomials of both fields of a strip.
template <std::size_t N>
struct RadialPair {
  Radial<N> source;
  Radial<N> error;
  RadialPair(const Strip<N>& strip, double t, double dt) : source(strip.source, t, dt), error(strip.error, t, dt) {}
};

/// Copies a form into a form with more harmonics. The additional harmonics are 0.
template <std::size_t N>
PolarSeriesOf<N> widened(const PolarSeries& form) {
  PolarSeriesOf<N> wide;
  for (std::size_t i = 0; i < 2; ++i) {
    std::ranges::copy(form.of[i], wide.of[i].begin());
    std::ranges::copy(form.used[i], wide.used[i].begin());
  }
  return wide;
}

/// Searches for the bound by dividing cells, with polar forms of N harmonics.
template <std::size_t N>
class Bounder {
  using Form = PolarSeriesOf<N>;
  using Harmonics = internal::Harmonics<N>;
  using Strip = internal::Strip<N>;
  using RadialPair = internal::RadialPair<N>;

 public:
  Bounder(const CameraModel& source, const CameraModel& target, const FieldOfView& field_of_view, double max_angle_rad,
          double seen, int budget)
      : source_(source),
        target_(target),
        last_{field_of_view.size.width - 1.0, field_of_view.size.height - 1.0},
        max_angle_(std::min(
            std::numbers::pi,
            std::min({field_of_view.max_angle_rad, max_angle_rad, max_angle(source), max_angle(target)}) + kAngleSlack)),
        circle_(field_of_view.circle),
        budget_(budget) {
    result_.seen = seen;
    for (int i = 0; i < kAzimuths; ++i) {
      const double phi = std::numbers::pi * (2 * i + 1) / kAzimuths;
      first_cells_.push_back({phi, Harmonics(phi, kFirstWidth)});
    }
  }

  /// Makes the search and returns its result.
  ErrorBound bound() {
    add_strips();
    while (!is_unbounded_ && !cells_.empty() && !(cells_.front().bound <= good_enough()) && result_.evaluations < budget_) {
      std::ranges::pop_heap(cells_, {}, &Cell::bound);
      const Cell cell = cells_.back();
      cells_.pop_back();
      split(cell);
    }
    result_.bound = cells_.empty() ? done_ : std::max(done_, cells_.front().bound);
    if (is_unbounded_) result_.bound = std::numeric_limits<double>::infinity();
    return result_;
  }

 private:
  /// An upper bound [rad] of the rounding error of max_angle(), which for some models is an arc cosine near 180 degrees.
  static constexpr double kAngleSlack = 4e-8;
  // Widths of strips [rad].
  static constexpr double kFirstStrip = 0.12;
  static constexpr double kWidestStrip = 0.25;
  static constexpr double kNarrowestStrip = 3e-5;
  static constexpr int kAzimuths = 8;  ///< The number of cells into which every strip is divided at first.
  /// Half of the range of azimuths of these cells [rad], enlarged so that rounding leaves no gaps between them.
  static constexpr double kFirstWidth = std::numbers::pi / kAzimuths * (1.0 + 4.0 * kRoundOff);
  /// The largest distance from the image of the pixel of a ray that unproject() returns for a pixel on the border, by rounding.
  static constexpr double kBorderSlack = 1e-6;  // px
  /// An upper bound of the rounding error of a ray's direction. Near a fold of ocamcalib, the image radius changes fast with
  /// the angle, so that the pixel of a rounded ray may be 1e-7 px from the original pixel in the same camera.
  static constexpr double kRayRounding = 32.0 * kRoundOff;  // rad

  /// A cell with at most this bound [px] is not divided further.
  [[nodiscard]] double good_enough() const { return std::max(kGoodEnoughRatio * result_.seen, result_.seen + kNegligiblePx); }

  /// Divides the range of angles into strips that are narrow enough for the polynomials. Adds the cells of each strip. The
  /// accuracy of each strip determines the width of the next one.
  void add_strips() {
    double width = kFirstStrip;
    for (double from = 0.0; from < max_angle_ && !is_unbounded_;) {
      const double left = max_angle_ - from;
      const bool is_over_budget = result_.evaluations >= budget_;
      const double parts = is_over_budget ? 1.0 : std::ceil(left / width);
      const double to = parts > 1.0 ? from + left / parts : max_angle_;
      const Strip strip = make_strip(0.5 * (from + to), 0.5 * (to - from));
      result_.evaluations += kStripCost;
      const double fitting = fitting_share(strip);
      width = std::clamp(fitting * (to - from), kNarrowestStrip, kWidestStrip);
      if (fitting < 1.0 && to - from > kNarrowestStrip && !is_over_budget) continue;
      add_cells(strip);
      from = to;
    }
  }

  /// Adds the first cells of a strip: all its angles, and a part of the azimuths each.
  void add_cells(const Strip& strip) {
    strips_.push_back(strip);
    Cell cell;
    cell.strip = strips_.size() - 1;
    cell.dt = strip.half;
    cell.dphi = kFirstWidth;
    const RadialPair radial(strip, cell.t, cell.dt);
    for (const FirstCell& first : first_cells_) {
      cell.phi = first.phi;
      add(cell, radial, first.harmonics);
    }
  }
  /// The number of cells whose evaluation takes as long as that of a strip.
  static constexpr int kStripCost = 50;

  /// The largest factor by which the strip's width may change so that its truncation error still meets the limit. Less than 1
  /// if the strip is too wide. The truncation error is proportional to the power kOrder of the width.
  [[nodiscard]] double fitting_share(const Strip& strip) const {
    // If source and target are equal, only the rounding of rays causes errors. They depend on the derivatives of the source,
    // for which rough polynomials are enough.
    constexpr double kRoughPx = 1e-3;
    const bool same = source_ == target_;
    const double truncation = same ? strip.source.truncation : strip.error.truncation;
    const double allowed = same ? kRoughPx : std::max(kNegligibleRemainderPx, kRemainderShare * result_.seen);
    constexpr double kSmallestFactor = 0.25;
    constexpr double kLargestFactor = 2.0;
    constexpr double kSafety = 0.9;
    const double share = kSafety * std::pow(allowed / truncation, 1.0 / static_cast<double>(kOrder));
    if (!(truncation <= allowed)) return share > kSmallestFactor && share < kSafety ? share : kSmallestFactor;
    return std::clamp(share, 1.0, kLargestFactor);
  }

  /// Computes the fields of a strip, centre +- half [rad].
  [[nodiscard]] Strip make_strip(double centre, double half) const {
    const AngleSeries at_centre = angle_series({centre, 0.0});
    const AngleSeries over_strip = angle_series({centre, half * (1.0 + 4.0 * kRoundOff) + kUnderflow});
    Strip strip;
    strip.centre = centre;
    strip.half = half;
    const Form source_centre = form_of(source_, at_centre);
    const Form source_strip = form_of(source_, over_strip);
    strip.source = field_of(source_centre, source_strip, half);
    if (source_ == target_) return strip;  // the error is 0 except for the rounding of rays
    const Form error_strip = difference(form_of(target_, over_strip), source_strip);
    strip.error = field_of(difference(form_of(target_, at_centre), source_centre), error_strip, half);
    strip.series_rest_px = length(error_strip.series_rest_px[0], error_strip.series_rest_px[1]);
    return strip;
  }

  /// The polar form of a model for a series of angles.
  [[nodiscard]] static Form form_of(const CameraModel& model, const AngleSeries& angle) {
    return std::visit(
        [&]<class M>(const Intrinsics<M>& m) -> Form {
          const double* p = m.values.data();
          if constexpr (requires(Form form) { M::polar_form(p, angle, form); }) {
            if (N == kHarmonics || is_tilted(m)) {
              Form form;
              M::polar_form(p, angle, form);
              return form;
            }
          }
          PolarSeries form;
          M::polar_form(p, angle, form);
          return widened<N>(form);
        },
        model);
  }

  /// The form a - b.
  [[nodiscard]] static Form difference(const Form& a, const Form& b) {
    Form result = a;
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < N; ++j) {
        if (b.used[i][j]) result.set(i, j, result.of[i][j] - b.of[i][j]);
      }
      result.series_rest_px[i] += b.series_rest_px[i];
    }
    return result;
  }

  /// Divides a cell into two halves, and adds these.
  void split(const Cell& cell) {
    Cell half = cell;
    (cell.split_angle ? half.dt : half.dphi) *= 0.5;
    // A cell that is already too small to divide keeps its bound.
    if (!(half.dt > 1e-14) || !(half.dphi > 1e-14)) {
      done_ = std::max(done_, cell.bound);
      return;
    }
    const Strip& strip = strips_[cell.strip];
    if (cell.split_angle) {
      const Harmonics harmonics(cell.phi, cell.dphi);
      for (const double side : {-1.0, 1.0}) {
        half.t = cell.t + side * half.dt;
        add(half, RadialPair(strip, half.t, half.dt), harmonics);
      }
    } else {
      const RadialPair radial(strip, cell.t, cell.dt);
      for (const double side : {-1.0, 1.0}) {
        half.phi = cell.phi + side * half.dphi;
        add(half, radial, Harmonics(half.phi, half.dphi));
      }
    }
  }

  /// Computes the bound of a cell. Adds the cell to those to be divided, unless it lies outside the image or the circle, or its
  /// bound is good enough.
  void add(Cell cell, const RadialPair& radial, const Harmonics& harmonics) {
    ++result_.evaluations;
    const Strip& strip = strips_[cell.strip];
    const Plane source = plane_of(strip.source, radial.source, cell, harmonics);
    // Drops the cell if none of its pixels lies in the image or in the circle.
    bool centre_inside = true;
    Vector spreads{};
    for (std::size_t i = 0; i < 2; ++i) {
      const double spread =
          std::abs(source.by_angle[i]) * cell.dt + std::abs(source.by_azimuth[i]) * cell.dphi + source.rest[i];
      if (source.value[i] + spread < -kBorderSlack || source.value[i] - spread > last_[i] + kBorderSlack) return;
      centre_inside = centre_inside && source.value[i] >= 0.0 && source.value[i] <= last_[i];
      spreads[i] = spread;
    }
    if (circle_) {
      const double beyond = circle_->beyond(source.value);
      if (beyond > length(spreads[0], spreads[1]) + kBorderSlack) return;
      centre_inside = centre_inside && beyond <= 0.0;
    }
    const Plane error = plane_of(strip.error, radial.error, cell, harmonics);
    // The largest squared error on the tangent plane, which is at one of the four corners of the cell.
    double corner = 0.0;
    for (const double side : {-1.0, 1.0}) {
      double square = 0.0;
      double other = 0.0;
      for (std::size_t i = 0; i < 2; ++i) {
        const double a = error.by_angle[i] * cell.dt;
        const double b = side * error.by_azimuth[i] * cell.dphi;
        square += (error.value[i] + a + b) * (error.value[i] + a + b);
        other += (error.value[i] - a - b) * (error.value[i] - a - b);
      }
      corner = std::max({corner, square, other});
    }
    const double rounding = kRayRounding * (source.steepest(cell.dt) + error.steepest(cell.dt));
    cell.bound = (std::sqrt(corner) + length(error.rest[0], error.rest[1]) + rounding) * (1.0 + 1e-12);
    // With a NaN bound, nothing is known about the error.
    if (!std::isfinite(cell.bound)) cell.bound = std::numeric_limits<double>::infinity();
    if (centre_inside) {
      // A part of this cell lies in the image, however finely it is divided. If the strip's remainder is infinite, so is the
      // bound of that part.
      is_unbounded_ = is_unbounded_ || !strip.finite();
      const double certain = length(error.value[0], error.value[1]) - strip.remainder();
      if (certain > result_.seen) {
        result_.seen = certain;
        result_.seen_at = source.value;
      }
    }
    // If most of the bound is the remainder of the strip, dividing the cell would not make it much smaller.
    constexpr double kMostlyRemainder = 1.5;
    if (cell.bound <= std::max(good_enough() + strip.series_rest_px, kMostlyRemainder * strip.remainder()) &&
        std::isfinite(cell.bound)) {
      done_ = std::max(done_, cell.bound);
      return;
    }
    // The cell is divided along the variable that contributes more to the bound.
    const double by_angle =
        length(error.by_angle[0], error.by_angle[1]) * cell.dt + 2.0 * length(error.angle_rest[0], error.angle_rest[1]);
    const double by_azimuth = length(error.by_azimuth[0], error.by_azimuth[1]) * cell.dphi +
                              2.0 * length(error.rest[0] - error.angle_rest[0], error.rest[1] - error.angle_rest[1]);
    cell.split_angle = std::isfinite(by_angle) && std::isfinite(by_azimuth) ? by_angle > by_azimuth : cell.dt > cell.dphi;
    cells_.push_back(cell);
    std::ranges::push_heap(cells_, {}, &Cell::bound);
  }

  const CameraModel& source_;
  const CameraModel& target_;
  Vector last_;       ///< The last pixel of the image, in its lower right corner.
  double max_angle_;  ///< The largest angle of a ray for which there may be an error [rad].
  std::optional<LensCircle> circle_;
  int budget_;
  /// The azimuths of one of the cells into which every strip is divided at first.
  struct FirstCell {
    double phi;
    Harmonics harmonics;
  };
  std::vector<FirstCell> first_cells_;
  std::vector<Strip> strips_;
  std::vector<Cell> cells_;    ///< The cells that may be divided: a heap with the largest bound first.
  double done_ = 0.0;          ///< The largest bound of the cells that are not divided further.
  bool is_unbounded_ = false;  ///< True if a strip with an infinite remainder reaches into the image: no bound exists.
  ErrorBound result_;
};

/// An upper bound of the rounding errors of unproject() and project() [px], which every computed error contains.
double rounding_of(const CameraModel& source, const CameraModel& target, const ImageSize& size) {
  constexpr double kRelative = 1e-13;  // the accuracy of radtan's inverse
  double pixels = static_cast<double>(size.width) + size.height;
  for (const CameraModel* model : {&source, &target}) {
    for (const double value : central_focal_lengths(*model)) pixels += std::abs(value);
    for (const double value : principal_point(*model)) pixels += 0.5 * std::abs(value);
  }
  return kRelative * pixels;
}

}  // namespace

ErrorBound bound_error(const CameraModel& source, const CameraModel& target, const FieldOfView& field_of_view,
                       double target_max_angle_rad, double seen, int budget) {
  const bool bounded = std::visit(
      []<class S, class T>(const Intrinsics<S>&, const Intrinsics<T>&) { return HasPolarForm<S> && HasPolarForm<T>; }, source,
      target);
  if (!bounded) return {};
  const auto has_tilt = [](const auto& model) { return is_tilted(model); };
  const bool tilted = std::visit(has_tilt, source) || std::visit(has_tilt, target);
  ErrorBound result = tilted
                          ? Bounder<kTiltedHarmonics>(source, target, field_of_view, target_max_angle_rad, seen, budget).bound()
                          : Bounder<kHarmonics>(source, target, field_of_view, target_max_angle_rad, seen, budget).bound();
  result.bound += rounding_of(source, target, field_of_view.size);
  return result;
}

}  // namespace fca::internal
