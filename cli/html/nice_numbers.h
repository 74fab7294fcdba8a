// SPDX-License-Identifier: BSD-3-Clause
// Round numbers for axes, colour bars and scale bars: 1, 2 and 5 times powers of ten.
#pragma once

#include <string>
#include <vector>

namespace fca::cli {

/// The smallest 1-2-5 number that is not less than a positive one.
[[nodiscard]] double nice_above(double value);
/// The largest 1-2-5 number that is not more than a positive one.
[[nodiscard]] double nice_below(double value);

/// Multiples of a 1-2-5 step in [from, to], about `count` of them.
[[nodiscard]] std::vector<double> linear_ticks(double from, double to, int count);
/// Powers of ten in [from, to], both positive; every n-th where they are more than `most`.
[[nodiscard]] std::vector<double> decades(double from, double to, int most = 8);

/// "0.05", "20", and what is smaller or larger than that as a power of ten: "10⁻⁶", "2·10⁻⁶".
[[nodiscard]] std::string tick_label(double value);

}  // namespace fca::cli
