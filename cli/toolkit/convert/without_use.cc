// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/toolkit/convert.h>

#include <algorithm>
#include <array>

namespace fca {

namespace {

/// An option of a request that only some formats support.
struct FormatOption {
  Code unsupported;  ///< The code of the message that the format does not support the option.
  bool (*is_given)(const ConvertRequest&);
  bool (*is_supported)(const Format&);
};

constexpr std::array kFormatOptions = {
    FormatOption{Code::kModeWithoutUse, [](const ConvertRequest& request) { return request.mode.has_value(); },
                 [](const Format& format) { return !format.modes.empty(); }},
    FormatOption{Code::kRateWithoutUse, [](const ConvertRequest& request) { return request.frame_rate_hz.has_value(); },
                 [](const Format& format) { return format.frame_rate; }},
    FormatOption{Code::kBaselineWithoutUse, [](const ConvertRequest& request) { return request.baseline_m.has_value(); },
                 [](const Format& format) { return format.baseline; }},
    FormatOption{Code::kArgumentsWithoutUse, [](const ConvertRequest& request) { return request.as_arguments; },
                 [](const Format& format) { return format.arguments != nullptr; }},
    FormatOption{Code::kDegreeWithoutUse, [](const ConvertRequest& request) { return request.degree.has_value(); },
                 [](const Format& format) {
                   return std::ranges::any_of(format.models, [](const StoredModel& stored) {
                     return find_model(stored.model)->least_degree > 0 && stored.ranges.empty();
                   });
                 }},
};

}  // namespace

Message without_use(const ConvertRequest& request, const Format& to) {
  for (const FormatOption& option : kFormatOptions) {
    if (!option.is_given(request) || option.is_supported(to)) continue;
    std::vector<std::string> supporting_formats;
    for (const Format& format : written_formats()) {
      if (option.is_supported(format)) supporting_formats.emplace_back(format.id);
    }
    return {option.unsupported, {supporting_formats, to.id}};
  }
  if (!request.layout || &request.layout->format() == &to) return {};
  return {Code::kLayoutWithoutUse, {request.layout->format().id, to.id}};
}

}  // namespace fca
