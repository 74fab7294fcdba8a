// SPDX-License-Identifier: BSD-3-Clause
#include <fca/fca.h>

int main(int argc, char** argv) {  // settings camchain.yaml imu.yaml FOLDER: ORB-SLAM3's settings, proven, in that folder.
  if (argc != 4) return 3;
  fca::ConvertRequest request;
  request.inputs.files = {argv[1]};
  request.inputs.parts = {argv[2]};
  request.to = fca::find_format("orbslam3");
  request.provenance = fca::ProvenanceComment::kNone;
  fca::Files files;
  fca::ConvertResult result = fca::convert(request, files);  // its proofs, losses and diagnostics are values
  return fca::save(result, argv[3], result.diagnostics) && result.proofs.front().agrees() ? 0 : 1;
}
