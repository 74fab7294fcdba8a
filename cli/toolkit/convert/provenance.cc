// SPDX-License-Identifier: BSD-3-Clause
#include "provenance.h"

#include "words.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/top_comment.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include <sys/types.h>

#include <sha2.h>

namespace fca {

namespace {

/// The SHA-256 of the bytes as 64 hexadecimal digits.
std::string sha256(const std::string& bytes) {
  std::array<std::uint8_t, SHA256_DIGEST_LENGTH> digest{};
  SHA2_CTX context;
  SHA256Init(&context);
  SHA256Update(&context, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  SHA256Final(digest.data(), &context);
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const unsigned byte : digest) {
    text += kDigits[byte >> 4u];
    text += kDigits[byte & 15u];
  }
  return text;
}

// Fixed parts of the lines of a comment. is_ours() recognises the lines of earlier comments by them.
constexpr std::string_view kFirstWords = "Written by fca-io ";
constexpr std::string_view kHash = ", SHA-256 ";
constexpr std::string_view kCommand = "by fca-io ";
constexpr std::string_view kArrow = " -> ";
constexpr std::string_view kRms = ", rms ";
constexpr std::string_view kKept = "the input's parameters";

/// True if lines_for() of this or an earlier version may have written the line.
bool is_ours(std::string_view line) {
  return line.starts_with(kFirstWords) || line.starts_with(kCommand) || line.find(kHash) != std::string_view::npos ||
         line.find(kKept) != std::string_view::npos ||
         (line.find(kArrow) != std::string_view::npos && line.find(kRms) != std::string_view::npos);
}

/// The line about one camera: "cam0: ds -> kb4, rms 0.000232 px, max 0.00129 px up to 97.5 deg from the axis". `other_images`:
/// the request changed the images.
std::string camera_line(const ConvertedCamera& camera, bool other_images) {
  const std::string from(camera.source.lens_id());
  const std::string to(camera.target.lens_id());
  std::string text = name_in_words(camera) + ": ";
  if (camera.source.model == camera.target.model)
    return text + to + ", " + std::string(kKept) + (other_images ? " for the changed images" : "");
  if (!camera.report) return text + from + std::string(kArrow) + to;
  const ErrorStatistics& statistics = camera.report->statistics;
  const std::string where = camera.source.rays.empty() ? "" : " at its " + std::to_string(camera.source.rays.size()) + " rays";
  return text + from + std::string(kArrow) + to + (camera.report->exact ? ", exact" : "") + std::string(kRms) +
         pixels(statistics.error.rms) + " px, max " + pixels(statistics.error.max) + " px" + where + " up to " +
         text::format_short(camera.report->scored_to_deg, 4) + " deg from the axis";
}

/// The name of the document's file: "camchain.yaml". If several documents have the same name, with its folder:
/// "cam0/sensor.yaml".
std::string name_among(const std::vector<text::Document>& documents, const text::Document& document) {
  const std::filesystem::path path = document.source().name;
  const auto of_same_name = std::ranges::count_if(documents, [&path](const text::Document& each) {
    return std::filesystem::path(each.source().name).filename() == path.filename();
  });
  const bool needs_folder = of_same_name > 1 && path.has_parent_path();
  return (needs_folder ? path.parent_path().filename() / path.filename() : path.filename()).string();
}

/// The lines of the comment in that file.
std::vector<std::string> lines_for(const Written::File& file, const ConvertRequest& request, const Calibration& calibration,
                                   const ConvertResult& result) {
  std::vector<std::string> lines = {std::string(kFirstWords) + FCA_VERSION + " from"};
  for (const text::Document& document : calibration.documents) {
    const text::Source& source = document.source();
    lines.push_back("  " + name_among(calibration.documents, document) + std::string(kHash) + sha256(source.bytes));
  }
  // The new comment replaces one that the file of --into had, and contains the name and hash of that file.
  if (!request.into.empty()) {
    const std::string name = std::filesystem::path(request.into).filename().string();
    lines.push_back("  into " + name + std::string(kHash) + sha256(file.document.source().bytes));
  }
  if (!request.made_by.empty()) lines.push_back(std::string(kCommand) + request.made_by);
  for (const ConvertedCamera& camera : result.cameras) {
    if (std::ranges::find(file.cameras, camera.source.name) != file.cameras.end())
      lines.push_back(camera_line(camera, !request.inputs.change.changes_nothing()));
  }
  return lines;
}

/// True if the document was read as a part of the input.
bool is_input(const text::Document& document, const Calibration& calibration) {
  return std::ranges::any_of(calibration.documents, [&document](const text::Document& input) {
    return input.source().bytes == document.source().bytes;
  });
}

}  // namespace

void add_provenance(const ConvertRequest& request, const Calibration& calibration, Written& written, ConvertResult& result) {
  const bool in_all = request.provenance == ProvenanceComment::kInAllFiles;
  const bool in_none = request.provenance == ProvenanceComment::kNone;
  for (Written::File& file : written.files) {
    if (file.of_defaults && file.programs.empty()) continue;  // no program reads these default values
    const bool has_base = !request.into.empty() || is_input(file.document, calibration);
    // A comment of an earlier conversion describes the file before this edit.
    const bool is_outdated = has_base && (file.document.edited() || in_none);
    const bool replaces = is_outdated && text::remove_top_comment(file.document, is_ours);
    if (in_none || (has_base && !in_all && !replaces)) continue;
    if (text::add_top_comment(file.document, lines_for(file, request, calibration, result)) || !in_all) continue;
    const bool is_plain_text = file.document.syntax() == text::Syntax::kWords;
    const bool is_binary = file.document.syntax() == text::Syntax::kBinary;
    const Code why = is_plain_text ? Code::kProvenanceHasNoRoom
                     : is_binary   ? Code::kProvenanceInBinary
                                   : Code::kProvenanceInJson;
    result.diagnostics.add(why);
  }
}

}  // namespace fca
