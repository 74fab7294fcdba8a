// SPDX-License-Identifier: BSD-3-Clause
#include "blocks.h"
#include "inverse.h"
#include "ocamcalib.h"

#include "../fields.h"
#include "../losses.h"
#include "../one_camera_files.h"

#include <fca/code.h>
#include <fca/formats/file_name.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <cmath>

namespace fca::ocamcalib {

namespace {

constexpr std::size_t kFirstCoefficient = 5;  // after cx cy c d e
/// The toolbox's own degree is 4, and programs with places for a fixed number have five (camodocal, MATLAB).
constexpr std::size_t kUsualCoefficients = 5;
/// In the words of exportData2TXT.m.
constexpr std::string_view kDirectComment =
    "polynomial coefficients for the DIRECT mapping function (ocam_model.ss in MATLAB). These are used by cam2world";
constexpr std::string_view kInverseComment =
    "polynomial coefficients for the inverse mapping function (ocam_model.invpol in MATLAB). These are used by world2cam";
/// As in read.cc: farther from the direct polynomial's inverse it is not of the same lens.
constexpr double kStalePx = 1.0;

std::vector<double> direct_polynomial(const CameraModel& model) {
  const std::span<const double> values = parameter_values(model).subspan(kFirstCoefficient);
  std::size_t count = values.size();
  while (count > kUsualCoefficients && values[count - 1] == 0.0) --count;
  return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count)};
}

std::string block(std::string_view comment, std::span<const double> values, bool counted) {
  std::string text = "#" + std::string(comment) + "\n\n";
  if (counted) text += std::to_string(values.size()) + " ";
  for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? " " : "") + text::format_real(values[i]);
  return text + "\n\n";
}

std::string compose(const Camera& camera, const InversePolynomial& inverse) {
  const auto value = [&camera](ParameterId id) { return parameter(camera.model, id).value(); };
  const std::array<double, 2> centre = {value("cy"), value("cx")};
  const std::array<double, 3> affine = {value("c"), value("d"), value("e")};
  return block(kDirectComment, direct_polynomial(camera.model), true) + block(kInverseComment, inverse.coefficients, true) +
         block("center: \"row\" and \"column\", starting from 0 (C convention)", centre, false) +
         block("affine parameters \"c\", \"d\", \"e\"", affine, false) + "#image size: \"height\" and \"width\"\n\n" +
         std::to_string(camera.image_size->height) + " " + std::to_string(camera.image_size->width) + "\n";
}

/// What a rebuilt polynomial is worth, for people.
void tell_inverse(const Camera& camera, const InversePolynomial& inverse, Written& written, Diagnostics& diagnostics) {
  constexpr double kGoal = 1e-6;        // px
  constexpr double kNoticeable = 0.25;  // px
  const bool noticeable = inverse.error_px > kNoticeable;
  const Message fitted{Code::kCalibResultsInverseFitted, {inverse.coefficients.size(), inverse.error_px}};
  written.defaults.push_back({camera.name + " " + std::string(kInverse), fitted, false});
  const Severity severity = noticeable ? Severity::kWarning : Severity::kNote;
  if (inverse.error_px > kGoal) diagnostics.add(severity, Code::kCalibResultsInverseInexact, {camera.name, inverse.error_px});
}

/// A word that has the value already is not touched: scanf's %lf takes "0" and "0.0" alike.
void set_real(text::Document& document, const text::Node& word, double value) {
  if (text::parse_real(word.value) != value) document.replace(word.span, text::format_real(value));
}

/// Makes the words of a polynomial say those numbers; its count is made to fit.
void edit_polynomial(text::Document& document, const PolynomialNodes& nodes, std::span<const double> values) {
  const std::size_t common = std::min(nodes.coefficients.size(), values.size());
  fields::set_scalar(document, *nodes.count, std::to_string(values.size()));
  for (std::size_t i = 0; i < common; ++i) set_real(document, *nodes.coefficients[i], values[i]);
  const text::Node& last = nodes.coefficients.empty() ? *nodes.count : *nodes.coefficients.back();
  const std::size_t old_end = last.span.end();
  if (values.size() > common) {
    std::string more;
    for (const double value : values.subspan(common)) more += " " + text::format_real(value);
    document.insert(old_end, more);
  } else if (nodes.coefficients.size() > common) {
    const std::size_t end = nodes.coefficients[common - 1]->span.end();
    document.replace({end, old_end - end}, "");
  }
}

/// Adds the block that a file of four blocks lacks, after the direct polynomial's line.
void insert_inverse(text::Document& document, const Blocks& blocks, std::span<const double> values) {
  const std::string line_break(document.source().line_break());
  std::string lines;
  for (const char c : "\n\n" + block(kInverseComment, values, true)) lines += c == '\n' ? line_break : std::string(1, c);
  lines.resize(lines.size() - 2 * line_break.size());
  document.insert(document.source().line_at(blocks.direct.coefficients.back()->span.offset).end(), lines);
}

