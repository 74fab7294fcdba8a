// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/calibration.h>

#include "pose_words.h"

#include "known_formats.h"
#include "lengths.h"
#include "losses.h"
#include "lost_poses.h"
#include "uncertainties.h"

#include <fca/code.h>
#include <fca/formats/read_back.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>
#include <fca/rig/contradictions.h>
#include <fca/rig/limits.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

namespace fca {

std::optional<text::Document> parse_calibration(const text::Source& source, Diagnostics& diagnostics) {
  Diagnostics found;
  std::optional<text::Document> document = text::parse_document(source, found);
  const Message known = document ? Message{} : looks_like(source.bytes, Parsed::kNo);
  if (known.is_said()) {
    diagnostics.add(known.code, known.arguments, {source.name, 0, 0});
    return std::nullopt;
  }
  for (const Diagnostic& entry : found.entries()) diagnostics.add(entry);
  return document;
}

std::optional<DetectedFormat> detect_format(const text::Document& document, Diagnostics& diagnostics) {
  std::vector<DetectedFormat> surest;
  int score = 0;
  for (const Format& format : all_formats()) {
    const ProbeResult result = format.probe(document);
    if (result.score > score) surest.clear();
    score = std::max(score, result.score);
    if (result.score == score && score > 0) surest.push_back({&format, result.why});
  }
  const SourceRange where = {document.source().name, 0, 0};
  if (surest.empty()) {
    const Message known = looks_like(document.source().bytes, Parsed::kYes);
    diagnostics.add(known.is_said() ? known.code : Code::kFormatUnknown, known.arguments, where);
    return std::nullopt;
  }
  if (surest.size() > 1) {
    std::vector<Message> candidates;
    candidates.reserve(surest.size());
    for (const DetectedFormat& candidate : surest)
      candidates.push_back({Code::kFormatCandidate, {candidate.format->id, candidate.why}});
    diagnostics.add(Code::kFormatAmbiguous, {candidates}, where);
    return std::nullopt;
  }
  return surest.front();
}

namespace {

using Names = std::map<std::string, std::string>;  // old -> new

/// "[1, 2]" with the numbers of the cameras' new names: [3, 2] where cam1 became cam3.
std::string recounted(const std::string& list, const Names& names) {
  constexpr std::string_view kDigits = "0123456789";
  std::string result;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find_first_not_of(kDigits, at), list.size());
    if (end == at) {
      result += list[at++];
      continue;
    }
    const auto name = names.find("cam" + list.substr(at, end - at));
    result += name == names.end() ? list.substr(at, end - at) : name->second.substr(std::string_view("cam").size());
    at = end;
  }
  return result;
}

/// Gives the cameras of `part`, a file of `format`, whose names `rig` has the next free "camN", in its poses and numbers, too.
void rename_apart(const Rig& rig, const Format& format, Rig& part) {
  std::size_t next = rig.cameras.size();
  Names names;
  for (Camera& camera : part.cameras) {
    if (rig.find_camera(camera.name) == nullptr) continue;
    const std::string old = camera.name;
    std::string name;
    do {
      name = "cam" + std::to_string(next++);
    } while (rig.find_camera(name) != nullptr || part.find_camera(name) != nullptr);
    for (PoseEdge& edge : part.poses) {
      if (edge.a == old) edge.a = name;
      if (edge.b == old) edge.b = name;
    }
    for (ExtraField& extra : part.extra_fields) {
      if (extra.owner == old) extra.owner = name;
    }
    for (RectifiedPair::View& view : part.rectified ? std::span(part.rectified->views) : std::span<RectifiedPair::View>()) {
      if (view.camera == old) view.camera = name;
    }
    camera.name = name;
    names.emplace(old, name);
  }
  for (Uncertainty& each : part.uncertainties) {
    if (const auto renamed = names.find(each.camera); renamed != names.end()) each.camera = renamed->second;
  }
  for (ExtraField& extra : part.extra_fields) {
    if (!extra.owner.empty() && std::ranges::find(format.of_cameras, extra.key) != format.of_cameras.end())
      extra.value = recounted(extra.value, names);
  }
}

