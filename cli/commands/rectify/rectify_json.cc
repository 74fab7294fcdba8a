// SPDX-License-Identifier: BSD-3-Clause
#include "rectify_command.h"
#include "shell/diagnostics_json.h"
#include "shell/option_hints.h"
#include "shell/words.h"

#include <fca/formats/text/message.h>
#include <fca/formats/wording.h>

namespace fca::cli {

namespace {

void put_region(Json& json, std::string_view key, const std::optional<ImageRegion>& region) {
  if (!region) {
    json.null(key);
    return;
  }
  json.object(key, [&] {
    json.put("x", region->x);
    json.put("y", region->y);
    json.put("width", region->size.width);
    json.put("height", region->size.height);
  });
}

void put_view(Json& json, const RectifyResult& result, std::size_t i) {
  const RectifiedPair::View& view = result.pair.views.at(i);
  json.object([&] {
    json.put("camera", result.cameras.at(i).name);
    json.put("cx", view.centre[0]);
    json.put("cy", view.centre[1]);
    json.put("T_rectified_camera", std::span<const double>(view.T_rectified_camera.values));
    put_region(json, "valid", view.valid);
  });
}

void put_rows(Json& json, std::string_view key, const RowDifference& rows) {
  json.object(key, [&] {
    json.put("rms_px", rows.rms_px);
    json.put("max_px", rows.max_px);
    json.put("max_at", std::span<const double>(rows.max_at));
    json.put("share", rows.share);
  });
}

void put_pair(Json& json, const RectifyResult& result) {
  json.object("pair", [&] {
    json.put("stated", result.is_stated);
    json.put("vertical", result.pair.is_vertical);
    json.put("exchanged", result.is_exchanged);
    json.put("width", result.size.width);
    json.put("height", result.size.height);
    json.put("fx", result.pair.focal_lengths[0]);
    json.put("fy", result.pair.focal_lengths[1]);
    json.put("full_fov_deg", result.full_fov_rad * kDegreesPerRadian);
    json.put("baseline_m", result.baseline_m());
    json.put("bf", result.bf());
    const std::array<std::size_t, 2> both = {0, 1};
    json.array("views", both, [&](std::size_t i) { put_view(json, result, i); });
  });
}

}  // namespace

std::string rectify_json(const RectifyArguments& arguments, const Rectifying& done, ExitCode code, const Console& console) {
  const RectifyResult& result = done.result;
  Json json;
  json.object([&] {
    json.put("fca_io", FCA_VERSION);
    json.put("file", arguments.request.inputs.files.front());
    json.put("exit_code", static_cast<int>(code));
    put_pair(json, result);
    json.object("vertical_disparity", [&] {
      put_rows(json, "at_infinity", result.disparity->at_infinity);
      put_rows(json, "at_ten_baselines", result.disparity->at_ten_baselines);
    });
    if (result.ours) {
      json.object("ours_minus_opencv", [&] {
        json.put("fx", result.ours->focal_lengths[0] - result.pair.focal_lengths[0]);
        json.put("cx", result.ours->views[0].centre[0] - result.pair.views[0].centre[0]);
        json.put("cy", result.ours->views[0].centre[1] - result.pair.views[0].centre[1]);
      });
    } else {
      json.null("ours_minus_opencv");
    }
    json.array("settings", result.files, [&](const ConvertedFile& file) {
      const auto index = static_cast<std::size_t>(&file - result.files.data());
      const bool is_written = index < done.settings.size();
      json.object([&] {
        is_written ? json.put("path", done.settings[index]) : json.null("path");
        is_written ? json.null("text") : json.put("text", file.bytes);
      });
    });
    json.array("proof", result.proofs, [&](const ProofResult& proof) {
      json.object([&] {
        json.put("program", proof.program);
        json.put("loads", proof.loads);
        json.put("agrees", proof.agrees());
        json.put("max_diff_px", proof.max_diff_px);
        json.put("refusals", sentences_of(proof.refusals, with_options));
      });
    });
    json.put("maps", done.maps);
    std::vector<RemappedImage> images = done.images[0];
    images.insert(images.end(), done.images[1].begin(), done.images[1].end());
    json.array("images", images, [&](const RemappedImage& image) {
      json.object([&] {
        json.put("input", image.input);
        !image.left&& image.code == ExitCode::kGood ? json.put("output", image.output) : json.null("output");
        put_diagnostics(json, image.diagnostics, console);
      });
    });
    put_diagnostics(json, result.diagnostics, console);
  });
  return json.document();
}

}  // namespace fca::cli
