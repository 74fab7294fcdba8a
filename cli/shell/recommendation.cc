// SPDX-License-Identifier: BSD-3-Clause
#include "recommendation.h"

#include "shell/words.h"

#include <fca/formats/text/numbers.h>

namespace fca::cli {

namespace {

std::string in_words(const Candidate& candidate) {
  const ConversionReport& report = candidate.conversion->report;
  const std::string id(candidate.model->id);
  if (report.exact) return id + " (exact)";
  if (!reaches_all(candidate)) {
    return id + " (rms " + pixels(report.statistics.error.rms) + " px, up to " + text::format_short(report.scored_to_deg, 3) +
           " deg from the axis only)";
  }
  const PixelDistance& distance = candidate.decisive();
  return id + " (rms " + pixels(distance.rms) + " px, 99 % within " + pixels(distance.p99) + " px" +
         (candidate.in_circle ? ", with --max-angle " + text::format_short(candidate.in_circle->max_angle_deg) : "") + ")";
}

}  // namespace

std::string recommendation(const std::vector<Candidate>& candidates, const Format* to) {
  const Candidate* best = recommended(candidates, to);
  if (best == nullptr) return "No model could be fitted; the table says why.";
  constexpr double kUseless = 10.0;  // px
  if (!best->conversion->report.exact && best->decisive().rms > kUseless)
    return "No model describes this lens. The nearest is " + in_words(*best) + ".";
  const bool read_by_some = !best->stored_by.empty();
  if (to != nullptr) {
    std::string text = "For " + std::string(to->program) + ": " + in_words(*best) + ".";
    const Candidate* any = recommended(candidates, nullptr);
    if (any != best) text += " Best of all is " + in_words(*any) + ", which it does not read.";
    return text;
  }
  std::string text = best->conversion->report.exact && best->conversion->report.from_model == best->conversion->report.to_model
                         ? "Keep " + std::string(best->model->id) + ": it is exact."
                         : "Take " + in_words(*best) + ".";
  if (!read_by_some) text += " No program that fca-io knows reads it.";
  const Candidate* next = recommended_beside(candidates, *best);
  if (next != nullptr) text += " For a program that does not read it: " + in_words(*next) + ".";
  return text;
}

}  // namespace fca::cli
