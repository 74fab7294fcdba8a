// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "toolkit/conversion.h"

namespace fca::cli {

/// Does -o have room for all files? False with an error, as a wrong use of the command.
[[nodiscard]] bool have_place(const ConvertArguments& arguments, const Written& written, ConvertOutcome& outcome);

/// The outputs: path and bytes of each file of outcome.written. Those with cameras all have a place (have_place() was asked);
/// another one beside them only in a folder: elsewhere it is a loss, and said. False with an error where one would replace an
/// image of --lens-circle.
[[nodiscard]] bool place_outputs(const ConvertArguments& arguments, ConvertOutcome& outcome);

}  // namespace fca::cli
