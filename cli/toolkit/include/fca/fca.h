// SPDX-License-Identifier: BSD-3-Clause
// All of the library. It has a function for each thing that the command does: read, convert, check, compare, report, remap,
// rectify, compare models, and repeat a paper's evaluation. Each function takes a request of plain values and returns a result
// of plain values. The functions print nothing, and only save() writes files.
#pragma once

#include <fca/formats/text/message.h>
#include <fca/formats/wording.h>
#include <fca/toolkit/check.h>
#include <fca/toolkit/compare.h>
#include <fca/toolkit/convert.h>
#include <fca/toolkit/evaluate.h>
#include <fca/toolkit/ledger.h>
#include <fca/toolkit/models.h>
#include <fca/toolkit/read.h>
#include <fca/toolkit/rectify.h>
#include <fca/toolkit/remap.h>
#include <fca/toolkit/report.h>
#include <fca/toolkit/save.h>
#include <fca/toolkit/target.h>
