// SPDX-License-Identifier: BSD-3-Clause
// EuRoC (ASL): a sensor.yaml for each sensor of a dataset, mav0/cam0/sensor.yaml, mav0/cam1/sensor.yaml, mav0/imu0/sensor.yaml.
#pragma once

#include <fca/formats/format.h>

namespace fca::euroc {

extern const Format kFormat;

}  // namespace fca::euroc
