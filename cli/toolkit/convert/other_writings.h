// SPDX-License-Identifier: BSD-3-Clause
// After a file was written and proven: other ways to write the same calibration, of which the program may misread less. Each is
// written and proven, too, and the best becomes the result.
#pragma once

#include "start.h"

namespace fca {

/// The distance in pixels (rms over the image) between the converted camera and the one that the target program sees in the
/// file, of the camera with the largest; 0 where no program was asked.
[[nodiscard]] double worst_rms_px(const ConvertResult& result);
/// The same distance at the worst pixel of all cameras.
[[nodiscard]] double worst_max_px(const ConvertResult& result);

/// Where the program misreads a camera, writes the other layouts, too, each in the cameras' own models or, where it does not
/// hold those, in the best that it holds. The best for that program becomes the result, unless the request asks for a layout or
/// a model; the rest is listed (ConvertResult::others). `before`: the result as it was before anything was written.
void try_other_layouts(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result);

/// Where the program gives up rays that the model of a fitted camera has (3dgrut those at the border of a wide lens), writes
/// the models that may be chosen, too. The one with which it gives up the least of the images becomes the result, if it is good
/// there. Without effect where the request names a model or a file to write into.
void try_other_models(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result);

/// Where cameras of wide lenses are fitted and the program is off, fits them to the inscribed circles of their images alone,
/// and says what that is worth (ConvertResult::nearer). The result stays the fit to the whole lens.
void try_nearer_fit(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result);

}  // namespace fca
