// SPDX-License-Identifier: BSD-3-Clause
// evaluate: what it prints of the paper (Lee, Fisheye-Calib-Adapter, 2024, Tables 1-3) is in the paper, and what it prints of
// its own cameras is true. The formulas here are written from the paper and share no code with the library.
#include "cli/told.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <sstream>

#include <rapidjson/document.h>

namespace fca::test {
namespace {

using Json = rapidjson::Value;
using Parameters = std::map<std::string, double>;

struct Point2 {
  double u = 0.0;
  double v = 0.0;
};
struct Point3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

double distance(const Point2& a, const Point2& b) { return std::hypot(a.u - b.u, a.v - b.v); }

/// A camera as printed: its model's name and parameters.
struct PrintedCamera {
  std::string model;
  Parameters p;
  std::vector<double> polynomial;  ///< ocamcalib: a0, a1, ... up to the last that is not 0
  double rho_max = 2000.0;         ///< ocamcalib: where the angle stops growing, to a pixel.
};

/// OCamCalib's height of the ray at the image radius rho, ahead of the camera: -f(rho).
double ocamcalib_height(const PrintedCamera& camera, double rho) {
  double height = 0.0;
  for (auto a = camera.polynomial.rbegin(); a != camera.polynomial.rend(); ++a) height = height * rho - *a;
  return height;
}

PrintedCamera camera_in(const Json& value) {
  PrintedCamera camera{value["model"].GetString(), {}};
  for (const auto& member : value["parameters"].GetObject()) camera.p[member.name.GetString()] = member.value.GetDouble();
  if (camera.model != "ocamcalib") return camera;
  for (int k = 0; k <= 8; ++k) camera.polynomial.push_back(camera.p.at("a" + std::to_string(k)));
  while (camera.polynomial.back() == 0.0) camera.polynomial.pop_back();
  double last = 0.0;
  for (double rho = 1.0; rho < camera.rho_max; rho += 1.0) {
    const double angle = std::atan2(rho, ocamcalib_height(camera, rho));
    if (angle < last) camera.rho_max = rho;
    last = angle;
  }
  return camera;
}

/// KB's d(theta) (paper, sec. II-D).
auto distortion_of(const Parameters& p) {
  return [k1 = p.at("k1"), k2 = p.at("k2"), k3 = p.at("k3"), k4 = p.at("k4")](double theta) {
    const double t2 = theta * theta;
    return theta * (1.0 + t2 * (k1 + t2 * (k2 + t2 * (k3 + t2 * k4))));
  };
}

/// The rays of the models that are sources in the tables (paper, sec. II; KB's and RT's inverses by bisection and fixed point).
Point3 ray_of(const PrintedCamera& camera, const Point2& pixel) {
  const Parameters& p = camera.p;
  const double x = (pixel.u - p.at("cx")) / p.at("fx");
  const double y = (pixel.v - p.at("cy")) / p.at("fy");
  const double r2 = x * x + y * y;
  if (camera.model == "ucm" || camera.model == "eucm" || camera.model == "ds") {
    const double alpha = p.at("alpha");
    const double beta = camera.model == "eucm" ? p.at("beta") : 1.0;
    const double mz =
        (1.0 - beta * alpha * alpha * r2) / (alpha * std::sqrt(1.0 - (2.0 * alpha - 1.0) * beta * r2) + 1.0 - alpha);
    if (camera.model != "ds") return {x, y, mz};
    const double xi = p.at("xi");
    const double scale = (mz * xi + std::sqrt(mz * mz + (1.0 - xi * xi) * r2)) / (mz * mz + r2);
    return {scale * x, scale * y, scale * mz - xi};
  }
  if (camera.model == "kb4") {
    const double radius = std::sqrt(r2);
    const auto d = distortion_of(p);
    double low = 0.0;
    double high = 2.0;
    for (int i = 0; i < 60; ++i) {
      const double theta = 0.5 * (low + high);
      (d(theta) < radius ? low : high) = theta;
    }
    return {std::sin(low) * x / radius, std::sin(low) * y / radius, std::cos(low)};
  }
  EXPECT_EQ(camera.model, "radtan");
  const double k1 = p.at("k1");
  const double k2 = p.at("k2");
  const double k3 = p.at("k3");
  const double p1 = p.at("p1");
  const double p2 = p.at("p2");
  Point3 ray{x, y, 1.0};
  for (int i = 0; i < 500; ++i) {
    const double q = ray.x * ray.x + ray.y * ray.y;
    const double radial = 1.0 + q * (k1 + q * (k2 + q * k3));
    const Point3 before = ray;
    ray.x = (x - 2.0 * p1 * ray.x * ray.y - p2 * (q + 2.0 * ray.x * ray.x)) / radial;
    ray.y = (y - p1 * (q + 2.0 * before.y * before.y) - 2.0 * p2 * before.x * before.y) / radial;
    if (std::abs(ray.x - before.x) + std::abs(ray.y - before.y) < 1e-15) break;
  }
  return ray;
}

Point2 pixel_of(const PrintedCamera& camera, const Point3& ray) {
  const Parameters& p = camera.p;
  const double r = std::hypot(ray.x, ray.y);
  if (camera.model == "ocamcalib") {
    // Height over rho, f / rho, falls to z / r up to the root that is meant, and no further than the angle grows.
    double low = 0.0;
    double high = camera.rho_max;
    for (int i = 0; i < 48; ++i) {
      const double rho = 0.5 * (low + high);
      (ocamcalib_height(camera, rho) * r > ray.z * rho ? low : high) = rho;
    }
    const double down = low * ray.y / r;
    const double right = low * ray.x / r;
    return {p.at("e") * down + right + p.at("cx"), p.at("c") * down + p.at("d") * right + p.at("cy")};
  }
  double x = 0.0;
  double y = 0.0;
  if (camera.model == "kb4") {
    const double d = distortion_of(p)(std::atan2(r, ray.z));
    x = d * ray.x / r;
    y = d * ray.y / r;
  } else if (camera.model == "radtan") {
    const double a = ray.x / ray.z;
    const double b = ray.y / ray.z;
    const double q = a * a + b * b;
    const double radial = 1.0 + q * (p.at("k1") + q * (p.at("k2") + q * p.at("k3")));
    x = a * radial + 2.0 * p.at("p1") * a * b + p.at("p2") * (q + 2.0 * a * a);
    y = b * radial + p.at("p1") * (q + 2.0 * b * b) + 2.0 * p.at("p2") * a * b;
  } else {
    const bool double_sphere = camera.model == "ds";
    const double alpha = p.at("alpha");
    const double z = double_sphere ? p.at("xi") * std::hypot(r, ray.z) + ray.z : ray.z;
    const double beta = camera.model == "eucm" ? p.at("beta") : 1.0;
    const double denominator = alpha * std::sqrt(beta * r * r + z * z) + (1.0 - alpha) * z;
    x = ray.x / denominator;
    y = ray.y / denominator;
  }
  return {p.at("fx") * x + p.at("cx"), p.at("fy") * y + p.at("cy")};
}

struct Errors {
  int count = 0;
  double mean = 0.0;
  double rms = 0.0;
  double max = 0.0;
};

/// Of the target against the source, over the pixels whose ray lies within the angle.
Errors errors_over(const std::vector<Point2>& pixels, const PrintedCamera& source, const PrintedCamera& target,
                   double max_angle_deg) {
  Errors errors;
  for (const Point2& pixel : pixels) {
    const Point3 ray = ray_of(source, pixel);
    // Beyond the model's own limit its square root has no value.
    if (!(std::atan2(std::hypot(ray.x, ray.y), ray.z) * 180.0 / std::numbers::pi <= max_angle_deg)) continue;
    const double e = distance(pixel_of(target, ray), pixel);
    ++errors.count;
    errors.mean += e;
    errors.rms += e * e;
    errors.max = std::max(errors.max, e);
  }
  errors.mean /= errors.count;
  errors.rms = std::sqrt(errors.rms / errors.count);
  return errors;
}

struct Size {
  int width = 0;
  int height = 0;
};
Size size_in(const Json& table) { return {table["width_px"].GetInt(), table["height_px"].GetInt()}; }

std::vector<Point2> every_pixel(const Size& size) {
  std::vector<Point2> pixels;
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) pixels.push_back({static_cast<double>(u), static_cast<double>(v)});
  }
  return pixels;
}

