// SPDX-License-Identifier: BSD-3-Clause
// Files in which defects are planted: those of testdata and, where it exists, of the corpus.
#pragma once

#include "check_files.h"

#include <fca/formats/text/read_document.h>
#include <fca/formats/wording.h>

namespace fca::test {

struct Good {
  std::string name;
  Calibration calibration;
  CheckReport report;  ///< Before anything is planted.
};

/// The formats' own files in their order, then the corpus's. The order decides which files a defect is planted in.
inline std::vector<Good> good_files() {
  std::vector<fs::path> paths;
  for (const Format& format : written_formats()) {
    const fs::path good = testdata_dir() / format.id / "good";
    if (fs::exists(good)) std::ranges::copy(files_in(good), std::back_inserter(paths));
  }
  for (const Format& format : written_formats()) {
    if (has_corpus()) std::ranges::copy(corpus_files_of(format.id), std::back_inserter(paths));
  }
  std::vector<Good> files;
  for (const fs::path& path : paths) {
    Diagnostics diagnostics;
    std::optional<text::Document> document = text::read_document(path.string(), diagnostics);
    if (!document) continue;
    std::optional<Calibration> calibration = read_calibration({*std::move(document)}, nullptr, {}, diagnostics);
    if (!calibration) continue;
    CheckReport report = checked(calibration->documents.front().source());
    files.push_back({path.filename().string(), *std::move(calibration), std::move(report)});
  }
  return files;
}

inline const std::vector<Good>& all_good() {
  static const std::vector<Good> kFiles = good_files();
  return kFiles;
}

/// The bytes that were damaged, or were to be.
inline const text::Document& document_of(const Good& good) { return good.calibration.documents.front(); }
inline const std::string& bytes_of(const Good& good) { return document_of(good).source().bytes; }

inline const Finding* find_any(const CheckReport& report, const std::vector<std::string>& codes) {
  const auto found = std::ranges::find_if(
      report.findings, [&codes](const Finding& finding) { return std::ranges::find(codes, id_of(finding)) != codes.end(); });
  return found == report.findings.end() ? nullptr : &*found;
}

}  // namespace fca::test
