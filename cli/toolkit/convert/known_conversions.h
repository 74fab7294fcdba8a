// SPDX-License-Identifier: BSD-3-Clause
// Conversions of cameras that were made before: the layouts of a format are tried with the same cameras.
#pragma once

#include <fca/convert/convert.h>

#include <list>
#include <mutex>
#include <optional>

namespace fca {

/// Of one request. Threads may ask at the same time.
class KnownConversions {
 public:
  /// As fca::convert().
  [[nodiscard]] std::optional<Conversion> convert(const Camera& camera, const ConvertOptions& options,
                                                  Diagnostics& diagnostics);

 private:
  struct Known {
    Camera camera;
    ConvertOptions options;
    std::optional<Conversion> conversion;
    Diagnostics found;
  };
  [[nodiscard]] const Known* find(const Camera& camera, const ConvertOptions& options);

  std::mutex mutex_;
  std::list<Known> known_;  ///< They stay where they are.
};

}  // namespace fca
