// SPDX-License-Identifier: BSD-3-Clause
// What a batch puts aside: all of it comes back, and nothing is seen of it.
#include "shell/spool.h"

#include "cli/run_program.h"

#include <atomic>
#include <thread>

#include <sys/stat.h>

namespace fca::test {
namespace {

using cli::Spool;

/// Different for each, some with NULs.
std::string piece_number(std::size_t i) {
  std::string text = std::to_string(i) + std::string(1 + i % 5000, static_cast<char>(i % 7));
  return text + std::to_string(i);
}

TEST(Spool, GivesBackWhatItGotInAnyOrder) {
  const TemporaryFolder folder;
  Spool spool(folder.path().string());
  constexpr std::size_t kPieces = 2000;
  std::vector<Spool::Piece> pieces;
  for (std::size_t i = 0; i < kPieces; ++i) pieces.push_back(spool.put(piece_number(i)));
  EXPECT_EQ(folder.names(), std::set<std::string>()) << "a killed program would leave it";
  for (std::size_t i = 0; i < kPieces; i += 3) EXPECT_EQ(spool.look(pieces[i]), piece_number(i));
  for (std::size_t i = kPieces; i-- > 0;) EXPECT_EQ(spool.take(pieces[i]), piece_number(i));
  EXPECT_EQ(spool.take(spool.put("")), "");
  EXPECT_EQ(spool.take(spool.put("behind the others")), "behind the others");
}

TEST(Spool, IsUsedBySeveralThreads) {
  const TemporaryFolder folder;
  Spool spool(folder.path().string());
  constexpr std::size_t kThreads = 4;
  std::vector<std::jthread> threads;
  std::atomic<int> wrong = 0;
  for (std::size_t thread = 0; thread < kThreads; ++thread) {
    threads.emplace_back([&spool, &wrong, thread] {
      std::vector<Spool::Piece> pieces;
      for (std::size_t i = 0; i < 500; ++i) pieces.push_back(spool.put(piece_number(i * kThreads + thread)));
      for (std::size_t i = 0; i < 500; ++i) wrong += spool.take(pieces[i]) == piece_number(i * kThreads + thread) ? 0 : 1;
    });
  }
  threads.clear();
  EXPECT_EQ(wrong, 0);
}

// A folder that takes no file, or is not there.
TEST(Spool, WorksWhereItsFolderCannotBeUsed) {
  for (const char* folder : {"/proc", "/no/such/folder", ""}) {
    Spool spool(folder);
    std::vector<Spool::Piece> pieces;
    for (std::size_t i = 0; i < 200; ++i) pieces.push_back(spool.put(piece_number(i)));
    for (std::size_t i = 0; i < 200; ++i) EXPECT_EQ(spool.take(pieces[i]), piece_number(i)) << folder;
  }
}

TEST(Spool, TakesNoMoreRoomThanWhatIsYetToBeTaken) {
  const TemporaryFolder folder;
  Spool spool(folder.path().string());
  const std::string megabyte(1U << 20U, 'x');
  /// Of the file, which has no name: by its place among what this process has open.
  const auto room = [&folder] {
    for (const fs::directory_entry& open : fs::directory_iterator("/proc/self/fd")) {
      std::error_code ignored;
      struct stat status {};
      if (fs::read_symlink(open.path(), ignored).string().starts_with(folder.path().string() + "/") &&
          ::stat(open.path().c_str(), &status) == 0)
        return static_cast<double>(status.st_blocks) * 512.0;
    }
    return -1.0;
  };
  std::vector<Spool::Piece> pieces;
  for (int i = 0; i < 8; ++i) pieces.push_back(spool.put(megabyte));
  const double full = room();
  ASSERT_GE(full, 7.0 * static_cast<double>(megabyte.size()));
  for (int i = 0; i < 8; ++i) EXPECT_EQ(spool.take(pieces[static_cast<std::size_t>(i)]), megabyte);
  if (room() == full) GTEST_SKIP() << "the file system knows no holes";
  EXPECT_LE(room(), 0.2 * static_cast<double>(megabyte.size()));
}

}  // namespace
}  // namespace fca::test
