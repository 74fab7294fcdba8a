// SPDX-License-Identifier: BSD-3-Clause
// DSO (and DM-VIO, which TUM-VI's sequences are read with): camera.txt. From JakobEngel/dso@1469e1e, src/util/Undistort.cpp:
// getUndistorterForFile, readFromFile and the distortCoordinates of each model, in float. The camera is that of the images as
// recorded; DSO works on what it computes from them by the lines 3 and 4.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "fca/code.h"
#include "programs.h"

namespace fca::consumers {
namespace {

constexpr std::size_t kMaxBytes = 2U << 20U;
constexpr std::size_t kMaxLine = 4096;  // sscanf measures its whole argument each time

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;

enum class Lens { kPinhole, kFov, kRadTan, kEquidistant, kKannalaBrandt };

std::string_view name_of(Lens lens) {
  switch (lens) {
    case Lens::kPinhole:
      break;
    case Lens::kFov:
      return "FOV";
    case Lens::kRadTan:
      return "RadTan";
    case Lens::kEquidistant:
      return "EquiDistant";
    case Lens::kKannalaBrandt:
      return "KannalaBrandt";
  }
  return "Pinhole";
}

struct DsoModel {
  Lens lens = Lens::kPinhole;
  std::array<double, 8> p{};  ///< fx fy cx cy and what the lens has; parsOrg
  int width = 0, height = 0;
};

struct Lines {
  std::array<std::string, 4> line;
};

Lines lines_of(std::string_view bytes) {
  Lines lines;
  std::istringstream stream{std::string(bytes)};
  for (std::string& line : lines.line) std::getline(stream, line);
  return lines;
}

/// How many numbers sscanf finds. The program's patterns begin with a name and a blank, which matches any blanks or none.
int scan(const char* text, std::array<double, 8>& p) {
  return std::sscanf(text, "%lf %lf %lf %lf %lf %lf %lf %lf", p.data(), &p[1], &p[2], &p[3], &p[4], &p[5], &p[6], &p[7]);
}

/// The order of getUndistorterForFile: bare numbers first (8: RadTan; 5: FOV, or Pinhole if the fifth is 0), then names.
std::optional<Lens> choose_lens(const std::string& line, std::array<double, 8>& p) {
  const int bare = scan(line.c_str(), p);
  if (bare == 8) return Lens::kRadTan;
  if (bare >= 5) return p[4] == 0.0 ? Lens::kPinhole : Lens::kFov;
  struct Named {
    std::string_view name;
    Lens lens;
    int count;
  };
  constexpr std::array<Named, 5> kNamed = {{{"KannalaBrandt", Lens::kKannalaBrandt, 8},
                                            {"RadTan", Lens::kRadTan, 8},
                                            {"EquiDistant", Lens::kEquidistant, 8},
                                            {"FOV", Lens::kFov, 5},
                                            {"Pinhole", Lens::kPinhole, 5}}};
  for (const Named& named : kNamed) {
    p = {};
    if (!line.starts_with(named.name)) continue;
    if (scan(line.c_str() + named.name.size(), p) >= named.count) return named.lens;
  }
  return std::nullopt;
}

struct Factors {
  float x = 0.0F, y = 0.0F;
};

Factors radtan(const std::array<float, 4>& k, float x, float y) {
  const float x2 = x * x;
  const float y2 = y * y;
  const float xy = x * y;
  const float r2 = x2 + y2;
  const float radial = k[0] * r2 + k[1] * r2 * r2;
  return {static_cast<float>(x + x * radial + 2.0 * k[2] * xy + k[3] * (r2 + 2.0 * x2)),
          static_cast<float>(y + y * radial + 2.0 * k[3] * xy + k[2] * (r2 + 2.0 * y2))};
}

/// EquiDistant and KannalaBrandt: the same polynomial, other lines of code.
Factors equidistant(const std::array<float, 4>& k, float x, float y) {
  const float r = std::sqrt(x * x + y * y);
  const float theta = std::atan(r);
  const float theta2 = theta * theta;
  const float theta4 = theta2 * theta2;
  const float bent = theta * (1 + k[0] * theta2 + k[1] * theta4 + k[2] * theta4 * theta2 + k[3] * theta4 * theta4);
  constexpr float kOnAxis = 1e-8F;
  const float scaling = r > kOnAxis ? bent / r : 1.0F;
  return {x * scaling, y * scaling};
}

Factors fov(float omega, float x, float y) {
  const float r = std::sqrt(x * x + y * y);
  const float d2t = 2.0F * std::tan(omega / 2.0F);
  const float factor = r == 0.0F || omega == 0.0F ? 1.0F : std::atan(r * d2t) / (omega * r);
  return {x * factor, y * factor};
}

/// distortCoordinates for the pixel of a pinhole camera whose ray this is: only rays to the front have one.
std::optional<Pixel> distort(const DsoModel& model, const Ray& ray) {
  if (!(ray[2] > 0.0)) return std::nullopt;
  std::array<float, 8> p{};
  for (std::size_t i = 0; i < p.size(); ++i) p.at(i) = static_cast<float>(model.p.at(i));
  const std::array<float, 4> k = {p[4], p[5], p[6], p[7]};
  Factors point = {static_cast<float>(ray[0] / ray[2]), static_cast<float>(ray[1] / ray[2])};
  switch (model.lens) {
    case Lens::kPinhole:
      break;
    case Lens::kFov:
      point = fov(p[4], point.x, point.y);
      break;
    case Lens::kRadTan:
      point = radtan(k, point.x, point.y);
      break;
    case Lens::kEquidistant:
    case Lens::kKannalaBrandt:
      point = equidistant(k, point.x, point.y);
      break;
  }
  const float u = p[0] * point.x + p[2];
  const float v = p[1] * point.y + p[3];
  if (!std::isfinite(u) || !std::isfinite(v)) return std::nullopt;
  return Pixel{u, v};
}

/// Largest distance from the undistorted pixel, over rays whose pinhole pixel is in the image.
double cost_of_no_rectification(const DsoModel& model) {
  constexpr int kSteps = 40;
  double worst = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Pixel pixel = {(model.width - 1.0) * i / kSteps, (model.height - 1.0) * j / kSteps};
      const auto bent = distort(model, {(pixel[0] - model.p[2]) / model.p[0], (pixel[1] - model.p[3]) / model.p[1], 1.0});
      if (bent) worst = std::max(worst, std::hypot((*bent)[0] - pixel[0], (*bent)[1] - pixel[1]));
    }
  }
  return worst;
}

