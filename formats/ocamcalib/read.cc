// SPDX-License-Identifier: BSD-3-Clause
#include "blocks.h"
#include "inverse.h"
#include "ocamcalib.h"

#include "../fields.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/models/ocamcalib_parameters.h>

#include <cmath>

namespace fca::ocamcalib {

namespace {

/// Farther than this from the exact inverse, the two polynomials are not of one lens. findinvpoly.m stops at 0.01 px.
constexpr double kStalePx = 1.0;

/// A centre is taken for swapped if the other order puts it at most half as far from the middle, and it is farther from there,
/// in diagonals of the image, than lenses are mounted.
constexpr double kSwappedRatio = 0.5;
constexpr double kSwappedDiagonals = 0.03;

std::string listed(std::span<const double> values) {
  std::string list;
  for (const double value : values) list += (list.empty() ? "" : " ") + text::format_real(value);
  return list;
}

class ResultsReader {
 public:
  ResultsReader(const text::Document& document, Diagnostics& diagnostics)
      : reader_(document, text::Dialect::kPyYaml, diagnostics) {}

  std::optional<Rig> run() {
    const std::optional<Blocks> blocks = find_blocks(reader_.document(), reader_.diagnostics());
    if (!blocks) return std::nullopt;
    Rig rig;
    Camera camera;
    camera.name = "cam0";
    camera.model = *make_model("ocamcalib");
    bool good = read_direct(blocks->direct, camera);
    good = read_rest(*blocks, camera) && good;
    const std::optional<std::vector<double>> inverse = read_inverse(blocks->inverse);
    if (!good || !inverse) return std::nullopt;
    const bool swapped = warn_if_swapped(*blocks, camera);
    if (inverse->empty()) {
      reader_.say(blocks->inverse.count != nullptr ? *blocks->inverse.count : *blocks->centre[0],
                  Code::kCalibResultsInverseMissing);
      rig.cameras.push_back(std::move(camera));
      return rig;
    }
    const double error = inverse_error(camera, *inverse);
    if (!swapped) warn_if_stale(*blocks, error);  // else the lens is not where the centre says
    const std::string values = listed(*inverse);
    rig.extra_fields.push_back(
        {"cam0", std::string(kInverse), values, {Code::kCalibResultsInverse, {inverse->size(), error, values}}});
    rig.cameras.push_back(std::move(camera));
    return rig;
  }

 private:
  bool read_direct(const PolynomialNodes& nodes, Camera& camera) {
    const text::Node& first = *nodes.coefficients.front();
    if (text::parse_real(first.value).value_or(0.0) > 0.0) {
      reader_.say(first, Code::kCalibResultsSign, {first.value});
      return false;
    }
    bool good = true;
    for (std::size_t i = 0; i < nodes.coefficients.size(); ++i) {
      good = reader_.parameter(*nodes.coefficients[i], "direct polynomial", kOcamcalibCoefficients.at(i), camera.model) && good;
    }
    return good;
  }

  std::optional<std::vector<double>> read_inverse(const PolynomialNodes& nodes) {
    std::vector<double> values;
    for (const text::Node* node : nodes.coefficients) {
      const std::optional<double> value = reader_.real(*node, "inverse polynomial");
      if (!value) return std::nullopt;
      values.push_back(*value);
    }
    return values;
  }

  bool read_rest(const Blocks& blocks, Camera& camera) {
    bool good = reader_.parameter(*blocks.centre[0], "row of the centre", "cy", camera.model);
    good = reader_.parameter(*blocks.centre[1], "column of the centre", "cx", camera.model) && good;
    constexpr std::array<ParameterId, 3> kAffine = {"c", "d", "e"};
    for (std::size_t i = 0; i < kAffine.size(); ++i)
      good = reader_.parameter(*blocks.affine[i], "affine parameter", kAffine.at(i), camera.model) && good;
    const auto value = [&camera](ParameterId id) { return parameter(camera.model, id).value(); };
    if (good && !(value("c") - value("d") * value("e") > 0.0)) {
      reader_.say(*blocks.affine[0], Code::kCalibResultsMirrors);
      good = false;
    }
    camera.image_size = reader_.image_size(*blocks.size[1], *blocks.size[0], "image ");
    return good && camera.image_size && check_centre(blocks, camera);
  }

  /// A centre a whole image away from the image is no lens's: one of the two is not what it seems.
  bool check_centre(const Blocks& blocks, const Camera& camera) {
    const double row = parameter(camera.model, "cy").value();
    const double column = parameter(camera.model, "cx").value();
    const auto near = [](double at, int side) { return at > -1.0 * side && at < 2.0 * side; };
    const ImageSize size = *camera.image_size;
    const bool straight = near(row, size.height) && near(column, size.width);
    const bool swapped = near(row, size.width) && near(column, size.height);
    if (straight || swapped) return true;
    const bool by_row = !near(row, size.height);
    reader_.say(*blocks.centre[by_row ? 0 : 1], Code::kCalibResultsCentreOutside,
                {blocks.centre[0]->value, blocks.centre[1]->value, size.height, size.width});
    return false;
  }

  /// Some exporters write column before row (MATLAB's DistortionCenter is so). On an image that is almost square nobody can
  /// tell.
  bool warn_if_swapped(const Blocks& blocks, const Camera& camera) {
    const double row = parameter(camera.model, "cy").value();
    const double column = parameter(camera.model, "cx").value();
    const ImageSize size = *camera.image_size;
    const double straight = std::hypot(row - 0.5 * size.height, column - 0.5 * size.width);
    const double swapped = std::hypot(row - 0.5 * size.width, column - 0.5 * size.height);
    if (swapped > kSwappedRatio * straight || straight < kSwappedDiagonals * std::hypot(size.width, size.height)) return false;
    reader_.say(*blocks.centre[0], Code::kCalibResultsCentreSwapped,
                {blocks.centre[0]->value, blocks.centre[1]->value, size.height, size.width});
    return true;
  }

  void warn_if_stale(const Blocks& blocks, double error) {
    if (error <= kStalePx) return;
    reader_.say(*blocks.inverse.count, Code::kCalibResultsInverseStale, {error});
  }

  fields::Reader reader_;
};

}  // namespace

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& /*options*/, Diagnostics& diagnostics) {
  if (documents.size() != 1) {
    diagnostics.add(Code::kCalibResultsManyDocuments, {documents.size()});
    return std::nullopt;
  }
  Diagnostics found;
  std::optional<Rig> rig = ResultsReader(documents.front(), found).run();
  for (const Diagnostic& entry : found.entries()) diagnostics.add(entry);
  return rig;
}

}  // namespace fca::ocamcalib
