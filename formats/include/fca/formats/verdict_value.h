// SPDX-License-Identifier: BSD-3-Clause
// Whether to use a file: one of three words, and the reasons for it. Text, JSON, pages and libraries show the same value.
#pragma once

#include <fca/formats/pixel_distance.h>
#include <fca/message.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca {

/// The worst of the reasons.
enum class VerdictWord : std::uint8_t { kReady, kUseWithCare, kDoNotUse };

/// "ready", "use-with-care", "do-not-use"
[[nodiscard]] std::string_view name_of(VerdictWord word);

/// Why a file is less than ready. fca/formats/wording.h words it.
struct Reason {
  VerdictWord word = VerdictWord::kUseWithCare;
  Message facts;
  std::string camera = {};                     ///< By its name in the rig; empty: it is about the whole file.
  std::optional<PixelDistance> distance = {};  ///< Where pixels decide.
  Message remedy = {};                         ///< What to do, where the table does not know it.
  Code kind = {};                              ///< Whose id it has, where that is not the sentence's.
  bool is_accepted = false;                    ///< By the user: it does no more than ask for care.
  Message addition = {};                       ///< A clause after the facts; may be none.
};

/// Limits that the user set are not overruled by the user.
[[nodiscard]] bool may_be_accepted(const Reason& reason);
[[nodiscard]] bool may_be_accepted(Code code);

struct Verdict {
  VerdictWord word = VerdictWord::kReady;
  std::vector<Reason> reasons;  ///< The worst first.
};

/// A reason that the user overrules.
struct Acceptance {
  Code code = {};           ///< One of those that have the reason's id.
  std::string camera = {};  ///< Empty: of any.
  [[nodiscard]] bool covers(const Reason& reason) const;
};

}  // namespace fca
