// SPDX-License-Identifier: BSD-3-Clause
// The covariance of cameras' parameters, of a calibration program of one's own: a table in the same syntax as one of rays.
//
//   covariance cam0 kb4 fx fy cx cy k1 k2 k3 k4
//   1.2e-2 1.1e-2 ...          a row for each of the parameters that the line names, in their order
//
// Blanks or commas between the words. Parameters that no line names were held fixed. More cameras follow with lines of their
// own. Lines that begin with # are not read.
#pragma once

#include <fca/formats/text/document.h>
#include <fca/rig/rig.h>

namespace fca::covariance {

/// Is the first line that specifies something the head of such a table?
[[nodiscard]] bool is_table(const text::Document& document);

/// Adds what it specifies. Errors stand at their places.
void read(const text::Document& document, Rig& rig, Diagnostics& diagnostics);

}  // namespace fca::covariance
