// SPDX-License-Identifier: BSD-3-Clause
#include "colmap.h"
#include "lines.h"
#include "rig_config.h"

#include "../fields.h"
#include "../kalibr/demands.h"
#include "../losses.h"
#include "../one_camera_files.h"
#include "../schema/schema.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>
#include <set>

namespace fca::colmap {

using text::Node;

namespace {

constexpr std::string_view kId = "CAMERA_ID";
constexpr std::string_view kCamerasFile = "cameras.txt";
constexpr std::string_view kReadBy = "COLMAP (rays inside 90 deg)";

constexpr std::array kModels = {
    StoredModel{"radtan", "OPENCV", true, "COLMAP", kalibr::kNoK3, Code::kColmapNoK3},
    StoredModel{"rational", "FULL_OPENCV", true, "COLMAP", {}},
    StoredModel{"pinhole", "PINHOLE", true, "COLMAP", {}},
    StoredModel{"kb4", "OPENCV_FISHEYE", true, kReadBy, {}},
    StoredModel{"fov", "FOV", true, kReadBy, {}},
    StoredModel{.model = "eucm", .file_name = "EUCM", .read_by = kReadBy, .ranges = {}, .since = "4.1"},
};
constexpr std::array kOwnFacts = {OwnFact{"ids of cameras"}};

bool is_whole(const Node& word) { return text::parse_int(word.value).has_value(); }

bool is_header(const Node& line) {
  const auto has = [&line](std::string_view word) {
    return std::ranges::any_of(line.items, [word](const Node& each) { return each.value.starts_with(word); });
  };
  return has(kId) && has("MODEL") && has("WIDTH") && has("PARAMS");
}

ProbeResult probe(const text::Document& document) {
  if (document.syntax() == text::Syntax::kJson) return probe_rig_config(document);
  if (document.syntax() != text::Syntax::kWords) return {};
  const std::vector<const Node*> lines = camera_lines(document);
  if (!lines.empty() && lines.front()->items.size() > kFirstParameter) {
    const std::vector<Node>& words = lines.front()->items;
    if (is_whole(words[0]) && find_model(words[1].value) != nullptr)
      return {95, Message{Code::kColmapNamedModel, {words[1].value}}};
  }
  if (std::ranges::any_of(document.root().items, is_header)) return {90, Message{Code::kColmapHeader}};
  return {};
}

class CamerasReader {
 public:
  CamerasReader(const text::Document& document, Diagnostics& diagnostics)
      : reader_(document, text::Dialect::kPyYaml, diagnostics) {}

  std::optional<Rig> run() {
    const std::vector<const Node*> lines = camera_lines(reader_.document());
    if (lines.empty()) {
      reader_.diagnostics().add(Code::kColmapNoCamera, {}, {reader_.document().source().name, 0, 0});
      return std::nullopt;
    }
    Rig rig;
    bool good = true;
    for (const Node* line : lines) good = read_camera(*line, rig) && good;
    if (!good) return std::nullopt;
    warn_of_blanks(lines);
    return rig;
  }

 private:
  bool read_camera(const Node& line, Rig& rig) {
    const std::vector<Node>& words = line.items;
    if (words.size() <= kFirstParameter) {
      reader_.say(line, Code::kColmapShortLine, {words.size()});
      return false;
    }
    Camera camera;
    camera.name = "cam" + std::to_string(rig.cameras.size());
    const std::optional<int> id = read_id(words[0]);
    const Model* model = read_model(words[1], reader_);
    camera.image_size = reader_.image_size(words[2], words[3], "image ");
    if (!id || model == nullptr || !camera.image_size || !read_parameters(line, *model, camera)) return false;
    if (*id != static_cast<int>(rig.cameras.size()) + 1)
      rig.extra_fields.push_back({camera.name, std::string(kId), std::to_string(*id)});
    rig.cameras.push_back(std::move(camera));
    return true;
  }

  std::optional<int> read_id(const Node& word) {
    const std::optional<int> id = reader_.integer(word, kId);
    if (!id) return std::nullopt;
    if (*id < 0 || !ids_.insert(*id).second) {
      reader_.say(word, *id < 0 ? Code::kColmapNegativeId : Code::kColmapIdTwice, {*id});
      return std::nullopt;
    }
    return id;
  }

