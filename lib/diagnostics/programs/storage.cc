// SPDX-License-Identifier: BSD-3-Clause
// What cv::FileStorage and PyYAML report about a file, what stands in it in their words, and what all programs say of its
// bytes.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> storage_program_codes() {
  static constexpr std::array kRows = {
      // Of any program.
      refusal(Code::kProgramFileEmpty, "the file is empty"),
      refusal(Code::kProgramFileTooLarge, "the file is larger than 2 MiB; not read"),
      refusal(Code::kProgramNoNumber, "{0} is {1}, not a number"),
      remedy(Code::kProgramWriteReal, "int-for-real", ": write {0}.0"),
      // cv::FileStorage. {0}: who does not take the file, {1}: its words, or one of the clauses.
      refusal(Code::kStorageZeroByte, "the file contains a zero byte: it is not text"),
      refusal(Code::kStorageTooManyElements, "more than 64 nested or 512 elements; not read"),
      refusal(Code::kStorageNestedTooDeep, "more than 64 nested lists or maps, or an indentation beyond 200"),
      refusal(Code::kStorageByteOrderMark,
              "the file begins with a byte order mark (BOM), which cv::FileStorage does not parse"),
      refusal(Code::kStorageNoDocument, "cv::FileStorage finds no document in the file"),
      refusal(Code::kStorageNotTaken, "{0} does not take the file: {1}"),
      naming(clause(Code::kStorageReaderOf, "OpenCV's reader, which {0} uses,")),
      named_refusal(Code::kStorageProgramStops, "{0} stops: {1}"),
      clause(Code::kStorageNoCount, "{0} is not a count of rows or columns"),
      clause(Code::kStorageTooFewNumbers, "it has {0} numbers for {1} places"),
      // What stands under a key of cv::FileStorage: reals keep a '.', so that they differ from ints.
      clause(Code::kValueReal, "{0:real}"),
      clause(Code::kValueString, "the string \"{0}\""),
      clause(Code::kValueMap, "a map"),
      clause(Code::kValueNothing, "nothing"),
      // Why PyYAML raises.
      clause(Code::kPyYamlAtLine, "line {0}: {1}"),
      clause(Code::kPyYamlInItsWords, "{0}"),
      clause(Code::kPyYamlTooLarge, "larger than 2 MiB; not read"),
      clause(Code::kPyYamlNotUtf8, "the bytes are not UTF-8"),
      clause(Code::kPyYamlControlCharacter, "a control character is not allowed in YAML"),
      clause(Code::kPyYamlLineEnd,
             "PyYAML ends a line, also a comment, at this character, which others take for a space (U+0085, U+2028, U+2029)"),
      clause(Code::kPyYamlNestedTooDeep, "more than 64 nested lists or maps"),
      clause(Code::kPyYamlOpenCvHeader, "the header '{0}' is OpenCV's; PyYAML wants '%YAML 1.2' and '---', or no header"),
      clause(Code::kPyYamlVersion, "the '%YAML' line asks for a version other than 1.x"),
      clause(Code::kPyYamlDirectiveAlone, "a '%' line must be followed by '---'"),
      clause(Code::kPyYamlTab, "a TAB outside of a comment or quotes (PyYAML: cannot start any token)"),
      clause(Code::kPyYamlOpenQuote, "a quote is not closed"),
      clause(Code::kPyYamlSecondDocument, "a second document ('---'); safe_load wants one"),
      clause(Code::kPyYamlEmptyPlace, "nothing between two commas"),
      clause(Code::kPyYamlAliasOfItself, "an alias of something that contains it"),
      clause(Code::kPyYamlUnknownTag, "the tag '{0}' is unknown to safe_load"),
      clause(Code::kPyYamlTagOfOthers, "'{0}' does not fit its tag"),
      clause(Code::kPyYamlKeyNoScalar, "a list or map as a key"),
      clause(Code::kPyYamlNoColon, "'{0}' lacks a colon followed by a space"),
      clause(Code::kPyYamlMergeOfNoMap, "'<<' wants a map"),
      // What stands under a key of PyYAML.
      clause(Code::kPyYamlScalar, "the {0} {1}"),
      clause(Code::kPyYamlString, "the string '{0}'"),
      clause(Code::kPyYamlList, "a list of {0}"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
