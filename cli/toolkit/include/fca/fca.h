// SPDX-License-Identifier: BSD-3-Clause
// Everything that the command does, as functions: read, convert, check, compare, report, remap, rectify, compare models, and
// the paper's evaluation. Each takes a request of plain values, and gives a result of plain values; nothing is printed, and
// only save() writes.
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