/// Adds what `part` holds to `rig`: its IMUs, poses and cameras. Facts stated twice must agree.
bool join(const Rig& part, const text::Document& document, Rig& rig, Diagnostics& diagnostics) {
  bool good = true;
  const SourceRange where = {document.source().name, 0, 0};
  for (const Camera& camera : part.cameras) {
    const Camera* there = rig.find_camera(camera.name);
    if (there == nullptr) {
      rig.cameras.push_back(camera);
      continue;
    }
    // COLMAP's rig_config.json specifies the lenses again, without sizes.
    const bool same_size = !camera.image_size || camera.image_size == there->image_size;
    if (there->model != camera.model || !same_size) {
      diagnostics.add(Code::kCameraInMainFile, {camera.name}, where);
      good = false;
    }
  }
  for (const Imu& imu : part.imus) {
    const auto same_name = std::ranges::find(rig.imus, imu.name, &Imu::name);
    if (same_name == rig.imus.end()) {
      rig.imus.push_back(imu);
    } else if (*same_name != imu) {
      diagnostics.add(Code::kImuInMainFile, {imu.name}, where);
      good = false;
    }
  }
  rig.poses.insert(rig.poses.end(), part.poses.begin(), part.poses.end());
  for (const Frame& frame : part.frames) rig.add_frame(frame.name, frame.kind);
  rig.extra_fields.insert(rig.extra_fields.end(), part.extra_fields.begin(), part.extra_fields.end());
  rig.uncertainties.insert(rig.uncertainties.end(), part.uncertainties.begin(), part.uncertainties.end());
  rig.pose_uncertainties.insert(rig.pose_uncertainties.end(), part.pose_uncertainties.begin(), part.pose_uncertainties.end());
  if (!rig.baseline_m) rig.baseline_m = part.baseline_m;
  if (!rig.rectified) rig.rectified = part.rectified;
  return good;
}

/// In the order in which they were read.
std::vector<std::string> names_of_path(const Rig& rig, const PoseLoop& loop) {
  const std::set<std::size_t> edges(loop.path.begin(), loop.path.end());
  std::vector<std::string> names;
  names.reserve(edges.size());
  for (const std::size_t i : edges) names.push_back(name_of(rig.poses[i]));
  return names;
}

/// Are they two statements of one pose, in the same direction?
bool is_second_statement(const Rig& rig, const PoseLoop& loop) {
  return loop.path.size() == 1 && rig.poses[loop.path.front()].a == rig.poses[loop.edge].a;
}

/// `files`: what specifies each pose.
Diagnostic worded(const Contradiction& contradiction, const Rig& rig, std::span<const std::string> files) {
  const PoseLoop& loop = contradiction.loop;
  const PoseEdge& edge = rig.poses[loop.edge];
  const SourceRange where = {files[loop.edge], 0, 0};
  if (contradiction.mistake != Code::kNone) return {Severity::kWarning, {contradiction.mistake, {name_of(edge)}}, where};
  if (is_second_statement(rig, loop) && files[loop.path.front()] != files[loop.edge]) {
    const auto& [first, second] = std::minmax(loop.path.front(), loop.edge);
    return {Severity::kWarning,
            {Code::kPoseInTwoFiles, {edge.a, edge.b, files[second], loop.difference.largest_element, files[first]}},
            {files[first], 0, 0}};
  }
  return {Severity::kWarning,
          {Code::kPoseContradictsOthers,
           {edge.a, edge.b, names_of_path(rig, loop), in_degrees(loop.difference.angle_rad),
            in_metres(loop.difference.distance_m)}},
          where};
}

/// A pose that is specified, and follows from others too: do they agree? Real files print them from one estimate, to 1e-15. The
/// file can be read, which makes them warnings; how grave they are, checks and verdicts say.
void warn_of_contradictions(const Rig& rig, std::span<const std::string> files, Diagnostics& diagnostics) {
  for (const Contradiction& each : contradictions(rig)) diagnostics.add(worded(each, rig, files));
}

}  // namespace

std::vector<NamedFile> named_parts(const Format& format, const text::Document& document) {
  std::vector<NamedFile> parts;
  if (format.parts == nullptr) return parts;
  const std::filesystem::path folder = std::filesystem::path(document.source().name).parent_path();
  for (const text::Node* node : format.parts(document)) {
    parts.push_back({(folder / std::filesystem::path(node->value).relative_path()).string(), document.range(*node)});
  }
  return parts;
}

std::optional<text::Source> read_part(const NamedFile& part) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(part.path, ignored)) return std::nullopt;
  Diagnostics discarded;
  return text::read_source(part.path, discarded);
}

