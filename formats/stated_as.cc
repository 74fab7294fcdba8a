// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/stated_as.h>

#include "places.h"

#include <cmath>

namespace fca {

namespace {

/// The keys on the way to the byte, in front of `keys`; false if the tree does not hold it.
bool find_keys(const text::Node& node, std::size_t offset, std::vector<std::string>& keys) {
  for (const text::Node& item : node.items) {
    if (find_keys(item, offset, keys)) return true;
  }
  for (const text::Entry& entry : node.entries) {
    if (!find_keys(entry.value, offset, keys)) continue;
    keys.insert(keys.begin(), entry.key.value);
    return true;
  }
  return node.is_scalar() && offset >= node.span.offset && offset < node.span.end();
}

}  // namespace

std::string key_of_pose(const Calibration& calibration, std::size_t index) {
  const Transform& T = calibration.rig.poses.at(index).T_a_b;
  // A number that stands nowhere else.
  int row = 0;
  for (int other = 1; other < 3; ++other) {
    if (std::abs(T(other, 3)) > std::abs(T(row, 3))) row = other;
  }
  const text::Document& document = calibration.documents.at(calibration.with_cameras);
  const SourceRange range = Places(document, calibration).pose(index, row, 3);
  std::vector<std::string> keys;
  if (range.length == 0 || !find_keys(document.root(), range.offset, keys)) return "";
  // Numbers of an opencv-matrix.
  if (keys.size() > 1 && keys.back() == "data") keys.pop_back();
  std::string text;
  for (const std::string& key : keys) text += (text.empty() ? "" : " ") + key;
  return text;
}

}  // namespace fca
