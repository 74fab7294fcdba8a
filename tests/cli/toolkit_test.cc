// SPDX-License-Identifier: BSD-3-Clause
// fca::toolkit as a C++ program uses it: requests and results of plain values, without a command line.
#include "cli/run_program.h"

#include <fca/code.h>
#include <fca/fca.h>
#include <fca/formats/text/read_document.h>
#include <fca/formats/wording.h>
#include <fca/toolkit/acceptance.h>

#include <algorithm>
#include <map>
#include <set>

namespace fca::test {
namespace {

bool has(const Diagnostics& diagnostics, std::string_view code) {
  return std::ranges::any_of(diagnostics.entries(), [code](const Diagnostic& entry) { return id_of(entry) == code; });
}

ConvertRequest request_for(const std::string& file, const char* format) {
  ConvertRequest request;
  request.inputs.files = {file};
  request.to = find_format(format);
  request.provenance = ProvenanceComment::kNone;
  return request;
}

/// Files that are nowhere on the disk.
class FilesInMemory : public Files {
 public:
  explicit FilesInMemory(std::map<std::string, std::string> texts) : texts_(std::move(texts)) {}

 protected:
  [[nodiscard]] std::optional<text::Source> fetch(const std::string& path, Diagnostics& diagnostics) const override {
    const auto found = texts_.find(path);
    if (found != texts_.end()) return text::Source{path, found->second};
    diagnostics.add(Code::kImageMissing, {}, {path, 0, 0});
    return std::nullopt;
  }

