// SPDX-License-Identifier: BSD-3-Clause
// The lens of an ncamera's camera: rows of its table.
#pragma once

#include "../schema/keys.h"

namespace fca::ncamera {

/// type, distortion/type, distortion/parameters and intrinsics. The first row reads which lens it is, the others its numbers,
/// after the rows of the image's sides.
[[nodiscard]] bool read_lens(schema::Reading& reading, const schema::Key& key, const text::Node& node);
[[nodiscard]] std::vector<schema::Statement> write_type(const schema::Subject& subject, const schema::Key& key);
extern const schema::Mapping kDistortion;
extern const schema::Mapping kIntrinsics;

/// Are both lenses of OCamCalib's, with the same polynomial?
[[nodiscard]] bool has_same_polynomial(const CameraModel& a, const CameraModel& b);

/// The polynomial of SVO's omni lenses by which it projects: that of the rig for the camera, where it has places for it and is
/// the inverse (of a file that is edited: whatever it is), else one that is fitted. Nothing of other lenses.
[[nodiscard]] std::optional<ExtraField> inverse_of(const Rig& rig, const Camera& camera, bool is_edited, Written& written,
                                                   Diagnostics& diagnostics);

/// Two radii, in halves of the image's height, outside of which SVO's omni lenses show nothing; zeros: they show all.
inline constexpr std::string_view kMask = "mask_relative_radii";

}  // namespace fca::ncamera
