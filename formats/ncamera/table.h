// SPDX-License-Identifier: BSD-3-Clause
// The tables of an ncamera's layouts.
#pragma once

#include "../schema/keys.h"

#include <string_view>

namespace fca::ncamera {

/// The cameras with their poses in the body, and what SVO reads of the IMU; one camera alone; maplab's list of sensors, of
/// which the rows are those of its NCAMERA and of its IMU.
extern const schema::Schema kRig;
extern const schema::Schema kSingle;
extern const schema::Schema kSensors;

/// The keys of maplab's sensors.
extern const schema::Mapping kSensorOfCameras;
extern const schema::Mapping kSensorOfImu;

/// What a key of SVO's tuning has before it in an extra field.
inline constexpr std::string_view kTuningPrefix = "svo.";

inline constexpr std::string_view kImuSection = "imu_params";

/// A fresh file, after which SVO's sections stand where the rig specifies anything for them.
[[nodiscard]] std::string composed(const Rig& rig, Written& written);
/// SVO's two sections; "" where the rig specifies nothing for them.
[[nodiscard]] std::string composed_imu(const Rig& rig, Written& written);
/// The rig's extra fields that a fresh file specifies.
[[nodiscard]] std::vector<ExtraField> carried(const Rig& rig);

}  // namespace fca::ncamera
