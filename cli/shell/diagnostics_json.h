// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "console.h"
#include "json.h"
#include "option_hints.h"

#include <algorithm>
#include <span>

namespace fca::cli {

/// Members of an open object: line and column; of a binary file the byte, from 0.
inline void put_place(Json& json, const text::Source& source, std::size_t offset) {
  if (source.is_binary()) return json.put("byte", static_cast<long long>(offset));
  const text::Position position = source.position(offset);
  json.put("line", position.line);
  json.put("column", position.column);
}

/// The array "diagnostics" of an open object. `sources`: what they point into.
inline void put_diagnostics(Json& json, const Diagnostics& diagnostics, std::span<const text::Source> sources) {
  json.array("diagnostics", diagnostics.entries(), [&](const Diagnostic& entry) {
    json.object([&] {
      json.put("severity", name_of(entry.severity));
      json.put("code", id_of(entry));
      const auto source = std::ranges::find(sources, entry.where.file, &text::Source::name);
      if (!entry.where.file.empty()) json.put("file", entry.where.file);
      if (source != sources.end() && (entry.where.offset > 0 || entry.where.length > 0)) {
        put_place(json, *source, entry.where.offset);
      }
      json.put("message", message_of(entry, with_options));
      if (const std::string fix = fix_of(entry, with_options); !fix.empty()) json.put("fix", fix);
    });
  });
}
inline void put_diagnostics(Json& json, const Diagnostics& diagnostics, const Console& console) {
  put_diagnostics(json, diagnostics, console.sources());
}

}  // namespace fca::cli
