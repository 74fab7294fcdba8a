// SPDX-License-Identifier: BSD-3-Clause
#include "batch.h"

#include "shell/progress.h"
#include "shell/verdict_text.h"
#include "shell/words.h"
#include "toolkit/parallel_for.h"

#include <fca/code.h>
#include <fca/toolkit/inputs.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

namespace fca::cli {

namespace {

/// Inputs that are converted together.
struct Group {
  std::string path;  ///< As it was found: a file, or the folder of a rig.
  std::string name;  ///< The first file; of a folder that is one rig the folder.
  std::vector<std::string> files;
  bool named = true;  ///< By the user; false: met in a folder or by a pattern.
  bool join = false;  ///< Its files are one rig.
};

std::vector<Group> groups_of(const std::vector<FoundFile>& inputs, const ConvertArguments& arguments) {
  std::vector<Group> groups;
  for (const FoundFile& file : inputs) {
    const bool join = arguments.request.inputs.join;
    if (groups.empty() || !join) groups.push_back({file.path, rig_name(file.path), {}, file.named, join});
    Group& group = groups.back();
    const std::vector<std::string> files = rig_files_in(file.path);
    group.join = group.join || !files.empty();
    group.files.insert(group.files.end(), files.begin(), files.end());
    if (files.empty()) group.files.push_back(file.path);
  }
  return groups;
}

/// The command that converts that group alone.
TypedOptions command_for(const Group& group, const TypedOptions& typed) {
  TypedOptions own = {{.name = "INPUT", .value = group.path, .positional = true}};
  std::ranges::copy_if(typed, std::back_inserter(own), [](const TypedOption& option) { return !option.positional; });
  return own;
}

bool holds_no_camera(const ConvertOutcome& outcome) {
  return std::ranges::any_of(outcome.diagnostics.entries(), [](const Diagnostic& entry) {
    constexpr std::array kHoldsNone = {Code::kAnyUnknownFormat, Code::kNothingToConvert, Code::kAnyNoCalibration};
    return same_id(code_of(entry), kHoldsNone);
  });
}

/// Of ten thousand conversions only what is still to be written and told is kept.
void forget(ConvertOutcome& outcome) {
  outcome.losses = {};
  outcome.defaults = {};
  outcome.proofs = {};
}

std::string models(const ConvertOutcome& outcome) {
  std::vector<std::string> said;
  for (const ConvertedCamera& camera : outcome.cameras) {
    const std::string from(model_info(camera.source.model).id);
    const std::string to(model_info(camera.target.model).id);
    const std::string one = from == to ? to : from + " -> " + to;
    if (std::ranges::find(said, one) == said.end()) said.push_back(one);
  }
  return enumerated(said);
}

/// The largest of a figure over the cameras, as the program sees them, else of the fit.
std::string largest(const ConvertOutcome& outcome, double ErrorSummary::*figure, double as_program_sees) {
  double most = as_program_sees;
  for (const ConvertedCamera& camera : outcome.cameras) {
    if (as_program_sees == 0.0 && camera.report && !camera.report->exact)
      most = std::max(most, camera.report->judgement.error.*figure);
  }
  constexpr double kNothingPx = 1e-4;
  return most < kNothingPx ? "0" : pixels(most);
}

std::string result(const ConvertOutcome& outcome) {
  for (const Diagnostic& entry : outcome.diagnostics.entries()) {
    if (entry.severity != Severity::kError) continue;
    const bool is_judged = outcome.status == Status::kRejected;
    return (is_judged ? std::string(in_words(VerdictWord::kDoNotUse)) : "error") + ": " + id_of(entry);
  }
  return std::string(in_words(outcome.verdict.word));
}

constexpr std::size_t kGap = 2;
constexpr std::size_t kWidest = 60;  // longer names push their line to the right

struct Line {
  std::string input;
  std::string models;
  std::string rms;
  std::string max;
  std::string result;
};

std::string table(const std::vector<Line>& lines) {
  const auto width = [&lines](std::string Line::*column) {
    std::size_t widest = 0;
    for (const Line& line : lines) widest = std::max(widest, std::min((line.*column).size(), kWidest));
    return widest + kGap;
  };
  const std::size_t input = width(&Line::input);
  const std::size_t model = width(&Line::models);
  const std::size_t rms = width(&Line::rms);
  const std::size_t max = width(&Line::max);
  // A longer text than its column is wide has its gap, too.
  const auto cell = [](const std::string& said, std::size_t wide) { return padded(said + std::string(kGap, ' '), wide); };
  std::string text;
  for (const Line& line : lines) {
    text += cell(line.input, input) + cell(line.models, model) + cell(line.rms, rms) + cell(line.max, max) + line.result + "\n";
  }
  return text;
}

}  // namespace

bool is_told_in_full(std::size_t inputs) {
  constexpr std::size_t kMost = 8;
  return inputs <= kMost;
}

Batch convert_batch(const std::vector<FoundFile>& inputs, const ConvertArguments& arguments, const TypedOptions& typed,
                    const HeldInterrupt& interrupt, const Files& known, Console& console) {
  struct Job {
    std::optional<ConvertOutcome> outcome;
    std::vector<text::Source> sources;  ///< What its diagnostics point into.
  };
  const std::vector<Group> groups = groups_of(inputs, arguments);
  std::vector<Job> jobs(groups.size());
  const bool in_full = arguments.json || is_told_in_full(groups.size());
  Progress progress(groups.size(), console.streams().err);
  parallel_for(groups.size(), arguments.request.jobs, [&](std::size_t i) {
    if (interrupt.asked()) return;
    ConvertArguments each = arguments;
    if (groups.size() > 1) each.request.jobs = 1;
    each.request.inputs.files = groups[i].files;
    each.request.inputs.join = groups[i].join;
    each.one_input = groups.size() == 1;
    CommandFiles files(console.streams());
    files.know_documents_of(known);
    jobs[i].outcome = convert_input(groups[i].name, each, groups.size() > 1 ? command_for(groups[i], typed) : typed, files);
    const Diagnostics& said = jobs[i].outcome->diagnostics;
    if (in_full ? !said.entries().empty() : said.has_errors()) jobs[i].sources = files.sources();
    if (groups.size() > 1 && !in_full) forget(*jobs[i].outcome);
    progress.step();
  });
  Batch batch;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    Job& job = jobs[i];
    if (!job.outcome) {
      ++batch.left;
    } else if (!groups[i].named && holds_no_camera(*job.outcome)) {
      ++batch.skipped;
    } else {
      for (text::Source& source : job.sources) console.files().remember(std::move(source));
      batch.outcomes.push_back(*std::move(job.outcome));
    }
  }
  for (ConvertOutcome& outcome : batch.outcomes) outcome.one_of_many = batch.outcomes.size() > 1;
  return batch;
}