/// The paper: samples "by uniformly dividing the image into grid cells", N = 500; 28 x 18 of 752 x 480.
std::vector<Point2> samples_of(const Size& size) {
  const double aspect = static_cast<double>(size.width) / size.height;
  const int columns = static_cast<int>(std::lround(std::sqrt(500.0 * aspect)));
  const int rows = static_cast<int>(std::lround(std::sqrt(500.0 / aspect)));
  std::vector<Point2> samples;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column)
      samples.push_back({(column + 0.5) * size.width / columns, (row + 0.5) * size.height / rows});
  }
  return samples;
}

class Evaluate : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    // Under the sanitizers it takes its time.
    const RunResult run = run_program({"evaluate", "--json"}, {.limit_seconds = 300.0});
    ASSERT_EQ(run.code, 0) << run.err;
    ASSERT_EQ(run.err, "");
    document_ = std::make_unique<rapidjson::Document>();
    document_->Parse<rapidjson::kParseFullPrecisionFlag | rapidjson::kParseValidateEncodingFlag>(run.out.c_str());
    ASSERT_FALSE(document_->HasParseError()) << run.out;
  }
  static void TearDownTestSuite() { document_.reset(); }

  static const Json& conversions() { return (*document_)["conversions"]; }
  static const Json& polynomials() { return (*document_)["polynomials"]; }

  /// The row "EUCM-DS".
  static const Json& row(const std::string& name) {
    for (const Json& table : conversions().GetArray()) {
      for (const Json& row : table["rows"].GetArray()) {
        if (name == std::string(row["from"].GetString()) + "-" + row["to"].GetString()) return row;
      }
    }
    ADD_FAILURE() << name << " is missing";
    return conversions();
  }

  static std::unique_ptr<rapidjson::Document> document_;
};
std::unique_ptr<rapidjson::Document> Evaluate::document_;

/// The errors that a row prints are those of the cameras that it prints, over all the pixels that it counts.
void expect_errors_are_true(const Json& row, const Size& size) {
  const PrintedCamera source = camera_in(row["source"]);
  const PrintedCamera target = camera_in(row["target"]);
  const double max_angle = row["domain"]["max_angle_deg"].GetDouble() + 1e-9;
  const Errors errors = errors_over(every_pixel(size), source, target, max_angle);
  const Json& printed = row["error_px"];
  // Below 1e-9 px it is the bisections' rounding that differs.
  const auto tolerance = [](double value) { return 1e-6 * value + 1e-9; };
  EXPECT_EQ(errors.count, static_cast<int>(row["domain"]["scored_pixels"].GetDouble()));
  EXPECT_EQ(row["domain"]["unrepresentable_pixels"].GetDouble(), 0.0);
  EXPECT_NEAR(printed["rms"].GetDouble(), errors.rms, tolerance(errors.rms));
  EXPECT_NEAR(printed["mean"].GetDouble(), errors.mean, tolerance(errors.mean));
  // The maximum is searched for between the pixels, too.
  EXPECT_GE(printed["max"].GetDouble(), errors.max - tolerance(errors.max));
  const Point2 at{printed["max_at"][0].GetDouble(), printed["max_at"][1].GetDouble()};
  EXPECT_NEAR(distance(pixel_of(target, ray_of(source, at)), at), printed["max"].GetDouble(), tolerance(errors.max));
}

TEST_F(Evaluate, ErrorsAreThoseOfEveryPixel) {
  int rows = 0;
  for (const Json& table : conversions().GetArray()) {
    const Size size = size_in(table);
    for (const Json& row : table["rows"].GetArray()) {
      SCOPED_TRACE(std::string(row["from"].GetString()) + "-" + row["to"].GetString());
      expect_errors_are_true(row, size);
      const Errors on_samples = errors_over(samples_of(size), camera_in(row["source"]), camera_in(row["target"]),
                                            row["domain"]["max_angle_deg"].GetDouble() + 1e-9);
      EXPECT_EQ(on_samples.count, row["paper_samples"]["count"].GetInt());
      EXPECT_NEAR(on_samples.mean, row["paper_samples"]["mean_px"].GetDouble(), 1e-6 * on_samples.mean + 1e-9);
      ++rows;
    }
  }
  EXPECT_EQ(rows, 16);
}

