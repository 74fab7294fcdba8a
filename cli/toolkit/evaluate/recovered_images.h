// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/evaluate.h>

#include <string>

namespace fca {

/// Adds what EvaluateRequest::image_path asks for. False with an error where there is no such image, or none of that size among
/// the tables.
[[nodiscard]] bool add_recovered_images(const std::string& path, Files& files, EvaluateResult& evaluation);

}  // namespace fca
