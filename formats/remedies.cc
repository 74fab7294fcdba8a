// SPDX-License-Identifier: BSD-3-Clause
#include "remedies.h"

#include <fca/formats/wording.h>

#include <algorithm>
#include <array>

namespace fca {

namespace {

struct Remedy {
  std::string_view code;
  std::string_view what_to_do;
};

constexpr std::array kRemedies = {
    Remedy{"comments-dropped", "copy those that still hold from the old file"},
    Remedy{"topic-dropped", "remap the program's topic to it where you start the program"},
    Remedy{"frame-rate-dropped", "give it to the program by an option of its own, if it asks for one"},
    Remedy{"frame-rate-rounded", "--fps N writes another one"},
    Remedy{"imu-rate-rounded", "nothing below a percent: noise is scaled with the root of the rate"},
    Remedy{"imu-dropped", "keep its file; --to kalibr -o FOLDER/ writes a complete IMU to one"},
    Remedy{"baseline-dropped", "keep it for programs that ask for it by itself"},
    Remedy{"pose-dropped", "keep the input, which says it"},
};
constexpr std::string_view kOfAnyLoss = "keep the input, which says it";

}  // namespace

void add_remedies(std::span<Loss> losses) {
  for (Loss& loss : losses) {
    if (!remedy_of(loss).empty()) continue;
    const auto* const known = std::ranges::find(kRemedies, id_of(loss), &Remedy::code);
    loss.remedy = known == kRemedies.end() ? kOfAnyLoss : known->what_to_do;
  }
}

}  // namespace fca