namespace {

/// The first of the documents with the parts of it that follow: all, or none.
std::span<const text::Document> with_parts(const Format& format, std::span<const text::Document> documents) {
  const std::vector<NamedFile> named = named_parts(format, documents.front());
  const auto name_of = [](const text::Document& document) { return document.source().name; };
  const bool all = documents.size() > named.size() &&
                   std::ranges::equal(documents.subspan(1, named.size()), named, {}, name_of, &NamedFile::path);
  return documents.first(all ? 1 + named.size() : 1);
}

/// Does it say anything of what a file says?
bool tells(const ReadOptions& options) {
  return options.image_size || options.opencv_model || options.length_unit_m || options.imu_rate_hz;
}

/// Gives the cameras what the files without cameras say of them, once all of the rig's files, of these formats, are read.
void complete(std::span<const Format* const> formats, Rig& rig) {
  for (const Format& each : all_formats()) {
    const bool is_read = std::ranges::find(formats, &each) != formats.end();
    if (is_read && each.complete != nullptr) each.complete(rig);
  }
}

}  // namespace

/// Joined files of cameras alone put each at the origin of the same frame (ROS: R = I and no baseline; mrcal: zeros): that
/// specifies no pose.
void forget_common_origins(Rig& rig, Diagnostics& diagnostics) {
  std::map<std::string, std::vector<std::string>> at_origin;
  // A vehicle's is one that cameras are measured in.
  const auto is_of_files = [&rig](const std::string& name) { return rig.kind_of(name) == FrameKind::kOther; };
  for (const PoseEdge& edge : rig.poses) {
    if (edge.T_a_b != Transform{}) continue;
    if (is_of_files(edge.a)) at_origin[edge.a].push_back(edge.b);
    if (is_of_files(edge.b)) at_origin[edge.b].push_back(edge.a);
  }
  for (const auto& [frame, cameras] : at_origin) {
    if (cameras.size() < 2) continue;
    std::erase_if(rig.poses,
                  [&of = frame](const PoseEdge& edge) { return (edge.a == of || edge.b == of) && edge.T_a_b == Transform{}; });
    diagnostics.add(Code::kPoseOfEachMissing, {cameras});
  }
}

std::optional<Rig> rig_alone(const Calibration& calibration, std::size_t document) {
  if (document < calibration.rigs.size() && calibration.rigs[document]) return calibration.rigs[document];
  Diagnostics said_before;
  return calibration.formats[document]->read(std::span(calibration.documents).subspan(document, 1), {}, said_before);
}

std::optional<Calibration> alone(const Calibration& calibration, std::size_t document) {
  std::optional<Rig> rig = rig_alone(calibration, document);
  if (!rig) return std::nullopt;
  Calibration result;
  result.format = calibration.formats[document];
  result.why = {Code::kFormatGiven};
  result.documents = {calibration.documents[document]};
  result.formats = {result.format};
  result.rig = *std::move(rig);
  if (result.format->leaves_unit_open()) result.poses_without_unit = result.rig.poses;
  complete(result.formats, result.rig);
  return result;
}

