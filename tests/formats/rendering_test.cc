// SPDX-License-Identifier: BSD-3-Clause
// A diagnostic as people see it: file:line:column, the line, a caret under the character that is meant.
#include "formats/test_files.h"

namespace fca::test {
namespace {

using text::Source;

std::string rendered(const Source& source, std::size_t offset, std::size_t length, const std::string& fix = "",
                     bool colour = false) {
  const text::Shown shown{Severity::kError, "some-code", "something is wrong", fix, source.range({offset, length})};
  return text::render(shown, std::span(&source, 1), colour);
}

/// Characters (code points) in front of the caret, counted as a terminal does.
std::size_t caret_column(const std::string& text) {
  const std::vector<std::string> lines = split(text, '\n');
  return lines.size() < 3 ? std::string::npos : lines[2].find('^');
}

std::size_t code_points(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

TEST(Rendering, PlaceLineCaretAndFix) {
  const Source source{"dir/f.yaml", "a: 1\nbb: 22.5 # c\n"};
  EXPECT_EQ(rendered(source, 9, 4, "write 23"),
            "dir/f.yaml:2:5: error: something is wrong [some-code]\n"
            "    bb: 22.5 # c\n"
            "        ^~~~\n"
            "    fix: write 23\n");
}

TEST(Rendering, WithoutAPlace) {
  const Source source{"f.yaml", "a: 1\n"};
  EXPECT_EQ(text::render({Severity::kWarning, "c", "m", "", {"f.yaml", 0, 0}}, std::span(&source, 1)),
            "f.yaml: warning: m [c]\n");
  EXPECT_EQ(text::render({Severity::kNote, "", "m", "", {}}, {}), "note: m\n");
  EXPECT_EQ(text::render({Severity::kError, "c", "m", "", {"other.yaml", 7, 2}}, std::span(&source, 1)),
            "other.yaml: error: m [c]\n");
}

// The first byte of a file is a place, too.
TEST(Rendering, TheFirstByte) {
  const Source source{"f.yaml", "x\n"};
  EXPECT_EQ(rendered(source, 0, 1), "f.yaml:1:1: error: something is wrong [some-code]\n    x\n    ^\n");
}

TEST(Rendering, ColumnsCountCharacters) {
  const Source source{"f.yaml", "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x93\xB7: bad\n"};
  const std::string text = rendered(source, source.bytes.find("bad"), 3);
  EXPECT_TRUE(text.starts_with("f.yaml:1:6: ")) << text;
  EXPECT_EQ(caret_column(text), 4U + 5U) << text;
}

TEST(Rendering, TheUnderlineCountsCharactersToo) {
  const Source source{"f.yaml", "a: \xC3\xA9\xC3\xA9\xC3\xA9 # x\n"};
  const std::vector<std::string> lines = split(rendered(source, 3, 6), '\n');
  EXPECT_EQ(lines.at(2), "       ^~~");
}

TEST(Rendering, TabsAreOneColumn) {
  const Source source{"f.yaml", "\ta:\tbad\n"};
  const std::string text = rendered(source, 4, 3);
  EXPECT_TRUE(text.starts_with("f.yaml:1:5: ")) << text;
  EXPECT_EQ(split(text, '\n').at(1), "     a: bad");
  EXPECT_EQ(caret_column(text), 4U + 4U);
}

TEST(Rendering, ByteOrderMarkAndCrlfAreNotShown) {
  const Source source{"f.yaml",
                      "\xEF\xBB\xBF"
                      "a: bad\r\nb\r\n"};
  EXPECT_EQ(rendered(source, 6, 3), "f.yaml:1:4: error: something is wrong [some-code]\n    a: bad\n       ^~~\n");
}

TEST(Rendering, EndOfFileAndBeyond) {
  const Source source{"f.yaml", "a: 1"};
  EXPECT_EQ(rendered(source, 4, 1), "f.yaml:1:5: error: something is wrong [some-code]\n    a: 1\n        ^\n");
  EXPECT_EQ(rendered(source, 400, 100), "f.yaml:1:5: error: something is wrong [some-code]\n    a: 1\n        ^\n");
}

TEST(Rendering, TheUnderlineEndsWithTheLine) {
  const Source source{"f.yaml", "a:\n  b: 1\n  c: 2\n"};
  EXPECT_EQ(split(rendered(source, 5, 11), '\n').at(2), "      ^~~~");
}

bool has_control_characters(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte < 0x20 && byte != '\n') || byte == 0x7F) return true;
    // U+0080 .. U+009F, of which U+009B opens an escape sequence as ESC [ does.
    if (byte == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0) return true;
  }
  return false;
}

