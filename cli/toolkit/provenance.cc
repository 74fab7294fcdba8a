// SPDX-License-Identifier: BSD-3-Clause
#include "provenance.h"

#include "shell/words.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/text/top_comment.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include <sys/types.h>

#include <sha2.h>

namespace fca::cli {

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

/// Is it a line that lines_for() makes?
bool is_ours(std::string_view line) {
  return line.starts_with(kFirstWords) || line.starts_with(kCommand) || line.find(kHash) != std::string_view::npos ||
         line.find(kKept) != std::string_view::npos ||
         (line.find(kArrow) != std::string_view::npos && line.find(kRms) != std::string_view::npos);
}

/// "cam0: ds -> kb4, rms 0.000232 px, max 0.00129 px up to 97.5 deg from the axis"
std::string camera_line(const CameraOutcome& camera, bool other_images) {
  const std::string from(model_info(camera.source.model).id);
  const std::string to(model_info(camera.target.model).id);
  std::string text = camera.name_in_words() + ": ";
  if (camera.source.model == camera.target.model)
    return text + to + ", " + std::string(kKept) + (other_images ? " for the changed images" : "");
  if (!camera.report) return text + from + std::string(kArrow) + to;
  const Judgement& j = camera.report->judgement;
  return text + from + std::string(kArrow) + to + (camera.report->exact ? ", exact" : "") + std::string(kRms) +
         pixels(j.error.rms) + " px, max " + pixels(j.error.max) + " px up to " +
         text::format_short(camera.report->scored_to_deg, 4) + " deg from the axis";
}

/// The command's words without what says only where the file goes and how it is told: the same conversion gives the same file.
std::string command(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 5> kOfNoMatter = {"--json", "--force", "--fsync", "--dry-run", "--provenance"};
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "-o" || word == "--output") {
      ++i;
    } else if (!(word.starts_with("-o") || word.starts_with("--output=")) &&
               std::ranges::find(kOfNoMatter, word) == kOfNoMatter.end()) {
      text += (text.empty() ? "" : " ") + shell_word(word);
    }
  }
  return text;
}

std::vector<std::string> lines_for(const Written::File& file, const ConvertArguments& arguments, const Calibration& calibration,
                                   const ConvertOutcome& outcome) {
  std::vector<std::string> lines = {std::string(kFirstWords) + FCA_VERSION + " from"};
  for (const text::Document& document : calibration.documents) {
    const text::Source& source = document.source();
    const std::string name = source.name == "-" ? "standard input" : std::filesystem::path(source.name).filename().string();
    lines.push_back("  " + name + std::string(kHash) + sha256(source.bytes));
  }
  // What the base said of itself goes; what it was does not.
  if (!arguments.into.empty()) {
    const std::string name = std::filesystem::path(arguments.into).filename().string();
    lines.push_back("  into " + name + std::string(kHash) + sha256(file.document.source().bytes));
  }
  lines.push_back(std::string(kCommand) + command(arguments.words));
  for (const CameraOutcome& camera : outcome.cameras) {
    if (std::ranges::find(file.cameras, camera.source.name) != file.cameras.end())
      lines.push_back(camera_line(camera, changes_images(arguments.reading)));
  }
  return lines;
}

bool is_input(const text::Document& document, const Calibration& calibration) {
  return std::ranges::any_of(calibration.documents, [&document](const text::Document& input) {
    return input.source().bytes == document.source().bytes;
  });
}

}  // namespace

void add_provenance(const ConvertArguments& arguments, const Calibration& calibration, ConvertOutcome& outcome) {
  for (Written::File& file : outcome.written.files) {
    const bool of_base = !arguments.into.empty() || is_input(file.document, calibration);
    // What it said of the file as it was does not hold for one that is edited.
    const bool outdated = of_base && (file.document.edited() || arguments.no_provenance);
    const bool replaces = outdated && text::remove_top_comment(file.document, is_ours);
    if (arguments.no_provenance || (of_base && !arguments.provenance && !replaces)) continue;
    if (text::add_top_comment(file.document, lines_for(file, arguments, calibration, outcome)) || !arguments.provenance)
      continue;
    outcome.diagnostics.note("provenance-not-written",
                             file.document.syntax() == text::Syntax::kWords
                                 ? "--provenance: the comment at the beginning of the file has no room for it"
                                 : "--provenance: JSON has no comments that could hold it");
  }
}

}  // namespace fca::cli
