// SPDX-License-Identifier: BSD-3-Clause
// An existing file says something new: the same keys, only the changed bytes.
#pragma once

#include "derived.h"
#include "layout.h"

#include <fca/formats/format.h>

#include <optional>
#include <string>

namespace fca::opencv {

struct Base {
  const text::Document& document;
  Layout layout;
  Rig rig;                 ///< As read from it.
  bool ambiguous = false;  ///< Nothing in it says what its four numbers are.
};

/// Reads a file that is to be edited. Where it does not say what its four numbers are, `rig` does: they are the same numbers.
[[nodiscard]] std::optional<Base> read_base(const text::Document& document, const Rig& rig);

/// What a file says besides cameras and poses.
[[nodiscard]] std::vector<ExtraField> extras_of(const text::Document& document);

struct Edited {
  text::Document document;
  Rig old;
  Layout layout;
  StaleKeys stale;         ///< Of the base's; its document must live as long.
  bool ambiguous = false;  ///< As the base was, and is yet.
};

/// Nothing, and `why` says why, where its keys cannot hold the rig.
[[nodiscard]] std::optional<Edited> edit(const Base& base, const Rig& rig, Message& why);

/// Which of kLayoutNames a file's keys are nearest to.
[[nodiscard]] std::string name_of_layout(const Layout& layout);

/// Do programs around OpenCV's samples know these keys, and understand the cameras without being told what they are, or as
/// they are `told`?
[[nodiscard]] bool samples_read(const Layout& layout, const Rig& rig, bool told);

}  // namespace fca::opencv
