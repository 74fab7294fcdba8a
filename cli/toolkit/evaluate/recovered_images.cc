// SPDX-License-Identifier: BSD-3-Clause
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

/// The position in the source's image of what a pixel of the target's image shows; nullopt if a model has no ray or pixel, or
/// the ray is beyond the limit.
std::optional<Pixel> looked_up(const EvaluatedRow& row, std::optional<double> limit_rad, const Pixel& pixel) {
  const std::optional<Ray> ray = unproject(row.conversion.camera.model, pixel);
  if (!ray || (limit_rad && angle_from_axis(*ray) > *limit_rad)) return std::nullopt;
  return project(row.source, *ray);
}

/// An image's colours as the target camera would have taken them. `mask`: 255 where they are known, otherwise 0.
struct Recovered {
  std::vector<GreyImage> colours;
  std::vector<std::uint8_t> mask;
};

Recovered recovered(const std::vector<GreyImage>& original, const EvaluatedTable& table, const EvaluatedRow& row) {
  const ImageSize& size = table.published.size;
  std::optional<double> limit_rad;
  if (table.published.max_angle_deg) limit_rad = *table.published.max_angle_deg / kDegreesPerRadian;
  Recovered result{original, {}};
  result.mask.reserve(original.front().samples.size());
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const std::optional<Pixel> place = looked_up(row, limit_rad, {static_cast<double>(u), static_cast<double>(v)});
      const std::optional<LanczosWindow> window = place ? LanczosWindow::about(*place, size) : std::nullopt;
      const std::size_t pixel = result.mask.size();
      result.mask.push_back(window ? 255 : 0);
      if (!window) continue;
      for (std::size_t colour = 0; colour < original.size(); ++colour)
        result.colours[colour].samples[pixel] = static_cast<float>(window->value(original[colour]));
    }
  }
  return result;
}

/// The mean PSNR and SSIM over the colours.
RecoveredImage compared(const std::vector<GreyImage>& before, const Recovered& after) {
  const auto colours = static_cast<double>(before.size());
  RecoveredImage result;
  double mean_square = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const ImageSimilarity colour = similarity(before[i], after.colours[i], after.mask);
    mean_square += colour.mean_square / colours;
    result.ssim += colour.ssim / colours;
    result.compared = colour.compared;
  }
  result.psnr_db = psnr_db(mean_square, before.front().full_scale);
  return result;
}

/// An 8-bit image whose levels are `level_at(colour, pixel)`.
template <class Levels>
Image picture_of(const std::vector<GreyImage>& like, const Levels& level_at) {
  constexpr double kWhite = 255.0;
  const GreyImage& first = like.front();
  Image image{first.width, first.height, static_cast<int>(like.size()), Image::Sample::k8Bit, {}};
  image.bytes.reserve(like.size() * first.samples.size());
  for (std::size_t pixel = 0; pixel < first.samples.size(); ++pixel) {
    for (std::size_t colour = 0; colour < like.size(); ++colour) {
      const double level = kWhite * level_at(colour, pixel) / static_cast<double>(first.full_scale);
      image.bytes.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(level, 0.0, kWhite))));
    }
  }
  return image;
}

RecoveredPictures pictures_of(const std::vector<GreyImage>& before, const Recovered& after) {
  constexpr double kAmplified = 16.0;
  const auto known = [&after](std::size_t pixel) { return after.mask[pixel] != 0; };
  const auto level = [](const GreyImage& image, std::size_t pixel) { return static_cast<double>(image.samples[pixel]); };
  return {picture_of(before, [&](std::size_t colour,
                                 std::size_t pixel) { return known(pixel) ? level(after.colours[colour], pixel) : 0.0; }),
          picture_of(before, [&](std::size_t colour, std::size_t pixel) {
            return known(pixel) ? kAmplified * std::abs(level(after.colours[colour], pixel) - level(before[colour], pixel))
                                : 0.0;
          })};
}

/// Maps a pixel of the source to the target's pixel of the same ray.
Placement placement_of(const EvaluatedRow& row) {
  return [&row](const Pixel& pixel) -> std::optional<Pixel> {
    const std::optional<Ray> ray = unproject(row.source, pixel);
    return ray ? project(row.conversion.camera.model, *ray) : std::nullopt;
  };
}

void add_to_table(const std::vector<GreyImage>& colours, bool with_pictures, EvaluatedTable& table) {
  constexpr std::string_view kSourceOfFigure3 = "KB";
  for (EvaluatedRow& row : table.rows) {
    const Recovered after = recovered(colours, table, row);
    row.recovered = compared(colours, after);
    row.painted = painted_image(colours, placement_of(row));
    if (with_pictures && row.published.from.name == kSourceOfFigure3) row.pictures = pictures_of(colours, after);
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
  std::vector<std::string> sizes;
  bool fits = false;
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
