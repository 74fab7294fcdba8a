// SPDX-License-Identifier: BSD-3-Clause
#include "camera_txt.h"

#include "../fields.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fca::dso {

using text::Node;

namespace {

/// A lens of DSO's.
struct Lens {
  std::string_view name;
  std::string_view model;
  std::span<const ParameterId> coefficients;  ///< Our parameters, after fx fy cx cy.
  std::size_t numbers;                        ///< That DSO demands.
};

constexpr std::array<ParameterId, 4> kKannalaBrandt = {"k1", "k2", "k3", "k4"};
constexpr std::array<ParameterId, 4> kRadTan = {"k1", "k2", "p1", "p2"};
constexpr std::array<ParameterId, 1> kOmega = {"w"};
constexpr std::array kLenses = {Lens{"EquiDistant", "kb4", kKannalaBrandt, 8},
                                Lens{"KannalaBrandt", "kb4", kKannalaBrandt, 8},
                                Lens{"RadTan", "radtan", kRadTan, 8},
                                Lens{"FOV", "fov", kOmega, 5},
                                Lens{"ATAN", "fov", kOmega, 5},  // PTAM's name for it; DSO knows only the first
                                Lens{"Pinhole", "pinhole", {}, 5}};

/// The lens under whose name DSO reads a model: the first.
const Lens* lens_of(std::string_view model) {
  const auto found = std::ranges::find(kLenses, model, &Lens::model);
  return found == kLenses.end() ? nullptr : &*found;
}

const Lens& lens_named(std::string_view name) { return *std::ranges::find(kLenses, name, &Lens::name); }

bool is_number(const Node& word) { return text::parse_real(word.value).has_value(); }
bool is_whole(const Node& word) { return text::parse_int(word.value).has_value(); }

/// The line as it stands, to the line break: DSO compares all of it.
std::string_view whole_line(const text::Document& document, const Node& line) {
  const std::string_view bytes = document.source().bytes;
  const std::size_t start = document.source().line_at(line.span.offset).offset;
  return bytes.substr(start, std::min(bytes.find('\n', start), bytes.size()) - start);
}

/// Line 1: the lens and its numbers.
struct FirstLine {
  const Lens* lens = nullptr;
  bool named = false;
  std::vector<const Node*> numbers;
};

/// As DSO's getUndistorterForFile chooses. No lens: none fits.
FirstLine first_line(const Node& line) {
  FirstLine result;
  if (line.items.empty()) return result;
  result.named = !is_number(line.items.front());
  for (const Node& word : std::span(line.items).subspan(result.named ? 1 : 0)) {
    if (!is_number(word)) break;
    result.numbers.push_back(&word);
  }
  const std::size_t count = result.numbers.size();
  if (result.named) {
    const auto found = std::ranges::find(kLenses, line.items.front().value, &Lens::name);
    if (found != kLenses.end()) result.lens = &*found;
  } else if (count >= 8) {
    result.lens = &lens_named("RadTan");
  } else if (count >= 5) {
    result.lens = &lens_named("FOV");
  }
  // A lens of angle 0 bends nothing.
  if (result.lens != nullptr && result.lens->model == "fov" && count >= 5 && text::parse_real(result.numbers[4]->value) == 0.0)
    result.lens = &lens_named("Pinhole");
  return result;
}

/// DSO knows the relative form by the centre alone.
bool is_relative(const std::array<double, 4>& numbers) { return numbers[2] < 1.0 && numbers[3] < 1.0; }

/// The factor and the shift from a relative number to pixels.
double to_pixels(double relative, std::size_t index, const ImageSize& size) {
  const double side = index % 2 == 0 ? size.width : size.height;
  return index < 2 ? relative * side : relative * side - 0.5;
}

/// The number that reads back as exactly `value` where there is one, else the nearest.
double to_relative(double value, std::size_t index, const ImageSize& size) {
  const double side = index % 2 == 0 ? size.width : size.height;
  const double relative = (index < 2 ? value : value + 0.5) / side;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double below = relative;
  double above = relative;
  constexpr int kNeighbours = 3;
  for (int i = 0; i < kNeighbours; ++i) {
    if (to_pixels(below, index, size) == value) return below;
    if (to_pixels(above, index, size) == value) return above;
    below = std::nextafter(below, -kInfinity);
    above = std::nextafter(above, kInfinity);
  }
  return relative;
}

/// A word that has the value already is not touched: scanf takes "0" and "0.0" alike.
void set_real(text::Document& document, const Node& word, double value) {
  if (text::parse_real(word.value) != value) document.replace(word.span, text::format_real(value));
}

constexpr std::array<ParameterId, 4> kFocalAndCentre = {"fx", "fy", "cx", "cy"};

double value_of(const Camera& camera, ParameterId id) { return parameter(camera.model, id).value(); }

/// Line 1 with the lens's name; `numbers`: fx fy cx cy as they are to stand there.
std::string spelled(const Lens& lens, const Camera& camera, const std::array<double, 4>& numbers) {
  std::string line(lens.name);
  for (const double number : numbers) line += " " + text::format_real(number);
  for (const ParameterId id : lens.coefficients) line += " " + text::format_real(value_of(camera, id));
  for (std::size_t i = numbers.size() + lens.coefficients.size(); i < lens.numbers; ++i) line += " 0";
  return line;
}

class CameraTxtReader {
 public:
  CameraTxtReader(const text::Document& document, Diagnostics& diagnostics)
      : reader_(document, text::Dialect::kPyYaml, diagnostics), lines_(document.root().items) {}

