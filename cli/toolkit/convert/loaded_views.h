// SPDX-License-Identifier: BSD-3-Clause
// A cache of what the readers of programs read from files during a conversion: each reads the same bytes only once.
#pragma once

#include <fca/formats/consumers/consumer.h>

#include <list>
#include <string>

namespace fca {

/// The views of one request. Not thread-safe.
class LoadedViews {
 public:
  /// Returns what Consumer::load() returns, which it calls only the first time. The reference is valid as long as this object.
  [[nodiscard]] const consumers::ConsumerView& of(const consumers::Consumer& program, const std::string& bytes,
                                                  const consumers::LoadOptions& options);
  /// Adds a view that the caller got from Consumer::load().
  void add(const consumers::Consumer& program, std::string bytes, const consumers::LoadOptions& options,
           consumers::ConsumerView view);

 private:
  struct Loaded {
    const consumers::Consumer* program;
    std::string bytes;
    consumers::LoadOptions options;
    consumers::ConsumerView view;
  };
  std::list<Loaded> loaded_;
};

}  // namespace fca
