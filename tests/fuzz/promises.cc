// SPDX-License-Identifier: BSD-3-Clause
#include "promises.h"

#include <fca/formats/check.h>
#include <fca/formats/read_back.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>
#include <fca/formats/wording.h>

#include "text/binary.h"
#include "text/json.h"
#include "text/python.h"
#include "text/words.h"
#include "text/xml.h"
#include "text/yaml.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace fca::fuzz {

namespace {

/// Models are fitted with fewer samples than people get: the paths are the same.
constexpr int kSamples = 40;

class Checker {
 public:
  void expect(bool kept, const std::string& promise) {
    if (!kept) complaints_.push_back(promise);
  }
  /// Nothing without an error, and no error together with something.
  void expect_reason(bool result, const Diagnostics& diagnostics, const std::string& step) {
    expect(result || diagnostics.has_errors(), step + " is refused without an error");
    for (const Diagnostic& entry : diagnostics.entries())
      expect(!id_of(entry).empty() && !message_of(entry).empty(), step + ": a diagnostic without code or message");
  }
  [[nodiscard]] Complaints complaints() && { return std::move(complaints_); }

 private:
  Complaints complaints_;
};

// Recursive, but no deeper than text::kMaxDepth.
void expect_places(const text::Node& node, const text::Span& around, Checker& checker) {
  const bool inside = node.span.offset >= around.offset && node.span.end() <= around.end();
  checker.expect(inside, "a node at byte " + std::to_string(node.span.offset) + " lies outside what holds it");
  if (!inside) return;
  for (const text::Node& item : node.items) expect_places(item, node.span, checker);
  for (const text::Entry& entry : node.entries) {
    expect_places(entry.key, around, checker);
    expect_places(entry.value, around, checker);
  }
}

bool same_number(double a, double b) {
  constexpr double kDigitsOfFiles = 1e-9;  // relative: files have at least so many
  return a == b || std::abs(a - b) <= kDigitsOfFiles * std::max(std::abs(a), std::abs(b));
}

/// Equal numbers; else, of another parametrisation or model that says the same (radtan whose coefficients are 0), equal pixels.
bool same_lens(const CameraModel& a, const CameraModel& b) {
  const bool alike = a.index() == b.index() && std::ranges::equal(parameter_values(a), parameter_values(b), same_number);
  if (alike) return true;
  constexpr double kVisible = 1e-6;  // of the pixel's own size, or px
  for (const double angle : {0.1, 0.3, 0.6}) {
    for (const double azimuth : {0.0, 1.0, 2.5, 4.0}) {
      const Ray ray = {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
      const std::optional<Pixel> of_a = project(a, ray);
      const std::optional<Pixel> of_b = project(b, ray);
      if (!of_a || !of_b) continue;  // where the domain ends is a digit's affair
      for (std::size_t i = 0; i < of_a->size(); ++i) {
        const double scale = std::max({1.0, std::abs((*of_a)[i]), std::abs((*of_b)[i])});
        if (std::abs((*of_a)[i] - (*of_b)[i]) > kVisible * scale) return false;
      }
    }
  }
  return true;
}

std::string in_words(const CameraModel& model) {
  std::string text(model_info(model).id);
  for (const double value : parameter_values(model)) text += " " + text::format_short(value, 12);
  return text;
}

ConvertOptions options_for(const StoredModel& stored) {
  ConvertOptions options;
  options.model = stored.model;
  options.ranges.assign(stored.ranges.begin(), stored.ranges.end());
  options.bound = false;
  options.samples = kSamples;
  return options;
}

void expect_cameras(const Rig& rig, const std::vector<std::string>& names, const Rig& back, const std::string& step,
                    Checker& checker) {
  checker.expect(back.cameras.size() == names.size(), step + ": " + std::to_string(names.size()) + " cameras are written and " +
                                                          std::to_string(back.cameras.size()) + " are read");
  if (back.cameras.size() != names.size()) return;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Camera* meant = rig.find_camera(names[i]);
    checker.expect(meant != nullptr, step + ": a file holds a camera '" + names[i] + "' that nobody has");
    if (meant == nullptr) continue;
    const Camera& read = back.cameras[i];
    checker.expect(same_lens(meant->model, read.model), step + ": the lens of " + names[i] + " is " + in_words(meant->model) +
                                                            " and is read as " + in_words(read.model));
    checker.expect(!read.image_size || !meant->image_size || read.image_size == meant->image_size,
                   step + ": " + names[i] + " has another image size");
  }
}

void expect_written(const Format& format, const Rig& rig, const std::string& step, Checker& checker) {
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(format, nullptr, rig, {}, diagnostics);
  checker.expect_reason(written.has_value(), diagnostics, step);
  if (!written) return;
  checker.expect(!written->files.empty(), step + " gives no file");
  for (const Written::File& file : written->files) {
    const std::string& name = file.document.source().name;
    checker.expect(name.find('/') == std::string::npos && name.find('\0') == std::string::npos && !name.starts_with('.'),
                   step + " names a file that leads elsewhere");
    Diagnostics as_text;
    const std::optional<text::Document> parsed = text::parse_document({name, file.document.bytes()}, as_text);
    checker.expect(parsed.has_value(), step + ": what is written is no document: " +
                                           (as_text.entries().empty() ? "" : message_of(as_text.entries().front())));
    if (!parsed || file.cameras.empty()) continue;
    ReadOptions options;
    options.opencv_model = written->opencv_model;
    const std::optional<Rig> back = read_back(format, file, options);
    checker.expect(back.has_value(), step + ": what is written is not read:\n" + file.document.bytes());
    if (back) expect_cameras(rig, file.cameras, *back, step, checker);
  }
}

const Format& other_format(const Format& own, std::string_view bytes) {
  const std::span<const Format> formats = written_formats();
  const std::size_t at = std::hash<std::string_view>()(bytes) % formats.size();
  return formats[at].id == own.id ? formats[(at + 1) % formats.size()] : formats[at];
}

void expect_rewritten(const Format& format, const text::Document& document, const Rig& rig, Checker& checker) {
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(format, &document, rig, {}, diagnostics);
  checker.expect_reason(written.has_value(), diagnostics, "the edit that changes nothing");
  if (!written) return;
  // A polynomial that no longer fits the other one is fitted again, and said.
  if (!written->defaults.empty() || !written->losses.empty()) return;
  const std::string bytes = written->files.empty() ? "" : written->files.front().document.bytes();
  const auto differ = std::ranges::mismatch(bytes, document.source().bytes);
  const std::string from(differ.in1, bytes.end());
  checker.expect(bytes == document.source().bytes, "an edit that changes nothing writes '" + from.substr(0, 60) + "' at byte " +
                                                       std::to_string(differ.in1 - bytes.begin()));
}

void expect_checked(const Format* format, const text::Source& source, Checker& checker) {
  CheckOptions options;
  options.from = format;
  const CheckReport report = check_file(source, options);
  for (const Finding& finding : report.findings) {
    checker.expect(find_check_code(id_of(finding)) != nullptr, "the finding " + id_of(finding) + " has no story");
    checker.expect(finding.where.offset + finding.where.length <= source.bytes.size(),
                   "the finding " + id_of(finding) + " lies outside the file");
  }
  const std::optional<text::Source> fixed = fixed_source(source, options);
  checker.expect(!fixed || fixed->bytes != source.bytes, "a fix that changes nothing");
}

/// A conversion needs the size of the image; as --size says it of files that do not.
Rig sized(Rig rig) {
  for (Camera& camera : rig.cameras) camera.image_size = camera.image_size.value_or(ImageSize{640, 480});
  return rig;
}

}  // namespace

