// SPDX-License-Identifier: BSD-3-Clause
// Reasons of a verdict that are about two cameras.
#pragma once

#include <fca/formats/verdict.h>

#include <vector>

namespace fca {

/// Several cameras in a file that should say where they stand. Where its program cannot do without, poses were invented.
void add_missing_poses(const VerdictFacts& facts, std::vector<Reason>& reasons);
/// A stereo pair that its user asked for, and that geometry would not take.
void add_strange_pair(const VerdictFacts& facts, std::vector<Reason>& reasons);
/// What the fits of both cameras do to a stereo pair: no pixel of either need be far off. It is over all that both see: of wide
/// lenses corners would decide, which decide nothing else, and no file is refused for it.
void add_epipolar_error(const VerdictFacts& facts, std::vector<Reason>& reasons);
/// A stereo pair, one camera above the other, for a program that looks for matches along rows.
void add_vertical_pair(const VerdictFacts& facts, std::vector<Reason>& reasons);

}  // namespace fca