/// A figure as the paper prints it, and the worth of its last digit.
struct Printed {
  std::string digits;

  [[nodiscard]] double value() const { return std::strtod(digits.c_str(), nullptr); }
  [[nodiscard]] double last_digit() const {
    const std::size_t exponent = std::min(digits.find('e'), digits.size());
    const std::size_t point = std::min(digits.find('.'), exponent);
    const double decimals = point == exponent ? 0.0 : static_cast<double>(exponent - point - 1);
    const double power = exponent == digits.size() ? 0.0 : std::strtod(digits.c_str() + exponent + 1, nullptr);
    return std::pow(10.0, power - decimals);
  }
  /// The paper rounds some figures and cuts others off.
  [[nodiscard]] bool may_be(double exact) const { return std::abs(exact - value()) <= last_digit(); }
};

struct PaperRow {
  std::string name;
  double time_ms = 0.0;
  Printed reprojection_error;
  Printed parameter_error;
};

// Copied from the paper once more, in its order: a mistake in the program's table would have to happen twice.
const std::vector<PaperRow> kTables1And2 = {
    {"EUCM-DS", 2, {"7.75e-06"}, {"4.0964"}}, {"EUCM-KB", 1, {"6.87e-10"}, {"1.0779"}},
    {"EUCM-RT", 5, {"4.63e-05"}, {"2.5740"}}, {"KB-EUCM", 1, {"0.02354"}, {"0.5961"}},
    {"KB-DS", 3, {"0.02275"}, {"8.3069"}},    {"KB-RT", 6, {"0.2617"}, {"3.5305"}},
    {"DS-KB", 3, {"1.87e-05"}, {"1.4905"}},   {"DS-EUCM", 2, {"0.0024"}, {"0.6312"}},
    {"DS-RT", 4, {"15.1505"}, {"157.024"}},   {"RT-EUCM", 4, {"0.7922"}, {"8.1594"}},
    {"RT-KB", 2, {"0.1031"}, {"2.1977"}},     {"RT-DS", 2, {"0.9697"}, {"195.222"}},
    {"KB-OCC", 4, {"0.1777"}, {"2.181"}},     {"UCM-OCC", 5, {"0.9480"}, {"13.7598"}},
    {"EUCM-OCC", 3, {"0.0468"}, {"0.3695"}},  {"DS-OCC", 4, {"0.1546"}, {"2.7296"}},
};

TEST_F(Evaluate, PrintsThePapersFigures) {
  for (const PaperRow& paper : kTables1And2) {
    SCOPED_TRACE(paper.name);
    const Json& printed = row(paper.name)["paper"];
    EXPECT_EQ(printed["time_ms"].GetDouble(), paper.time_ms);
    EXPECT_EQ(printed["reprojection_error_px"].GetDouble(), paper.reprojection_error.value());
    EXPECT_EQ(printed["parameter_error"].GetDouble(), paper.parameter_error.value());
  }
}

/// Least squares by Levenberg's and Marquardt's method with differences for derivatives.
using Residuals = std::function<std::vector<double>(const std::vector<double>&)>;

std::vector<double> solve(std::vector<std::vector<double>> a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t j = i + 1; j < n; ++j) {
      if (std::abs(a[j][i]) > std::abs(a[pivot][i])) pivot = j;
    }
    std::swap(a[i], a[pivot]);
    std::swap(b[i], b[pivot]);
    for (std::size_t j = i + 1; j < n; ++j) {
      const double factor = a[j][i] / a[i][i];
      for (std::size_t k = i; k < n; ++k) a[j][k] -= factor * a[i][k];
      b[j] -= factor * b[i];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  return b;
}

double squares(const std::vector<double>& e) {
  double sum = 0.0;
  for (const double v : e) sum += v * v;
  return sum;
}

std::vector<double> least_squares(const Residuals& residuals, std::vector<double> p) {
  double damping = 1e-4;
  std::vector<double> e = residuals(p);
  for (int round = 0; round < 500 && damping < 1e12; ++round) {
    std::vector<std::vector<double>> columns;
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double h = 1e-6 * std::max(1.0, std::abs(p[k]));
      std::vector<double> before = p;
      std::vector<double> after = p;
      before[k] -= h;
      after[k] += h;
      std::vector<double> column = residuals(after);
      const std::vector<double> other = residuals(before);
      for (std::size_t i = 0; i < column.size(); ++i) column[i] = (column[i] - other[i]) / (2.0 * h);
      columns.push_back(std::move(column));
    }
    std::vector<std::vector<double>> normal(p.size(), std::vector<double>(p.size()));
    std::vector<double> right(p.size());
    for (std::size_t j = 0; j < p.size(); ++j) {
      for (std::size_t k = 0; k < p.size(); ++k) {
        for (std::size_t i = 0; i < e.size(); ++i) normal[j][k] += columns[j][i] * columns[k][i];
      }
      for (std::size_t i = 0; i < e.size(); ++i) right[j] -= columns[j][i] * e[i];
      normal[j][j] *= 1.0 + damping;
    }
    std::vector<double> moved = solve(normal, right);
    for (std::size_t k = 0; k < p.size(); ++k) moved[k] += p[k];
    std::vector<double> there = residuals(moved);
    if (squares(there) < squares(e)) {
      p = std::move(moved);
      e = std::move(there);
      damping *= 0.1;
    } else {
      damping *= 4.0;
    }
  }
  return p;
}

PrintedCamera with_values(const std::string& model, const std::vector<double>& values) {
  const std::map<std::string, std::vector<std::string>> kNames = {{"kb4", {"fx", "fy", "cx", "cy", "k1", "k2", "k3", "k4"}},
                                                                  {"eucm", {"fx", "fy", "cx", "cy", "alpha", "beta"}},
                                                                  {"ds", {"fx", "fy", "cx", "cy", "alpha", "xi"}}};
  PrintedCamera camera{model, {}};
  const std::vector<std::string>& names = kNames.at(model);
  for (std::size_t i = 0; i < names.size(); ++i) camera.p[names[i]] = values[i];
  return camera;
}

