// SPDX-License-Identifier: BSD-3-Clause
// A page, element by element. Whatever goes into it as text or as an attribute's value is escaped here, so that nothing a file
// says can be anything but text.
#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>

namespace fca::cli {

class Html {
 public:
  struct Attribute {
    std::string_view name;
    std::string value;
  };
  using Attributes = std::initializer_list<Attribute>;

  /// An element whose content is what `content` writes.
  template <std::invocable Content>
  void element(std::string_view tag, Attributes attributes, Content&& content) {
    open(tag, attributes);
    content();
    close(tag);
  }
  /// One that holds text.
  void element(std::string_view tag, Attributes attributes, std::string_view content) {
    open(tag, attributes);
    text(content);
    close(tag);
  }
  /// An element that HTML knows no end of (meta).
  void element_without_end(std::string_view tag, Attributes attributes) { open(tag, attributes); }

  void text(std::string_view content);

  /// Style sheets are constants of the program, and not escaped: HTML would not undo it there.
  void style(std::string_view sheet);

  /// The whole document.
  [[nodiscard]] std::string document() const { return "<!doctype html>\n" + page_ + "\n"; }

 private:
  void open(std::string_view tag, Attributes attributes);
  void close(std::string_view tag);

  std::string page_;
};

/// A number of a drawing: two decimals at most, so that pages stay small.
[[nodiscard]] std::string coordinate(double value);

}  // namespace fca::cli
