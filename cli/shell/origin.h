// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace fca::cli {

/// From which state of the sources the command was built.
struct Origin {
  std::string_view commit;  ///< 40 digits; empty: not built from a git repository.
  std::string_view date;    ///< Of the commit, else of the release: "2026-11-27", in UTC; empty: not known.
  bool is_changed = false;  ///< The sources had changes that are in no commit.
};

/// Of this build. Only the executable has it: a commit makes nothing else link again.
[[nodiscard]] Origin origin_of_build();

}  // namespace fca::cli
