// SPDX-License-Identifier: BSD-3-Clause
// What cannot be parsed.
#include "rows.h"
#include "topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kYaml = "yaml-syntax";
constexpr std::string_view kJson = "json-syntax";
constexpr std::string_view kPython = "python-syntax";
constexpr std::string_view kXml = "xml-syntax";
constexpr std::string_view kCount = "wrong-count";

constexpr std::string_view kCloseIt = "close it";
constexpr std::string_view kIsCutOff = "check whether the file is cut off";
constexpr std::string_view kOurBug = "report this file: it is a bug";
constexpr std::string_view kWriteValueOut = "write the value out";

}  // namespace

std::span<const CodeInfo> syntax_codes() {
  static constexpr std::string_view kColmapStops = "COLMAP stops, or reads what is not there.";
  static constexpr std::array kRows = {
      error(Code::kTooDeep, "too-deep", "nested deeper than {0} levels"),
      error(Code::kListTooLong, "too-long", "more than {0} values in one list; no calibration has so many"),
      error(Code::kMergeConflict, "merge-conflict", "a git merge-conflict marker: the file holds two versions of these lines",
            "keep one version and delete the marker lines"),

      error(Code::kYamlQuoteOpen, kYaml, "YAML syntax error: a quote that is never closed", kCloseIt),
      error(Code::kYamlAlias, "yaml-alias", "a YAML alias (*name) that fca-io cannot read here", kWriteValueOut),
      error(Code::kYamlAnchor, "yaml-anchor", "a YAML anchor (&name); OpenCV's YAML has none", kWriteValueOut),
      error(Code::kYamlMergeKey, "yaml-alias", "a merge key (<<) needs a mapping or a list of mappings", kWriteValueOut),
      note(Code::kYamlCopies, "yaml-alias", "values are shared by YAML aliases; fca-io reads this file, but does not edit it"),
      error(Code::kYamlCopiesNotEdited, "yaml-alias", "values are shared by YAML aliases: an edit here would change others",
            "write the values out first, or write a fresh file"),
      note(Code::kYamlRosParameters, "ros-parameters",
           "the calibration is among a ROS 2 node's parameters; programs that read files do not look there"),
      error(Code::kYamlKeyIsNoName, "yaml-key", "a key that is not a name"),
      error(Code::kYamlKeyWithoutColon, kYaml, "YAML syntax error: a key without its colon",
            "check for a missing space after the colon"),
      error(Code::kYamlEndsEarly, kYaml, "YAML syntax error: the file ends inside a list or value",
            "check whether the file is cut off; if not, a bracket or quote above is open"),
      error(Code::kYamlBlankMissing, "blank-missing", "a space is missing after the colon", "write a space after it"),
      error(Code::kYamlTab, "yaml-tab", "a TAB as indentation; YAML allows only spaces there", "replace the TAB by spaces"),
      error(Code::kYamlDocuments, "yaml-documents",
            "several YAML documents in one file, which programs read differently: cv::FileStorage looks keys up in all of "
            "them, PyYAML (Kalibr) refuses the file",
            "keep one document"),
      error(Code::kYamlMessages, "yaml-documents", "several messages of a ROS topic in one file",
            "keep one of them; rostopic echo -n 1 prints no more"),
      error(Code::kYamlNothingBegins, kYaml, "YAML syntax error: nothing can begin here"),
      error(Code::kYamlMapValue, kYaml, "YAML syntax error: illegal map value",
            "check for a missing space after the colon of a key"),
      // In the parser's words.
      error(Code::kYamlSyntax, kYaml, "YAML syntax error: {0}"),
      error(Code::kYamlError, kYaml, "YAML error: {0}"),

      error(Code::kJsonMisread, "json-place", "the JSON parser read something else than the file contains here", kOurBug),
      error(Code::kJsonNotANumber, kJson, "JSON syntax error: JSON has no NaN and no infinity"),
      error(Code::kJsonPlus, kJson, "JSON syntax error: a JSON number begins without '+'"),
      error(Code::kJsonPointFirst, kJson, "JSON syntax error: a JSON number has a digit before its point"),
      error(Code::kJsonPointLast, kJson, "JSON syntax error: a JSON number has a digit after its point"),
      error(Code::kJsonLeadingZeros, kJson, "JSON syntax error: a JSON number has no leading zeros"),
      error(Code::kJsonNoNumber, kJson, "JSON syntax error: not a JSON number"),
      error(Code::kJsonExponentEmpty, kJson, "JSON syntax error: a number without digits in its exponent"),
      error(Code::kJsonNumberTooBig, kJson, "JSON syntax error: a number too large for a double"),
      error(Code::kJsonValueMissing, kJson, "JSON syntax error: a value is missing here"),
      error(Code::kJsonNoValue, kJson, "JSON syntax error: '{0}' is not a JSON value; write text in double quotes"),
      error(Code::kJsonStringOpen, kJson, "JSON syntax error: a string that is never closed", kCloseIt),
      error(Code::kJsonStringOfLines, kJson, "JSON syntax error: a string that is not closed on its line", kCloseIt),
      error(Code::kJsonControlCharacter, kJson, "JSON syntax error: a control character inside a string", "escape it: \\t"),
      error(Code::kJsonNotUtf8, kJson, "JSON syntax error: a byte that is not UTF-8", "save the file as UTF-8"),
      error(Code::kJsonWrongEscape, kJson, "JSON syntax error: a wrong escape inside a string", "write a backslash as \\\\"),
      error(Code::kJsonBracketOpen, kJson, "JSON syntax error: a '{0}' that is never closed", kIsCutOff),
      error(Code::kJsonEndsEarly, kJson, "JSON syntax error: the file ends too early"),
      error(Code::kJsonCommaAfterLast, kJson, "JSON syntax error: a comma after the last value", "remove the comma"),
      error(Code::kJsonSingleQuotes, kJson, "JSON syntax error: single quotes; JSON has double quotes", "replace ' by \""),
      error(Code::kJsonComment, kJson, "JSON syntax error: a comment; JSON has none", "remove the comment"),
      error(Code::kJsonAfterRoot, kJson, "JSON syntax error: something follows the closing bracket"),
      error(Code::kJsonKeyWanted, kJson, "JSON syntax error: a key in double quotes is missing"),
      error(Code::kJsonColonMissing, kJson, "JSON syntax error: a key without its colon"),
      error(Code::kJsonCommaMissing, kJson, "JSON syntax error: a comma or '{0}' is missing"),
      // In the parser's words.
      error(Code::kJsonSyntax, kJson, "JSON syntax error: {0}"),

      // Literals of Python.
      error(Code::kLiteralNotUtf8, kPython, "Python syntax error: a byte that is not UTF-8", "save the file as UTF-8"),
      error(Code::kLiteralNotANumber, kPython, "Python syntax error: a literal has no nan and no inf"),
      error(Code::kLiteralNoNumber, kPython, "Python syntax error: '{0}' is not a decimal number"),
      error(Code::kLiteralValueMissing, kPython, "Python syntax error: a value is missing here"),
      error(Code::kLiteralNoValue, kPython, "Python syntax error: '{0}' is not a literal; write text in quotes"),
      error(Code::kLiteralStringOpen, kPython, "Python syntax error: a string that is never closed", kCloseIt),
      error(Code::kLiteralStringOfLines, kPython, "Python syntax error: a string that is not closed on its line", kCloseIt),
      error(Code::kLiteralStringsMixed, kPython, "Python syntax error: text and bytes (b'..') next to each other"),
      error(Code::kLiteralWrongEscape, kPython, "Python syntax error: a wrong escape inside a string",
            "write a backslash as \\\\"),
      error(Code::kLiteralBracketOpen, kPython, "Python syntax error: a '{0}' that is never closed", kIsCutOff),
      error(Code::kLiteralEndsEarly, kPython, "Python syntax error: the file ends too early"),
      error(Code::kLiteralAfterRoot, kPython, "Python syntax error: something follows the closing bracket"),
      error(Code::kLiteralKeyWanted, kPython, "Python syntax error: a key in quotes is missing"),
      error(Code::kLiteralColonMissing, kPython, "Python syntax error: a key without its colon"),
      error(Code::kLiteralCommaMissing, kPython, "Python syntax error: a comma or '{0}' is missing"),

      error(Code::kXmlMisread, "xml-place", "the XML parser read something else than the file contains here", kOurBug),
      error(Code::kXmlElementOpen, kXml, "XML syntax error: <{0}> is never closed", kIsCutOff),
      error(Code::kXmlNoElement, kXml, "XML syntax error: the file has no element", kIsCutOff),
      error(Code::kXmlTextOutside, kXml, "XML syntax error: text outside the root element"),
      error(Code::kXmlTagOpen, kXml, "XML syntax error: a '<' whose '>' is missing",
            "check whether the file is cut off; write a '<' in a text as &lt;"),
      error(Code::kXmlInstruction, kXml, "XML syntax error: <?..?> is allowed only at the beginning"),
      error(Code::kXmlDeclaration, "xml-declaration",
            "a document type, entity or CDATA section (<!..>); calibration files have none", "write the text out"),
      error(Code::kXmlTagWithoutName, kXml, "XML syntax error: a tag without a name", "write a '<' in a text as &lt;"),
      error(Code::kXmlSecondRoot, kXml, "XML syntax error: a second root element", "keep one <opencv_storage>"),
      error(Code::kXmlClosesNothing, kXml, "XML syntax error: </{0}> closes nothing"),
      error(Code::kXmlClosesAnother, kXml, "XML syntax error: </{0}> where </{1}> must close the element that line {2} opens"),
      error(Code::kXmlRoot, "xml-root", "the outermost element is <{0}>; XML calibrations are OpenCV's, with <opencv_storage>"),
      error(Code::kXmlUnknownEntity, kXml, "XML syntax error: an entity that XML does not know",
            "write a '&' in a text as &amp;"),
      error(Code::kXmlQuoteOpen, kXml, "XML syntax error: a quote that is never closed", kCloseIt),
      error(Code::kXmlBlankMissing, kXml, "XML syntax error: a space is missing after the quote"),
      error(Code::kXmlQuoteInWord, kXml, "XML syntax error: a quote inside a word",
            "write it as &quot;, or put all of the text in quotes"),
      error(Code::kXmlMixed, "xml-mixed", "<{0}> holds both named elements and values"),
      error(Code::kXmlAttribute, kXml, "XML syntax error: an attribute must be name=\"value\""),
      error(Code::kXmlLine, kXml, "XML syntax error on this line"),

      // COLMAP's binary files.
      with_consequence(
          error(Code::kBinaryEndsInCount, kCount, "the file ends inside its first number, which has 8 bytes", kIsCutOff),
          kColmapStops),
      with_consequence(error(Code::kBinaryEndsInCamera, kCount, "the file ends inside camera {0} of {1}", kIsCutOff),
                       kColmapStops),
      with_consequence(error(Code::kBinaryEndsInRig, kCount, "the file ends inside rig {0} of {1}", kIsCutOff), kColmapStops),
      with_consequence(error(Code::kBinaryCount, kCount, "the file announces {0}, but its {1} bytes have room for at most {2}",
                             "check that it is one of COLMAP's files, and complete"),
                       kColmapStops),
      error(Code::kBinaryModel, "unknown-model", "COLMAP has no camera model with the number {0}",
            "check that the file is one of COLMAP's; the numbers are 0 to 17"),
      error(Code::kBinarySensor, "out-of-range", "COLMAP has no sensors of the type {0}", "write 0 for a camera, 1 for an IMU"),
      error(Code::kBinaryPoseFlag, "out-of-range", "{0} is neither 1 (a pose follows) nor 0 (no pose follows)"),
      error(Code::kNpyTruncated, kCount, "the file ends before the array that its header announces"),
      error(Code::kNpyLonger, kCount, "the file is longer than the array that its header announces"),
      error(Code::kNpyOtherArray, "wrong-syntax",
            "fca-io reads only NumPy arrays of two dimensions, with little-endian floating-point numbers in row order",
            "save it with numpy.save(file, numpy.ascontiguousarray(array.reshape(-1, 5), '<f8'))"),
      with_consequence(warning(Code::kBinaryAfterEnd, kCount, "{0} bytes follow after what the file announces",
                               "check that it is one complete file"),
                       "COLMAP does not read them."),
      error(Code::kBinaryOther, "unknown-format", "COLMAP's {0} contains no camera", "give cameras.bin, or the folder"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
