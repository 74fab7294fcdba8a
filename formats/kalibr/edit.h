// SPDX-License-Identifier: BSD-3-Clause
// An existing camchain says something new: its own statements, only the changed bytes.
#pragma once

#include "poses.h"

#include "../fields.h"

#include <fca/formats/format.h>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace fca::kalibr {

/// Takes a document from saying `old` to saying `rig`, whose cameras are `rig_as_named`'s by another name.
class Editor {
 public:
  Editor(const text::Document& base, const Rig& old, const Rig& rig_as_named, const Rig& rig);

  /// Are the cameras other ones, or in another order?
  [[nodiscard]] bool other_cameras() const;

  /// Blocks can be added and removed where they are blocks, and nothing next to them speaks of cameras by name.
  [[nodiscard]] bool possible() const;

  /// `overlaps`: cam_overlaps of every camera of the rig, if it is known; for those that the base does not have.
  [[nodiscard]] text::Document edited(std::span<const std::optional<fields::Field>> overlaps, std::vector<Loss>& losses);

 private:
  /// A camera of the base that stays, and its place in the rig.
  struct Kept {
    const text::Entry* entry;
    std::size_t before;
    std::size_t now;
  };
  [[nodiscard]] std::vector<Kept> kept() const;
  /// What the file's own statements are to say. Poses that follow from them need not be stated.
  [[nodiscard]] Rig said_by(std::span<const Kept> cameras) const;
  void edit_named_poses();
  /// The fields of a block that specifies poses under the keys of `block`, and those that the file lacks.
  [[nodiscard]] std::vector<fields::Field> fields_after(const text::Node& block, std::size_t index) const;
  [[nodiscard]] std::vector<fields::Field> fields_before(const text::Node& block, std::size_t index) const;
  /// OpenVINS' chains specify the inverse of T_cam_imu.
  [[nodiscard]] std::string_view imu_pose_key() const;
  /// Does a camera of the base specify something under that key?
  [[nodiscard]] bool states(std::string_view key) const;
  /// cam_overlaps in the numbers of the chain as it will be.
  void count_overlaps(const text::Entry& camera, std::vector<Loss>& losses);

  const text::Document& base_;
  text::Document document_;
  text::Dialect dialect_;
  const Rig& old_;
  const Rig& as_named_;
  const Rig& rig_;
  Rig said_;
};

}  // namespace fca::kalibr