/// The paper's conversion: its samples, its residual (KB: in pixels; EUCM and DS: times the denominator), its start.
PrintedCamera as_the_paper_converts(const PrintedCamera& source, const std::string& model, const Size& size) {
  const std::vector<Point2> samples = samples_of(size);
  std::vector<Point3> rays;
  for (const Point2& pixel : samples) {
    Point3 ray = ray_of(source, pixel);
    const double length = std::hypot(ray.x, ray.y, ray.z);
    rays.push_back({ray.x / length, ray.y / length, ray.z / length});
  }
  std::vector<double> start = {source.p.at("fx"), source.p.at("fy"), source.p.at("cx"), source.p.at("cy")};
  if (model == "kb4") {
    start.resize(8);
  } else {
    start.insert(start.end(), {0.5, model == "eucm" ? 1.0 : 0.0});
  }
  const Residuals residuals = [&](const std::vector<double>& values) {
    const PrintedCamera camera = with_values(model, values);
    std::vector<double> e;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Point2 pixel = pixel_of(camera, rays[i]);
      // fx x - (u - cx) D is D (pixel - u), and D = fx x / (pixel - cx).
      const double weight = model == "kb4" ? 1.0 : values[0] * rays[i].x / (pixel.u - values[2]);
      e.push_back(weight * (pixel.u - samples[i].u));
      e.push_back(weight * (pixel.v - samples[i].v));
    }
    return e;
  };
  return with_values(model, least_squares(residuals, start));
}

double parameter_distance(const PrintedCamera& a, const PrintedCamera& b) {
  double sum = 0.0;
  for (const auto& [name, value] : a.p) sum += (value - b.p.at(name)) * (value - b.p.at(name));
  return std::sqrt(sum);
}

const PaperRow& paper_row(const std::string& name) {
  return *std::find_if(kTables1And2.begin(), kTables1And2.end(), [&name](const PaperRow& row) { return row.name == name; });
}

// Where the authors' program loses no sample and its Jacobian is right, the paper's method gives the paper's digits: these are
// the paper's cameras, samples and RE.
TEST_F(Evaluate, ThePapersMethodGivesThePapersDigitsOnTheseCameras) {
  const Size size = size_in(conversions()[0]);
  for (const char* name : {"DS-KB", "RT-KB", "KB-EUCM", "DS-EUCM", "KB-DS"}) {
    SCOPED_TRACE(name);
    const PrintedCamera source = camera_in(row(name)["source"]);
    const PrintedCamera converted = as_the_paper_converts(source, row(name)["target"]["model"].GetString(), size);
    const double mean = errors_over(samples_of(size), source, converted, 180.0).mean;
    EXPECT_TRUE(paper_row(name).reprojection_error.may_be(mean)) << mean;
    // KB-DS: along DS's ridge of xi and focal length, Ceres stops short of the optimum in the sixth digit of its cost.
    if (std::string(name) == "KB-DS") continue;
    const std::string target = std::string(name).substr(std::string(name).find('-') + 1);
    const PrintedCamera calibration = camera_in(row(target == "KB" ? "KB-EUCM" : "EUCM-DS")["source"]);
    const double parameters = parameter_distance(converted, calibration);
    EXPECT_TRUE(paper_row(name).parameter_error.may_be(parameters)) << parameters;
  }
}

// The reason given for these two rows.
TEST_F(Evaluate, TheAuthorsStopAboveTheirResidualsOptimumFromRadtan) {
  const Size size = size_in(conversions()[0]);
  for (const auto& [name, said] : {std::pair{"RT-EUCM", 0.71}, std::pair{"RT-DS", 0.83}}) {
    const PrintedCamera source = camera_in(row(name)["source"]);
    const PrintedCamera converted = as_the_paper_converts(source, row(name)["target"]["model"].GetString(), size);
    const double mean = errors_over(samples_of(size), source, converted, 180.0).mean;
    EXPECT_NEAR(mean, said, 0.005) << name;
    EXPECT_LT(mean, paper_row(name).reprojection_error.value()) << name;
    EXPECT_TRUE(contains(row(name)["why"].GetString(), std::to_string(said).substr(0, 4))) << row(name)["why"].GetString();
  }
}

TEST_F(Evaluate, ParameterErrorIsTheDistanceToTheCalibration) {
  for (const Json& printed : conversions()[0]["rows"].GetArray()) {
    const PrintedCamera target = camera_in(printed["target"]);
    const std::map<std::string, const char*> kRowFrom = {
        {"ds", "DS-KB"}, {"kb4", "KB-DS"}, {"eucm", "EUCM-DS"}, {"radtan", "RT-KB"}};
    const PrintedCamera calibration = camera_in(row(kRowFrom.at(target.model))["source"]);
    const double expected = parameter_distance(target, calibration);
    EXPECT_NEAR(printed["parameter_error"].GetDouble(), expected, 1e-12 * expected);
  }
}

// Table 2 measures in its own (u, v) form; the calibration is the paper's.
TEST_F(Evaluate, ParameterErrorOfOccIsInThePapersForm) {
  const std::vector<double> truth = {0.998870,     -0.000169, 0.000110,      359.829671,   243.611488,
                                     2.093037e+02, 0.0,       -2.216175e-03, 5.122558e-06, -2.149945e-08};
  for (const Json& printed : conversions()[1]["rows"].GetArray()) {
    const Parameters p = camera_in(printed["target"]).p;
    // (u - cx, v - cy) = [c' d'; e' 1] m with the file's [1 e; c d] on (column, row): m = s (column, row), s = file's c.
    const double c = p.at("c");
    std::vector<double> values = {1.0 / c, p.at("e") / c, p.at("d") / c, p.at("cx"), p.at("cy")};
    for (int k = 0; k <= 4; ++k) values.push_back(-p.at("a" + std::to_string(k)) * std::pow(c, 1 - k));
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) sum += (values[i] - truth[i]) * (values[i] - truth[i]);
    EXPECT_NEAR(printed["parameter_error"].GetDouble(), std::sqrt(sum), 1e-6);
  }
}

