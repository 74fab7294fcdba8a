// SPDX-License-Identifier: BSD-3-Clause
#include "lens_circles.h"

#include "image_file.h"
#include "image_planes.h"
#include "words.h"

#include <fca/formats/text/source.h>
#include <fca/rig/lit_circle.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fca::cli {

namespace {

struct SampleImages {
  Camera* camera = nullptr;
  std::vector<std::string> paths;
};

/// Whose images they are; nothing with an error.
std::optional<std::vector<SampleImages>> by_camera(const std::vector<std::string>& asked, Rig& rig, Diagnostics& diagnostics) {
  std::vector<SampleImages> result;
  std::vector<std::string> names;
  for (const Camera& camera : rig.cameras) names.push_back(camera.name);
  for (const std::string& each : asked) {
    const std::size_t equals = each.find('=');
    const std::string name = equals == std::string::npos ? "" : each.substr(0, equals);
    auto camera = std::ranges::find(rig.cameras, name, &Camera::name);
    const bool named = equals != std::string::npos && camera != rig.cameras.end();
    if (!named && rig.cameras.size() == 1) camera = rig.cameras.begin();
    if (camera == rig.cameras.end()) {
      diagnostics.error(
          "lens-circle-of-none", "--lens-circle " + each + " does not say of which camera the image is", {},
          "there are " + enumerated(names, "and") + ": --lens-circle " + (names.empty() ? "CAMERA" : names.front()) + "=IMAGE");
      return std::nullopt;
    }
    auto found = std::ranges::find(result, &*camera, &SampleImages::camera);
    if (found == result.end()) found = result.insert(result.end(), {&*camera, {}});
    found->paths.push_back(named ? each.substr(equals + 1) : each);
  }
  return result;
}

std::string in_words(const LensCircle& circle, const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  names.reserve(paths.size());
  for (const std::string& path : paths) names.push_back(std::filesystem::path(path).filename().string());
  constexpr std::size_t kFew = 3;
  const std::string images = names.size() <= kFew ? enumerated(names, "and") : counted(names.size(), "image");
  return "the lit circle of " + text::printable(images) + ": centre (" + fixed(circle.centre[0], 1) + ", " +
         fixed(circle.centre[1], 1) + "), radius " + fixed(circle.radius_px, 1) + " px, " + percent(circle.rim_share) +
         " of its rim seen, rms " + pixels(circle.rms_px) + " px";
}

/// A lamp in a dark room is a lit circle, too, and so is the glow around a lens: what speaks against the one that was found.
void warn_of_doubts(const Camera& camera, const std::string& path, Diagnostics& diagnostics) {
  constexpr double kOffCentre = 0.1;  // of the radius
  constexpr double kHalf = 0.5;
  const LensCircle& circle = *camera.lens_circle;
  const Pixel axis = principal_point(camera.model);
  const double off = std::hypot(circle.centre[0] - axis[0], circle.centre[1] - axis[1]);
  if (off > kOffCentre * circle.radius_px) {
    diagnostics.warning(
        "lens-circle-off-centre",
        camera.name + ": the lit circle's centre is " + fixed(off, 1) +
            " px from the principal point; what lies dark within the largest angle on its rim counts as lens, too",
        {path, 0, 0}, "is it the lens, and not a lamp? fca-io report draws it; --max-angle DEG says it by hand");
  }
  if (circle.rim_share < kHalf) {
    diagnostics.warning("lens-circle-uncertain",
                        camera.name + ": only " + percent(circle.rim_share) + " of the lit circle's rim is seen", {path, 0, 0},
                        "further images of brighter scenes, each as --lens-circle; fca-io report draws it");
  }
}

bool add_circle(const SampleImages& sample, Diagnostics& diagnostics) {
  Camera& camera = *sample.camera;
  if (!camera.image_size) {
    diagnostics.error("image-size-missing", camera.name + ": the image size is not known", {}, "give it: --size WIDTHxHEIGHT");
    return false;
  }
  std::optional<GreyImage> seen;  // the brightest so far: many large images need not be held at once
  for (const std::string& path : sample.paths) {
    const std::optional<Image> image = read_image(path, diagnostics);
    if (!image || !has_size_of(camera, *image, path, diagnostics)) return false;
    std::vector<GreyImage> lights = planes(*image);  // a blue light is light, too
    if (seen) lights.push_back(*std::move(seen));
    seen = brightest(lights);
  }
  camera.lens_circle = find_lit_circle(*seen);
  if (camera.lens_circle) {
    camera.lens_circle->why = in_words(*camera.lens_circle, sample.paths);
    warn_of_doubts(camera, sample.paths.front(), diagnostics);
  } else {
    diagnostics.warning("no-lens-circle",
                        camera.name + ": " + (sample.paths.size() == 1 ? "the image shows" : "the images show") +
                            " no dark border around a lit circle; the whole image counts as lens",
                        {sample.paths.front(), 0, 0},
                        "images of a bright scene show it best, several together if need be; --max-angle DEG says it by hand");
  }
  return true;
}

}  // namespace

bool add_lens_circles(const std::vector<std::string>& asked, Rig& rig, Diagnostics& diagnostics) {
  const std::optional<std::vector<SampleImages>> samples = by_camera(asked, rig, diagnostics);
  return samples && std::ranges::all_of(*samples, [&](const SampleImages& each) { return add_circle(each, diagnostics); });
}

}  // namespace fca::cli
