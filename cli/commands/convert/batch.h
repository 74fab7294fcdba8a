// SPDX-License-Identifier: BSD-3-Clause
// Several inputs converted at the same time. What came of them waits in a spool until all are converted, so that memory does
// not grow with their number.
#pragma once

#include "finished.h"
#include "output_names.h"
#include "shell/calibration_files.h"
#include "shell/held_interrupt.h"
#include "shell/spool.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace fca::cli {

/// Few inputs have their reports; many have a line each in the table, and --json has everything.
[[nodiscard]] bool is_reported_in_full(std::size_t inputs);

class Batch {
 public:
  using OnFinished = std::function<void(const Finished& finished)>;

  /// All but `console` are to live as long as the batch.
  Batch(const std::vector<FoundFile>& inputs, const ConvertArguments& arguments, const TypedOptions& typed, const Files& known,
        Console& console);

  /// Converts every input (with --join: all as one), arguments.jobs at the same time, until the interrupt. With `on_finished`
  /// each is reported, and not kept, as soon as all before it are.
  void convert(const HeldInterrupt& interrupt, const OnFinished& on_finished);

  /// Inputs with a result, good or bad.
  [[nodiscard]] std::size_t converted() const { return converted_; }
  /// Files met in folders, or by patterns, that hold no camera.
  [[nodiscard]] std::size_t skipped() const { return skipped_; }
  /// Not tried: Ctrl-C.
  [[nodiscard]] std::size_t left() const { return entries_.size() - converted_ - skipped_; }
  [[nodiscard]] bool is_in_full() const { return is_reported_in_full(entries_.size()); }

  /// The next ones that were converted, in the order of the inputs, each once: one more while they have fewer than that many
  /// files. None: all are taken.
  [[nodiscard]] std::vector<Finished> take(std::size_t files);

  /// Refuses before anything is written that two outputs have one path.
  [[nodiscard]] bool collide();
  /// --opencv-model without a file that it could be about, in words.
  [[nodiscard]] std::optional<std::string> opencv_model_problem() const;
  /// Which of the request's accepted reasons are reasons of some input.
  [[nodiscard]] const std::vector<bool>& used_acceptances() const { return used_; }

  [[nodiscard]] Spool& spool() { return spool_; }

 private:
  /// Inputs that are converted together.
  struct Group;
  enum class State : std::uint8_t { kLeft, kSkipped, kKept, kReported };
  struct Entry {
    Spool::Piece piece;
    State state = State::kLeft;
  };
  struct Whole {
    ConvertOutcome outcome;
    std::vector<text::Source> sources;
  };

  [[nodiscard]] Group group(std::size_t index) const;
  void convert_one(std::size_t index, const OnFinished& on_finished);
  void note(std::size_t index, const ConvertOutcome& outcome);
  /// Those that are next, as far as they are converted.
  void report_finished(const OnFinished& on_finished);
  [[nodiscard]] std::string how_to_part() const;

  const std::vector<FoundFile>& inputs_;
  const ConvertArguments& arguments_;
  const TypedOptions& typed_;
  const Files& known_;  ///< What was parsed of the inputs already.
  Console& console_;
  ConvertArguments each_;  ///< Of one input, but for its files.
  TypedOptions options_;   ///< Those of the typed ones that are no input.
  Spool spool_;
  std::mutex mutex_;
  std::vector<Entry> entries_;
  std::map<std::size_t, Whole> whole_;  ///< Of a few inputs, for their reports.
  OutputNames names_;
  std::size_t next_ = 0;  ///< To be taken or reported.
  std::size_t converted_ = 0;
  std::size_t skipped_ = 0;
  std::size_t first_ = std::numeric_limits<std::size_t>::max();  ///< That was converted.
  const Format* first_format_ = nullptr;
  std::string first_extension_;
  bool has_several_files_ = false;  ///< With cameras, of one input.
  bool may_be_opencv_ = false;      ///< An input, or what is written.
  std::vector<bool> used_;
};

}  // namespace fca::cli
