// SPDX-License-Identifier: BSD-3-Clause
#include "sections.h"

#include "grid_figure.h"
#include "shell/option_hints.h"
#include "shell/verdict_text.h"
#include "shell/words.h"
#include "tile.h"

#include <fca/formats/wording.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <vector>

namespace fca::cli {

namespace {

std::string class_of(VerdictWord word) {
  switch (word) {
    case VerdictWord::kReady:
      return "card verdict";
    case VerdictWord::kUseWithCare:
      return "card verdict care";
    case VerdictWord::kDoNotUse:
      return "card verdict stop";
  }
  return "";
}

/// A camera as the program sees it that the file is for.
struct SeenCamera {
  const ProofResult* by = nullptr;
  CameraProof proof;
};

std::vector<SeenCamera> seen_cameras(const ReportContents& contents) {
  std::vector<SeenCamera> cameras;
  const auto add = [&cameras](const ProofResult& proof) {
    if (!proof.is_first) return;
    for (const CameraProof& camera : proof.cameras) {
      if (camera.distance.in_image.region > 0.0) cameras.push_back({&proof, camera});
    }
  };
  if (contents.to != nullptr) {
    for (const ProofResult& proof : contents.conversion->proofs) add(proof);
  } else {
    for (const CheckResult& file : contents.checks) {
      if (file.report.proof) add(*file.report.proof);
    }
  }
  return cameras;
}

void put_pixels(Html& html, const std::vector<SeenCamera>& cameras) {
  const auto worst =
      std::ranges::max_element(cameras, {}, [](const SeenCamera& camera) { return camera.proof.distance.decisive().rms; });
  if (worst == cameras.end()) return;
  const PixelDistance& distance = worst->proof.distance.decisive();
  put_tile(html, "Worst camera, as the program sees it", pixels(distance.rms) + " px rms",
           {worst->proof.name + ": 99 % within " + pixels(distance.p99) + " px, worst " + pixels(distance.max) + " px",
            region_in_words(worst->proof.distance),
            "two calibrations of one camera differ by 0.4 to 3 px rms (TUM VI, Odyssey+, EuRoC)"});
  const auto compared = [](const SeenCamera& camera) {
    const PixelDistance& image = camera.proof.distance.in_image;
    return image.region * (1.0 - image.no_rays);
  };
  const auto least = std::ranges::min_element(cameras, {}, compared);
  const PixelDistance& image = least->proof.distance.in_image;
  const double missing = image.region * image.no_rays;
  constexpr double kNoticeable = 5e-4;
  const bool distance_covers_image = image.region > 1.0 - kNoticeable;
  put_tile(html, "Compared", percent(compared(*least)) + " of the image",
           {missing > kNoticeable   ? "the program has no right ray for " + percent(missing)
            : distance_covers_image ? "the program has a ray for every pixel"
                                    : "the program has a ray for all that counts as lens"});
  put_grid(html, worst->proof.name, worst->by->program, worst->proof.distance);
}

/// Corners that the verdict does not count.
std::string limit_in_words(const std::vector<SeenCamera>& cameras) {
  constexpr double kNoticeable = 0.01;
  const auto share = [](const SeenCamera& camera) { return share_without_rays(camera.proof.distance); };
  const auto most = std::ranges::max_element(cameras, {}, share);
  if (most == cameras.end() || share(*most) <= kNoticeable) return "";
  return no_rays_outside_in_words(share(*most));
}

void put_settings(Html& html, const ReportContents& contents) {
  if (contents.to == nullptr) return;
  std::vector<std::string> settings;
  for (const DefaultedValue& value : contents.conversion->defaults) {
    if (value.look_at_it) settings.push_back(value.key);
  }
  put_tile(html, "To set by hand", settings.empty() ? "nothing" : counted(settings.size(), "value"), {enumerated(settings)});
}

}  // namespace

void put_verdict(Html& html, const ReportContents& contents) {
  const Verdict& verdict = contents.verdict;
  const std::vector<SeenCamera> seen = seen_cameras(contents);
  std::string word(in_words(verdict.word));
  word.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(word.front())));
  html.element("div", {{"class", class_of(verdict.word)}}, [&] {
    html.element("div", {{"class", "word"}}, word);
    put_recommendations(html, contents);
    if (contents.conversion && contents.conversion->headline.is_said()) {
      const bool refused = contents.conversion->status == Status::kRejected;
      html.element("div", {},
                   "The file that convert " + std::string(refused ? "refuses to write" : "writes") + ": " +
                       text::text_of(contents.conversion->headline, with_options));
    }
    html.element("ul", {}, [&] {
      for (const SummaryLine& line : lines_of(verdict)) html.element("li", {}, line.about + ": " + line.text);
      const std::string limit = limit_in_words(seen);
      if (!limit.empty()) html.element("li", {}, limit);
    });
  });
  html.element("div", {{"class", "tiles"}}, [&] {
    put_pixels(html, seen);
    put_settings(html, contents);
  });
}

}  // namespace fca::cli
