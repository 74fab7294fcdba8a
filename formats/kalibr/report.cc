// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include "layout.h"

#include "../fields.h"

#include <fca/code.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace fca::kalibr {

using text::Node;

namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kHead = "Calibration results";

/// Python's class of a camera, without "Rs" of a rolling shutter and "Masked", and the camchain's two names.
struct Geometry {
  std::string_view name;
  std::string_view camera_model;
  std::string_view distortion_model;
};
constexpr std::array kGeometries = {
    Geometry{"DistortedPinhole", "pinhole", "radtan"}, Geometry{"EquidistantDistortedPinhole", "pinhole", "equidistant"},
    Geometry{"FovDistortedPinhole", "pinhole", "fov"}, Geometry{"Pinhole", "pinhole", "none"},
    Geometry{"DistortedOmni", "omni", "radtan"},       Geometry{"Omni", "omni", "none"},
    Geometry{"ExtendedUnified", "eucm", "none"},       Geometry{"DoubleSphere", "ds", "none"},
};

const Layout* layout_of_class(std::string_view name) {
  for (const std::string_view suffix : {"CameraGeometry", "Rs"}) {
    if (name.ends_with(suffix)) name.remove_suffix(suffix.size());
  }
  if (name.starts_with("Masked")) name.remove_prefix(std::string_view("Masked").size());
  const auto* const geometry = std::ranges::find(kGeometries, name, &Geometry::name);
  if (geometry == kGeometries.end()) return nullptr;
  const auto layout = std::ranges::find_if(layouts(), [geometry](const Layout& each) {
    return each.camera_model == geometry->camera_model && each.distortion_model == geometry->distortion_model;
  });
  return layout == layouts().end() ? nullptr : &*layout;
}

/// "1" of "T_1_0:", and what follows.
std::optional<std::string> take_index(std::string_view& rest) {
  const std::size_t end = std::min(rest.find_first_not_of("0123456789"), rest.size());
  if (end == 0) return std::nullopt;
  std::string index(rest.substr(0, end));
  rest.remove_prefix(end);
  return index;
}

/// Thrown after an error was added: the reader stops.
struct Broken {};

class ReportReader {
 public:
  ReportReader(const text::Document& document, Diagnostics& diagnostics)
      : document_(document), bytes_(document.source().bytes), reader_(document, text::Dialect::kPyYaml, diagnostics) {}

  void read_into(Rig& rig) {
    try {
      at_ = document_.source().byte_order_mark();
      while (skip_blanks() && read_section(rig)) {
      }
      if (rig.uncertainties.empty()) throw broken(at_, Code::kReportNothing);
    } catch (const Broken&) {
    }
  }

 private:
  /// False at what is not read any more.
  bool read_section(Rig& rig) {
    const Node line = take_line();
    const std::string_view text = line.value;
    if (text == kHead || text == "Camera-system parameters:" || text.find_first_not_of("=-") == std::string_view::npos)
      return true;
    if (text == "Target configuration" || text.starts_with("Transformation (cam")) return false;
    if (text == "Normalized Residuals" || text == "Residuals") return true;
    if (text.starts_with("Reprojection error (")) return read_residuals(line, rig), true;
    if (text.starts_with("Gyroscope error (") || text.starts_with("Accelerometer error (")) return true;
    if (text.starts_with("baseline T_")) return read_baseline(line, rig), true;
    if (text.starts_with("cam")) return read_camera(line, rig), true;
    throw broken(line, Code::kReportLineUnknown, {"report", shown(line), "cam0 (topic): or baseline T_1_0:"});
  }

  void read_camera(const Node& line, Rig& rig) {
    std::string_view rest = std::string_view(line.value).substr(std::string_view("cam").size());
    const std::optional<std::string> index = take_index(rest);
    if (!index || !rest.starts_with(" (") || !rest.ends_with("):"))
      throw broken(line, Code::kReportLineUnknown, {"report", shown(line), "cam0 (topic):"});
    Uncertainty camera;
    camera.camera = "cam" + *index;
    camera.where = document_.range(line);
    if (std::ranges::find(rig.uncertainties, camera.camera, &Uncertainty::camera) != rig.uncertainties.end())
      throw broken(line, Code::kReportTwice, {camera.camera});
    const Layout& layout = read_type(camera.camera);
    camera.model = layout.model;
    const std::size_t parameters = find_model(layout.model)->parameters.size();
    camera.sigmas.assign(parameters, 0.0);
    camera.values.assign(parameters, std::numeric_limits<double>::quiet_NaN());
    read_slots("distortion", layout.coefficients, camera);
    read_slots("projection", layout.intrinsics, camera);
    if (const std::size_t before = at_; skip_blanks()) {
      const std::size_t begin = at_;
      const Node next = take_line();
      if (next.value.starts_with("reprojection error:")) {
        at_ = begin;
        const auto [mean, deviation] = read_pair(camera.camera, "reprojection error", 2, 2);
        camera.reprojection_rms_px = std::hypot(std::hypot(mean[0], mean[1]), std::hypot(deviation[0], deviation[1]));
      } else if (next.value != "failed printing the reprojection error!") {
        at_ = before;
      }
    }
    rig.uncertainties.push_back(std::move(camera));
  }

