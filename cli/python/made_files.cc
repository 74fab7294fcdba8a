// SPDX-License-Identifier: BSD-3-Clause
#include "made_files.h"

#include <fca/formats/wording.h>
#include <fca/toolkit/save.h>

namespace fca::python {

py::dict bytes_by_name(std::span<const ConvertedFile> files) {
  py::dict by_name;
  for (const ConvertedFile& file : files) by_name[py::str(name_in_folder(file))] = py::bytes(file.bytes);
  return by_name;
}

void save_files(const std::vector<ConvertedFile>& files, const py::object& folder, bool force) {
  ConvertResult made;
  made.files = files;
  Diagnostics diagnostics;
  if (!save(made, path_of(folder), diagnostics, force)) raise(diagnostics);
}

void add_loss(py::module_& module) {
  py::class_<Loss>(module, "Loss", "Something of the input that the files cannot say.")
      .def_property_readonly(
          "what", [](const Loss& loss) { return what_of(loss); }, "The fact: \"cam0 timeshift_cam_imu 0.002\".")
      .def_property_readonly(
          "why", [](const Loss& loss) { return why_of(loss); }, "What the format lacks.")
      .def_readonly("matters", &Loss::matters, "The target's program would use it.")
      .def("__repr__", [](const Loss& loss) { return "<fca_io.Loss " + what_of(loss) + ": " + why_of(loss) + ">"; });
}

}  // namespace fca::python
