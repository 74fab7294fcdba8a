// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/format.h>

namespace fca::stella {

extern const Format kFormat;

[[nodiscard]] std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options,
                                      Diagnostics& diagnostics);
[[nodiscard]] std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                                           Diagnostics& diagnostics);
[[nodiscard]] std::size_t cameras_held(const Rig& rig, std::string_view mode, std::string_view layout);

}  // namespace fca::stella
