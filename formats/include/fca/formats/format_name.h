// SPDX-License-Identifier: BSD-3-Clause
// What files are called. A format serves several programs, and the files of one of them go by its name, not by the format's.
#pragma once

#include <fca/formats/format.h>

#include <string_view>
#include <vector>

namespace fca {

/// A name that --from and --to take ("orbslam2"), and one for people ("ORB-SLAM2 settings").
struct FormatName {
  std::string_view id;
  std::string_view title;
};

/// That of a document which the format read or wrote.
[[nodiscard]] FormatName name_of(const Format& format, const text::Document& document);
/// The same of its bytes.
[[nodiscard]] FormatName name_of(const Format& format, const text::Source& source);
/// Those that the format's files may have next to the format's own.
[[nodiscard]] std::vector<FormatName> further_names(const Format& format);

}  // namespace fca