  std::optional<Rig> run() {
    const FirstLine first = lines_.empty() ? FirstLine() : first_line(lines_.front());
    if (first.lens == nullptr || first.numbers.size() < first.lens->numbers) {
      refuse_first_line(first);
      return std::nullopt;
    }
    if (first.lens->name == "ATAN") reader_.say(lines_.front().items.front(), Code::kCameraTxtAtan);
    const std::optional<ImageSize> size = read_size();
    if (!size) return std::nullopt;
    Camera camera;
    camera.name = "cam0";
    camera.image_size = size;
    camera.model = *make_model(first.lens->model);
    if (!read_numbers(first, *size, camera)) return std::nullopt;
    Rig rig;
    read_output(camera, *size, rig);
    rig.cameras.push_back(std::move(camera));
    return rig;
  }

 private:
  void refuse_first_line(const FirstLine& first) {
    const Node& root = reader_.document().root();
    const Node& at = lines_.empty() || lines_.front().items.empty() ? root : lines_.front();
    SourceRange where = reader_.document().range(at);
    if (&at == &root) where.length = 0;
    const std::size_t read = (first.named ? 1 : 0) + first.numbers.size();
    if (first.lens != nullptr && read < at.items.size()) {
      reader_.say(at.items[read], Code::kCameraTxtNotANumber, {at.items[read].value.substr(0, 40)});
    } else if (first.lens != nullptr) {
      reader_.diagnostics().add(Code::kCameraTxtTooFewNumbers, {first.numbers.size(), first.lens->name, first.lens->numbers},
                                where);
    } else {
      reader_.diagnostics().add(Code::kCameraTxtNoLens, {}, where);
    }
  }

  std::optional<ImageSize> read_size() {
    if (lines_.size() < 2 || lines_[1].items.size() < 2 || !is_whole(lines_[1].items[0]) || !is_whole(lines_[1].items[1])) {
      const Node& at = lines_.size() < 2 || lines_[1].items.empty() ? lines_.front() : lines_[1];
      reader_.say(at, Code::kCameraTxtSize);
      return std::nullopt;
    }
    return reader_.image_size(lines_[1].items[0], lines_[1].items[1], "image ");
  }

