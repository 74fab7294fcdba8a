// SPDX-License-Identifier: BSD-3-Clause
// Reports facts in a file that are no part of the calibration but become wrong if the images or cameras change.
#pragma once

#include <fca/formats/format.h>

namespace fca {

/// For an edited file whose images changed (size, crop): adds a warning and a loss with the facts that are still those of the
/// calibrated images (Format::of_the_images). Only the owner of the file can compute them again. `rig`: as read from the file.
void list_facts_of_other_images(const Rig& rig, const Format& format, Written& written, Diagnostics& diagnostics);

/// For an edited file of --into: adds a warning and a loss with the facts that were computed from the former cameras and poses
/// (Format::of_the_lenses). `base`: the rig that the file contained. `rig`: the rig that it contains now. Adds nothing if both
/// have the same models, poses and baseline.
void list_facts_of_other_lenses(const Rig& base, const Rig& rig, const Format& format, Written& written,
                                Diagnostics& diagnostics);

}  // namespace fca
