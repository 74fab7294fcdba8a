// SPDX-License-Identifier: BSD-3-Clause
#include "batch.h"

#include "options/target.h"
#include "shell/progress.h"
#include "toolkit/parallel_for.h"

#include <fca/code.h>
#include <fca/toolkit/inputs.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

namespace fca::cli {

struct Batch::Group {
  std::string path;  ///< As it was found: a file, or the folder of a rig.
  std::string name;  ///< The first file; of a folder that is one rig the folder.
  std::vector<std::string> files;
  bool named = true;  ///< By the user; false: met in a folder or by a pattern.
  bool join = false;  ///< Its files are one rig.
};

namespace {

namespace fs = std::filesystem;

bool holds_no_camera(const ConvertOutcome& outcome) {
  return std::ranges::any_of(outcome.diagnostics.entries(), [](const Diagnostic& entry) {
    constexpr std::array kHoldsNone = {Code::kAnyUnknownFormat, Code::kNothingToConvert, Code::kAnyNoCalibration};
    return same_id(code_of(entry), kHoldsNone);
  });
}

/// Next to the outputs, where there is room for them; where none are written, where temporary files are.
std::string spool_folder(const ConvertArguments& arguments) {
  std::error_code error;  // what cannot be asked is no folder
  if (arguments.dry_run || !arguments.output.holds_many()) return fs::temp_directory_path(error).string();
  for (fs::path folder = arguments.output.path; !folder.empty() && folder != folder.parent_path();
       folder = folder.parent_path()) {
    if (fs::is_directory(folder, error)) return folder.string();
  }
  return arguments.output.path.starts_with('/') ? "/" : ".";
}

}  // namespace

bool is_reported_in_full(std::size_t inputs) {
  constexpr std::size_t kMost = 8;
  return inputs <= kMost;
}

Batch::Batch(const std::vector<FoundFile>& inputs, const ConvertArguments& arguments, const TypedOptions& typed,
             const Files& known, Console& console)
    : inputs_(inputs),
      arguments_(arguments),
      typed_(typed),
      known_(known),
      console_(console),
      each_(arguments),
      spool_(spool_folder(arguments)),
      entries_(arguments.request.inputs.join ? std::min<std::size_t>(inputs.size(), 1) : inputs.size()),
      used_(arguments.request.accepted.size()) {
  each_.inputs.clear();
  each_.one_input = entries_.size() == 1;
  if (entries_.size() > 1) each_.request.jobs = 1;
  std::ranges::copy_if(typed, std::back_inserter(options_), [](const TypedOption& option) { return !option.positional; });
}

Batch::Group Batch::group(std::size_t index) const {
  const bool join = arguments_.request.inputs.join;
  const FoundFile& first = inputs_[index];
  Group group = {first.path, rig_name(first.path), {}, first.named, join};
  const std::size_t end = join ? inputs_.size() : index + 1;
  for (std::size_t i = index; i < end; ++i) {
    const std::vector<std::string> files = rig_files_in(inputs_[i].path);
    group.join = group.join || !files.empty();
    group.files.insert(group.files.end(), files.begin(), files.end());
    if (files.empty()) group.files.push_back(inputs_[i].path);
  }
  return group;
}

void Batch::convert(const HeldInterrupt& interrupt, const OnFinished& on_finished) {
  const bool is_watched = on_finished && console_.streams().out.is_terminal();  // the reports show how far it is
  Progress progress(entries_.size(), console_.streams().err);
  parallel_for(entries_.size(), arguments_.request.jobs, [&](std::size_t i) {
    if (interrupt.asked()) return;
    convert_one(i, on_finished);
    if (!is_watched) progress.step();
  });
  for (auto& [index, whole] : whole_) {
    for (text::Source& source : whole.sources) console_.files().remember(std::move(source));
  }
}

void Batch::convert_one(std::size_t index, const OnFinished& on_finished) {
  const Group group = this->group(index);
  ConvertArguments arguments = each_;
  arguments.request.inputs.files = group.files;
  arguments.request.inputs.join = group.join;
  // The command that converts that group alone.
  TypedOptions typed = {{.name = "INPUT", .value = group.path, .positional = true}};
  typed.insert(typed.end(), options_.begin(), options_.end());
  CommandFiles files(console_.streams());
  files.know_documents_of(known_);
  ConvertOutcome outcome = convert_input(group.name, arguments, entries_.size() > 1 ? typed : typed_, files);
  if (!group.named && holds_no_camera(outcome)) {
    const std::scoped_lock lock(mutex_);
    ++skipped_;
    entries_[index].state = State::kSkipped;
    return report_finished(on_finished);
  }
  const Finished result = finished(outcome, arguments_, files.sources(), console_);
  const std::scoped_lock lock(mutex_);
  note(index, outcome);
  if (is_in_full() && !arguments_.json) whole_.emplace(index, Whole{std::move(outcome), files.sources()});
  if (on_finished && index == next_) {
    on_finished(result);
    entries_[index].state = State::kReported;
  } else {
    entries_[index] = {spool_.put(packed(result)), State::kKept};
  }
  report_finished(on_finished);
}

void Batch::note(std::size_t index, const ConvertOutcome& outcome) {
  ++converted_;
  for (const ConvertedFile& file : outcome.files) {
    if (!file.path.empty()) names_.add(index, file.path);
  }
  if (index < first_) {
    first_ = index;
    first_format_ = outcome.from;
    if (outcome.to != nullptr)
      first_extension_ = outcome.files.empty() ? outcome.to->extension : extension_of(outcome.files.front(), *outcome.to);
  }
  has_several_files_ = has_several_files_ || camera_files(outcome.files) > 1;
  may_be_opencv_ = may_be_opencv_ || has_use_for_opencv_model(outcome);
  for (std::size_t i = 0; i < used_.size(); ++i) {
    const Acceptance& accepted = arguments_.request.accepted[i];
    used_[i] = used_[i] || std::ranges::any_of(outcome.verdict.reasons, [&accepted](const Reason& reason) {
                 return accepted.covers(reason) && (reason.is_accepted || !may_be_accepted(reason));
               });
  }
}

void Batch::report_finished(const OnFinished& on_finished) {
  for (; on_finished && next_ < entries_.size() && entries_[next_].state != State::kLeft; ++next_) {
    if (entries_[next_].state != State::kKept) continue;
    on_finished(unpacked(spool_.take(entries_[next_].piece)));
  }
}

std::vector<Finished> Batch::take(std::size_t files) {
  std::vector<Finished> taken;
  for (std::size_t count = 0; next_ < entries_.size() && std::max(count, taken.size()) < files; ++next_) {
    if (entries_[next_].state != State::kKept) continue;
    Finished& finished = taken.emplace_back(unpacked(spool_.take(entries_[next_].piece)));
    count += finished.files.size();
    const auto whole = whole_.find(next_);
    if (whole == whole_.end()) continue;
    finished.whole = std::move(whole->second.outcome);
    finished.whole->one_of_many = converted_ > 1;
  }
  return taken;
}

bool Batch::collide() {
  std::map<std::string, std::string> inputs;  // by the path of their output
  for (const std::size_t suspect : names_.suspects()) {
    const Finished finished = unpacked(spool_.look(entries_[suspect].piece));
    for (const OutputFile& output : finished.files) {
      if (output.path.empty()) continue;
      const auto [first, is_new] = inputs.insert({output.path, finished.input});
      if (is_new) continue;
      const std::string of = first->second == finished.input ? "two outputs of " + finished.input
                                                             : "the outputs of " + first->second + " and " + finished.input;
      static_cast<void>(console_.refuse(ExitCode::kUsage, of + " would be written to " + output.path, how_to_part()));
      return true;
    }
  }
  return false;
}

/// A pattern that gives each output a path of its own, from the parts of the inputs' names that differ.
std::string Batch::how_to_part() const {
  for (const std::string_view names : {"{stem}", "{stem}.{extension}", "{folder}.{stem}", "{folder}.{stem}.{extension}"}) {
    std::set<std::string> paths;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (entries_[i].state == State::kKept) paths.insert(with_names_of(group(i).name, "", std::string(names)));
    }
    if (paths.size() == converted_) {
      return "use a pattern such as -o 'out/" + std::string(names) + (has_several_files_ ? ".{camera}" : "") +
             first_extension_ + "'";
    }
  }
  return "convert them one by one, each with an -o of its own";
}

std::optional<std::string> Batch::opencv_model_problem() const {
  const Inputs& inputs = arguments_.request.inputs;
  if (!inputs.opencv_model || !inputs.parts.empty() || may_be_opencv_ || converted_ == 0) return std::nullopt;
  return opencv_model_without_use(group(first_).name, *first_format_);
}

}  // namespace fca::cli