// A file must not be able to drive the terminal of whoever reads its diagnostics: ESC ] 0 ; sets a title, ESC [ 2 J clears.
TEST(Rendering, NoControlCharacterOfTheFileLeaks) {
  for (const std::string bad : {"\x1b[2J", "\x07", "\x7f", "\r", "\x08",
                                "\xC2\x9B"
                                "2J",
                                "\xC2\x80"}) {
    const Source source{"f.yaml", "a: " + bad + " x\n"};
    EXPECT_FALSE(has_control_characters(rendered(source, 3, 2))) << "in the line: " << testing::PrintToString(bad);
    const text::Shown spoken{Severity::kError, "c", "the key '" + bad + "' is bad", "drop '" + bad + "'", {}};
    EXPECT_FALSE(has_control_characters(text::render(spoken, {}))) << "in the message: " << testing::PrintToString(bad);
    const Source named{"f" + bad + ".yaml", "a: x\n"};
    EXPECT_FALSE(has_control_characters(rendered(named, 3, 1))) << "in the name: " << testing::PrintToString(bad);
  }
}

TEST(Rendering, MultiLineMessagesStayOnTheirLine) {
  const text::Shown spoken{Severity::kError, "c", "a value 'x\ny.yaml:1:1: error: forged'", "", {}};
  EXPECT_EQ(split(text::render(spoken, {}), '\n').size(), 1U);
}

TEST(Rendering, LongLinesAreCutAroundThePlace) {
  const Source source{"f.yaml", "a: [" + std::string(5000, '1') + ", bad, " + std::string(5000, '2') + "]\n"};
  const std::string text = rendered(source, source.bytes.find("bad"), 3);
  const std::vector<std::string> lines = split(text, '\n');
  EXPECT_LE(lines.at(1).size(), 200U);
  EXPECT_EQ(lines.at(1).substr(caret_column(text), 3), "bad");
}

// Cut at any byte, what is printed is UTF-8, and the caret stands under the character.
TEST(Rendering, LongLinesOfUtf8AreCutBetweenCharacters) {
  for (int shift = 0; shift < 4; ++shift) {
    std::string bytes(static_cast<std::size_t>(shift), 'a');
    for (int i = 0; i < 100; ++i) bytes += "\xF0\x9F\x93\xB7";
    const std::size_t place = bytes.size();
    bytes += "BAD";
    for (int i = 0; i < 100; ++i) bytes += "\xE2\x82\xAC";
    const Source source{"f.yaml", bytes + "\n"};
    const std::string text = rendered(source, place, 3);
    EXPECT_EQ(text::valid_utf8(text), text) << shift;
    const std::string line = split(text, '\n').at(1);
    EXPECT_EQ(code_points(line.substr(0, line.find("BAD"))), caret_column(text)) << shift;
  }
}

TEST(Rendering, ColourOnlyWhenAsked) {
  const Source source{"f.yaml", "a: 1\n"};
  EXPECT_EQ(rendered(source, 3, 1).find('\x1b'), std::string::npos);
  const std::string coloured = rendered(source, 3, 1, "", true);
  EXPECT_NE(coloured.find("\x1b["), std::string::npos);
  EXPECT_NE(coloured.find("\x1b[0m"), std::string::npos);
}

TEST(Rendering, Positions) {
  const Source source{"f", "ab\r\n\nc\n"};
  const auto place = [&source](std::size_t offset) {
    const text::Position position = source.position(offset);
    return std::pair(position.line, position.column);
  };
  EXPECT_EQ(place(0), std::pair(1, 1));
  EXPECT_EQ(place(1), std::pair(1, 2));
  EXPECT_EQ(place(4), std::pair(2, 1));
  EXPECT_EQ(place(5), std::pair(3, 1));
  EXPECT_EQ(source.text(source.line_at(1)), "ab");
  EXPECT_EQ(source.text(source.line_at(4)), "");
  EXPECT_EQ(source.line_break(), "\r\n");
  EXPECT_EQ((Source{"f", "a\nb\r\n"}).line_break(), "\n");
}

TEST(Rendering, ValidUtf8KeepsTheLength) {
  const std::pair<std::string, std::string> kCases[] = {
      {"abc", "abc"},
      {"\xC3\xA9", "\xC3\xA9"},
      {"\xFC", "?"},
      {"\xC3", "?"},
      {"\xE2\x82", "??"},
      {"\x80z", "?z"},
      {"\xF0\x9F\x93\xB7", "\xF0\x9F\x93\xB7"},
      {"\xC3(", "?("},
      // Overlong forms, surrogates and what lies beyond U+10FFFF are not UTF-8 either (RFC 3629); a JSON parser refuses them.
      {"\xC0\x80", "??"},
      {"\xED\xA0\x80", "???"},
      {"\xF4\x90\x80\x80", "????"},
      {"\xE0\x80\xAF", "???"},
  };
  for (const auto& [bytes, expected] : kCases) EXPECT_EQ(text::valid_utf8(bytes), expected) << testing::PrintToString(bytes);
}

}  // namespace
}  // namespace fca::test
