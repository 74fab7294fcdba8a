// SPDX-License-Identifier: BSD-3-Clause
// The origin of a written file, as a comment in it.
#pragma once

#include <fca/formats/calibration.h>
#include <fca/toolkit/convert.h>

namespace fca {

/// Adds a comment to each written file that is to have one: the inputs with their SHA-256, the command, the version and, for
/// each camera in the file, the fit with its field of view and errors. It contains nothing that changes from run to run, such
/// as the time. By default fresh files get it. Edited files do not, but an earlier comment of fca-io in them, which is no
/// longer true, is replaced. Files whose syntax has no comments get none.
void add_provenance(const ConvertRequest& request, const Calibration& calibration, Written& written, ConvertResult& result);

}  // namespace fca
