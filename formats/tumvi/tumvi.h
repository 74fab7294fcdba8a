// SPDX-License-Identifier: BSD-3-Clause
// TUM-VI: the dataset's calibrations. There is no schema of its own: a chain is Kalibr's camchain-imucam with the dataset's
// habits (redundant T_cam_imu and T_cn_cnm1, no timeshift_cam_imu, pinhole-equidistant or omni-radtan), and is detected as
// Kalibr's; this format is chosen by name. Its DSO export, camera.txt, is a format of its own (formats/dso),
// and read and written here, too, where this one is named.
#pragma once

#include <fca/formats/format.h>

namespace fca::tumvi {

extern const Format kFormat;

[[nodiscard]] std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options,
                                      Diagnostics& diagnostics);
[[nodiscard]] std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                                           Diagnostics& diagnostics);

}  // namespace fca::tumvi
