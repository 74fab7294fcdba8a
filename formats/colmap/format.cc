// SPDX-License-Identifier: BSD-3-Clause
#include "colmap.h"
#include "ids.h"
#include "lines.h"
#include "rig_config.h"
#include "rigs.h"

#include "../fields.h"
#include "../kalibr/demands.h"
#include "../losses.h"
#include "../one_camera_files.h"
#include "../schema/schema.h"
#include "../text/binary.h"
#include "../text/npy.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace fca::colmap {

using text::Node;

namespace {

constexpr std::string_view kCamerasFile = "cameras.txt";
constexpr std::string_view kBinaryFile = "cameras.bin";
constexpr std::string_view kBinary = ".bin";  // the extension
constexpr std::string_view kReadBy = "COLMAP (rays inside 90 deg)";

constexpr std::array kModels = {
    StoredModel{"radtan", "OPENCV", true, "COLMAP", kalibr::kNoK3, Code::kColmapNoK3},
    StoredModel{"rational", "FULL_OPENCV", true, "COLMAP", {}},
    StoredModel{"pinhole", "PINHOLE", true, "COLMAP", {}},
    StoredModel{"kb4", "OPENCV_FISHEYE", true, kReadBy, {}},
    StoredModel{"fov", "FOV", true, kReadBy, {}},
    StoredModel{.model = "eucm", .file_name = "EUCM", .read_by = kReadBy, .ranges = {}, .since = "4.1"},
    StoredModel{.model = "division", .file_name = "DIVISION", .read_by = kReadBy, .ranges = {}, .since = "4.0"},
    StoredModel{"thin-prism-fisheye", "THIN_PRISM_FISHEYE", true, kReadBy, {}},
    StoredModel{
        .model = "fisheye624", .file_name = "RAD_TAN_THIN_PRISM_FISHEYE", .read_by = kReadBy, .ranges = {}, .since = "3.11"},
};
constexpr std::array kOwnFacts = {OwnFact{"ids of cameras"}};

/// One that no camera can have, too: its reader says what is wrong with it.
bool is_id(const Node& word) {
  return text::parse_int(word.value) || word.value.find_first_not_of("0123456789") == std::string::npos;
}

bool is_header(const Node& line) { return has_words(line, {kId, "MODEL", "WIDTH", "PARAMS"}); }

ProbeResult probe(const text::Document& document) {
  if (document.syntax() == text::Syntax::kJson) return probe_rig_config(document);
  if (is_rigs(document)) return probe_rigs(document);
  if (document.root().tag == text::kNpyTag) return {};
  if (document.syntax() == text::Syntax::kBinary) return {95, Message{Code::kColmapBinary}};
  if (document.syntax() != text::Syntax::kWords) return {};
  const std::vector<const Node*> lines = camera_lines(document);
  if (!lines.empty() && lines.front()->items.size() > kFirstParameter) {
    const std::vector<Node>& words = lines.front()->items;
    if (is_id(words[0]) && find_model(words[1].value) != nullptr)
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
    if (reader_.document().syntax() == text::Syntax::kWords) warn_of_blanks(lines);
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
    const std::optional<Id> id = read_new_id(words[0]);
    const Model* model = read_model(words[1], reader_);
    camera.image_size = reader_.image_size(words[2], words[3], "image ");
    if (!id || model == nullptr || !camera.image_size || !read_parameters(line, *model, camera)) return false;
    if (*id != rig.cameras.size() + 1) rig.extra_fields.push_back({camera.name, std::string(kId), std::to_string(*id)});
    rig.cameras.push_back(std::move(camera));
    return true;
  }

  std::optional<Id> read_new_id(const Node& word) {
    const std::optional<Id> id = read_id(word, kId, reader_);
    if (!id || ids_.insert(*id).second) return id;
    reader_.say(word, Code::kColmapIdTwice, {*id});
    return std::nullopt;
  }

  bool read_parameters(const Node& line, const Model& model, Camera& camera) {
    const std::span<const Node> words = std::span(line.items).subspan(kFirstParameter);
    const auto is_number = [](const Node& word) { return text::parse_real(word.value).has_value(); };
    const auto count = static_cast<std::size_t>(std::ranges::find_if_not(words, is_number) - words.begin());
    if (count < std::min(words.size(), model.parameters())) {
      static_cast<void>(reader_.real(words[count], set_by(model, count).front().name()));
      return false;
    }
    if (count != model.parameters()) {
      const Node& at = words[std::min(count - 1, model.parameters())];
      reader_.say(at, Code::kColmapParameterCount, {model.name, model.parameters(), count, parameter_names(model)});
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
  std::set<Id> ids_;
};

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  const text::Syntax syntax = documents.front().syntax();
  if (is_rigs(documents.front())) return read_rigs(documents.front(), diagnostics);
  if (syntax == text::Syntax::kWords || syntax == text::Syntax::kBinary)
    return CamerasReader(documents.front(), diagnostics).run();
  if (syntax == text::Syntax::kJson) return read_rig_config(documents.front(), options, diagnostics);
  diagnostics.add(Code::kColmapWrongSyntax, {}, {documents.front().source().name, 0, 0});
  return std::nullopt;
}

/// Numbers as they stand after each other.
std::string spelled(std::span<const double> numbers, text::Syntax syntax) {
  const bool binary = syntax == text::Syntax::kBinary;
  std::string text;
  for (const double number : numbers) {
    const std::string one = text::format_real(number);
    text += binary ? text::encoded(text::kRealTag, one) : (text.empty() ? "" : " ") + one;
  }
  return text;
}

using Lines = std::vector<std::vector<std::string>>;

/// The words of a fresh file.
Lines lines_of(const Rig& rig, std::span<const Id> ids) {
  Lines lines;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Camera& camera = rig.cameras[i];
    const Model& model = *written_model(camera.model);
    lines.push_back({std::to_string(ids[i]), std::string(model.name), std::to_string(camera.image_size->width),
                     std::to_string(camera.image_size->height)});
    const std::vector<double> numbers = parameters_in(model, camera).value();
    for (const double number : numbers) lines.back().push_back(text::format_real(number));
  }
  return lines;
}

/// What a file of cameras says, without comments and what else COLMAP does not read.
Lines lines_of(const text::Document& document) {
  Lines lines;
  for (const Node* line : camera_lines(document)) {
    const std::size_t words = kFirstParameter + find_model(line->items[1].value)->parameters();
    std::vector<std::string> values;
    for (const Node& word : std::span(line->items).first(words)) values.push_back(word.value);
    lines.push_back(std::move(values));
  }
  return lines;
}

/// With the comments that COLMAP writes.
std::string as_text(std::string_view head, const Lines& lines) {
  std::string text = std::string(head) + std::to_string(lines.size()) + "\n";
  for (const std::vector<std::string>& words : lines) {
    for (std::size_t i = 0; i < words.size(); ++i) text += (i > 0 ? " " : "") + words[i];
    text += "\n";
  }
  return text;
}

constexpr std::string_view kHeadOfCameras =
    "# Camera list with one line of data per camera:\n#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n# Number of cameras: ";
constexpr std::string_view kHeadOfRigs =
    "# Rig calib list with one line of data per calib:\n"
    "#   RIG_ID, NUM_SENSORS, REF_SENSOR_TYPE, REF_SENSOR_ID, SENSORS[] as (SENSOR_TYPE, SENSOR_ID, HAS_POSE, [QW, QX, QY, QZ, "
    "TX, TY, TZ])\n# Number of rigs: ";

/// The line with other numbers, and another model where its own cannot hold them or is none of `taken` (empty: all are).
void edit_line(text::Document& document, const Node& line, const Camera& old, const Camera& camera,
               std::span<const std::string_view> taken) {
  const std::vector<Node>& words = line.items;
  if (old.image_size != camera.image_size) {
    fields::set_scalar(document, words[2], std::to_string(camera.image_size->width));
    fields::set_scalar(document, words[3], std::to_string(camera.image_size->height));
  }
  const Model& named = *find_model(words[1].value);
  const bool is_taken = taken.empty() || std::ranges::find(taken, named.name) != taken.end();
  if (old.model == camera.model && is_taken) return;
  const std::optional<std::vector<double>> before = parameters_in(named, old);
  const std::optional<std::vector<double>> after = parameters_in(named, camera);
  if (!before || !after || !is_taken) {
    const Model& model = *written_model(camera.model);
    const text::Span first = words[kFirstParameter].span;
    const text::Span last = words[kFirstParameter + named.parameters() - 1].span;
    fields::set_scalar(document, words[1], std::string(model.name));
    document.replace({first.offset, last.end() - first.offset},
                     spelled(parameters_in(model, camera).value(), document.syntax()));
    return;
  }
  for (std::size_t i = 0; i < after->size(); ++i) {
    if ((*before)[i] == (*after)[i]) continue;
    document.replace(words[kFirstParameter + i].span, spelled(std::span(*after).subspan(i, 1), document.syntax()));
  }
}

/// The base, of the same cameras, with what the rig says otherwise.
text::Document edited(const text::Document& base, const Rig& old, const Rig& rig, std::span<const std::string_view> taken) {
  if (base.syntax() == text::Syntax::kJson) return edited_rig_config(base, old, rig);
  if (is_rigs(base)) return edited_rigs(base, rig);
  text::Document document = base;
  const std::vector<const Node*> lines = camera_lines(base);
  for (std::size_t i = 0; i < lines.size(); ++i) edit_line(document, *lines[i], old.cameras[i], rig.cameras[i], taken);
  return document;
}

/// Quaternions say rotations alone: a matrix that was printed with few digits, or a product of such, is not quite one.
Rig with_rotations(Rig rig, Written& written) {
  constexpr double kRounding = 1e-9;
  for (PoseEdge& edge : rig.poses) {
    const std::optional<Transform> nearest = nearest_rotation(edge.T_a_b);
    if (!nearest || largest_difference(*nearest, edge.T_a_b).distance <= kRounding) continue;
    edge.T_a_b = *nearest;
    written.restated.push_back(edge);
    written.losses.push_back(lost(Code::kPoseRecomputed, edge.a, "cam_from_rig_rotation", {edge.b}));
  }
  return rig;
}

/// How the cameras sit to each other, in files next to that of the cameras: for rig_configurator, and as a model has it.
void add_poses(const Rig& rig, std::span<const Id> ids, bool binary, Written& written, Diagnostics& diagnostics) {
  const std::optional<std::string> config = composed_rig_config(rig);
  std::optional<text::Document> document =
      config ? text::parse_document({"rig_config.json", *config}, diagnostics) : std::nullopt;
  if (document) written.files.push_back({*std::move(document), {}, {"colmap-rig"}});
  const Lines lines = rig_lines(rig, ids);
  if (lines.empty()) return;
  text::Source source = binary ? text::Source{"rigs.bin", text::binary_file(text::kRigsTag, lines)}
                               : text::Source{"rigs.txt", as_text(kHeadOfRigs, lines)};
  std::optional<text::Document> rigs = text::parse_document(std::move(source), diagnostics);
  if (!rigs) return;
  written.files.push_back({*std::move(rigs), {}, {"colmap-rig"}});
  // Where there is no room for either, one of them is missed.
  written.files.back().of_defaults = config.has_value();
}

/// Without images and points COLMAP does not open a folder.
void add_fillers(bool binary, Written& written, Diagnostics& diagnostics) {
  std::vector<text::Document> none;
  if (binary) {
    for (const char* name : {"images.bin", "points3D.bin"})
      none.emplace_back(text::Source{name, std::string(8, '\0')}, text::Syntax::kBinary, Node{});  // a count: 0
  } else {
    for (const auto& [name, line] :
         {std::pair{"images.txt", "# Image list: none\n"}, {"points3D.txt", "# 3D point list: none\n"}}) {
      if (std::optional<text::Document> document = text::parse_document({name, line}, diagnostics)) none.push_back(*document);
    }
  }
  for (text::Document& document : none) {
    written.files.push_back({std::move(document), {}, {}});
    written.files.back().of_defaults = true;
  }
}

/// Is the base to stay what it is, text or binary?
bool keeps_syntax(const text::Document& base, std::string_view extension) {
  if (extension.empty() || base.syntax() == text::Syntax::kJson) return true;
  return (base.syntax() == text::Syntax::kBinary) == (extension == kBinary);
}

/// A fresh file of cameras. Of the same ones in the other syntax it has the base's models and numbers.
std::optional<text::Document> composed(const text::Document* base, const std::optional<Rig>& old, const Rig& rig, bool binary,
                                       std::span<const Id> ids, std::span<const std::string_view> taken,
                                       Diagnostics& diagnostics) {
  std::optional<Lines> lines;
  if (base != nullptr && old && !is_rigs(*base) && base->syntax() != text::Syntax::kJson && schema::same_cameras(*old, rig)) {
    const std::optional<text::Document> now = text::as_edited(edited(*base, *old, rig, taken));
    if (now) lines = lines_of(*now);
  }
  if (!lines) lines = lines_of(rig, ids);
  if (!binary) return text::parse_document({std::string(kCamerasFile), as_text(kHeadOfCameras, *lines)}, diagnostics);
  return text::parse_document({std::string(kBinaryFile), text::binary_file(text::kCamerasTag, *lines)}, diagnostics);
}

/// As the base says it.
std::optional<Rig> read_base(const text::Document* base) {
  Diagnostics ignored;
  std::optional<Rig> rig = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  if (rig) name_sensors(*rig);
  return rig;
}

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  const std::optional<Rig> old = read_base(base);
  // Poses alone can be edited, too, where they are what was asked for.
  const bool same = old && (schema::same_cameras(*old, rig) || (is_rigs(*base) && options.keeps_layout));
  const bool edits = same && !options.rewrite && keeps_syntax(*base, options.extension);
  if (edits ? !can_store(kFormat, rig, &*old, diagnostics)
            : !writable_alone(kFormat, rig, Message{Code::kColmapDemandsSize}, diagnostics))
    return std::nullopt;
  const std::vector<Id> ids = camera_ids(rig);
  const bool wants_binary = options.extension == kBinary;
  std::optional<text::Document> document =
      edits ? edited(*base, *old, rig, options.models_taken)
            : composed(options.rewrite ? nullptr : base, old, rig, wants_binary, ids, options.models_taken, diagnostics);
  if (!document) return std::nullopt;
  Written written;
  const bool is_rig_config = document->syntax() == text::Syntax::kJson;
  const bool of_rigs = is_rig_config || is_rigs(*document);
  std::vector<ExtraField> said = edits ? old->extra_fields : std::vector<ExtraField>();
  for (std::size_t i = 0; !edits && i < ids.size(); ++i)
    said.push_back({rig.cameras[i].name, std::string(kId), std::to_string(ids[i])});
  const bool is_binary = document->syntax() == text::Syntax::kBinary;
  written.headline = {is_rig_config ? Code::kColmapRigHeadline
                      : of_rigs     ? Code::kColmapRigsHeadline
                      : is_binary   ? Code::kColmapBinaryHeadline
                                    : Code::kColmapHeadline};
  const auto own_rigs = std::ranges::find_if(options.input, is_rigs);
  written.files.push_back({*std::move(document), {}, {of_rigs ? "colmap-rig" : "colmap"}});
  for (std::size_t i = 0; i < rig.cameras.size() && (is_rig_config || !of_rigs); ++i)
    written.files.front().cameras.push_back(rig.cameras[i].name);
  add_extras_lost(rig, said, edits ? std::nullopt : old, Message{Code::kColmapNoPlace}, written.losses);
  list_camera_losses(rig, "COLMAP", written.losses);
  // Next to what is changed in place lie the poses of its folder.
  const bool has_poses_beside = edits && (options.keeps_layout || of_rigs);
  if (!has_poses_beside && !options.lenses_alone && edits && own_rigs != options.input.end()) {
    written.files.push_back({edited_rigs(*own_rigs, rig), {}, {"colmap-rig"}});
    written.files.back().place = is_binary ? "rigs.bin" : "rigs.txt";
  } else if (!has_poses_beside && !options.lenses_alone) {
    add_poses(with_rotations(rig, written), ids, is_binary, written, diagnostics);
  }
  if (written.files.size() == 1 && !of_rigs) written.sensor = kLensAlone;
  if (edits && written.files.size() == 1) return written;
  add_fillers(is_binary, written, diagnostics);
  if (edits) written.files.front().place = is_binary ? kBinaryFile : kCamerasFile;
  for (Written::File& file : written.files)
    if (file.place.empty()) file.place = file.document.source().name;
  return written;
}

