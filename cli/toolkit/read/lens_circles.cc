// SPDX-License-Identifier: BSD-3-Clause
#include "lens_circles.h"

#include "image_planes.h"

#include <fca/code.h>
#include <fca/formats/text/source.h>
#include <fca/rig/image_circle.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace fca {

namespace {

struct SampleImages {
  Camera* camera = nullptr;
  std::vector<std::string> paths;
};

/// The image as the user typed it: "IMAGE" or "CAMERA=IMAGE"
std::string in_words(const CameraImage& image) { return image.camera.empty() ? image.path : image.camera + "=" + image.path; }

void refuse(const CameraImage& image, const Rig& rig, Diagnostics& diagnostics) {
  const std::string given = in_words(image);
  if (image.path.empty()) {
    diagnostics.add(Code::kCircleWithoutImage, {given});
    return;
  }
  std::vector<std::string> names;
  for (const Camera& camera : rig.cameras) names.push_back(camera.name);
  const std::string first = names.empty() ? "CAMERA" : names.front();
  if (names.empty()) names.emplace_back("none");
  diagnostics.add(image.camera.empty() ? Code::kCircleOfNoCamera : Code::kCircleOfUnknownCamera,
                  {given, names, first, image.camera});
}

/// The camera that took the image; null if it is not known.
Camera* camera_of(const CameraImage& image, Rig& rig) {
  if (image.camera.empty()) return rig.cameras.size() == 1 ? rig.cameras.data() : nullptr;
  const auto camera = std::ranges::find(rig.cameras, image.camera, &Camera::name);
  return camera != rig.cameras.end() ? &*camera : nullptr;
}

/// The images grouped by camera; nullopt, with an error, if an image has no known camera or no path.
std::optional<std::vector<SampleImages>> by_camera(const std::vector<CameraImage>& images, Rig& rig, Diagnostics& diagnostics) {
  std::vector<SampleImages> result;
  for (const CameraImage& image : images) {
    Camera* camera = camera_of(image, rig);
    if (camera == nullptr || image.path.empty()) {
      refuse(image, rig, diagnostics);
      return std::nullopt;
    }
    auto found = std::ranges::find(result, camera, &SampleImages::camera);
    if (found == result.end()) found = result.insert(result.end(), {camera, {}});
    if (std::ranges::find(found->paths, image.path) == found->paths.end()) found->paths.push_back(image.path);
  }
  return result;
}

Message named(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  names.reserve(paths.size());
  for (const std::string& path : paths) names.push_back(text::printable(std::filesystem::path(path).filename().string()));
  constexpr std::size_t kFew = 3;
  if (names.size() <= kFew) return {Code::kImagesByName, {names}};
  return {Code::kImagesByNumber, {names.size()}};
}

/// The images that show the circle on their own; all images if none does.
std::vector<std::string> witnesses(const ImageCircleSearch& search, const LensCircle& circle,
                                   const std::vector<std::string>& paths) {
  std::vector<std::string> result;
  for (const std::size_t image : search.showing(circle)) result.push_back(paths.at(image));
  return result.empty() ? paths : result;
}

/// Adds warnings if the circle may not be that of the lens. A lamp in a dark room is bright too, and so is the glow around a
/// lens.
void warn_of_doubts(const Camera& camera, const std::string& path, Diagnostics& diagnostics) {
  constexpr double kOffCentre = 0.1;  // fraction of the radius
  constexpr double kHalf = 0.5;
  constexpr double kSmall = 0.2;  // fraction of the image's area
  const LensCircle& circle = *camera.lens_circle;
  const Pixel axis = principal_point(camera.model);
  const double off = std::hypot(circle.centre[0] - axis[0], circle.centre[1] - axis[1]);
  if (off > kOffCentre * circle.radius_px) diagnostics.add(Code::kCircleOffCentre, {camera.name, off}, {path, 0, 0});
  const double covered = std::numbers::pi * circle.radius_px * circle.radius_px /
                         (static_cast<double>(camera.image_size->width) * camera.image_size->height);
  if (covered < kSmall) diagnostics.add(Code::kCircleSmall, {camera.name, covered}, {path, 0, 0});
  if (circle.rim_share < kHalf) diagnostics.add(Code::kCircleUncertain, {camera.name, circle.rim_share}, {path, 0, 0});
}

/// Warns about images that show another circle: they are from another camera, or show something else.
void warn_of_others(const ImageCircleSearch& search, const Camera& camera, const std::vector<std::string>& paths,
                    const std::vector<std::string>& witnesses, Diagnostics& diagnostics) {
  for (const std::size_t image : search.contradicting(*camera.lens_circle)) {
    const LensCircle other = *search.alone(image);
    diagnostics.add(Code::kCirclesDiffer, {camera.name, other.centre[0], other.centre[1], other.radius_px, named(witnesses)},
                    {paths.at(image), 0, 0});
  }
}

/// How the camera's image size and pixels change; nullopt if the change is not possible, which is reported elsewhere.
std::optional<ChangedImage> changed_image_of(const Camera& camera, const ImageChange& change) {
  Diagnostics said_later;
  return changed_image(*camera.image_size, change, said_later);
}

/// The camera before or after the change, whichever has the size of the image.
Camera as_taken(const Camera& camera, const ImageChange& change, const Image& image) {
  const std::optional<ChangedImage> changed = changed_image_of(camera, change);
  const ImageSize size = {image.width, image.height};
  Camera result = camera;
  if (!changed || size == *camera.image_size || size != changed->size) return result;
  result.model = with_pixels(camera.model, changed->map);
  result.image_size = size;
  return result;
}

/// The circle in the camera's image before the change; nullopt if it is not a circle there.
std::optional<LensCircle> in_image_of(const Camera& camera, const ImageChange& change, const Camera& seen) {
  if (seen.image_size == camera.image_size) return seen.lens_circle;
  return with_pixels(*seen.lens_circle, changed_image_of(camera, change)->map.inverse());
}

/// A camera as its sample images show it (before or after the change), and the search for their circle.
struct Seen {
  Camera camera;
  ImageCircleSearch search;
};

/// Searches for the circle in a camera's images; nullopt, with an error, if an image cannot be read or does not have the
/// camera's size.
std::optional<Seen> look_at(const Camera& camera, const std::vector<std::string>& paths, const ImageChange& change,
                            Files& files, Diagnostics& diagnostics) {
  std::optional<Seen> seen;
  for (const std::string& path : paths) {
    const std::optional<Image> image = files.read_image(path, diagnostics);
    if (!image) return std::nullopt;
    if (!seen) {
      const Camera taken = as_taken(camera, change, *image);
      seen = Seen{taken, ImageCircleSearch(principal_point(taken.model))};
    }
    if (!has_size_of(seen->camera, !change.changes_nothing(), *image, path, diagnostics)) return std::nullopt;
    seen->search.add(brightest(planes(*image)));  // the brightest colour of each pixel, since light may be blue only
  }
  if (seen) seen->camera.lens_circle = seen->search.best();
  return seen;
}

/// Warns about images that show another circle than most, and searches again without them. False, with an error, if that fails.
bool remove_others(const Camera& camera, std::vector<std::string>& paths, const ImageChange& change, Files& files, Seen& seen,
                   Diagnostics& diagnostics) {
  const std::vector<std::size_t> others = seen.search.contradicting(*seen.camera.lens_circle);
  if (others.empty()) return true;
  warn_of_others(seen.search, seen.camera, paths, witnesses(seen.search, *seen.camera.lens_circle, paths), diagnostics);
  std::vector<std::string> rest;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (std::ranges::find(others, i) == others.end()) rest.push_back(paths[i]);
  }
  std::optional<Seen> again = look_at(camera, rest, change, files, diagnostics);
  if (!again) return false;
  paths = std::move(rest);
  if (again->camera.lens_circle) seen = *std::move(again);
  return true;
}

