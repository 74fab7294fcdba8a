// SPDX-License-Identifier: BSD-3-Clause
// Defects of spelling and syntax, planted in the text of good files, are found in the line where they stand.
#include "places.h"
#include "seeded_files.h"

#include <fca/formats/text/numbers.h>

#include <cmath>

namespace fca::test {
namespace {

/// A defect, and the formats whose program stumbles over it (for others it is none).
struct TextDefect {
  const char* name;
  std::vector<std::string_view> formats;  ///< Empty: all.
  std::vector<std::string> codes;         ///< One of them must be said.
  /// The edit that plants it, or nothing where the file has no such place.
  std::function<std::optional<SpanEdit>(const Good&)> plant;
  bool line_is_known = true;  ///< False: the defect is of the file as a whole.
};

const text::Document& document_of(const Good& good) { return good.calibration.documents.front(); }
const std::string& bytes_of(const Good& good) { return document_of(good).source().bytes; }
bool has_cameras(const Good& good) { return !good.calibration.rig.cameras.empty(); }

/// Does ORB-SLAM3 itself load it? The older programs of its family are less strict.
bool is_read_by_orbslam3(const Good& good) {
  return std::ranges::any_of(good.report.readers.programs, [](const Readers::Program& program) {
    return program.loads && program.program.starts_with("ORB-SLAM3");
  });
}

/// Where the first camera's parameter stands, with what stands there.
std::optional<text::Span> number_of(const Good& good, std::string_view name) {
  if (!has_cameras(good)) return std::nullopt;
  const Places places(document_of(good), good.calibration);
  const Camera& camera = good.calibration.rig.cameras.front();
  if (!parameter(camera.model, name)) return std::nullopt;
  const SourceRange where = places.parameter(camera, name);
  if (where.length == 0) return std::nullopt;
  return text::Span{where.offset, where.length};
}

/// Another spelling of a parameter.
auto spelled(std::string_view name, std::function<std::string(const std::string&)> change) {
  return [name, change = std::move(change)](const Good& good) -> std::optional<SpanEdit> {
    const std::optional<text::Span> span = number_of(good, name);
    if (!span) return std::nullopt;
    return SpanEdit{*span, change(std::string(document_of(good).source().text(*span)))};
  };
}

/// The first line that begins so (behind blanks) and ends so, replaced by a function of it.
auto line_starting(std::string_view start, std::function<std::optional<std::string>(const std::string&)> change) {
  return [start, change = std::move(change)](const Good& good) -> std::optional<SpanEdit> {
    const std::string& bytes = bytes_of(good);
    for (std::size_t at = 0; at < bytes.size();) {
      const text::Span line = document_of(good).source().line_at(at);
      const std::string text(document_of(good).source().text(line));
      const std::size_t first = text.find_first_not_of(' ');
      if (first != std::string::npos && std::string_view(text).substr(first).starts_with(start)) {
        const std::optional<std::string> changed = change(text);
        if (!changed || *changed == text) return std::nullopt;
        return SpanEdit{line, *changed};
      }
      at = std::min(bytes.find('\n', line.end()), bytes.size() - 1) + 1;
    }
    return std::nullopt;
  };
}

/// "key: 12.5  # note" with the number replaced; nothing unless a number stands there.
std::optional<std::string> with_number(const std::string& line, const std::function<std::string(double)>& spell) {
  const std::size_t colon = line.find(':');
  const std::size_t first = line.find_first_not_of(" \t", colon + 1);
  if (colon == std::string::npos || first == std::string::npos) return std::nullopt;
  const std::size_t end = std::min(line.find_first_of(" \t\r#", first), line.size());
  const std::optional<double> number = text::parse_real(line.substr(first, end - first));
  if (!number) return std::nullopt;
  return line.substr(0, first) + spell(*number) + line.substr(end);
}

std::string whole(double value) { return std::to_string(std::lround(value)); }

std::vector<TextDefect> text_defects() {
  return {
      {"a letter in a number",
       {},
       {"not-a-number", "matrix-type", "json-syntax", "wrong-syntax", "wrong-count", "missing-block", "yaml-syntax"},
       spelled("cx", [](const std::string& number) { return number + "O"; })},
      {"no focal length",
       {},
       {"not-positive", "not-a-camera", "out-of-range", "focal-length-not-in-pixels"},
       spelled("fx", [](const std::string&) { return std::string("0.0"); })},
      {"a focal length without its decimal point",
       {"kalibr", "orbslam3"},
       {"int-for-real"},
       [](const Good& good) -> std::optional<SpanEdit> {
         if (good.calibration.format->id == "orbslam3" && !is_read_by_orbslam3(good)) return std::nullopt;
         return spelled("fx", [](const std::string& number) { return whole(std::stod(number)); })(good);
       }},
      {"an exponent without its point",
       {"kalibr"},
       {"number-as-text"},
       spelled("fx", [](const std::string& number) { return whole(std::stod(number)) + "e0"; })},
      {"an image size with a decimal point",
       {"kalibr"},
       {"real-for-int", "not-an-integer"},
       line_starting("resolution: [",
                     [](const std::string& line) -> std::optional<std::string> {
                       std::string changed = line;
                       return changed.insert(changed.find(','), ".0");
                     })},
      {"a rate with a decimal point",
       {"orbslam3"},
       {"real-for-int", "not-an-integer"},
       line_starting(
           "Camera.fps:",
           [](const std::string& line) { return with_number(line, [](double value) { return whole(value) + ".0"; }); })},
      {"a rate in kilohertz",
       {"kalibr"},
       {"imu-rate"},
       line_starting("update_rate:",
                     [](const std::string& line) {
                       return with_number(line, [](double rate) { return text::format_real(rate / 1000.0); });
                     })},
      {"a camera model that nobody knows",
       {"kalibr"},
       {"unknown-model"},
       line_starting("camera_model:", [](const std::string&) { return "  camera_model: pinhol"; })},
      {"a TAB as indentation",
       {"kalibr", "orbslam3"},
       {"yaml-tab", "yaml-syntax"},
       line_starting("distortion_model:", [](const std::string& line) { return "\t" + line.substr(line.find('d')); })},
      {"git's markers",
       {"kalibr", "orbslam3", "opencv"},
       {"merge-conflict"},
       [](const Good& good) -> std::optional<SpanEdit> {
         const std::optional<text::Span> span = number_of(good, "fx");
         if (!span || document_of(good).syntax() != text::Syntax::kYaml) return std::nullopt;
         const std::size_t line = document_of(good).source().line_at(span->offset).offset;
         return SpanEdit{{line, 0}, "<<<<<<< HEAD\n"};
       }},
      {"a key twice",
       {"kalibr"},
       {"duplicate-key"},
       line_starting("distortion_model:", [](const std::string& line) { return line + "\n  distortion_model: none"; }),
       false},
      {"OpenCV's header",
       {"kalibr"},
       {"opencv-header"},
       [](const Good& good) -> std::optional<SpanEdit> {
         if (bytes_of(good).starts_with("%") || bytes_of(good).starts_with("---")) return std::nullopt;
         return SpanEdit{{0, 0}, "%YAML:1.0\n"};
       }},
      {"a matrix of doubles",
       {"orbslam3"},
       {"matrix-not-float"},
       [](const Good& good) -> std::optional<SpanEdit> {
         if (!is_read_by_orbslam3(good)) return std::nullopt;
         return line_starting("dt: f", [](const std::string& line) { return line.substr(0, line.find('f')) + "d"; })(good);
       }},
      {"File.version as a number",
       {"orbslam3"},
       {"file-version-not-string"},
       line_starting("File.version:", [](const std::string&) { return "File.version: 1.0"; })},
      {"a depth threshold in metres",
       {"orbslam3"},
       {"depth-threshold"},
       line_starting("ThDepth:", [](const std::string& line) { return with_number(line, [](double) { return "0.1"; }); })},
      {"bf without the focal length",
       {"orbslam3"},
       {"bf-is-a-baseline", "baseline-contradicts"},
       line_starting("Camera.bf:",
                     [](const std::string& line) -> std::optional<std::string> {
                       return with_number(line, [](double bf) { return text::format_real(bf / 450.0); });
                     })},
      {"k1 not in pixels",
       {"woodscape"},
       {"not-in-pixels"},
       spelled("k1", [](const std::string& number) { return text::format_real(std::stod(number) / 1000.0); })},
      {"a quaternion's digit lost",
       {"woodscape"},
       {"not-a-rotation"},
       [](const Good& good) -> std::optional<SpanEdit> {
         const std::string& bytes = bytes_of(good);
         std::size_t at = bytes.find("\"quaternion\"");
         if (at == std::string::npos) return std::nullopt;
         at = bytes.find("0.", at);  // the first of four with something before its point
         return at == std::string::npos ? std::nullopt : std::optional(SpanEdit{{at + 2, 0}, "9"});
       },
       false},
      {"a1 that is not 0",
       {"ocamcalib"},
       {"a1-not-zero"},
       [](const Good& good) -> std::optional<SpanEdit> {
         // "5 a0 0 a2 a3 a4": the third number of the first line with numbers.
         const std::string& bytes = bytes_of(good);
         std::size_t line = 0;
         while (line < bytes.size() && !std::isdigit(static_cast<unsigned char>(bytes[line])))
           line = bytes.find('\n', line) + 1;
         const std::size_t a0 = bytes.find_first_not_of(' ', bytes.find(' ', line));
         const std::size_t a1 = bytes.find_first_not_of(' ', bytes.find(' ', a0));
         const std::size_t end = bytes.find(' ', a1);
         return SpanEdit{{a1, end - a1}, "0.25"};
       }},
      {"an inverse polynomial of another lens",
       {"ocamcalib"},
       {"stale-inverse"},
       [](const Good& good) -> std::optional<SpanEdit> {
         const std::string& bytes = bytes_of(good);
         std::size_t at = bytes.find("#inverse");
         if (at == std::string::npos) at = bytes.find("inverse");
         if (at == std::string::npos) return std::nullopt;
         const std::size_t count = bytes.find_first_of("0123456789", bytes.find('\n', at));
         const std::size_t first = bytes.find_first_not_of(' ', bytes.find(' ', count));
         const std::size_t end = bytes.find_first_of(" \n", first);
         const double value = std::stod(bytes.substr(first, end - first));
         return SpanEdit{{first, end - first}, text::format_real(value * 1.05)};
       },
       false},
      {"NaN",
       {},
       {"not-finite", "not-a-number", "matrix-type", "number-as-text", "json-syntax", "wrong-syntax", "wrong-count"},
       spelled("cy", [](const std::string&) { return std::string("nan"); })},
      {"a zero byte",
       {},
       {"binary-file"},
       [](const Good& good) {
         return SpanEdit{{bytes_of(good).size() / 2, 0}, std::string(1, '\0')};
       },
       false},
      {"the end cut off",
       {"woodscape"},
       {"json-syntax"},
       [](const Good& good) {
         const std::size_t half = bytes_of(good).size() / 2;
         return SpanEdit{{half, bytes_of(good).size() - half}, ""};
       },
       false},
  };
}

/// The file with the defect, where it is one and the file is without fault before.
std::optional<std::string> planted(const Good& good, const TextDefect& defect) {
  const auto& formats = defect.formats;
  if (!formats.empty() && std::ranges::find(formats, good.calibration.format->id) == formats.end()) return std::nullopt;
  if (good.report.has(Severity::kError)) return std::nullopt;
  const std::optional<SpanEdit> edit = defect.plant(good);
  if (!edit) return std::nullopt;
  std::string bytes = bytes_of(good);
  return bytes.replace(edit->span.offset, edit->span.length, edit->text);
}

/// Is it in the line of the first byte that differs?
bool is_in_its_line(const Good& good, const text::Source& damaged, const Finding& finding) {
  const auto first = std::ranges::mismatch(damaged.bytes, bytes_of(good)).in1 - damaged.bytes.begin();
  return damaged.position(finding.where.offset).line == damaged.position(static_cast<std::size_t>(first)).line;
}

TEST(SeededSpellings, AreFoundInTheirLine) {
  for (const TextDefect& defect : text_defects()) {
    const auto plant = [&defect](const Good& good) { return planted(good, defect); };
    expect_found(defect.name, tally_of(defect.codes, plant, &is_in_its_line), 1, defect.line_is_known ? 0.95 : 0.0);
  }
}

}  // namespace
}  // namespace fca::test
