// SPDX-License-Identifier: BSD-3-Clause
// The list of camera models, and one value type that holds any of them. A new model is one header and one line in ModelList.
#pragma once

#include <fca/message.h>
#include <fca/models/division.h>
#include <fca/models/ds.h>
#include <fca/models/eucm.h>
#include <fca/models/fisheye624.h>
#include <fca/models/fov.h>
#include <fca/models/ftheta.h>
#include <fca/models/kb4.h>
#include <fca/models/mei.h>
#include <fca/models/model_traits.h>
#include <fca/models/ocamcalib.h>
#include <fca/models/opencv14.h>
#include <fca/models/pinhole.h>
#include <fca/models/radtan.h>
#include <fca/models/rational.h>
#include <fca/models/skewed.h>
#include <fca/models/thin_prism_fisheye.h>
#include <fca/models/ucm.h>
#include <fca/models/woodscape.h>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fca {

/// A model with its parameters: a plain value.
template <CameraModelType M>
struct Intrinsics {
  using Model = M;
  std::array<double, kParameterCount<M>> values{};
  bool operator==(const Intrinsics&) const = default;
};

namespace internal {
template <CameraModelType... Ms>
struct TypeList {
  using Variant = std::variant<Intrinsics<Ms>...>;
  /// Calls f.template operator()<M>() for every model.
  template <class F>
  static void for_each(F&& f) {
    (f.template operator()<Ms>(), ...);
  }
};
}  // namespace internal

/// Every model fca knows, in the order in which they are listed to people.
using ModelList = internal::TypeList<Pinhole, Radtan, Rational, Kb4, Ucm, Eucm, Ds, Mei, Fov, Ocamcalib, Woodscape, Opencv14,
                                     Division, ThinPrismFisheye, Fisheye624, Ftheta, Skewed<Radtan>, Skewed<Rational>,
                                     Skewed<Opencv14>, Skewed<Kb4>, Skewed<Mei>>;

/// Any camera model with its parameters. Compares by value.
using CameraModel = ModelList::Variant;

namespace internal {

/// The name as the first model with such a parameter holds it; empty if none has one.
template <CameraModelType... Ms>
constexpr std::string_view name_among(std::string_view name, TypeList<Ms...> /*models*/) {
  std::string_view found;
  const auto look_in = [&](std::span<const Parameter> rows) {
    for (const Parameter& row : rows) {
      if (found.empty() && row.name == name) found = row.name;
    }
  };
  (look_in(Ms::kParameters), ...);
  return found;
}

template <class Models>
constexpr std::string_view checked_name(std::string_view name, Models models) {
  const std::string_view found = name_among(name, models);
  if (found.empty()) throw "no camera model has a parameter of this name";
  return found;
}

}  // namespace internal

/// The name of a parameter, checked when it is compiled: of a literal that no model of ModelList has there is none.
class ParameterId {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): parameter(model, "fx")
  consteval ParameterId(const char* name) : ParameterId(internal::checked_name(name, ModelList{})) {}
  /// A row of a model's table.
  constexpr explicit ParameterId(const Parameter& row) : name_(row.name) {}
  /// Of a model of your own.
  template <CameraModelType M>
  [[nodiscard]] static consteval ParameterId of(std::string_view name) {
    return ParameterId(internal::checked_name(name, internal::TypeList<M>{}));
  }
  /// Nothing if no model of ModelList has a parameter of that name.
  [[nodiscard]] static std::optional<ParameterId> find(std::string_view name);

  [[nodiscard]] constexpr std::string_view name() const { return name_; }  ///< As in the model's table, which outlives all.
  bool operator==(const ParameterId&) const = default;

 private:
  constexpr explicit ParameterId(std::string_view name) : name_(name) {}

  std::string_view name_;
};
using ParameterIds = std::initializer_list<ParameterId>;

using Ray = std::array<double, 3>;    ///< x right, y down, z forward.
using Pixel = std::array<double, 2>;  ///< u, v; centre of the top-left pixel = (0, 0).

/// Angle of a ray from the optical axis, in radians, [0, pi].
[[nodiscard]] double angle_from_axis(const Ray& ray);

/// What is known of a model without its parameters.
struct ModelInfo {
  std::string_view id;
  std::string_view title;
  std::span<const std::string_view> aliases;
  std::span<const Parameter> parameters;
  bool focal_lengths_first = false;  ///< The parameters begin with fx, fy, cx, cy.
  int least_degree = 0;              ///< Of a polynomial whose degree a fit chooses; 0: it is none.
  int most_degree = 0;
  bool kept_only = false;  ///< No search for the best model tries it, only who asks for it by name.
};

/// All models, in the order of ModelList.
[[nodiscard]] std::span<const ModelInfo> all_models();
/// The model of that id or alias, in any case, '-' or '_'; null if there is none.
[[nodiscard]] const ModelInfo* find_model(std::string_view name);

/// A model of that exact id with all parameters 0; nothing if there is none.
[[nodiscard]] std::optional<CameraModel> make_model(std::string_view id);

[[nodiscard]] const ModelInfo& model_info(const CameraModel& model);
[[nodiscard]] std::span<const double> parameter_values(const CameraModel& model);
[[nodiscard]] std::span<double> parameter_values(CameraModel& model);
/// The value of that parameter; nothing if the model has no such parameter.
[[nodiscard]] std::optional<double> parameter(const CameraModel& model, ParameterId id);
/// False if the model has no such parameter.
bool set_parameter(CameraModel& model, ParameterId id, double value);

/// Ray (any positive length) -> pixel; nothing outside the model's domain or where the numbers overflow.
[[nodiscard]] std::optional<Pixel> project(const CameraModel& model, const Ray& ray);
/// Pixel -> unit ray; nothing where no ray of the domain has that pixel.
[[nodiscard]] std::optional<Ray> unproject(const CameraModel& model, const Pixel& pixel);
/// The same of many, but for rounding: three numbers a ray, two a pixel, one after the other. Not a number where there is
/// nothing. Both spans are of as many rays as pixels.
void project_all(const CameraModel& model, std::span<const double> rays, std::span<double> pixels);
void unproject_all(const CameraModel& model, std::span<const double> pixels, std::span<double> rays);
/// The limit of the model's domain, in radians from the axis.
[[nodiscard]] double max_angle(const CameraModel& model);

/// The pixel of the optical axis.
[[nodiscard]] Pixel principal_point(const CameraModel& model);
/// Radius per angle at the centre along u and v, in pixels per radian: the focal lengths by which models compare. (fx of ds,
/// mei and fov is something else.)
[[nodiscard]] std::array<double, 2> central_focal_lengths(const CameraModel& model);

/// A model and the skew of its image (skewed.h).
struct SkewedModel {
  CameraModel straight;  ///< Without skew.
  double skew_px = 0.0;
};
[[nodiscard]] SkewedModel without_skew(const CameraModel& model);
/// pinhole becomes radtan's model with skew; nothing of a model that has none.
[[nodiscard]] std::optional<CameraModel> with_skew(const CameraModel& model, double skew_px);

/// The id of the model without skew.
[[nodiscard]] std::string_view straight_id(const CameraModel& model);

/// Why this value cannot be that parameter; says nothing if it can.
[[nodiscard]] Message problem_with(const Parameter& parameter, double value);

/// Why these parameters are not a camera: not finite, outside their range, focal length not positive.
[[nodiscard]] std::vector<Message> validate(const CameraModel& model);

}  // namespace fca
