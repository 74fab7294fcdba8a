// SPDX-License-Identifier: BSD-3-Clause
// All kernels: a model without any is evaluated one pixel at a time.
#pragma once

#include "division/kernels.h"
#include "ds/kernels.h"
#include "eucm/kernels.h"
#include "fov/kernels.h"
#include "ftheta/kernels.h"
#include "kb4/kernels.h"
#include "mei/kernels.h"
#include "ocamcalib/kernels.h"
#include "pinhole/kernels.h"
#include "radtan/kernels.h"
#include "rational/kernels.h"
#include "ucm/kernels.h"
#include "woodscape/kernels.h"
