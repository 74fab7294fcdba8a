// SPDX-License-Identifier: BSD-3-Clause
// Private: rows of the table of codes, by what they are.
#pragma once

#include <fca/code.h>

#include <string_view>

namespace fca::diagnostics {

/// Of every loss without a better one.
inline constexpr std::string_view kKeepTheInput = "keep the input, which contains it";

constexpr CodeInfo error(Code code, std::string_view id, std::string_view text, std::string_view fix = {}) {
  return {.code = code, .id = id, .severity = Severity::kError, .about = About::kMeaning, .text = text, .fix = fix};
}

constexpr CodeInfo warning(Code code, std::string_view id, std::string_view text, std::string_view fix = {}) {
  return {.code = code, .id = id, .severity = Severity::kWarning, .about = About::kMeaning, .text = text, .fix = fix};
}

constexpr CodeInfo note(Code code, std::string_view id, std::string_view text, std::string_view fix = {}) {
  return {.code = code, .id = id, .severity = Severity::kNote, .about = About::kMeaning, .text = text, .fix = fix};
}

/// What was asked for and cannot be.
constexpr CodeInfo bad_request(Code code, std::string_view id, std::string_view text, std::string_view fix = {}) {
  return {.code = code, .id = id, .severity = Severity::kError, .about = About::kUse, .text = text, .fix = fix};
}

/// What a file leaves open.
constexpr CodeInfo question(Code code, std::string_view id, std::string_view text, std::string_view why) {
  return {.code = code, .id = id, .severity = Severity::kNote, .about = About::kMeaning, .text = text, .why = why};
}

/// What a target cannot hold.
constexpr CodeInfo loss(Code code, std::string_view id, std::string_view what, std::string_view why,
                        std::string_view fix = kKeepTheInput) {
  return {
      .code = code, .id = id, .severity = Severity::kWarning, .about = About::kMeaning, .text = what, .why = why, .fix = fix};
}

/// Of a key that a program misses.
inline constexpr std::string_view kAddTheKey =
    "add it: copy it from the calibration's result or from the program's example file";

/// Why a program does not run with a file. `fix`: what to do where no other spelling of a value helps.
constexpr CodeInfo refusal(Code code, std::string_view text, std::string_view fix = {}) {
  return {
      .code = code, .id = "program-refuses", .severity = Severity::kError, .about = About::kReader, .text = text, .fix = fix};
}

/// What a program misreads or ignores without a word.
constexpr CodeInfo misreading(Code code, std::string_view text, std::string_view fix = {}) {
  return {.code = code,
          .id = "program-misreads",
          .severity = Severity::kWarning,
          .about = About::kReader,
          .text = text,
          .fix = fix};
}

/// The same of what a program reads from a file.
constexpr CodeInfo about_reader(CodeInfo row) {
  row.about = About::kReader;
  return row;
}

/// The same of where cameras stand: no matter to a file that specifies no poses.
constexpr CodeInfo about_poses(CodeInfo row) {
  row.about = About::kPoses;
  return row;
}

constexpr CodeInfo reader_warning(Code code, std::string_view id, std::string_view text, std::string_view fix = {}) {
  return about_reader(warning(code, id, text, fix));
}

/// The same with what happens if the file is used as it is.
constexpr CodeInfo with_consequence(CodeInfo row, std::string_view consequence) {
  row.consequence = consequence;
  return row;
}

/// The sentence names the program.
constexpr CodeInfo naming(CodeInfo row) {
  row.names_program = true;
  return row;
}

constexpr CodeInfo named_refusal(Code code, std::string_view text, std::string_view fix = {}) {
  return naming(refusal(code, text, fix));
}

constexpr CodeInfo named_misreading(Code code, std::string_view text, std::string_view fix = {}) {
  return naming(misreading(code, text, fix));
}

/// How a program's complaint is fixed: an id and what to do.
constexpr CodeInfo remedy(Code code, std::string_view id, std::string_view text) {
  return {.code = code, .id = id, .severity = Severity::kNote, .about = About::kReader, .text = text};
}

/// Of parts of sentences, which nobody asks for by name.
inline constexpr std::string_view kClauseId = "clause";

/// A part of another sentence, or words for people next to a result.
constexpr CodeInfo clause(Code code, std::string_view text) {
  return {.code = code, .id = kClauseId, .severity = Severity::kNote, .about = About::kMeaning, .text = text};
}

}  // namespace fca::diagnostics