std::optional<Calibration> read_calibration(std::vector<text::Document> documents, const Format* format,
                                            const ReadOptions& options, Diagnostics& diagnostics,
                                            std::span<const std::optional<DetectedFormat>> detected_before) {
  if (documents.empty()) return std::nullopt;
  Calibration result;
  if (documents.size() > 1) result.rigs.resize(documents.size());
  std::vector<std::string> files;  // in which each pose of the rig stands
  for (std::size_t i = 0; i < documents.size(); ++i) {
    const text::Document& document = documents[i];
    const bool main_file = result.format == nullptr;
    DetectedFormat detected{format, {Code::kFormatGiven}};
    if (format == nullptr || (!main_file && !options.join)) {
      const bool is_known = i < detected_before.size() && detected_before[i];
      const std::optional<DetectedFormat> found = is_known ? detected_before[i] : detect_format(document, diagnostics);
      if (!found) return std::nullopt;
      detected = *found;
    }
    const std::span<const text::Document> parts = with_parts(*detected.format, std::span(documents).subspan(i));
    std::optional<Rig> rig = detected.format->read(parts, options, diagnostics);
    if (!rig) return std::nullopt;
    if (const std::size_t count = result.rig.cameras.size() + rig->cameras.size(); count > kMostCameras) {
      diagnostics.add(Code::kTooManyCameras, {count, kMostCameras}, {document.source().name, 0, 0});
      return std::nullopt;
    }
    if (parts.size() == 1 && !result.rigs.empty() && !tells(options)) result.rigs[i] = rig;
    const bool rectified_here = rig->rectified && !result.rig.rectified;
    if (main_file) {
      result.format = detected.format;
      result.why = detected.why;
      result.rig = *std::move(rig);
    } else {
      if (result.rig.cameras.empty() && !rig->cameras.empty() && detected.format == result.format) result.with_cameras = i;
      if (options.join) rename_apart(result.rig, *detected.format, *rig);
      result.one_format = result.one_format && (rig->cameras.empty() || detected.format == result.format);
      if (!join(*rig, document, result.rig, diagnostics)) return std::nullopt;
    }
    result.formats.resize(result.formats.size() + parts.size(), detected.format);
    i += parts.size() - 1;
    const auto own = std::span(result.rig.poses).subspan(files.size());
    if (detected.format->leaves_unit_open() && options.length_unit_m) {
      for (PoseEdge& edge : own) scale_translation(*options.length_unit_m, edge.T_a_b);
      if (rectified_here) result.rig.rectified->offset_m *= *options.length_unit_m;
      result.poses_in_told_unit += own.size();
    } else if (detected.format->leaves_unit_open()) {
      result.poses_without_unit.insert(result.poses_without_unit.end(), own.begin(), own.end());
    }
    files.resize(result.rig.poses.size(), document.source().name);
  }
  complete(result.formats, result.rig);
  if (!match_uncertainties(result.rig, diagnostics)) return std::nullopt;
  warn_of_contradictions(result.rig, files, diagnostics);
  if (options.join && !result.format->many_cameras && !result.format->frame.empty())
    forget_common_origins(result.rig, diagnostics);
  result.documents = std::move(documents);
  return result;
}

std::vector<ImageSize> offered_sizes(const Diagnostics& diagnostics) {
  std::vector<ImageSize> sizes;
  for (const Diagnostic& entry : diagnostics.entries()) {
    if (entry.severity == Severity::kError && entry.facts.code != Code::kDeviceSizeNeeded) return {};
    if (entry.facts.code != Code::kDeviceSizeNeeded) continue;
    for (const std::string& size : std::get<std::vector<std::string>>(entry.facts.arguments.front().value)) {
      const std::size_t x = size.find('x');
      sizes.push_back({text::parse_int(size.substr(0, x)).value_or(0), text::parse_int(size.substr(x + 1)).value_or(0)});
    }
  }
  return sizes;
}

std::optional<Written> write_calibration(const Format& format, const text::Document* base, const Rig& rig,
                                         const WriteOptions& options, Diagnostics& diagnostics) {
  if (!format.is_written()) {
    diagnostics.add(Code::kFormatIsReadOnly, {format.title});
    return std::nullopt;
  }
  std::optional<Written> written = format.write(base, rig, options, diagnostics);
  if (!written) return std::nullopt;
  for (const Written::File& file : written->files) {
    if (file.document.edited()) add_lost_comments(file.document, written->losses);
  }
  const Message why = format.many_cameras ? Message{Code::kSeveralFilesBecomeOne} : Message{};
  for (const text::Document& document : options.joined)
    add_rewritten(document, written->files.front().document, why, written->losses);
  // In a fresh file of one lens alone stands no pose, and no name of a camera.
  const bool says_more = format.many_cameras || base != nullptr || !rig.poses.empty();
  for (Written::File& file : written->files) {
    if (says_more) file.says = read_back(format, file, rig, *written);
  }
  written->poses = poses_in(format, *written);
  if (rig.rectified && rig.rectified->sources.empty() && !written->states_rectification) {
    const RectifiedPair& pair = *rig.rectified;
    written->losses.push_back(lost(Code::kRectificationDropped, pair.views[0].camera, "",
                                   {pair.views[1].camera, pair.focal_lengths[0], std::abs(pair.offset_m),
                                    Message{Code::kFilesHaveNoPlace, {format.title}}}));
  }
  const std::vector<Loss> poses = lost_poses(format, rig, *written);
  written->losses.insert(written->losses.end(), poses.begin(), poses.end());
  return written;
}

}  // namespace fca
