// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/ray_table.h>

#include "../evaluation/summary.h"

#include <fca/models/linear_fit.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fca {

std::optional<LensCentre> centre_of(std::span<const Correspondence> table) {
  std::vector<Correspondence> inner(table.begin(), table.end());
  std::ranges::sort(inner, {}, [](const Correspondence& c) { return angle_from_axis(c.ray); });
  constexpr std::size_t kFewest = 6;
  inner.resize(std::min(inner.size(), std::max(kFewest, inner.size() / 4)));
  LensCentre centre;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    internal::LinearFit<2> fit;
    for (const Correspondence& c : inner) {
      const double sine = std::hypot(c.ray[0], c.ray[1]);
      const double along = sine > 0.0 ? angle_from_axis(c.ray) * c.ray[axis] / sine : 0.0;
      fit.add({along, 1.0}, c.pixel[axis], c.weight);
    }
    std::array<double, 2> solution{};
    fit.solve(solution.data());
    if (!(solution[0] > 0.0) || !std::isfinite(solution[0]) || !std::isfinite(solution[1])) return std::nullopt;
    centre.focal[axis] = solution[0];
    centre.point[axis] = solution[1];
  }
  return centre;
}

ErrorSummary judge(std::span<const Correspondence> table, const Projection& target) {
  constexpr int kBinsPerOctave = 1024;  // percentiles to 0.1 %
  internal::Summary summary(kBinsPerOctave);
  internal::Batch batch;
  batch.spread.fill(0.0);
  std::size_t count = 0;
  const auto add = [&] {
    summary.add(batch, count);
    count = 0;
  };
  for (const Correspondence& c : table) {
    batch.u[count] = c.pixel[0];
    batch.v[count] = c.pixel[1];
    batch.weight[count] = c.weight;
    batch.z[count] = std::cos(angle_from_axis(c.ray));
    batch.verdict[count] = internal::Verdict::kUnrepresentable;
    if (const std::optional<Pixel> image = target(c.ray)) {
      const double error = std::hypot((*image)[0] - c.pixel[0], (*image)[1] - c.pixel[1]);
      if (std::isfinite(error)) {
        batch.error[count] = error;
        batch.verdict[count] = internal::Verdict::kScored;
      }
    }
    if (++count == internal::Batch::kSize) add();
  }
  add();
  return summary.judgement({}).error;
}

}  // namespace fca
