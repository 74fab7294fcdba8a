// SPDX-License-Identifier: BSD-3-Clause
#include "sigmas.h"

#include "numbers.h"

#include <fca/code.h>
#include <fca/formats/opencv_coefficients.h>
#include <fca/normalised_id.h>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

namespace fca::opencv {

namespace {

constexpr std::array<std::string_view, 4> kSigmaKeys = {"stddeviationsintrinsics", "stddeviationsofintrinsics", "stdintrinsics",
                                                        "intrinsicstddeviations"};
constexpr std::array<std::string_view, 3> kErrorKeys = {"avgreprojectionerror", "averagereprojectionerror",
                                                        "reprojectionerror"};
constexpr std::array<ParameterId, 4> kMatrixParameters = {"fx", "fy", "cx", "cy"};

const text::Entry* find_any(const text::Node& mapping, std::span<const std::string_view> keys) {
  const auto found = std::ranges::find_if(mapping.entries, [keys](const text::Entry& entry) {
    return std::ranges::find(keys, normalised_id(entry.key.value)) != keys.end();
  });
  return found == mapping.entries.end() ? nullptr : &*found;
}

/// Nothing of a model that cv::calibrateCamera does not fit.
std::vector<double> sigmas_of(const CameraModel& model, std::span<const double> stated) {
  const std::span<const Parameter> parameters = model_info(model).parameters;
  std::vector<double> sigmas(parameters.size(), 0.0);
  const auto set = [&](ParameterId id, double sigma) {
    const auto place = std::ranges::find(parameters, id.name(), &Parameter::name);
    if (place != parameters.end()) sigmas[static_cast<std::size_t>(place - parameters.begin())] = sigma;
  };
  for (std::size_t i = 0; i < kMatrixParameters.size(); ++i) set(kMatrixParameters.at(i), stated[i]);
  for (std::size_t i = 0; i < kOpenCvCoefficients.size(); ++i)
    set(kOpenCvCoefficients.at(i), stated[kMatrixParameters.size() + i]);
  // With CALIB_FIX_ASPECT_RATIO fx follows fy, and 0 stands for it.
  const double aspect = parameter(model, "fx").value() / parameter(model, "fy").value();
  if (stated[0] == 0.0 && stated[1] > 0.0) set("fx", stated[1] * aspect);
  return sigmas;
}

}  // namespace

void read_sigmas(const text::Node& mapping, const Camera& camera, fields::Reader& reader, Rig& rig) {
  Uncertainty result;
  result.camera = camera.name;
  if (const text::Entry* entry = find_any(mapping, kErrorKeys); entry != nullptr && entry->value.is_scalar()) {
    Diagnostics not_used;
    fields::Reader quiet(reader.document(), reader.dialect(), not_used);
    result.reprojection_rms_px = quiet.positive(entry->value, entry->key.value);
    result.where = reader.document().range(entry->key);
  }
  const std::string_view id = model_info(camera.model).id;
  if (const text::Entry* entry = find_any(mapping, kSigmaKeys); entry != nullptr && (opencv_count(id) > 0 || id == "pinhole")) {
    Diagnostics not_used;
    fields::Reader quiet(reader.document(), reader.dialect(), not_used);
    const std::optional<Numbers> stated = read_numbers(entry->value, entry->key.value, quiet);
    const bool are_sigmas = stated && stated->values.size() == kMatrixParameters.size() + kOpenCvCoefficients.size() &&
                            std::ranges::all_of(stated->values, [](double sigma) { return sigma >= 0.0; });
    result.where = reader.document().range(entry->key);
    if (are_sigmas) {
      result.model = id;
      result.sigmas = sigmas_of(camera.model, stated->values);
    } else {
      reader.say(entry->key, Code::kOpencvSigmasOdd, {entry->key.value});
    }
  }
  if (!result.sigmas.empty() || result.reprojection_rms_px) rig.uncertainties.push_back(std::move(result));
}

}  // namespace fca::opencv