std::string batch_text(const Batch& batch, bool written) {
  std::vector<Line> lines = {{"input", "model", "rms px", "max px", "result"}};
  std::size_t good = 0;
  std::size_t files = 0;
  const std::size_t reached = batch.outcomes.size() - batch.unwritten;
  for (std::size_t i = 0; i < batch.outcomes.size(); ++i) {
    const ConvertOutcome& outcome = batch.outcomes[i];
    lines.push_back({outcome.input, models(outcome),
                     outcome.cameras.empty() ? "" : largest(outcome, &ErrorSummary::rms, outcome.rms_px),
                     outcome.cameras.empty() ? "" : largest(outcome, &ErrorSummary::max, outcome.max_px),
                     i < reached ? result(outcome) : "not written"});
    if (outcome.code != ExitCode::kGood) continue;
    ++good;
    const auto is_file = [](const ConvertedFile& file) { return !file.path.empty(); };
    if (i < reached) files += static_cast<std::size_t>(std::ranges::count_if(outcome.files, is_file));
  }
  VerdictCounts words;
  for (const ConvertOutcome& outcome : batch.outcomes) {
    if (outcome.status <= Status::kRejected) words.add(outcome.verdict.word);
  }
  const std::size_t all = batch.outcomes.size() + batch.left;
  std::string text = "\n" + table(lines) + "\n" + (reached < all ? "interrupted: " : "") + std::to_string(good) + " of " +
                     counted(all, "input") + " converted";
  text += written ? ", " + counted(files, "file") + " written" : ", nothing written (--dry-run)";
  if (batch.skipped > 0)
    text += "; " + counted(batch.skipped, "other file") + (batch.skipped == 1 ? " holds" : " hold") + " no camera";
  return text + "; " + words.in_words() + "\n";
}

}  // namespace fca::cli
