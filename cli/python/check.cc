// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"

#include <fca/code.h>
#include <fca/formats/text/message.h>
#include <fca/formats/text/read_document.h>
#include <fca/formats/wording.h>
#include <fca/toolkit/check.h>
#include <fca/toolkit/programs.h>

#include <memory>

namespace fca::python {

namespace {

struct Check {
  CheckResult result;
  std::unique_ptr<Files> files;
};

/// A finding with its place in words of people.
struct PlacedFinding {
  Finding finding;
  std::string file;
  std::optional<text::Position> place;
};

std::unique_ptr<Check> check_source(const py::object& source, const std::optional<Size>& image_size,
                                    const std::vector<std::string>& ignore) {
  CheckRequest request;
  request.inputs = inputs_of(source);
  if (image_size) request.inputs.image_size = size_of(image_size);
  for (const std::string& id : ignore) {
    const CodeInfo* const code = find_code(id);
    if (code == nullptr) raise_value_error("there is no code '" + id + "'");
    request.ignored.push_back(code->code);
  }
  Diagnostics diagnostics;
  auto result = std::make_unique<Check>();
  result->files = std::make_unique<Files>();
  const std::optional<text::Source> text = result->files->read(request.inputs.files.front(), diagnostics);
  if (!text) raise(diagnostics);
  {
    const py::gil_scoped_release released;
    result->result = check(request, *text, *result->files);
  }
  return result;
}

std::vector<PlacedFinding> findings_of(const Check& check) {
  std::vector<PlacedFinding> placed;
  const text::Source& source = check.result.source;
  for (const Finding& finding : check.result.report.findings) {
    const bool has_place = !finding.where.file.empty() && finding.where.file == source.name && !source.is_binary();
    placed.push_back({finding, finding.where.file.empty() ? source.name : finding.where.file,
                      has_place ? std::optional(source.position(finding.where.offset)) : std::nullopt});
  }
  return placed;
}

std::optional<int> line_of(const PlacedFinding& finding) {
  return finding.place ? std::optional(finding.place->line) : std::nullopt;
}

std::optional<int> column_of(const PlacedFinding& finding) {
  return finding.place ? std::optional(finding.place->column) : std::nullopt;
}

}  // namespace

void add_check(py::module_& module) {
  py::class_<PlacedFinding>(module, "Finding", "Something that is, or may be, wrong with a file.")
      .def_property_readonly(
          "code", [](const PlacedFinding& each) { return id_of(each.finding); }, "'pose-inverted', ...")
      .def_property_readonly(
          "severity", [](const PlacedFinding& each) { return std::string(name_of(each.finding.severity)); },
          "'error', 'warning' or 'note'")
      .def_property_readonly(
          "text", [](const PlacedFinding& each) { return message_of(each.finding); }, "What is wrong.")
      .def_property_readonly(
          "consequence", [](const PlacedFinding& each) { return consequence_of(each.finding); },
          "What happens if the file is used as it is.")
      .def_property_readonly(
          "fix", [](const PlacedFinding& each) { return fix_of(each.finding); }, "What to do; may be empty.")
      .def_readonly("file", &PlacedFinding::file, "Path.")
      .def_property_readonly("line", &line_of, "From 1; None: no place.")
      .def_property_readonly("column", &column_of, "In characters, from 1.")
      .def("__repr__", [](const PlacedFinding& each) {
        return "<fca_io.Finding " + id_of(each.finding) + ": " + message_of(each.finding) + ">";
      });
  py::class_<Check>(module, "Check", "What a check came to.")
      .def_property_readonly(
          "verdict", [](const Check& each) { return std::string(name_of(each.result.report.verdict.word)); },
          "'ready', 'use-with-care' or 'do-not-use'")
      .def_property_readonly(
          "reasons", [](const Check& each) { return each.result.report.verdict.reasons; },
          "Why it is less than ready: a list of Reason.")
      .def_property_readonly(
          "format",
          [](const Check& each) {
            const Format* format = each.result.report.format;
            return format != nullptr ? std::optional(std::string(format->id)) : std::nullopt;
          },
          "None: no format that fca-io knows.")
      .def_property_readonly("findings", &findings_of, "A list of Finding, in the order of the file.");
  module.def("check", &check_source, py::arg("source"), py::kw_only(), py::arg("image_size") = py::none(),
             py::arg("ignore") = std::vector<std::string>(),
             "Is a calibration file sane? What is wrong, where, what happens if it is used, and how to fix it.");
}

}  // namespace fca::python