  bool read_parameters(const Node& line, const Model& model, Camera& camera) {
    const std::span<const Node> words = std::span(line.items).subspan(kFirstParameter);
    const auto is_number = [](const Node& word) { return text::parse_real(word.value).has_value(); };
    const auto count = static_cast<std::size_t>(std::ranges::find_if_not(words, is_number) - words.begin());
    if (count < std::min(words.size(), model.parameters)) {
      static_cast<void>(reader_.real(words[count], set_by(model, count).front().name()));
      return false;
    }
    if (count != model.parameters) {
      const Node& at = words[std::min(count - 1, model.parameters)];
      reader_.say(at, Code::kColmapParameterCount, {model.name, model.parameters, count, parameter_names(model)});
      return false;
    }
    if (count < words.size()) reader_.say(words[count], Code::kColmapAfterParameters, {words[count].value.substr(0, 40)});
    return read_lens(words.first(count), model, camera, reader_);
  }

  /// COLMAP 3.8 takes what stands between two blanks for a word, even nothing. Said once.
  void warn_of_blanks(std::span<const Node* const> lines) {
    const text::Source& source = reader_.document().source();
    for (const Node* line : lines) {
      for (std::size_t i = 1; i < line->items.size(); ++i) {
        const std::size_t start = line->items[i - 1].span.end();
        const text::Span gap = {start, line->items[i].span.offset - start};
        if (source.text(gap) == " ") continue;
        reader_.diagnostics().add(Code::kColmapBlanks, {}, source.range(gap));
        return;
      }
    }
  }

  fields::Reader reader_;
  std::set<int> ids_;
};

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  const text::Syntax syntax = documents.front().syntax();
  if (syntax == text::Syntax::kWords) return CamerasReader(documents.front(), diagnostics).run();
  if (syntax == text::Syntax::kJson) return read_rig_config(documents.front(), options, diagnostics);
  diagnostics.add(Code::kColmapWrongSyntax, {}, {documents.front().source().name, 0, 0});
  return std::nullopt;
}

/// The numbers that cameras go by: those that they had in a cameras.txt, else 1, 2, ...
std::vector<int> camera_ids(const Rig& rig) {
  std::vector<int> ids(rig.cameras.size(), -1);
  std::set<int> taken;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const ExtraField* had = rig.find_extra_field(rig.cameras[i].name, kId);
    const std::optional<int> id = had != nullptr ? text::parse_int(had->value) : std::nullopt;
    if (id && *id >= 0 && taken.insert(*id).second) ids[i] = *id;
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i] >= 0) continue;
    ids[i] = static_cast<int>(i) + 1;
    while (!taken.insert(ids[i]).second) ++ids[i];
  }
  return ids;
}

std::string spelled(std::span<const double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : " ") + text::format_real(number);
  return text;
}

/// With the comments that COLMAP writes.
std::string composed(const Rig& rig, std::span<const int> ids) {
  std::string text =
      "# Camera list with one line of data per camera:\n#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n"
      "# Number of cameras: " +
      std::to_string(rig.cameras.size()) + "\n";
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Camera& camera = rig.cameras[i];
    const Model& model = *written_model(camera.model);
    text += std::to_string(ids[i]) + " " + std::string(model.name) + " " + std::to_string(camera.image_size->width) + " " +
            std::to_string(camera.image_size->height) + " " + spelled(parameters_in(model, camera).value()) + "\n";
  }
  return text;
}

/// The line with other numbers, and another model where its own cannot hold them.
void edit_line(text::Document& document, const Node& line, const Camera& old, const Camera& camera) {
  const std::vector<Node>& words = line.items;
  if (old.image_size != camera.image_size) {
    fields::set_scalar(document, words[2], std::to_string(camera.image_size->width));
    fields::set_scalar(document, words[3], std::to_string(camera.image_size->height));
  }
  if (old.model == camera.model) return;
  const Model& named = *find_model(words[1].value);
  const std::optional<std::vector<double>> before = parameters_in(named, old);
  const std::optional<std::vector<double>> after = parameters_in(named, camera);
  if (!before || !after) {
    const Model& model = *written_model(camera.model);
    const text::Span first = words[kFirstParameter].span;
    const text::Span last = words[kFirstParameter + named.parameters - 1].span;
    document.replace(words[1].span, std::string(model.name));
    document.replace({first.offset, last.end() - first.offset}, spelled(parameters_in(model, camera).value()));
    return;
  }
  for (std::size_t i = 0; i < after->size(); ++i) {
    if ((*before)[i] != (*after)[i]) document.replace(words[kFirstParameter + i].span, text::format_real((*after)[i]));
  }
}

