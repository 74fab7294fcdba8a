// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/text/source.h>

#include <iosfwd>
#include <string>

namespace fca::text {

/// The bytes of a stream, as a text of that name; of one that does not end, a little more than kMaxFileBytes.
[[nodiscard]] Source read_stream(std::string name, std::istream& stream);

}  // namespace fca::text
