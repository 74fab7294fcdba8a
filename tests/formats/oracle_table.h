// SPDX-License-Identifier: BSD-3-Clause
// Tables of oracles/: what a real program computed from a file of the corpus (oracles/README.md).
#pragma once

#include "formats/test_files.h"

#include <fca/formats/wording.h>

#include <cmath>

namespace fca::test {

struct OracleRow {
  Ray ray;      ///< Of "unproject" rows, nan: the program calls the pixel invalid.
  Pixel pixel;  ///< Of "project" rows, nan: the program calls the ray invalid.
};

struct OracleTable {
  std::string file;  ///< Below corpus/.
  std::size_t camera = 0;
  std::vector<OracleRow> rows;         ///< Those of "project".
  std::vector<OracleRow> unprojected;  ///< Those of "unproject".
};

inline OracleTable read_oracle_table(const fs::path& path) {
  OracleTable table;
  for (const std::string& line : split(read_file(path), '\n')) {
    const std::vector<std::string> fields = split(line, '\t');
    if (line.starts_with("# corpus file: ")) {
      table.file = fields.at(0).substr(std::string("# corpus file: ").size());
      table.camera = std::stoul(fields.at(1).substr(std::string("camera index: ").size()));
    } else if (line.starts_with("project\t")) {
      table.rows.push_back({{std::stod(fields.at(1)), std::stod(fields.at(2)), std::stod(fields.at(3))},
                            {std::stod(fields.at(4)), std::stod(fields.at(5))}});
    } else if (line.starts_with("unproject\t")) {
      table.unprojected.push_back({{std::stod(fields.at(3)), std::stod(fields.at(4)), std::stod(fields.at(5))},
                                   {std::stod(fields.at(1)), std::stod(fields.at(2))}});
    }
  }
  return table;
}

/// The tables of a folder of oracles/ printed by one consumer ("dso").
inline std::vector<OracleTable> oracle_tables(const std::string& folder, const std::string& consumer) {
  std::vector<OracleTable> tables;
  for (const fs::path& path : files_in(shared_dir() / "oracles" / folder, ".tsv")) {
    if (path.string().ends_with("." + consumer + ".tsv")) tables.push_back(read_oracle_table(path));
  }
  return tables;
}

inline bool has_shared() { return fs::exists(shared_dir() / "oracles") && fs::exists(shared_dir() / "corpus"); }

/// A file of the corpus as the command reads it, with everything that was said.
struct ReadCorpusFile {
  std::optional<Calibration> calibration;
  Diagnostics diagnostics;
};

inline ReadCorpusFile read_corpus_file(const std::string& file) {
  ReadCorpusFile result;
  std::optional<text::Document> document = text::read_document((shared_dir() / "corpus" / file).string(), result.diagnostics);
  if (document) result.calibration = read_calibration({*std::move(document)}, nullptr, {}, result.diagnostics);
  return result;
}

inline double distance(const Pixel& a, const Pixel& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

/// What a format's writer returns for a rig; an expectation fails where it refuses.
inline Written written_by(const Format& format, const text::Document* base, const Rig& rig, const WriteOptions& options = {}) {
  Diagnostics diagnostics;
  std::optional<Written> written = format.write(base, rig, options, diagnostics);
  EXPECT_TRUE(written) << (diagnostics.entries().empty() ? "nothing said" : message_of(diagnostics.entries().front()));
  return written ? *std::move(written) : Written();
}

}  // namespace fca::test
