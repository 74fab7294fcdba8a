// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/opencv14.h>

#include "../exact_steps.h"

#include <fca/models/rational.h>

#include <array>

namespace fca {

std::span<const internal::ExactStep> Opencv14::exact_steps() {
  static constexpr std::array kSteps = {
      internal::exact_step<internal::widened<Rational, Opencv14>>(),
      internal::exact_step<internal::narrowed<Opencv14, Rational>>(),
  };
  return kSteps;
}

}  // namespace fca
