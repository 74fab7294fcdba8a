// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate.h"

#include "output.h"

namespace fca::cli {

void add_evaluate_options(Options& options, EvaluateArguments& arguments) {
  options.value("--image", "IMAGE",
                "An image of 752 x 480 px: recovered by every row's conversion and compared with itself, PSNR and SSIM",
                arguments.image);
  add_output_option(options, "A page of the paper's figures: one HTML file, with recovered images where --image is given",
                    arguments.page);
  add_json_option(options, arguments.json);
  add_force_option(options, "Overwrite an existing page", arguments.force);
  options.afterwards([&arguments]() -> std::optional<std::string> {
    if (!arguments.json || arguments.page.kind != OutputPlace::Kind::kStandardOutput) return std::nullopt;
    return "-o - and --json both want standard output; name a file";
  });
  options.footer(
      "The cameras are the paper's. Its figures are next to ours, and why they differ. The paper's images are not ours:\n"
      "--image takes any; examples/cpp/render_image.cc makes one. With the authors' own (their repository's\n"
      "dataset/kalibr/image.png for Table 1, dataset/OcamCalib/image.jpg for Table 2), their PSNR and SSIM are computed their "
      "way,\n"
      "next to what the image loses.\n\n"
      "Example:\n"
      "  fca-io evaluate\n"
      "  fca-io evaluate --json > tables.json\n"
      "  fca-io evaluate --image seen.pgm -o figures.html\n");
}

}  // namespace fca::cli
