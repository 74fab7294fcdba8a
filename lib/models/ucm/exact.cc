// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/ucm.h>

#include "../exact_steps.h"

#include <fca/models/pinhole.h>

#include <array>

namespace fca {

std::span<const internal::ExactStep> Ucm::exact_steps() {
  static constexpr std::array kSteps = {
      internal::exact_step<internal::widened<Pinhole, Ucm>>(),
      internal::exact_step<internal::narrowed<Ucm, Pinhole>>(),
  };
  return kSteps;
}

}  // namespace fca
