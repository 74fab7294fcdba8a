// SPDX-License-Identifier: BSD-3-Clause
// Where the programs that read with cv::FileStorage are linked in; storage_loader.cc has the command's.
#include "programs.h"

namespace fca::consumers {

void prepare_storage_programs() {}

}  // namespace fca::consumers
