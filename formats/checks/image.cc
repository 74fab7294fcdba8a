// SPDX-License-Identifier: BSD-3-Clause
#include "topics.h"

#include <fca/formats/text/numbers.h>

#include <cmath>

namespace fca::checks {

namespace {

std::string at(double u, double v) { return "(" + text::format_short(u, 5) + ", " + text::format_short(v, 5) + ")"; }

std::string size_of(const ImageSize& size) { return std::to_string(size.width) + " x " + std::to_string(size.height); }

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

  void add(Severity severity, std::string code, std::string message, std::string fix, const SourceRange& where) {
    findings_.add({severity, std::move(code), camera_.name + ": " + std::move(message), {}, std::move(fix), where});
  }

  /// Width and height, or the two numbers of the centre, the other way round.
  bool check_swapped() {
    constexpr double kNear = 0.1;
    constexpr double kFar = 0.2;
    const bool fits_swapped = off(u_, size_.height) < kNear && off(v_, size_.width) < kNear;
    const bool far = off(u_, size_.width) > kFar && off(v_, size_.height) > kFar;
    if (!fits_swapped || !far) return false;
    if (subject_.is("ocamcalib")) return true;  // its reader says so, at the centre
    add(Severity::kError, "size-swapped",
        "the principal point " + at(u_, v_) + " is the middle of a " + size_of({size_.height, size_.width}) +
            " image, not of one of " + size_of(size_),
        "exchange width and height, or the two numbers of the principal point", subject_.places.image_width(camera_));
    return true;
  }

  /// Numbers of one resolution beside the size of another: the centre is off by the same factor along both sides.
  bool check_scaled() {
    const double across = u_ / (0.5 * (size_.width - 1));
    const double down = v_ / (0.5 * (size_.height - 1));
    constexpr double kSame = 0.08;
    constexpr double kFarFromOne = 0.3;
    if (!(across > 0.0 && down > 0.0) || !std::isfinite(across + down) || std::abs(across / down - 1.0) > kSame ||
        std::abs(across - 1.0) < kFarFromOne)
      return false;
    const double factor = 0.5 * (across + down);
    add(Severity::kError, "size-unlike-centre",
        "the principal point " + at(u_, v_) + " is the middle of an image " + text::format_short(factor, 3) +
            " times as large as " + size_of(size_),
        "write the size of the images that were calibrated, or scale the intrinsics to this size",
        subject_.places.image_width(camera_));
    return true;
  }

  void check_centre() {
    const double worst = std::max(off(u_, size_.width), off(v_, size_.height));
    constexpr double kFar = 0.3;
    if (worst <= kFar) return;
    const bool outside = worst > 1.0;
    const bool by_column = off(u_, size_.width) >= off(v_, size_.height);
    add(outside ? Severity::kError : Severity::kWarning, outside ? "centre-outside" : "centre-off",
        "the principal point " + at(u_, v_) + (outside ? " lies outside the " : " is far from the middle of the ") +
            size_of(size_) + " image",
        outside ? "a crop moves it by the crop's corner; an exchange of numbers or another resolution is more likely"
                : "right for a cropped image; else another resolution's numbers, or a poor calibration",
        subject_.places.parameter(camera_, by_column ? ParameterId("cx") : ParameterId("cy")));
  }

  void check_focal_lengths() {
    const auto [f_u, f_v] = central_focal_lengths(camera_.model);
    constexpr double kPixelsOfAny = 0.05;  // of the width: 170 deg and more of an equidistant lens
    constexpr double kLongest = 20.0;      // 3 deg across the image
    const double relative = f_u / size_.width;
    if (relative < kPixelsOfAny || relative > kLongest) {
      add(Severity::kError, "focal-length-not-in-pixels",
          "the focal length " + text::format_short(f_u, 5) + " px does not belong to an image of " +
              std::to_string(size_.width) + " columns",
          relative < kPixelsOfAny
              ? "it is in pixels: millimetres divided by the pixel pitch, or a normalised one times the width"
              : "check it and the image size",
          subject_.places.parameter(camera_, "fx"));
      return;
    }
    constexpr double kSquarePixels = 0.05;
    if (std::abs(f_u / f_v - 1.0) <= kSquarePixels) return;
    add(Severity::kWarning, "focal-lengths-differ",
        "the focal lengths " + text::format_short(f_u, 6) + " and " + text::format_short(f_v, 6) + " px differ by " +
            text::format_short(100.0 * std::abs(f_u / f_v - 1.0), 3) + " %",
        "right for pixels that are not square; else compare both with the calibration's result",
        subject_.places.parameter(camera_, "fy"));
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
  for (const Camera& camera : subject.rig().cameras) {
    if (!camera.image_size) {
      findings.undecided("folds-inside-image", camera.name + ": principal point, field of view and folding",
                         "no image size in the file: give --size WxH");
      continue;
    }
    const std::optional<ImageSize>& told = subject.options.reading.image_size;
    if (told && *told != *camera.image_size) {
      findings.add(
          {Severity::kError,
           "size-contradicts",
           camera.name + " has " + size_of(*camera.image_size) + " px in the file, and " + size_of(*told) + " was told",
           {},
           "--size is for files that state no size",
           subject.places.image_width(camera)});
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
