// SPDX-License-Identifier: BSD-3-Clause
#include "loaded_views.h"

#include <algorithm>
#include <utility>

namespace fca {

const consumers::ConsumerView& LoadedViews::of(const consumers::Consumer& program, const std::string& bytes,
                                               const consumers::LoadOptions& options) {
  const auto same = std::ranges::find_if(
      loaded_, [&](const Loaded& each) { return each.program == &program && each.options == options && each.bytes == bytes; });
  if (same != loaded_.end()) return same->view;
  loaded_.push_back({&program, bytes, options, program.load(bytes, options)});
  return loaded_.back().view;
}

void LoadedViews::add(const consumers::Consumer& program, std::string bytes, const consumers::LoadOptions& options,
                      consumers::ConsumerView view) {
  loaded_.push_back({&program, std::move(bytes), options, std::move(view)});
}

}  // namespace fca