  bool read_numbers(const FirstLine& first, const ImageSize& size, Camera& camera) {
    std::array<double, 4> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::optional<double> value = reader_.real(*first.numbers[i], kFocalAndCentre[i].name());
      if (!value) return false;
      numbers[i] = *value;
    }
    bool good = true;
    const bool relative = is_relative(numbers);
    constexpr double kLargestShare = 10.0;
    if (relative && (numbers[0] > kLargestShare || numbers[1] > kLargestShare)) {
      reader_.say(*first.numbers[2], Code::kCameraTxtSharesByCentre);
      return false;
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double value = relative ? to_pixels(numbers[i], i, size) : numbers[i];
      good = reader_.parameter(*first.numbers[i], "line 1", kFocalAndCentre[i], value, camera.model) && good;
    }
    for (std::size_t i = 0; i < first.lens->coefficients.size(); ++i) {
      good = reader_.parameter(*first.numbers[4 + i], "line 1", first.lens->coefficients[i], camera.model) && good;
    }
    if (first.lens->model == "pinhole" && text::parse_real(first.numbers[4]->value) != 0.0) {
      reader_.say(*first.numbers[4], Code::kCameraTxtFifthNumber);
    }
    return good;
  }

  /// The lines 3 and 4: what DSO turns the camera's images into.
  void read_output(const Camera& camera, const ImageSize& size, Rig& rig) {
    if (lines_.size() < 4 || lines_[2].items.empty() || lines_[3].items.size() < 2) {
      const Node& last = lines_[std::min<std::size_t>(lines_.size() - 1, 3)];
      reader_.say(last.items.empty() ? lines_[1] : last, Code::kCameraTxtNoOutput);
      return;
    }
    const Node& mode = lines_[2];
    const std::string_view line = whole_line(reader_.document(), mode);
    const bool numbers = mode.items.size() >= 5 && std::ranges::all_of(std::span(mode.items).first(5), is_number);
    if (line == "full") {
      reader_.say(mode, Code::kCameraTxtFull);
    } else if (!numbers && line != "crop" && line != "none") {
      reader_.say(mode, Code::kCameraTxtMode);
    }
    const Node& output = lines_[3];
    const bool same_size =
        output.items[0].value == std::to_string(size.width) && output.items[1].value == std::to_string(size.height);
    if (line == "none" && !same_size) reader_.say(output, Code::kCameraTxtSizesDiffer);
    if (line == "none" && model_info(camera.model).id != "pinhole") reader_.say(mode, Code::kCameraTxtNotRectified);
    std::string words;
    for (const Node& word : mode.items) words += word.value + " ";
    rig.extra_fields.push_back(
        {"cam0", "DSO's rectified image", words + output.items[0].value + " x " + output.items[1].value});
  }

  fields::Reader reader_;
  const std::vector<Node>& lines_;
};

}  // namespace

bool camera_txt_holds(std::string_view model) { return lens_of(model) != nullptr; }

ProbeResult probe_camera_txt(const text::Document& document) {
  if (document.syntax() != text::Syntax::kWords) return {};
  const std::vector<Node>& lines = document.root().items;
  if (lines.empty()) return {};
  const FirstLine first = first_line(lines.front());
  const bool sized = lines.size() > 1 && lines[1].items.size() == 2 && std::ranges::all_of(lines[1].items, is_whole);
  if (first.named && first.lens != nullptr && !first.numbers.empty())
    return {sized ? 95 : 60, Message{Code::kCameraTxtNamedLens, {lines.front().items.front().value}}};
  if (!sized || first.numbers.size() < 4) return {};
  const bool mode = lines.size() > 2 && !lines[2].items.empty() &&
                    (lines[2].items.size() == 5 || lines[2].items.front().value == "crop" ||
                     lines[2].items.front().value == "none" || lines[2].items.front().value == "full");
  if (mode) return {90, Message{Code::kCameraTxtWithMode}};
  if (first.named || first.lens != nullptr) return {50, Message{Code::kCameraTxtNumbers}};
  return {};
}

