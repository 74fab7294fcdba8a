// SPDX-License-Identifier: BSD-3-Clause
// What runs at the same time; where no thread can be started, tests/package/few_threads.
#include "toolkit/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <vector>

namespace fca::test {
namespace {

TEST(ParallelFor, CallsEachOnce) {
  for (const std::size_t jobs : {0, 1, 2, 7, 100}) {
    for (const std::size_t count : {0, 1, 2, 50}) {
      std::vector<std::atomic<int>> calls(count);
      parallel_for(count, jobs, [&calls](std::size_t i) { ++calls[i]; });
      for (const std::atomic<int>& each : calls) EXPECT_EQ(each, 1) << jobs << " jobs, " << count << " calls";
    }
  }
}

TEST(ParallelFor, AnExceptionReachesTheCallerAfterAllHaveEnded) {
  for (const std::size_t jobs : {1, 2, 4}) {
    for (const std::size_t bad : {0, 1, 2, 3}) {
      std::atomic<int> running = 0;
      const auto body = [&running, bad](std::size_t i) {
        ++running;
        if (i == bad) {
          --running;
          throw std::runtime_error("the one of " + std::to_string(i));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        --running;
      };
      try {
        parallel_for(20, jobs, body);
        FAIL() << "no exception";
      } catch (const std::runtime_error& error) {
        EXPECT_EQ(error.what(), "the one of " + std::to_string(bad));
      }
      EXPECT_EQ(running, 0);
    }
  }
}

TEST(ParallelFor, NoFurtherOneBeginsAfterAnException) {
  std::atomic<int> begun = 0;
  const auto body = [&begun](std::size_t) {
    ++begun;
    throw std::runtime_error("at once");
  };
  EXPECT_THROW(parallel_for(1000, 2, body), std::runtime_error);
  EXPECT_LE(begun, 2);
}

TEST(InBackground, WhatThrowsIsDropped) {
  std::atomic<bool> done = false;
  {
    const std::jthread task = in_background([&done] { done = true; });
  }
  EXPECT_TRUE(done);
  {
    const std::jthread task = in_background([] { throw std::runtime_error("nobody hears it"); });
  }
}

}  // namespace
}  // namespace fca::test
