// SPDX-License-Identifier: BSD-3-Clause
// Checks written files with readers that imitate the real programs (fca/formats/consumers), before anything is saved.
#pragma once

#include "loaded_views.h"

#include <fca/formats/calibration.h>
#include <fca/toolkit/convert.h>

#include <optional>
#include <string>
#include <thread>

namespace fca {

/// Starts a thread that prepares a reader of the format for its first use, for example by loading OpenCV's libraries, which
/// takes as long as a fit. Nobody needs to wait for the thread: a reader that is not prepared yet prepares itself when it is
/// used.
[[nodiscard]] std::jthread prepare_programs(const Format& format);

/// The reason why a program would refuse the files that contain `rig`, if the same program does not refuse `base` for the same
/// reason. `base` may be null. Empty if there is no such program.
[[nodiscard]] Message newly_refused(const Written& written, const Rig& rig, const text::Document* base, LoadedViews& views);

/// Fixes spellings in the kept text of a base that the target's program would refuse ("IMU.Frequency: 200" without a decimal
/// point, a byte order mark), and adds a note about each. Does not change a file that the program would refuse even with all
/// fixes. Returns true if nothing had to be fixed because the programs load every file as it is.
[[nodiscard]] bool fix_kept_text(const Format& format, const Rig& rig, Written& written, LoadedViews& views,
                                 Diagnostics& diagnostics);

/// Adds a warning if no program of the input's format would load the input. The conversion continues, but the input may not be
/// the file which the program used.
void warn_if_refused(const Calibration& calibration, const Inputs& inputs, Diagnostics& diagnostics);

/// Checks that the programs of an output file read `rig` from it, and adds the proofs and diagnostics to `result`. If the
/// output is an edit of a file that the program already refused, its refusal is not an error. A diagnostic also reports an
/// output that no known program reads. `base`: the file that was edited; null for a fresh file.
void verify(const Rig& rig, const ConvertedFile& output, const ConvertRequest& request, const Written& written,
            const text::Document* base, LoadedViews& views, ConvertResult& result);

}  // namespace fca
