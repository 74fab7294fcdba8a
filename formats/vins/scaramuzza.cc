// SPDX-License-Identifier: BSD-3-Clause
#include "scaramuzza.h"

#include <fca/models/ocamcalib_parameters.h>

#include <algorithm>

namespace fca::vins {

namespace {

Scaramuzza camodocals(const CameraModel& model, std::span<const double> inverse) {
  const auto value = [&model](ParameterId id) { return parameter(model, id).value(); };
  const double c = value("c");
  Scaramuzza result;
  double factor = c;
  for (std::size_t i = 0; i < result.direct.size(); ++i) {
    result.direct.at(i) = factor * value(kOcamcalibCoefficients.at(i));
    factor /= c;
  }
  for (std::size_t i = 0; i < std::min(inverse.size(), result.inverse.size()); ++i) result.inverse.at(i) = c * inverse[i];
  result.ac = 1.0 / c;
  result.ad = value("e") / c;
  result.ae = value("d") / c;
  result.cx = value("cx");
  result.cy = value("cy");
  return result;
}

Section polynomial(std::string_view name, std::span<const double> coefficients) {
  Section section{std::string(name), {}};
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    section.fields.push_back(fields::real("p" + std::to_string(i), coefficients[i]));
  return section;
}

}  // namespace

CameraModel ocamcalib_of(const Scaramuzza& numbers) {
  CameraModel model = *make_model("ocamcalib");
  const double c = 1.0 / numbers.ac;
  set_parameter(model, "c", c);
  set_parameter(model, "d", numbers.ae / numbers.ac);
  set_parameter(model, "e", numbers.ad / numbers.ac);
  set_parameter(model, "cx", numbers.cx);
  set_parameter(model, "cy", numbers.cy);
  double factor = numbers.ac;
  for (std::size_t i = 0; i < numbers.direct.size(); ++i) {
    set_parameter(model, kOcamcalibCoefficients.at(i), factor * numbers.direct.at(i));
    factor /= numbers.ac;
  }
  return model;
}

std::vector<double> inverse_of(const Scaramuzza& numbers) {
  std::vector<double> result(numbers.inverse.begin(), numbers.inverse.end());
  std::ranges::for_each(result, [&numbers](double& coefficient) { coefficient *= numbers.ac; });
  while (!result.empty() && result.back() == 0.0) result.pop_back();
  return result;
}

std::vector<Section> scaramuzza_sections(const CameraModel& model, std::span<const double> inverse) {
  const Scaramuzza numbers = camodocals(model, inverse);
  return {polynomial(kDirect, numbers.direct),
          polynomial(kInverse, numbers.inverse),
          {std::string(kAffine),
           {fields::real("ac", numbers.ac), fields::real("ad", numbers.ad), fields::real("ae", numbers.ae),
            fields::real("cx", numbers.cx), fields::real("cy", numbers.cy)}}};
}

}  // namespace fca::vins
