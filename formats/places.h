// SPDX-License-Identifier: BSD-3-Clause
// Where a file specifies a fact of its rig: where the format's table says, or what the format's writer would edit if the fact
// were another. So no second list of keys is needed, and a new format has places as soon as it can write.
#pragma once

#include "schema/schema.h"

#include <fca/formats/calibration.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca {

class Places {
 public:
  /// Both must outlive it.
  Places(const text::Document& document, const Calibration& calibration) : document_(&document), calibration_(&calibration) {}

  /// The number that says what `change` changes. Where the writer cannot tell, the first number that reads `value`; else the
  /// file without a place.
  [[nodiscard]] SourceRange of(const std::function<void(Rig&)>& change, std::optional<double> value) const;

  [[nodiscard]] SourceRange parameter(const Camera& camera, ParameterId id) const;
  [[nodiscard]] SourceRange image_width(const Camera& camera) const;
  [[nodiscard]] SourceRange time_offset(const Camera& camera) const;
  /// An element of the pose that is rig.poses[index].
  [[nodiscard]] SourceRange pose(std::size_t index, int row, int column) const;
  /// A member of the first IMU.
  [[nodiscard]] SourceRange imu(std::optional<double> Imu::*member) const;
  [[nodiscard]] SourceRange baseline() const;

 private:
  /// By the format's table; nothing where it has none, or where the number stands in no key of it.
  [[nodiscard]] std::optional<SourceRange> by_table(std::string_view camera, const schema::Fact& fact) const;
  [[nodiscard]] std::vector<text::Span> edits_for(const Rig& rig) const;

  const text::Document* document_;
  const Calibration* calibration_;
  mutable std::optional<std::vector<text::Span>> anyway_;  ///< What the writer edits for the rig as it is; asked once.
  mutable int asked_ = 0;                                  ///< How often the writer was asked.
};

/// The smallest node that holds the byte; null if none does.
[[nodiscard]] const text::Node* node_at(const text::Node& root, std::size_t offset);

}  // namespace fca
