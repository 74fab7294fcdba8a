// SPDX-License-Identifier: BSD-3-Clause
// Tables. Where the window is narrow, rows become cards, for which each cell carries its column's title; but for tables of
// short numbers, which fit.
#pragma once

#include "html.h"

#include <string>
#include <vector>

namespace fca::cli {

struct Table {
  std::vector<std::string> titles;
  std::vector<std::vector<std::string>> rows;
  std::string style;  ///< Class: "numbers" aligns all columns but the first on the right.
};

inline void put_table(Html& html, const Table& table) {
  html.element("table", {{"class", table.style}}, [&] {
    html.element("thead", {}, [&] {
      html.element("tr", {}, [&] {
        for (const std::string& title : table.titles) html.element("th", {{"scope", "col"}}, title);
      });
    });
    html.element("tbody", {}, [&] {
      for (const std::vector<std::string>& row : table.rows) {
        html.element("tr", {}, [&] {
          for (std::size_t i = 0; i < row.size(); ++i) {
            // Numbers and names stay in one line; what is longer, a file may have brought in.
            constexpr std::size_t kShort = 20;
            html.element("td",
                         {{"class", row[i].size() <= kShort ? "short" : "long"},
                          {"data-title", i < table.titles.size() ? table.titles[i] : ""}},
                         row[i]);
          }
        });
      }
    });
  });
}

}  // namespace fca::cli
