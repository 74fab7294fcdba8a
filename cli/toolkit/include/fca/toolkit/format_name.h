// SPDX-License-Identifier: BSD-3-Clause
// What files are called: for results.
#pragma once

#include <fca/formats/format_name.h>
