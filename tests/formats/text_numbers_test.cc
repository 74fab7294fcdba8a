// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text: the shortest spelling that reads back as the same double and is a real number to every program.
#include "pyyaml.h"

#include <fca/formats/text/numbers.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core/persistence.hpp>

namespace fca::text {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Random bit patterns (every exponent, subnormals, both signs) and the values calibrations have.
std::vector<double> sample_values(int count) {
  std::vector<double> values = {0.0,
                                -0.0,
                                1.0,
                                -1.0,
                                20.0,
                                200.0,
                                1e15,
                                1e16,
                                1e21,
                                1e22,
                                1e23,
                                123456789012345680.0,
                                0.1,
                                1e-4,
                                1e-5,
                                2.2e-5,
                                5e-324,
                                -5e-324,
                                2.2250738585072014e-308,
                                1.7976931348623157e308,
                                1e100,
                                1e-100,
                                190.97847715128717,
                                0.5,
                                4294967296.0,
                                9007199254740993.0};
  std::mt19937_64 random(20260101);
  std::uniform_real_distribution<double> usual(-1000.0, 1000.0);
  while (static_cast<int>(values.size()) < count) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) values.push_back(value);
    values.push_back(usual(random));
    values.push_back(std::round(usual(random)));
  }
  return values;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// The least number of significant digits with which printf says this very double.
int fewest_digits(double value) {
  for (int digits = 1; digits < 17; ++digits) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.*e", digits - 1, value);
    if (std::strtod(buffer, nullptr) == value) return digits;
  }
  return 17;
}

int significant_digits(const std::string& text) {
  std::string digits;
  for (const char c : text.substr(0, text.find('e'))) {
    if (c >= '0' && c <= '9') digits += c;
  }
  digits.erase(0, digits.find_first_not_of('0'));
  digits.erase(digits.find_last_not_of('0') + 1);
  return static_cast<int>(digits.size());
}

