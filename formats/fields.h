// SPDX-License-Identifier: BSD-3-Clause
// Between nodes and meaning: reads typed values with a diagnostic at their place, and writes fields by the smallest edits.
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/text/dialect.h>
#include <fca/formats/text/document.h>
#include <fca/rig/rig.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca::fields {

/// Reads values of one document as one program's dialect. Every method that fails has added an error at the place.
class Reader {
 public:
  Reader(const text::Document& document, text::Dialect dialect, Diagnostics& diagnostics)
      : document_(document), dialect_(dialect), diagnostics_(diagnostics) {}

  /// The value that counts under a key; null (no error) if there is none.
  [[nodiscard]] const text::Node* find(const text::Node& mapping, std::string_view key) const;
  /// The same; an error "missing-key" if there is none. `owner`: what lacks the key, for the message ("cam0").
  [[nodiscard]] const text::Node* require(const text::Node& mapping, std::string_view key, std::string_view owner);

  /// A finite number; integers count.
  [[nodiscard]] std::optional<double> real(const text::Node& node, std::string_view what);
  /// A number greater than 0 and not absurdly large (noise densities, rates, baselines).
  [[nodiscard]] std::optional<double> positive(const text::Node& node, std::string_view what);
  /// A baseline in metres; where a focal length [px] is given, from their product (Camera.bf).
  [[nodiscard]] std::optional<double> baseline(const text::Node& node, std::string_view what,
                                               std::optional<double> focal_length = {});
  /// Seconds.
  [[nodiscard]] std::optional<double> time_offset(const text::Node& node, std::string_view what);
  [[nodiscard]] std::optional<int> integer(const text::Node& node, std::string_view what);
  /// What cameras and topics are called, on one line and without control characters: people, terminals and other files are told
  /// it. A warning where the file has others. Empty where no scalar stands there.
  [[nodiscard]] std::string name(const text::Node& node, std::string_view what);
  [[nodiscard]] std::optional<std::string> string(const text::Node& node, std::string_view what);
  /// A sequence of finite numbers; any length if `count` is 0.
  [[nodiscard]] std::optional<std::vector<double>> reals(const text::Node& node, std::size_t count, std::string_view what);
  /// Sets a parameter of the model to the node's number; an error at the node if that cannot be.
  [[nodiscard]] bool parameter(const text::Node& node, std::string_view what, ParameterId id, CameraModel& model);
  /// The same of a value that was computed from the node's.
  [[nodiscard]] bool parameter(const text::Node& node, std::string_view what, ParameterId id, double value, CameraModel& model);
  /// Width and height; an error at `width` if no image can have that size.
  [[nodiscard]] std::optional<ImageSize> image_size(const text::Node& width, const text::Node& height, std::string_view owner);
  /// 4 x 4 as nested rows or as 16 numbers.
  [[nodiscard]] std::optional<Transform> transform(const text::Node& node, std::string_view what);
  /// Where a part of a pose stands and what it is called.
  struct Place {
    const text::Node& node;  ///< Its numbers as a list, nested lists or an opencv-matrix: of the part, or of the whole pose.
    std::string_view what;
  };
  /// The same transform: an error (and nothing) if its last row is not 0 0 0 1 or a number is beyond the limits of
  /// rig/limits.h, a warning if its 3 x 3 part is only roughly a rotation.
  [[nodiscard]] std::optional<Transform> checked(const Transform& T, const Place& rotation, const Place& translation);
  [[nodiscard]] std::optional<Transform> checked(const Transform& T, const text::Node& node, std::string_view what) {
    return checked(T, {node, what}, {node, what});
  }
  /// An opencv-matrix {rows, cols, dt, data}: its numbers row by row, with rows and cols checked against them.
  struct Matrix {
    int rows = 0;
    int cols = 0;
    std::vector<double> values;
  };
  [[nodiscard]] std::optional<Matrix> opencv_matrix(const text::Node& node, std::string_view what);

