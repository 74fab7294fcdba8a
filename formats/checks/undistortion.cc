// SPDX-License-Identifier: BSD-3-Clause
// cv::undistortPoints, which OpenCV's users, ORB-SLAM, ROS and OpenVINS call, makes five steps of an iteration and stops: near
// the corners of a wide lens it has not arrived, or walks away.
#include "../consumers/opencv_formulas.h"
#include "topics.h"

#include <fca/code.h>
#include <fca/formats/opencv_coefficients.h>

#include <array>
#include <cmath>

namespace fca::checks {

namespace {

namespace cv_formulas = consumers::opencv;

struct OpenCvCamera {
  cv_formulas::CameraMatrix K;
  cv_formulas::PinholeCoefficients k{};
};

std::optional<OpenCvCamera> as_opencv(const CameraModel& model) {
  const std::size_t count = opencv_count(model_info(model).id);
  if (count == 0) return std::nullopt;
  const auto value = [&model](ParameterId coefficient) { return parameter(model, coefficient).value(); };
  OpenCvCamera camera;
  camera.K = {value("fx"), value("fy"), value("cx"), value("cy"), 0.0};
  for (std::size_t i = 0; i < count; ++i) camera.k.at(i) = value(kOpenCvCoefficients.at(i));
  const bool is_tilted = camera.k.at(kPrismCount) != 0.0 || camera.k.at(kPrismCount + 1) != 0.0;
  if (is_tilted) return std::nullopt;  // which undistort_point() does not know
  return camera;
}

/// Where the program's ray of a pixel is imaged by the lens: how far from the pixel, in pixels.
double distance_after(const OpenCvCamera& camera, const Pixel& pixel, int steps) {
  const Pixel point = cv_formulas::undistort_point(camera.K, camera.k, pixel, steps);
  const Pixel again = cv_formulas::project_points(camera.K, camera.k, {point[0], point[1], 1.0});
  return std::hypot(again[0] - pixel[0], again[1] - pixel[1]);
}

struct WrongPixels {
  double worst_px = 0.0;    ///< Of all pixels that the lens has a ray for.
  double nearest_px = 0.0;  ///< From the principal point: the first that is off by more than the limit.
  bool any = false;
  bool diverges = false;  ///< More steps make it no better.
};

constexpr double kLimit = 1.0;

WrongPixels wrong_pixels_of(const OpenCvCamera& camera, const CameraModel& model, const ImageSize& size) {
  constexpr int kSteps = 32;
  constexpr int kOpenCvSteps = 5;
  constexpr int kManySteps = 100;
  WrongPixels wrong;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Pixel pixel = {(size.width - 1.0) * i / kSteps, (size.height - 1.0) * j / kSteps};
      if (!unproject(model, pixel)) continue;  // folds-inside-image says that
      const double distance = distance_after(camera, pixel, kOpenCvSteps);
      if (distance <= kLimit) continue;
      const double from_centre = std::hypot(pixel[0] - camera.K.cx, pixel[1] - camera.K.cy);
      if (!wrong.any || from_centre < wrong.nearest_px) wrong.nearest_px = from_centre;
      wrong.any = true;
      wrong.worst_px = std::isfinite(distance) ? std::max(wrong.worst_px, distance) : distance;
      wrong.diverges = wrong.diverges || !(distance_after(camera, pixel, kManySteps) <= kLimit);
    }
  }
  return wrong;
}

/// Nothing where it arrives.
std::optional<Message> problem_with(const Camera& camera, const OpenCvCamera& lens) {
  const WrongPixels wrong = wrong_pixels_of(lens, camera.model, *camera.image_size);
  if (!wrong.any) return std::nullopt;
  return Message{wrong.diverges ? Code::kUndistortionDiverges : Code::kUndistortionFewSteps,
                 {camera.name, wrong.worst_px, kLimit, wrong.nearest_px}};
}

}  // namespace

bool check_undistortion(const Subject& subject, Findings& findings) {
  // Numbers that are not believed for another reason are not of this lens.
  constexpr std::array kOtherReasons = {
      Code::kAnyCentreOff,          Code::kAnyCentreOutside, Code::kAnyEucmWithoutType, Code::kAnyFocalLengthNotInPixels,
      Code::kAnyFoldsInsideImage,   Code::kAnyOctal,         Code::kAnySizeSwapped,     Code::kAnySizeUnlikeCentre,
      Code::kAnyTangentialTooLarge, Code::kAnyWrongFamily};
  bool any = false;
  for (const Camera& camera : subject.rig().cameras) {
    const std::optional<OpenCvCamera> lens = as_opencv(camera.model);
    if (!lens || !camera.image_size || findings.has_any(kOtherReasons, subject.rig(), camera.name)) continue;
    if (const std::optional<Message> problem = problem_with(camera, *lens))
      findings.add(problem->code, problem->arguments, subject.places.parameter(camera, "k1"));
    any = true;
  }
  return any;
}

}  // namespace fca::checks

namespace fca {

std::optional<Message> undistortion_problem(const Camera& camera) {
  const std::optional<checks::OpenCvCamera> lens = checks::as_opencv(camera.model);
  return lens && camera.image_size ? checks::problem_with(camera, *lens) : std::nullopt;
}

}  // namespace fca
