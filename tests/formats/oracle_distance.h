// SPDX-License-Identifier: BSD-3-Clause
// What a program computed (oracles/) next to what a file of ours says of the same rays.
#pragma once

#include "formats/oracle_table.h"

#include <fca/formats/consumers/consumer.h>
#include <fca/formats/proof.h>
#include <fca/formats/verdict.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace fca::test {

/// The tables of a program of ours, and where they lie.
struct Printed {
  const char* program;
  const char* folder;
  const char* suffix;
};

inline constexpr std::array kPrinted = {
    Printed{"kalibr", "kalibr", "kalibr"},          Printed{"orbslam3", "orbslam3", "orbslam3"},
    Printed{"opencv", "opencv", "opencv"},          Printed{"ocamcalib", "ocamcalib", "ocamcalib"},
    Printed{"woodscape", "woodscape", "woodscape"}, Printed{"basalt", "basalt", "basalt"},
    Printed{"vins", "camodocal", "camodocal"},      Printed{"ros", "ros_camera_info", "ros"},
};

inline constexpr double kReadyPx = 0.25;

/// The camera's own pixels of a region next to those that a program printed.
struct OracleDistance {
  int compared = 0;
  double rms = 0.0;
};

/// Where the verdict looks: the image, of a wide lens the circle in it.
inline bool is_in_region(const Camera& camera, const Pixel& pixel, bool is_wide) {
  const Pixel last = {camera.image_size->width - 1.0, camera.image_size->height - 1.0};
  if (pixel[0] < 0.0 || pixel[1] < 0.0 || pixel[0] > last[0] || pixel[1] > last[1]) return false;
  const Pixel middle = {0.5 * last[0], 0.5 * last[1]};
  return !is_wide || distance(pixel, middle) <= std::min(middle[0], middle[1]);
}

using ProjectRay = std::function<std::optional<Pixel>(const Ray&)>;

/// `theirs`: the pixels that are to be the table's, in the file's. The mean is the image's: the rays of a table lie in rings
/// about the axis, as many in each, so that one stands for a part of the image that grows with its radius.
inline OracleDistance evaluate(const Camera& camera, const OracleTable& table, const std::array<double, 2>& scale, bool is_wide,
                               const ProjectRay& theirs) {
  OracleDistance result;
  double squares = 0.0;
  double area = 0.0;
  const std::optional<Pixel> axis = project(camera.model, {0.0, 0.0, 1.0});
  if (!axis) return result;
  for (const OracleRow& row : table.rows) {
    const std::optional<Pixel> pixel = project(camera.model, row.ray);
    // From 90 degrees on programs mirror: the verdict counts that as a share, not as pixels.
    if (!pixel || row.ray[2] <= 0.0 || !is_in_region(camera, *pixel, is_wide) || std::isnan(row.pixel[0])) continue;
    const std::optional<Pixel> seen = theirs(row.ray);
    if (!seen) continue;
    const double share = distance(*pixel, *axis);
    squares += share * std::pow(distance(*seen, {row.pixel[0] / scale[0], row.pixel[1] / scale[1]}), 2);
    area += share;
    ++result.compared;
  }
  result.rms = area > 0.0 ? std::sqrt(squares / area) : std::numeric_limits<double>::infinity();
  return result;
}

/// By a program, in the file's pixels.
inline ProjectRay by_reader(const consumers::ConsumerCamera& reader) {
  return [&reader](const Ray& ray) -> std::optional<Pixel> {
    const std::optional<Pixel> pixel = reader.project(ray);
    if (!pixel) return std::nullopt;
    return Pixel{(*pixel)[0] / reader.scale[0], (*pixel)[1] / reader.scale[1]};
  };
}

/// A proof of the table's file, and the camera that the table is about.
struct Case {
  Camera camera;
  CameraProof proof;
  consumers::ConsumerCamera reader;
};

inline std::optional<Case> case_of(const consumers::Consumer& consumer, const OracleTable& table) {
  const std::string bytes = read_file(shared_dir() / "corpus" / table.file);
  const ReadCorpusFile read = read_corpus_file(table.file);
  if (!read.calibration || read.calibration->rig.cameras.size() <= table.camera) return std::nullopt;
  const Camera& camera = read.calibration->rig.cameras[table.camera];
  if (!camera.image_size) return std::nullopt;
  for (const char* mode : {"mono", "stereo"}) {
    const consumers::LoadOptions options = {mode, std::nullopt};
    const ProofResult proof = prove(consumer, bytes, options, read.calibration->rig);
    const consumers::ConsumerView view = consumer.load(bytes, options);
    if (!proof.loads || proof.cameras.size() <= table.camera || view.cameras.size() <= table.camera) continue;
    return Case{camera, proof.cameras[table.camera], view.cameras[table.camera]};
  }
  return std::nullopt;
}

}  // namespace fca::test