bool add_circle(const SampleImages& sample, const ImageChange& change, Files& files, Diagnostics& diagnostics) {
  Camera& camera = *sample.camera;
  if (!camera.image_size) {
    diagnostics.add(Code::kImageSizeNotKnown, {camera.name});
    return false;
  }
  std::vector<std::string> paths = sample.paths;
  std::optional<Seen> seen = look_at(camera, paths, change, files, diagnostics);
  if (!seen) return false;
  if (!seen->camera.lens_circle) {
    diagnostics.add(paths.size() == 1 ? Code::kImageWithoutCircle : Code::kImagesWithoutCircle, {camera.name},
                    {paths.front(), 0, 0});
    return true;
  }
  if (!remove_others(camera, paths, change, files, *seen, diagnostics)) return false;
  LensCircle& circle = *seen->camera.lens_circle;
  const std::vector<std::string> shown_by = witnesses(seen->search, circle, paths);
  circle.why = {Code::kImageCircleOf, {named(shown_by)}};
  warn_of_doubts(seen->camera, shown_by.front(), diagnostics);
  camera.lens_circle = in_image_of(camera, change, seen->camera);
  if (!camera.lens_circle) diagnostics.add(Code::kCircleInStretchedImages, {camera.name}, {paths.front(), 0, 0});
  return true;
}

}  // namespace

bool add_lens_circles(const std::vector<CameraImage>& images, const ImageChange& change, Files& files, Rig& rig,
                      Diagnostics& diagnostics) {
  const std::optional<std::vector<SampleImages>> samples = by_camera(images, rig, diagnostics);
  return samples &&
         std::ranges::all_of(*samples, [&](const SampleImages& each) { return add_circle(each, change, files, diagnostics); });
}

}  // namespace fca
