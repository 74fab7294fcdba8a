// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry.h"

namespace fca::matrix::okvis {

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index);
std::vector<Pose> relative_poses(const std::vector<std::string>& files);

}  // namespace fca::matrix::okvis
