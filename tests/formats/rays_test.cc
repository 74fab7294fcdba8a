// SPDX-License-Identifier: BSD-3-Clause
// Tables of rays: text and .npy say the same, and what is no ray is refused at its place.
#include "test_files.h"

#include <fca/code.h>
#include <fca/formats/calibration.h>
#include <fca/formats/text/read_document.h>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace fca::test {
namespace {

/// u v x y z of a pinhole with a focal length of 100 and its axis at (50, 40).
std::vector<std::array<double, 5>> table() {
  std::vector<std::array<double, 5>> rows;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 5; ++j) {
      const double u = 20.0 * i;
      const double v = 20.0 * j;
      rows.push_back({u, v, (u - 50.0) / 100.0, (v - 40.0) / 100.0, 1.0});
    }
  }
  return rows;
}

std::string as_text(const std::string& separator, const std::string& line_break = "\n") {
  std::ostringstream text;
  text.precision(17);
  for (const std::array<double, 5>& row : table()) {
    for (std::size_t i = 0; i < row.size(); ++i) text << (i > 0 ? separator : "") << row[i];
    text << line_break;
  }
  return text.str();
}

template <class Real, class Bits>
std::string as_npy(const std::string& type, const std::string& shape = "(30, 5)", const std::string& order = "False") {
  std::string header = "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
  header.resize(117, ' ');
  header += '\n';
  std::string bytes = std::string("\x93NUMPY\1\0", 8) + static_cast<char>(header.size()) + '\0' + header;
  for (const std::array<double, 5>& row : table()) {
    for (const double number : row) {
      Bits bits = std::bit_cast<Bits>(static_cast<Real>(number));
      for (std::size_t i = 0; i < sizeof(bits); ++i, bits >>= 8U) bytes += static_cast<char>(bits & 0xFFU);
    }
  }
  return bytes;
}

struct Outcome {
  std::optional<Calibration> calibration;
  Diagnostics diagnostics;

  [[nodiscard]] const Diagnostic* error() const {
    for (const Diagnostic& entry : diagnostics.entries()) {
      if (entry.severity == Severity::kError) return &entry;
    }
    return nullptr;
  }
};

Outcome read(const std::string& name, const std::string& bytes, bool told = true, const ReadOptions& options = {}) {
  Outcome outcome;
  std::optional<text::Document> document = text::parse_document({name, bytes}, outcome.diagnostics);
  if (!document) return outcome;
  const Format* format = told ? find_format("rays") : nullptr;
  if (format == nullptr) {
    const std::optional<DetectedFormat> detected = detect_format(*document, outcome.diagnostics);
    if (!detected) return outcome;
    format = detected->format;
  }
  outcome.calibration = read_calibration({*std::move(document)}, format, options, outcome.diagnostics);
  return outcome;
}

TEST(Rays, EachSpellingSaysTheSame) {
  const Outcome plain = read("rays.txt", as_text(" "));
  ASSERT_TRUE(plain.calibration);
  const Camera& camera = plain.calibration->rig.cameras.at(0);
  ASSERT_EQ(camera.rays.size(), table().size());
  double sum = 0.0;
  const std::vector<std::array<double, 5>> rows = table();
  for (std::size_t i = 0; i < camera.rays.size(); ++i) {
    const auto& [u, v, x, y, z] = rows[i];
    const double length = std::hypot(x, y, z);
    EXPECT_EQ(camera.rays[i].pixel, (Pixel{u, v}));
    EXPECT_NEAR(camera.rays[i].ray[0], x / length, 1e-15);
    EXPECT_NEAR(camera.rays[i].ray[2], z / length, 1e-15);
    sum += camera.rays[i].weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);

  const std::vector<std::pair<std::string, std::string>> others = {
      {"rays.csv", as_text(",")},
      {"rays.csv", as_text(", ")},
      {"rays.csv", "u,v,x,y,z\n" + as_text(",")},
      {"rays.csv", "# of a collimator\n\nu v x y z\n" + as_text("\t")},
      {"rays.txt", as_text(" ", "\r\n")},
      {"rays.txt", "\xEF\xBB\xBF" + as_text(" ")},
      {"rays.npy", as_npy<double, std::uint64_t>("<f8")}};
  for (const auto& [name, bytes] : others) {
    const Outcome other = read(name, bytes);
    ASSERT_TRUE(other.calibration) << bytes.substr(0, 40);
    EXPECT_EQ(other.calibration->rig.cameras.at(0), camera) << bytes.substr(0, 40);
  }
  const Outcome rounded = read("rays.npy", as_npy<float, std::uint32_t>("<f4"));
  ASSERT_TRUE(rounded.calibration);
  for (std::size_t i = 0; i < camera.rays.size(); ++i)
    EXPECT_NEAR(rounded.calibration->rig.cameras.at(0).rays[i].ray[0], camera.rays[i].ray[0], 1e-7);
}

TEST(Rays, AreRecognisedByTheNamesOfTheirColumnsOrByNumpy) {
  for (const auto& [name, bytes] : std::vector<std::pair<std::string, std::string>>{
           {"rays.csv", "u,v,x,y,z\n" + as_text(",")}, {"rays.npy", as_npy<double, std::uint64_t>("<f8")}}) {
    const Outcome outcome = read(name, bytes, false);
    ASSERT_TRUE(outcome.calibration) << name;
    EXPECT_EQ(outcome.calibration->format->id, "rays");
  }
  EXPECT_FALSE(read("numbers.txt", as_text(" "), false).calibration) << "five numbers in a line may be anything";
}

