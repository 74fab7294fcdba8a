// SPDX-License-Identifier: BSD-3-Clause
// Is a calibration sane? What is wrong with it, what happens if it is used, how to fix it, and what could not be decided.
#pragma once

#include <fca/code.h>
#include <fca/formats/calibration.h>
#include <fca/formats/consumers/consumer.h>
#include <fca/formats/proof.h>
#include <fca/formats/verdict_value.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca {

/// Bytes to put in place of others.
struct SpanEdit {
  text::Span span;
  std::string text;
};

/// Something that is, or may be, wrong with a file. fca/formats/wording.h words it.
struct Finding {
  Severity severity = Severity::kError;
  Message facts = {};
  SourceRange where = {};
  std::optional<SpanEdit> edit = {};  ///< Where the fix is certain: another spelling of the same value.
  std::vector<Message> details = {};  ///< Clauses after the sentence.
  Code kind = {};                     ///< Whose id it has, where that is not the sentence's.
  // In place of what the table says besides the sentence: that of another row, or a sentence that is one.
  Message outcome = {};  ///< What happens if the file is used as it is.
  Message remedy = {};   ///< How to fix it.
};

/// Whose id it has.
[[nodiscard]] Code code_of(const Finding& finding);

/// A question the file does not answer.
struct Undecided {
  Message facts = {};
  Code kind = {};  ///< Whose id it has, where that is not the question's.
};

/// What a check came to.
struct CheckReport {
  const Format* format = nullptr;  ///< Null where no format knows the file.
  Message why;                     ///< Why that format; none: it was told.
  bool is_calibration = true;      ///< False: nothing of a calibration stands in the file.
  bool holds_no_camera = false;    ///< It was read, and is another part of a calibration (imu.yaml).
  std::vector<Finding> findings;   ///< In the order of their places.
  std::vector<Message> checked;    ///< Clauses: what the file gave a check to look at.
  std::vector<Undecided> undecided;
  Readers readers;                   ///< Who reads the file.
  bool has_reader = true;            ///< False: its keys are none that a program of ours reads; another may.
  std::optional<ProofResult> proof;  ///< What the program that it is for reads from it; none: no such program, or no camera.
  std::string mode;                  ///< Of that program, which the keys are for.
  Verdict verdict;                   ///< Whether to use the file with that program.
  std::vector<std::string> parts;    ///< Paths of the files that it names as parts of it and that are there.
  [[nodiscard]] bool has(Severity severity) const;
};

struct CheckOptions {
  ReadOptions reading;
  const Format* from = nullptr;                  ///< Null: detected.
  const consumers::Consumer* program = nullptr;  ///< The program the file is meant for; null: the format's own.
  std::optional<double> max_angle_rad;           ///< What counts as lens, from the axis.
  std::vector<Code> ignored;                     ///< Findings with their ids are left out.
  bool parts = false;                            ///< Are the files that it names as parts of it to be looked for, and read?
};

/// Checks one file by itself. The faults of its parts are told by a check of theirs.
[[nodiscard]] CheckReport check_file(const text::Source& source, const CheckOptions& options);

/// What is wrong with the meaning of what a document specifies, of that what `to` holds: sizes, lenses, poses, noise. Programs
/// are not asked. `calibration` was read from the document, and from others perhaps; `diagnostics`: what its readers found.
[[nodiscard]] std::vector<Finding> findings_about_meaning(const text::Document& document, const Calibration& calibration,
                                                          const Diagnostics& diagnostics, const CheckOptions& options,
                                                          const Format& to);

/// Why cv::undistortPoints does not arrive at the camera's rays, to a pixel; nothing where it does, or is not for that model.
[[nodiscard]] std::optional<Message> undistortion_problem(const Camera& camera);

/// Are the noise densities that it has such as sensors have them, also inflated ones?
[[nodiscard]] bool has_usual_noise(const Imu& imu);

/// The file with every fix that is certain, also those that only show when others are made; nothing if there is none. Only
/// spellings change (a decimal point, quotes, a header), no value.
[[nodiscard]] std::optional<text::Source> fixed_source(const text::Source& source, const CheckOptions& options);

/// A row for every id that a finding may have, by id: what is wrong in general, and the consequence and the fix where a finding
/// has nothing more exact to say.
[[nodiscard]] std::span<const CodeInfo> check_codes();
/// Null if there is none.
[[nodiscard]] const CodeInfo* find_check_code(std::string_view id);

}  // namespace fca