/// The model that the file names for its camera number `index`; that of a fresh line where it names none that holds the lens.
const Model& model_in(const text::Document& file, std::size_t index, const Camera& camera) {
  const bool has_lines = file.syntax() == text::Syntax::kWords || file.syntax() == text::Syntax::kBinary;
  const std::vector<const Node*> lines = has_lines && !is_rigs(file) ? camera_lines(file) : std::vector<const Node*>();
  const Model* named =
      index < lines.size() && lines[index]->items.size() > 1 ? find_model(lines[index]->items[1].value) : nullptr;
  return named != nullptr && parameters_in(*named, camera) ? *named : *written_model(camera.model);
}

/// For COLMAP's feature_extractor, which takes sizes from the images (controllers/image_reader.cc).
std::string arguments(const Camera& camera, const text::Document& file, std::size_t index) {
  const Model& model = model_in(file, index, camera);
  const std::vector<double> numbers = parameters_in(model, camera).value();
  std::string list;
  for (const double number : numbers) list += (list.empty() ? "" : ",") + text::format_real(number);
  return "--ImageReader.camera_model " + std::string(model.name) + " --ImageReader.camera_params " + list;
}

}  // namespace

const Format kFormat = {
    .id = "colmap",
    .title = "COLMAP cameras.txt or .bin, rigs, rig_config.json",
    .group = FormatGroup::kReconstruction,
    .syntaxes = "text, binary, JSON",
    .extension = ".txt",
    .program = "COLMAP",
    .main_file = kCamerasFile,
    .binary_file = kBinaryFile,
    .reader_warns = true,
    .many_cameras = true,
    .extrinsics = true,
    .poses_apart = true,
    .metres_by_custom = true,
    .imu = false,
    .image_size = true,
    .own_facts = kOwnFacts,
    .models = kModels,
    .probe = probe,
    .arguments = arguments,
    .complete = name_sensors,
    .read = read,
    .write = write,
};

}  // namespace fca::colmap
