// SPDX-License-Identifier: BSD-3-Clause
// How it is decided whether to use a file, for all that print or return a verdict.
#pragma once

#include <fca/formats/check.h>
#include <fca/formats/proof.h>
#include <fca/formats/verdict_value.h>
#include <fca/rectify/vertical_disparity.h>
#include <fca/rig/contradictions.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca {

/// The calibration's own uncertainty of a camera whose covariance is known: one standard deviation of its pixels, the root mean
/// square over the image.
struct OwnUncertainty {
  std::string camera;  ///< By its name in the rig.
  double rms_px = 0.0;
};

/// All that is known of a written file, or of one that is evaluated as it is.
struct VerdictFacts {
  const Format* to = nullptr;                ///< Of the file.
  std::string_view mode = {};                ///< Of `to`'s modes, that it is for.
  std::span<const ProofResult> proofs = {};  ///< Of each file the program that it is for comes first.
  bool is_read = true;                       ///< False: its findings say why it cannot be read; all errors count.
  bool is_asked = true;                      ///< False: no program was asked on purpose.
  bool has_reader = true;                    ///< False: of some file no program is known that reads it.
  std::string_view not_for = {};             ///< The format's own program, where nobody asked for the one that is written for.
  bool is_named = false;  ///< That program was asked for, so that a file which only others read is not to be used.
  std::span<const Loss> losses = {};
  std::span<const DefaultedValue> defaults = {};
  std::span<const Finding> findings = {};        ///< About the meaning of what the file specifies (findings_about_meaning).
  const Rig* rig = nullptr;                      ///< As read, for its contradictions.
  std::span<const PoseEdge> written_poses = {};  ///< That the written files specify, by its cameras' names; empty: none are.
  const Contradiction* outvoted = nullptr;       ///< That of the pose that was left out of what is written, if one was.
  /// Of each written file the cameras of the rig that it holds; empty: nothing is written, all count.
  std::span<const std::vector<std::string>> files = {};
  const PairError* pair = nullptr;                     ///< Of a stereo pair among the written cameras; null: there is none.
  std::span<const OwnUncertainty> uncertainties = {};  ///< An error below that is no reason for care.
  double outside_lens = 0.0;  ///< The share of the image that the lens as it was given leaves out, of the camera with most.
  std::span<const Acceptance> accepted = {};
};

/// By pixels alone.
[[nodiscard]] VerdictWord word_of(const PixelDistance& distance);

[[nodiscard]] Verdict decide(const VerdictFacts& facts);

/// Does a program of the format, started in that mode, miss what was lost? If not it is a detail: a topic, an identity matrix,
/// an IMU next to a format of lenses.
[[nodiscard]] bool matters(const Loss& loss, const Format& to, std::string_view mode);

}  // namespace fca
