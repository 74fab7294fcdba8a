// SPDX-License-Identifier: BSD-3-Clause
#include "sections.h"

#include "commands/convert/convert_command.h"
#include "shell/option_hints.h"
#include "shell/words.h"

#include <fca/formats/wording.h>

#include <algorithm>
#include <string>

namespace fca::cli {

namespace {

void put_losses(Html& html, const ConvertResult& outcome) {
  html.element("h3", {}, "Lost");
  const auto lacks_pixels = [](const ConvertedCamera& camera) { return camera.unrepresented_share() > 0.0; };
  if (outcome.losses.empty() && std::ranges::none_of(outcome.cameras, lacks_pixels))
    html.element("p", {{"class", "good"}}, "Nothing.");
  html.element("ul", {{"class", "losses"}}, [&] {
    for (const ConvertedCamera& camera : outcome.cameras) {
      if (!lacks_pixels(camera)) continue;
      html.element("li", {}, [&] {
        html.element("span", {{"class", "strong"}}, percent(camera.unrepresented_share()) + " of the image");
        html.text(" of " + name_in_words(camera) + ": " + camera.report->to_model + " does not describe the lens there");
      });
    }
    for (const Loss& loss : outcome.losses) {
      html.element("li", {}, [&] {
        html.element("span", {{"class", "strong"}}, what_of(loss, with_options));
        html.text(": " + why_of(loss, with_options));
        const std::string remedy = remedy_of(loss, with_options);
        if (!remedy.empty()) html.element("div", {{"class", "soft"}}, "Do: " + remedy);
      });
    }
  });
}

void put_defaults(Html& html, const std::vector<DefaultedValue>& defaults) {
  const auto put = [&](const char* title, bool look_at_it) {
    std::vector<std::string> values;
    for (const DefaultedValue& value : defaults) {
      if (value.look_at_it == look_at_it) values.push_back(text_of(value, with_options));
    }
    if (values.empty()) return;
    html.element("h3", {}, title);
    html.element("ul", {}, [&] {
      for (const std::string& value : values) html.element("li", {}, value);
    });
  };
  put("Not in the input: set them to your camera's", true);
  put("Defaults", false);
}

/// As convert's report says it, with what belongs to a verdict set off below it.
void put_proofs(Html& html, const ConvertResult& outcome) {
  if (outcome.proofs.empty() && outcome.unproven.empty()) return;
  html.element("h3", {}, "Proof: how the program reads the written file");
  for (const ProofWords& proof : proofs_in_words(outcome)) {
    html.element("p", {{"class", "strong"}}, proof.verdict);
    for (const std::string& detail : proof.details) html.element("p", {{"class", "soft"}}, "  " + detail);
  }
}

}  // namespace

void put_ledger(Html& html, const ReportContents& contents) {
  if (!contents.conversion || contents.to == nullptr) return;
  html.element("h2", {}, "What convert loses and adds for " + std::string(contents.to->title));
  put_losses(html, *contents.conversion);
  put_defaults(html, contents.conversion->defaults);
  put_proofs(html, *contents.conversion);
}

}  // namespace fca::cli
