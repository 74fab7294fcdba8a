// SPDX-License-Identifier: BSD-3-Clause
#include "words.h"

#include <fca/formats/text/message.h>

#include <array>

namespace fca {

std::string pixels(double value) {
  constexpr double kLargerThanAnyImage = 1e6;
  if (value > kLargerThanAnyImage) return "over a million";
  const std::array<Argument, 1> arguments = {value};
  return text::filled("{0:px}", arguments);
}

std::string name_in_words(const ConvertedCamera& camera) {
  const std::string& name = camera.name();
  return name == camera.source.name ? name : name + " (input's " + camera.source.name + ")";
}

std::string size_in_words(const ImageSize& size) { return std::to_string(size.width) + " x " + std::to_string(size.height); }

}  // namespace fca
