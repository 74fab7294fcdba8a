// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/rational.h>

#include "../exact_steps.h"

#include <fca/models/radtan.h>

#include <array>

namespace fca {

std::span<const internal::ExactStep> Rational::exact_steps() {
  static constexpr std::array kSteps = {
      internal::exact_step<internal::widened<Radtan, Rational>>(),
      internal::exact_step<internal::narrowed<Rational, Radtan>>(),
  };
  return kSteps;
}

}  // namespace fca