/// UCM as the paper unprojects it (eq. 7), with the sign below the fraction to choose: the paper's text has +1, the authors'
/// program -1. Nothing where the program gives up (denominator below 1e-3) or the ray does not lie ahead.
std::optional<Point3> ucm_ray(const Parameters& p, const Point2& pixel, double sign) {
  const double alpha = p.at("alpha");
  const double xi = alpha / (1.0 - alpha);
  const double x = (pixel.u - p.at("cx")) / p.at("fx") * (1.0 - alpha);
  const double y = (pixel.v - p.at("cy")) / p.at("fy") * (1.0 - alpha);
  const double r2 = x * x + y * y;
  const double below = 1.0 + sign * r2;
  if (below < 1e-3) return std::nullopt;
  const double k = (xi + std::sqrt(1.0 + (1.0 - xi * xi) * r2)) / below;
  if (!(k - xi > 0.0)) return std::nullopt;
  return Point3{k * x, k * y, k - xi};
}

/// The paper's fit of a0 + a1 r + a2 r^2: (u - cx) - a(r) x / z, linear.
std::array<double, 3> polynomial_as_the_paper_fits(const Parameters& ucm, double sign, const Size& size) {
  std::vector<std::vector<double>> normal(3, std::vector<double>(3));
  std::vector<double> right(3);
  for (const Point2& pixel : samples_of(size)) {
    const std::optional<Point3> ray = ucm_ray(ucm, pixel, sign);
    if (!ray) continue;
    const Point2 from_centre{pixel.u - ucm.at("cx"), pixel.v - ucm.at("cy")};
    const double r = std::hypot(from_centre.u, from_centre.v);
    const std::array<double, 3> powers = {1.0, r, r * r};
    for (const auto& [slope, value] : {std::pair{ray->x / ray->z, from_centre.u}, std::pair{ray->y / ray->z, from_centre.v}}) {
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t k = 0; k < 3; ++k) normal[j][k] += slope * slope * powers[j] * powers[k];
        right[j] += slope * powers[j] * value;
      }
    }
  }
  const std::vector<double> a = solve(normal, right);
  return {a[0], a[1], a[2]};
}

const std::array<Printed, 3> kPapersPolynomial = {{{"130.809"}, {"0.01238"}, {"0.00186"}}};

// The paper prints alpha with four digits, and its polynomial follows from some alpha with the wrong sign that rounds to them.
TEST_F(Evaluate, TheWrongSignGivesThePapersPolynomial) {
  const Size size = size_in(polynomials());
  Parameters ucm = camera_in(polynomials()["source"]).p;
  // f as printed, too.
  ucm["fx"] = 131.5893;
  ucm["fy"] = 131.3089;
  EXPECT_NEAR(ucm.at("alpha"), 0.4937, 0.00005);
  ucm["alpha"] = 0.49365;
  const std::array<double, 3> low = polynomial_as_the_paper_fits(ucm, -1.0, size);
  ucm["alpha"] = 0.49375;
  const std::array<double, 3> high = polynomial_as_the_paper_fits(ucm, -1.0, size);
  const std::array<double, 3> right = polynomial_as_the_paper_fits(ucm, 1.0, size);
  EXPECT_LT(right[2], 0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    const Printed& printed = kPapersPolynomial[k];
    EXPECT_LE(std::min(low[k], high[k]), printed.value() + printed.last_digit()) << k;
    EXPECT_GE(std::max(low[k], high[k]), printed.value() - printed.last_digit()) << k;
    // With the right sign the same method ends elsewhere, further away than any of alpha's digits reach.
    EXPECT_GT(std::abs(right[k] - printed.value()), 2.0 * std::abs(high[k] - low[k])) << k;
  }
}

TEST_F(Evaluate, TheClosedFormsOfBothSignsAreTheCurvatureOnTheAxis) {
  const Parameters ucm = camera_in(polynomials()["source"]).p;
  Parameters round = ucm;
  round["fx"] = round["fy"] = 0.5 * (ucm.at("fx") + ucm.at("fy"));
  const auto curvature = [&round](double sign) {
    // a(r) = a0 + a2 r^2 + O(r^4); from two radii.
    const auto height = [&](double r) {
      const Point3 ray = *ucm_ray(round, {round.at("cx") + r, round.at("cy")}, sign);
      return r * ray.z / ray.x;
    };
    return (height(2.0) - height(1.0)) / 3.0;
  };
  const Json& sign = polynomials()["sign_error"];
  EXPECT_NEAR(sign["a2_on_axis"].GetDouble(), curvature(1.0), 1e-3 * std::abs(curvature(1.0)));
  EXPECT_NEAR(sign["a2_on_axis_with_wrong_sign"].GetDouble(), curvature(-1.0), 1e-3 * std::abs(curvature(-1.0)));
  EXPECT_LT(curvature(1.0), 0.0);
  EXPECT_GT(curvature(-1.0), 0.0);
}

/// A polynomial around UCM's centre as OCamCalib's file has it.
PrintedCamera polynomial_camera(const Parameters& ucm, double a0, double a2) {
  PrintedCamera camera{"ocamcalib", {{"cx", ucm.at("cx")}, {"cy", ucm.at("cy")}, {"c", 1.0}, {"d", 0.0}, {"e", 0.0}}};
  camera.polynomial = {-a0, 0.0, -a2};
  return camera;
}

TEST_F(Evaluate, OurPolynomialIsTheBestOne) {
  const Size size = size_in(polynomials());
  const PrintedCamera source = camera_in(polynomials()["source"]);
  const Json& ours = polynomials()["rows"][2];
  EXPECT_EQ(std::string(ours["method"].GetString()), "fca-io, degree 2, c = 1");
  EXPECT_EQ(ours["domain"]["max_angle_deg"].GetDouble(), 90.0);
  const double a0 = ours["polynomial"]["a0"].GetDouble();
  const double a2 = ours["polynomial"]["a2"].GetDouble();
  EXPECT_EQ(ours["polynomial"]["a1"].GetDouble(), 0.0);
  std::vector<Point2> ahead = every_pixel(size);
  std::erase_if(ahead, [&source](const Point2& pixel) { return !(ray_of(source, pixel).z >= 0.0); });
  const auto rms = [&](double b0, double b2) {
    return errors_over(ahead, source, polynomial_camera(source.p, b0, b2), 90.0).rms;
  };
  const double here = rms(a0, a2);
  EXPECT_NEAR(here, ours["error_px"]["rms"].GetDouble(), 1e-6 * here);
  for (const double step : {-1e-3, 1e-3}) {
    EXPECT_GT(rms(a0 * (1.0 + step), a2), here) << step;
    EXPECT_GT(rms(a0, a2 * (1.0 + step)), here) << step;
  }
  // ERRATA: "close to -0.0018". The toolbox's own a2 has these two digits.
  EXPECT_NEAR(a2, -0.0018, 0.0001);
}