TEST(Rays, WhatIsNoRayIsRefusedAtItsLine) {
  struct Bad {
    std::string line;
    Code code;
  };
  const std::vector<Bad> lines = {{"1 2 3 4", Code::kNumbersWanted},         {"1 2 3 4 5 6", Code::kNumbersWanted},
                                  {"1 2 nan 4 5", Code::kValueNoNumber},     {"1 2 1e999 4 5", Code::kValueNotFinite},
                                  {"1 2 0 0 0", Code::kRayWithoutDirection}, {"1e308 2 0 0 1", Code::kPixelOutOfRange},
                                  {"1 2 a 4 5", Code::kValueNoNumber}};
  for (const Bad& bad : lines) {
    const text::Source source = {"rays.txt", "0 0 0 0 1\n" + bad.line + "\n" + as_text(" ")};
    const Outcome outcome = read(source.name, source.bytes);
    ASSERT_NE(outcome.error(), nullptr) << bad.line;
    EXPECT_EQ(outcome.error()->facts.code, bad.code) << bad.line;
    EXPECT_EQ(source.position(outcome.error()->where.offset).line, 2) << bad.line;
  }
}

TEST(Rays, TablesThatDetermineNoLensAreRefused) {
  const Outcome few = read("rays.txt", "0 0 0 0 1\n1 1 0.1 0.1 1\n");
  ASSERT_NE(few.error(), nullptr);
  EXPECT_EQ(few.error()->facts.code, Code::kTooFewRays);
  std::string same;
  for (int i = 0; i < 40; ++i) same += "5 5 0.1 0.2 1\n";
  const Outcome one_ray = read("rays.txt", same);
  ASSERT_NE(one_ray.error(), nullptr);
  EXPECT_EQ(one_ray.error()->facts.code, Code::kRaysWithoutCentre);
  const Outcome mapping = read("rays.yaml", "a: 1\n");
  ASSERT_NE(mapping.error(), nullptr);
  EXPECT_EQ(mapping.error()->facts.code, Code::kRaysWrongSyntax);
}

// The pixels run from (0, 0) to (100, 80).
TEST(Rays, PixelsOfAnotherImageAreRefused) {
  const auto code_for = [](int width, int height) {
    ReadOptions options;
    options.image_size = ImageSize{width, height};
    const Outcome outcome = read("rays.txt", as_text(" "), true, options);
    return outcome.error() != nullptr ? outcome.error()->facts.code : Code::kNone;
  };
  EXPECT_EQ(code_for(101, 81), Code::kNone);
  EXPECT_EQ(code_for(640, 480), Code::kNone);
  EXPECT_EQ(code_for(50, 40), Code::kRaysOfOtherImage) << "most of them are outside";
  EXPECT_EQ(code_for(6400, 4800), Code::kRaysOfOtherImage) << "all of them are in one corner";
}

TEST(Rays, ColumnsInAnotherOrderAreNoticed) {
  const Outcome outcome = read("rays.csv", "x,y,z,u,v\n" + as_text(","));
  ASSERT_NE(outcome.error(), nullptr);
  EXPECT_EQ(outcome.error()->facts.code, Code::kRaysOfOtherColumns);
}

TEST(Rays, DamagedArraysAreRefused) {
  const std::string whole = as_npy<double, std::uint64_t>("<f8");
  for (const std::size_t size : {6UL, 8UL, 9UL, 11UL, 60UL, whole.size() - 1}) {
    const Outcome outcome = read("rays.npy", whole.substr(0, size));
    ASSERT_NE(outcome.error(), nullptr) << size;
    EXPECT_EQ(outcome.error()->facts.code, Code::kNpyTruncated) << size;
  }
  const Outcome longer = read("rays.npy", as_npy<double, std::uint64_t>("<f8", "(20, 5)"));
  ASSERT_NE(longer.error(), nullptr);
  EXPECT_EQ(longer.error()->facts.code, Code::kNpyLonger);
  for (const std::string& other :
       {as_npy<double, std::uint64_t>(">f8"), as_npy<double, std::uint64_t>("<i8"), as_npy<double, std::uint64_t>("|O"),
        as_npy<double, std::uint64_t>("<f8", "(30, 5)", "True"), as_npy<double, std::uint64_t>("<f8", "(150,)"),
        as_npy<double, std::uint64_t>("<f8", "(10, 5, 3)")}) {
    const Outcome outcome = read("rays.npy", other);
    ASSERT_NE(outcome.error(), nullptr);
    EXPECT_EQ(outcome.error()->facts.code, Code::kNpyOtherArray);
  }
  for (const char* shape : {"(18446744073709551615, 5)", "(3689348814741910324, 5)", "(31, 5)", "(30, 0)"}) {
    const Outcome outcome = read("rays.npy", as_npy<double, std::uint64_t>("<f8", shape));
    ASSERT_NE(outcome.error(), nullptr) << shape;
    EXPECT_EQ(outcome.error()->facts.code, Code::kNpyTruncated) << shape;
  }
}

}  // namespace
}  // namespace fca::test
