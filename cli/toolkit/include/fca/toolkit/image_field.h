// SPDX-License-Identifier: BSD-3-Clause
// Computes a number for every cell of a grid over an image: the error of a conversion, or the angle from the axis.
#pragma once

#include <fca/convert/report.h>
#include <fca/rig/rig.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace fca {

/// Whether a cell was scored, and why not. The values are the parts of Coverage (fca/convert/report.h).
enum class Part : std::uint8_t { kScored, kOutsideLens, kUnrepresentable };

/// A grid of cells over an image, and the value of each cell.
struct ImageField {
  ImageSize image;  ///< Size of the image.
  int columns = 0;
  int rows = 0;
  std::vector<double> values;  ///< Row by row from the top. NaN if the cell was not scored.
  std::vector<Part> parts;

  /// The index of a cell in `values` and `parts`.
  [[nodiscard]] std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * columns + column); }
  /// The pixel in the middle of a cell.
  [[nodiscard]] Pixel pixel(int column, int row) const {
    return {(column + 0.5) * image.width / columns - 0.5, (row + 0.5) * image.height / rows - 0.5};
  }
};

/// The largest number of cells along the longer side of the image, for pictures and for contours. Contours need fewer cells,
/// because their lines are interpolated between cells.
inline constexpr int kPictureCells = 512;
inline constexpr int kContourCells = 144;

/// The error [px] of each cell: the distance between the cell's pixel and the pixel to which `target` projects the ray of this
/// pixel in `source`. `limit_rad`: the angle from the axis at which the lens ends; nullopt: it fills the image.
/// `max_angle_rad`: cells at larger angles from the axis are kUnrepresentable. `rotation`: maps rays of the source to rays of
/// the target; null: both cameras have the same frame. nullopt if the camera has no image size or no field of view.
[[nodiscard]] std::optional<ImageField> error_field(const Camera& source, const CameraModel& target,
                                                    std::optional<double> limit_rad, double max_angle_rad, int most_cells,
                                                    const Transform* rotation = nullptr);

/// The angle [deg] of each cell's ray from the axis. `limit_rad`, and when the result is nullopt: as for error_field().
[[nodiscard]] std::optional<ImageField> angle_field(const Camera& camera, std::optional<double> limit_rad, int most_cells);

/// The error at one angle from the axis, over all azimuths whose pixels are in the image.
struct ProfilePoint {
  double angle_deg = 0.0;
  double rms_px = 0.0;
  double max_px = 0.0;
};
/// The profile from the axis to `max_angle_rad`, without angles that no pixel of the image has. `rotation`: as for
/// error_field().
[[nodiscard]] std::vector<ProfilePoint> error_profile(const Camera& source, const CameraModel& target, double max_angle_rad,
                                                      const Transform* rotation = nullptr);

/// The image radius of an angle: the distance [px] between the principal point and the pixels of rays at this angle from the
/// axis, averaged over all azimuths.
struct RadiusPoint {
  double angle_deg = 0.0;
  double radius_px = 0.0;
};
/// The image radius from the axis up to the angle `to_rad`, or up to the angle at which the model ends.
[[nodiscard]] std::vector<RadiusPoint> radius_curve(const CameraModel& model, double to_rad);

}  // namespace fca
