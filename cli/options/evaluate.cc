// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate.h"

#include "output.h"

namespace fca::cli {

void add_evaluate_options(Options& options, EvaluateArguments& arguments) {
  options.value(
      "--image", "IMAGE",
      "An image of 752 x 480 px: the conversion of every row recovers it, and PSNR and SSIM compare it with the original",
      arguments.image);
  add_output_option(options, "A page of the paper's figures: one HTML file, with recovered images where --image is given",
                    arguments.page);
  add_json_option(options, arguments.json);
  add_force_option(options, "Overwrite an existing page", arguments.force);
  options.afterwards([&arguments]() -> std::optional<std::string> {
    if (!arguments.json || arguments.page.kind != OutputPlace::Kind::kStandardOutput) return std::nullopt;
    return "-o - and --json both use standard output; name a file";
  });
  options.footer(
      "The cameras are the paper's. The tables show its figures, ours, and why they differ. fca-io does not contain the "
      "paper's images: --image takes any image; examples/cpp/render_image.cc makes one. With the authors' own (their "
      "repository's dataset/kalibr/image.png for Table 1, dataset/OcamCalib/image.jpg for Table 2), their PSNR and SSIM are "
      "computed their way, next to what the image loses.\n\n"
      "Example:\n"
      "  fca-io evaluate\n"
      "  fca-io evaluate --json > tables.json\n"
      "  fca-io evaluate --image seen.pgm -o figures.html\n");
}

}  // namespace fca::cli
