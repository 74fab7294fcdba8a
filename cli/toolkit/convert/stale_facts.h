// SPDX-License-Identifier: BSD-3-Clause
// Facts beside the calibration that a changed image, or another camera, makes wrong.
#pragma once

#include <fca/formats/format.h>

namespace fca {

/// Lists, and warns of, what an edited file still says about the images as they were calibrated (Format::of_the_images): nobody
/// but its owner can compute it anew. `rig`: as read from the file.
void list_facts_of_other_images(const Rig& rig, const Format& format, Written& written, Diagnostics& diagnostics);

/// The same of what the file written into, which says `base`, had computed from its cameras (Format::of_the_lenses), where
/// `rig` has others.
void list_facts_of_other_lenses(const Rig& base, const Rig& rig, const Format& format, Written& written,
                                Diagnostics& diagnostics);

}  // namespace fca
