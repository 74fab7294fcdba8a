// SPDX-License-Identifier: BSD-3-Clause
// What the files of devices share: lenses whose coefficients are OpenCV's, number by number at its place, and lenses for
// several sizes of images.
#pragma once

#include "../fields.h"

#include <fca/formats/format.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca::devices {

using Nodes = std::vector<const text::Node*>;

/// Sets the parameters to the nodes' numbers, one for one, as far as there are nodes. False, with an error at the first node
/// whose number cannot be. `what`: what the list is called.
[[nodiscard]] bool set_parameters(std::span<const ParameterId> parameters, const Nodes& nodes, std::string_view what,
                                  CameraModel& model, fields::Reader& reader);

/// The simplest model with these coefficients, in the order of cv::projectPoints. Nothing, with an error, where one is no
/// number.
[[nodiscard]] std::optional<CameraModel> opencv_lens(const Nodes& coefficients, std::string_view what, fields::Reader& reader);

/// The same of cv::fisheye, of whose vector the first four count.
[[nodiscard]] std::optional<CameraModel> fisheye_lens(const Nodes& coefficients, std::string_view what, fields::Reader& reader);

/// "1280x720"
[[nodiscard]] std::string in_words(const ImageSize& size);
/// Of each size once, the largest first.
[[nodiscard]] std::vector<std::string> in_words(std::vector<ImageSize> sizes);

/// A camera and the sizes of images for which it has lenses.
struct Sizes {
  std::string camera;
  std::vector<ImageSize> sizes;
  const text::Node* place = nullptr;  ///< Of the camera's first lens.
};

/// For each camera the size of its images: the only one for which it has a lens, else the one that was told; nothing, with a
/// warning, of one without a lens for that. Nothing at all, with an error, where a choice is needed and none was told, or none
/// has a lens for what was told.
[[nodiscard]] std::optional<std::vector<std::optional<ImageSize>>> chosen_sizes(std::span<const Sizes> cameras,
                                                                                const std::optional<ImageSize>& told,
                                                                                fields::Reader& reader);

}  // namespace fca::devices
