// SPDX-License-Identifier: BSD-3-Clause
// A number for every cell of a grid over an image: the error of a conversion, or the angle from the axis.
#pragma once

#include <fca/convert/report.h>
#include <fca/rig/rig.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace fca {

/// What became of a cell, in the judge's words (Coverage).
enum class Part : std::uint8_t { kScored, kOutsideLens, kUnrepresentable };

struct ImageField {
  ImageSize image;
  int columns = 0;
  int rows = 0;
  std::vector<double> values;  ///< Row by row from the top; not a number where the cell was not scored.
  std::vector<Part> parts;

  [[nodiscard]] std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * columns + column); }
  /// The pixel in the middle of a cell.
  [[nodiscard]] Pixel pixel(int column, int row) const {
    return {(column + 0.5) * image.width / columns - 0.5, (row + 0.5) * image.height / rows - 0.5};
  }
};

/// Cells along the longer side of the image, at most: of pictures, and of contours, whose lines are as fine as people see
/// with fewer.
inline constexpr int kPictureCells = 512;
inline constexpr int kContourCells = 144;

/// Two cameras over the domain that a judgement was about: pixel -> ray by `source` -> pixel by `target`. `limit_rad`: as it
/// was given (--max-angle); `reach_rad`: nothing further from the axis was scored; `rotation`: takes the source's rays to the
/// target's, null: they have the same. Nothing where there is no domain.
[[nodiscard]] std::optional<ImageField> error_field(const Camera& source, const CameraModel& target,
                                                    std::optional<double> limit_rad, double reach_rad, int most_cells,
                                                    const Transform* rotation = nullptr);

/// Degrees from the axis.
[[nodiscard]] std::optional<ImageField> angle_field(const Camera& camera, std::optional<double> limit_rad, int most_cells);

/// A function of the angle from the axis, over all directions around it that the image holds.
struct ProfilePoint {
  double angle_deg = 0.0;
  double rms_px = 0.0;
  double max_px = 0.0;
};
/// The error from the axis to `reach_rad`; angles that no pixel of the image has are left out. `rotation`: takes the source's
/// rays to the target's; null: they have the same.
[[nodiscard]] std::vector<ProfilePoint> error_profile(const Camera& source, const CameraModel& target, double reach_rad,
                                                      const Transform* rotation = nullptr);

/// How far from the principal point a model has rays of each angle, in pixels: the mean of all directions around the axis.
struct RadiusPoint {
  double angle_deg = 0.0;
  double radius_px = 0.0;
};
/// Up to `to_rad`, or where the model ends.
[[nodiscard]] std::vector<RadiusPoint> radius_curve(const CameraModel& model, double to_rad);

}  // namespace fca
