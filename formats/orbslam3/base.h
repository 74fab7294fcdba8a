// SPDX-License-Identifier: BSD-3-Clause
// A settings file that is written into: what it is, what of it stays, and what to say of that.
#pragma once

#include "settings.h"

#include <fca/diagnostics.h>
#include <fca/formats/format.h>

#include <optional>
#include <span>
#include <vector>

namespace fca::orbslam3 {

/// A document that settings are written into.
struct Base {
  const text::Document& document;
  Rig rig;        ///< As read from it.
  Target target;  ///< What it is.
};

/// The sensor mode of a document that says `rig`, as far as `style` can serve it.
[[nodiscard]] Sensor sensor_of(const text::Document& document, const Rig& rig, Style style);

/// Nothing where the document is null or no settings file.
[[nodiscard]] std::optional<Base> read_base(const text::Document* document);

/// The fields that the base is taken from. A mode that was requested has exactly its keys: the base's of other modes are among
/// them, to go. Else what the base says in a mode that the rig leaves, and the rig still says, stays, for it is as true as
/// before.
[[nodiscard]] std::vector<fields::Field> fields_of(const Base& base, const Rig& rig, std::span<const fields::Field> after,
                                                   const WriteOptions& options);

/// Values of the base that no rig specifies and that the mode asked for has no use for.
void list_left_keys(const Base& base, std::span<const fields::Field> after, const Target& target, std::vector<Loss>& losses);

/// A base whose bf and poses are of two baselines: the new bf follows the poses.
void warn_of_other_baseline(const Base& base, std::span<const fields::Field> after, Diagnostics& diagnostics);

/// The base's mode is not to be lost in silence: its keys stay, and nothing reads them.
void warn_of_poorer_mode(const Base& base, const Rig& rig, const Target& target, Diagnostics& diagnostics);

/// Of the values that no input specifies, those that the base does not already have.
[[nodiscard]] std::vector<fields::Field> new_fields(const std::vector<fields::Field>& fields, const Base& base);

}  // namespace fca::orbslam3
