// SPDX-License-Identifier: BSD-3-Clause
// A lens as a table of rays, from a measurement or a program of one's own: it is read, and fitted as any model.
//
//   u v x y z      a pixel (the centre of the top-left one is 0, 0) and its ray (x right, y down, z forward, of any length)
//
// One line each, with blanks or commas between the numbers. A first line of those five names, and lines that begin with #, are
// not read. The covariance of a camera's parameters is such a table, too: covariance.h. Or a .npy file of rows of five numbers.
// No line may lack a ray: leave the pixels out that see nothing.
#include "rays.h"

#include "covariance.h"
#include "fields.h"
#include "text/npy.h"
#include "text/words.h"

#include <fca/code.h>
#include <fca/convert/ray_table.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>

namespace fca::rays {

using text::Node;

namespace {

constexpr std::array<std::string_view, 5> kColumns = {"u", "v", "x", "y", "z"};
constexpr std::string_view kSeparators = ",; \t";

/// A line's words, also where commas alone stand between them.
std::vector<Node> words_of(const Node& line) {
  std::vector<Node> words;
  for (const Node& item : line.items) std::ranges::move(fields::words_in(item, kSeparators), std::back_inserter(words));
  return words;
}

/// The words in small letters, without quotes and the "#" of a comment.
std::string names_in(std::span<const Node> words) {
  std::string names;
  for (const Node& word : words) {
    for (const char c : word.value) {
      if (c != '"' && c != '#') names += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    if (!names.empty()) names += ' ';
  }
  return names;
}

bool names_columns(std::span<const Node> words) { return names_in(words) == "u v x y z "; }

/// The same names in another order.
bool names_other_columns(std::span<const Node> words) {
  std::string names = names_in(words);
  std::ranges::sort(names);
  return names == "     uvxyz" && !names_columns(words);
}

/// A comment above the numbers, as numpy.savetxt writes its header.
bool has_header_in_comment(const text::Document& document) {
  for (const Node& line : document.root().items) {
    if (line.items.empty()) continue;
    if (line.tag != text::kCommentTag) return false;
    if (names_columns(words_of(line))) return true;
  }
  return false;
}

/// The first line that specifies something.
const Node* first_line(const text::Document& document) {
  const auto found = std::ranges::find_if(
      document.root().items, [](const Node& line) { return !line.items.empty() && line.tag != text::kCommentTag; });
  return found == document.root().items.end() ? nullptr : &*found;
}

std::optional<Correspondence> entry_of(fields::Reader& reader, const Node& line, std::span<const Node> words) {
  if (words.size() != kColumns.size()) {
    reader.say(line, Code::kNumbersWanted, {"u v x y z", words.size(), kColumns.size()});
    return std::nullopt;
  }
  std::array<double, kColumns.size()> numbers{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::optional<double> number = reader.real(words[i], kColumns.at(i));
    if (!number) return std::nullopt;
    numbers.at(i) = *number;
  }
  Correspondence entry;
  std::copy_n(numbers.begin(), entry.pixel.size(), entry.pixel.begin());
  std::copy_n(numbers.begin() + 2, entry.ray.size(), entry.ray.begin());
  constexpr double kMostPixels = 1e6;
  if (std::abs(entry.pixel[0]) > kMostPixels || std::abs(entry.pixel[1]) > kMostPixels) {
    reader.say(line, Code::kPixelOutOfRange, {entry.pixel[0], entry.pixel[1]});
    return std::nullopt;
  }
  if (!internal::normalise(entry.ray.data())) {
    reader.say(line, Code::kRayWithoutDirection);
    return std::nullopt;
  }
  return entry;
}

/// From where to where the pixels run.
struct Extent {
  Pixel least;
  Pixel most;
};

Extent extent_of(std::span<const Correspondence> rays) {
  Extent extent = {rays.front().pixel, rays.front().pixel};
  for (const Correspondence& entry : rays) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      extent.least.at(axis) = std::min(extent.least.at(axis), entry.pixel.at(axis));
      extent.most.at(axis) = std::max(extent.most.at(axis), entry.pixel.at(axis));
    }
  }
  return extent;
}

/// Do nearly all pixels lie in the image, and over more than a corner of it?
bool fill_image(std::span<const Correspondence> rays, const Extent& extent, const ImageSize& size) {
  constexpr double kBorder = 0.5;  // of pixels
  constexpr double kMostOutside = 0.1;
  constexpr double kLeastSpread = 0.1;
  const auto outside = std::ranges::count_if(rays, [&size](const Correspondence& entry) {
    const auto [u, v] = entry.pixel;
    return u < -kBorder || v < -kBorder || u > size.width - kBorder || v > size.height - kBorder;
  });
  const bool is_spread = extent.most[0] - extent.least[0] >= kLeastSpread * size.width ||
                         extent.most[1] - extent.least[1] >= kLeastSpread * size.height;
  return is_spread && static_cast<double>(outside) <= kMostOutside * static_cast<double>(rays.size());
}

std::optional<Camera> read_camera(const text::Document& document, const ReadOptions& options, Diagnostics& diagnostics) {
  Camera camera;
  camera.name = "cam0";
  camera.image_size = options.image_size;
  if (document.root().kind != text::NodeKind::kSequence) {
    diagnostics.add(Code::kRaysWrongSyntax, {}, {document.source().name, 0, 0});
    return std::nullopt;
  }
  fields::Reader reader(document, text::Dialect::kPyYaml, diagnostics);
  const Node* first = first_line(document);
  const Node* gap = nullptr;  ///< An empty line after a ray: at the end it says nothing.
  for (const Node& line : document.root().items) {
    if (line.items.empty() && !camera.rays.empty()) gap = &line;
    if (line.items.empty() || line.tag == text::kCommentTag) continue;
    const std::vector<Node> words = words_of(line);
    if (&line == first && names_columns(words)) continue;
    if (&line == first && names_other_columns(words)) {
      reader.say(line, Code::kRaysOfOtherColumns);
      return std::nullopt;
    }
    if (gap != nullptr) reader.say(Severity::kNote, *gap, Code::kNumbersWanted, {"u v x y z", 0, kColumns.size()});
    gap = nullptr;
    const std::optional<Correspondence> entry = entry_of(reader, line, words);
    if (!entry) return std::nullopt;
    camera.rays.push_back(*entry);
  }
  const bool looks_ahead = std::ranges::any_of(camera.rays, [](const Correspondence& entry) { return entry.ray[2] > 0.0; });
  const bool has_centre = looks_ahead && camera.rays.size() >= kFewestRays;
  const std::optional<LensCentre> centre = has_centre ? centre_of(camera.rays) : std::nullopt;
  if (!centre) {
    diagnostics.add(camera.rays.size() < kFewestRays ? Code::kTooFewRays : Code::kRaysWithoutCentre,
                    {camera.rays.size(), kFewestRays}, {document.source().name, 0, 0});
    return std::nullopt;
  }
  const Extent extent = extent_of(camera.rays);
  if (camera.image_size && !fill_image(camera.rays, extent, *camera.image_size)) {
    diagnostics.add(
        Code::kRaysOfOtherImage,
        {extent.least[0], extent.most[0], extent.least[1], extent.most[1], camera.image_size->width, camera.image_size->height},
        {document.source().name, 0, 0});
    return std::nullopt;
  }
  for (Correspondence& entry : camera.rays) entry.weight = 1.0 / static_cast<double>(camera.rays.size());
  camera.model = Intrinsics<Pinhole>{{centre->focal[0], centre->focal[1], centre->point[0], centre->point[1]}};
  return camera;
}

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  Rig rig;
  for (const text::Document& document : documents) {
    if (covariance::is_table(document)) {
      Diagnostics found;
      covariance::read(document, rig, found);
      for (const Diagnostic& entry : found.entries()) diagnostics.add(entry);
      if (found.has_errors()) return std::nullopt;
      continue;
    }
    std::optional<Camera> camera = read_camera(document, options, diagnostics);
    if (!camera) return std::nullopt;
    rig.cameras.push_back(*std::move(camera));
  }
  return rig;
}

/// Five numbers in a line may be anything: only the names of the columns, or a row of NumPy's, tell.
ProbeResult probe(const text::Document& document) {
  if (covariance::is_table(document)) return {evidence::kPart, {Code::kFoundKeys, {std::vector<std::string>{"covariance"}}}};
  if (document.root().tag == text::kNpyTag) return {evidence::kHint, {Code::kFoundKeys, {"NumPy"}}};
  const bool has_lines = document.syntax() == text::Syntax::kWords;
  const Node* first = has_lines ? first_line(document) : nullptr;
  if (first == nullptr || (!names_columns(words_of(*first)) && !has_header_in_comment(document))) return {};
  return {evidence::kCamera, {Code::kFoundKeys, {std::vector<std::string>(kColumns.begin(), kColumns.end())}}};
}

}  // namespace

const Format kFormat = {
    .id = "rays",
    .title = "table of rays (u v x y z)",
    .group = FormatGroup::kCalibration,
    .syntaxes = "CSV, text, .npy",
    .extension = ".csv",
    .program = "a measurement",
    .many_cameras = false,
    .extrinsics = false,
    .imu = false,
    .image_size = false,
    .models = {},
    .probe = probe,
    .read = read,
};

}  // namespace fca::rays
