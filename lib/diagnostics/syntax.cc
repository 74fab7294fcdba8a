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
constexpr std::string_view kIsCutOff = "is the file cut off?";
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
      error(Code::kYamlAlias, "yaml-alias", "a YAML alias (*name) that cannot be read here", kWriteValueOut),
      error(Code::kYamlAnchor, "yaml-anchor", "a YAML anchor (&name); OpenCV's YAML has none", kWriteValueOut),
      error(Code::kYamlMergeKey, "yaml-alias", "a merge key (<<) needs a mapping or a list of mappings", kWriteValueOut),
      note(Code::kYamlCopies, "yaml-alias", "values are shared by YAML aliases; fca-io reads this file, but does not edit it"),
      error(Code::kYamlCopiesNotEdited, "yaml-alias", "values are shared by YAML aliases: an edit here would change others",
            "write the values out first, or write a fresh file"),
      note(Code::kYamlRosParameters, "ros-parameters",
           "the calibration stands among a ROS 2 node's parameters; programs that read files do not look there"),
      error(Code::kYamlKeyIsNoName, "yaml-key", "a key that is no name"),
      error(Code::kYamlKeyWithoutColon, kYaml, "YAML syntax error: a key without its colon",
            "is a blank missing after the colon?"),
      error(Code::kYamlEndsEarly, kYaml, "YAML syntax error: the file ends inside a list or value",
            "is the file cut off? If not, a bracket or quote above is open"),
      error(Code::kYamlBlankMissing, "blank-missing", "a blank is missing after the colon", "write a blank after it"),
      error(Code::kYamlTab, "yaml-tab", "a TAB as indentation; YAML takes only blanks there", "replace the TAB by blanks"),
      error(Code::kYamlDocuments, "yaml-documents",
            "several YAML documents in one file, which programs read differently: cv::FileStorage looks keys up in all of "
            "them, PyYAML (Kalibr) refuses the file",
            "keep one document"),
      error(Code::kYamlMessages, "yaml-documents", "several messages of a ROS topic in one file",
            "keep one of them; rostopic echo -n 1 prints no more"),
      error(Code::kYamlNothingBegins, kYaml, "YAML syntax error: nothing can begin here"),
      error(Code::kYamlMapValue, kYaml, "YAML syntax error: illegal map value", "is a blank missing after the colon of a key?"),
      // In the parser's words.
      error(Code::kYamlSyntax, kYaml, "YAML syntax error: {0}"),
      error(Code::kYamlError, kYaml, "YAML error: {0}"),

      error(Code::kJsonMisread, "json-place", "the JSON parser read something else than what is here", kOurBug),
      error(Code::kJsonNotANumber, kJson, "JSON syntax error: JSON has no NaN and no infinity"),
      error(Code::kJsonPlus, kJson, "JSON syntax error: a JSON number begins without '+'"),
      error(Code::kJsonPointFirst, kJson, "JSON syntax error: a JSON number has a digit before its point"),
      error(Code::kJsonPointLast, kJson, "JSON syntax error: a JSON number has a digit after its point"),
      error(Code::kJsonLeadingZeros, kJson, "JSON syntax error: a JSON number has no leading zeros"),
      error(Code::kJsonNoNumber, kJson, "JSON syntax error: no JSON number"),
      error(Code::kJsonExponentEmpty, kJson, "JSON syntax error: a number without digits in its exponent"),
      error(Code::kJsonNumberTooBig, kJson, "JSON syntax error: a number too large for a double"),
      error(Code::kJsonValueMissing, kJson, "JSON syntax error: a value is missing here"),
      error(Code::kJsonNoValue, kJson, "JSON syntax error: '{0}' is no JSON value; text stands in double quotes"),
      error(Code::kJsonStringOpen, kJson, "JSON syntax error: a string that is never closed", kCloseIt),
      error(Code::kJsonStringOfLines, kJson, "JSON syntax error: a string that is not closed on its line", kCloseIt),
      error(Code::kJsonControlCharacter, kJson, "JSON syntax error: a control character inside a string", "escape it: \\t"),
      error(Code::kJsonNotUtf8, kJson, "JSON syntax error: a byte that is no UTF-8", "save the file as UTF-8"),
      error(Code::kJsonWrongEscape, kJson, "JSON syntax error: a wrong escape inside a string", "a backslash is spelled \\\\"),
      error(Code::kJsonBracketOpen, kJson, "JSON syntax error: a '{0}' that is never closed", kIsCutOff),
      error(Code::kJsonEndsEarly, kJson, "JSON syntax error: the file ends too early"),
      error(Code::kJsonCommaBehindLast, kJson, "JSON syntax error: a comma after the last value", "remove the comma"),
      error(Code::kJsonSingleQuotes, kJson, "JSON syntax error: single quotes; JSON has double quotes", "replace ' by \""),
      error(Code::kJsonComment, kJson, "JSON syntax error: a comment; JSON has none", "remove the comment"),
      error(Code::kJsonBehindRoot, kJson, "JSON syntax error: something follows the closing bracket"),
      error(Code::kJsonKeyWanted, kJson, "JSON syntax error: a key in double quotes is wanted"),
      error(Code::kJsonColonMissing, kJson, "JSON syntax error: a key without its colon"),
      error(Code::kJsonCommaMissing, kJson, "JSON syntax error: a comma or '{0}' is missing"),
      // In the parser's words.
      error(Code::kJsonSyntax, kJson, "JSON syntax error: {0}"),

      // Literals of Python.
      error(Code::kLiteralNotUtf8, kPython, "Python syntax error: a byte that is no UTF-8", "save the file as UTF-8"),
      error(Code::kLiteralNotANumber, kPython, "Python syntax error: a literal has no nan and no inf"),
      error(Code::kLiteralNoNumber, kPython, "Python syntax error: '{0}' is no decimal number"),
      error(Code::kLiteralValueMissing, kPython, "Python syntax error: a value is missing here"),
      error(Code::kLiteralNoValue, kPython, "Python syntax error: '{0}' is no literal; text stands in quotes"),
      error(Code::kLiteralStringOpen, kPython, "Python syntax error: a string that is never closed", kCloseIt),
      error(Code::kLiteralStringOfLines, kPython, "Python syntax error: a string that is not closed on its line", kCloseIt),
      error(Code::kLiteralStringsMixed, kPython, "Python syntax error: a text and bytes (b'..') side by side"),
      error(Code::kLiteralWrongEscape, kPython, "Python syntax error: a wrong escape inside a string",
            "a backslash is spelled \\\\"),
      error(Code::kLiteralBracketOpen, kPython, "Python syntax error: a '{0}' that is never closed", kIsCutOff),
      error(Code::kLiteralEndsEarly, kPython, "Python syntax error: the file ends too early"),
      error(Code::kLiteralBehindRoot, kPython, "Python syntax error: something follows the closing bracket"),
      error(Code::kLiteralKeyWanted, kPython, "Python syntax error: a key in quotes is wanted"),
      error(Code::kLiteralColonMissing, kPython, "Python syntax error: a key without its colon"),
      error(Code::kLiteralCommaMissing, kPython, "Python syntax error: a comma or '{0}' is missing"),

      error(Code::kXmlMisread, "xml-place", "the XML parser read something else than what is here", kOurBug),
      error(Code::kXmlElementOpen, kXml, "XML syntax error: <{0}> is never closed", kIsCutOff),
      error(Code::kXmlNoElement, kXml, "XML syntax error: no element at all", kIsCutOff),
      error(Code::kXmlTextOutside, kXml, "XML syntax error: text outside the root element"),
      error(Code::kXmlTagOpen, kXml, "XML syntax error: a '<' whose '>' is missing",
            "is the file cut off? A '<' in a text is spelled &lt;"),
      error(Code::kXmlInstruction, kXml, "XML syntax error: <?..?> is taken at the beginning only"),
      error(Code::kXmlDeclaration, "xml-declaration",
            "a document type, entity or CDATA section (<!..>); calibration files have none", "write the text out"),
      error(Code::kXmlTagWithoutName, kXml, "XML syntax error: a tag without a name", "a '<' in a text is spelled &lt;"),
      error(Code::kXmlSecondRoot, kXml, "XML syntax error: a second root element", "keep one <opencv_storage>"),
      error(Code::kXmlClosesNothing, kXml, "XML syntax error: </{0}> closes nothing"),
      error(Code::kXmlClosesAnother, kXml, "XML syntax error: </{0}> where </{1}> is wanted, which line {2} opens"),
      error(Code::kXmlRoot, "xml-root", "the outermost element is <{0}>; XML calibrations are OpenCV's, with <opencv_storage>"),
      error(Code::kXmlUnknownEntity, kXml, "XML syntax error: an entity that XML does not know",
            "a '&' in a text is spelled &amp;"),
      error(Code::kXmlQuoteOpen, kXml, "XML syntax error: a quote that is never closed", kCloseIt),
      error(Code::kXmlBlankMissing, kXml, "XML syntax error: a blank is missing after the quote"),
      error(Code::kXmlQuoteInWord, kXml, "XML syntax error: a quote inside a word",
            "spell it &quot;, or put all of it in quotes"),
      error(Code::kXmlMixed, "xml-mixed", "<{0}> holds both named elements and values"),
      error(Code::kXmlAttribute, kXml, "XML syntax error: an attribute is written name=\"value\""),
      error(Code::kXmlLine, kXml, "XML syntax error on this line"),

      // COLMAP's binary files.
      with_consequence(
          error(Code::kBinaryEndsInCount, kCount, "the file ends inside the number of 8 bytes that it begins with", kIsCutOff),
          kColmapStops),
      with_consequence(error(Code::kBinaryEndsInCamera, kCount, "the file ends inside camera {0} of {1}", kIsCutOff),
                       kColmapStops),
      with_consequence(error(Code::kBinaryEndsInRig, kCount, "the file ends inside rig {0} of {1}", kIsCutOff), kColmapStops),
      with_consequence(error(Code::kBinaryCount, kCount, "the file announces {0}, and its {1} bytes have room for {2} at most",
                             "is it one of COLMAP's, and whole?"),
                       kColmapStops),
      error(Code::kBinaryModel, "unknown-model", "COLMAP has no camera model with the number {0}",
            "is the file one of COLMAP's? The numbers are 0 to 17"),
      error(Code::kBinarySensor, "out-of-range", "COLMAP has no sensors of the type {0}", "0 is a camera, 1 an IMU"),
      error(Code::kBinaryPoseFlag, "out-of-range", "{0} where 1 says that a pose follows, and 0 that none does"),
      error(Code::kNpyTruncated, kCount, "the file ends before the array that its first bytes announce"),
      error(Code::kNpyLonger, kCount, "there are more bytes than the array has that the first ones announce"),
      error(Code::kNpyOtherArray, "wrong-syntax",
            "an array of NumPy is read where it has two dimensions, of little-endian floating-point numbers in rows",
            "save it with numpy.save(file, numpy.ascontiguousarray(array.reshape(-1, 5), '<f8'))"),
      with_consequence(
          warning(Code::kBinaryBehind, kCount, "{0} bytes after what the file announces", "is it whole, and one file?"),
          "COLMAP does not read them."),
      error(Code::kBinaryOther, "unknown-format", "COLMAP's {0} holds no camera", "take cameras.bin, or the folder"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
