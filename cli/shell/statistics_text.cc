// SPDX-License-Identifier: BSD-3-Clause
#include "statistics_text.h"

#include "option_hints.h"
#include "shell/words.h"

#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>

#include <cmath>

namespace fca::cli {

std::string circle_in_words(const LensCircle& circle) {
  return text::text_of(circle.why, with_options) + ": " + place_in_words(circle) + ", " + percent(circle.rim_share) +
         " of its rim in the image found, rms " + pixels(circle.rms_px) + " px";
}

std::string field_of_view_in_words(const Coverage& coverage) {
  const std::string why = text::text_of(coverage.why, with_options);
  if (!coverage.circle) return angle_in_words(coverage.max_angle_deg) + ": " + why;
  const LensCircle& circle = *coverage.circle;
  const std::string first = coverage.why == circle.why ? "" : why + "; ";
  return "up to " + text::format_short(coverage.max_angle_deg, 4) + " deg from the axis: " + first + circle_in_words(circle);
}

std::string field_of_view_text(const Coverage& coverage) { return "  view:   " + field_of_view_in_words(coverage) + "\n"; }

constexpr double kNoticeableShare = 0.0005;  // less is 0.0 %

std::string coverage_text(const Coverage& coverage, double scored_to_deg) {
  std::string result = percent(coverage.scored) + " of the image scored";
  constexpr double kNoticeable = 0.01;  // deg
  if (scored_to_deg < coverage.max_angle_deg - kNoticeable)
    result += " (up to " + text::format_short(scored_to_deg, 4) + " deg from the axis)";
  if (coverage.outside_lens > kNoticeableShare) result += ", " + percent(coverage.outside_lens) + " outside the lens";
  if (coverage.unrepresentable > kNoticeableShare)
    result += ", " + percent(coverage.unrepresentable) + " beyond what was scored";
  return result;
}

bool is_larger_than(const ErrorStatistics& statistics, const ImageSize& image) {
  return statistics.error.rms > std::hypot(image.width, image.height);
}

std::string error_text(const ErrorStatistics& statistics, const std::optional<ImageSize>& image) {
  const ErrorSummary& error = statistics.error;
  if (image && is_larger_than(statistics, *image))
    return "further apart than the image is large (" + size_in_words(*image) + " px)";
  const bool all = statistics.coverage.unrepresentable == 0.0 && statistics.coverage.outside_lens <= kNoticeableShare;
  const bool is_in_image = !image || error.bound <= std::hypot(image->width, image->height);
  const std::string bound = std::isfinite(error.bound) && is_in_image
                                ? "proven below " + pixels(error.bound, image) + (all ? " everywhere" : " where it was scored")
                                : "no bound is proven";
  return "rms " + pixels(error.rms, image) + " px, max " + pixels(error.max, image) + " px at (" + fixed(error.max_at[0], 1) +
         ", " + fixed(error.max_at[1], 1) + "), " + bound;
}

std::string band_table(const std::vector<ErrorBand>& bands, std::span<const BandColumn> further,
                       const std::optional<ImageSize>& image) {
  constexpr std::size_t kWidth = 12;
  const auto row = [](const std::vector<std::string>& cells) {
    std::string text = "   ";
    // The last cell has nothing to be aligned with.
    for (std::size_t i = 0; i < cells.size(); ++i)
      text += (i == 0 ? " " : "") + (i + 1 < cells.size() ? padded(cells[i], kWidth) : cells[i]);
    return text + "\n";
  };
  std::vector<std::string> titles = {"deg", "share", "rms px", "max px"};
  for (const BandColumn& column : further) titles.push_back(column.title);
  std::string text = row(titles);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const ErrorBand& band = bands[i];
    if (band.share <= 0.0 && band.max_px <= 0.0) continue;
    std::vector<std::string> cells = {fixed(band.from_deg, 0) + "-" + fixed(band.to_deg, 0), percent(band.share),
                                      pixels(band.rms_px, image), pixels(band.max_px, image)};
    for (const BandColumn& column : further) {
      const std::optional<ImageSize>& most = column.in_pixels ? image : std::nullopt;
      cells.push_back(i < column.values.size() ? pixels(column.values[i], most) : "");
    }
    text += row(cells);
  }
  return text;
}

}  // namespace fca::cli
