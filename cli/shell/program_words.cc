// SPDX-License-Identifier: BSD-3-Clause
#include "program_words.h"

#include "option_hints.h"
#include "shell/words.h"
#include "verdict_text.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/text/source.h>
#include <fca/formats/wording.h>

#include <algorithm>

namespace fca::cli {

namespace {

/// "cam0: KannalaBrandt8, 512 x 512 px: within 7.3e-05 px of what the file means"
std::string camera_text(const CameraProof& camera) {
  std::string text = camera.name + ": " + camera.model;
  if (camera.width > 0 && camera.height > 0) text += ", " + size_in_words({camera.width, camera.height}) + " px";
  if (camera.compared_share == 0.0) {
    return text + (camera.agrees ? ": no pixels compared, as the file contains no image size (--size WxH)"
                                 : ": it has no pixel where the file means one");
  }
  if (camera.agrees) return text + ": within " + pixels(camera.max_diff_px) + " px of what the file means";
  return text + ": misread, up to " + pixels(camera.max_diff_px) + " px from what the file means";
}

std::string refusal_text(const std::vector<consumers::Complaint>& refusals) {
  constexpr std::size_t kMostSaid = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostSaid, refusals.size()); ++i)
    text += "    " + text::printable(sentence_of(refusals[i], with_options)) + "\n";
  if (refusals.size() > kMostSaid)
    text += "    and " + std::to_string(refusals.size() - kMostSaid) + " more (--json lists them)\n";
  return text;
}

/// What a program sees of a file that it loads.
std::string view_text(const ProofResult& proof, const Rig& rig, bool lens_given) {
  std::string text;
  for (const CameraProof& camera : proof.cameras) text += "    " + camera_text(camera) + "\n";
  std::vector<std::string> unseen;
  for (const Camera& camera : rig.cameras) {
    if (std::ranges::find(proof.cameras, camera.name, &CameraProof::name) == proof.cameras.end()) unseen.push_back(camera.name);
  }
  if (!unseen.empty()) text += "    does not use " + enumerated(unseen, "and") + "\n";
  if (!proof.poses.empty()) {
    text += "    " + enumerated(proof.poses, "and") + ": " +
            (proof.poses_agree ? "as the file means" : "an element is off by " + text::format_short(proof.max_diff_pose, 3)) +
            "\n";
  }
  for (const Message& number : proof.other_numbers) text += "    but: " + text::text_of(number, with_options) + "\n";
  for (const std::string& sentence : misreadings(proof, lens_given)) text += "    but: " + text::printable(sentence) + "\n";
  return text;
}

}  // namespace

std::vector<std::string> misreadings(const ProofResult& proof, bool lens_given) {
  constexpr double kNoticeable = 1e-3;
  const std::string of_image = lens_given ? " of the lens" : " of the image";
  std::vector<std::string> sentences;
  if (proof.unanswered_share > kNoticeable) {
    sentences.push_back("it gives no right pixel for " + percent(proof.unanswered_share) + of_image +
                        ": it cannot project rays so far from the axis");
  }
  if (proof.wrong_ray_share > kNoticeable) {
    sentences.push_back("it gives " + percent(proof.wrong_ray_share) + of_image + " wrong rays, " + pixels(proof.wrong_ray_px) +
                        " px off at worst: " + text::text_of(proof.wrong_ray_why, with_options));
  }
  for (const consumers::Complaint& warning : proof.warnings) sentences.push_back(sentence_of(warning, with_options));
  return sentences;
}

std::string program_reading_text(const ProgramReading& reading, const Calibration& calibration, const std::string& file,
                                 bool lens_given) {
  const std::string program(reading.program->program);
  std::string text = "\nas " + program + " reads it\n";
  if (!reading.reads_format) {
    return text + "  nothing: it does not read the " + std::string(calibration.format->title) + " format\n" +
           "    do: fca-io check " + shell_word(file) + " --for " + std::string(reading.program->id) +
           " (the command that converts it, and what it loses)\n";
  }
  for (const ProgramReading::Mode& mode : reading.modes) {
    const std::string who = mode.names.empty() ? "" : "as " + enumerated(mode.names) + ": ";
    text += "  " + who + (mode.proof.loads ? "loads it; " : "refuses it; ") + std::string(in_words(mode.verdict.word)) + "\n";
    text += mode.proof.loads ? view_text(mode.proof, calibration.rig, lens_given) : refusal_text(mode.proof.refusals);
  }
  return text;
}

}  // namespace fca::cli
