// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/radtan.h>

#include "../exact_steps.h"

#include <fca/models/pinhole.h>

#include <array>

namespace fca {

std::span<const internal::ExactStep> Radtan::exact_steps() {
  static constexpr std::array kSteps = {
      internal::exact_step<internal::widened<Pinhole, Radtan>>(),
      internal::exact_step<internal::narrowed<Radtan, Pinhole>>(),
  };
  return kSteps;
}

}  // namespace fca