TEST_F(Evaluate, PolynomialsOfTheProgramAreEvaluatedOnEveryPixel) {
  const Size size = size_in(polynomials());
  const PrintedCamera source = camera_in(polynomials()["source"]);
  int fitted = 0;
  for (const Json& row : polynomials()["rows"].GetArray()) {
    if (row["published"].GetBool()) continue;
    SCOPED_TRACE(row["method"].GetString());
    const Errors errors =
        errors_over(every_pixel(size), source, camera_in(row["target"]), row["domain"]["max_angle_deg"].GetDouble() + 1e-9);
    EXPECT_EQ(errors.count, static_cast<int>(row["domain"]["scored_pixels"].GetDouble()));
    EXPECT_NEAR(row["error_px"]["rms"].GetDouble(), errors.rms, 1e-6 * errors.rms);
    EXPECT_NEAR(row["error_px"]["mean"].GetDouble(), errors.mean, 1e-6 * errors.mean);
    ++fitted;
  }
  EXPECT_EQ(fitted, 4);
}

// Where the paper's polynomial stops: its angle grows up to r^2 = a0 / a2.
TEST_F(Evaluate, ThePapersPolynomialHasNoPixelForTheOtherRays) {
  const Json& paper = polynomials()["rows"][1];
  EXPECT_EQ(std::string(paper["method"].GetString()), "paper");
  const double a0 = kPapersPolynomial[0].value();
  const double a1 = kPapersPolynomial[1].value();
  const double a2 = kPapersPolynomial[2].value();
  const double r = std::sqrt(a0 / a2);
  const double limit = std::atan2(r, a0 + a1 * r + a2 * r * r) * 180.0 / std::numbers::pi;
  const PrintedCamera source = camera_in(polynomials()["source"]);
  int ahead = 0;
  int reached = 0;
  for (const Point2& pixel : every_pixel(size_in(polynomials()))) {
    const Point3 ray = ray_of(source, pixel);
    const double angle = std::atan2(std::hypot(ray.x, ray.y), ray.z) * 180.0 / std::numbers::pi;
    ahead += angle <= 90.0 ? 1 : 0;
    reached += angle < limit ? 1 : 0;
  }
  EXPECT_EQ(paper["domain"]["scored_pixels"].GetDouble(), reached);
  EXPECT_EQ(paper["domain"]["unrepresentable_pixels"].GetDouble(), ahead - reached);
}

TEST_F(Evaluate, RmseIsThatOfThePaper) {
  EXPECT_TRUE(Printed{"0.2613"}.may_be(polynomials()["rows"][0]["rmse"].GetDouble()));
  EXPECT_TRUE(Printed{"0.1148"}.may_be(polynomials()["rows"][1]["rmse"].GetDouble()));
  EXPECT_EQ(polynomials()["rows"][0]["polynomial"]["a0"].GetDouble(), 131.46);
  for (std::size_t k = 0; k < kPapersPolynomial.size(); ++k) {
    const std::string name = "a" + std::to_string(k);
    EXPECT_EQ(polynomials()["rows"][1]["polynomial"][name.c_str()].GetDouble(), kPapersPolynomial[k].value());
  }
}

// Figure 2. The duration is that of a run; what a fit finds does not depend on it.
TEST_F(Evaluate, NumberOfSamplesIsSwept) {
  const Json& sweeps = (*document_)["samples"];
  ASSERT_EQ(sweeps.Size(), 12U);
  for (const Json& sweep : sweeps.GetArray()) {
    const std::string name = std::string(sweep["from"].GetString()) + "-" + sweep["to"].GetString();
    SCOPED_TRACE(name);
    const Json& whole = row(name);
    int before = 0;
    for (const Json& point : sweep["points"].GetArray()) {
      const int asked = point["samples_asked"].GetInt();
      EXPECT_GT(asked, before);
      EXPECT_GT(point["samples"].GetInt(), asked / 2);  // those outside of the lens are none
      EXPECT_GT(point["time_us"].GetDouble(), 0.0);
      before = asked;
      if (asked < 300) continue;
      EXPECT_LE(point["rms_px"].GetDouble(), 1.01 * whole["error_px"]["rms"].GetDouble() + 1e-6);
      EXPECT_NEAR(point["parameter_error"].GetDouble(), whole["parameter_error"].GetDouble(),
                  0.02 * whole["parameter_error"].GetDouble());
    }
    EXPECT_EQ(before, 10'000);
  }
}

// In place of Table 4: EUCM of TUM VI's camera, whose optimum is known (tests/lib/convert/floors.h).
TEST_F(Evaluate, SlamIsNotReproducedAndItsConversionIsProven) {
  constexpr double kOptimum = 0.0226;
  const Json& slam = (*document_)["slam"];
  EXPECT_FALSE(slam["reproduced"].GetBool());
  EXPECT_NEAR(slam["rms_px"].GetDouble(), kOptimum, 0.005 * kOptimum + 5e-5);
  EXPECT_LE(slam["rms_px"].GetDouble(), slam["max_px"].GetDouble());
  ASSERT_TRUE(slam["bound_px"].IsNumber());
  EXPECT_LE(slam["max_px"].GetDouble(), slam["bound_px"].GetDouble());
  // It names the experiment that is the table's counterpart, and that exists.
  const std::string counterpart = "examples/openvins_simulation";
  EXPECT_TRUE(contains(slam["why"].GetString(), counterpart));
  EXPECT_TRUE(fs::exists(fs::path(FCA_EXAMPLES_DIR).parent_path() / counterpart / "results.csv"));
}

TEST(EvaluateText, HasEveryRowWithThePapersFiguresAndOneReasonEach) {
  const RunResult run = run_program({"evaluate"}, {.limit_seconds = 300.0});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  for (const PaperRow& paper : kTables1And2) {
    int lines = 0;
    std::istringstream stream(run.out);
    for (std::string line; std::getline(stream, line);) {
      std::istringstream words(line);
      std::string name;
      std::string error;
      words >> name >> error;
      if (name != paper.name || std::strtod(error.c_str(), nullptr) != paper.reprojection_error.value()) continue;
      ++lines;
    }
    EXPECT_EQ(lines, 1) << paper.name;
  }
}

/// A grey image (PGM) with edges in all directions.
std::string rings_and_stripes(int width, int height) {
  std::string bytes = "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const double ring = std::sin(std::hypot(u - 300.0, v - 200.0) / 4.0);
      bytes += static_cast<char>(std::lround(120.0 + 60.0 * ring + 50.0 * std::sin(u / 9.0 + v / 5.0)));
    }
  }
  return bytes;
}

