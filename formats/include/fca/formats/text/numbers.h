// SPDX-License-Identifier: BSD-3-Clause
// The one wrapper around std::from_chars and std::to_chars: no locale, no loss.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::text {

/// A whole real or integer literal: "1.5", "-2.", "+.5", "1e-5", "017" (seventeen). Also "nan" and "inf" in YAML's spellings
/// (".nan", "-.Inf") . Nothing if anything else stands there.
[[nodiscard]] std::optional<double> parse_real(std::string_view text);
/// Those of a list or matrix ("[[1.0, 2.0], [3.0, 4.0]]"), in their order; nothing where one cannot be read.
[[nodiscard]] std::optional<std::vector<double>> reals_in(std::string_view list);

/// A whole decimal integer literal that fits.
[[nodiscard]] std::optional<int> parse_int(std::string_view text);

/// The shortest decimal that reads back as the same double, always recognisable as a real by PyYAML, yaml-cpp and
/// cv::FileStorage alike: with a point, and in exponents with point and sign ("20.0", "2.0e-05").
[[nodiscard]] std::string format_real(double value);

/// For people: `digits` significant digits, no trailing zeros.
[[nodiscard]] std::string format_short(double value, int digits = 6);

}  // namespace fca::text