std::string shown(const std::string& line) {
  std::string text = "\"";
  for (const char c : line.substr(0, 60)) {
    if (c == '\r') {
      text += "\\r";
    } else {
      text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return text + "\"";
}

class Reader {
 public:
  explicit Reader(ConsumerView& view) : view_(view) {}

  void run(std::string_view bytes) {
    lines_ = lines_of(bytes).line;
    for (const std::string& line : lines_) {
      if (line.size() > kMaxLine) return refuse(Code::kDsoLineTooLong);
    }
    const std::optional<Lens> lens = choose_lens(lines_[0], model_.p);
    if (!lens) {
      return refuse(Code::kDsoUnknownLens, {shown(lines_[0])});
    }
    model_.lens = *lens;
    if (!read_size(lines_[1], model_.width, model_.height, 2, "image")) return;
    for (const double value : model_.p) {
      if (!std::isfinite(value)) return refuse(Code::kDsoNumberNotFinite);
    }
    make_absolute();
    if (model_.lens == Lens::kPinhole && model_.p[4] != 0.0) warn(Code::kDsoFifthNumberIgnored);
    read_output();
  }

 private:
  /// The file has lines and no keys.
  void refuse(Code code, std::vector<Argument> arguments = {}) { view_.refusals.emplace_back(code, "", std::move(arguments)); }
  void warn(Code code, std::vector<Argument> arguments = {}) { view_.warnings.emplace_back(code, "", std::move(arguments)); }

  bool read_size(const std::string& line, int& width, int& height, int number, std::string_view whose) {
    constexpr int kMaxSide = 1 << 15;
    const bool found = std::sscanf(line.c_str(), "%d %d", &width, &height) == 2;
    if (found && width > 0 && height > 0 && width <= kMaxSide && height <= kMaxSide) return true;
    refuse(Code::kDsoSizeNotRead, {number, whose, shown(line)});
    return false;
  }

  /// The relative form is known by the centre alone: cx < 1 and cy < 1.
  void make_absolute() {
    auto& p = model_.p;
    if (!(p[2] < 1.0 && p[3] < 1.0)) {
      if (p[0] < 1.0 || p[1] < 1.0 || p[2] < 1.0 || p[3] < 1.0) warn(Code::kDsoPixelsBelowOne);
      return;
    }
    if (p[0] > 10.0 || p[1] > 10.0) warn(Code::kDsoSharesByCentre);
    p[0] *= model_.width;
    p[1] *= model_.height;
    p[2] = p[2] * model_.width - 0.5;
    p[3] = p[3] * model_.height - 0.5;
  }

  void read_output() {
    const std::string& mode = lines_[2];
    std::array<float, 5> output{};
    const bool explicit_output =
        std::sscanf(mode.c_str(), "%f %f %f %f %f", output.data(), &output[1], &output[2], &output[3], &output[4]) == 5;
    if (mode != "crop" && mode != "none" && mode != "full" && !explicit_output) {
      return refuse(Code::kDsoOutputUnknown, {shown(mode)});
    }
    if (mode == "full") return refuse(Code::kDsoFullUnfinished);
    int width = 0;
    int height = 0;
    if (!read_size(lines_[3], width, height, 4, "output")) return;
    if (mode == "none" && (width != model_.width || height != model_.height)) return refuse(Code::kDsoSizesDiffer);
    if (explicit_output && (output[2] > 1.0F || output[3] > 1.0F)) warn(Code::kDsoOutputShares);
    add_camera(mode == "none");
  }

  /// With "none" DSO passes the images through and calls them pinhole images, whatever the lens is.
  void add_camera(bool passes_through) {
    ConsumerCamera camera;
    camera.name = "cam0";
    camera.width = model_.width;
    camera.height = model_.height;
    if (passes_through) {
      const double cost = cost_of_no_rectification(model_);
      constexpr double kFloatNoise = 1e-3;
      camera.misread = cost > kFloatNoise;
      if (camera.misread) warn(Code::kDsoNotRectified, {cost});
      model_.lens = Lens::kPinhole;
    }
    camera.model = name_of(model_.lens);
    camera.project = [model = model_](const Ray& ray) { return distort(model, ray); };
    view_.cameras.push_back(std::move(camera));
  }

  ConsumerView& view_;
  std::array<std::string, 4> lines_;
  DsoModel model_;
};

}  // namespace

ConsumerView load_dso(std::string_view bytes, const LoadOptions& /*options*/) {
  ConsumerView view;
  if (bytes.empty() || bytes.size() > kMaxBytes) {
    view.refusals.emplace_back(bytes.empty() ? Code::kProgramFileEmpty : Code::kProgramFileTooLarge, "");
    return view;
  }
  Reader(view).run(bytes);
  return view;
}

}  // namespace fca::consumers
