// SPDX-License-Identifier: BSD-3-Clause
#include "words.h"

#include <fca/toolkit/convert.h>

#include <array>

namespace fca {

namespace {

/// What a request may state and not every format has.
struct Statement {
  std::string_view option;  ///< For people.
  bool (*is_made)(const ConvertRequest&);
  bool (*has_use)(const Format&);
};

constexpr std::array kStatements = {
    Statement{"--sensor", [](const ConvertRequest& request) { return !request.mode.empty(); },
              [](const Format& format) { return !format.modes.empty(); }},
    Statement{"--fps", [](const ConvertRequest& request) { return request.frame_rate_hz.has_value(); },
              [](const Format& format) { return format.frame_rate; }},
    Statement{"--baseline", [](const ConvertRequest& request) { return request.baseline_m.has_value(); },
              [](const Format& format) { return format.baseline; }},
};

}  // namespace

std::optional<std::string> without_use(const ConvertRequest& request, const Format& to) {
  const auto sentence = [&to](const std::string& option, const std::vector<std::string>& users) {
    return option + " is for --to " + enumerated(users, "or") + ", not " + std::string(to.id);
  };
  for (const Statement& statement : kStatements) {
    if (!statement.is_made(request) || statement.has_use(to)) continue;
    std::vector<std::string> users;
    for (const Format& format : all_formats()) {
      if (statement.has_use(format)) users.emplace_back(format.id);
    }
    return sentence(std::string(statement.option), users);
  }
  const auto& [owner, layout] = request.layout;
  if (layout.empty() || owner == &to) return std::nullopt;
  return sentence("--" + std::string(owner->id) + "-layout", {std::string(owner->id)});
}

}  // namespace fca
