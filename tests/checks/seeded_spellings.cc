// SPDX-License-Identifier: BSD-3-Clause
#include "seeded_edits.h"

#include <fca/formats/text/numbers.h>

#include <cmath>

namespace fca::test {
namespace {

std::string whole(double value) { return std::to_string(std::lround(value)); }

std::vector<TextDefect> defects() {
  return {
      {"a letter in a number",
       {},
       {"not-a-number", "json-syntax", "wrong-count", "missing-block"},
       spelled("cx", [](const std::string& number) { return number + "O"; })},
      {"no focal length", {}, {"not-a-camera"}, spelled("fx", [](const std::string&) { return std::string("0.0"); })},
      {"a focal length without its decimal point",
       {"kalibr", "orbslam3"},
       {"int-for-real"},
       [](const Good& good) -> std::optional<SpanEdit> {
         // ORB-SLAM2 takes it, and most settings of the older style are for that alone.
         if (good.calibration.format->id == "orbslam3" && bytes_of(good).find("File.version") == std::string::npos)
           return std::nullopt;
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
                     }),
       10},
      {"a camera model that nobody knows",
       {"kalibr"},
       {"unknown-model"},
       line_starting("camera_model:", [](const std::string&) { return "  camera_model: pinhol"; })},
      {"a model type in small letters",
       {"vins"},
       {"unknown-model"},
       line_starting("model_type:",
                     [](const std::string& line) -> std::optional<std::string> {
                       if (line.find("scaramuzza") != std::string::npos) return std::nullopt;  // read in any case
                       std::string small = line;
                       std::ranges::transform(small, small.begin(), [](char c) {
                         return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
                       });
                       return small;
                     }),
       10},
      {"another program's name for a parameter",
       {"vins"},
       {"missing-key"},
       line_starting("p2:", [](const std::string& line) { return with_replaced(line, "p2", "t2"); }),
       5,
       false},
      {"a configuration for three cameras", {"vins"}, {"out-of-range"}, replaced("num_of_cam: *[12]", "num_of_cam: 3"), 5},
      {"a distortion model that image_geometry does not know",
       {"ros"},
       {"unknown-model"},
       line_starting("distortion_model:", [](const std::string&) { return "distortion_model: fov"; }),
       5},
      {"no distortion model", {"ros"}, {"key-assumed"}, without_line("distortion_model:"), 5, false},
      {"an equidistant lens of zeros, which image_geometry takes for none",
       {"ros"},
       {"program-misreads"},
       replaced(R"((distortion_model: equidistant[\s\S]*?data:\s*\[)[^\]]*\])", "$1 0.0, 0.0, 0.0, 0.0]"),
       2,
       false},
      {"a projection matrix of zeros",
       {"ros"},
       {"program-refuses"},
       replaced(R"((projection_matrix:[\s\S]*?data:\s*\[)[^\]]*\])", "$1 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]"),
       5,
       false},
      {"a TAB as indentation",
       {"kalibr", "orbslam3"},
       {"yaml-tab"},
       line_starting("distortion_model:", [](const std::string& line) { return "\t" + line.substr(line.find('d')); })},
      {"git's markers",
       {"kalibr", "orbslam3", "opencv"},
       {"merge-conflict"},
       [](const Good& good) -> std::optional<SpanEdit> {
         const std::optional<text::Span> span = number_of(good, "fx");
         if (!span || document_of(good).syntax() == text::Syntax::kXml || document_of(good).syntax() == text::Syntax::kJson)
           return std::nullopt;
         const std::size_t line = document_of(good).source().line_at(span->offset).offset;
         return SpanEdit{{line, 0}, "<<<<<<< HEAD\n"};
       }},
      {"a key twice",
       {"kalibr"},
       {"duplicate-key"},
       line_starting("distortion_model:", [](const std::string& line) { return line + "\n  distortion_model: none"; }),
       20,
       false},
      {"OpenCV's header",
       {"kalibr"},
       {"opencv-header"},
       [](const Good& good) -> std::optional<SpanEdit> {
         if (bytes_of(good).starts_with("%") || bytes_of(good).starts_with("---")) return std::nullopt;
         // With a pose to the IMU it is OpenVINS' chain.
         if (bytes_of(good).find("T_cam_imu") != std::string::npos) return std::nullopt;
         return SpanEdit{{0, 0}, "%YAML:1.0\n"};
       },
       15},
      {"a matrix of doubles",
       {"orbslam3"},
       {"matrix-not-float"},
       [](const Good& good) -> std::optional<SpanEdit> {
         if (!is_read_by(good, "ORB-SLAM3 V1.0")) return std::nullopt;
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
      {"a negative depth threshold",
       {"orbslam3"},
       {"depth-threshold"},
       line_starting("Stereo.ThDepth:",
                     [](const std::string& line) { return with_number(line, [](double) { return "-40.0"; }); }),
       10},
      {"bf for the baseline",
       {"orbslam3"},
       {"baseline-is-bf"},
       [](const Good& good) -> std::optional<SpanEdit> {
         if (!good.calibration.rig.baseline_m) return std::nullopt;  // a pose stands next to it, and ORB-SLAM3 goes by that
         return line_starting("Stereo.b:", [](const std::string& line) {
           return with_number(line, [](double baseline) { return text::format_real(baseline * 450.0); });
         })(good);
       },
       10},
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
       spelled("k1", [](const std::string& number) { return text::format_real(std::stod(number) / 1000.0); }),
       5},
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
       5,
       false},
      {"a focal length of 1e300", {}, {"not-a-camera"}, spelled("fx", [](const std::string&) { return std::string("1e300"); })},
      {"an infinite focal length",
       {"kalibr"},
       {"not-finite"},
       spelled("fx", [](const std::string&) { return std::string(".inf"); })},
      {"half a column", {"kalibr"}, {"not-an-integer"}, replaced("resolution: \\[ *([0-9]+)", "resolution: [$1.5")},
      {"a rate of 0", {"kalibr"}, {"not-positive"}, replaced("update_rate: .*", "update_rate: 0.0"), 10},
      {"a number too many", {"ocamcalib"}, {"wrong-count"}, replaced("^([0-9]+ -[0-9][^\n]*)", "$1 1.5"), 20},
      {"the end cut off before the size",
       {"ocamcalib"},
       {"missing-block"},
       replaced("^[0-9]+ [0-9]+ *\\s*(?![^])", ""),
       20,
       false},
      {"NaN",
       {},
       {"not-finite", "not-a-number", "number-as-text", "json-syntax", "python-syntax", "wrong-count"},
       spelled("cy", [](const std::string&) { return std::string("nan"); })},
      {"a zero byte",
       {},
       {"binary-file"},
       [](const Good& good) {
         return SpanEdit{{bytes_of(good).size() / 2, 0}, std::string(1, '\0')};
       },
       20,
       false},
      {"UTF-16",
       {},
       {"utf-16"},
       [](const Good& good) {
         const std::string bytes = bytes_of(good);
         std::string wide = "\xFF\xFE";
         for (const char byte : bytes) wide += {byte, '\0'};
         return SpanEdit{{0, bytes.size()}, wide};
       },
       20,
       false},
      {"lines that end in CR",
       {"kalibr", "orbslam3", "opencv"},
       {"cr-line-ends"},
       [](const Good& good) -> std::optional<SpanEdit> {
         const text::Syntax syntax = document_of(good).syntax();
         if (syntax == text::Syntax::kXml || syntax == text::Syntax::kJson) return std::nullopt;
         std::string bytes = bytes_of(good);
         std::erase(bytes, '\r');
         std::ranges::replace(bytes, '\n', '\r');
         return SpanEdit{{0, bytes_of(good).size()}, bytes};
       },
       20,
       false},
      {"the end cut off",
       {"woodscape"},
       {"json-syntax"},
       [](const Good& good) {
         const std::size_t half = bytes_of(good).size() / 2;
         return SpanEdit{{half, bytes_of(good).size() - half}, ""};
       },
       5,
       false},
  };
}

}  // namespace

std::vector<SeededDefect> seeded_spellings() {
  std::vector<SeededDefect> result;
  for (const TextDefect& defect : defects()) result.push_back(seeded(defect));
  return result;
}

}  // namespace fca::test
