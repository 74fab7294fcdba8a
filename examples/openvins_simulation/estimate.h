// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "flight.h"

#include <string>
#include <vector>

namespace flight {

/// What OpenVINS' estimator makes of the flight with the calibration of `config`, started from the true state: a pose for each
/// of the flight's images. OpenVINS may end the program where its filter breaks.
[[nodiscard]] std::vector<Pose> estimate(const Flight& flight, const std::string& config);

}  // namespace flight
