// SPDX-License-Identifier: BSD-3-Clause
#include "version_command.h"

#include "options/lists.h"
#include "shell/json.h"
#include "shell/words.h"

#include <fca/formats/consumers/consumer.h>

#include <algorithm>

namespace fca::cli {

namespace {

std::string version_json(const Origin& origin) {
  Json json;
  json.object([&] {
    json.put("fca_io", FCA_VERSION);
    origin.commit.empty() ? json.null("commit") : json.put("commit", origin.commit);
    json.put("changed", origin.is_changed);
    origin.date.empty() ? json.null("date") : json.put("date", origin.date);
    json.array("programs", consumers::all_consumers(), [&](const consumers::Consumer& consumer) {
      json.object([&] {
        json.put("id", consumer.id);
        json.put("program", consumer.program);
        json.put("source", consumers::source_words(consumer.source));
      });
    });
  });
  return json.document();
}

/// The first line is what --version prints. Programs of one source stand once, by the first one's id.
std::string version_text(const Origin& origin) {
  std::string text = "fca-io " FCA_VERSION "\n";
  if (!origin.commit.empty()) {
    text += "commit " + std::string(origin.commit) + (origin.is_changed ? ", with changes" : "") + "\n";
  }
  if (!origin.date.empty()) text += "date   " + std::string(origin.date) + "\n";
  text += "readers after\n";
  const std::span<const consumers::Consumer> programs = consumers::all_consumers();
  constexpr std::size_t kId = 12;
  for (auto program = programs.begin(); program != programs.end(); ++program) {
    const std::string words = consumers::source_words(program->source);
    const auto same = [&words](const consumers::Consumer& other) { return consumers::source_words(other.source) == words; };
    if (std::any_of(programs.begin(), program, same)) continue;
    text += "  " + padded(program->id, kId) + words + "\n";
  }
  return text;
}

}  // namespace

void add_version_command(Application& application, const Origin& origin) {
  application.add<ListArguments>("version", "The version, its commit, and after which programs its readers are written",
                                 &add_version_options, [origin](const ListArguments& arguments, Console& console) {
                                   console.out(arguments.json ? version_json(origin) : version_text(origin));
                                   return ExitCode::kGood;
                                 });
}

}  // namespace fca::cli
