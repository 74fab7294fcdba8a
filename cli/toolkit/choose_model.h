// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/convert/convert.h>
#include <fca/formats/format.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fca::cli {

/// One camera before and after. No report where nothing was computed (the model is kept and the image size unknown).
struct CameraOutcome {
  Camera source;
  Camera target;
  std::optional<ConversionReport> report;
  std::string name_in_file = {};  ///< What the file written calls it; empty: as the input does.
  Diagnostics found = {};         ///< What its conversion said of it.

  /// The written name.
  [[nodiscard]] const std::string& name() const { return name_in_file.empty() ? source.name : name_in_file; }
  /// The same for people: "cam0 (input's cam1)" where the two differ.
  [[nodiscard]] std::string name_in_words() const {
    return name() == source.name ? name() : name() + " (input's " + source.name + ")";
  }
  /// Of the image, what the target does not reach; 0 where nobody notices.
  [[nodiscard]] double unrepresented_share() const {
    constexpr double kNoticeable = 5e-4;
    const double share = report ? report->judgement.coverage.unrepresentable : 0.0;
    return share > kNoticeable ? share : 0.0;
  }
};

struct ModelChoice {
  std::string model;  ///< As asked for; empty: chosen for the stock program.
  std::optional<double> max_angle_rad;
  bool every_pixel = false;  ///< Judge by every pixel instead of the lattice.
  Objective objective = Objective::kRms;
  std::vector<std::string> among = {};  ///< What may be chosen; empty: what the stock program reads.
  std::size_t jobs = 0;                 ///< Cameras fitted at the same time; 0: as many as there are processors.
  bool same_format = false;             ///< The cameras come from a file of the format they are written to.
};

/// What lib/convert is to be asked for, to fit a camera to what `stored` can hold.
[[nodiscard]] ConvertOptions options_for(const StoredModel& stored, const ModelChoice& choice);

/// The cameras as `format` will store them. Without a model asked for: each keeps its model if the stock program reads it
/// exactly and all agree, else all take the stock model that covers most of the images and, among equals, fits best by
/// the objective.
[[nodiscard]] std::optional<std::vector<CameraOutcome>> convert_cameras(const std::vector<Camera>& cameras,
                                                                        const Format& format, const ModelChoice& choice,
                                                                        Diagnostics& diagnostics);

}  // namespace fca::cli