 private:
  std::map<std::string, std::string> texts_;
};

TEST(Toolkit, AConversionIsTheCommandsByteForByte) {
  ConvertRequest request = request_for(kTumvi, "orbslam3");
  request.inputs.parts = {kImu};
  Files files;
  const ConvertResult result = convert(request, files);
  EXPECT_EQ(result.status, Status::kDone);
  ASSERT_EQ(result.files.size(), 1U);
  const RunResult run = run_program({"convert", kTumvi, "--with", kImu, "--to", "orbslam3", "--no-provenance"});
  EXPECT_EQ(result.files.front().bytes, run.out);
  EXPECT_EQ(result.files.front().cameras, (std::vector<std::string>{"cam0", "cam1"}));
  ASSERT_FALSE(result.proofs.empty());
  EXPECT_TRUE(result.proofs.front().agrees());
  EXPECT_EQ(result.cameras.size(), 2U);
}

TEST(Toolkit, AModelIsFittedAndItsErrorIsAValue) {
  ConvertRequest request = request_for(kTumvi, "orbslam3");
  request.model = find_model("eucm");
  request.inputs.max_angle_rad = 97.5 / 180.0 * 3.14159265358979;
  Files files;
  const ConvertResult result = convert(request, files);
  EXPECT_EQ(result.status, Status::kDone);
  ASSERT_EQ(result.cameras.size(), 2U);
  ASSERT_TRUE(result.cameras.front().report);
  EXPECT_NEAR(result.cameras.front().report->statistics.error.rms, 0.0225, 1e-4);  // LIMITS.md: .0226 at best

  request.max_error_px = 0.01;
  const ConvertResult limited = convert(request, files);
  EXPECT_EQ(limited.status, Status::kRejected);
  EXPECT_TRUE(has(limited.diagnostics, "error-limit"));
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  EXPECT_FALSE(save(limited, folder.path().string(), diagnostics));
  EXPECT_TRUE(folder.names().empty());
}

TEST(Toolkit, FilesComeFromWhereTheCallerHasThem) {
  FilesInMemory files({{"memory.yaml", read_file(kDs)}});
  const ConvertResult result = convert(request_for("memory.yaml", "kalibr"), files);
  EXPECT_EQ(result.status, Status::kDone);
  ASSERT_EQ(result.files.size(), 1U);
  EXPECT_EQ(result.files.front().bytes, read_file(kDs));
  EXPECT_EQ(convert(request_for("other.yaml", "kalibr"), files).status, Status::kUnreadable);
}

TEST(Toolkit, HowItEndedSaysWhoIsAtFault) {
  FilesInMemory files({{"no.yaml", "a: 1\n"}, {"chain.yaml", read_file(kTumvi)}});
  EXPECT_EQ(convert(request_for("no.yaml", "orbslam3"), files).status, Status::kBadInput);
  ConvertRequest request = request_for("chain.yaml", "kalibr");
  request.mode = FormatMode::find(*find_format("orbslam3"), "stereo");
  const ConvertResult without_use = convert(request, files);
  EXPECT_EQ(without_use.status, Status::kBadRequest);
  EXPECT_TRUE(has(without_use.diagnostics, "option-without-use"));
  request = request_for("chain.yaml", "ocamcalib");
  request.room.camera_files = false;
  const ConvertResult no_room = convert(request, files);
  EXPECT_EQ(no_room.status, Status::kBadRequest);
  EXPECT_TRUE(has(no_room.diagnostics, "one-camera-per-file"));
  request.room = {};
  EXPECT_EQ(convert(request, files).files.size(), 2U);
}

TEST(Toolkit, CamerasAreChosenByNameOrPlace) {
  Files files;
  ConvertRequest request = request_for(kTumvi, "kalibr");
  for (const CameraChoice& choice : {CameraChoice{"cam1"}, CameraChoice{"1", 1}}) {
    request.inputs.cameras = {{choice}};
    const ConvertResult result = convert(request, files);
    ASSERT_EQ(result.cameras.size(), 1U) << choice.name;
    EXPECT_EQ(result.cameras.front().source.name, "cam1");
  }
  request.inputs.cameras = {{CameraChoice{"cam7"}}};
  EXPECT_EQ(convert(request, files).status, Status::kBadRequest);
}

// The file written calls them otherwise: that is for people, and the shell's to say.
TEST(Toolkit, ALossNamesItsCameraAsTheInputDoes) {
  ConvertRequest request = request_for(kDs, "opencv");
  request.inputs.cameras = {{"1", 1}, {"0", 0}};
  Files files;
  const ConvertResult result = convert(request, files);
  std::set<std::string> owners;
  for (const Loss& loss : result.losses) {
    if (id_of(loss) == "time-offset-dropped") owners.insert(loss.owner);
  }
  EXPECT_EQ(owners, (std::set<std::string>{"cam0", "cam1"}));
  EXPECT_EQ(result.cameras.front().source.name, "cam1");
}

TEST(Toolkit, SavedFilesAreWholeUnderTheirNames) {
  Files files;
  ConvertResult result = convert(request_for(kTumvi, "ocamcalib"), files);
  const TemporaryFolder folder;
  ASSERT_TRUE(save(result, folder / "made", result.diagnostics));
  for (const ConvertedFile& file : result.files)
    EXPECT_EQ(read_file(std::filesystem::path(folder / "made") / file.name), file.bytes) << file.name;
}

TEST(Toolkit, AFileIsCheckedAgainstItsReader) {
  Files files;
  const std::string text = with_replaced(read_file(kTumvi), "pinhole", "pinnhole");
  const CheckResult result = check({}, {"chain.yaml", text}, files);
  EXPECT_TRUE(result.report.has(Severity::kError));
  CheckRequest request;
  request.program = find_program("orbslam3");
  const CheckResult other = check(request, {kTumvi, read_file(kTumvi)}, files);
  ASSERT_TRUE(other.instead) << "what converting it to that program's format gives";
  EXPECT_EQ(other.instead->to->id, "orbslam3");
}

TEST(Toolkit, TwoFilesAreCompared) {
  Files files;
  CompareRequest request;
  request.reference.files = {kTumvi};
  request.files = {kTumvi, kDs};
  request.max_error_px = 0.25;
  const CompareResult result = compare(request, files);
  ASSERT_EQ(result.files.size(), 2U);
  EXPECT_EQ(result.files[0].status, Status::kDone);
  EXPECT_TRUE(result.files[0].comparison->identical());
  EXPECT_NE(result.files[1].status, Status::kDone);
  EXPECT_EQ(result.status, result.files[1].status);
}

TEST(Toolkit, EveryModelIsTriedForEveryCamera) {
  Files files;
  Inputs inputs;
  inputs.files = {kDs};
  const ModelsResult result = compare_models(inputs, files);
  EXPECT_EQ(result.status, Status::kDone);
  for (const auto& [camera, candidates] : result.cameras) {
    const auto fitted = std::ranges::count(all_models(), false, &ModelInfo::kept_only);
    EXPECT_EQ(candidates.size(), static_cast<std::size_t>(fitted));
    EXPECT_EQ(recommended(candidates, nullptr)->model->id, model_info(camera.model).id) << "its own is exact";
  }
}

TEST(Toolkit, AnImageIsMappedPixelByPixel) {
  Files files;
  RemapRequest request;
  request.inputs.files = {kTumvi};
  request.inputs.cameras = {{CameraChoice{"cam0"}}};
  request.view = PinholeView{1.5, ImageSize{200, 150}};
  const RemapResult result = remap(request, files);
  ASSERT_EQ(result.status, Status::kDone);
  EXPECT_EQ(result.map.size, (ImageSize{200, 150}));
  EXPECT_EQ(result.mask.size(), 200U * 150U);
  const ImageSize size = *result.source.image_size;
  Image grey{size.width, size.height, 1, Image::Sample::k8Bit, {}};
  grey.bytes.assign(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), 77);
  const std::optional<Image> seen = remapped(grey, result.map, Interpolation::kBilinear);
  ASSERT_TRUE(seen);
  for (std::size_t i = 0; i < result.mask.size(); ++i) {
    if (result.mask[i] == 255) {
      ASSERT_EQ(seen->bytes[i], 77) << i;
    }
  }
}

TEST(Toolkit, AnAcceptanceIsACodeAndPerhapsACamera) {
  for (const CodeInfo& row : all_codes()) {
    const TypedAcceptance typed = parse_acceptance(std::string(row.id) + ":left:cam0");
    EXPECT_EQ(typed.id, row.id);
    ASSERT_EQ(typed.acceptance.has_value(), find_code(row.id) != nullptr) << row.id;
    if (!typed.acceptance) continue;
    EXPECT_TRUE(same_id(typed.acceptance->code, row.code)) << row.id;
    EXPECT_EQ(typed.acceptance->camera, "left:cam0");
  }
  EXPECT_EQ(parse_acceptance("poses-contradict").acceptance->camera, "");
  EXPECT_EQ(parse_acceptance("poses-contradict:").acceptance->camera, "");
  for (const char* word : {"", ":", ":cam0", "no-such-code", "no-such-code:cam0"})
    EXPECT_FALSE(parse_acceptance(word).acceptance) << word;
}

// A program that forgets something is told so.
TEST(Toolkit, ARequestThatLacksSomethingIsRefused) {
  Files files;
  const ConvertResult no_format = convert(request_for(kDs, "orbslam"), files);  // a typo: no such format
  EXPECT_EQ(no_format.status, Status::kBadRequest);
  EXPECT_TRUE(has(no_format.diagnostics, "no-target"));
  ConvertRequest no_input = request_for(kDs, "kalibr");
  no_input.inputs.files.clear();
  const ConvertResult nothing = convert(no_input, files);
  EXPECT_EQ(nothing.status, Status::kBadRequest);
  EXPECT_TRUE(has(nothing.diagnostics, "no-input"));

  EXPECT_EQ(read({}, files).status, Status::kBadRequest);
  EXPECT_EQ(report({}, files).status, Status::kBadRequest);
  EXPECT_EQ(compare({}, files).status, Status::kBadRequest);
  EXPECT_EQ(compare_models(Inputs{}, files).status, Status::kBadRequest);
  EXPECT_EQ(remap({}, files).status, Status::kBadRequest);
  CompareRequest beside_nothing;
  beside_nothing.reference.files = {kDs};
  EXPECT_EQ(compare(beside_nothing, files).status, Status::kBadRequest);

  RemapRequest own_model;
  own_model.inputs.files = {kTumvi};
  own_model.inputs.cameras = {{CameraChoice{"cam0"}}};
  own_model.view = AsModel{};
  const RemapResult same = remap(own_model, files);
  EXPECT_EQ(same.status, Status::kDone);
  EXPECT_EQ(same.view.model, same.source.model);
}

// "camchain.yaml imu.yaml"
TEST(Toolkit, OneFileWithCamerasTakesTheOthersAsItsParts) {
  Files files;
  Inputs inputs;
  inputs.files = {kImu, kTumvi};
  const Inputs recognised = with_parts_recognised(inputs, files);
  EXPECT_EQ(recognised.files, (std::vector<std::string>{kTumvi}));
  EXPECT_EQ(recognised.parts, (std::vector<std::string>{kImu}));
  inputs.files = {kTumvi, kDs};
  EXPECT_EQ(with_parts_recognised(inputs, files).files, inputs.files);
}

TEST(Toolkit, AReportHoldsWhatThePageShows) {
  Files files;
  ReportRequest request;
  request.conversion = request_for(kDs, "orbslam3");
  const ReportResult result = report(request, files);
  EXPECT_EQ(result.status, Status::kDone);
  ASSERT_TRUE(result.reading.calibration);
  ASSERT_TRUE(result.conversion);
  EXPECT_EQ(result.conversion->to->id, "orbslam3");
  EXPECT_EQ(result.checks.size(), 1U);
  EXPECT_TRUE(result.models.empty());
}

}  // namespace
}  // namespace fca::test
