// SPDX-License-Identifier: BSD-3-Clause
#include "kept_inputs.h"

#include <fca/code.h>
#include <fca/formats/text/message.h>

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

bool KeptInputs::hold(const std::string& output) const {
  if (files_.empty()) return false;
  const std::filesystem::path place = place_of(output);
  return !place.empty() && files_.contains(place);
}

std::optional<std::string> KeptInputs::problem_with(const std::string& output) const {
  return hold(output) ? std::optional(text::text_of({Code::kOverwritesInput, {output}})) : std::nullopt;
}

}  // namespace fca::cli
