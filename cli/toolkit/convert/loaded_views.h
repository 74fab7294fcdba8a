// SPDX-License-Identifier: BSD-3-Clause
// What programs made of files in a conversion: each is asked once about the same bytes.
#pragma once

#include <fca/formats/consumers/consumer.h>

#include <list>
#include <string>

namespace fca {

/// Of one request, and one thread.
class LoadedViews {
 public:
  /// As Consumer::load(). The view stays where it is.
  [[nodiscard]] const consumers::ConsumerView& of(const consumers::Consumer& program, const std::string& bytes,
                                                  const consumers::LoadOptions& options);
  /// Takes what the program made of the bytes when it was asked otherwise.
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
