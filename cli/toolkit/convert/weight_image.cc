// SPDX-License-Identifier: BSD-3-Clause
#include "weight_image.h"

#include "read/image_planes.h"

#include <fca/code.h>
#include <fca/toolkit/image.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace fca {

namespace {

/// The mean of the colours of each pixel, at least 0.
GreyImage grey_of(const Image& image) {
  std::vector<GreyImage> colours = planes(image);
  GreyImage grey = std::move(colours.front());
  for (std::size_t i = 0; i < grey.samples.size(); ++i) {
    float sum = grey.samples[i];
    for (std::size_t colour = 1; colour < colours.size(); ++colour) sum += colours[colour].samples[i];
    // An image of floating-point numbers may contain negative values, which are treated as black.
    grey.samples[i] = std::max(0.0F, sum / static_cast<float>(colours.size()));
  }
  return grey;
}

}  // namespace

bool read_weight_image(const Rig& rig, Files& files, ConvertRequest& request, Diagnostics& diagnostics) {
  if (request.weight != WeightKind::kImage || request.density != nullptr) return true;
  const std::optional<Image> image = files.read_image(request.weight_image, diagnostics);
  if (!image) return false;
  for (const Camera& camera : rig.cameras) {
    if (camera.image_size && !has_size_of(camera, false, *image, request.weight_image, diagnostics)) return false;
  }
  GreyImage grey = grey_of(*image);
  if (std::ranges::all_of(grey.samples, [](float sample) { return sample == 0.0F; })) {
    diagnostics.add(Code::kWeightsBlack, {rig.cameras.empty() ? "" : rig.cameras.front().name}, {request.weight_image, 0, 0});
    return false;
  }
  request.density = std::make_shared<const GreyImage>(std::move(grey));
  return true;
}

}  // namespace fca
