// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/text/document.h>

namespace fca::text {

/// How a file is written, by its first lines and, where they leave it open, by its extension:
///
/// 1. `%YAML:` is cv::FileStorage's YAML, any other `%` plain YAML.
/// 2. `<` is XML (but `<<<<<<< ` is git's).
/// 3. `{`, and `[` before a JSON value, are JSON. YAML, too, can begin so: see falls_back_to_yaml.
/// 4. A name that ends in .cameramodel, mrcal's, is Python. So is a mapping, after comments or none, whose first key stands in
///    single quotes, by any name but one of the other syntaxes': YAML, too, can begin so, and is what Python refuses.
/// 5. A text with a line that begins with `Intrinsic of "` is words: what librealsense's tools print. So is one that
///    begins with `Calibration results`: Kalibr's report.
/// 6. Otherwise the first line that is neither blank nor a comment decides. Numbers, with or without one name before them, are
/// words
///    (`5 -1.2 0.0`, `RadTan 0.5 0.5 ..`): no YAML mapping or list begins so. So is an .ini: a section (`[image]`) before a
///    line of text. What a mapping or list can begin with (`key:`, `- x`) is YAML.
/// 7. What can be none of these is what its extension says (.txt, .csv: words), so that a damaged file is told what is wrong
///    with it
///    as a file of its kind. A first line of text before a line of numbers is words by any name but a YAML file's.
/// 8. The rest is YAML, whose parser says what is wrong.
[[nodiscard]] Syntax choose_syntax(const Source& source);

/// May a file that begins with a bracket and that JSON refuses be YAML in flow style? By its extension; elsewhere if no JSON
/// key or value in double quotes begins it (`{a: 1}`, `{'a': 1}`).
[[nodiscard]] bool falls_back_to_yaml(const Source& source);

/// The name's extension is that of mrcal's camera models.
[[nodiscard]] bool named_as_python(const Source& source);

/// The name's extension is YAML's.
[[nodiscard]] bool named_as_yaml(const Source& source);

}  // namespace fca::text
