// SPDX-License-Identifier: BSD-3-Clause
// Files in, a rig out, and back: syntax, format detection, several files that are one calibration, and what writing loses.
#pragma once

#include <fca/formats/format.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fca {

/// What was read, with what it was read from.
struct Calibration {
  const Format* format = nullptr;
  Message why;                               ///< Why that format.
  bool one_format = true;                    ///< False: joined from files with cameras in more than one.
  std::vector<text::Document> documents;     ///< The main file first, then its further parts.
  std::size_t with_cameras = 0;              ///< Which of them specifies the cameras (the first that does, of `format`).
  std::vector<const Format*> formats;        ///< Of the documents, one for one.
  std::vector<PoseEdge> poses_without_unit;  ///< Those of `rig` whose unit neither their files nor ReadOptions say.
  std::size_t poses_in_told_unit = 0;        ///< Those whose unit ReadOptions say.
  /// Of several documents the rig of each that was read by itself, if ReadOptions said nothing of it.
  std::vector<std::optional<Rig>> rigs;
  Rig rig;
};

/// What its format reads of one of the documents, by itself and without ReadOptions; nothing where it does not read it so.
[[nodiscard]] std::optional<Rig> rig_alone(const Calibration& calibration, std::size_t document);
/// That as a calibration.
[[nodiscard]] std::optional<Calibration> alone(const Calibration& calibration, std::size_t document);

struct DetectedFormat {
  const Format* format = nullptr;
  Message why = {};
};

/// As text::parse_document(); a text of another program, without a syntax that is parsed, is named.
[[nodiscard]] std::optional<text::Document> parse_calibration(const text::Source& source, Diagnostics& diagnostics);

/// The format whose content the document has. No format, or a tie, is an error.
[[nodiscard]] std::optional<DetectedFormat> detect_format(const text::Document& document, Diagnostics& diagnostics);

/// A file that a document names as part of its calibration.
struct NamedFile {
  std::string path;   ///< With the document's own folder before it.
  SourceRange where;  ///< What names it.
};

/// The files that a document of that format names as parts of its calibration (Format::parts).
[[nodiscard]] std::vector<NamedFile> named_parts(const Format& format, const text::Document& document);

/// The bytes of such a file; nothing if no file is there that can be read. A pipe that a file names would be waited for.
[[nodiscard]] std::optional<text::Source> read_part(const NamedFile& part);

/// Reads one calibration. `format`: null to detect it. `with`: further parts of the same calibration (imu.yaml). The files at
/// named_parts() of a document, all of them, may follow it and are read with it. `detected`: of the documents whose format was
/// detected before, one for one; may end early.
[[nodiscard]] std::optional<Calibration> read_calibration(std::vector<text::Document> documents, const Format* format,
                                                          const ReadOptions& options, Diagnostics& diagnostics,
                                                          std::span<const std::optional<DetectedFormat>> detected = {});

/// Of a file with a lens for each size of images, that was not read for want of one (ReadOptions::image_size): those sizes, the
/// widest first. Nothing of any other file, nor where anything else is wrong.
[[nodiscard]] std::vector<ImageSize> offered_sizes(const Diagnostics& diagnostics);

/// What `format.write` returns for the rig, and which of its poses that does not say (losses "pose-dropped").
[[nodiscard]] std::optional<Written> write_calibration(const Format& format, const text::Document* base, const Rig& rig,
                                                       const WriteOptions& options, Diagnostics& diagnostics);

}  // namespace fca
