// SPDX-License-Identifier: BSD-3-Clause
// Files in memory, and what they cannot say.
#pragma once

#include "bindings.h"

#include <fca/toolkit/convert.h>

namespace fca::python {

/// Bytes by the name in the folder that they are saved into.
[[nodiscard]] py::dict bytes_by_name(std::span<const ConvertedFile> files);

/// Writes the files into a folder. Raises fca_io.Error where that fails.
void save_files(const std::vector<ConvertedFile>& files, const py::object& folder, bool force);

/// The class fca_io.Loss.
void add_loss(py::module_& module);

}  // namespace fca::python
