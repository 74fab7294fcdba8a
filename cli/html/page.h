// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contents.h"
#include "html.h"

#include <functional>
#include <string>

namespace fca::cli {

/// One HTML file that needs nothing besides itself: no script, no request, light and dark, for screens of any width and for
/// paper. The same contents give the same bytes.
[[nodiscard]] std::string report_page(const ReportContents& contents);

/// A page of that title with its style and its policy, around what `content` writes.
[[nodiscard]] std::string page_around(const std::string& title, const std::function<void(Html&)>& content);

}  // namespace fca::cli
