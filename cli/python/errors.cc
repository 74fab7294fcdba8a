// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"

#include <fca/formats/text/message.h>
#include <fca/formats/text/render.h>

#include <algorithm>

namespace fca::python {

namespace {

/// What Python holds of an error: its sentence, and where it is.
py::object error_of(const Diagnostic& entry, std::span<const text::Source> sources) {
  const py::object error = py::module_::import("fca_io").attr("Error")(message_of(entry));
  error.attr("code") = id_of(entry);
  error.attr("fix") = fix_of(entry);
  error.attr("file") = entry.where.file;
  const auto source = std::ranges::find(sources, entry.where.file, &text::Source::name);
  if (source == sources.end() || source->is_binary()) return error;
  const text::Position place = source->position(entry.where.offset);
  error.attr("line") = place.line;
  error.attr("column") = place.column;
  return error;
}

}  // namespace

void raise(const Diagnostics& diagnostics, std::span<const text::Source> sources) {
  const auto& entries = diagnostics.entries();
  const auto first = std::ranges::find(entries, Severity::kError, &Diagnostic::severity);
  if (first == entries.end()) throw py::value_error("fca_io: nothing came of it");
  const py::object error = error_of(*first, sources);
  PyErr_SetObject(py::type::handle_of(error).ptr(), error.ptr());
  throw py::error_already_set();
}

std::vector<std::string> warnings_of(const Diagnostics& diagnostics) {
  std::vector<std::string> texts;
  for (const Diagnostic& entry : diagnostics.entries()) {
    if (entry.severity == Severity::kWarning) texts.push_back(message_of(entry));
  }
  return texts;
}

void raise_value_error(const std::string& message) { throw py::value_error(message); }

}  // namespace fca::python