/// The factor by which all radii of a lens grew: a'_k = a_k s^(1 - k), as with_pixels() has it. Nothing if it is another lens.
std::optional<double> radial_scale(std::span<const double> before, std::span<const double> after) {
  constexpr double kRounding = 1e-12;
  if (before.size() != after.size() || before[0] == 0.0) return std::nullopt;
  const double scale = after[0] / before[0];
  if (!(scale > 0.0)) return std::nullopt;
  double factor = scale;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const double expected = factor * before[k];
    if (!(std::abs(after[k] - expected) <= kRounding * std::abs(expected))) return std::nullopt;
    factor /= scale;
  }
  return scale;
}

/// Takes the base from saying `old` to saying `camera`.
text::Document edited(const text::Document& base, const Camera& old, const Camera& camera, Written& written,
                      Diagnostics& diagnostics) {
  text::Document document = base;
  Diagnostics ignored;
  const Blocks blocks = find_blocks(document, ignored).value();
  const auto set = [&](const text::Node* node, ParameterId id) {
    set_real(document, *node, parameter(camera.model, id).value());
  };
  set(blocks.centre[0], "cy");
  set(blocks.centre[1], "cx");
  set(blocks.affine[0], "c");
  set(blocks.affine[1], "d");
  set(blocks.affine[2], "e");
  fields::set_scalar(document, *blocks.size[0], std::to_string(camera.image_size->height));
  fields::set_scalar(document, *blocks.size[1], std::to_string(camera.image_size->width));

  const std::vector<double> before = direct_polynomial(old.model);
  std::vector<double> after = direct_polynomial(camera.model);
  // A polynomial of another length than ours would be keeps its length where that holds all of it.
  const std::size_t length = blocks.direct.coefficients.size();
  while (after.size() > length && after.back() == 0.0) after.pop_back();
  if (after.size() < length) after.resize(length, 0.0);
  edit_polynomial(document, blocks.direct, after);

  // Neither the centre nor the affine part enter rho(theta), and images of another size only scale it: the file's own
  // polynomial stays as good as it was, unless the lens is now seen farther out.
  std::vector<double> inverse;
  for (const text::Node* node : blocks.inverse.coefficients) inverse.push_back(*text::parse_real(node->value));
  if (const std::optional<double> scale = radial_scale(before, direct_polynomial(camera.model)); scale && !inverse.empty()) {
    // rho = sum b_i theta^i, so radii s times as long are those of coefficients s times as large.
    if (*scale != 1.0) std::ranges::for_each(inverse, [&scale](double& coefficient) { coefficient *= *scale; });
    // One that was stale in the base's pixels is no better in coarser ones.
    if (inverse_error(camera, inverse) <= kStalePx * std::min(1.0, *scale)) {
      edit_polynomial(document, blocks.inverse, inverse);
      return document;
    }
  }
  const InversePolynomial fitted = fit_inverse(camera);
  if (blocks.inverse.count != nullptr) {
    edit_polynomial(document, blocks.inverse, fitted.coefficients);
  } else {
    insert_inverse(document, blocks, fitted.coefficients);
  }
  tell_inverse(camera, fitted, written, diagnostics);
  return document;
}

/// An inverse polynomial that was read is no loss where one was fitted to the same lens again. One that differs from that of
/// the file written into is: with the same direct polynomial, the file keeps its own.
void list_extras(const Rig& rig, const std::optional<Rig>& old, Written& written) {
  std::vector<ExtraField> extras = rig.extra_fields;
  if (!old || old->cameras.front().model != rig.cameras.front().model)
    std::erase_if(extras, [](const ExtraField& extra) { return extra.key == kInverse; });
  add_beyond_base(extras, old ? old->extra_fields : std::vector<ExtraField>(), Message{Code::kCalibResultsNoPlace},
                  written.losses);
}

}  // namespace

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  const Message size_use = {Code::kCalibResultsEndsWithSize};
  if (!writable_alone(kFormat, rig, size_use, diagnostics)) return std::nullopt;

  Diagnostics ignored;
  const std::optional<Rig> old = base != nullptr && !options.rewrite ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  Written written;
  for (const Camera& camera : rig.cameras) {
    std::optional<text::Document> document;
    const bool of_base = is_camera_of(old, rig, camera);
    if (of_base) {
      document = edited(*base, old->cameras.front(), camera, written, diagnostics);
    } else {
      const InversePolynomial inverse = fit_inverse(camera);
      const std::string name = rig.cameras.size() == 1 ? "calib_results.txt" : as_file_name(camera.name) + ".txt";
      document = fresh_file(kFormat, camera, {name, compose(camera, inverse)}, diagnostics);
      tell_inverse(camera, inverse, written, diagnostics);
    }
    if (!document) return std::nullopt;
    written.files.push_back({*std::move(document), {camera.name}, {"ocamcalib"}});
  }
  list_camera_losses(rig, "OCamCalib", written.losses);
  list_extras(rig, old, written);
  written.headline = {rig.cameras.size() == 1 ? Code::kCalibResultsHeadline : Code::kCalibResultsHeadlineEach};
  return written;
}

}  // namespace fca::ocamcalib
