// SPDX-License-Identifier: BSD-3-Clause
#include "compose.h"

#include "scaramuzza.h"

#include "../composed.h"
#include "../ocamcalib/inverse.h"

#include <fca/code.h>

namespace fca::vins {

using fields::Field;

namespace {

/// How deep cv::FileStorage puts the keys of a mapping.
constexpr std::size_t kDeeper = 3;

}  // namespace

bool is_scaramuzza(const Camera& camera) { return layout_of_model(model_info(camera.model).id)->type == kScaramuzza; }

std::vector<double> fitted_inverse(const Camera& camera, Written& written, Diagnostics& diagnostics) {
  if (!is_scaramuzza(camera)) return {};
  const ocamcalib::InversePolynomial inverse = ocamcalib::fit_inverse(camera, kInverseCount);
  constexpr double kGoal = 1e-6;  // px
  const bool good = inverse.error_px <= kGoal;
  written.defaults.push_back({camera.name + " inverse polynomial",
                              Message{Code::kCalibResultsInverseFitted, {inverse.coefficients.size(), inverse.error_px}},
                              !good});
  if (!good) diagnostics.add(Code::kVinsInverseInexact, {camera.name, inverse.error_px, kInverseCount, "camodocal"});
  return inverse.coefficients;
}

std::string spelled(const Section& section, bool flow) {
  std::string text = section.name + (flow ? ": {" : ":");
  for (const Field& field : section.fields) {
    text +=
        flow ? (&field == &section.fields.front() ? " " : ", ") + fields::spell(field) : "\n" + fields::spell(field, kDeeper);
  }
  return text + (flow ? " }" : "");
}

std::optional<text::Document> fresh_camera_file(const Camera& camera, std::string_view name, const std::string& file,
                                                Written& written, Diagnostics& diagnostics) {
  ComposedYaml text("%YAML:1.0\n---\n");
  for (const Field& field : head_of(camera, name)) text.add(field);
  for (const Section& section : sections_of(camera, fitted_inverse(camera, written, diagnostics)))
    text.add_mapping(section.name, section.fields, kDeeper);
  return std::move(text).document(file, diagnostics);
}

}  // namespace fca::vins
