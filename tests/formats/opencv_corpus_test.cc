// SPDX-License-Identifier: BSD-3-Clause
// Real OpenCV calibrations: nothing else is taken for one; what is read is written back byte for byte, and its pixels are those
// that OpenCV printed (oracles/README.md). corpus_test.cc has the table of what is read and refused.
#include "formats/oracle_camera.h"

#include <fca/formats/consumers/consumer.h>
#include <fca/formats/wording.h>

#include <cmath>
#include <cstdio>

namespace fca::test {
namespace {

bool has_corpus() { return fs::exists(shared_dir() / "corpus" / "opencv"); }

struct Outcome {
  std::optional<Calibration> calibration;
  Diagnostics diagnostics;
  std::string codes;
};

Outcome read(const fs::path& path, const ReadOptions& options = {}) {
  Outcome outcome;
  std::optional<text::Document> document = text::read_document(path.string(), outcome.diagnostics);
  if (document) outcome.calibration = read_calibration({*std::move(document)}, nullptr, options, outcome.diagnostics);
  for (const Diagnostic& entry : outcome.diagnostics.entries()) {
    if (outcome.codes.find(id_of(entry)) == std::string::npos)
      outcome.codes += (outcome.codes.empty() ? "" : " ") + id_of(entry);
  }
  return outcome;
}

TEST(OpenCvCorpus, WhatIsReadIsWrittenBackByteForByte) {
  if (!has_corpus()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  for (const fs::path& path : files_in(shared_dir() / "corpus" / "opencv")) {
    const Outcome outcome = read(path);
    if (!outcome.calibration) continue;
    Diagnostics diagnostics;
    const std::optional<Written> written =
        outcome.calibration->format->write(&outcome.calibration->documents.front(), outcome.calibration->rig, {}, diagnostics);
    ASSERT_TRUE(written) << path;
    EXPECT_TRUE(written->files.front().document.bytes() == read_file(path)) << path;
    EXPECT_TRUE(written->losses.empty()) << path << ": " << what_of(written->losses.front());
  }
}

// Any one parameter of any camera: one scalar of the file changes, and the rest of its bytes stays.
TEST(OpenCvCorpus, OneChangedParameterChangesOneNumber) {
  if (!has_corpus()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  int edits = 0;
  for (const fs::path& path : files_in(shared_dir() / "corpus" / "opencv")) {
    const Outcome outcome = read(path);
    if (!outcome.calibration || outcome.calibration->rig.cameras.empty()) continue;
    SCOPED_TRACE(path.filename());
    const text::Document& base = outcome.calibration->documents.front();
    const std::string& bytes = base.source().bytes;
    // The file has no key for a lens, or a pinhole's zeros.
    const bool no_lens = model_info(outcome.calibration->rig.cameras.front().model).id == "pinhole";
    for (std::size_t camera = 0; camera < outcome.calibration->rig.cameras.size(); ++camera) {
      Rig rig = outcome.calibration->rig;
      const std::span<double> values = parameter_values(rig.cameras[camera].model);
      for (std::size_t i = 0; i < (no_lens ? 4 : values.size()); ++i) {
        const double before = values[i];
        // A float, so that a matrix of floats can hold it.
        values[i] = static_cast<float>(before + 0.015625);
        Diagnostics diagnostics;
        const std::optional<Written> written = find_format("opencv")->write(&base, rig, {}, diagnostics);
        ASSERT_TRUE(written);
        const std::string result = written->files.front().document.bytes();
        Parsed parsed = parse(result, path.filename().string());
        ASSERT_TRUE(parsed.document) << parsed.rendered();
        const std::vector<const text::Node*> old_scalars = scalars_of(base);
        const std::vector<const text::Node*> new_scalars = scalars_of(*parsed.document);
        // MATLAB's two radial coefficients become three when k3 is no longer 0.
        const bool grown = new_scalars.size() == old_scalars.size() + 1;
        if (!grown) {
          ASSERT_EQ(new_scalars.size(), old_scalars.size());
          std::size_t changed = 0;
          std::size_t place = 0;
          for (std::size_t k = 0; k < new_scalars.size(); ++k) {
            if (new_scalars[k]->value == old_scalars[k]->value) continue;
            ++changed;
            place = k;
          }
          ASSERT_EQ(changed, 1U) << model_info(rig.cameras[camera].model).parameters[i].name;
          const text::Span was = old_scalars[place]->span;
          EXPECT_EQ(result.substr(0, was.offset), bytes.substr(0, was.offset));
          EXPECT_EQ(result.substr(new_scalars[place]->span.end()), bytes.substr(was.end()));
        }
        const Calibration back = [&] {
          std::optional<Calibration> again = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
          EXPECT_TRUE(again) << parsed.rendered();
          return again ? *std::move(again) : Calibration();
        }();
        EXPECT_TRUE(back.rig.cameras == rig.cameras);
        values[i] = before;
        ++edits;
      }
    }
  }
  std::printf("%d edits\n", edits);
  EXPECT_GT(edits, 500);
}

// Everything else in the corpus: other formats, and the inputs of OpenCV's samples (image lists, board settings).
TEST(OpenCvCorpus, NothingElseIsTakenForACalibration) {
  if (!has_corpus()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  int asked = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(shared_dir() / "corpus")) {
    if (!entry.is_regular_file() || entry.path().parent_path().filename() == "opencv") continue;
    Diagnostics ignored;
    const std::optional<text::Document> document = text::read_document(entry.path().string(), ignored);
    if (!document) continue;
    const ProbeResult result = find_format("opencv")->probe(*document);
    EXPECT_EQ(result.score, 0) << entry.path() << ": " << text::text_of(result.why);
    if (entry.path().parent_path().filename() == "opencv_not_a_calibration") {
      EXPECT_FALSE(detect_format(*document, ignored)) << entry.path();
      ++asked;
    }
  }
  EXPECT_GE(asked, 10);
}

struct Row {
  Ray ray;
  Pixel pixel;
};

TEST(OpenCvCorpus, PixelsAreThoseOpenCvPrinted) {
  if (!has_corpus()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  int tables = 0;
  int compared = 0;
  for (const fs::path& path : files_in(shared_dir() / "oracles" / "opencv")) {
    const std::vector<std::string> lines = split(read_file(path), '\n');
    const std::vector<std::string> head = split(lines.at(0), '\t');
    const std::string file = head.at(0).substr(std::string("# corpus file: ").size());
    const std::size_t index = std::stoul(head.at(1).substr(std::string("camera index: ").size()));
    const Outcome outcome = read(shared_dir() / "corpus" / file);
    ASSERT_TRUE(outcome.calibration) << file << outcome.codes;
    SCOPED_TRACE(file);
    ++tables;
    const CameraModel& model = outcome.calibration->rig.cameras.at(index).model;
    const consumers::ConsumerView view =
        consumers::find_consumer("opencv")->load(read_file(shared_dir() / "corpus" / file), {});
    ASSERT_GT(view.cameras.size(), index);
    int here = 0;
    double worst = 0.0;
    for (const std::string& line : lines) {
      const std::vector<std::string> words = split(line, '\t');
      if (words.empty() || words.front() != "project") continue;
      const Row row = {{std::stod(words.at(1)), std::stod(words.at(2)), std::stod(words.at(3))},
                       {std::stod(words.at(4)), std::stod(words.at(5))}};
      const bool mirrored = row.ray[2] <= 0.0 && model_info(model).id != "mei";
      if (mirrored || !std::isfinite(row.pixel[0])) continue;
      const std::optional<Pixel> ours = project(model, row.ray);
      if (!ours) {
        EXPECT_TRUE(folds_before(view.cameras[index], row.ray)) << "we have no pixel at z = " << row.ray[2];
        continue;
      }
      const double difference = std::hypot((*ours)[0] - row.pixel[0], (*ours)[1] - row.pixel[1]);
      // Rows near 90 degrees lie at 1e12 px, where a double's last place is 1e-4 px.
      const double scale = std::max({1.0, std::abs(row.pixel[0]) / 1000.0, std::abs(row.pixel[1]) / 1000.0});
      EXPECT_LE(difference, 1e-9 * scale) << row.pixel[0] << " " << row.pixel[1];
      worst = std::max(worst, difference / scale);
      ++here;
    }
    std::printf("%-90s cam%zu: %d rows, worst %.2g px\n", file.c_str(), index, here, worst);
    EXPECT_GE(here, 10);
    compared += here;
  }
  EXPECT_GE(tables, 13);
  EXPECT_GE(compared, 300);
}

}  // namespace
}  // namespace fca::test
