// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "outcome.h"
#include "shell/json.h"

#include <fca/diagnostics.h>
#include <fca/formats/text/source.h>

#include <cstddef>
#include <span>
#include <string>

namespace fca::cli {

/// The members of one conversion's object, as CLI.md names them.
/// `sources`: what its diagnostics point into.
void put_conversion(Json& json, const ConvertOutcome& outcome, std::span<const text::Source> sources);

/// The object of one conversion.
[[nodiscard]] std::string conversion_json(const ConvertOutcome& outcome, std::span<const text::Source> sources);
/// The same once its files could not be written, and why.
[[nodiscard]] std::string unwritten_json(const std::string& conversion, ExitCode code, const Diagnostics& why);

/// The text that --json prints, piece by piece: one conversion's object is the document, several are a list in it.
class ConversionsJson {
 public:
  /// The next conversion_json(), of so many, with what stands before it.
  [[nodiscard]] std::string next(const std::string& conversion, std::size_t conversions);
  /// What stands after the last one.
  [[nodiscard]] std::string end(std::size_t conversions) const;

 private:
  bool is_begun_ = false;
};

/// The text that --json-lines prints for one: what --json prints for it alone, in one line.
[[nodiscard]] std::string conversion_line(const std::string& conversion);

}  // namespace fca::cli
