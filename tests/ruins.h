// SPDX-License-Identifier: BSD-3-Clause
// Files broken at random places.
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace fca::test {

/// A cut, a flipped byte, a doubled or lost piece, a number turned into an odd one.
inline std::string ruined(std::string bytes, std::mt19937& random) {
  const auto place = [&random](const std::string& text) { return text.empty() ? std::size_t{0} : random() % text.size(); };
  static const std::vector<std::string> kOdd = {"1.0e+308",
                                                "-1.0e+308",
                                                ".nan",
                                                "-.inf",
                                                "0",
                                                "0.0",
                                                "-0.0",
                                                "1e-320",
                                                "99999999999999999999",
                                                "[",
                                                "]",
                                                "{",
                                                "}",
                                                "\"",
                                                "'",
                                                "&a ",
                                                "*a",
                                                "!!x ",
                                                "|",
                                                ">",
                                                "\t",
                                                "\r",
                                                std::string(1, '\0'),
                                                "\xFF",
                                                "\xEF\xBB\xBF",
                                                "---\n",
                                                "%YAML:1.0\n",
                                                "- ",
                                                ": ",
                                                "#",
                                                "? ",
                                                ",",
                                                "0x10",
                                                "1_0",
                                                "~"};
  switch (random() % 6) {
    case 0:
      return bytes.substr(0, place(bytes));
    case 1:
      if (!bytes.empty()) bytes[place(bytes)] = static_cast<char>(random() % 256);
      return bytes;
    case 2:
      return bytes.erase(place(bytes), 1 + random() % 40);
    case 3:
      return bytes.insert(place(bytes), bytes.substr(place(bytes), 1 + random() % 200));
    case 4:
      return bytes.insert(place(bytes), kOdd[random() % kOdd.size()]);
    default: {
      // A number, where the damage passes the syntax and reaches the models.
      std::size_t at = bytes.find_first_of("0123456789", place(bytes));
      if (at == std::string::npos) return bytes;
      const std::size_t end = std::min(bytes.find_first_not_of("0123456789.eE+-", at), bytes.size());
      return bytes.replace(at, end - at, kOdd[random() % 9]);
    }
  }
}

}  // namespace fca::test
