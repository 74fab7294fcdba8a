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

/// The sample images of one camera.
struct SampleImages {
  Camera* camera = nullptr;
  std::vector<std::string> paths;
};

/// Repeats the user's argument: "IMAGE" or "CAMERA=IMAGE".
std::string in_words(const CameraImage& image) { return image.camera.empty() ? image.path : image.camera + "=" + image.path; }

/// Adds an error about a sample image without a path or without a known camera.
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

/// The camera that took the image. Null if it is not known.
Camera* camera_of(const CameraImage& image, Rig& rig) {
  if (image.camera.empty()) return rig.cameras.size() == 1 ? rig.cameras.data() : nullptr;
  const auto camera = std::ranges::find(rig.cameras, image.camera, &Camera::name);
  return camera != rig.cameras.end() ? &*camera : nullptr;
}

/// Groups the images by camera and removes duplicates. nullopt, with an error, if an image has no known camera or no path.
std::optional<std::vector<SampleImages>> group_by_camera(const std::vector<CameraImage>& images, Rig& rig,
                                                         Diagnostics& diagnostics) {
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

/// Lists up to three images by name; otherwise gives their number.
Message list_of(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  names.reserve(paths.size());
  for (const std::string& path : paths) names.push_back(text::printable(std::filesystem::path(path).filename().string()));
  constexpr std::size_t kMaxNames = 3;
  if (names.size() <= kMaxNames) return {Code::kImagesByName, {names}};
  return {Code::kImagesByNumber, {names.size()}};
}

/// The images in each of which the circle can be found without the others. All images if there are none.
std::vector<std::string> images_showing(const ImageCircleSearch& search, const LensCircle& circle,
                                        const std::vector<std::string>& paths) {
  std::vector<std::string> result;
  for (const std::size_t image : search.showing(circle)) result.push_back(paths.at(image));
  return result.empty() ? paths : result;
}

/// Adds warnings if the circle may not be the image circle: a lamp in a dark room and the glow around a lens look similar.
void warn_of_doubts(const Camera& camera, const std::string& path, Diagnostics& diagnostics) {
  constexpr double kLargestOffset = 0.1;      // of the centre from the principal point, as a fraction of the radius
  constexpr double kSmallestRim = 0.5;        // visible fraction of the rim
  constexpr double kSmallestAreaShare = 0.2;  // fraction of the image's area
  const LensCircle& circle = *camera.lens_circle;
  const Pixel axis = principal_point(camera.model);
  const double offset = std::hypot(circle.centre[0] - axis[0], circle.centre[1] - axis[1]);
  if (offset > kLargestOffset * circle.radius_px) diagnostics.add(Code::kCircleOffCentre, {camera.name, offset}, {path, 0, 0});
  const double covered = std::numbers::pi * circle.radius_px * circle.radius_px /
                         (static_cast<double>(camera.image_size->width) * camera.image_size->height);
  if (covered < kSmallestAreaShare) diagnostics.add(Code::kCircleSmall, {camera.name, covered}, {path, 0, 0});
  if (circle.rim_share < kSmallestRim) diagnostics.add(Code::kCircleUncertain, {camera.name, circle.rim_share}, {path, 0, 0});
}

/// Warns about images that show another circle: they may be from another camera, or show something else that is round.
void warn_of_contradicting(const ImageCircleSearch& search, const Camera& camera, const std::vector<std::string>& paths,
                           const std::vector<std::string>& images_with_circle, Diagnostics& diagnostics) {
  for (const std::size_t image : search.contradicting(*camera.lens_circle)) {
    const LensCircle other = *search.alone(image);
    diagnostics.add(Code::kCirclesDiffer,
                    {camera.name, other.centre[0], other.centre[1], other.radius_px, list_of(images_with_circle)},
                    {paths.at(image), 0, 0});
  }
}

/// The effect of the change on the camera's images. nullopt if the change is not possible; change_images() reports that later.
std::optional<ChangedImage> changed_image_of(const Camera& camera, const ImageChange& change) {
  Diagnostics discarded;
  return changed_image(*camera.image_size, change, discarded);
}

/// The camera after the change if the image has that size; otherwise the camera before the change.
Camera camera_of_image_size(const Camera& camera, const ImageChange& change, const Image& image) {
  const std::optional<ChangedImage> changed = changed_image_of(camera, change);
  const ImageSize size = {image.width, image.height};
  Camera result = camera;
  if (!changed || size == *camera.image_size || size != changed->size) return result;
  result.model = with_pixels(camera.model, changed->map);
  result.image_size = size;
  return result;
}

/// Maps the circle of `searched` to the camera's image before the change. nullopt if it is not a circle in that image.
std::optional<LensCircle> circle_before_change(const Camera& camera, const ImageChange& change, const Camera& searched) {
  if (searched.image_size == camera.image_size) return searched.lens_circle;
  return with_pixels(*searched.lens_circle, changed_image_of(camera, change)->map.inverse());
}

/// A camera, and the search for the circle in its sample images.
struct SearchedCamera {
  Camera camera;  ///< The camera before or after the change, whichever the images show, with the circle if it was found.
  ImageCircleSearch search;
};

/// Searches for the circle in the images of a camera. nullopt, with an error, if an image cannot be read or does not have the
/// camera's size.
std::optional<SearchedCamera> search_images(const Camera& camera, const std::vector<std::string>& paths,
                                            const ImageChange& change, Files& files, Diagnostics& diagnostics) {
  std::optional<SearchedCamera> searched;
  for (const std::string& path : paths) {
    const std::optional<Image> image = files.read_image(path, diagnostics);
    if (!image) return std::nullopt;
    if (!searched) {
      const Camera taken = camera_of_image_size(camera, change, *image);
      searched = SearchedCamera{taken, ImageCircleSearch(principal_point(taken.model))};
    }
    if (!has_size_of(searched->camera, !change.changes_nothing(), *image, path, diagnostics)) return std::nullopt;
    searched->search.add(brightest(planes(*image)));  // the brightest colour of each pixel, since light may be blue only
  }
  if (searched) searched->camera.lens_circle = searched->search.best();
  return searched;
}

/// Warns about images that show another circle than most images, removes them from `paths`, and searches again without them.
/// False, with an error, if an image cannot be read.
bool remove_contradicting(const Camera& camera, std::vector<std::string>& paths, const ImageChange& change, Files& files,
                          SearchedCamera& searched, Diagnostics& diagnostics) {
  const std::vector<std::size_t> others = searched.search.contradicting(*searched.camera.lens_circle);
  if (others.empty()) return true;
  warn_of_contradicting(searched.search, searched.camera, paths,
                        images_showing(searched.search, *searched.camera.lens_circle, paths), diagnostics);
  std::vector<std::string> rest;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (std::ranges::find(others, i) == others.end()) rest.push_back(paths[i]);
  }
  std::optional<SearchedCamera> repeated = search_images(camera, rest, change, files, diagnostics);
  if (!repeated) return false;
  if (!repeated->camera.lens_circle) return true;  // the others are needed to see the circle
  paths = std::move(rest);
  searched = *std::move(repeated);
  return true;
}

