// SPDX-License-Identifier: BSD-3-Clause
// Defects planted in good files, those of testdata and of the corpus, are found at their place; and every code that a
// file can have is planted.
#include "seeded_defects.h"

#include <cstdio>
#include <set>

namespace fca::test {

bool is_new_number(const Good& good, const text::Source& damaged, const Finding& finding) {
  const text::Span span = {finding.where.offset, finding.where.length};
  return span.length > 0 && (span.end() > bytes_of(good).size() || document_of(good).source().text(span) != damaged.text(span));
}

namespace {

/// As many files as a defect is planted in.
constexpr int kEnough = 40;
/// Every so many files first, so that all formats take part; then the others.
constexpr std::size_t kStride = 5;

std::vector<const Good*> in_mixed_order(const std::vector<Good>& files) {
  std::vector<const Good*> result;
  for (std::size_t first = 0; first < kStride; ++first) {
    for (std::size_t i = first; i < files.size(); i += kStride) result.push_back(&files[i]);
  }
  return result;
}

/// What checks found of a defect that was planted in one file after the other.
struct Tally {
  int planted = 0;
  int found = 0;
  int placed = 0;
  std::string missed;
  std::string misplaced;
};

/// Plants it in kEnough files that do not have it already, and in more until each of its codes was said, which are added to
/// `said`.
Tally tally_of(const SeededDefect& defect, std::set<std::string>& said) {
  CheckOptions options;
  if (defect.program != nullptr) options.program = consumers::find_consumer(defect.program);
  Tally tally;
  for (const Good* good : in_mixed_order(all_good())) {
    const auto is_said = [&said](const std::string& code) { return said.contains(code); };
    if (tally.planted >= kEnough && std::ranges::all_of(defect.codes, is_said)) break;
    if (find_any(good->report, defect.codes) != nullptr) continue;
    const std::optional<std::string> bytes = defect.plant(*good);
    if (!bytes || *bytes == bytes_of(*good)) continue;
    ++tally.planted;
    const text::Source source = {good->name, *bytes};
    const CheckReport report = checked(source, options);
    const Finding* finding = find_any(report, defect.codes);
    if (finding == nullptr) {
      tally.missed += "\n  " + good->name + (report.findings.empty() ? "" : ": " + line_of(report.findings.front(), source));
      continue;
    }
    ++tally.found;
    for (const Finding& each : report.findings) {
      if (std::ranges::find(defect.codes, id_of(each)) != defect.codes.end()) said.insert(id_of(each));
    }
    if (!defect.is_placed || defect.is_placed(*good, source, *finding)) {
      ++tally.placed;
    } else {
      tally.misplaced += "\n  " + good->name + ": " + line_of(*finding, source);
    }
  }
  return tally;
}

/// Every code that a defect may be reported by is, in one file at least.
void expect_found(const std::vector<SeededDefect>& defects) {
  std::set<std::string> said;
  std::set<std::string> wanted;
  for (const SeededDefect& defect : defects) {
    wanted.insert(defect.codes.begin(), defect.codes.end());
    const Tally tally = tally_of(defect, said);
    std::printf("%-52s %3d of %3d found, %3d at their place\n", defect.name.c_str(), tally.found, tally.planted, tally.placed);
    EXPECT_GE(tally.planted, has_corpus() ? defect.at_least : 0) << defect.name;
    EXPECT_GE(tally.found, 0.95 * tally.planted) << defect.name << tally.missed;
    EXPECT_GE(tally.placed, 0.95 * tally.found) << defect.name << tally.misplaced;
  }
  if (!has_corpus()) GTEST_SKIP() << "shared/corpus is not there: not every defect could be planted";
  for (const std::string& code : wanted) EXPECT_TRUE(said.contains(code)) << code << " is not said of any defect that lists it";
}

TEST(SeededDefects, OfFactsAreFound) { expect_found(seeded_facts()); }
TEST(SeededDefects, OfSpellingAreFound) { expect_found(seeded_spellings()); }
TEST(SeededDefects, OfStructureAreFound) { expect_found(seeded_structure()); }

TEST(SeededDefects, HaveEveryCode) {
  std::set<std::string_view> planted;
  const std::vector<SeededDefect> all[] = {seeded_facts(), seeded_spellings(), seeded_structure()};
  for (const std::vector<SeededDefect>& list : all) {
    for (const SeededDefect& defect : list) planted.insert(defect.codes.begin(), defect.codes.end());
  }
  // Said of memories of devices, in which there is no defect to plant.
  const std::set<std::string_view> of_devices = {"lens-in-doubt", "not-calibrated", "pose-doubtful", "size-needed"};
  for (const CodeInfo& code : check_codes())
    EXPECT_NE(planted.contains(code.id), is_of_no_file(code.id) || of_devices.contains(code.id)) << code.id;
}

}  // namespace
}  // namespace fca::test
