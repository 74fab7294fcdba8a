// SPDX-License-Identifier: BSD-3-Clause
#include "seeded_edits.h"

#include <fca/formats/consumers/consumer.h>
#include <fca/formats/text/numbers.h>

#include <array>
#include <iterator>
#include <regex>
#include <sstream>

namespace fca::test {
namespace {

using text::Syntax;

// ---------------------------------------------------------------- OpenCV's matrices

/// The numbers of the first 3 x 3 matrix of the file, row by row; nothing where there is none.
std::optional<std::array<text::Span, 9>> camera_matrix(const Good& good) {
  const std::string& bytes = bytes_of(good);
  if (good.calibration.rig.cameras.empty()) return std::nullopt;  // a pose alone: its first matrix is R
  std::smatch head;
  if (!std::regex_search(bytes, head, std::regex("rows\\W+3\\W+cols\\W+3\\W+dt\\W+d\\W+data\\W*?(?=-?[0-9.])")))
    return std::nullopt;
  std::array<text::Span, 9> numbers;
  auto at = static_cast<std::size_t>(head.position() + head.length());
  for (text::Span& number : numbers) {
    at = bytes.find_first_of("-.0123456789", at);
    if (at == std::string::npos) return std::nullopt;
    const std::size_t end = bytes.find_first_not_of("+-.0123456789eE", at);
    number = {at, end - at};
    at = end;
  }
  return numbers;
}

/// One element of that matrix changed; only where it was `from`.
Edit element(std::size_t index, double from, const char* to) {
  return [=](const Good& good) -> std::optional<SpanEdit> {
    const auto numbers = camera_matrix(good);
    if (!numbers) return std::nullopt;
    const text::Span& span = (*numbers)[index];
    if (std::stod(std::string(document_of(good).source().text(span))) != from) return std::nullopt;
    return SpanEdit{span, to};
  };
}

/// Rows and columns of that matrix exchanged.
std::optional<SpanEdit> transposed(const Good& good) {
  const auto numbers = camera_matrix(good);
  if (!numbers) return std::nullopt;
  const text::Source& source = document_of(good).source();
  const std::size_t begin = numbers->front().offset;
  std::string text;
  for (std::size_t i = 0; i < 9; ++i) {
    const text::Span& here = (*numbers)[i];
    const text::Span& other = (*numbers)[3 * (i % 3) + i / 3];
    text += source.text(other);
    if (i + 1 < 9) text += source.text({here.end(), (*numbers)[i + 1].offset - here.end()});
  }
  return SpanEdit{{begin, numbers->back().end() - begin}, text};
}

/// The first matrix of one row or column with five numbers, with others.
Edit distortion(const char* size, const char* numbers) {
  return [=](const Good& good) -> std::optional<SpanEdit> {
    const std::string& bytes = bytes_of(good);
    std::smatch match;
    const std::regex head("^([ \t]*)rows: *(1|5) *\n *cols: *(1|5) *\n *dt: *d *\n *data: *\\[[^\\]]*\\]",
                          std::regex::multiline);
    if (!std::regex_search(bytes, match, head) || match[2] == match[3]) return std::nullopt;
    const std::string indent = match[1];
    return SpanEdit{
        {static_cast<std::size_t>(match.position()), static_cast<std::size_t>(match.length())},
        indent + "rows: 1\n" + indent + "cols: " + size + "\n" + indent + "dt: d\n" + indent + "data: [ " + numbers + " ]"};
  };
}

std::vector<TextDefect> matrix_defects() {
  return {
      {"a skew", {"opencv"}, {"skew"}, element(1, 0.0, "2.5")},
      {"K(2, 2) = 0", {"opencv"}, {"matrix-corner"}, element(8, 1.0, "0.0")},
      {"a number below K's diagonal", {"opencv"}, {"not-a-camera-matrix"}, element(3, 0.0, "3.5")},
      {"K with its rows as columns", {"opencv"}, {"matrix-transposed"}, transposed, 20, false},
      {"four coefficients of no stated lens",
       {"opencv"},
       {"ambiguous-model"},
       [](const Good& good) -> std::optional<SpanEdit> {
         for (const char* decides : {"distortion_type", "flags"}) {
           if (bytes_of(good).find(decides) != std::string::npos) return std::nullopt;
         }
         return distortion("4", "0.06, -0.12, 0.001, 0.002")(good);
       },
       10,
       false},
      {"six coefficients", {"opencv"}, {"wrong-length"}, distortion("6", "0.06, -0.12, 0.001, 0.002, 0., 0.1"), 10, false},
      {"no distortion coefficients",
       {"opencv"},
       {"distortion-missing"},
       where(Syntax::kOpenCvYaml, replaced("^(distortion_coefficients|D1|distCoeffs|dist_coeffs)(?= *:)", "lens")),
       10,
       false},
      {"a matrix of bytes",
       {"opencv"},
       {"matrix-type"},
       of_cameras(replaced("^((camera_matrix|M1|K1): *!!.*\n *rows.*\n *cols.*\n *dt: *)d *$", "$1u"))},
      {"a number for a pose",
       {"orbslam3"},
       {"not-a-matrix"},
       replaced("^(IMU\\.T_b_c1|Stereo\\.T_c1_c2|Tbc|T_c1_c2): *!!opencv-matrix *\n *rows.*\n *cols.*\n *dt.*\n *data: "
                "*\\[[^\\]]*\\]",
                "$1: 1.0")},
  };
}

std::string with(const std::string& bytes, const SpanEdit& edit) {
  return std::string(bytes).replace(edit.span.offset, edit.span.length, edit.text);
}

/// A camchain as OpenVINS reads it, but for the quotes around a lens's name with a comment after.
std::optional<std::string> unquoted_for_openvins(const Good& good) {
  if (good.calibration.format->id != "kalibr" || good.calibration.rig.cameras.empty()) return std::nullopt;
  CheckOptions options;
  options.program = consumers::find_consumer("openvins");
  const std::optional<text::Source> fixed = fca::fixed_source(document_of(good).source(), options);
  const std::string bytes = fixed ? fixed->bytes : bytes_of(good);
  if (checked({good.name, bytes}, options).has(Severity::kError)) return std::nullopt;
  const std::regex quoted("(distortion_model: *)\"?(\\w+)\"?.*$", std::regex::multiline);
  std::string without = std::regex_replace(bytes, quoted, "$1$2  # the lens", std::regex_constants::format_first_only);
  return without == bytes ? std::nullopt : std::optional(std::move(without));
}

/// A camera matrix and distortion under MATLAB's names, the matrix as MATLAB has it.
std::optional<std::string> as_of_matlab(const Good& good) {
  if (good.calibration.format->id != "opencv" || good.report.has(Severity::kError)) return std::nullopt;
  const std::optional<SpanEdit> lens = distortion("2", "0.06, -0.12")(good);
  const std::optional<SpanEdit> matrix = transposed(good);
  if (!lens || !matrix || lens->span.offset < matrix->span.end()) return std::nullopt;
  const std::string bytes = with(with(bytes_of(good), *lens), *matrix);
  if (!std::regex_search(bytes, std::regex("^camera_matrix *:", std::regex::multiline))) return std::nullopt;
  const std::regex keys("^camera_matrix(?= *:)([^]*)^distortion_coefficients(?= *:)", std::regex::multiline);
  return std::regex_replace(bytes, keys, "IntrinsicMatrix$1RadialDistortion", std::regex_constants::format_first_only);
}

// ---------------------------------------------------------------- YAML and XML

std::string nested(int levels) {
  return "nested: " + std::string(static_cast<std::size_t>(levels), '[') + std::string(static_cast<std::size_t>(levels), ']') +
         "\n";
}

const std::string& deep() {
  static const std::string kText = nested(80);
  return kText;
}

const std::string& large() {
  static const std::string kText(std::size_t{3} << 20, '\n');
  return kText;
}

const std::string& long_list() {
  static const std::string kText = [] {
    std::string text = "corners: [0";
    for (int i = 0; i < 100'000; ++i) text += ",1";
    return text + "]\n";
  }();
  return kText;
}

const std::string& hundred_cameras() {
  static const std::string kText = [] {
    std::string text;
    for (int i = 20; i < 120; ++i) {
      text += "cam" + std::to_string(i) +
              ": {camera_model: pinhole, intrinsics: [458.5, 457.5, 367.0, 248.5], distortion_model: radtan, "
              "distortion_coeffs: [-0.28, 0.07, 0.0, 0.0], resolution: [752, 480], rostopic: /c}\n";
    }
    return text;
  }();
  return kText;
}

std::optional<SpanEdit> among_ros_parameters(const Good& good) {
  std::string text = "/**:\n  ros__parameters:\n";
  std::istringstream lines(bytes_of(good));
  for (std::string line; std::getline(lines, line);) text += "    " + line + "\n";
  return SpanEdit{{0, bytes_of(good).size()}, text};
}

constexpr const char* kSettings =
    "Camera.type: \"PinHole\"\nCamera.fx: 458.654\nCamera.fy: 457.296\nCamera.cx: 367.215\nCamera.cy: 248.375\n"
    "Camera.k1: -0.28\nCamera.k2: 0.07\nCamera.p1: 0.0002\nCamera.p2: 1.8e-05\nCamera.width: 752\nCamera.height: "
    "480\nCamera.fps: 20.0\n";

std::vector<TextDefect> syntax_defects() {
  return {
      {"nothing at all",
       {},
       {"empty-file"},
       [](const Good& good) {
         return SpanEdit{{0, bytes_of(good).size()}, ""};
       },
       20,
       false},
      {"three megabytes more", {}, {"too-large"}, appended(large()), 20, false},
      {"eighty lists in each other", {"kalibr", "orbslam3"}, {"too-deep"}, appended(deep())},
      {"a list without end", {"kalibr"}, {"too-long"}, appended(long_list()), 20, false},
      {"a hundred cameras more", {"kalibr"}, {"too-many-cameras"}, of_cameras(appended(hundred_cameras())), 20, false},
      {"an anchor", {"orbslam3"}, {"yaml-anchor"}, replaced("Camera.fps: *", "Camera.fps: &rate ")},
      {"a ROS 2 node's parameters", {"kalibr"}, {"ros-parameters"}, among_ros_parameters, 20, false},
      {"no blank behind a colon",
       {"kalibr"},
       {"blank-missing"},
       replaced("^( +(camera_model|intrinsics|accelerometer_noise_density|resolution)): +", "$1:")},
      {"an alias", {"kalibr"}, {"yaml-alias"}, replaced("distortion_model: .*", "distortion_model: *other")},
      {"a second document", {"kalibr"}, {"yaml-documents"}, appended("---\nmore: 1\n")},
      {"a list as a key", {"kalibr"}, {"yaml-key"}, appended("? [1, 2]\n: 3\n")},
      {"a bracket that stays open", {"kalibr"}, {"yaml-syntax"}, replaced("(resolution: \\[[^\\]\n]*)\\]", "$1"), 20, false},
      {"other settings below", {"kalibr"}, {"ambiguous-format"}, of_cameras(appended(kSettings)), 20, false},
      {"cameras under names nobody reads",
       {"kalibr"},
       {"unknown-format", "program-refuses"},
       replaced("^cam0:", "lens0:"),
       10,
       false},
      {"a document type",
       {"opencv"},
       {"xml-declaration"},
       where(Syntax::kXml, replaced("^<opencv_storage>", "<!DOCTYPE x>\n<opencv_storage>")),
       4},
      {"text between elements",
       {"opencv"},
       {"xml-mixed"},
       where(Syntax::kXml, replaced("^<opencv_storage>", "<opencv_storage>words")),
       4,
       false},
      {"another root element",
       {"opencv"},
       {"xml-root"},
       where(Syntax::kXml,
             [](const Good& good) -> std::optional<SpanEdit> {
               const std::string& bytes = bytes_of(good);
               const std::size_t begin = bytes.find("<opencv_storage>");
               const std::size_t end = bytes.find("</opencv_storage>");
               if (begin == std::string::npos || end == std::string::npos) return std::nullopt;
               return SpanEdit{{begin, end + 17 - begin},
                               "<storage>" + bytes.substr(begin + 16, end - begin - 16) + "</storage>"};
             }),
       4},
      {"an element that stays open", {"opencv"}, {"xml-syntax"}, where(Syntax::kXml, replaced("</rows>", "")), 4, false},
  };
}

// ---------------------------------------------------------------- keys and lists

std::vector<TextDefect> key_defects() {
  return {
      {"no topic", {"kalibr"}, {"program-misreads"}, of_cameras(without_line("rostopic:")), 20, false},
      {"a topic's key misspelt", {"kalibr"}, {"key-misspelt"}, replaced("rostopic:", "rostopik:")},
      {"a name with an escape sequence",
       {"kalibr"},
       {"name-unprintable"},
       replaced("rostopic: *\\S+", R"(rostopic: "/cam\e[31m")")},
      {"no intrinsics", {"kalibr"}, {"missing-key"}, without_line("intrinsics: ["), 20, false},
      {"an intrinsic lost", {"kalibr"}, {"wrong-length"}, replaced("intrinsics: \\[[^,\\]]*, *", "intrinsics: [")},
      {"a number for a list", {"woodscape"}, {"not-a-list"}, replaced("(\"quaternion\": *)\\[[^\\]]*\\]", "$1 0.5"), 5},
      {"a list for a name", {"kalibr"}, {"not-a-string"}, replaced("camera_model: *(\\w+)", "camera_model: [$1]")},
      {"a camera without keys", {"kalibr"}, {"not-a-mapping"}, appended("cam7: 5\n")},
      {"an image without columns", {"kalibr"}, {"image-size-invalid"}, replaced("resolution: \\[ *[0-9]+", "resolution: [0")},
      {"a size with a leading zero",
       {"kalibr"},
       {"octal"},
       replaced("resolution: \\[ *([1-7][0-7]+),", "resolution: [0$1,"),
       10},
      {"a pose's last row",
       {"kalibr"},
       {"not-a-transform"},
       replaced("- \\[0\\.0, 0\\.0, 0\\.0, 1\\.0\\]", "- [0.0, 0.0, 1.0, 1.0]")},
      {"a camera light years away",
       {"kalibr"},
       {"out-of-range"},
       replaced("(T_c\\w+: *\\n *- \\[.*, )[-+.0-9e]+\\]", "$01 1.0e+17]")},
      {"V1.0 without its version", {"orbslam3"}, {"file-version-missing"}, without_line("File.version:"), 20, false},
      {"an IMU without its rate",
       {"orbslam3"},
       {"mode-refused", "missing-key", "program-refuses"},
       without_line("IMU.Frequency:"),
       10,
       false},
      {"another word for the lens",
       {"nerfstudio"},
       {"model-contradicts"},
       replaced("(\"camera_model\": *\"OPENCV\")", "$1, \"is_fisheye\": true"),
       1},
      {"a fifth coefficient", {"woodscape"}, {"program-ignores"}, replaced("(\"k4\": *[-+.0-9eE]+)", "$1, \"k5\": 1.5"), 4},
      {"CARLA's translation",
       {"woodscape"},
       {"carla-translation"},
       replaced("\"translation\"", "\"translation used in CARLA (CARLA reference)\""),
       4},
      {"a byte order mark", {"opencv", "orbslam3", "woodscape"}, {"byte-order-mark"}, of_cameras([](const Good&) {
         return SpanEdit{{0, 0}, "\xEF\xBB\xBF"};
       })},
      {"OpenCV's header gone", {"opencv"}, {"yaml-layout", "program-refuses"}, replaced("^%YAML.*\n(---.*\n)?", ""), 10, false},
      {"a pose without its translation",
       {"opencv"},
       {"pose-missing"},
       of_cameras(replaced("^T(?= *: *!!)", "moved")),
       3,
       false},
      {"a camera matrix under a name nobody reads",
       {"opencv"},
       {"program-finds-no-camera"},
       replaced("^camera_matrix(?= *: *!!)", "Intrinsics"),
       6,
       false},
      {"a centre below 1",
       {"dso"},
       {"relative-by-centre"},
       replaced("^(\\w+ +[-.0-9]+ +[-.0-9]+) +[0-9]{2,}[.0-9]* +[0-9]{2,}[.0-9]*", "$1 0.5 0.5"),
       4},
      {"a layout that OpenCV does not read", {"kalibr"}, {"yaml-layout"}, appended("\n"), 20, false, "openvins"},
  };
}

// ---------------------------------------------------------------- OCamCalib's lines

/// Block 0 is the direct polynomial ("5 a0 0 a2 a3 a4"), 1 the inverse one.
enum class Block { kDirect, kInverse };

/// The numbers of a block changed as words; `change` says whether it could.
Edit numbers_of(Block block, std::function<bool(std::vector<std::string>&)> change) {
  return [block, change = std::move(change)](const Good& good) -> std::optional<SpanEdit> {
    const std::string& bytes = bytes_of(good);
    int index = static_cast<int>(block);
    for (std::size_t at = 0; at < bytes.size(); at = std::min(bytes.find('\n', at), bytes.size() - 1) + 1) {
      const text::Span line = document_of(good).source().line_at(at);
      const std::string text(document_of(good).source().text(line));
      if (text.find_first_not_of(" \t\r") == std::string::npos || text.front() == '#') continue;
      if (index-- > 0) continue;
      std::istringstream stream(text);
      std::vector<std::string> words(std::istream_iterator<std::string>(stream), {});
      if (words.size() < 4 || !change(words)) return std::nullopt;
      std::string changed = words.front();
      for (std::size_t i = 1; i < words.size(); ++i) changed += " " + words[i];
      return SpanEdit{line, changed};
    }
    return std::nullopt;
  };
}

std::vector<TextDefect> line_defects() {
  return {
      {"a comment line too many", {"ocamcalib"}, {"comment-lines"}, replaced("^#.*\n", "#\n$&"), 20, false},
      {"no comment line", {"ocamcalib"}, {"comment-missing"}, replaced("^#.*\n(\\s*\n)*", ""), 20, false},
      {"a comment line of two thousand characters",
       {"ocamcalib"},
       {"comment-too-long"},
       [](const Good& good) -> std::optional<SpanEdit> {
         const std::size_t at = bytes_of(good).find('#');
         if (at == std::string::npos) return std::nullopt;
         return SpanEdit{{at + 1, 0}, std::string(2000, 'x')};
       }},
      {"a1 that is not 0",
       {"ocamcalib"},
       {"a1-not-zero"},
       numbers_of(Block::kDirect,
                  [](std::vector<std::string>& words) {
                    words[2] = "0.25";
                    return true;
                  })},
      {"a polynomial of degree eleven",
       {"ocamcalib"},
       {"degree-too-high"},
       numbers_of(Block::kDirect,
                  [](std::vector<std::string>& words) {
                    words.front() = "12";
                    words.resize(13, "1e-30");
                    return true;
                  })},
      {"a0 with the other sign",
       {"ocamcalib"},
       {"polynomial-sign"},
       numbers_of(Block::kDirect,
                  [](std::vector<std::string>& words) {
                    if (!words[1].starts_with('-')) return false;
                    words[1].erase(0, 1);
                    return true;
                  })},
      {"an inverse polynomial of another lens",
       {"ocamcalib"},
       {"stale-inverse"},
       numbers_of(Block::kInverse,
                  [](std::vector<std::string>& words) {
                    words[1] = text::format_real(1.05 * std::stod(words[1]));
                    return true;
                  })},
      {"no inverse polynomial",
       {"ocamcalib"},
       {"inverse-missing"},
       numbers_of(Block::kInverse,
                  [](std::vector<std::string>& words) {
                    words = {"0"};
                    return true;
                  }),
       20,
       false},
  };
}

}  // namespace

std::vector<SeededDefect> seeded_structure() {
  std::vector<SeededDefect> result;
  for (const std::vector<TextDefect>& list : {matrix_defects(), syntax_defects(), key_defects(), line_defects()}) {
    for (const TextDefect& defect : list) result.push_back(seeded(defect));
  }
  result.push_back({"MATLAB's camera matrix", {"matlab-origin"}, as_of_matlab, {}, 5});
  result.push_back({"a name without quotes, and a comment", {"unquoted-text"}, unquoted_for_openvins, {}, 5, "openvins"});
  return result;
}

}  // namespace fca::test