  /// A warning at every entry of a mapping that does not count; after a few only their number.
  void warn_of_duplicates(const text::Node& mapping);
  /// A warning at every key that nobody has asked for and that is probably one which was asked for and is not there: what it
  /// specifies would be lost without a word. To be called when all is read.
  void warn_of_misspelt() const;
  /// Every key of a mapping that nobody has asked for, as what `owner` specifies besides. To be called when all is read.
  void keep_unasked(const text::Node& mapping, const std::string& owner, std::vector<ExtraField>& kept) const;
  /// As severe as the table says, at the node.
  void say(const text::Node& node, Code code, std::vector<Argument> arguments = {});
  void say(Severity severity, const text::Node& node, Code code, std::vector<Argument> arguments = {});

  [[nodiscard]] const text::Document& document() const { return document_; }
  [[nodiscard]] text::Dialect dialect() const { return dialect_; }
  [[nodiscard]] Diagnostics& diagnostics() { return diagnostics_; }

 private:
  const text::Document& document_;
  text::Dialect dialect_;
  Diagnostics& diagnostics_;
  struct Asked {
    const text::Node* mapping;
    std::string key;
    bool found;
  };
  [[nodiscard]] bool has_read(const text::Node& mapping, std::string_view key) const;
  mutable std::vector<Asked>
      asked_;  ///< A note for warn_of_misspelt() and keep_unasked(): what find() answers does not depend on it.
};

/// The words of a scalar, as scalars at their places; of another node none.
[[nodiscard]] std::vector<text::Node> words_in(const text::Node& scalar, std::string_view separators);

/// How a field's value is laid out.
enum class Shape {
  kScalar,  ///< key: 1.0
  kList,    ///< key: [1.0, 2.0]
  kRows,    ///< key: and one "- [..]" line per row of 4
  kMatrix,  ///< key: !!opencv-matrix with rows, cols, dt, data
};

/// A key and what its value says, as tokens ready to be written in YAML; other syntaxes spell them their own way.
struct Field {
  std::string key;
  Shape shape = Shape::kScalar;
  std::vector<std::string> tokens;
  int columns = 0;           ///< kRows, kMatrix
  std::string element_type;  ///< kMatrix: "f" or "d"
  bool operator==(const Field&) const = default;
};

[[nodiscard]] Field scalar(std::string key, std::string token);
[[nodiscard]] Field real(std::string key, double value);
[[nodiscard]] Field integer(std::string key, int value);
/// A double-quoted string, escaped.
[[nodiscard]] Field quoted(std::string key, std::string_view value);
[[nodiscard]] Field list(std::string key, std::span<const double> values);
[[nodiscard]] Field rows(std::string key, const Transform& T);
[[nodiscard]] Field matrix(std::string key, std::span<const double> values, int columns, std::string element_type);

/// The lines of a field after `indentation` blanks, without a last line break (and, in JSON, without a comma).
[[nodiscard]] std::string spell(const Field& field, std::size_t indentation = 0, text::Syntax syntax = text::Syntax::kYaml);

/// What a value says, for Rig::extra_fields: a scalar as spelled; lists and mappings on one line, their reals in one spelling.
[[nodiscard]] std::string value_text(const text::Node& value);

/// Makes a scalar say what the token says, in the document's syntax. A scalar that says so already is not touched, whatever its
/// spelling. For documents of words, which have no keys for apply().
void set_scalar(text::Document& document, const text::Node& scalar, const std::string& token);

/// Text of a document as Document::insert_after takes it: line feeds alone, and without `indentation` after them.
[[nodiscard]] std::string unindented(std::string_view text, std::string_view indentation);

/// A double-quoted YAML string.
[[nodiscard]] std::string quote(std::string_view value);

/// Takes a mapping from saying `before` to saying `after`: fields that are equal in both are not touched, whatever their
/// spelling; changed ones are edited number by number where the layout allows; new ones are inserted after their predecessor,
/// vanished ones removed. With an empty `before`, every field of `after` is compared with what the document says.
void apply(text::Document& document, const text::Node& mapping, text::Dialect dialect, std::span<const Field> before,
           std::span<const Field> after);

}  // namespace fca::fields