std::optional<Rig> read_camera_txt(const text::Document& document, Diagnostics& diagnostics) {
  return CameraTxtReader(document, diagnostics).run();
}

Message problem_with_camera_txt(const Rig& rig) {
  if (rig.cameras.size() != 1) return {Code::kCameraTxtManyCameras, {rig.cameras.size()}};
  const Camera& camera = rig.cameras.front();
  const std::string model(model_info(camera.model).id);
  if (lens_of(model) == nullptr) return {Code::kCameraTxtUnknownModel, {model}};
  if (model == "radtan" && value_of(camera, "k3") != 0.0) return {Code::kCameraTxtNoK3};
  if (!camera.image_size) return {Code::kCameraTxtSizeMissing};
  if (value_of(camera, "cx") < 1.0 && value_of(camera, "cy") < 1.0) return {Code::kCameraTxtCentreBelowOne};
  return {};
}

std::string fresh_camera_txt(const Camera& camera) {
  std::array<double, 4> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = value_of(camera, kFocalAndCentre[i]);
  const std::string size = std::to_string(camera.image_size->width) + " " + std::to_string(camera.image_size->height);
  return spelled(*lens_of(model_info(camera.model).id), camera, numbers) + "\n" + size + "\ncrop\n" + size + "\n";
}

std::optional<text::Document> edited_camera_txt(const text::Document& base, const Camera& camera) {
  text::Document document = base;
  const std::vector<Node>& lines = document.root().items;
  const FirstLine first = first_line(lines.front());
  const std::string_view model = model_info(camera.model).id;
  if (first.lens == nullptr || lens_of(model) == nullptr || !camera.image_size) return std::nullopt;
  const auto value = [&camera](ParameterId id) { return value_of(camera, id); };
  if (model == "radtan" && value("k3") != 0.0) return std::nullopt;
  std::array<double, 4> old{};
  for (std::size_t i = 0; i < old.size(); ++i) old[i] = text::parse_real(first.numbers[i]->value).value_or(0.0);
  const bool relative = is_relative(old);

  const ImageSize size = *camera.image_size;
  const std::optional<ImageSize> old_size = [&]() -> std::optional<ImageSize> {
    const std::optional<int> width = text::parse_int(lines[1].items[0].value);
    const std::optional<int> height = text::parse_int(lines[1].items[1].value);
    return width && height ? std::optional(ImageSize{*width, *height}) : std::nullopt;
  }();
  if (!old_size) return std::nullopt;
  std::array<double, 4> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double wanted = value(kFocalAndCentre[i]);
    const bool same = relative && size == *old_size && to_pixels(old[i], i, size) == wanted;
    numbers[i] = same ? old[i] : relative ? to_relative(wanted, i, size) : wanted;
  }
  if (is_relative(numbers) != relative) return std::nullopt;
  if (first.lens->model == model) {
    for (std::size_t i = 0; i < numbers.size(); ++i) set_real(document, *first.numbers[i], numbers[i]);
    for (std::size_t i = 0; i < first.lens->coefficients.size(); ++i)
      set_real(document, *first.numbers[4 + i], value(first.lens->coefficients[i]));
  } else {
    const std::vector<Node>& words = lines.front().items;
    const std::size_t start = words.front().span.offset;
    document.replace({start, words.back().span.end() - start}, spelled(*lens_of(model), camera, numbers));
  }
  // With "none" DSO demands that what goes in comes out.
  const bool passes_through =
      size != *old_size && lines.size() > 3 && lines[3].items.size() >= 2 && whole_line(document, lines[2]) == "none";
  std::vector<const Node*> sizes = {&lines[1]};
  if (passes_through) sizes.push_back(&lines[3]);
  for (const Node* line : sizes) {
    fields::set_scalar(document, line->items[0], std::to_string(size.width));
    fields::set_scalar(document, line->items[1], std::to_string(size.height));
  }
  return document;
}

}  // namespace fca::dso
