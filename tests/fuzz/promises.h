// SPDX-License-Identifier: BSD-3-Clause
// What fca-io promises of any bytes, as functions that the fuzzer, the mutation test and the replay of old crashes share.
#pragma once

#include <fca/formats/calibration.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::fuzz {

/// Promises that were broken, a sentence each; empty: none.
using Complaints = std::vector<std::string>;

/// How much is asked of bytes that are read.
enum class Depth {
  kRead,       ///< Written back.
  kRoundTrip,  ///< Also rewritten, and for one other program.
  kChecked,    ///< Also checked and fixed, which asks the programs.
};

/// The syntax's parser: it refuses with a reason, or every place of its tree lies inside the bytes, parents around children.
[[nodiscard]] Complaints parse_promises(text::Syntax syntax, std::string_view bytes);

/// Read as that format (null: detected), then:
/// - written into itself not a byte changes;
/// - rewritten, and for another program (which one depends on the bytes), with the models that takes, the result is read and
///   holds the same cameras: names, image sizes and, up to the digits that files have, parameters;
/// - whatever is refused has an error that says why.
[[nodiscard]] Complaints read_promises(const Format* format, std::string_view bytes, const std::string& name, Depth depth);

/// The rig with models that the format stores, fitted where they must be; nothing where a camera cannot be one of them.
[[nodiscard]] std::optional<Rig> as_stored(const Format& format, Rig rig, Complaints& complaints);

/// The promises of writing alone, for a rig from anywhere.
[[nodiscard]] Complaints write_promises(const Format& format, const Rig& rig);

}  // namespace fca::fuzz
