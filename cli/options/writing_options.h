// SPDX-License-Identifier: BSD-3-Clause
// What is to be written: the options of `convert` that `report` has, too, because its page shows what they do.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fca::cli {

struct WritingOptions {
  std::string to;     ///< A format; empty: that of `into`, if any.
  std::string model;  ///< Empty: the input's, else the best that the format's own program reads.
  std::string sensor;
  std::string orbslam3_layout;
  std::string opencv_layout;
  std::string into;  ///< The file whose text is edited.
  bool anew = false;
  bool every_pixel = false;
  std::string objective = "rms";
  std::optional<double> fps;
  std::optional<double> baseline_m;
  std::vector<std::string> settings;  ///< "KEY=VALUE"
};

/// All of them but --to and --model, whose words are each command's own.
void add_writing_options(CLI::App& command, WritingOptions& options);

/// A usage error among them, in words.
[[nodiscard]] std::optional<std::string> problem_with(const WritingOptions& options);

}  // namespace fca::cli