/// The base, of the same cameras, with what the rig says otherwise.
text::Document edited(const text::Document& base, const Rig& old, const Rig& rig) {
  if (base.syntax() == text::Syntax::kJson) return edited_rig_config(base, old, rig);
  text::Document document = base;
  const std::vector<const Node*> lines = camera_lines(base);
  for (std::size_t i = 0; i < lines.size(); ++i) edit_line(document, *lines[i], old.cameras[i], rig.cameras[i]);
  return document;
}

/// How the cameras sit to each other, in a file beside cameras.txt.
void add_rig_config(const Rig& rig, Written& written, Diagnostics& diagnostics) {
  const std::optional<std::string> bytes = composed_rig_config(rig);
  std::optional<text::Document> document =
      bytes ? text::parse_document({"rig_config.json", *bytes}, diagnostics) : std::nullopt;
  if (!document) return;
  written.files.push_back({*std::move(document), {}, {"colmap-rig"}});
  for (Written::File& file : written.files) file.place = file.document.source().name;
  written.headline = {Code::kColmapBothHeadline};
}

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  Diagnostics ignored;
  const std::optional<Rig> old = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  const bool edits = old && !options.anew && schema::same_cameras(*old, rig);
  if (edits ? !can_store(kFormat, rig, &*old, diagnostics)
            : !writable_alone(kFormat, rig, Message{Code::kColmapDemandsSize}, diagnostics))
    return std::nullopt;
  const std::vector<int> ids = camera_ids(rig);
  std::optional<text::Document> document =
      edits ? edited(*base, *old, rig) : text::parse_document({std::string(kCamerasFile), composed(rig, ids)}, diagnostics);
  if (!document) return std::nullopt;
  Written written;
  const bool is_rig_config = document->syntax() == text::Syntax::kJson;
  std::vector<ExtraField> said = edits ? old->extra_fields : std::vector<ExtraField>();
  for (std::size_t i = 0; !edits && i < ids.size(); ++i)
    said.push_back({rig.cameras[i].name, std::string(kId), std::to_string(ids[i])});
  written.files.push_back({*std::move(document), {}, {is_rig_config ? "colmap-rig" : "colmap"}});
  for (const Camera& camera : rig.cameras) written.files.front().cameras.push_back(camera.name);
  add_extras_lost(rig, said, edits ? std::nullopt : old, Message{Code::kColmapNoPlace}, written.losses);
  list_camera_losses(rig, "COLMAP", written.losses);
  written.headline = {is_rig_config ? Code::kColmapRigHeadline : Code::kColmapHeadline};
  if (!edits) add_rig_config(rig, written, diagnostics);
  if (written.files.size() == 1 && !is_rig_config) written.sensor = kLensAlone;
  return written;
}

/// For COLMAP's feature_extractor, which takes sizes from the images (controllers/image_reader.cc).
std::string arguments(const Camera& camera) {
  const Model& model = *written_model(camera.model);
  const std::vector<double> numbers = parameters_in(model, camera).value();
  std::string list;
  for (const double number : numbers) list += (list.empty() ? "" : ",") + text::format_real(number);
  return "--ImageReader.camera_model " + std::string(model.name) + " --ImageReader.camera_params " + list;
}

}  // namespace

const Format kFormat = {
    .id = "colmap",
    .title = "COLMAP cameras.txt, rig_config.json",
    .syntaxes = "text, JSON",
    .extension = ".txt",
    .program = "COLMAP",
    .main_file = kCamerasFile,
    .reader_warns = true,
    .many_cameras = true,
    .extrinsics = true,
    .poses_apart = true,
    .imu = false,
    .image_size = true,
    .own_facts = kOwnFacts,
    .models = kModels,
    .probe = probe,
    .arguments = arguments,
    .read = read,
    .write = write,
};

}  // namespace fca::colmap
