// SPDX-License-Identifier: BSD-3-Clause
// The source may be a table of rays and their pixels: from a collimator, a target at known places, or, as here, a lens's data
// sheet, which gives the image height for every ten degrees from the axis.
#include <fca/convert/fit.h>
#include <fca/convert/ray_table.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

int main() {
  constexpr double kHeightMm[] = {0.0, 0.261, 0.521, 0.776, 1.026, 1.268, 1.5, 1.721, 1.928, 2.121};  // at 0, 10, ... 90 deg
  constexpr double kPixelMm = 0.003, kCentre[] = {960.0, 540.0};
  constexpr int kAround = 12;
  std::vector<fca::Correspondence> table;
  double weights = 0.0;
  for (std::size_t i = 0; i < std::size(kHeightMm); ++i) {
    const double angle = static_cast<double>(i) * std::numbers::pi / 18.0, radius = kHeightMm[i] / kPixelMm;
    for (int j = 0; j < kAround; ++j) {
      const double around = 2.0 * std::numbers::pi * j / kAround, c = std::cos(around), s = std::sin(around);
      fca::Correspondence entry;
      entry.ray = {std::sin(angle) * c, std::sin(angle) * s, std::cos(angle)};
      entry.pixel = {kCentre[0] + radius * c, kCentre[1] + radius * s};
      entry.weight = radius;  // a wider ring holds more of the image
      weights += entry.weight;
      table.push_back(entry);
    }
  }
  for (fca::Correspondence& entry : table) entry.weight /= weights;
  const auto centre = fca::centre_of(table);
  if (!centre) return 1;
  const auto kb4 = fca::fit<fca::Kb4>(table, *centre);
  const auto eucm = fca::fit<fca::Eucm>(table, *centre);
  if (!kb4 || !eucm) return 1;
  const fca::ErrorSummary as_kb4 = fca::evaluate(table, fca::projection_of(kb4->model));
  const fca::ErrorSummary as_eucm = fca::evaluate(table, fca::projection_of(eucm->model));
  std::printf("a data sheet's lens: focal length %.1f px, centre (%.1f, %.1f)\n", kb4->model.values[0], kb4->model.values[2],
              kb4->model.values[3]);
  std::printf("  as kb4:  rms %.3f px, max %.3f px (the sheet's digits are worth %.2f px)\n", as_kb4.rms, as_kb4.max,
              0.0005 / kPixelMm);
  std::printf("  as eucm: rms %.3f px, max %.3f px\n", as_eucm.rms, as_eucm.max);
  return kb4->reaches_all && as_kb4.max < 0.5 ? 0 : 1;
}
