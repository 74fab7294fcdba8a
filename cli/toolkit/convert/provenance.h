// SPDX-License-Identifier: BSD-3-Clause
// Writes a comment into each file that says where the file comes from.
#pragma once

#include <fca/formats/calibration.h>
#include <fca/toolkit/convert.h>

namespace fca {

/// Adds a comment to written files: the version of fca-io, the input files with their SHA-256, the command and, for each camera
/// in the file, the fit with its errors and its largest angle. The comment contains nothing that changes from run to run, such
/// as the time. request.provenance selects the files. By default these are fresh files, and edited files that contain a comment
/// of an earlier conversion: this comment is no longer true and is replaced (with kNone, removed). If all files were selected,
/// a note reports a file whose syntax has no comments.
void add_provenance(const ConvertRequest& request, const Calibration& calibration, Written& written, ConvertResult& result);

}  // namespace fca
