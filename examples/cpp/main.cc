// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/convert.h>

#include <cstdio>

int main() {  // TUM VI's left camera (Kannala-Brandt) as EUCM, as far as its lens sees: 97.5 degrees from the axis.
  const fca::Intrinsics<fca::Kb4> lens{{190.978, 190.973, 254.932, 256.897, 0.00348, 0.000715, -0.00205, 0.000203}};
  fca::Diagnostics diagnostics;
  const auto result = fca::convert({"left", fca::ImageSize{512, 512}, lens, {}, {}, {}}, {"eucm", 1.7017, {}}, diagnostics);
  for (const fca::Diagnostic& entry : diagnostics.entries()) std::fprintf(stderr, "%s\n", fca::id_of(entry).c_str());
  if (!result) return 1;
  for (const double value : fca::parameter_values(result->camera.model)) std::printf("%.17g\n", value);
  std::printf("rms %.17g px, max %.17g px\n", result->report.statistics.error.rms, result->report.statistics.error.max);
}
