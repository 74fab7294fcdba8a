// SPDX-License-Identifier: BSD-3-Clause
// The options of one command. Each is defined once: its name, its help, and what it sets in the command's request.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace fca::cli {

/// Takes a typed word over into a request. Returns what is wrong with it, in a sentence; nothing if it is taken.
using TakeWord = std::function<std::optional<std::string>(const std::string& word)>;

/// A word that cannot be taken, as TakeWord explains it.
struct UsageProblem {
  std::string sentence;
};

/// Finishes a request when all words are taken. Returns what is wrong with them together, in a sentence; nothing if all is
/// well.
using FinishRequest = std::function<std::optional<std::string>()>;

/// An option that code asks for among those that were typed.
enum class OptionKey : std::uint8_t { kOther, kCameras, kModel, kJson, kJsonLines };

/// An option as it was typed, once: one that came several times is several.
struct TypedOption {
  std::string name;  ///< "--to"; of positional words "FILE".
  OptionKey key = OptionKey::kOther;
  std::optional<std::string> value = {};  ///< Nothing: a flag.
  bool positional = false;
  bool about_output = false;  ///< It does not change the written file.
};

using TypedOptions = std::vector<TypedOption>;

/// What an option is about. The help shows them in this order.
enum class OptionGroup : std::uint8_t { kTarget, kReading, kLens, kProof, kOutput };

class Options {
 public:
  /// With the words of a command line only those options are defined that one of them may name: to define all takes as long as
  /// reading a file. Without, all are.
  explicit Options(CLI::App& command, std::optional<std::vector<std::string>> words = {});

  /// What the options that follow are about.
  void group(OptionGroup group);

  /// Words without a name in front, such as files.
  void positional(const std::string& name, const std::string& help, std::vector<std::string>& target, bool required = true);
  /// One such word.
  void one_positional(const std::string& name, const std::string& help, std::vector<std::string>& target, bool required = true);

  /// An option with one value.
  void value(const std::string& name, const std::string& type, const std::string& help, TakeWord take,
             OptionKey key = OptionKey::kOther);
  void value(const std::string& name, const std::string& type, const std::string& help, std::string& target);
  /// A plain decimal number ("0x61" is none).
  void number(const std::string& name, const std::string& type, const std::string& help, std::optional<double>& target);
  void number(const std::string& name, const std::string& type, const std::string& help,
              std::function<std::optional<std::string>(double)> take);
  void whole_number(const std::string& name, const std::string& type, const std::string& help,
                    std::function<std::optional<std::string>(int)> take);
  void count(const std::string& name, const std::string& type, const std::string& help, std::size_t& target, int least,
             int most);
  /// An option that may come several times, with one value each time.
  void each(const std::string& name, const std::string& type, const std::string& help, TakeWord take);
  void each(const std::string& name, const std::string& type, const std::string& help, std::vector<std::string>& target);

  void flag(const std::string& name, const std::string& help, bool& target, OptionKey key = OptionKey::kOther);
  /// A flag that may come several times.
  void count(const std::string& name, const std::string& help, int& target);
  /// A flag that sets `target` to false, next to its opposite, which is the default.
  void flag_pair(const std::string& on, const std::string& on_help, const std::string& off, const std::string& off_help,
                 bool& target);

  struct Flag {
    std::string name;
    std::string help;
    std::function<void()> take;
  };
  /// Flags of which one can be given; else that is a usage error, in those words.
  void exclusive_flags(const std::vector<Flag>& flags, const std::string& problem);

  /// Options that are understood, for a better refusal, and not shown.
  void hide(const std::vector<std::string>& names);
  /// After the list of options: examples.
  void footer(const std::string& text);

  /// What is done when all words are taken, in the order of these calls.
  void afterwards(FinishRequest finish) { finish_.push_back(std::move(finish)); }
  /// Does it. The first problem ends it.
  [[nodiscard]] std::optional<std::string> finish() const;

  /// No option takes an empty value, a script's unset variable. To be called after the last definition.
  void refuse_empty_values();
  /// Those that were given, in their order.
  [[nodiscard]] TypedOptions typed() const;
  /// Was the flag given, as far as the words were parsed?
  [[nodiscard]] bool has_flag(OptionKey key) const;
  /// The words that options begin with: "--to"; also of those that no word names.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  [[nodiscard]] OptionKey key_of(const CLI::Option* option) const;
  /// Remembers an option of those names ("-o,--output"). Is it to be defined?
  [[nodiscard]] bool add_names(const std::string& names);

  CLI::App& command_;
  std::optional<std::vector<std::string>> words_;  ///< Nothing: every option may be named.
  std::vector<std::string> names_;
  std::map<const CLI::Option*, OptionKey> keys_;
  std::vector<FinishRequest> finish_;
};

}  // namespace fca::cli
