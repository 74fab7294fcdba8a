// SPDX-License-Identifier: BSD-3-Clause
// A number for every cell of a grid over an image: the error of a conversion, or the angle from the axis.
#pragma once

#include <fca/convert/report.h>
#include <fca/rig/rig.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace fca {

/// Was a cell scored? The parts are those of Coverage (fca/convert/report.h).
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

/// The largest number of cells along the longer side of the image. Contours need fewer than pictures: their lines are
/// interpolated.
inline constexpr int kPictureCells = 512;
inline constexpr int kContourCells = 144;

/// The error in pixels at each cell: the distance between its pixel and target(ray of the pixel in `source`). `limit_rad`: the
/// angle at which the lens ends, if the caller gave one; `max_angle_rad`: cells further from the axis count as
/// kUnrepresentable; `rotation`: takes the source's rays to the target's; null: they have the same frame. Nothing where the
/// camera has no image size or sees nothing of it.
[[nodiscard]] std::optional<ImageField> error_field(const Camera& source, const CameraModel& target,
                                                    std::optional<double> limit_rad, double max_angle_rad, int most_cells,
                                                    const Transform* rotation = nullptr);

/// The angle of each cell's ray from the axis, in degrees.
[[nodiscard]] std::optional<ImageField> angle_field(const Camera& camera, std::optional<double> limit_rad, int most_cells);

/// The error at one angle from the axis, over all azimuths whose pixels are in the image.
struct ProfilePoint {
  double angle_deg = 0.0;
  double rms_px = 0.0;
  double max_px = 0.0;
};
/// The profile from the axis to `max_angle_rad`, without angles that no pixel of the image has. `rotation`: takes rays in the
/// source's frame to the target's; null: both have the same frame.
[[nodiscard]] std::vector<ProfilePoint> error_profile(const Camera& source, const CameraModel& target, double max_angle_rad,
                                                      const Transform* rotation = nullptr);

/// The distance of the pixels of one angle from the principal point, in pixels: the mean over all azimuths.
struct RadiusPoint {
  double angle_deg = 0.0;
  double radius_px = 0.0;
};
/// From the axis up to `to_rad`, or to the angle at which the model ends.
[[nodiscard]] std::vector<RadiusPoint> radius_curve(const CameraModel& model, double to_rad);

}  // namespace fca
