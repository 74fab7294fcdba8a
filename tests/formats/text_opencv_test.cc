// SPDX-License-Identifier: BSD-3-Clause
// The XML and JSON files of the corpus, read by us and by cv::FileStorage.
#include "formats/text_checks.h"

#include <fca/formats/text/dialect.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <iostream>

#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>

namespace fca::test {
namespace {

/// Our number at every place where cv::FileStorage has one. Returns how many.
int expect_same_numbers(const text::Node& ours, const cv::FileNode& theirs) {
  int count = 0;
  if (theirs.isInt() || theirs.isReal()) {
    if (ours.value == "true" || ours.value == "false") return 0;
    const std::optional<double> value = text::parse_real(ours.value);
    EXPECT_TRUE(value) << ours.value;
    // Basalt's nanoseconds: cv::FileStorage keeps the last 32 bits of a whole number.
    const bool wraps = theirs.isInt() && value && std::abs(*value) > 2147483647.0;
    if (value && !wraps) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(*value), std::bit_cast<std::uint64_t>(static_cast<double>(theirs))) << ours.value;
    }
    return 1;
  }
  if (theirs.isSeq()) {
    EXPECT_EQ(ours.items.size(), theirs.size());
    std::size_t i = 0;
    for (cv::FileNodeIterator it = theirs.begin(); it != theirs.end() && i < ours.items.size(); ++it, ++i)
      count += expect_same_numbers(ours.items[i], *it);
  }
  if (theirs.isMap()) {
    for (const std::string& key : theirs.keys()) {
      const text::Node* inner = text::find(ours, key, text::Dialect::kOpenCv);
      EXPECT_NE(inner, nullptr) << key;
      if (inner != nullptr) count += expect_same_numbers(*inner, theirs[key]);
    }
  }
  return count;
}

TEST(TextOpenCv, NumbersOfTheCorpusAreThoseOfOpenCv) {
  if (!fs::exists(shared_dir() / "corpus")) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  cv::redirectError([](int, const char*, const char*, const char*, int, void*) { return 0; });
  int files = 0;
  int numbers = 0;
  for (const fs::directory_entry& each : fs::recursive_directory_iterator(shared_dir() / "corpus")) {
    const fs::path extension = each.path().extension();
    if (extension != ".json" && extension != ".xml") continue;
    SCOPED_TRACE(each.path());
    const std::string bytes = read_file(each.path());
    const Parsed parsed = parse(bytes, each.path());
    try {
      const cv::FileStorage storage(bytes, cv::FileStorage::READ | cv::FileStorage::MEMORY);
      ASSERT_TRUE(parsed.document) << parsed.rendered();
      numbers += expect_same_numbers(parsed.document->root(), storage.root());
      ++files;
    } catch (const cv::Exception& error) {
      std::cout << "  OpenCV refuses " << each.path().filename() << "\n";
    }
  }
  cv::redirectError(nullptr);
  std::cout << "  " << numbers << " numbers of " << files << " files\n";
  EXPECT_GE(files, 30);
  EXPECT_GE(numbers, 1000);
}

}  // namespace
}  // namespace fca::test
