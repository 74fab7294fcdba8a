// SPDX-License-Identifier: BSD-3-Clause
// The error statistics of two cameras, for people: lines after two blanks.
#pragma once

#include <fca/convert/report.h>
#include <fca/rig/rig.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fca::cli {

/// "the image circle of a.png: centre (255.5, 250.1), radius 240.1 px, 98.2 % of its rim in the image seen, rms 0.3 px"
[[nodiscard]] std::string circle_in_words(const LensCircle& circle);
/// "115.3 deg from the axis (230.5 deg in full): the whole image". A lens circle need not lie about the axis: then only how far
/// it reaches from there, and where it is.
[[nodiscard]] std::string field_of_view_in_words(const Coverage& coverage);
/// "  view:   " and those words
[[nodiscard]] std::string field_of_view_text(const Coverage& coverage);
/// "100.0 % of the image scored, 3.0 % outside the lens": what was scored, and the parts of the image that were not.
[[nodiscard]] std::string coverage_text(const Coverage& coverage, double scored_to_deg);
/// "rms 0.118 px, max 2.96 px at (511.0, 0.0), proven below 2.98 everywhere"
/// With an image size: prints no distance larger than the image.
[[nodiscard]] std::string error_text(const ErrorStatistics& statistics, const std::optional<ImageSize>& image = {});

/// Is the rms larger than the image's diagonal?
[[nodiscard]] bool is_larger_than(const ErrorStatistics& statistics, const ImageSize& image);

/// A further column of the table of bands, a cell for each band.
struct BandColumn {
  std::string title;
  std::vector<double> values;
  bool in_pixels = true;
};
/// Share, rms and max of each band of angles.
[[nodiscard]] std::string band_table(const std::vector<ErrorBand>& bands, std::span<const BandColumn> further = {},
                                     const std::optional<ImageSize>& image = {});

}  // namespace fca::cli
