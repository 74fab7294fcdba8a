// SPDX-License-Identifier: BSD-3-Clause
// The numbers of two calibrations next to each other, those that differ.
#include "compare_command.h"
#include "shell/words.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cmath>

namespace fca::cli {

namespace {

struct Row {
  std::string what;
  std::string reference;
  std::string other;
  std::string difference;
};

std::string table_text(const std::vector<Row>& rows) {
  constexpr std::size_t kGap = 2;
  std::size_t what = 0;
  std::size_t reference = 0;
  std::size_t other = 0;
  for (const Row& row : rows) {
    what = std::max(what, row.what.size() + kGap);
    reference = std::max(reference, row.reference.size() + kGap);
    other = std::max(other, row.other.size() + kGap);
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line =
        "  " + padded(row.what, what) + padded(row.reference, reference) + padded(row.other, other) + row.difference;
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

const Row kTitles = {"", "REF", "FILE", "difference"};

/// The rows below their titles, and how many more are the same; empty where neither file has any.
std::string section(const std::string& heading, const std::string& what, const std::vector<Row>& rows, std::size_t same) {
  const bool any_differs = rows.size() > 1;
  if (!any_differs && same == 0) return "";
  if (!any_differs) return "\n" + heading + ": the same\n";
  return "\n" + heading + "\n" + table_text(rows) + (same > 0 ? "  " + counted(same, "other " + what) + ": the same\n" : "");
}

/// "2 times as much"
std::string ratio_in_words(double reference, double other) {
  return reference == 0.0 ? "" : text::format_short(other / reference, 4) + " times as much";
}

std::string only_in(const std::vector<ParameterComparison>& parameters, bool of_reference) {
  std::string names;
  for (const ParameterComparison& row : parameters) {
    if ((of_reference ? row.other : row.reference).has_value()) continue;
    names += (names.empty() ? "" : " ") + row.name;
  }
  return names;
}

std::string parameters_text(const CameraComparison& camera) {
  std::vector<Row> rows = {kTitles};
  if (camera.reference_model != camera.other_model) rows.push_back({"model", camera.reference_model, camera.other_model, ""});
  if (camera.other_size) {
    rows.push_back({"image", size_in_words(camera.size), size_in_words(*camera.other_size),
                    ratio_in_words(camera.size.width, camera.other_size->width)});
  }
  std::size_t same = 0;
  for (const ParameterComparison& row : camera.parameters) {
    if (!row.reference || !row.other) continue;
    if (row.same_but_for_rounding()) {
      ++same;
    } else {
      rows.push_back({row.name, text::format_short(*row.reference, 7), text::format_short(*row.other, 7),
                      text::format_short(*row.other - *row.reference, 4)});
    }
  }
  std::string text = "\n" + names_of(camera) + ": ";
  if (rows.size() == 1) return text + camera.reference_model + ", all " + std::to_string(same) + " parameters the same\n";
  text += camera.other_size ? "FILE's numbers for REF's image size\n" : "parameters\n";
  text += table_text(rows);
  const std::string only_in_reference = only_in(camera.parameters, true);
  const std::string only_in_other = only_in(camera.parameters, false);
  if (same > 0) text += "  " + counted(same, "other parameter") + ": the same\n";
  const bool same_model = camera.reference_model == camera.other_model;
  const auto of = [&](const char* file, const std::string& model) {
    return same_model ? "  only in " + std::string(file) + ": " : "  " + std::string(file) + "'s, of " + model + ": ";
  };
  if (!only_in_reference.empty()) text += of("REF", camera.reference_model) + only_in_reference + "\n";
  if (!only_in_other.empty()) text += of("FILE", camera.other_model) + only_in_other + "\n";
  return text;
}

std::string length_in_words(double metres) { return text::format_short(metres * 1000.0, 5) + " mm"; }

/// "0.369 deg and 1.2 mm"
std::string distance_in_words(const PoseDistance& distance) {
  return text::format_short(distance.angle_rad * kDegreesPerRadian, 3) + " deg and " +
         text::format_short(distance.distance_m * 1000.0, 3) + " mm";
}

std::string poses_text(const std::vector<PoseComparison>& poses) {
  std::vector<Row> rows = {{"", "length in REF", "length in FILE", "difference"}};
  std::size_t same = 0;
  for (const PoseComparison& pose : poses) {
    if (pose.same_but_for_rounding()) {
      ++same;
      continue;
    }
    rows.push_back({"T_" + pose.a + "_" + pose.b, length_in_words(pose.reference_length_m),
                    length_in_words(pose.other_length_m),
                    distance_in_words({pose.angle_rad, pose.distance_m}) +
                        (pose.remaining ? " (" + distance_in_words(*pose.remaining) + " with the turn)" : "")});
  }
  return section("poses", "pose", rows, same);
}

std::string difference_of(const FactComparison& fact) {
  const double more = fact.other - fact.reference;
  if (fact.unit == "s" || fact.unit == "m")
    return text::format_short(std::abs(more) * 1000.0, 3) + " m" + fact.unit + (more > 0.0 ? " more" : " less");
  return ratio_in_words(fact.reference, fact.other);
}

std::string facts_text(const std::vector<FactComparison>& facts) {
  std::vector<Row> rows = {kTitles};
  std::size_t same = 0;
  for (const FactComparison& fact : facts) {
    if (fact.same_but_for_rounding()) {
      ++same;
      continue;
    }
    const std::string unit = fact.unit.empty() ? "" : " [" + fact.unit + "]";
    rows.push_back({(fact.owner.empty() ? "" : fact.owner + " ") + fact.name + unit, text::format_short(fact.reference),
                    text::format_short(fact.other), difference_of(fact)});
  }
  return section("times and IMU", "number", rows, same);
}

}  // namespace

std::string names_of(const CameraComparison& camera) {
  return camera.other == camera.reference ? camera.reference : camera.reference + " and " + camera.other;
}

std::string numbers_text(const RigComparison& comparison) {
  std::string text;
  for (const CameraComparison& camera : comparison.cameras) text += parameters_text(camera);
  return text + poses_text(comparison.poses) + facts_text(comparison.facts);
}

}  // namespace fca::cli
