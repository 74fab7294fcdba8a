// SPDX-License-Identifier: BSD-3-Clause
#include "write_guard.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/rig/limits.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace fca {

namespace {

using text::Node;

/// The names of the numbers that are not finite: "Camera.bf". A word in quotes is no number.
void collect_not_finite(const Node& node, const std::string& name, std::multiset<std::string>& names) {
  if (node.is_scalar() && !node.quoted) {
    const std::optional<double> value = text::parse_real(node.value);
    if (value && !std::isfinite(*value)) names.insert(name);
  }
  for (const Node& item : node.items) collect_not_finite(item, name, names);
  for (const text::Entry& entry : node.entries) collect_not_finite(entry.value, entry.key.value, names);
}

/// Every name that a file may state, and what it is of. Readers make them printable; rigs built in code may hold others.
std::vector<std::pair<Code, std::string_view>> names_of(const Rig& rig) {
  std::vector<std::pair<Code, std::string_view>> names;
  for (const Camera& camera : rig.cameras) {
    names.emplace_back(Code::kTheCamera, camera.name);
    names.emplace_back(Code::kTheTopic, camera.topic);
  }
  for (const Imu& imu : rig.imus) {
    names.emplace_back(Code::kTheImu, imu.name);
    names.emplace_back(Code::kTheTopic, imu.topic);
  }
  return names;
}

std::multiset<std::string> not_finite(const text::Document& document) {
  std::multiset<std::string> names;
  if (!document.edited()) {
    collect_not_finite(document.root(), "", names);
    return names;
  }
  if (const std::optional<text::Document> after = text::as_edited(document)) collect_not_finite(after->root(), "", names);
  return names;
}

}  // namespace

bool may_be_written(const Rig& rig, Diagnostics& diagnostics) {
  const std::vector<Message> problems = validate(rig);
  for (const Message& problem : problems) diagnostics.add(problem.code, problem.arguments);
  bool printable = true;
  for (const auto& [what, name] : names_of(rig)) {
    const std::string shown = text::printable(name);
    if (shown == name) continue;
    printable = false;
    diagnostics.add(Code::kNameUnprintable, {Message{what}, shown});
  }
  return printable && problems.empty();
}

bool has_no_mirror(const Rig& rig, Diagnostics& diagnostics) {
  for (const PoseEdge& edge : rig.poses) {
    if (!(rotation_determinant(edge.T_a_b) < 0.0)) continue;
    diagnostics.add(Code::kPoseMirrors, {edge.a, edge.b});
    return false;
  }
  return true;
}

bool edits_no_copies(const Written& written, const text::Document* base, Diagnostics& diagnostics) {
  const auto is_edited = [](const Written::File& file) { return file.document.edited(); };
  if (base == nullptr || std::ranges::none_of(written.files, is_edited)) return true;
  const Node* copy = text::first_copy(base->root());
  if (copy != nullptr) diagnostics.add(Code::kYamlCopiesNotEdited, {}, base->range(*copy));
  return copy == nullptr;
}

bool holds_finite_numbers(const Written& written, const text::Document* base, Diagnostics& diagnostics) {
  const std::multiset<std::string> already = base != nullptr ? not_finite(*base) : std::multiset<std::string>();
  for (const Written::File& file : written.files) {
    const std::multiset<std::string> names = not_finite(file.document);
    for (const std::string& name : names) {
      if (names.count(name) <= already.count(name)) continue;
      const Argument number = name.empty() ? Argument(Message{Code::kNumberWithoutName}) : Argument(name);
      diagnostics.add(Code::kNumberWouldNotBeFinite, {number, file.document.source().name});
      return false;
    }
  }
  return true;
}

}  // namespace fca
