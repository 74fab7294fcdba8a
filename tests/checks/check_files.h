// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formats/test_files.h"

#include <fca/formats/check.h>
#include <fca/formats/text/read_document.h>
#include <fca/formats/wording.h>

namespace fca::test {

inline CheckReport checked(const text::Source& source, const CheckOptions& options = {}) { return check_file(source, options); }

inline CheckReport checked(const fs::path& path, const CheckOptions& options = {}) {
  return checked(text::Source{path.filename().string(), read_file(path)}, options);
}

/// What a file says, read as that format (null: as what it is); nothing if it cannot be read.
inline std::optional<Rig> rig_of(const text::Source& source, const Format* format = nullptr) {
  Diagnostics diagnostics;
  const std::optional<text::Document> document = text::parse_document(source, diagnostics);
  if (!document) return std::nullopt;
  std::optional<Calibration> calibration = read_calibration({*document}, format, {}, diagnostics);
  if (!calibration) return std::nullopt;
  return calibration->rig;
}

inline bool says(const CheckReport& report, std::string_view code) {
  return std::ranges::any_of(report.findings, [code](const Finding& finding) { return id_of(finding) == code; });
}

/// "6:16 error int-for-real"; "-" for a finding of the whole file.
inline std::string line_of(const Finding& finding, const text::Source& source) {
  return place_of(finding.where, source) + " " + severity_word(finding.severity) + " " + id_of(finding);
}

inline bool has_corpus() { return fs::exists(shared_dir() / "corpus" / "kalibr"); }

/// Codes that no file has, whatever stands in it.
inline bool is_of_no_file(std::string_view code) {
  constexpr std::string_view kAskedFor[] = {
      "cannot-read",           // said of a path
      "part-missing",          // of the folder a file lies in
      "program-other-format",  // of the program asked for (--for)
      "no-calibration",
      "not-settings",
      "wrong-syntax",      // of a format that was forced (--from)
      "size-contradicts",  // of --size
      "xml-place",         // of our XML parser's own mistakes: none is known
  };
  return std::ranges::find(kAskedFor, code) != std::end(kAskedFor);
}

}  // namespace fca::test
