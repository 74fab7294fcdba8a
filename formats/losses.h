// SPDX-License-Identifier: BSD-3-Clause
// Entries of the loss ledger that every writer makes alike. `why` is a clause of the table.
#pragma once

#include <fca/formats/format.h>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace fca {

/// What was read and has no place in the target, each as a loss; tuning ("Viewer.PointSize", ...) as one.
void add_not_carried(std::span<const ExtraField> extras, const Message& why, std::vector<Loss>& losses);

/// A camera's time offset (by Kalibr's name for it: no other format has one), with what to do about it; nothing where there is
/// none, or 0.
void add_time_offset(const Camera& camera, const Message& why, std::vector<Loss>& losses);

/// Time offsets [s] that differ from `common`, the one that the program takes for all cameras, with what to add to the stamps.
/// `who`: "Basalt has one for all cameras".
void add_other_time_offsets(const Rig& rig, double common, const Message& who, std::vector<Loss>& losses);

/// What is known of a camera's image stream: time offset, topic, frame rate.
void add_stream(const Camera& camera, const Message& why, std::vector<Loss>& losses);

/// Those of `extras` that are not among `there`, what the file to be edited says and goes on saying.
[[nodiscard]] std::vector<ExtraField> extras_beyond(std::span<const ExtraField> extras, std::span<const ExtraField> there);

/// What the input specifies besides its rig and the edited file, which says `there`, does not: as losses. Keys that the file
/// has keep its value; the losses of the others give the reason `why`.
void add_beyond_base(std::span<const ExtraField> extras, std::span<const ExtraField> there, const Message& why,
                     std::vector<Loss>& losses);

/// What the input specifies besides its rig and the file, which specifies `there`, does not (`why`); and of `replaced`, the rig
/// of a base in whose place the file was composed, what neither of them specifies.
void add_extras_lost(const Rig& rig, std::span<const ExtraField> there, const std::optional<Rig>& replaced, const Message& why,
                     std::vector<Loss>& losses);

/// The comments of the text that `edited` is an edit of, and that stood in what was replaced or removed there.
void add_lost_comments(const text::Document& edited, std::vector<Loss>& losses);

/// What goes with a base's text where `fresh` is composed in its place: comments and its first line, "%YAML:1.0". `why`: why it
/// is rewritten; may be none. Its keys are the writer's affair.
void add_rewritten(const text::Document& base, const text::Document& fresh, const Message& why, std::vector<Loss>& losses);

}  // namespace fca
