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

constexpr std::string_view kFirstWords = "Written by fca-io ";
constexpr std::string_view kHash = ", SHA-256 ";
constexpr std::string_view kCommand = "by fca-io ";
constexpr std::string_view kArrow = " -> ";
constexpr std::string_view kRms = ", rms ";
constexpr std::string_view kKept = "the input's parameters";

/// True for a line that lines_for() makes.
bool is_ours(std::string_view line) {
  return line.starts_with(kFirstWords) || line.starts_with(kCommand) || line.find(kHash) != std::string_view::npos ||
         line.find(kKept) != std::string_view::npos ||
         (line.find(kArrow) != std::string_view::npos && line.find(kRms) != std::string_view::npos);
}

/// The line of one camera: "cam0: ds -> kb4, rms 0.000232 px, max 0.00129 px up to 97.5 deg from the axis"
std::string camera_line(const ConvertedCamera& camera, bool other_images) {
  const std::string from(camera.source.lens_id());
  const std::string to(camera.target.lens_id());
  std::string text = name_in_words(camera) + ": ";
  if (camera.source.model == camera.target.model)
    return text + to + ", " + std::string(kKept) + (other_images ? " for the changed images" : "");
  if (!camera.report) return text + from + std::string(kArrow) + to;
  const ErrorStatistics& j = camera.report->statistics;
  const std::string where = camera.source.rays.empty() ? "" : " at its " + std::to_string(camera.source.rays.size()) + " rays";
  return text + from + std::string(kArrow) + to + (camera.report->exact ? ", exact" : "") + std::string(kRms) +
         pixels(j.error.rms) + " px, max " + pixels(j.error.max) + " px" + where + " up to " +
         text::format_short(camera.report->scored_to_deg, 4) + " deg from the axis";
}

/// The file's name, "camchain.yaml", with its folder, "cam0/sensor.yaml", if several documents have the same name.
std::string name_among(const std::vector<text::Document>& documents, const text::Document& document) {
  const std::filesystem::path path = document.source().name;
  const auto same = std::ranges::count_if(documents, [&path](const text::Document& each) {
    return std::filesystem::path(each.source().name).filename() == path.filename();
  });
  const bool is_apart = same > 1 && path.has_parent_path();
  return (is_apart ? path.parent_path().filename() / path.filename() : path.filename()).string();
}

std::vector<std::string> lines_for(const Written::File& file, const ConvertRequest& request, const Calibration& calibration,
                                   const ConvertResult& result) {
  std::vector<std::string> lines = {std::string(kFirstWords) + FCA_VERSION + " from"};
  for (const text::Document& document : calibration.documents) {
    const text::Source& source = document.source();
    lines.push_back("  " + name_among(calibration.documents, document) + std::string(kHash) + sha256(source.bytes));
  }
  // The comment that the base had is replaced; its name and hash are in the new one.
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
    if (file.of_defaults && file.programs.empty()) continue;  // a file of defaults that no program reads
    const bool of_base = !request.into.empty() || is_input(file.document, calibration);
    // A comment that fca-io wrote earlier describes the file before this edit: it is no longer true.
    const bool outdated = of_base && (file.document.edited() || in_none);
    const bool replaces = outdated && text::remove_top_comment(file.document, is_ours);
    if (in_none || (of_base && !in_all && !replaces)) continue;
    if (text::add_top_comment(file.document, lines_for(file, request, calibration, result)) || !in_all) continue;
    const bool words = file.document.syntax() == text::Syntax::kWords;
    const bool binary = file.document.syntax() == text::Syntax::kBinary;
    const Code why = words ? Code::kProvenanceHasNoRoom : binary ? Code::kProvenanceInBinary : Code::kProvenanceInJson;
    result.diagnostics.add(why);
  }
}

}  // namespace fca
