// SPDX-License-Identifier: BSD-3-Clause
#include "stereo_order.h"

#include "camera_names.h"
#include "shell/words.h"

#include <fca/rig/stereo_order.h>

#include <algorithm>

namespace fca::cli {

namespace {

/// The command as it was given, but with these cameras.
std::string command_with_cameras(const std::vector<std::string>& words, const std::string& cameras) {
  std::string command = "fca-io";
  bool skip = false;
  for (const std::string& word : words) {
    if (!skip && word != "--camera" && !word.starts_with("--camera=")) command += " " + shell_word(word);
    skip = word == "--camera";
  }
  return command + " --camera " + shell_word(cameras);
}

/// The first two cameras the other way round, as --camera named them ("cam0,cam1"); the others behind them.
std::string swapped(const std::optional<std::string>& cameras) {
  if (!cameras) return "1,0";
  const std::size_t comma = cameras->find(',');
  const std::size_t rest = std::min(cameras->find(',', comma + 1), cameras->size());
  return cameras->substr(comma + 1, rest - comma - 1) + "," + cameras->substr(0, comma) + cameras->substr(rest);
}

}  // namespace

void warn_of_wrong_side(const Rig& rig, const ConvertArguments& arguments, const ConvertOutcome& outcome,
                        Diagnostics& diagnostics) {
  if (outcome.written.first_is_left.empty()) return;
  const std::optional<double> left = second_left_of_first(rig);
  if (!left) return;
  Rig other = rig;
  std::swap(other.cameras[0], other.cameras[1]);
  const std::string what =
      rig.cameras[1].name + " sits " + fixed(100.0 * *left, 2) + " cm to the left of " + rig.cameras[0].name;
  if (second_left_of_first(other)) {
    diagnostics.warning(
        "stereo-order",
        with_names_of_file(what + ", and " + rig.cameras[0].name + " to the left of " + rig.cameras[1].name, outcome.cameras) +
            ": they do not look the same way, the same way up; " + outcome.written.first_is_left,
        {}, "is their pose right (show says it in words)? If so, they are no left and right camera");
    return;
  }
  diagnostics.warning("stereo-order", with_names_of_file(what, outcome.cameras) + "; " + outcome.written.first_is_left, {},
                      command_with_cameras(arguments.words, swapped(arguments.reading.cameras)));
}

}  // namespace fca::cli
