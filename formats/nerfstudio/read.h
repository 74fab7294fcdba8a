// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../fields.h"

#include <fca/formats/format.h>

namespace fca::nerfstudio {

/// The cameras of one transforms.json; its frames and what else stands in it are extra fields. Nothing, with errors, where a
/// camera cannot be read.
[[nodiscard]] std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options,
                                      Diagnostics& diagnostics);

/// The camera's numbers as the file has them, a field for each. A kb4 has k1 to k4, a radtan the others, a pinhole none.
[[nodiscard]] std::vector<fields::Field> numbers_of(const Camera& camera);

}  // namespace fca::nerfstudio