Complaints parse_promises(text::Syntax syntax, std::string_view bytes) {
  const text::Source source = {"fuzz", std::string(bytes)};
  Checker checker;
  Diagnostics diagnostics;
  std::optional<text::Node> root;
  switch (syntax) {
    case text::Syntax::kYaml:
    case text::Syntax::kOpenCvYaml:
      root = text::parse_yaml(source, syntax, diagnostics);
      break;
    case text::Syntax::kXml:
      root = text::parse_xml(source, diagnostics);
      break;
    case text::Syntax::kJson:
      root = text::parse_json(source, diagnostics);
      break;
    case text::Syntax::kPython:
      root = text::parse_python(source, diagnostics);
      break;
    case text::Syntax::kWords:
      root = text::parse_words(source, diagnostics);
      break;
    case text::Syntax::kBinary:
      root = text::parse_binary(source, diagnostics);
      break;
  }
  checker.expect_reason(root.has_value(), diagnostics, "the text");
  if (root) expect_places(*root, {0, bytes.size()}, checker);
  return std::move(checker).complaints();
}

std::optional<Rig> as_stored(const Format& format, Rig rig, Complaints& complaints) {
  if (rig.cameras.size() > format.most_cameras) rig.cameras.resize(format.most_cameras);
  Diagnostics ignored;
  const StoredModel* stored = nullptr;
  for (const StoredModel& row : format.models) {
    if (stored == nullptr && row.stock && !row.pairs_only) stored = &row;
  }
  const bool all_stored =
      std::ranges::all_of(rig.cameras, [&](const Camera& camera) { return can_store(format, camera, ignored); });
  const bool one_model = std::ranges::all_of(
      rig.cameras, [&](const Camera& camera) { return camera.model.index() == rig.cameras.front().model.index(); });
  if (all_stored && (one_model || !format.one_model)) return rig;
  if (stored == nullptr) return std::nullopt;
  for (Camera& camera : rig.cameras) {
    Diagnostics diagnostics;
    const std::optional<Conversion> conversion = convert(camera, options_for(*stored), diagnostics);
    if (!conversion && !diagnostics.has_errors())
      complaints.push_back("the conversion to " + std::string(stored->model) + " is refused without an error");
    if (!conversion) return std::nullopt;
    camera = conversion->camera;
  }
  return rig;
}