/// The grey levels of such an image.
std::vector<double> greys_of(const std::string& pgm, const Size& size) {
  std::vector<double> greys;
  const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  for (const char sample : pgm.substr(pgm.size() - pixels)) greys.push_back(static_cast<unsigned char>(sample));
  return greys;
}

/// Lanczos of 8 x 8 pixels from its definition; nothing where the window reaches beyond the image.
std::optional<double> lanczos(const std::vector<double>& greys, const Size& size, const Point2& place) {
  const auto sinc = [](double x) { return x == 0.0 ? 1.0 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x); };
  const int u0 = static_cast<int>(std::floor(place.u)) - 3;
  const int v0 = static_cast<int>(std::floor(place.v)) - 3;
  if (u0 < 0 || v0 < 0 || u0 + 8 > size.width || v0 + 8 > size.height) return std::nullopt;
  std::array<double, 8> along_u{};
  std::array<double, 8> along_v{};
  for (std::size_t i = 0; i < 8; ++i) {
    const double x = place.u - u0 - static_cast<double>(i);
    const double y = place.v - v0 - static_cast<double>(i);
    along_u.at(i) = sinc(x) * sinc(x / 4.0);
    along_v.at(i) = sinc(y) * sinc(y / 4.0);
  }
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t row = 0; row < 8; ++row) {
    const std::size_t first =
        (static_cast<std::size_t>(v0) + row) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(u0);
    for (std::size_t column = 0; column < 8; ++column) {
      const double weight = along_u.at(column) * along_v.at(row);
      sum += weight * greys[first + column];
      weights += weight;
    }
  }
  return sum / weights;
}

/// Of the image that the target would have taken, next to the image that the source took.
struct Loss {
  double mean_square = 0.0;
  double compared = 0.0;
};

Loss loss_of(const std::vector<double>& greys, const Size& size, const PrintedCamera& source, const PrintedCamera& target) {
  Loss loss;
  int compared = 0;
  for (const Point2& pixel : every_pixel(size)) {
    const Point3 ray = ray_of(target, pixel);
    // Beyond radtan's fold no ray has the pixel, and the fixed point stops anywhere.
    if (!(distance(pixel_of(target, ray), pixel) < 1e-6)) continue;
    const std::optional<double> seen = lanczos(greys, size, pixel_of(source, ray));
    if (!seen) continue;
    const std::size_t at =
        static_cast<std::size_t>(pixel.v) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(pixel.u);
    const double difference = static_cast<double>(static_cast<float>(*seen)) - greys[at];
    loss.mean_square += difference * difference;
    ++compared;
  }
  loss.mean_square /= compared;
  loss.compared = static_cast<double>(compared) / static_cast<double>(greys.size());
  return loss;
}

class EvaluateImage : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const TemporaryFolder folder;
    const RunResult run =
        run_program({"evaluate", "--image", folder.write("seen.pgm", kImage), "--json"}, {.limit_seconds = 300.0});
    ASSERT_EQ(run.code, 0) << run.err;
    document_ = std::make_unique<rapidjson::Document>();
    document_->Parse<rapidjson::kParseFullPrecisionFlag>(run.out.c_str());
    ASSERT_FALSE(document_->HasParseError()) << run.out;
  }
  static void TearDownTestSuite() { document_.reset(); }

  static const std::string kImage;
  static std::unique_ptr<rapidjson::Document> document_;
};
const std::string EvaluateImage::kImage = rings_and_stripes(752, 480);
std::unique_ptr<rapidjson::Document> EvaluateImage::document_;

// Also where two models hardly differ: nothing but what they differ by is lost.
TEST_F(EvaluateImage, LosesWhatTheModelsDifferBy) {
  int rows = 0;
  const Json& table = (*document_)["conversions"][0];
  const Size size = size_in(table);
  const std::vector<double> greys = greys_of(kImage, size);
  for (const Json& row : table["rows"].GetArray()) {
    SCOPED_TRACE(std::string(row["from"].GetString()) + "-" + row["to"].GetString());
    const Loss loss = loss_of(greys, size, camera_in(row["source"]), camera_in(row["target"]));
    const Json& recovered = row["recovered_image"];
    ASSERT_TRUE(recovered["psnr_db"].IsNumber());
    // 1e-4 of the mean square: places are known to 1e-12 px, and no two of these models agree to better than 1e-6.
    EXPECT_NEAR(recovered["psnr_db"].GetDouble(), 10.0 * std::log10(255.0 * 255.0 / loss.mean_square), 4.4e-4);
    EXPECT_NEAR(recovered["compared_share"].GetDouble(), loss.compared, 1e-12);
    ++rows;
  }
  EXPECT_EQ(rows, 12);
}

