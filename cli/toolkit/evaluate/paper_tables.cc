// SPDX-License-Identifier: BSD-3-Clause
#include <fca/toolkit/paper_tables.h>

#include <fca/models/ocamcalib_parameters.h>

#include <algorithm>
#include <cmath>

namespace fca::paper {

namespace {

constexpr Model kKb{"KB", Kb4::kId};
constexpr Model kUcm{"UCM", Ucm::kId};
constexpr Model kEucm{"EUCM", Eucm::kId};
constexpr Model kDs{"DS", Ds::kId};
constexpr Model kRt{"RT", Radtan::kId};
constexpr Model kOcc{"OCC", Ocamcalib::kId};

/// OCamCalib's parameters as the paper defines them (sec. II-E): (u, v) = [c d; e 1] (m_x, m_y) + (cx, cy), and
/// m_z = a0 + a1 r + ... + a4 r^4, which is positive in front of the camera.
struct OccParameters {
  static constexpr std::size_t kTerms = 5;
  double c = 1.0;
  double d = 0.0;
  double e = 0.0;
  double cx = 0.0;
  double cy = 0.0;
  std::array<double, kTerms> a{};
};

/// Converts the paper's parameters to those of the OCamCalib toolbox, which acts on (row, column) in place of (u, v). The
/// toolbox's c is the inverse of the paper's c, and its radius is the paper's radius times the paper's c. The code changes
/// signs by 0 - x and not by -x, so that no coefficient is -0.
Intrinsics<Ocamcalib> toolbox_form(const OccParameters& occ) {
  CameraModel model = Intrinsics<Ocamcalib>{};
  set_parameter(model, "cx", occ.cx);
  set_parameter(model, "cy", occ.cy);
  set_parameter(model, "c", 1.0 / occ.c);
  set_parameter(model, "d", occ.e / occ.c);
  set_parameter(model, "e", occ.d / occ.c);
  for (std::size_t k = 0; k < OccParameters::kTerms; ++k)
    set_parameter(model, kOcamcalibCoefficients.at(k), 0.0 - occ.a[k] * std::pow(occ.c, 1.0 - static_cast<double>(k)));
  return std::get<Intrinsics<Ocamcalib>>(model);
}

/// Converts the toolbox's parameters to the paper's: the inverse of toolbox_form().
OccParameters paper_form(const CameraModel& model) {
  const auto value = [&model](ParameterId id) { return parameter(model, id).value(); };
  OccParameters occ;
  occ.cx = value("cx");
  occ.cy = value("cy");
  occ.c = 1.0 / value("c");
  occ.d = value("e") / value("c");
  occ.e = value("d") / value("c");
  for (std::size_t k = 0; k < OccParameters::kTerms; ++k)
    occ.a[k] = 0.0 - value(kOcamcalibCoefficients.at(k)) * std::pow(value("c"), 1.0 - static_cast<double>(k));
  return occ;
}

constexpr std::string_view kNearTheOptimum =
    "near the optimum of these samples; the mean over all pixels is higher because cell centres leave out the border";
constexpr std::string_view kFewSamples =
    "an operator-precedence mistake in the authors' EUCM unprojection keeps 141 of 504 samples, those near the axis: their fit "
    "and "
    "their RE see nothing else";
constexpr std::string_view kFewSamplesAndFactor =
    "as the other EUCM rows, and as the other RT rows: 4.63e-05 px on 141 samples are 620 px at the worst pixel";
constexpr std::string_view kFactor =
    "the Jacobian of RT's distortion lacks the factors fx and fy, so that the authors' fit stops far from the optimum";
constexpr std::string_view kAlgebraic =
    "the authors' residual is algebraic, the distance times the projection's denominator, and their fit ends above even its "
    "optimum, which has RE 0.71 for EUCM and 0.83 for DS; PE is large for everybody, as DS trades xi for focal length";

/// Table 1: conversions between calibrations that Kalibr computed of one camera from Kalibr's sample data.
ConversionTable kalibr_table() {
  ConversionTable table;
  table.number = 1;
  table.title = "Kalibr's sample camera";
  table.size = {752, 480};
  table.calibrations = {
      Intrinsics<Eucm>{{460.92588889854693, 459.59327980206865, 365.81762690405503, 248.93674967920276, 0.5864679700626143,
                        1.139248617863534}},
      Intrinsics<Kb4>{{461.58688085556616, 460.2811732644195, 366.28603126815506, 249.08026891791644, -0.012523386218579752,
                       0.057836801948828065, -0.08495347810986263, 0.04362766880887814}},
      Intrinsics<Ds>{{348.112754378549, 347.1109973814674, 365.8121721753254, 249.3555778487899, 0.5657413673629862,
                      -0.24425190195168348}},
      Intrinsics<Radtan>{{459.2595646276051, 457.7579979599497, 366.021259576013, 248.29906707021513, -0.2895683327836746,
                          0.07964702146041833, 0.00033877669379945766, -2.1638533618181003e-05, 0.0}}};
  table.rows = {{kEucm, kDs, 2, 7.75e-06, 4.0964, 38.2773, 0.9975, ErrorFigures{0.0229, 0.0497, 0.38}, kFewSamples},
                {kEucm, kKb, 1, 6.87e-10, 1.0779, 36.5411, 0.9965, ErrorFigures{5e-4, 0.0014, 0.02}, kFewSamples},
                {kEucm, kRt, 5, 4.63e-05, 2.5740, 31.5081, 0.9873, ErrorFigures{9.45, 34.0, 620.0}, kFewSamplesAndFactor},
                {kKb, kEucm, 1, 0.02354, 0.5961, 40.4105, 0.9975, ErrorFigures{0.0240, 0.0300, 0.57}, kNearTheOptimum},
                {kKb, kDs, 3, 0.02275, 8.3069, 40.082, 0.9974, ErrorFigures{0.0233, 0.0297, 0.60}, kNearTheOptimum},
                {kKb, kRt, 6, 0.2617, 3.5305, 40.943, 0.9978, ErrorFigures{0.279, 0.580, 21.8}, kFactor},
                {kDs, kKb, 3, 1.87e-05, 1.4905, 39.8845, 0.9968, ErrorFigures{2e-5, 3e-5, 0.001}, kNearTheOptimum},
                {kDs, kEucm, 2, 0.0024, 0.6312, 42.4375, 0.9981, ErrorFigures{0.0025, 0.0033, 0.05}, kNearTheOptimum},
                {kDs, kRt, 4, 15.1505, 157.024, 28.8887, 0.9584, ErrorFigures{15.7, 23.8, 719.0}, kFactor},
                {kRt, kEucm, 4, 0.7922, 8.1594, 40.5359, 0.9968, ErrorFigures{0.817, 1.178, 16.6}, kAlgebraic},
                {kRt, kKb, 2, 0.1031, 2.1977, 41.6988, 0.9979, ErrorFigures{0.106, 0.143, 2.1}, kNearTheOptimum},
                {kRt, kDs, 2, 0.9697, 195.222, 38.4396, 0.9961, ErrorFigures{0.991, 1.252, 15.1}, kAlgebraic}};
  table.remark =
      "PE compares with Kalibr's separate calibration in the target's model; two such calibrations differ by 0.4-1.7 px "
      "themselves, so that it is no measure of a conversion. The camera reaches only 54-57 deg from the axis.";
  return table;
}

/// Table 2: conversions to OCamCalib's model. Their sources are conversions of the camera of OCamCalib's sample data.
ConversionTable ocamcalib_table() {
  ConversionTable table;
  table.number = 2;
  table.title = "OCamCalib's 190-degree sample camera";
  table.size = {752, 480};
  table.max_angle_deg = 95.0;
  table.calibrations = {toolbox_form(
      {0.998870, -0.000169, 0.000110, 359.829671, 243.611488, {209.3037, 0.0, -2.216175e-03, 5.122558e-06, -2.149945e-08}})};
  constexpr std::string_view kInFrontOnly =
      "the authors' program drops what lies 90 deg or more from the axis, holds c = 1 and d = e = 0, frees a1, and minimises "
      "an "
      "algebraic residual";
  constexpr std::string_view kFewest =
      "the EUCM mistake keeps 66 of 504 samples; the small RE and PE are theirs, not the image's";
  table.rows = {{kKb, kOcc, 4, 0.1777, 2.181, 38.3962, 0.8227, std::nullopt, kInFrontOnly},
                {kUcm, kOcc, 5, 0.9480, 13.7598, 31.9255, 0.8035, std::nullopt, kInFrontOnly},
                {kEucm, kOcc, 3, 0.0468, 0.3695, 33.0033, 0.9244, std::nullopt, kFewest},
                {kDs, kOcc, 4, 0.1546, 2.7296, 34.7245, 0.8246, std::nullopt, kInFrontOnly}};
  table.remark =
      "The authors' program does not reproduce this table, so that nothing can be measured over the image next to it. A "
      "source "
      "is the camera as that model describes it, its own fit's error away from it: PE says how far, RE does not.";
  return table;
}

}  // namespace

std::vector<ConversionTable> conversion_tables() { return {kalibr_table(), ocamcalib_table()}; }

const CameraModel* calibration_in(const ConversionTable& table, const Model& model) {
  const auto found = std::ranges::find_if(
      table.calibrations, [&model](const CameraModel& calibration) { return model_info(calibration).id == model.id; });
  return found == table.calibrations.end() ? nullptr : &*found;
}

std::vector<Pixel> cell_centres(const ImageSize& size, int count) {
  const double aspect = static_cast<double>(size.width) / size.height;
  const auto columns = std::lround(std::sqrt(count * aspect));
  const auto rows = std::lround(std::sqrt(count / aspect));
  std::vector<Pixel> centres;
  for (long row = 0; row < rows; ++row) {
    for (long column = 0; column < columns; ++column) {
      centres.push_back({(static_cast<double>(column) + 0.5) * size.width / static_cast<double>(columns),
                         (static_cast<double>(row) + 0.5) * size.height / static_cast<double>(rows)});
    }
  }
  return centres;
}

std::vector<double> parameters_as_published(const CameraModel& model) {
  if (!std::holds_alternative<Intrinsics<Ocamcalib>>(model)) {
    const std::span<const double> values = parameter_values(model);
    return {values.begin(), values.end()};
  }
  const OccParameters occ = paper_form(model);
  std::vector<double> values = {occ.c, occ.d, occ.e, occ.cx, occ.cy};
  values.insert(values.end(), occ.a.begin(), occ.a.end());
  return values;
}

double parameter_distance(const CameraModel& a, const CameraModel& b) {
  const std::vector<double> of_a = parameters_as_published(a);
  const std::vector<double> of_b = parameters_as_published(b);
  double sum = 0.0;
  for (std::size_t i = 0; i < of_a.size(); ++i) sum += (of_a[i] - of_b[i]) * (of_a[i] - of_b[i]);
  return std::sqrt(sum);
}

Polynomial polynomial_of(const Intrinsics<Ocamcalib>& model) {
  // The toolbox's coefficients are negative in front of the camera.
  const auto positive_in_front = [&model](ParameterId id) { return 0.0 - parameter(model, id).value(); };
  return {positive_in_front("a0"), positive_in_front("a1"), positive_in_front("a2")};
}

Intrinsics<Ocamcalib> camera_of(const Polynomial& polynomial, const Pixel& centre) {
  OccParameters occ;
  occ.cx = centre[0];
  occ.cy = centre[1];
  occ.a = {polynomial.a0, polynomial.a1, polynomial.a2};
  return toolbox_form(occ);
}

PolynomialTable polynomial_table() {
  // The source has the printed gamma_x, gamma_y, cx, cy and xi. The paper also prints f = gamma / (1 + xi) and
  // alpha = xi / (1 + xi), but rounded to 4 decimals.
  constexpr double kXi = 0.975;
  PolynomialTable table;
  table.title = "libPeR's UCM of an OCamCalib sample camera";
  // The paper prints no image size. This is the size of the toolbox's sample images, whose middle is near the centre below.
  table.size = {1024, 768};
  table.source = {{259.889 / (1.0 + kXi), 259.335 / (1.0 + kXi), 514.168, 382.797, kXi / (1.0 + kXi)}};
  table.toolbox = {131.0074, 0.0, -0.0018};
  table.methods = {{{"libPeR", {131.46, 0.0, -0.0018}}, {"paper", {130.809, 0.01238, 0.00186}}}};
  return table;
}

SlamCamera slam_camera() {
  return {{512, 512},
          97.5,
          Intrinsics<Kb4>{{190.97847715128717, 190.9733070521226, 254.93170605935475, 256.8974428996504, 0.0034823894022493434,
                           0.0007150348452162257, -0.0020532361418706202, 0.00020293673591811182}},
          kEucm};
}

}  // namespace fca::paper
