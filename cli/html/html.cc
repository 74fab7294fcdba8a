// SPDX-License-Identifier: BSD-3-Clause
#include "html.h"

#include <fca/formats/text/source.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace fca::cli {

namespace {

/// Characters that mean something in HTML, and those that would turn the rest of a line around (U+202A to U+202E, U+2066 to
/// U+2069): a name must not change what stands next to it.
std::string escaped(std::string_view content) {
  const auto means_itself = [](char each) {
    return each >= ' ' && each <= '~' && std::string_view("&<>\"'").find(each) == std::string_view::npos;
  };
  if (std::ranges::all_of(content, means_itself)) return std::string(content);
  std::string result;
  const std::string clean = text::printable(content, true);
  for (std::size_t i = 0; i < clean.size(); ++i) {
    const std::string_view rest = std::string_view(clean).substr(i);
    const bool turns = (rest.starts_with("\xE2\x80") && rest.size() > 2 && rest[2] >= '\xAA' && rest[2] <= '\xAE') ||
                       (rest.starts_with("\xE2\x81") && rest.size() > 2 && rest[2] >= '\xA6' && rest[2] <= '\xA9');
    if (turns) {
      result += '?';
      i += 2;
      continue;
    }
    switch (clean[i]) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += clean[i];
    }
  }
  return result;
}

}  // namespace

void Html::text(std::string_view content) { page_ += escaped(content); }

void Html::style(std::string_view sheet) {
  page_ += "<style>";
  page_ += sheet;
  page_ += "</style>\n";
}

void Html::open(std::string_view tag, Attributes attributes) {
  page_ += '<';
  page_ += tag;
  for (const Attribute& attribute : attributes) {
    page_ += ' ';
    page_ += attribute.name;
    page_ += "=\"" + escaped(attribute.value) + '"';
  }
  page_ += '>';
}

void Html::close(std::string_view tag) {
  page_ += "</";
  page_ += tag;
  // A line break next to words within a line would be a blank.
  page_ += tag == "span" || tag == "code" ? ">" : ">\n";
}

std::string coordinate(double value) {
  if (!std::isfinite(value)) return "0";
  std::array<char, 400> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, 2);
  std::string text(buffer.data(), end.ptr);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace fca::cli
