// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"

#include <fca/formats/text/message.h>
#include <fca/formats/text/prose.h>
#include <fca/formats/wording.h>
#include <fca/toolkit/acceptance.h>
#include <fca/toolkit/convert.h>
#include <fca/toolkit/save.h>
#include <fca/toolkit/target.h>

#include <algorithm>
#include <memory>

namespace fca::python {

namespace {

/// A result, and the texts of its input that diagnostics point into.
struct Conversion {
  ConvertResult result;
  std::unique_ptr<Files> files;
};

Target target_named(const std::string& name) {
  if (std::optional<Target> target = find_target(name); target && target->format->is_written()) return *std::move(target);
  std::vector<std::string> known;
  for (const Format& format : written_formats()) known.emplace_back(format.id);
  raise_value_error("fca-io writes no '" + name + "'; there are " + text::enumerated(known));
}

Acceptance acceptance_of(const std::string& word) {
  TypedAcceptance typed = parse_acceptance(word);
  if (!typed.acceptance) raise_value_error("there is no code '" + typed.id + "'");
  if (!may_be_accepted(typed.acceptance->code)) raise_value_error("'" + typed.id + "' is a limit of your own");
  return *std::move(typed.acceptance);
}

template <class Word>
Word word_of(const Format& format, const std::string& kind, const std::string& word) {
  const std::optional<Word> found = Word::find(format, word);
  if (!found) raise_value_error(std::string(format.id) + " has no " + kind + " '" + word + "'");
  return *found;
}

std::unique_ptr<Conversion> convert_source(const py::object& source, const std::string& to,
                                           const std::vector<py::object>& parts, const std::optional<std::string>& model,
                                           const std::optional<double>& max_angle, const std::string& sensor,
                                           const std::string& layout, const std::vector<std::string>& accept, bool strict,
                                           const std::optional<double>& max_error) {
  ConvertRequest request;
  request.inputs = inputs_of(source);
  for (const py::object& part : parts) request.inputs.parts.push_back(path_of(part));
  request.inputs.max_angle_rad = radians(max_angle);
  Target target = target_named(to);
  request.to = target.format;
  request.program = target.program;
  request.layout = target.layout;
  request.extension = std::move(target.extension);
  if (!layout.empty()) request.layout = word_of<FormatLayout>(*request.to, "layout", layout);
  request.model = model ? &model_named(*model) : nullptr;
  if (!sensor.empty()) request.mode = word_of<FormatMode>(*request.to, "sensor mode", sensor);
  for (const std::string& word : accept) request.accepted.push_back(acceptance_of(word));
  request.strict = strict;
  request.max_error_px = max_error;
  request.made_by = "Python: fca_io.convert(to='" + to + "')";
  auto conversion = std::make_unique<Conversion>();
  conversion->files = std::make_unique<Files>();
  {
    const py::gil_scoped_release released;
    conversion->result = convert(request, *conversion->files);
  }
  const Status status = conversion->result.status;
  if (status != Status::kDone && status != Status::kRejected)
    raise(conversion->result.diagnostics, conversion->files->sources());
  return conversion;
}

py::dict files_of(const Conversion& conversion) {
  py::dict files;
  for (const ConvertedFile& file : conversion.result.files) files[py::str(name_in_folder(file))] = py::bytes(file.bytes);
  return files;
}

/// Nothing is written of a file that is not to be used.
void save_into(const Conversion& conversion, const py::object& folder, bool force) {
  if (conversion.result.status != Status::kDone) {
    const std::vector<Reason>& reasons = conversion.result.verdict.reasons;
    raise_value_error("the verdict is " + std::string(name_of(conversion.result.verdict.word)) + ": nothing is written" +
                      (reasons.empty() ? "" : "; " + message_of(reasons.front())));
  }
  Diagnostics diagnostics;
  if (!save(conversion.result, path_of(folder), diagnostics, force)) raise(diagnostics);
}

std::optional<ErrorSummary> error_of(const ConvertedCamera& camera) {
  return camera.report ? std::optional(camera.report->judgement.error) : std::nullopt;
}

std::vector<std::string> losses_of(const Conversion& conversion, bool matter) {
  std::vector<std::string> texts;
  for (const Loss& loss : conversion.result.losses) {
    if (loss.matters == matter) texts.push_back(what_of(loss) + ": " + why_of(loss));
  }
  return texts;
}

}  // namespace

void add_convert(py::module_& module) {
  py::class_<Reason>(module, "Reason", "Why a file is less than ready.")
      .def_property_readonly(
          "code", [](const Reason& reason) { return id_of(reason); }, "'pixels-off', ...")
      .def_property_readonly("verdict", [](const Reason& reason) { return std::string(name_of(reason.word)); })
      .def_readonly("camera", &Reason::camera, "Empty: it is about the whole file.")
      .def_property_readonly("text", [](const Reason& reason) { return message_of(reason); })
      .def_property_readonly("fix", [](const Reason& reason) { return fix_of(reason); })
      .def("__repr__",
           [](const Reason& reason) { return "<fca_io.Reason " + id_of(reason) + ": " + message_of(reason) + ">"; });
  py::class_<ConvertedCamera>(module, "ConvertedCamera", "One camera before and after.")
      .def_property_readonly("name", [](const ConvertedCamera& camera) { return camera.source.name; })
      .def_readonly("source", &ConvertedCamera::source)
      .def_readonly("target", &ConvertedCamera::target)
      .def_property_readonly("error", &error_of, "PixelError of the fit over the image; None where nothing was computed.");
  py::class_<Conversion>(module, "Conversion", "Files that were made, and whether to use them. Nothing is on the disk yet.")
      .def_property_readonly(
          "verdict", [](const Conversion& each) { return std::string(name_of(each.result.verdict.word)); },
          "'ready', 'use-with-care' or 'do-not-use'")
      .def_property_readonly("reasons", [](const Conversion& each) { return each.result.verdict.reasons; })
      .def_property_readonly(
          "headline", [](const Conversion& each) { return text::text_of(each.result.headline); }, "For which program and mode.")
      .def_property_readonly("files", &files_of, "Bytes by name.")
      .def_property_readonly("cameras", [](const Conversion& each) { return each.result.cameras; })
      .def_property_readonly(
          "lost", [](const Conversion& each) { return losses_of(each, true); },
          "What the target's program would use and the files cannot say.")
      .def_property_readonly(
          "details", [](const Conversion& each) { return losses_of(each, false); },
          "What the files cannot say and no program uses.")
      .def("save", &save_into, py::arg("folder"), py::kw_only(), py::arg("force") = false,
           "Writes the files into a folder, which is made if it is not there. ValueError where the verdict is 'do-not-use'; "
           "Error where a file exists, unless force is given.")
      .def("__repr__", [](const Conversion& each) {
        return "<fca_io.Conversion to " + std::string(each.result.to->id) + ": " +
               std::string(name_of(each.result.verdict.word)) + ">";
      });
  module.def("convert", &convert_source, py::arg("source"), py::arg("to"), py::kw_only(),
             py::arg("parts") = std::vector<py::object>(), py::arg("model") = py::none(), py::arg("max_angle") = py::none(),
             py::arg("sensor") = "", py::arg("layout") = "", py::arg("accept") = std::vector<std::string>(),
             py::arg("strict") = false, py::arg("max_error") = py::none(),
             R"(Converts a calibration, as the command does.

source: a path or a Rig of read(). to: a format or a program ('orbslam3', 'vins-fusion'). model: the camera model to write;
kept, else the best that the program reads. max_angle: degrees from the axis that count as lens. sensor, layout: of formats that
have them ('stereo-inertial', 'v1'). accept: codes of reasons that do not stop it. strict: nothing that matters may be lost.
max_error: pixels.)");
}

}  // namespace fca::python
