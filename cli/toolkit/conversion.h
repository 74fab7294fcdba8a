// SPDX-License-Identifier: BSD-3-Clause
// One input converted: read, fitted, written in memory, proven. Nothing is put in place here.
#pragma once

#include "choose_model.h"
#include "options/writing_options.h"
#include "reading.h"
#include "shell/console.h"

#include <fca/formats/calibration.h>
#include <fca/formats/proof.h>

#include <optional>
#include <string>
#include <vector>

namespace fca::cli {

struct ConvertArguments : WritingOptions {
  std::vector<std::string> words;  ///< The command line, without the program's name.
  std::vector<std::string> inputs;
  ReadingOptions reading;
  std::string output;
  bool in_place = false;
  std::size_t jobs = 0;  ///< Inputs, or cameras of one input, at the same time; 0: as many as there are processors.
  std::optional<double> max_error_px;
  bool provenance = false;  ///< In edited files, too.
  bool no_provenance = false;
  bool strict = false;
  bool no_verify = false;
  bool force = false;
  bool fsync = false;
  bool dry_run = false;
  bool json = false;
};

/// One input's conversion, for the text and the JSON.
struct ConvertOutcome {
  struct Output {
    std::string path;  ///< Empty: standard output (or the JSON).
    std::string bytes;
    std::vector<std::string> cameras;
    std::vector<std::string> programs;
  };
  std::string input;
  bool one_of_many = false;  ///< Then its report names it.
  bool lens_given = false;   ///< By --max-angle or --lens-circle: shares are of the lens.
  const Format* from = nullptr;
  bool one_format = true;  ///< False: `from` is the first file's, and others joined to it have another.
  const Format* to = nullptr;
  std::vector<CameraOutcome> cameras;
  Written written;
  std::vector<Output> outputs;
  std::vector<ProofResult> proofs;
  std::vector<std::string> unproven;        ///< Outputs that no program was found to judge; "" is standard output.
  std::vector<std::string> refused_before;  ///< Programs that refuse the file as they did before it was edited.
  Diagnostics diagnostics;
  ExitCode code = ExitCode::kGood;
};

/// `inputs`: one, or several that are one rig (--join).
[[nodiscard]] ConvertOutcome convert_inputs(const std::vector<std::string>& inputs, const ConvertArguments& arguments,
                                            Console& console);

}  // namespace fca::cli
