// SPDX-License-Identifier: BSD-3-Clause
#include "kept_inputs.h"

namespace fca::cli {

namespace {

/// Empty where it is no file.
std::filesystem::path place_of(const std::string& file) {
  if (is_standard_input(file)) return {};
  std::error_code error;
  return std::filesystem::weakly_canonical(file, error);
}

}  // namespace

KeptInputs::KeptInputs(const Inputs& inputs) {
  for (const CameraImage& image : inputs.lens_circles) add(image.path);
}

KeptInputs::KeptInputs(const Console& console, const Inputs& inputs) : KeptInputs(inputs) {
  for (const text::Source& source : console.sources()) add(source.name);
}

void KeptInputs::add(std::span<const std::string> files) {
  for (const std::string& file : files) add(file);
}

void KeptInputs::add(const std::string& file) { files_.insert(place_of(file)); }

std::optional<std::string> KeptInputs::problem_with(const std::string& output) const {
  if (files_.empty()) return std::nullopt;
  const std::filesystem::path place = place_of(output);
  if (place.empty() || !files_.contains(place)) return std::nullopt;
  return output + " is an input; name another place";
}

}  // namespace fca::cli
