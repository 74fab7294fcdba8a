// SPDX-License-Identifier: BSD-3-Clause
#include "lens.h"

#include "../opencv/lens.h"

#include <fca/code.h>
#include <fca/formats/opencv_coefficients.h>

#include <algorithm>

namespace fca::devices {

bool set_parameters(std::span<const ParameterId> parameters, const Nodes& nodes, std::string_view what, CameraModel& model,
                    fields::Reader& reader) {
  for (std::size_t i = 0; i < std::min(parameters.size(), nodes.size()); ++i) {
    if (!reader.parameter(*nodes[i], what, parameters[i], model)) return false;
  }
  return true;
}

std::optional<CameraModel> opencv_lens(const Nodes& coefficients, std::string_view what, fields::Reader& reader) {
  std::vector<double> values;
  for (const text::Node* node : coefficients) {
    const std::optional<double> value = reader.real(*node, what);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  const std::string_view id = opencv::model_of_coefficients(values);
  std::optional<CameraModel> model = make_model(id);
  const std::span<const ParameterId> used = std::span(kOpenCvCoefficients).first(opencv_count(id));
  if (!set_parameters(used, coefficients, what, *model, reader)) return std::nullopt;
  return model;
}

std::optional<CameraModel> fisheye_lens(const Nodes& coefficients, std::string_view what, fields::Reader& reader) {
  std::optional<CameraModel> model = make_model("kb4");
  if (!set_parameters(kFisheyeCoefficients, coefficients, what, *model, reader)) return std::nullopt;
  return model;
}

std::string in_words(const ImageSize& size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

std::vector<std::string> in_words(std::vector<ImageSize> sizes) {
  std::ranges::stable_sort(sizes, [](const ImageSize& a, const ImageSize& b) {
    return a.width != b.width ? a.width > b.width : a.height > b.height;
  });
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  std::vector<std::string> words;
  words.reserve(sizes.size());
  for (const ImageSize& size : sizes) words.push_back(in_words(size));
  return words;
}

std::optional<std::vector<std::optional<ImageSize>>> chosen_sizes(std::span<const Sizes> cameras,
                                                                  const std::optional<ImageSize>& told,
                                                                  fields::Reader& reader) {
  std::vector<std::optional<ImageSize>> chosen;
  std::vector<ImageSize> choices;  // of all that have several
  const text::Node* first = nullptr;
  for (const Sizes& each : cameras) {
    const bool one = in_words(each.sizes).size() == 1;
    const bool as_told = told && std::ranges::find(each.sizes, *told) != each.sizes.end();
    chosen.push_back(one ? std::optional(each.sizes.front()) : as_told ? told : std::nullopt);
    if (one) continue;
    if (first == nullptr) first = each.place;
    choices.insert(choices.end(), each.sizes.begin(), each.sizes.end());
  }
  if (first == nullptr) return chosen;
  if (!told) {
    reader.say(*first, Code::kDeviceSizeNeeded, {in_words(choices)});
    return std::nullopt;
  }
  if (std::ranges::find(chosen, told) == chosen.end()) {
    reader.say(*first, Code::kDeviceSizeUnknown, {in_words(*told), in_words(choices)});
    return std::nullopt;
  }
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    if (!chosen[i]) {
      reader.say(*cameras[i].place, Code::kDeviceCameraOfOtherSize,
                 {cameras[i].camera, in_words(*told), in_words(cameras[i].sizes)});
    }
  }
  return chosen;
}

}  // namespace fca::devices
