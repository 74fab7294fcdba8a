// SPDX-License-Identifier: BSD-3-Clause
// A cache of conversions: when several layouts are tried with the same cameras, each camera is fitted only once.
#pragma once

#include <fca/convert/convert.h>

#include <list>
#include <mutex>
#include <optional>

namespace fca {

/// The conversions of one request. Thread-safe.
class KnownConversions {
 public:
  /// Returns the result and adds the diagnostics of fca::convert(), which it calls only the first time.
  [[nodiscard]] std::optional<Conversion> convert(const Camera& camera, const ConvertOptions& options,
                                                  Diagnostics& diagnostics);

 private:
  struct Known {
    Camera camera;
    ConvertOptions options;
    std::optional<Conversion> conversion;
    Diagnostics found;  ///< The diagnostics of the conversion.
  };
  /// The cached conversion; null if there is none.
  [[nodiscard]] const Known* find(const Camera& camera, const ConvertOptions& options);

  std::mutex mutex_;
  std::list<Known> known_;  ///< A list, so that pointers to its elements stay valid.
};

}  // namespace fca
