// SPDX-License-Identifier: BSD-3-Clause
#include "recovered_images.h"

#include "image_file.h"
#include "image_planes.h"
#include "pictures/pictures.h"
#include "words.h"

#include <fca/compare/image_similarity.h>
#include <fca/remap/image_map.h>

#include <algorithm>

namespace fca::cli {

namespace {

Camera camera_with(const CameraModel& model, const ImageSize& size) {
  Camera camera;
  camera.image_size = size;
  camera.model = model;
  return camera;
}

/// The mean over the colours.
RecoveredImage compared(const Image& original, const Image& recovered, std::span<const std::uint8_t> mask) {
  const std::vector<GreyImage> before = planes(original);
  const std::vector<GreyImage> after = planes(recovered);
  const auto colours = static_cast<double>(before.size());
  RecoveredImage result;
  double mean_square = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const ImageSimilarity colour = similarity(before[i], after[i], mask);
    mean_square += colour.mean_square / colours;
    result.ssim += colour.ssim / colours;
    result.compared = colour.compared;
  }
  result.psnr_db = psnr_db(mean_square, before.front().full_scale);
  return result;
}

std::optional<RecoveredImage> recovered(const Image& original, const EvaluatedTable& table, const EvaluatedRow& row,
                                        Diagnostics& diagnostics) {
  const ImageSize& size = table.published.size;
  std::optional<double> limit_rad;
  if (table.published.max_angle_deg) limit_rad = *table.published.max_angle_deg / kDegreesPerRadian;
  const std::optional<ImageMapper> mapper = ImageMapper::between(
      camera_with(row.source, size), camera_with(row.conversion.camera.model, size), Transform{}, limit_rad, diagnostics);
  if (!mapper) return std::nullopt;
  const ImageMap map = image_map(*mapper);
  const std::optional<Image> image = remapped(original, map, Interpolation::kLanczos);
  if (!image) return std::nullopt;
  return compared(original, *image, seen(map, size));
}

}  // namespace

bool add_recovered_images(const std::string& path, Evaluation& evaluation, Diagnostics& diagnostics) {
  const std::optional<Image> image = read_image(path, diagnostics);
  if (!image) return false;
  const ImageSize size = {image->width, image->height};
  std::vector<std::string> sizes;
  bool fits = false;
  for (EvaluatedTable& table : evaluation.conversions) {
    const std::string needed = size_in_words(table.published.size);
    if (std::ranges::find(sizes, needed) == sizes.end()) sizes.push_back(needed);
    if (!(table.published.size == size)) continue;
    fits = true;
    for (EvaluatedRow& row : table.rows) {
      row.recovered = recovered(*image, table, row, diagnostics);
      if (!row.recovered) return false;
    }
  }
  if (!fits) {
    diagnostics.error("image-size",
                      "the image is " + size_in_words(size) + " px, and the paper's cameras are of " + enumerated(sizes, "or"),
                      {path, 0, 0}, "examples/cpp/render_image.cc makes one");
  }
  return fits;
}

}  // namespace fca::cli