  const Layout& read_type(const std::string& owner) {
    const Node line = want_line(owner, "type");
    const std::size_t begin = line.value.rfind('.');
    const std::size_t end = line.value.find("'>");
    const bool is_class = begin != std::string::npos && end != std::string::npos && begin < end && line.value.ends_with("'>");
    const std::string name = is_class ? line.value.substr(begin + 1, end - begin - 1) : shown(line);
    const Layout* layout = is_class ? layout_of_class(name) : nullptr;
    if (layout == nullptr) throw broken(line, Code::kReportUnknownGeometry, {owner, name});
    return *layout;
  }

  void read_slots(std::string_view key, std::span<const Slot> slots, Uncertainty& camera) {
    const auto [values, sigmas] = read_pair(camera.camera, key, slots.size(), slots.size());
    const std::span<const Parameter> parameters = find_model(camera.model)->parameters;
    for (std::size_t i = 0; i < slots.size(); ++i) {
      if (!slots[i].parameter) continue;
      const auto place = std::ranges::find(parameters, slots[i].parameter->name(), &Parameter::name) - parameters.begin();
      camera.values[static_cast<std::size_t>(place)] = values[i];
      camera.sigmas[static_cast<std::size_t>(place)] = sigmas[i];
    }
  }

  void read_baseline(const Node& line, Rig& rig) {
    std::string_view rest = std::string_view(line.value).substr(std::string_view("baseline T_").size());
    const std::optional<std::string> a = take_index(rest);
    const bool is_between = rest.starts_with('_');
    if (is_between) rest.remove_prefix(1);
    const std::optional<std::string> b = take_index(rest);
    if (!a || !b || !is_between || rest != ":")
      throw broken(line, Code::kReportLineUnknown, {"report", shown(line), "baseline T_1_0:"});
    PoseUncertainty pose{"cam" + *a, "cam" + *b, {}, {}, document_.range(line)};
    const std::string owner = "baseline T_" + *a + "_" + *b;
    constexpr std::size_t kQuaternion = 4;
    const auto rotation = read_pair(owner, "q", kQuaternion, 3).second;
    const auto translation = read_pair(owner, "t", 3, 3).second;
    std::ranges::copy(rotation, pose.rotation_rad.begin());
    std::ranges::copy(translation, pose.translation_m.begin());
    rig.pose_uncertainties.push_back(std::move(pose));
  }

  /// "Reprojection error (cam0) [px]:     mean 0.2, median 0.18, std: 0.12"; the normalised ones have no unit.
  void read_residuals(const Node& line, Rig& rig) {
    const std::vector<Node> words = fields::words_in(line, " \t,:()");
    const auto value_behind = [&](std::string_view name) {
      const auto word = std::ranges::find(words, name, &Node::value);
      if (word == words.end() || word + 1 == words.end())
        throw broken(line, Code::kReportLineUnknown, {"report", shown(line), name});
      return number(*(word + 1), std::string(name));
    };
    constexpr std::size_t kCamera = 2;
    if (words.size() <= kCamera || !index_in(words[kCamera].value, "cam"))
      throw broken(line, Code::kReportLineUnknown, {"report", shown(line), "(cam0)"});
    if (line.value.ends_with("no corners")) return;
    const double mean = value_behind("mean");
    const double deviation = value_behind("std");
    if ((words.end() - 2)->value != "std")
      throw broken(words.back(), Code::kReportLineUnknown, {"report", words.back().value, "the end of the line"});
    static_cast<void>(value_behind("median"));
    if (deviation < 0.0) throw broken(line, Code::kReportSigmaNegative, {words[kCamera].value, deviation});
    Uncertainty camera;
    camera.camera = words[kCamera].value;
    camera.where = document_.range(line);
    camera.reprojection_rms_px = std::hypot(mean, deviation);
    if (line.value.find("[px]") != std::string::npos) rig.uncertainties.push_back(std::move(camera));
  }

  /// "key: [values] +- [sigmas]", over several lines where NumPy broke them.
  std::pair<std::vector<double>, std::vector<double>> read_pair(const std::string& owner, std::string_view key,
                                                                std::size_t values, std::size_t sigmas) {
    skip_blanks();
    const std::size_t begin = at_;
    static_cast<void>(want_line(owner, key));
    at_ = begin + key.size() + 1;
    const std::string what = owner + " " + std::string(key);
    std::pair<std::vector<double>, std::vector<double>> result;
    result.first = read_list(what, values);
    if (!skip_blanks() || bytes_.compare(at_, 2, "+-") != 0)
      throw broken(std::min(at_, bytes_.size() - 1), Code::kReportBracketMissing, {what, "+-"});
    at_ += 2;
    result.second = read_list(what, sigmas, 0.0);
    const std::size_t line_end = std::min(bytes_.find('\n', at_), bytes_.size());
    const std::size_t rest = bytes_.find_first_not_of(kBlanks, at_);
    if (rest < line_end) {
      at_ = rest;
      const Node more = take_line();
      throw broken(more, Code::kReportLineUnknown, {what, shown(more), "the end of the line"});
    }
    return result;
  }

