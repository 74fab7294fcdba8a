// SPDX-License-Identifier: BSD-3-Clause
// What a file says of a rig, key by key, under the keys of a layout.
#pragma once

#include "layout.h"

#include "../fields.h"

#include <fca/rig/rig.h>

#include <vector>

namespace fca::opencv {

/// Makes fields. With a base, matrices keep its way of writing them: dt, rows and columns, further zeros, K(2, 2).
class FieldMaker {
 public:
  FieldMaker(const Rig& rig, const Layout& layout, const text::Document* base) : rig_(rig), layout_(layout), base_(base) {}

  /// Of the top level. `kept_length[i]`: the coefficients of camera i may be as many as the base's.
  [[nodiscard]] std::vector<fields::Field> root(const std::vector<bool>& kept_length) const;
  /// Of a camera that has a mapping of its own under `keys` (of the base, or of a new file).
  [[nodiscard]] std::vector<fields::Field> map(std::size_t camera, const CameraKeys& keys, bool kept_length) const;

 private:
  [[nodiscard]] const text::Node* there(const text::Node* mapping, const std::string& key) const;
  [[nodiscard]] const text::Node* mapping_in_base(const CameraKeys& keys) const;
  void add_size(const SizeKeys& keys, const Camera& camera, const text::Node* mapping,
                std::vector<fields::Field>& fields) const;
  void add_lens(const Camera& camera, const CameraKeys& keys, bool kept_length, std::vector<fields::Field>& fields) const;

  const Rig& rig_;
  const Layout& layout_;
  const text::Document* base_;
};

/// R and T of a pair, as the base (may be null) writes them: T_second_first.
[[nodiscard]] std::vector<fields::Field> stereo_pose_fields(const Rig& rig, const std::string& first, const std::string& second,
                                                            const Layout& layout, const text::Document* base);

/// Frame to which MC-Calib's poses take: what the rig specifies of the camera, else its first camera. Nothing if neither.
struct ReferencePose {
  Transform T;
  int group = 0;
};
[[nodiscard]] std::optional<ReferencePose> reference_pose(const Rig& rig, const Camera& camera);

}  // namespace fca::opencv
