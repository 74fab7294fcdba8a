// SPDX-License-Identifier: BSD-3-Clause
#include "commands/convert/batch.h"
#include "rectify_command.h"
#include "shell/option_hints.h"
#include "shell/words.h"

#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>

#include <algorithm>
#include <cmath>

namespace fca::cli {

namespace {

using text::format_short;

/// A line of the report.
std::string line(std::string_view name, const std::string& words) {
  constexpr std::size_t kColumn = 15;
  return "  " + padded(name, kColumn - 2) + in_columns(words, kColumn, kColumn) + "\n";
}

std::string in_metres(double metres) {
  constexpr double kLong = 1.0;
  constexpr double kCmPerM = 100.0;
  return metres < kLong ? format_short(kCmPerM * metres, 4) + " cm" : format_short(metres, 4) + " m";
}

std::string place(const RectifyResult& result) {
  const std::string& first = result.cameras[0].name;
  const std::string& second = result.cameras[1].name;
  return second + " stands " + in_metres(result.baseline_m()) + (result.pair.is_vertical ? " below " : " to the right of ") +
         first;
}

std::string origin(const RectifyArguments& arguments, const RectifyResult& result) {
  if (result.is_rectified) return "the images are rectified already: the file holds their camera";
  if (result.is_stated) return "rectified as the file has it";
  if (arguments.like_opencv) return "rectified by OpenCV";
  return "rectification computed from the pose";
}

std::string camera(const RectifyResult& result) {
  const auto& [fx, fy] = result.pair.focal_lengths;
  const Pixel& left = result.pair.views[0].centre;
  const Pixel& right = result.pair.views[1].centre;
  std::string words = "fx " + format_short(fx) + (fx == fy ? "" : ", fy " + format_short(fy)) + ", cx " + format_short(left[0]);
  if (left[0] != right[0]) words += " and " + format_short(right[0]);
  words += ", cy " + format_short(left[1]);
  if (left[1] != right[1]) words += " and " + format_short(right[1]);
  return words + " px; " + size_in_words(result.size) + " px, " + format_short(result.full_fov_rad * kDegreesPerRadian, 4) +
         " deg wide in full";
}

std::string region(const std::optional<ImageRegion>& region, const ImageSize& size) {
  if (!region) return "nothing";
  if (*region == ImageRegion{0, 0, size}) return "the whole image";
  return size_in_words(region->size) + " px from (" + std::to_string(region->x) + ", " + std::to_string(region->y) + ")";
}

std::string seen_by(const RectifyResult& result) {
  const auto& [left, right] = result.pair.views;
  const std::string first = region(left.valid, result.size);
  const std::string second = region(right.valid, result.size);
  if (first == second) return "each camera sees " + first;
  return result.cameras[0].name + " sees " + first + ", " + result.cameras[1].name + " " + second;
}

std::string difference(const RowDifference& rows) {
  return "rms " + pixels(rows.rms_px) + " px, max " + pixels(rows.max_px) + " px at (" + fixed(rows.max_at[0], 0) + ", " +
         fixed(rows.max_at[1], 0) + ")";
}

std::string disparity(const RectifyResult& result) {
  constexpr double kRoundingPx = 1e-6;
  const VerticalDisparity& left = *result.disparity;
  const std::string across = result.pair.is_vertical ? "columns" : "rows";
  if (std::max(left.at_infinity.max_px, left.at_ten_baselines.max_px) < kRoundingPx) {
    return "the images of a point lie in the same " + across.substr(0, across.size() - 1) + " (" +
           percent(left.at_infinity.share) + " of the image is seen by both)";
  }
  return "the images of a point differ by " + across + ": " + difference(left.at_infinity) + " far away; " +
         difference(left.at_ten_baselines) + " at 10 baselines; over " + percent(left.at_infinity.share) + " of the image";
}

/// By how much OpenCV's camera is another than ours.
std::string from_ours(const RectifyResult& result) {
  const RectifiedPair& ours = *result.ours;
  const auto off = [](double a, double b) { return fixed(a - b, 3); };
  return "ours, from corners undistorted exactly, differs by " + off(ours.focal_lengths[0], result.pair.focal_lengths[0]) +
         " px in fx, " + off(ours.views[0].centre[0], result.pair.views[0].centre[0]) + " px in cx, " +
         off(ours.views[0].centre[1], result.pair.views[0].centre[1]) + " px in cy";
}

std::string settings(const Rectifying& done) {
  const RectifyResult& result = done.result;
  std::string text;
  for (const std::string& path : done.settings) text += line("wrote", text::printable(path));
  if (!result.mode.empty()) text += line("mode", result.mode);
  for (const ProofResult& proof : result.proofs) {
    std::string words = proof.program;
    if (!proof.loads) {
      words += " refuses it: " + enumerated(sentences_of(proof.refusals, with_options));
    } else {
      words += " loads it, and sees the camera" + std::string(proof.cameras.size() > 1 ? "s" : "") + " within " +
               pixels(proof.max_diff_px) + " px";
      if (!proof.poses_agree)
        words += ", and other poses (by up to " + format_short(proof.max_diff_pose, 3) + " in an element)";
      for (const Message& number : proof.other_numbers) words += "; " + text::text_of(number, with_options);
    }
    text += line("proof", words);
  }
  std::vector<std::string> set;
  for (const DefaultedValue& value : result.defaults) {
    if (value.look_at_it) set.push_back(text_of(value, with_options));
  }
  if (!set.empty()) text += line("set", enumerated(set) + ": no input contains it");
  for (const Loss& loss : result.losses) text += line("lost", what_of(loss, with_options) + ": " + why_of(loss, with_options));
  return text;
}

std::string images(const Rectifying& done) {
  std::string text;
  for (const std::vector<RemappedImage>& side : done.images) {
    if (side.empty()) continue;
    const auto written =
        std::ranges::count_if(side, [](const RemappedImage& image) { return !image.left && image.code == ExitCode::kGood; });
    const bool interrupted = std::ranges::any_of(side, &RemappedImage::left);
    const std::string folder = side.front().output.substr(0, side.front().output.rfind('/') + 1);
    text += line("wrote", std::string(interrupted ? "interrupted: " : "") + std::to_string(written) + " of " +
                              counted(side.size(), "image") + " to " + text::printable(folder));
  }
  return text;
}

}  // namespace

std::string rectify_text(const RectifyArguments& arguments, const Rectifying& done) {
  const RectifyResult& result = done.result;
  const bool upright = result.pair.is_vertical;
  std::string text =
      in_columns(result.cameras[0].name + " and " + result.cameras[1].name + ": " + origin(arguments, result), 0, 2) + "\n";
  if (!result.is_rectified) {
    text += line(upright ? "upper" : "left", result.cameras[0].name + ": " + place(result) +
                                                 (result.is_exchanged ? " (the files have them the other way round)" : ""));
  }
  text += line("camera", camera(result));
  text += line("baseline", format_short(result.baseline_m()) + " m; times fx " + format_short(result.bf()) + " m px");
  text += line("region", seen_by(result));
  text += line(upright ? "columns" : "rows", disparity(result));
  if (result.ours) text += line("OpenCV", from_ours(result));
  text += settings(done);
  for (const std::string& map : done.maps) text += line("wrote", text::printable(map));
  return text + images(done);
}

}  // namespace fca::cli
