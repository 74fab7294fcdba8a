// SPDX-License-Identifier: BSD-3-Clause
// A card with one figure.
#pragma once

#include "html.h"

#include <string>
#include <vector>

namespace fca::cli {

inline void put_tile(Html& html, const std::string& title, const std::string& big, const std::vector<std::string>& small) {
  html.element("div", {{"class", "tile"}}, [&] {
    html.element("div", {{"class", "soft"}}, title);
    html.element("div", {{"class", "big"}}, big);
    for (const std::string& line : small) html.element("div", {{"class", "soft"}}, line);
  });
}

}  // namespace fca::cli
