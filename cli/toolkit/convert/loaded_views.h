// SPDX-License-Identifier: BSD-3-Clause
// A cache of what programs read from files during a conversion: each reads the same bytes only once.
#pragma once

#include <fca/formats/consumers/consumer.h>

#include <list>
#include <string>

namespace fca {

/// Valid for one request; not thread-safe.
class LoadedViews {
 public:
  /// Like Consumer::load(). The reference stays valid.
  [[nodiscard]] const consumers::ConsumerView& of(const consumers::Consumer& program, const std::string& bytes,
                                                  const consumers::LoadOptions& options);
  /// Adds a view that the program has loaded elsewhere.
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
