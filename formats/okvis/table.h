// SPDX-License-Identifier: BSD-3-Clause
// The tables of OKVIS' configurations.
#pragma once

#include "../schema/keys.h"

#include <string_view>

namespace fca::okvis {

/// What a key of tuning has before its section in an extra field: "okvis.imu_parameters.a_max".
inline constexpr std::string_view kTuningPrefix = "okvis.";

/// An entry of the list of cameras (camera.cc).
extern const schema::Mapping kCamera;
[[nodiscard]] bool read_camera(schema::Reading& reading, const schema::Key& key, const text::Node& node);
/// Of an entry: does it say which model it is, as OKVIS2-X demands?
inline constexpr std::string_view kCameraModel = "cam_model";
inline constexpr std::string_view kEucm = "eucm";

/// All keys of both generations, for readers.
extern const schema::Schema kTable;
/// Those of OKVIS2 and OKVIS2-X, and those of OKVIS: what is edited.
extern const schema::Schema kOkvis2;
extern const schema::Schema kOkvis1;
/// Has the document the keys of the first generation?
[[nodiscard]] bool is_first_generation(const text::Document& document);

/// A fresh file by kOkvis2 or kOkvis1.
[[nodiscard]] std::string composed(const schema::Schema& table, const Rig& rig, Written& written);
/// The rig's extra fields that it specifies.
[[nodiscard]] std::vector<ExtraField> carried_over(const schema::Schema& table, const Rig& rig);

}  // namespace fca::okvis
