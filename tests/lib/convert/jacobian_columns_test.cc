// SPDX-License-Identifier: BSD-3-Clause
// Fits must not depend on the processor: what it makes of many samples at a time is, to the last bit, what this test, compiled
// for any processor, makes of each.
#include "convert/fitting/jacobian_columns.h"
#include "random_model.h"

#include <fca/models/camera_model.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

namespace fca {
namespace {

/// Rays on a spiral from the axis, some behind the camera, each with a pixel and a weight of its own.
std::vector<Correspondence> spiral(std::size_t count, double furthest_rad) {
  std::vector<Correspondence> samples;
  for (std::size_t k = 0; k < count; ++k) {
    const auto turn = static_cast<double>(k);
    const double angle = furthest_rad * turn / static_cast<double>(count);
    const Ray ray = {std::sin(angle) * std::cos(0.7 * turn), std::sin(angle) * std::sin(0.7 * turn), std::cos(angle)};
    samples.push_back({ray, {320.0 + 10.0 * ray[0], 240.0 - 7.0 * ray[1]}, 1.0 / (1.0 + turn)});
  }
  return samples;
}

struct Outcome {
  bool valid = false;
  std::vector<double> numbers;
};

template <class ComputeJacobian>
Outcome outcome_of(const CameraModel& model, std::span<const Correspondence> samples, const ComputeJacobian& compute_jacobian) {
  std::vector<double> roots;
  for (const Correspondence& s : samples) roots.push_back(std::sqrt(s.weight));
  Outcome outcome;
  outcome.numbers.resize((parameter_values(model).size() + 1) * 2 * samples.size());
  outcome.valid = compute_jacobian(internal::JacobianColumns{roots, outcome.numbers.data()});
  return outcome;
}

// A block has 16 samples: fewer, whole ones, and a rest.
RC_GTEST_PROP(JacobianColumns, AreThoseOfEachSampleToTheLastBit, ()) {
  const CameraModel model = test::random_model(*rc::gen::inRange<std::size_t>(0, all_models().size()));
  const std::size_t count = *rc::gen::elementOf(std::vector<std::size_t>{1, 7, 16, 32, 45});
  const double furthest = *rc::gen::elementOf(std::vector<double>{0.4, 1.2, 2.4});
  const std::vector<Correspondence> samples = spiral(count, furthest);
  std::visit(
      [&]<class M>(const Intrinsics<M>& m) {
        if constexpr (internal::HasDerivatives<M>) {
          const Outcome together = outcome_of(model, samples, [&](const internal::JacobianColumns& out) {
            return internal::jacobian_columns(std::type_identity<M>(), m.values.data(), samples, out);
          });
          const Outcome each = outcome_of(model, samples, [&](const internal::JacobianColumns& out) {
            return internal::FitTargetOf<M>().compute_jacobian(m.values.data(), samples, out);
          });
          RC_ASSERT(together.valid == each.valid);
          if (each.valid) RC_ASSERT(together.numbers == each.numbers);
          RC_CLASSIFY(each.valid, "valid");
        }
      },
      model);
}

}  // namespace
}  // namespace fca
