// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "schema/schema.h"

namespace fca::basalt {

extern const Format kFormat;
extern const schema::Schema kSchema;

}  // namespace fca::basalt
