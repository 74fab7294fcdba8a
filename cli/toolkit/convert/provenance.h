// SPDX-License-Identifier: BSD-3-Clause
// Where a written file comes from, as a comment in it.
#pragma once

#include <fca/formats/calibration.h>
#include <fca/toolkit/convert.h>

namespace fca {

/// Adds to every written file that is to have it: the inputs with their SHA-256, the command, the version, and for each of its
/// cameras what was fitted, over which domain, how well. Nothing that changes from run to run, no time. By default files that
/// are composed anew have it; edited ones stay their owner's, but what such a comment said of the file as it was is replaced.
/// Where the syntax has no comments none is written.
void add_provenance(const ConvertRequest& request, const Calibration& calibration, Written& written, ConvertResult& result);

}  // namespace fca
