// SPDX-License-Identifier: BSD-3-Clause
// How often a check finds something in real files, and how often nothing is wrong there.
#pragma once

#include <span>
#include <string_view>

namespace fca {

/// Real calibration files that all checks were run over: those of tests/checks/corpus_test.cc, which counts again.
inline constexpr int kRealFiles = 516;

/// Of one code of check.
struct Sighting {
  std::string_view id;
  int files = 0;         ///< In which it was found.
  int false_alarms = 0;  ///< Of those, files that are as their author means them; each looked at by hand.
};

/// Codes that were found in none are not listed.
[[nodiscard]] std::span<const Sighting> sightings();

/// The row of that code; zeros where it was found in none.
[[nodiscard]] Sighting sighting_of(std::string_view id);

}  // namespace fca
