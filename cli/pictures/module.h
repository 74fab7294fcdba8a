// SPDX-License-Identifier: BSD-3-Clause
// Private: the functions of pictures.h, as the module and its loader see them.
#pragma once

#include "pictures.h"

namespace fca::cli {

struct PictureFunctions {
  std::string (*png)(const Picture& picture);
};

/// What the module exports: a function without arguments that returns a pointer to its PictureFunctions.
inline constexpr const char* kPictureFunctions = "fca_picture_functions";

}  // namespace fca::cli
