// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate.h"

#include "output.h"

namespace fca::cli {

void add_evaluate_options(Options& options, EvaluateArguments& arguments) {
  options.value("--image", "IMAGE",
                "An image of 752 x 480 px: recovered by every row's conversion and compared with itself, PSNR and SSIM",
                arguments.image);
  add_json_option(options, arguments.json);
  options.footer(
      "The cameras are the paper's. Its figures are next to ours, and why they differ. The paper's images are not ours:\n"
      "--image takes any; examples/cpp/render_image.cc makes one.\n\n"
      "Example:\n"
      "  fca-io evaluate\n"
      "  fca-io evaluate --json > tables.json\n"
      "  fca-io evaluate --image seen.pgm\n");
}

}  // namespace fca::cli