TEST(TextNumbers, FormatRealReadsBackBitEqual) {
  for (const double value : sample_values(30'000)) {
    const std::string text = format_real(value);
    const std::optional<double> back = parse_real(text);
    ASSERT_TRUE(back) << text;
    EXPECT_TRUE(same_bits(*back, value)) << text;
    EXPECT_TRUE(same_bits(std::strtod(text.c_str(), nullptr), value)) << text;
  }
}

// Whole numbers beyond 2^53 may be written out: their digits are all there is of them.
TEST(TextNumbers, FormatRealHasNoDigitTooMany) {
  for (const double value : sample_values(10'000)) {
    const bool whole_and_large = std::abs(value) >= 9007199254740992.0 && format_real(value).find('e') == std::string::npos;
    if (value != 0.0 && !whole_and_large) {
      EXPECT_LE(significant_digits(format_real(value)), fewest_digits(value)) << format_real(value);
    }
  }
}

// FORMATS.md 0: PyYAML calls 1e-5 a string and 20 an int.
TEST(TextNumbers, FormatRealIsAFloatToPyYaml) {
  for (const double value : sample_values(30'000)) {
    const consumers::pyyaml::Value typed = consumers::pyyaml::resolve_plain_scalar(format_real(value));
    ASSERT_EQ(typed.kind, consumers::pyyaml::Kind::kFloat) << format_real(value);
    EXPECT_TRUE(same_bits(typed.number, value)) << format_real(value);
  }
}

TEST(TextNumbers, FormatRealIsARealToOpenCv) {
  std::vector<double> values = sample_values(1'000);
  std::string yaml = "%YAML:1.0\n";
  for (std::size_t i = 0; i < values.size(); ++i) yaml += "k" + std::to_string(i) + ": " + format_real(values[i]) + "\n";
  const cv::FileStorage storage(yaml, cv::FileStorage::READ | cv::FileStorage::MEMORY);
  ASSERT_TRUE(storage.isOpened());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const cv::FileNode node = storage["k" + std::to_string(i)];
    ASSERT_TRUE(node.isReal()) << format_real(values[i]);
    EXPECT_TRUE(same_bits(static_cast<double>(node), values[i])) << format_real(values[i]);
  }
}

TEST(TextNumbers, FormatRealOfWhatIsNotFinite) {
  EXPECT_EQ(format_real(kInfinity), ".inf");
  EXPECT_EQ(format_real(-kInfinity), "-.inf");
  EXPECT_EQ(format_real(std::nan("")), ".nan");
}

TEST(TextNumbers, FormatRealExamples) {
  EXPECT_EQ(format_real(20.0), "20.0");
  EXPECT_EQ(format_real(-0.0), "-0.0");
  EXPECT_EQ(format_real(2e-5), "2.0e-05");
  EXPECT_EQ(format_real(0.1), "0.1");
  EXPECT_EQ(format_real(190.97847715128717), "190.97847715128717");
}

TEST(TextNumbers, ParseRealTakesWholeLiterals) {
  const std::pair<const char*, double> kGood[] = {
      {"1.5", 1.5},          {"-2.", -2.0},        {"+.5", 0.5},         {".5", 0.5},
      {"1e-5", 1e-5},        {"1E5", 1e5},         {"017", 17.0},        {"0", 0.0},
      {"-0.0", -0.0},        {"1.0e+002", 100.0},  {"+1e+2", 100.0},     {".inf", kInfinity},
      {"-.Inf", -kInfinity}, {"+.INF", kInfinity}, {"1e400", kInfinity}, {"-1e400", -kInfinity},
      {"1e-400", 0.0},       {"-1e-400", -0.0},    {"5e-324", 5e-324},   {"1.7976931348623157e308", 1.7976931348623157e308},
  };
  for (const auto& [text, value] : kGood) {
    const std::optional<double> read = parse_real(text);
    ASSERT_TRUE(read) << text;
    EXPECT_TRUE(same_bits(*read, value)) << text << " " << *read;
  }
  for (const char* text : {".nan", ".NaN", ".NAN", ".Nan"}) {
    ASSERT_TRUE(parse_real(text)) << text;
    EXPECT_TRUE(std::isnan(*parse_real(text))) << text;
  }
}

// What overflows or vanishes does so by its value, not by the sign of its exponent.
TEST(TextNumbers, ParseRealOfLongLiterals) {
  EXPECT_EQ(parse_real("1" + std::string(400, '0')), kInfinity);
  EXPECT_EQ(parse_real("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(parse_real("-0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(parse_real("0." + std::string(400, '0') + "1e401"), 1.0);
  EXPECT_EQ(parse_real("1" + std::string(400, '0') + "e-400"), 1.0);
  EXPECT_EQ(parse_real("0." + std::string(400, '0') + "1e+2"), 0.0);
  EXPECT_EQ(parse_real("1" + std::string(400, '0') + "e-2"), kInfinity);
  EXPECT_EQ(parse_real("0.0e999999999999"), 0.0);
}

TEST(TextNumbers, ParseRealRefusesWhatIsNotANumber) {
  for (const char* text :
       {"",     " ",    "+",    "-",     ".",   "e5",  "1e",       "1e+",  "--1", "+-1",  "-+1",   "++1",   "1,5",     "1.5 ",
        " 1.5", "1.5x", "0x10", "1_000", "nan", "inf", "infinity", "-nan", "NaN", "1.5f", "1.2.3", "12:30", "\xC2\xB2"}) {
    EXPECT_FALSE(parse_real(text)) << "'" << text << "'";
  }
}

TEST(TextNumbers, ParseInt) {
  EXPECT_EQ(parse_int("512"), 512);
  EXPECT_EQ(parse_int("+5"), 5);
  EXPECT_EQ(parse_int("-2147483648"), std::numeric_limits<int>::min());
  for (const char* text : {"", "2147483648", "4000000000", "512.0", "5e2", "0x10", " 5", "5 ", "+-5", "five"})
    EXPECT_FALSE(parse_int(text)) << text;
}

TEST(TextNumbers, FormatShortIsForPeople) {
  EXPECT_EQ(format_short(0.1234567), "0.123457");
  EXPECT_EQ(format_short(200.0), "200");
  EXPECT_EQ(format_short(2.2e-05), "2.2e-05");
}

}  // namespace
}  // namespace fca::text
