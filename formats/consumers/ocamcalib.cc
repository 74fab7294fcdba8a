// SPDX-License-Identifier: BSD-3-Clause
// OCamCalib's C functions: get_ocam_model and world2cam of ocam_functions.cpp (Davide Scaramuzza; as vendored in
// ctu-mrs/uvdar_core). The reader never looks at what fscanf returns: where a value is not there it goes on with whatever was
// in memory. Such files are refused here, with the place where it loses its way.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "fca/code.h"
#include "programs.h"

namespace fca::consumers {
namespace {

constexpr std::size_t kMaxBytes = 2U << 20U;
constexpr int kMaxCoefficients = 64;  // MAX_POL_LENGTH, not checked by the original
constexpr int kLineBuffer = 1024;     // CMV_MAX_BUF

using Vector = std::array<double, 3>;
using Pixel = std::array<double, 2>;

struct OcamModel {
  std::vector<double> pol;
  std::vector<double> invpol;
  double xc = 0.0, yc = 0.0;  ///< Row, column.
  double c = 1.0, d = 0.0, e = 0.0;
  int width = 0, height = 0;
};

/// In the axes of the toolbox: x along the rows' index (down), y along the columns' (right), z to the back. Pixel: (row,
/// column).
Pixel world2cam(const OcamModel& model, const Vector& point) {
  const double norm = std::sqrt(point[0] * point[0] + point[1] * point[1]);
  if (norm == 0.0) return {model.xc, model.yc};  // also for a ray straight backwards
  const double theta = std::atan(point[2] / norm);
  double rho = model.invpol.front();
  double power = 1.0;
  for (std::size_t i = 1; i < model.invpol.size(); ++i) {
    power *= theta;
    rho += power * model.invpol[i];
  }
  const double x = point[0] / norm * rho;
  const double y = point[1] / norm * rho;
  return {x * model.c + y * model.d + model.xc, x * model.e + y + model.yc};
}

/// The other direction, by the other polynomial.
Vector cam2world(const OcamModel& model, const Pixel& pixel) {
  const double inverse_det = 1.0 / (model.c - model.d * model.e);
  const double u = pixel[0] - model.xc;
  const double v = pixel[1] - model.yc;
  const double x = inverse_det * (u - model.d * v);
  const double y = inverse_det * (-model.e * u + model.c * v);
  const double r = std::sqrt(x * x + y * y);
  double z = model.pol.front();
  double power = 1.0;
  for (std::size_t i = 1; i < model.pol.size(); ++i) {
    power *= r;
    z += power * model.pol[i];
  }
  return {x, y, z};
}

/// The last whole radius before the angle of cam2world's rays stops growing, where d/dr (pol(r) / r) = 0: beyond, two radii
/// have one ray, and no world2cam can be the inverse.
double fold(const OcamModel& model) {
  const double end = 2.0 * std::hypot(model.width, model.height);
  for (double r = 0.0; r < end; r += 1.0) {
    double derivative = 0.0;  // pol - r pol'
    double power = 1.0;
    for (std::size_t i = 0; i < model.pol.size(); ++i) {
      derivative += (1.0 - static_cast<double>(i)) * model.pol[i] * power;
      power *= r;
    }
    if (derivative * model.pol.front() <= 0.0) return std::max(0.0, r - 1.0);
  }
  return end;
}

/// How far projecting is from the inverse of unprojecting, over the image: the two polynomials are separate fits.
double disagreement(const OcamModel& model) {
  const double farthest = fold(model);
  double worst = 0.0;
  const auto ask = [&](const Pixel& pixel) {
    const Vector ray = cam2world(model, pixel);
    if (std::hypot(ray[0], ray[1]) >= farthest) return;
    const Pixel back = world2cam(model, ray);
    const double distance = std::hypot(back[0] - pixel[0], back[1] - pixel[1]);
    if (!(distance <= worst)) worst = distance;
  };
  constexpr int kSteps = 40;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) ask({(model.height - 1.0) * i / kSteps, (model.width - 1.0) * j / kSteps});
  }
  // They differ along the radius: on the axis, where they need not meet, towards the fold, and in waves between.
  const double end = std::hypot(model.width, model.height);
  constexpr int kDirections = 8;
  for (double radius = 0.125; radius < end; radius += std::min(1.0, 0.25 * radius)) {
    for (int k = 0; k < kDirections; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kDirections;
      const Pixel pixel = {model.xc + radius * std::cos(angle), model.yc + radius * std::sin(angle)};
      const bool is_inside =
          pixel[0] >= 0.0 && pixel[1] >= 0.0 && pixel[0] <= model.height - 1.0 && pixel[1] <= model.width - 1.0;
      if (is_inside) ask(pixel);
    }
  }
  return worst;
}

/// get_ocam_model, on a stream over the bytes.
class ModelReader {
 public:
  ModelReader(std::FILE* file, std::string_view bytes, ConsumerView& view) : file_(file), bytes_(bytes), view_(view) {}

  std::optional<OcamModel> read() {
    OcamModel model;
    skip_line();
    if (!read_polynomial(model.pol, "direct polynomial")) return std::nullopt;
    skip_blanks();
    skip_line();
    if (!read_polynomial(model.invpol, "inverse polynomial")) return std::nullopt;
    skip_blanks();
    skip_line();
    if (!read_real(model.xc, "row of the centre") || !read_real(model.yc, "column of the centre")) return std::nullopt;
    skip_blanks();
    skip_line();
    if (!read_real(model.c, "affine parameter c") || !read_real(model.d, "affine parameter d") ||
        !read_real(model.e, "affine parameter e"))
      return std::nullopt;
    skip_blanks();
    skip_line();
    if (!read_int(model.height, "image height") || !read_int(model.width, "image width")) return std::nullopt;
    return model;
  }

