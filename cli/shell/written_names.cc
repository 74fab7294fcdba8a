// SPDX-License-Identifier: BSD-3-Clause
#include "written_names.h"

#include "toolkit/words.h"

#include <fca/code.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

namespace fca::cli {

namespace {

using Cameras = std::span<const ConvertedCamera>;

void name(std::string& camera, Cameras cameras) {
  const auto found =
      std::ranges::find_if(cameras, [&camera](const ConvertedCamera& each) { return each.source.name == camera; });
  if (found != cameras.end()) camera = name_in_words(*found);
}

void name_lists(std::vector<Argument>& arguments, Cameras cameras) {
  for (Argument& argument : arguments) {
    auto* const names = std::get_if<std::vector<std::string>>(&argument.value);
    if (names == nullptr) continue;
    for (std::string& each : *names) name(each, cameras);
  }
}

void name_in(Argument& argument, Cameras cameras) {
  if (auto* const text = std::get_if<std::string>(&argument.value)) name(*text, cameras);
}

/// Of a pair whose cameras should change places: {0} and {2}.
void name_pair(Message& facts, Cameras cameras) {
  constexpr std::size_t kOther = 2;
  name_in(facts.arguments.at(0), cameras);
  name_in(facts.arguments.at(kOther), cameras);
}

/// {0}: losses.
void name_losses(Message& facts, Cameras cameras) {
  for (Message& loss : std::get<std::vector<Message>>(facts.arguments.front().value)) {
    name_in(loss.arguments.front(), cameras);
    name_lists(loss.arguments, cameras);
  }
}

void name_in(Message& facts, Cameras cameras) {
  switch (facts.code) {
    case Code::kSecondIsLeft:
    case Code::kEachIsLeft:
      return name_pair(facts, cameras);
    case Code::kVerdictLost:
    case Code::kLossesNotAllowed:
      return name_losses(facts, cameras);
    default:
      return;
  }
}

}  // namespace

void name_as_written(Verdict& verdict, Cameras cameras) {
  for (Reason& reason : verdict.reasons) name_in(reason.facts, cameras);
}

void name_as_written(ConvertResult& result) {
  for (Loss& loss : result.losses) {
    name(loss.owner, result.cameras);
    name_lists(loss.values, result.cameras);
  }
  Diagnostics named;
  for (Diagnostic entry : result.diagnostics.entries()) {
    name_in(entry.facts, result.cameras);
    named.add(std::move(entry));
  }
  result.diagnostics = std::move(named);
  name_as_written(result.verdict, result.cameras);
}

}  // namespace fca::cli
