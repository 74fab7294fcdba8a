// SPDX-License-Identifier: BSD-3-Clause
// The parts of a page, in their order.
#pragma once

#include "contents.h"
#include "html.h"

namespace fca::cli {

/// Whether to use the file, in words and colour, the numbers for it, and the reasons against it.
void put_verdict(Html& html, const ReportContents& contents);
/// --model all: which model to take, a sentence for each camera.
void put_recommendations(Html& html, const ReportContents& contents);
/// What it all comes to, in a few lines.
void put_summary(Html& html, const ReportContents& contents);
/// --model all: the models next to each other, and which to take.
void put_candidates(Html& html, const ReportContents& contents);
/// A row for each camera.
void put_camera_table(Html& html, const ReportContents& contents);
/// Curves, map, bands and parameters of each camera.
void put_cameras(Html& html, const ReportContents& contents);
void put_imus(Html& html, const ReportContents& contents);
/// How things sit to each other, drawn and in words.
void put_poses(Html& html, const ReportContents& contents);
/// What `check` finds.
void put_findings(Html& html, const ReportContents& contents);
/// What `convert` loses and adds, and how the program reads the result.
void put_ledger(Html& html, const ReportContents& contents);
/// The text of `show`, and the commands.
void put_sources(Html& html, const ReportContents& contents);

}  // namespace fca::cli