  /// Numbers of which none is below `least`.
  std::vector<double> read_list(const std::string& what, std::size_t count,
                                double least = -std::numeric_limits<double>::infinity()) {
    if (!skip_blanks() || bytes_[at_] != '[')
      throw broken(std::min(at_, bytes_.size() - 1), Code::kReportBracketMissing, {what, "["});
    Node list;
    list.kind = text::NodeKind::kScalar;
    const std::size_t end = bytes_.find(']', at_);
    const bool runs_on =
        end == std::string::npos || bytes_.substr(at_ + 1, end - at_ - 1).find_first_of("[:") != std::string::npos;
    if (runs_on) throw broken(at_, Code::kReportBracketMissing, {what, "]"});
    list.span = {at_ + 1, end - at_ - 1};
    list.value = bytes_.substr(list.span.offset, list.span.length);
    const std::vector<Node> words = fields::words_in(list, " \t\r\n,");
    at_ = end + 1;
    if (words.size() != count) {
      list.span = {list.span.offset - 1, list.span.length + 2};
      throw broken(list, Code::kNumbersWanted, {what, words.size(), count});
    }
    std::vector<double> numbers;
    numbers.reserve(words.size());
    for (const Node& word : words) {
      numbers.push_back(number(word, what));
      if (numbers.back() < least) throw broken(word, Code::kReportSigmaNegative, {what, numbers.back()});
    }
    return numbers;
  }

  double number(const Node& word, const std::string& what) {
    const std::optional<double> value = reader_.real(word, what);
    if (!value) throw Broken{};
    return *value;
  }

  /// The next line, which begins with the key.
  Node want_line(const std::string& owner, std::string_view key) {
    const std::size_t end = bytes_.size();
    if (!skip_blanks()) throw broken(end - 1, Code::kReportBracketMissing, {owner, std::string(key) + ":"});
    Node line = take_line();
    if (!line.value.starts_with(std::string(key) + ":"))
      throw broken(line, Code::kReportLineUnknown, {owner, shown(line), std::string(key) + ":"});
    return line;
  }

  /// False at the end.
  bool skip_blanks() {
    at_ = std::min(bytes_.find_first_not_of(kBlanks, at_), bytes_.size());
    return at_ < bytes_.size();
  }

  /// From here to the end of the line, without blanks at its end.
  Node take_line() {
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    Node line;
    line.kind = text::NodeKind::kScalar;
    const std::size_t last = bytes_.find_last_not_of(kBlanks, end - 1);
    line.span = {at_, last - at_ + 1};
    line.value = bytes_.substr(at_, line.span.length);
    at_ = end;
    return line;
  }

  static std::string shown(const Node& line) {
    constexpr std::size_t kMost = 40;
    return line.value.substr(0, kMost);
  }

  Broken broken(const Node& node, Code code, std::vector<Argument> arguments = {}) {
    reader_.say(node, code, std::move(arguments));
    return {};
  }
  Broken broken(std::size_t offset, Code code, std::vector<Argument> arguments = {}) {
    reader_.diagnostics().add(code, std::move(arguments), document_.source().range({offset, 1}));
    return {};
  }

  const text::Document& document_;
  const std::string& bytes_;
  fields::Reader reader_;
  std::size_t at_ = 0;
};

}  // namespace

bool is_report(const text::Document& document) {
  if (document.syntax() != text::Syntax::kWords) return false;
  std::string_view bytes = document.source().bytes;
  bytes.remove_prefix(document.source().byte_order_mark());
  bytes.remove_prefix(std::min(bytes.find_first_not_of(kBlanks), bytes.size()));
  return bytes.starts_with(kHead);
}

void read_report(const text::Document& document, Rig& rig, Diagnostics& diagnostics) {
  Rig found;
  ReportReader(document, diagnostics).read_into(found);
  for (Uncertainty& each : found.uncertainties) {
    if (!each.sigmas.empty())
      rig.extra_fields.push_back({each.camera, "standard deviations of its parameters", document.source().name});
    rig.uncertainties.push_back(std::move(each));
  }
  for (PoseUncertainty& each : found.pose_uncertainties) {
    rig.extra_fields.push_back({each.a, "standard deviations of T_" + each.a + "_" + each.b, document.source().name});
    rig.pose_uncertainties.push_back(std::move(each));
  }
}

}  // namespace fca::kalibr
