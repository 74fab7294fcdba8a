// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/calibration.h>

#include <map>
#include <string>

namespace fca {

/// A configuration next to camera files (Format::facts_apart) counts their cameras: its "cam0" is that of the first one. The
/// cameras of `written` by those names.
[[nodiscard]] std::map<std::string, std::string> counted_cameras(const Written& written);

/// The rig's poses under those names. Poses of cameras that `written` has not are left out where another has got their name.
[[nodiscard]] Rig with_counted_cameras(Rig rig, const Written& written);

}  // namespace fca
