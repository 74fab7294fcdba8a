// SPDX-License-Identifier: BSD-3-Clause
// The last line of defence of every writer, whatever it writes: no number that is not finite leaves the program.
#pragma once

#include <fca/formats/format.h>
#include <fca/formats/text/read_document.h>

namespace fca {

/// False with errors if the rig specifies what no file may (rig/limits.h), or has names that are not printable.
[[nodiscard]] bool may_be_written(const Rig& rig, Diagnostics& diagnostics);

/// False with an error if a pose is no motion but a mirror image.
[[nodiscard]] bool has_no_mirror(const Rig& rig, Diagnostics& diagnostics);

/// False with an error if a number in what was written is not finite, where the base (may be null) does not say it already.
[[nodiscard]] bool holds_finite_numbers(const Written& written, const text::Document* base, Diagnostics& diagnostics);

/// False with an error if a file was edited whose base has values that YAML's aliases share.
[[nodiscard]] bool edits_no_copies(const Written& written, const text::Document* base, Diagnostics& diagnostics);

/// The row with these checks around its writer.
template <const Format& kFormat>
Format guarded() {
  Format format = kFormat;
  if (!format.is_written()) return format;
  format.write = [](const text::Document* base, const Rig& rig, const WriteOptions& options,
                    Diagnostics& diagnostics) -> std::optional<Written> {
    if (!may_be_written(rig, diagnostics)) return std::nullopt;
    // An edit keeps what its base says, right or wrong.
    if (base == nullptr && !has_no_mirror(rig, diagnostics)) return std::nullopt;
    std::optional<Written> written = kFormat.write(base, rig, options, diagnostics);
    if (!written || !edits_no_copies(*written, base, diagnostics)) return std::nullopt;
    // What follows (the next check, losses, the names in the file) all asks what an edited file says now.
    for (Written::File& file : written->files) text::keep_edited(file.document);
    if (!holds_finite_numbers(*written, base, diagnostics)) return std::nullopt;
    return written;
  };
  return format;
}

}  // namespace fca