Complaints write_promises(const Format& format, const Rig& rig) {
  Complaints complaints;
  const std::optional<Rig> stored = as_stored(format, rig, complaints);
  if (!stored) return complaints;
  Checker checker;
  expect_written(format, *stored, "writing " + std::string(format.id), checker);
  for (const std::string& complaint : std::move(checker).complaints()) complaints.push_back(complaint);
  return complaints;
}

Complaints read_promises(const Format* format, std::string_view bytes, const std::string& name, Depth depth) {
  Checker checker;
  const text::Source source = {name, std::string(bytes)};
  if (depth == Depth::kChecked) expect_checked(format, source, checker);
  Diagnostics diagnostics;
  const std::optional<text::Document> document = text::parse_document(source, diagnostics);
  checker.expect_reason(document.has_value(), diagnostics, "the text");
  if (!document) return std::move(checker).complaints();
  checker.expect(document->bytes() == bytes, "parsing changes bytes");

  const std::optional<Calibration> calibration = read_calibration({*document}, format, {}, diagnostics);
  checker.expect_reason(calibration.has_value(), diagnostics, "the calibration");
  if (!calibration) return std::move(checker).complaints();
  checker.expect(!diagnostics.has_errors(), "a calibration is read in spite of an error");

  const Format& own = *calibration->format;
  if (own.is_written()) expect_rewritten(own, *document, calibration->rig, checker);
  if (depth == Depth::kRead) return std::move(checker).complaints();
  for (const Format* target : {&own, &other_format(own, bytes)}) {
    if (!target->is_written()) continue;
    for (const std::string& complaint : write_promises(*target, sized(calibration->rig))) checker.expect(false, complaint);
  }
  return std::move(checker).complaints();
}

}  // namespace fca::fuzz
