// SPDX-License-Identifier: BSD-3-Clause
// Facts in a file, besides the calibration, that become wrong if its images or cameras change.
#pragma once

#include <fca/formats/format.h>

namespace fca {

/// Lists, with a warning, facts in an edited file that are still about the images as they were calibrated
/// (Format::of_the_images). Only the file's owner can compute them again. `rig`: as read from the file.
void list_facts_of_other_images(const Rig& rig, const Format& format, Written& written, Diagnostics& diagnostics);

/// Lists, with a warning, facts that the file of --into, which contains `base`, had computed from its cameras
/// (Format::of_the_lenses), if `rig` has other cameras.
void list_facts_of_other_lenses(const Rig& base, const Rig& rig, const Format& format, Written& written,
                                Diagnostics& diagnostics);

}  // namespace fca
