// SPDX-License-Identifier: BSD-3-Clause
// A cache of conversions. The layouts of a format are tried with the same cameras, which need only one fit.
#pragma once

#include <fca/convert/convert.h>

#include <list>
#include <mutex>
#include <optional>

namespace fca {

/// Valid for one request. Thread-safe.
class KnownConversions {
 public:
  /// Like fca::convert(), including the diagnostics.
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
  std::list<Known> known_;  ///< A list, so that pointers stay valid.
};

}  // namespace fca
