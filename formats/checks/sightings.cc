// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/sightings.h>

#include <algorithm>
#include <array>

namespace fca {

namespace {

// Where a program refuses or misreads a file, no alarm is false: its reader was asked.
constexpr std::array kSightings = {
    Sighting{"baseline-contradicts", 5, 0},  Sighting{"bf-is-a-baseline", 1, 0},
    Sighting{"carla-translation", 4, 0},     Sighting{"centre-off", 2, 0},
    Sighting{"coefficient-repeated", 1, 0},  Sighting{"depth-threshold", 1, 0},
    Sighting{"distortion-missing", 5, 0},    Sighting{"duplicate-key", 3, 0},
    Sighting{"eucm-without-type", 7, 0},     Sighting{"focal-length-not-in-pixels", 2, 0},
    Sighting{"focal-lengths-differ", 12, 6}, Sighting{"folds-inside-image", 22, 0},
    Sighting{"imu-noise-too-large", 8, 3},   Sighting{"imu-sensors-swapped", 7, 0},
    Sighting{"imu-walk-above-noise", 2, 0},  Sighting{"int-for-real", 1, 0},
    Sighting{"key-assumed", 1, 0},           Sighting{"key-misspelt", 2, 0},
    Sighting{"matlab-origin", 1, 0},         Sighting{"matrix-corner", 2, 0},
    Sighting{"merge-conflict", 1, 0},        Sighting{"missing-key", 8, 0},
    Sighting{"mode-refused", 2, 0},          Sighting{"not-a-rotation", 3, 0},
    Sighting{"not-a-transform", 3, 0},       Sighting{"opencv-header", 3, 0},
    Sighting{"poses-contradict", 1, 0},      Sighting{"program-finds-no-camera", 6, 0},
    Sighting{"program-ignores", 2, 0},       Sighting{"program-misreads", 32, 0},
    Sighting{"program-refuses", 80, 0},      Sighting{"real-for-int", 1, 0},
    Sighting{"ros-parameters", 1, 0},        Sighting{"skew", 1, 0},
    Sighting{"tangential-too-large", 8, 0},  Sighting{"undistortion-inexact", 13, 0},
    Sighting{"units-not-stated", 5, 0},      Sighting{"unknown-format", 1, 0},
    Sighting{"unknown-model", 2, 0},
};

}  // namespace

std::span<const Sighting> sightings() { return kSightings; }

Sighting sighting_of(std::string_view id) {
  const auto* const found = std::ranges::find(kSightings, id, &Sighting::id);
  return found == kSightings.end() ? Sighting{id} : *found;
}

}  // namespace fca
