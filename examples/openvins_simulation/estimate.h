// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "flight.h"

#include <string>
#include <vector>

namespace flight {

/// The flight as OpenVINS' estimator finds it with the calibration of `config`, started from the true state: a pose for each
/// of the flight's images. OpenVINS may end the program where its filter breaks.
[[nodiscard]] std::vector<Pose> estimate(const Flight& flight, const std::string& config);

}  // namespace flight
