// SPDX-License-Identifier: BSD-3-Clause
// What a program says of a file, asked by code, path and values.
#pragma once

#include "id_and_arguments.h"

#include <fca/code.h>
#include <fca/formats/consumers/consumer.h>
#include <fca/formats/wording.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace fca::consumers {

/// `values`: those among its arguments that a test is about, at any depth.
inline bool complains(const std::vector<Complaint>& complaints, Code code, std::string_view key,
                      const std::vector<Argument>& values = {}) {
  return std::ranges::any_of(complaints, [&](const Complaint& complaint) {
    return complaint.key == key && test::is_said_of(complaint.facts, code, values);
  });
}

/// For the message of a test that fails.
inline std::string joined(const std::vector<Complaint>& complaints) {
  std::string result;
  for (const Complaint& complaint : complaints) {
    result += "'" + complaint.key + "': " + test::id_and_arguments(complaint.facts) + ": " + sentence_of(complaint) + "\n";
  }
  return result;
}

inline void expect_refused(const ConsumerView& view, Code code, std::string_view key = "",
                           const std::vector<Argument>& values = {}) {
  EXPECT_FALSE(view.loads()) << "expected: " << info(code).text;
  EXPECT_TRUE(complains(view.refusals, code, key, values)) << joined(view.refusals) << "lacks: " << info(code).text;
  EXPECT_TRUE(view.cameras.empty());
  EXPECT_TRUE(view.poses.empty());
}

inline void expect_warning(const ConsumerView& view, Code code, std::string_view key = "",
                           const std::vector<Argument>& values = {}) {
  EXPECT_TRUE(view.loads()) << joined(view.refusals);
  EXPECT_TRUE(complains(view.warnings, code, key, values)) << joined(view.warnings) << "lacks: " << info(code).text;
}

}  // namespace fca::consumers