TEST_F(EvaluateImage, LosesMoreWhereModelsDifferMore) {
  for (const Json& table : (*document_)["conversions"].GetArray()) {
    std::vector<std::array<double, 2>> rows;  // mean error, PSNR
    for (const Json& row : table["rows"].GetArray()) {
      const Json& recovered = row["recovered_image"];
      const bool identical = recovered["identical"].GetBool();
      EXPECT_EQ(identical, recovered["psnr_db"].IsNull());
      const double psnr = identical ? 1e9 : recovered["psnr_db"].GetDouble();
      EXPECT_GT(psnr, 10.0);
      EXPECT_GT(recovered["ssim"].GetDouble(), 0.3);
      EXPECT_LE(recovered["ssim"].GetDouble(), 1.0 + 1e-12);
      EXPECT_GT(recovered["compared_share"].GetDouble(), 0.5);
      EXPECT_GT(row["paper"]["psnr_db"].GetDouble(), 20.0);
      rows.push_back({row["error_px"]["mean"].GetDouble(), psnr});
    }
    for (const auto& [error, psnr] : rows) {
      for (const auto& [larger_error, lower_psnr] : rows) {
        if (larger_error <= 5.0 * error) continue;
        EXPECT_LE(lower_psnr, psnr) << larger_error << " " << error;
      }
    }
  }
}

/// What the paper's program paints, from ERRATA's description: column by column, discs of 5 pixels at the place without its
/// decimals, in the colour that the image has there. Black is 0.
std::vector<double> painted(const std::vector<double>& greys, const Size& size,
                            const std::function<Point2(const Point2&)>& place) {
  std::vector<double> canvas(greys.size(), 0.0);
  for (int u = 0; u < size.width; ++u) {
    for (int v = 0; v < size.height; ++v) {
      const Point2 to = place({static_cast<double>(u), static_cast<double>(v)});
      if (!(to.u >= -0.5 && to.u < size.width - 0.5 && to.v >= -0.5 && to.v < size.height - 0.5)) continue;
      const int x = static_cast<int>(to.u);
      const int y = static_cast<int>(to.v);
      const double colour = greys[static_cast<std::size_t>(y * size.width + x)];
      for (const auto& [i, j] :
           {std::pair(x, y), std::pair(x - 1, y), std::pair(x + 1, y), std::pair(x, y - 1), std::pair(x, y + 1)}) {
        if (i >= 0 && i < size.width && j >= 0 && j < size.height)
          canvas[static_cast<std::size_t>(j * size.width + i)] = colour;
      }
    }
  }
  return canvas;
}

TEST_F(EvaluateImage, PaintsAsThePapersProgram) {
  const Json& table = (*document_)["conversions"][0];
  const Size size = size_in(table);
  const std::vector<double> greys = greys_of(kImage, size);
  const std::vector<double> original = painted(greys, size, [](const Point2& pixel) { return pixel; });
  for (const Json& row : table["rows"].GetArray()) {
    SCOPED_TRACE(std::string(row["from"].GetString()) + "-" + row["to"].GetString());
    const PrintedCamera source = camera_in(row["source"]);
    const PrintedCamera target = camera_in(row["target"]);
    const std::vector<double> after =
        painted(greys, size, [&](const Point2& pixel) { return pixel_of(target, ray_of(source, pixel)); });
    double squares = 0.0;
    int lit = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (after[i] == 0.0 || original[i] == 0.0) continue;
      squares += (after[i] - original[i]) * (after[i] - original[i]);
      ++lit;
    }
    const Json& printed = row["painted_image"];
    // Where a place is a whole number but for rounding, two computations cut it to either side.
    EXPECT_NEAR(printed["psnr_db"].GetDouble(), 10.0 * std::log10(255.0 * 255.0 * lit / squares), 0.02);
    EXPECT_GT(printed["ssim"].GetDouble(), 0.0);
    EXPECT_LT(printed["ssim"].GetDouble(), 1.0);
  }
}

// It does not see what a conversion loses: a millionth of a millionth of the image's width costs more than a pixel does.
TEST_F(EvaluateImage, PaintingSeesNoiseAndNoDisplacement) {
  const Json& table = (*document_)["conversions"][0];
  for (const Json& row : table["rows"].GetArray()) {
    if (row["error_px"]["rms"].GetDouble() > 1.0) {
      EXPECT_GT(row["painted_image"]["psnr_db"].GetDouble(), table["painted_noise"]["psnr_db"].GetDouble());
      EXPECT_GT(row["painted_image"]["psnr_db"].GetDouble(), row["recovered_image"]["psnr_db"].GetDouble());
    }
  }
}

TEST_F(EvaluateImage, IsShownOnAPage) {
  const TemporaryFolder folder;
  const std::string image = folder.write("seen.pgm", kImage);
  const std::string page = folder / "figures.html";
  const RunOptions patient{.limit_seconds = 300.0};
  ASSERT_EQ(run_program({"evaluate", "--image", image, "-o", page}, patient).code, 0);
  const std::string html = read_file(page);
  const auto count = [&html](const std::string& word) {
    int found = 0;
    for (std::size_t at = html.find(word); at != std::string::npos; at = html.find(word, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("data:image/png;base64,"), 2 * 4);  // KB to EUCM, DS, RT and OCC
  EXPECT_EQ(count("<svg class=\"chart\""), 3 * 4);    // by source
  EXPECT_EQ(run_program({"evaluate", "-o", page}, patient).code, 4);
  EXPECT_EQ(run_program({"evaluate", "-o", page, "--force"}, patient).code, 0);
  EXPECT_EQ(run_program({"evaluate", "--image", image, "-o", image, "--force"}, patient).code, 3);
  EXPECT_EQ(run_program({"evaluate", "-o", "-", "--json"}).code, 3);
}

TEST_F(EvaluateImage, IsSaidInWords) {
  const TemporaryFolder folder;
  const RunResult run = run_program({"evaluate", "--image", folder.write("seen.pgm", kImage)}, {.limit_seconds = 300.0});
  EXPECT_TRUE(contains(run.out, "PSNR dB")) << run.err;
}

TEST_F(EvaluateImage, RefusesWhatIsNoImageOfThePapersCameras) {
  const TemporaryFolder folder;
  const RunResult other = run_program({"evaluate", "--image", folder.write("small.pgm", rings_and_stripes(640, 480))});
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(says(other.err, "image-size", "752 x 480")) << other.err;
  EXPECT_EQ(run_program({"evaluate", "--image", folder.write("text.pgm", "no image")}).code, 2);
  EXPECT_EQ(run_program({"evaluate", "--image", folder / "missing.png"}).code, 4);
}

TEST(EvaluateText, ReadsNoFile) { EXPECT_EQ(run_program({"evaluate", "camchain.yaml"}).code, 3); }

}  // namespace
}  // namespace fca::test