/// Sets the image circle of one camera from its sample images. False with errors.
bool add_circle(const SampleImages& sample, const ImageChange& change, Files& files, Diagnostics& diagnostics) {
  Camera& camera = *sample.camera;
  if (!camera.image_size) {
    diagnostics.add(Code::kImageSizeNotKnown, {camera.name});
    return false;
  }
  std::vector<std::string> paths = sample.paths;
  std::optional<SearchedCamera> searched = search_images(camera, paths, change, files, diagnostics);
  if (!searched) return false;
  if (!searched->camera.lens_circle) {
    diagnostics.add(paths.size() == 1 ? Code::kImageWithoutCircle : Code::kImagesWithoutCircle, {camera.name},
                    {paths.front(), 0, 0});
    return true;
  }
  if (!remove_contradicting(camera, paths, change, files, *searched, diagnostics)) return false;
  LensCircle& circle = *searched->camera.lens_circle;
  const std::vector<std::string> images_with_circle = images_showing(searched->search, circle, paths);
  circle.why = {Code::kImageCircleOf, {list_of(images_with_circle)}};
  warn_of_doubts(searched->camera, images_with_circle.front(), diagnostics);
  camera.lens_circle = circle_before_change(camera, change, searched->camera);
  if (!camera.lens_circle) diagnostics.add(Code::kCircleInStretchedImages, {camera.name}, {paths.front(), 0, 0});
  return true;
}

}  // namespace

bool add_lens_circles(const std::vector<CameraImage>& images, const ImageChange& change, Files& files, Rig& rig,
                      Diagnostics& diagnostics) {
  const std::optional<std::vector<SampleImages>> samples = group_by_camera(images, rig, diagnostics);
  return samples &&
         std::ranges::all_of(*samples, [&](const SampleImages& each) { return add_circle(each, change, files, diagnostics); });
}

}  // namespace fca
