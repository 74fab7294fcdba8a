// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/toolkit/convert.h>

#include <algorithm>
#include <array>

namespace fca {

namespace {

/// An option of a request that not every format has a use for.
struct Statement {
  Code useless;
  bool (*is_made)(const ConvertRequest&);
  bool (*has_use)(const Format&);
};

constexpr std::array kStatements = {
    Statement{Code::kModeWithoutUse, [](const ConvertRequest& request) { return request.mode.has_value(); },
              [](const Format& format) { return !format.modes.empty(); }},
    Statement{Code::kRateWithoutUse, [](const ConvertRequest& request) { return request.frame_rate_hz.has_value(); },
              [](const Format& format) { return format.frame_rate; }},
    Statement{Code::kBaselineWithoutUse, [](const ConvertRequest& request) { return request.baseline_m.has_value(); },
              [](const Format& format) { return format.baseline; }},
    Statement{Code::kArgumentsWithoutUse, [](const ConvertRequest& request) { return request.as_arguments; },
              [](const Format& format) { return format.arguments != nullptr; }},
    Statement{Code::kDegreeWithoutUse, [](const ConvertRequest& request) { return request.degree.has_value(); },
              [](const Format& format) {
                return std::ranges::any_of(format.models, [](const StoredModel& stored) {
                  return find_model(stored.model)->least_degree > 0 && stored.ranges.empty();
                });
              }},
};

}  // namespace

Message without_use(const ConvertRequest& request, const Format& to) {
  for (const Statement& statement : kStatements) {
    if (!statement.is_made(request) || statement.has_use(to)) continue;
    std::vector<std::string> users;
    for (const Format& format : written_formats()) {
      if (statement.has_use(format)) users.emplace_back(format.id);
    }
    return {statement.useless, {users, to.id}};
  }
  if (!request.layout || &request.layout->format() == &to) return {};
  return {Code::kLayoutWithoutUse, {request.layout->format().id, to.id}};
}

}  // namespace fca
