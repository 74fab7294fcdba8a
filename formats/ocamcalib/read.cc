// SPDX-License-Identifier: BSD-3-Clause
#include "blocks.h"
#include "inverse.h"
#include "ocamcalib.h"

#include "../fields.h"

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
      reader_.warning(blocks->inverse.count != nullptr ? *blocks->inverse.count : *blocks->centre[0], "inverse-missing",
                      "there is no inverse polynomial: OCamCalib's world2cam cannot project without it",
                      "fca-io convert FILE --to ocamcalib fits one to the direct polynomial");
      rig.cameras.push_back(std::move(camera));
      return rig;
    }
    const double error = inverse_error(camera, *inverse);
    if (!swapped) warn_if_stale(*blocks, error);  // else the lens is not where the centre says
    rig.extra_fields.push_back({"cam0", std::string(kInverse),
                                std::to_string(inverse->size()) + " coefficients, up to " + text::format_short(error, 3) +
                                    " px from the exact inverse of the direct polynomial: " + listed(*inverse)});
    rig.cameras.push_back(std::move(camera));
    return rig;
  }

 private:
  bool read_direct(const PolynomialNodes& nodes, Camera& camera) {
    const text::Node& first = *nodes.coefficients.front();
    if (text::parse_real(first.value).value_or(0.0) > 0.0) {
      reader_.error(first, "polynomial-sign",
                    "a0 = " + first.value + " is positive: OCamCalib's z points to the back of the lens, so a0 is negative",
                    "change the sign of all direct and of the odd inverse coefficients (b1, b3, ...)");
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
      reader_.error(*blocks.affine[0], "not-a-camera", "c - d e is not positive: [c d; e 1] mirrors the image or is singular");
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
    reader_.error(*blocks.centre[by_row ? 0 : 1], "centre-outside",
                  "the centre is row " + blocks.centre[0]->value + ", column " + blocks.centre[1]->value +
                      ", far outside an image of " + std::to_string(size.height) + " rows and " + std::to_string(size.width) +
                      " columns",
                  "the image size is its height and its width: is one of the two numbers cut short?");
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
    reader_.warning(*blocks.centre[0], "centre-swapped",
                    "the centre is row " + blocks.centre[0]->value + ", column " + blocks.centre[1]->value +
                        " of an image of " + std::to_string(size.height) + " rows and " + std::to_string(size.width) +
                        " columns; the other way round it would be nearer to the middle",
                    "one of the two pairs is swapped: write  " + blocks.centre[1]->value + " " + blocks.centre[0]->value +
                        "  for the centre, or  " + std::to_string(size.width) + " " + std::to_string(size.height) +
                        "  (height width) for the image's size; most images are wider than high");
    return true;
  }

  void warn_if_stale(const Blocks& blocks, double error) {
    if (error <= kStalePx) return;
    reader_.warning(*blocks.inverse.count, "stale-inverse",
                    "the inverse polynomial is up to " + text::format_short(error, 3) +
                        " px from the inverse of the direct one: programs that project (world2cam) and those that unproject " +
                        "(cam2world) see two different lenses; fca-io goes by the direct one",
                    "fca-io convert FILE --to ocamcalib rebuilds it");
  }

  fields::Reader reader_;
};

}  // namespace

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& /*options*/, Diagnostics& diagnostics) {
  if (documents.size() != 1) {
    diagnostics.error("one-camera",
                      "a calib_results.txt holds one camera; these are " + std::to_string(documents.size()) + " documents");
    return std::nullopt;
  }
  Diagnostics found;
  std::optional<Rig> rig = ResultsReader(documents.front(), found).run();
  for (const Diagnostic& entry : found.entries()) diagnostics.add(entry);
  return rig;
}

}  // namespace fca::ocamcalib
