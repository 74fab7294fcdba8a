// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace fca {

/// Rows from the top, one sample per pixel, without gaps; black is low. Any unit: `full_scale` is what the sensor's largest is.
struct GreyImage {
  int width = 0;
  int height = 0;
  float full_scale = 255.0F;
  std::vector<float> samples;
};

}  // namespace fca
