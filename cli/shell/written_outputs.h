// SPDX-License-Identifier: BSD-3-Clause
// What was converted, put into its places.
#pragma once

#include "commands/convert/finished.h"
#include "console.h"

#include <cstddef>
#include <span>
#include <string>
#include <unordered_set>

namespace fca::cli {

/// So many files, and a few more, are open at the same time.
inline constexpr std::size_t kFilesAtOnce = 256;

class OutputWriter {
 public:
  OutputWriter(const ConvertArguments& arguments, const Console& console) : arguments_(arguments), console_(console) {}

  /// Puts the files of each, all or none, into their places; says in it what went wrong with it. What a killed program has left
  /// next to them goes.
  void write(std::span<Finished> converted);

 private:
  void remove_leftovers_beside(const Finished& converted);

  const ConvertArguments& arguments_;
  const Console& console_;
  std::unordered_set<std::size_t> clean_;  ///< Hashes of folders without leftovers.
};

}  // namespace fca::cli
