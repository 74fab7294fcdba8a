// SPDX-License-Identifier: BSD-3-Clause
// Values that were computed from cameras and poses, or together with them, and do not follow when those are edited.
#pragma once

#include "layout.h"

#include <fca/diagnostics.h>
#include <fca/formats/format.h>

#include <span>
#include <string>
#include <vector>

namespace fca::opencv {

/// What an edit changes of a mapping's cameras.
struct Changes {
  bool lens = false;  ///< Camera matrix, distortion or image size of any of them.
  bool pose = false;  ///< R and T of a pair.
};

/// Do two models project every point to the same pixel, whatever coefficients of 0 one of them has beyond the other's?
[[nodiscard]] bool same_lens(const CameraModel& a, const CameraModel& b);

/// Where such a value comes from.
struct Origin;

/// Keys of a file that no longer belong to what it says.
class StaleKeys {
 public:
  /// Those of `mapping` but for `edited`, the keys that the edit itself speaks of. `owner`: of the mapping, "camera_0 " or "".
  void add(const text::Node& mapping, std::span<const std::string> edited, const Changes& changes, const std::string& owner);
  /// A warning at the first of each kind, and a loss that names them all.
  void tell(const text::Document& base, std::vector<Loss>& losses, Diagnostics& diagnostics) const;

 private:
  struct Key {
    std::string name;
    const text::Node* node;
    const Origin* origin;
  };
  std::vector<Key> keys_;
};

}  // namespace fca::opencv
