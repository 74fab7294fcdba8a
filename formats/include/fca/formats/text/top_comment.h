// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/text/document.h>

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace fca::text {

/// Adds comment lines at the top of a document, after its directives, its declaration and what comments stand there already.
/// Lines of words that begin with two comments ("#...", COLMAP) take them as lines; those that begin with one (OCamCalib:
/// exactly one) take them at the end of that, after ';'. False, and nothing is done, where the syntax has no comments (JSON,
/// other lines of words) or that one line would be too long for its reader.
bool add_top_comment(Document& document, std::span<const std::string> lines);

/// Removes those lines of such comments whose text `is_ours`; false if there are none.
bool remove_top_comment(Document& document, const std::function<bool(std::string_view)>& is_ours);

}  // namespace fca::text
