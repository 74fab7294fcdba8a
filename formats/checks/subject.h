// SPDX-License-Identifier: BSD-3-Clause
// Private: what a check looks at and where it puts what it finds.
#pragma once

#include "../places.h"

#include <fca/formats/check.h>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace fca::checks {

/// A file with what was read from it.
struct Subject {
  const text::Document& document;
  const Calibration& calibration;
  const CheckOptions& options;
  Places places;

  [[nodiscard]] const Rig& rig() const { return calibration.rig; }
  [[nodiscard]] bool is(std::string_view format) const { return calibration.format->id == format; }
};

/// Collects findings; a consequence left empty is the code's own.
class Findings {
 public:
  explicit Findings(CheckReport& report) : report_(report) {}
  void add(Finding finding);
  /// As severe as the table says.
  void add(Code code, std::vector<Argument> arguments, SourceRange where);
  void add(Severity severity, Code code, std::vector<Argument> arguments, SourceRange where);
  /// With the edit that certainly fixes it.
  void add(Code code, std::vector<Argument> arguments, SourceRange where, SpanEdit edit);
  /// Of the code's id, there.
  [[nodiscard]] bool has(Code code, const SourceRange& where) const;
  /// The same. Places may take a writer's time: this one is asked for only if there is such a finding anywhere.
  [[nodiscard]] bool has(Code code, const std::function<SourceRange()>& where) const;
  [[nodiscard]] bool has_any(std::span<const Code> codes) const;
  /// More than a note of that camera, whom messages name first; what is found of the file as a whole counts for each.
  [[nodiscard]] bool has_any(std::span<const Code> codes, const Rig& rig, const std::string& camera) const;
  void undecided(Code code, std::vector<Argument> arguments = {}) {
    report_.undecided.push_back({{code, std::move(arguments)}});
  }
  /// Of another id than the question's own: that of a finding that keeps it open.
  void undecided_as(Code kind, Code code) { report_.undecided.push_back({{code}, kind}); }

 private:
  CheckReport& report_;
};

}  // namespace fca::checks
