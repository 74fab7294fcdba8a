// SPDX-License-Identifier: BSD-3-Clause
// Files in which defects are planted: those of testdata and, where it exists, of the corpus.
#pragma once

#include "check_files.h"

#include <fca/formats/text/read_document.h>

#include <cstdio>
#include <functional>

namespace fca::test {

/// As many files as a defect is planted in.
inline constexpr int kEnough = 30;

struct Good {
  std::string name;
  Calibration calibration;
  CheckReport report;  ///< Before anything is planted.
};

inline std::vector<Good> good_files() {
  std::vector<fs::path> paths = files_of_all_formats("good");
  if (has_corpus()) {
    for (const Format& format : all_formats()) {
      const std::vector<fs::path> found = files_in(shared_dir() / "corpus" / format.id);
      paths.insert(paths.end(), found.begin(), found.end());
    }
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

inline const Finding* find_any(const CheckReport& report, const std::vector<std::string>& codes) {
  const auto found = std::ranges::find_if(
      report.findings, [&codes](const Finding& finding) { return std::ranges::find(codes, finding.code) != codes.end(); });
  return found == report.findings.end() ? nullptr : &*found;
}

/// Every `stride`th file, so that all formats take part and the test stays short.
inline std::vector<const Good*> some_good(std::size_t stride) {
  std::vector<const Good*> files;
  for (std::size_t i = 0; i < all_good().size(); i += stride) files.push_back(&all_good()[i]);
  return files;
}

/// What checks made of a defect that was planted in one file after the other.
struct Tally {
  int planted = 0;
  int found = 0;
  int placed = 0;
  std::string missed;
  std::string misplaced;
};

/// Plants it in up to kEnough files that do not have it already. `plant`: the file's bytes with the defect, or nothing where it
/// has no such place; `is_placed`: does the finding in the damaged file stand where the defect does?
inline Tally tally_of(const std::vector<std::string>& codes,
                      const std::function<std::optional<std::string>(const Good&)>& plant,
                      const std::function<bool(const Good&, const text::Source&, const Finding&)>& is_placed) {
  const std::size_t stride = has_corpus() ? 2 : 1;
  Tally tally;
  for (const Good* good : some_good(stride)) {
    if (tally.planted == kEnough) break;
    if (find_any(good->report, codes) != nullptr) continue;
    const std::optional<std::string> bytes = plant(*good);
    if (!bytes || *bytes == good->calibration.documents.front().source().bytes) continue;
    ++tally.planted;
    const text::Source source = {good->name, *bytes};
    const CheckReport report = checked(source);
    const Finding* finding = find_any(report, codes);
    if (finding == nullptr) {
      tally.missed += "\n  " + good->name + (report.findings.empty() ? "" : ": " + line_of(report.findings.front(), source));
      continue;
    }
    ++tally.found;
    if (is_placed(*good, source, *finding)) {
      ++tally.placed;
    } else {
      tally.misplaced += "\n  " + good->name + ": " + line_of(*finding, source);
    }
  }
  return tally;
}

/// Found in 95 %, of which `placed_share` stand where they should.
inline void expect_found(const char* name, const Tally& tally, int at_least, double placed_share) {
  std::printf("%-42s %3d of %3d found, %3d at their place\n", name, tally.found, tally.planted, tally.placed);
  EXPECT_GE(tally.planted, at_least) << name;
  EXPECT_GE(tally.found, 0.95 * tally.planted) << name << tally.missed;
  EXPECT_GE(tally.placed, placed_share * tally.found) << name << tally.misplaced;
}

}  // namespace fca::test
