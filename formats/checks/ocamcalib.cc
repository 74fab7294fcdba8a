// SPDX-License-Identifier: BSD-3-Clause
// What is OCamCalib's own beyond what its reader says (a stale inverse polynomial, an exchanged centre).
#include "topics.h"

#include <fca/code.h>

#include <cmath>

namespace fca::checks {

bool check_ocamcalib(const Subject& subject, Findings& findings) {
  if (!subject.is("ocamcalib")) return false;
  for (const Camera& camera : subject.rig().cameras) {
    const double a0 = std::abs(parameter(camera.model, "a0").value());
    const double a1 = parameter(camera.model, "a1").value();
    // OCamCalib's fit sets a1 = 0: the surface has no cusp on the axis. 1e-6 is a slope of a hair's breadth per image.
    constexpr double kZero = 1e-6;
    if (std::abs(a1) > kZero && a0 > 0.0) {
      findings.add(Code::kOcamA1NotZero, {camera.name, a1}, subject.places.parameter(camera, "a1"));
    }
  }
  return true;
}

}  // namespace fca::checks
