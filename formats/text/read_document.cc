// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/formats/text/read_document.h>
#include <fca/formats/text/read_stream.h>

#include "binary.h"
#include "json.h"
#include "npy.h"
#include "python.h"
#include "syntax.h"
#include "words.h"
#include "xml.h"
#include "yaml.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <istream>
#include <memory>
#include <utility>

namespace fca::text {

namespace {

/// Reads one byte more than allowed, so that "too large" is seen without reading all of a huge or endless file.
std::string read_limited(std::istream& stream) {
  std::string bytes;
  std::array<char, 16384> part;  // not all of the limit at once: clearing 2 MiB takes longer than reading a calibration
  while (stream && bytes.size() <= kMaxFileBytes) {
    stream.read(part.data(), static_cast<std::streamsize>(std::min(part.size(), kMaxFileBytes + 1 - bytes.size())));
    bytes.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  }
  return bytes;
}

/// YAML's flow style begins as JSON does. Sets `syntax` to kYaml if that is what it is.
std::optional<Node> parse_json_or_yaml(const Source& source, Syntax& syntax, Diagnostics& diagnostics) {
  Diagnostics as_json;
  std::optional<Node> root = parse_json(source, as_json);
  if (root) return root;
  const bool yaml = named_as_yaml(source);
  Diagnostics as_yaml;
  if (falls_back_to_yaml(source)) root = parse_yaml(source, Syntax::kYaml, as_yaml);
  if (root) syntax = Syntax::kYaml;
  // What is wrong with it, as a file of the kind that its name says.
  const Diagnostics& said = root || yaml ? as_yaml : as_json;
  for (const Diagnostic& entry : said.entries()) diagnostics.add(entry);
  return root;
}

/// By its quotes a literal of Python, which YAML's flow style can begin as, too.
std::optional<Node> parse_python_or_yaml(const Source& source, Syntax& syntax, Diagnostics& diagnostics) {
  Diagnostics as_python;
  std::optional<Node> root = parse_python(source, as_python);
  if (root) return root;
  Diagnostics as_yaml;
  if (!named_as_python(source)) root = parse_yaml(source, Syntax::kYaml, as_yaml);
  if (root) syntax = Syntax::kYaml;
  for (const Diagnostic& entry : (root ? as_yaml : as_python).entries()) diagnostics.add(entry);
  return root;
}

std::optional<Node> parse(const Source& source, Syntax& syntax, Diagnostics& diagnostics) {
  switch (syntax) {
    case Syntax::kYaml:
    case Syntax::kOpenCvYaml:
      return parse_yaml(source, syntax, diagnostics);
    case Syntax::kXml:
      return parse_xml(source, diagnostics);
    case Syntax::kJson:
      return parse_json_or_yaml(source, syntax, diagnostics);
    case Syntax::kPython:
      return parse_python_or_yaml(source, syntax, diagnostics);
    case Syntax::kWords:
      return parse_words(source, diagnostics);
    case Syntax::kBinary:
      return begins_as_npy(source.bytes) ? parse_npy(source, diagnostics) : parse_binary(source, diagnostics);
  }
  return std::nullopt;
}

/// UTF-16 in either order of bytes, with its mark or, of ASCII's characters, without.
bool is_utf16(std::string_view bytes) {
  const bool is_utf32 = bytes.substr(0, 4) == std::string_view("\xFF\xFE\0\0", 4);
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return !is_utf32;
  const std::string_view begin = bytes.substr(0, 64);
  std::array<std::size_t, 2> zeros = {0, 0};  // at even places, at odd ones
  for (std::size_t i = 0; i < begin.size(); ++i) zeros[i % 2] += begin[i] == '\0' ? 1 : 0;
  const std::size_t pairs = begin.size() / 2;
  const auto [fewer, more] = std::minmax(zeros[0], zeros[1]);
  return pairs > 0 && fewer == 0 && 4 * more > 3 * pairs;
}

/// JSON, Python and XML take a CR as a blank.
bool needs_line_feeds(Syntax syntax) { return !is_in_brackets(syntax) && syntax != Syntax::kXml; }

}  // namespace

Source read_stream(std::string name, std::istream& stream) { return {std::move(name), read_limited(stream)}; }

std::optional<Source> read_source(const std::string& path, Diagnostics& diagnostics) {
  const auto cannot_read = [&](Argument why) {
    diagnostics.add(Code::kFileUnreadable, {std::move(why)}, {path, 0, 0});
    return std::nullopt;
  };
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) return cannot_read(Message{Code::kFileMissing});
  if (status.type() == std::filesystem::file_type::directory) return cannot_read(Message{Code::kFileIsDirectory});
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return cannot_read(std::strerror(errno != 0 ? errno : EIO));
  std::string bytes = read_limited(stream);
  if (stream.bad()) return cannot_read(Message{Code::kFileReadingFailed});
  return Source{path, std::move(bytes)};
}

std::optional<Document> parse_document(Source source, Diagnostics& diagnostics) {
  const std::string_view text = std::string_view(source.bytes).substr(source.byte_order_mark());
  const SourceRange file = {source.name, 0, 0};
  if (source.bytes.size() > kMaxFileBytes) {
    diagnostics.add(Code::kFileTooLarge, {kMaxFileBytes / 1024 / 1024}, file);
    return std::nullopt;
  }
  if (!source.bytes.empty() && source.is_binary()) {
    Syntax binary = Syntax::kBinary;
    std::optional<Node> root = parse(source, binary, diagnostics);
    return root ? std::optional(Document(std::move(source), binary, *std::move(root))) : std::nullopt;
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    diagnostics.add(Code::kFileEmpty, {}, file);
    return std::nullopt;
  }
  if (is_utf16(source.bytes)) {
    diagnostics.add(Code::kFileUtf16, {}, file);
    return std::nullopt;
  }
  if (const std::size_t zero = source.bytes.find('\0'); zero != std::string::npos) {
    diagnostics.add(Code::kFileBinary, {}, source.range({zero, 1}));
    return std::nullopt;
  }
  Syntax syntax = choose_syntax(source);
  const std::size_t carriage_return = source.bytes.find('\r');
  if (carriage_return != std::string::npos && source.bytes.find('\n') == std::string::npos && needs_line_feeds(syntax)) {
    diagnostics.add(Code::kFileCrOnly, {}, source.range({carriage_return, 1}));
    return std::nullopt;
  }
  std::optional<Node> root = parse(source, syntax, diagnostics);
  if (!root) return std::nullopt;
  return Document(std::move(source), syntax, *std::move(root));
}

std::optional<Document> as_edited(const Document& document) {
  if (!document.edited()) return document;
  if (const Document* kept = document.kept_edited()) return *kept;
  Diagnostics ignored;
  return parse_document({document.source().name, document.bytes()}, ignored);
}

void keep_edited(Document& document) {
  if (!document.edited() || document.kept_edited() != nullptr) return;
  if (std::optional<Document> edited = as_edited(document))
    document.keep_edited(std::make_shared<const Document>(*std::move(edited)));
}

std::optional<Document> read_document(const std::string& path, Diagnostics& diagnostics) {
  std::optional<Source> source = read_source(path, diagnostics);
  if (!source) return std::nullopt;
  return parse_document(*std::move(source), diagnostics);
}

}  // namespace fca::text
