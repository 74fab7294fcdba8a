// SPDX-License-Identifier: BSD-3-Clause
#include "topics.h"

#include <fca/code.h>

#include <algorithm>
#include <cmath>

namespace fca::checks {

namespace {

class ImageCheck {
 public:
  ImageCheck(const Subject& subject, const Camera& camera, Findings& findings)
      : subject_(subject), camera_(camera), findings_(findings), size_(*camera.image_size) {
    const Pixel centre = principal_point(camera.model);
    u_ = centre[0];
    v_ = centre[1];
  }

  void run() {
    if (!check_swapped() && !check_scaled()) check_centre();
    check_focal_lengths();
  }

 private:
  /// Distance from the middle of the image in halves of its sides: 1 is the border.
  static double off(double place, int side) { return std::abs(place - 0.5 * (side - 1)) / (0.5 * side); }

  /// Width and height, or the two numbers of the centre, the other way round.
  bool check_swapped() {
    constexpr double kNear = 0.1;
    constexpr double kFar = 0.2;  // one of them; the other at least `kNear`
    const bool fits_swapped = off(u_, size_.height) < kNear && off(v_, size_.width) < kNear;
    const auto [less, more] = std::minmax({off(u_, size_.width), off(v_, size_.height)});
    const bool far = less > kNear && more > kFar;
    if (!fits_swapped || !far) return false;
    if (subject_.is("ocamcalib")) return true;  // its reader says so, at the centre
    findings_.add(Code::kSizeSwapped, {camera_.name, u_, v_, size_.width, size_.height}, subject_.places.image_width(camera_));
    return true;
  }

  /// Numbers of one resolution next to the size of another: the centre is off by the same factor along both sides.
  bool check_scaled() {
    const double across = u_ / (0.5 * (size_.width - 1));
    const double down = v_ / (0.5 * (size_.height - 1));
    constexpr double kSame = 0.08;
    constexpr double kFarFromOne = 0.3;
    if (!(across > 0.0 && down > 0.0) || !std::isfinite(across + down) || std::abs(across / down - 1.0) > kSame ||
        std::abs(across - 1.0) < kFarFromOne)
      return false;
    const double factor = 0.5 * (across + down);
    findings_.add(Code::kSizeUnlikeCentre, {camera_.name, u_, v_, size_.width, size_.height, factor},
                  subject_.places.image_width(camera_));
    return true;
  }

  void check_centre() {
    const double worst = std::max(off(u_, size_.width), off(v_, size_.height));
    constexpr double kFar = 0.3;
    if (worst <= kFar) return;
    const bool outside = worst > 1.0;
    const bool by_column = off(u_, size_.width) >= off(v_, size_.height);
    findings_.add(outside ? Code::kCentreOutsideImage : Code::kCentreOff, {camera_.name, u_, v_, size_.width, size_.height},
                  subject_.places.parameter(camera_, by_column ? ParameterId("cx") : ParameterId("cy")));
  }

  void check_focal_lengths() {
    const auto [f_u, f_v] = central_focal_lengths(camera_.model);
    constexpr double kPixelsOfAny = 0.05;  // of the width: 170 deg and more of an equidistant lens
    constexpr double kLongest = 20.0;      // 3 deg across the image
    const double relative = f_u / size_.width;
    if (relative < kPixelsOfAny || relative > kLongest) {
      const Code code = relative < kPixelsOfAny ? Code::kFocalLengthTooShort : Code::kFocalLengthTooLong;
      findings_.add(code, {camera_.name, f_u, size_.width}, subject_.places.parameter(camera_, "fx"));
      return;
    }
    constexpr double kSquarePixels = 0.05;
    constexpr double kAnySensor = 4.0;  // no sensor's pixels are so many times longer than wide
    if (std::abs(f_u / f_v - 1.0) <= kSquarePixels) return;
    const bool absurd = std::max(f_u / f_v, f_v / f_u) > kAnySensor;
    findings_.add(absurd ? Severity::kError : Severity::kWarning, Code::kFocalLengthsUnlike,
                  {camera_.name, f_u, f_v, 100.0 * std::abs(f_u / f_v - 1.0)}, subject_.places.parameter(camera_, "fy"));
  }

  const Subject& subject_;
  const Camera& camera_;
  Findings& findings_;
  ImageSize size_;
  double u_ = 0.0;
  double v_ = 0.0;
};

}  // namespace

bool check_image(const Subject& subject, Findings& findings) {
  bool any = false;
  const std::optional<ImageSize>& told = subject.options.reading.image_size;
  const std::vector<Camera>& cameras = subject.rig().cameras;
  // Of several cameras those whose size is specified may have another one.
  const bool is_told_of_one = std::ranges::find(cameras, told, &Camera::image_size) != cameras.end();
  for (const Camera& camera : cameras) {
    if (!camera.image_size) {
      findings.undecided(Code::kImageNotEvaluated, {camera.name});
      continue;
    }
    if (told && !is_told_of_one) {
      findings.add(Code::kSizeGivenDiffers,
                   {camera.name, camera.image_size->width, camera.image_size->height, told->width, told->height},
                   subject.places.image_width(camera));
    }
    // Of a part of an image, or a binned one, nothing can be expected that does not hold of the whole.
    const auto as_stated = subject.calibration.format->as_stated;
    const std::optional<Camera> whole = as_stated != nullptr ? as_stated(subject.document, camera) : std::nullopt;
    ImageCheck(subject, whole ? *whole : camera, findings).run();
    any = true;
  }
  return any;
}

}  // namespace fca::checks
