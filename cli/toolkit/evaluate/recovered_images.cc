// SPDX-License-Identifier: BSD-3-Clause
// "The paper" is S. Lee, "Fisheye-Calib-Adapter", 2024; its tables are in fca/toolkit/paper_tables.h.
#include "recovered_images.h"

#include "degrees.h"
#include "painted_images.h"
#include "read/image_planes.h"
#include "words.h"

#include <fca/code.h>
#include <fca/compare/image_similarity.h>
#include <fca/remap/lanczos.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fca {

namespace {

/// Maps a pixel of the target image to the position [px] in the source image that has the same ray. nullopt if one of the
/// models has no such ray or pixel, or if the ray is more than `limit_rad` from the axis.
std::optional<Pixel> source_pixel_of(const EvaluatedRow& row, std::optional<double> limit_rad, const Pixel& pixel) {
  const std::optional<Ray> ray = unproject(row.conversion.camera.model, pixel);
  if (!ray || (limit_rad && angle_from_axis(*ray) > *limit_rad)) return std::nullopt;
  return project(row.source, *ray);
}

/// The image that the target camera would have taken.
struct Resampled {
  std::vector<GreyImage> colours;  ///< One plane per colour of the original.
  /// For each pixel: 255 if the source image contains all pixels from which the pixel is interpolated, otherwise 0.
  std::vector<std::uint8_t> mask;
};

/// Resamples the source image to the pixels of the target camera. Pixels whose mask is 0 keep the original's level.
Resampled resample(const std::vector<GreyImage>& original, const EvaluatedTable& table, const EvaluatedRow& row) {
  const ImageSize& size = table.published.size;
  std::optional<double> limit_rad;
  if (table.published.max_angle_deg) limit_rad = *table.published.max_angle_deg / kDegreesPerRadian;
  Resampled result{original, {}};
  result.mask.reserve(original.front().samples.size());
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const std::optional<Pixel> source_pixel =
          source_pixel_of(row, limit_rad, {static_cast<double>(u), static_cast<double>(v)});
      const std::optional<LanczosWindow> window = source_pixel ? LanczosWindow::about(*source_pixel, size) : std::nullopt;
      const std::size_t pixel = result.mask.size();
      result.mask.push_back(window ? 255 : 0);
      if (!window) continue;
      for (std::size_t colour = 0; colour < original.size(); ++colour)
        result.colours[colour].samples[pixel] = static_cast<float>(window->value(original[colour]));
    }
  }
  return result;
}

/// Compares the pixels whose mask is 255: the PSNR of the squared error averaged over the colours, and the mean SSIM of the
/// colours.
RecoveredImage compare_images(const std::vector<GreyImage>& original, const Resampled& resampled) {
  const auto colours = static_cast<double>(original.size());
  RecoveredImage result;
  double mean_square = 0.0;
  for (std::size_t i = 0; i < original.size(); ++i) {
    const ImageSimilarity colour = similarity(original[i], resampled.colours[i], resampled.mask);
    mean_square += colour.mean_square / colours;
    result.ssim += colour.ssim / colours;
    result.compared = colour.compared;  // the same for all colours, since they have one mask
  }
  result.psnr_db = psnr_db(mean_square, original.front().full_scale);
  return result;
}

/// Returns an 8-bit image with the size and the colours of `same_size_as`. Its levels are level_at(colour, pixel), scaled from
/// the planes' full scale to 255.
template <class Levels>
Image picture_of(const std::vector<GreyImage>& same_size_as, const Levels& level_at) {
  constexpr double kWhite = 255.0;
  const GreyImage& first = same_size_as.front();
  Image image{first.width, first.height, static_cast<int>(same_size_as.size()), Image::Sample::k8Bit, {}};
  image.bytes.reserve(same_size_as.size() * first.samples.size());
  for (std::size_t pixel = 0; pixel < first.samples.size(); ++pixel) {
    for (std::size_t colour = 0; colour < same_size_as.size(); ++colour) {
      const double level = kWhite * level_at(colour, pixel) / static_cast<double>(first.full_scale);
      image.bytes.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(level, 0.0, kWhite))));
    }
  }
  return image;
}

/// The resampled image, and the amplified difference of its levels from the original's. Pixels whose mask is 0 are black.
RecoveredPictures pictures_of(const std::vector<GreyImage>& original, const Resampled& resampled) {
  constexpr double kDifferenceGain = 16.0;
  const auto known = [&resampled](std::size_t pixel) { return resampled.mask[pixel] != 0; };
  const auto level = [](const GreyImage& image, std::size_t pixel) { return static_cast<double>(image.samples[pixel]); };
  return {picture_of(original, [&](std::size_t colour,
                                   std::size_t pixel) { return known(pixel) ? level(resampled.colours[colour], pixel) : 0.0; }),
          picture_of(original, [&](std::size_t colour, std::size_t pixel) {
            return known(pixel)
                       ? kDifferenceGain * std::abs(level(resampled.colours[colour], pixel) - level(original[colour], pixel))
                       : 0.0;
          })};
}

/// Returns a function that maps a pixel of the source image to the pixel of the target image that has the same ray.
Placement placement_of(const EvaluatedRow& row) {
  return [&row](const Pixel& pixel) -> std::optional<Pixel> {
    const std::optional<Ray> ray = unproject(row.source, pixel);
    return ray ? project(row.conversion.camera.model, *ray) : std::nullopt;
  };
}

/// Adds the image statistics to every row of a table, and pictures to the rows that the paper's Figure 3 shows.
void add_to_table(const std::vector<GreyImage>& colours, bool with_pictures, EvaluatedTable& table) {
  constexpr std::string_view kSourceOfFigure3 = "KB";
  for (EvaluatedRow& row : table.rows) {
    const Resampled resampled = resample(colours, table, row);
    row.recovered = compare_images(colours, resampled);
    row.painted = painted_image(colours, placement_of(row));
    if (with_pictures && row.published.from.name == kSourceOfFigure3) row.pictures = pictures_of(colours, resampled);
  }
  table.painted_noise = painted_with_noise(colours);
}

}  // namespace

bool add_recovered_images(const EvaluateRequest& request, Files& files, EvaluateResult& evaluation) {
  Diagnostics& diagnostics = evaluation.diagnostics;
  const std::string& path = request.image_path;
  const std::optional<Image> image = files.read_image(path, diagnostics);
  if (!image) return false;
  const ImageSize size = {image->width, image->height};
  const std::vector<GreyImage> colours = planes(*image);
  std::vector<std::string> sizes;  // of the tables' images, for the error
  bool fits = false;               // the image has the size of a table
  for (EvaluatedTable& table : evaluation.conversions) {
    const std::string needed = size_in_words(table.published.size);
    if (std::ranges::find(sizes, needed) == sizes.end()) sizes.push_back(needed);
    if (!(table.published.size == size)) continue;
    fits = true;
    add_to_table(colours, request.pictures, table);
  }
  if (!fits) diagnostics.add(Code::kNotThePapersSize, {size.width, size.height, sizes}, {path, 0, 0});
  return fits;
}

}  // namespace fca