 private:
  /// fgets into a buffer of 1024: a longer comment is not skipped whole.
  void skip_line() {
    std::array<char, kLineBuffer> buffer{};
    if (std::fgets(buffer.data(), kLineBuffer, file_) == nullptr) buffer.front() = '\0';
  }

  void skip_blanks() {
    if (std::fscanf(file_, " ") < 0) return;  // the end; what comes next will notice
  }

  bool read_polynomial(std::vector<double>& coefficients, const char* what) {
    int count = 0;
    skip_blanks();
    if (!read_int(count, Message{Code::kOcamNumberOfCoefficients, {what}})) return false;
    if (count < 1 || count > kMaxCoefficients) {
      view_.refusals.emplace_back(Code::kOcamCoefficientCount, "", std::vector<Argument>{what, count});
      return false;
    }
    coefficients.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      if (!read_real(coefficients[static_cast<std::size_t>(i)], Message{Code::kOcamCoefficient, {i, what}})) return false;
    }
    return true;
  }

  /// `what`: a noun, or a clause that is one.
  bool read_int(int& value, const Argument& what) { return std::fscanf(file_, "%d", &value) == 1 || lose_way(what); }
  bool read_real(double& value, const Argument& what) { return std::fscanf(file_, "%lf", &value) == 1 || lose_way(what); }

  bool lose_way(const Argument& what) {
    const long at = std::ftell(file_);
    const std::size_t place = at < 0 ? bytes_.size() : std::min(static_cast<std::size_t>(at), bytes_.size());
    const std::string_view rest = bytes_.substr(place, 24);
    const std::string found(rest.substr(0, rest.find_first_of("\r\n")));
    const Message taken = found.empty() ? Message{Code::kOcamEndOfFile} : Message{Code::kOcamWords, {found}};
    view_.refusals.emplace_back(Code::kOcamLosesWay, "", std::vector<Argument>{taken, what});
    return false;
  }

  std::FILE* file_;
  std::string_view bytes_;
  ConsumerView& view_;
};

bool is_finite(const OcamModel& model) {
  double sum = model.xc + model.yc + model.c + model.d + model.e;
  for (const double value : model.pol) sum += value;
  for (const double value : model.invpol) sum += value;
  return std::isfinite(sum);
}

void check(const OcamModel& model, ConsumerView& view) {
  if (!is_finite(model)) view.refusals.emplace_back(Code::kOcamNotFinite, "");
  if (model.width <= 0 || model.height <= 0) view.refusals.emplace_back(Code::kOcamSizeNotPositive, "");
  if (model.c - model.d * model.e == 0.0) view.refusals.emplace_back(Code::kOcamAffineSingular, "");
  if (!view.loads()) return;
  if (model.pol.front() > 0.0) view.warnings.emplace_back(Code::kOcamOtherSign, "");
  const double swapped = std::hypot(model.xc - 0.5 * model.width, model.yc - 0.5 * model.height);
  const double straight = std::hypot(model.xc - 0.5 * model.height, model.yc - 0.5 * model.width);
  const double diagonal = std::hypot(model.width, model.height);
  constexpr double kMounted = 0.03;  // diagonals: no lens sits farther from the middle; an almost square image tells nothing
  if (swapped <= 0.5 * straight && straight >= kMounted * diagonal) view.warnings.emplace_back(Code::kOcamCentreSwapped, "");
}

}  // namespace

ConsumerView load_ocamcalib(std::string_view bytes, const LoadOptions& /*options*/) {
  ConsumerView view;
  if (bytes.empty() || bytes.size() > kMaxBytes) {
    view.refusals.emplace_back(bytes.empty() ? Code::kProgramFileEmpty : Code::kProgramFileTooLarge, "");
    return view;
  }
  std::string copy(bytes);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(::fmemopen(copy.data(), copy.size(), "r"), &std::fclose);
  if (!file) {
    view.refusals.emplace_back(Code::kOcamNotOpened, "");
    return view;
  }
  const std::optional<OcamModel> model = ModelReader(file.get(), bytes, view).read();
  if (model) check(*model, view);
  if (!view.loads()) return view;
  ConsumerCamera camera;
  camera.name = "cam0";
  camera.width = model->width;
  camera.height = model->height;
  camera.model = "OCamCalib's inverse polynomial";
  camera.project = [model = *model](const Vector& ray) -> std::optional<Pixel> {
    const Pixel pixel = world2cam(model, {ray[1], ray[0], -ray[2]});
    if (!std::isfinite(pixel[0]) || !std::isfinite(pixel[1])) return std::nullopt;
    return Pixel{pixel[1], pixel[0]};
  };
  // OCamCalib's findinvpoly stops at 0.01 px; where the direct polynomial turns inside the image none comes that near. What is
  // further off than that is no approximation but another lens.
  constexpr double kLargestApproximation = 2.0;
  const double difference = disagreement(*model);
  // It was measured on a lattice. Between its points, and by the rounding of large coefficients that cancel, it may be more.
  constexpr double kBetweenPoints = 1.5;
  camera.approximation_px = difference < kLargestApproximation ? kBetweenPoints * difference : 0.0;
  if (!(difference < 0.1)) view.warnings.emplace_back(Code::kOcamInverseFarOff, "", std::vector<Argument>{difference});
  view.cameras.push_back(std::move(camera));
  return view;
}

}  // namespace fca::consumers
