// SPDX-License-Identifier: BSD-3-Clause
// Real programs judge what a conversion made, before anything is put in place.
#pragma once

#include "loaded_views.h"

#include <fca/formats/calibration.h>
#include <fca/toolkit/convert.h>

#include <optional>
#include <string>
#include <thread>

namespace fca {

/// Has the programs that read the format get ready while something else is done (OpenCV's libraries take as long as a fit).
/// They are when the thread has ended; nobody needs to wait for it. Where no thread can be started, they get ready when asked.
[[nodiscard]] std::jthread prepare_programs(const Format& format);

/// Why a program would not load what is written of `rig` for it, and did load `base` (null: none); nothing if there is no such
/// program.
[[nodiscard]] Message newly_refused(const Written& written, const Rig& rig, const text::Document* base, LoadedViews& views);

/// What of a base's own text, which an edit keeps, the program that is to read it would refuse only for its spelling
/// (IMU.Frequency: 200, a byte order mark) is mended, with a note of each; where the program would refuse it all the same,
/// nothing is. True if there was nothing to mend: the programs load every file as it stood.
[[nodiscard]] bool mend_kept_text(const Format& format, const Rig& rig, Written& written, LoadedViews& views,
                                  Diagnostics& diagnostics);

/// A warning if the input's own program would not load it: it is read all the same, and may not be what that program used.
void warn_if_refused(const Calibration& calibration, const Inputs& inputs, Diagnostics& diagnostics);

/// Adds to the outcome what the programs of one output make of it. Where the output is an edit of a file that the program
/// refuses itself, that is the file's own defect: told, not held against us. An output without a program is told, too. `base`:
/// null if the output is no edit.
void verify(const Rig& rig, const ConvertedFile& output, const ConvertRequest& request, const Written& written,
            const text::Document* base, LoadedViews& views, ConvertResult& result);

}  // namespace fca
