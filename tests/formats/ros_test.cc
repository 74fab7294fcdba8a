// SPDX-License-Identifier: BSD-3-Clause
// ROS's camera_info: what K, D, R, P, binning and roi mean, what is written comes back, and what the program itself computed.
#include "formats/oracle_table.h"
#include "formats/rigs.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/formats/text/dialect.h>
#include <fca/formats/text/read_document.h>
#include <fca/formats/wording.h>
#include <fca/rig/rotation.h>

#include <random>

namespace fca::test {
namespace {

using Vector = std::array<double, 3>;

const Format& ros() { return *find_format("ros"); }
const consumers::Consumer& program() { return *consumers::find_consumer("ros"); }
std::string message(const std::string& name) { return read_file(testdata_dir() / "ros" / "messages" / name); }
std::string good(const std::string& name) { return read_file(testdata_dir() / "ros" / "good" / name); }

/// The files of several cameras as one rig.
Rig joined(const std::vector<std::string>& files) {
  std::vector<text::Document> documents;
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < files.size(); ++i)
    documents.push_back(*text::parse_document({std::to_string(i) + ".yaml", files[i]}, diagnostics));
  ReadOptions options;
  options.join = true;
  const std::optional<Calibration> calibration = read_calibration(documents, nullptr, options, diagnostics);
  EXPECT_TRUE(calibration);
  return calibration ? calibration->rig : Rig();
}

Rig read_back(const Written& written) {
  std::vector<std::string> files;
  for (const Written::File& file : written.files) files.push_back(file.document.bytes());
  return joined(files);
}

/// The numbers of a matrix of a file.
std::vector<double> numbers(const std::string& bytes, const std::string& key) {
  const Calibration calibration = calibration_of(bytes, "a.yaml");
  const text::Node* node = text::find(calibration.documents.front().root(), key, text::Dialect::kOpenCv);
  std::vector<double> values;
  for (const text::Node& item : text::find(*node, "data", text::Dialect::kOpenCv)->items)
    values.push_back(std::stod(item.value));
  return values;
}

/// Where a point in the camera's own frame lands in the rectified image: P [R p; 1], as CameraInfo.msg defines it, where the
/// fourth column is of the rectified frame's origin and so is not added for a point in the camera's own frame.
Pixel rectified(const std::string& bytes, const Vector& p) {
  const std::vector<double> R = numbers(bytes, "rectification_matrix");
  const std::vector<double> P = numbers(bytes, "projection_matrix");
  Vector q{};
  for (std::size_t i = 0; i < 9; ++i) q.at(i / 3) += R[i] * p.at(i % 3);
  return {P[0] * q[0] / q[2] + P[2], P[5] * q[1] / q[2] + P[6]};
}

Vector transformed(const Transform& T, const Vector& p) {
  const Vector r = rotated(T, p);
  return {r[0] + T(0, 3), r[1] + T(1, 3), r[2] + T(2, 3)};
}

// A point that both see stands in one row of the rectified images, and their columns differ by f B / z.
TEST(Ros, APairsPoseIsWhatMakesRowsMeet) {
  const std::string left = good("left.yaml");
  const std::string right = good("right.yaml");
  const Rig rig = joined({left, right});
  ASSERT_EQ(rig.cameras.size(), 2U);
  const std::optional<Transform> T = rig.resolve("stereo/right", "stereo/left");
  ASSERT_TRUE(T);
  EXPECT_NEAR(distance_of(*T), 0.1101, 1e-9);
  EXPECT_LT((*T)(0, 3), 0.0) << "the right camera sees the left one's origin to its left";
  for (const Vector& p : {Vector{0.0, 0.0, 2.0}, Vector{0.4, -0.3, 1.5}, Vector{-1.0, 0.6, 4.0}}) {
    const Pixel l = rectified(left, p);
    const Pixel r = rectified(right, transformed(*T, p));
    EXPECT_NEAR(l[1], r[1], 1e-9);
    EXPECT_GT(l[0], r[0]);
  }
}

// Two files of cameras that are no pair say nothing of their relation.
TEST(Ros, CamerasThatAreNoPairHaveNoPose) {
  const Rig rig = joined({good("mono.yaml"), good("left.yaml")});
  EXPECT_FALSE(rig.resolve(rig.cameras[0].name, rig.cameras[1].name));
}

struct Pair {
  Rig rig;
  Transform T_second_first;
};

Pair pair_at(const Quaternion& q, const Vector& t) {
  Pair pair = {sample_rig("kb4", {.two = true}), pose_of(normalised(q), t)};
  pair.rig.poses = {{"cam1", "cam0", pair.T_second_first}};
  return pair;
}

// The rectification that we choose: rows meet, and the pose comes back to rounding.
TEST(Ros, AChosenRectificationMakesRowsMeet) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const double baseline = i % 2 == 0 ? -0.2 : 0.2;
    const Vector t = {baseline, 0.05 * number(random), 0.05 * number(random)};
    const Pair pair = pair_at({0.15 * number(random), 0.15 * number(random), 0.15 * number(random), 1.0}, t);
    const Written written = written_by(ros(), nullptr, pair.rig);
    ASSERT_EQ(written.files.size(), 2U);
    const Rig back = read_back(written);
    ASSERT_TRUE(back.resolve("cam1", "cam0"));
    EXPECT_LE(test::element_difference(*back.resolve("cam1", "cam0"), pair.T_second_first), 1e-13);
    const std::string first = written.files[0].document.bytes();
    const std::string second = written.files[1].document.bytes();
    const std::vector<double> P = numbers(first, "projection_matrix");
    const std::vector<double> Q = numbers(second, "projection_matrix");
    for (const std::size_t place : {0U, 5U, 6U}) EXPECT_EQ(P[place], Q[place]) << "StereoCameraModel asserts that";
    EXPECT_TRUE(P[3] == 0.0 || Q[3] == 0.0) << "one camera is the origin";
    EXPECT_LE(P[3], 0.0);
    EXPECT_LE(Q[3], 0.0) << "the left one";
    for (const Vector& p : {Vector{0.0, 0.0, 2.0}, Vector{0.4, -0.3, 1.5}, Vector{-1.0, 0.6, 4.0}}) {
      const Pixel a = rectified(first, p);
      const Pixel b = rectified(second, transformed(pair.T_second_first, p));
      EXPECT_NEAR(a[1], b[1], 1e-9);
      EXPECT_GT(std::abs(a[0] - b[0]), 1.0);
    }
    EXPECT_EQ(std::ranges::find(written.losses, Code::kPoseRecomputed, &Loss::kind), written.losses.end());
  }
}

// Of cameras that look to different sides, or stand one above the other, each is rectified alone, and the pose is told as lost.
TEST(Ros, CamerasWithoutCommonRowsAreNoPair) {
  const Pair apart = pair_at({0.0, 0.70710678118654752, 0.0, 0.70710678118654752}, {0.1, 0.0, 0.0});
  const Pair above = pair_at({0.01, 0.02, 0.0, 1.0}, {0.02, -0.1, 0.0});
  for (const Pair& pair : {apart, above}) {
    Diagnostics diagnostics;
    const std::optional<Written> written = write_calibration(ros(), nullptr, pair.rig, {}, diagnostics);
    ASSERT_TRUE(written);
    for (const Written::File& file : written->files) {
      EXPECT_EQ(numbers(file.document.bytes(), "rectification_matrix"), (std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1}));
      EXPECT_EQ(numbers(file.document.bytes(), "projection_matrix")[3], 0.0);
    }
    EXPECT_TRUE(std::ranges::any_of(written->losses, [](const Loss& loss) { return id_of(loss) == "pose-dropped"; }));
    EXPECT_FALSE(read_back(*written).resolve("cam1", "cam0"));
  }
}

TEST(Ros, SkewComesBack) {
  for (const char* lens : {"radtan", "kb4"}) {
    Rig rig = sample_rig(lens, {});
    rig.cameras.front().model = with_skew(rig.cameras.front().model, 0.75).value();
    EXPECT_EQ(read_back(written_by(ros(), nullptr, rig)).cameras.front().model, rig.cameras.front().model) << lens;
  }
}

TEST(Ros, EveryModelComesBackAndTheProgramComputesTheSame) {
  for (const StoredModel& stored : ros().models) {
    if (!stored.stock) continue;  // it leaves the skew out
    SCOPED_TRACE(stored.model);
    Rig rig = sample_rig(stored.model == "rational" ? "radtan" : std::string(stored.model), {});
    if (stored.model == "rational")
      rig.cameras.front().model =
          model_of("rational", {458.6, 457.3, 367.2, 248.4, -0.28, 0.07, 0.0002, 0.00002, 0.001, 0.01, 0.002, 0.0005});
    const Written written = written_by(ros(), nullptr, rig);
    const std::string bytes = written.files.front().document.bytes();
    EXPECT_EQ(read_back(written).cameras.front().model, rig.cameras.front().model);
    const ProofResult proof = prove(program(), bytes, {}, rig);
    EXPECT_TRUE(proof.agrees()) << (proof.refusals.empty() ? "" : sentence_of(proof.refusals.front()));
    EXPECT_LE(proof.max_diff_px, 1e-9);
    EXPECT_GT(proof.compared_share, 0.9);
  }
}

// What oracles/ros_camera_info measured of such files: pixels of (u - x_offset) / binning.
TEST(Ros, BinningAndRegionGiveTheImageThatIsPublished) {
  const Rig rig = calibration_of(good("binned.yaml"), "binned.yaml").rig;
  const Camera& camera = rig.cameras.front();
  EXPECT_EQ(camera.image_size, (ImageSize{600, 480}));
  const Pixel centre = principal_point(camera.model);
  EXPECT_NEAR(centre[0], (640.25 - 40.0) / 2.0, 1e-12);
  EXPECT_NEAR(centre[1], (511.5 - 24.0) / 2.0, 1e-12);
  const ProofResult proof = prove(program(), good("binned.yaml"), {}, rig);
  EXPECT_TRUE(proof.agrees());
  EXPECT_LE(proof.max_diff_px, 1e-9);
  EXPECT_TRUE(proof.other_numbers.empty());
}

TEST(Ros, AnEditOfABinnedCameraKeepsTheOtherNumbers) {
  const std::string bytes = good("binned.yaml");
  const Calibration calibration = calibration_of(bytes, "binned.yaml");
  Rig rig = calibration.rig;
  ASSERT_TRUE(set_parameter(rig.cameras.front().model, "cx", 301.0));
  const Written written = written_by(ros(), &calibration.documents.front(), rig);
  const std::string edited = written.files.front().document.bytes();
  EXPECT_EQ(numbers(edited, "camera_matrix")[2], 642.0);
  EXPECT_EQ(calibration_of(edited, "a.yaml").rig.cameras, rig.cameras);
  EXPECT_EQ(numbers(edited, "camera_matrix")[0], 1168.68);
  EXPECT_EQ(numbers(edited, "projection_matrix")[2], 642.0) << "P is of the same image";
  EXPECT_EQ(numbers(edited, "distortion_coefficients").size(), 4U);
}

// The rectified image of another lens is the user's to choose; K and the coefficients are the lens.
TEST(Ros, AnEditChangesItsOwnNumbers) {
  const std::string bytes = good("mono.yaml");
  const Calibration calibration = calibration_of(bytes, "mono.yaml");
  Rig rig = calibration.rig;
  ASSERT_TRUE(set_parameter(rig.cameras.front().model, "k2", 0.0815));
  ASSERT_TRUE(set_parameter(rig.cameras.front().model, "fx", 512.25));
  const Written written = written_by(ros(), &calibration.documents.front(), rig);
  EXPECT_EQ(written.files.front().document.bytes(),
            with_replaced(with_replaced(bytes, "0.0792", "0.0815"), "511.52", "512.25"));
}

TEST(Ros, AnotherModelTakesTheOnesPlace) {
  const Calibration calibration = calibration_of(good("ost.yaml"), "ost.yaml");
  Rig rig = calibration.rig;
  rig.cameras.front().model = sample_model("kb4");
  const Written written = written_by(ros(), &calibration.documents.front(), rig);
  const std::string bytes = written.files.front().document.bytes();
  EXPECT_EQ(calibration_of(bytes, "a.yaml").rig.cameras, rig.cameras);
  EXPECT_EQ(numbers(bytes, "projection_matrix"), numbers(good("ost.yaml"), "projection_matrix"));
  EXPECT_TRUE(program().load(bytes, {}).loads());
}

// P of a camera that is rectified as it is, is K: it goes with it.
TEST(Ros, ThePOfAPlainCameraFollowsItsK) {
  const Rig rig = sample_rig("radtan", {});
  const std::string bytes = written_by(ros(), nullptr, rig).files.front().document.bytes();
  const Calibration calibration = calibration_of(bytes, "a.yaml");
  Rig changed = calibration.rig;
  ASSERT_TRUE(set_parameter(changed.cameras.front().model, "cy", 250.125));
  const std::string edited = written_by(ros(), &calibration.documents.front(), changed).files.front().document.bytes();
  EXPECT_EQ(numbers(edited, "camera_matrix")[5], 250.125);
  EXPECT_EQ(numbers(edited, "projection_matrix")[6], 250.125);
}

// A pair that is read, given another lens and written: its rectification is a fact of the files and stays.
TEST(Ros, APairKeepsItsRectification) {
  Rig rig = joined({good("left.yaml"), good("right.yaml")});
  ASSERT_TRUE(set_parameter(rig.cameras[0].model, "k1", -0.004));
  const Written written = written_by(ros(), nullptr, rig);
  for (const char* key : {"rectification_matrix", "projection_matrix"}) {
    EXPECT_EQ(numbers(written.files[0].document.bytes(), key), numbers(good("left.yaml"), key));
    const std::vector<double> there = numbers(good("right.yaml"), key);
    const std::vector<double> now = numbers(written.files[1].document.bytes(), key);
    for (std::size_t i = 0; i < there.size(); ++i) EXPECT_NEAR(now[i], there[i], 1e-12);
  }
}

// cv::projectPoints bends nothing where all coefficients are 0, and image_geometry does not even call it.
TEST(Ros, AnEquidistantCameraOfZerosIsMisread) {
  Rig rig = sample_rig("kb4", {});
  for (const ParameterId k : ParameterIds{"k1", "k2", "k3", "k4"})
    ASSERT_TRUE(set_parameter(rig.cameras.front().model, k, 0.0));
  const std::string bytes = written_by(ros(), nullptr, rig).files.front().document.bytes();
  const ProofResult proof = prove(program(), bytes, {}, rig);
  EXPECT_GT(proof.misread_px, 10.0);
}

// parse_ini.cpp: the number of coefficients is the model.
TEST(Ros, AnIniIsReadEditedAndProven) {
  const std::string bytes = good("videre.ini");
  const Calibration calibration = calibration_of(bytes, "videre.ini");
  ASSERT_EQ(calibration.format, &ros());
  Rig rig = calibration.rig;
  EXPECT_EQ(rig.cameras.front().name, "narrow_stereo/mono");
  EXPECT_EQ(model_info(rig.cameras.front().model).id, "radtan");
  EXPECT_TRUE(prove(program(), bytes, {}, rig).agrees());
  ASSERT_TRUE(set_parameter(rig.cameras.front().model, "k2", 0.04125));
  const Written written = written_by(ros(), &calibration.documents.front(), rig);
  EXPECT_EQ(written.files.front().document.bytes(), with_replaced(bytes, "0.03823", "0.04125"));
  rig.cameras.front().model =
      model_of("rational", {458.6, 457.3, 367.2, 248.4, -0.28, 0.07, 0.0002, 0.00002, 0.001, 0.01, 0.002, 0.0005});
  const Written rational = written_by(ros(), &calibration.documents.front(), rig);
  const Calibration back = calibration_of(rational.files.front().document.bytes(), "a.ini");
  EXPECT_EQ(back.rig.cameras, rig.cameras);
  EXPECT_TRUE(prove(program(), rational.files.front().document.bytes(), {}, rig).agrees());
}

TEST(Ros, AFreshIniComesBackAndHoldsNoFisheye) {
  WriteOptions options;
  options.extension = ".ini";
  for (const char* model : {"radtan", "pinhole"}) {
    const Rig rig = sample_rig(model, {});
    Diagnostics diagnostics;
    const std::optional<Written> written = ros().write(nullptr, rig, options, diagnostics);
    ASSERT_TRUE(written);
    const std::string bytes = written->files.front().document.bytes();
    EXPECT_TRUE(bytes.starts_with("# Camera intrinsics\n\n[image]\n"));
    EXPECT_EQ(calibration_of(bytes, "a.ini").rig.cameras.front().model, rig.cameras.front().model);
    EXPECT_TRUE(prove(program(), bytes, {}, rig).agrees());
  }
  Diagnostics diagnostics;
  EXPECT_FALSE(ros().write(nullptr, sample_rig("kb4", {}), options, diagnostics));
  EXPECT_EQ(id_of(diagnostics.entries().front()), "model-not-storable");
}

// An .ini that is to hold a fisheye becomes YAML.
TEST(Ros, AnIniThatCannotHoldTheLensIsRewritten) {
  const Calibration calibration = calibration_of(good("videre.ini"), "videre.ini");
  Rig rig = calibration.rig;
  rig.cameras.front().model = sample_model("kb4");
  const Written written = written_by(ros(), &calibration.documents.front(), rig);
  EXPECT_EQ(written.files.front().document.syntax(), text::Syntax::kYaml);
  EXPECT_EQ(calibration_of(written.files.front().document.bytes(), "a.yaml").rig.cameras.front().model,
            rig.cameras.front().model);
}

// ROS chooses the parser by the file's name.
TEST(Ros, TheNameOfTheOutputDecidesItsSyntax) {
  for (const auto& [input, extension, syntax] :
       {std::tuple("mono.yaml", ".ini", text::Syntax::kWords), std::tuple("videre.ini", ".yaml", text::Syntax::kYaml),
        std::tuple("videre.ini", ".ini", text::Syntax::kWords), std::tuple("mono.yaml", "", text::Syntax::kYaml)}) {
    const std::string bytes = good(input);
    const Calibration calibration = calibration_of(bytes, input);
    WriteOptions options;
    options.extension = extension;
    Diagnostics diagnostics;
    const std::optional<Written> written = ros().write(&calibration.documents.front(), calibration.rig, options, diagnostics);
    ASSERT_TRUE(written);
    const text::Document& document = written->files.front().document;
    EXPECT_EQ(document.syntax(), syntax) << input << " " << extension;
    EXPECT_EQ(calibration_of(document.bytes(), "a").rig, calibration.rig);
    EXPECT_EQ(document.bytes() == bytes, calibration.documents.front().syntax() == syntax);
  }
}

// The calibrator's ost.txt of a pair: both cameras, each with its own section.
TEST(Ros, AnIniOfAPairIsAPair) {
  const std::string bytes = read_file(testdata_dir() / "ros" / "bad" / "ost.txt");
  const Calibration calibration = calibration_of(bytes, "ost.txt");
  ASSERT_EQ(calibration.rig.cameras.size(), 2U);
  const std::optional<Transform> T = calibration.rig.resolve("narrow_stereo/right", "narrow_stereo/left");
  ASSERT_TRUE(T);
  EXPECT_NEAR((*T)(0, 3), -31.5512 / 262.92743, 1e-12);
  Rig rig = calibration.rig;
  ASSERT_TRUE(set_parameter(rig.cameras[1].model, "p1", -0.0007));
  const Written written = written_by(ros(), &calibration.documents.front(), rig);
  ASSERT_EQ(written.files.size(), 1U);
  const std::string edited = written.files.front().document.bytes();
  EXPECT_EQ(calibration_of(edited, "a.ini").rig.cameras, rig.cameras);
  const std::size_t right = bytes.find("[narrow_stereo/right]");
  EXPECT_EQ(edited.substr(0, right), bytes.substr(0, right)) << "the left camera's";
}

// R = I and no baseline is what every camera alone specifies.
TEST(Ros, CamerasAloneStateNoPoseToEachOther) {
  const Rig rig = joined({good("mono.yaml"), good("mono.yaml")});
  ASSERT_EQ(rig.cameras.size(), 2U);
  EXPECT_FALSE(rig.resolve(rig.cameras[1].name, rig.cameras[0].name));
}

// What ROS printed of real files, against the model that our reader gives.
TEST(Ros, OurModelIsThePrograms) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  int compared = 0;
  for (const OracleTable& table : oracle_tables("ros_camera_info", "ros")) {
    const ReadCorpusFile file = read_corpus_file(table.file);
    ASSERT_TRUE(file.calibration) << table.file;
    for (const OracleRow& row : table.rows) {
      const std::optional<Pixel> ours = project(file.calibration->rig.cameras.at(table.camera).model, row.ray);
      // Ours ends where the polynomial folds; there the program goes on.
      if (!ours || std::isnan(row.pixel[0])) continue;
      EXPECT_LE(distance(*ours, row.pixel) / std::max(1.0, std::abs(row.pixel[0]) / 1000.0), 1e-9) << table.file;
      ++compared;
    }
  }
  EXPECT_GE(compared, 100);
}

// `rostopic echo` and `ros2 topic echo` print the message, whose keys and shapes are others than the file's.
TEST(Ros, APrintedMessageMeansWhatAFileMeans) {
  const Rig first = calibration_of(message("ros1.yaml"), "a.yaml").rig;
  ASSERT_EQ(first.cameras.size(), 1U);
  EXPECT_EQ(first.cameras[0].name, "left_optical");
  EXPECT_EQ(first.cameras[0].image_size, (ImageSize{640, 480}));
  EXPECT_EQ(model_info(first.cameras[0].model).id, "radtan");
  EXPECT_EQ(parameter(first.cameras[0].model, "k1"), -0.3125);
  const Rig second = calibration_of(message("ros2.yaml"), "b.yaml").rig;
  EXPECT_EQ(model_info(second.cameras.at(0).model).id, "kb4");
  EXPECT_EQ(parameter(second.cameras[0].model, "k4"), 0.00390625);
  for (const Rig& rig : {first, second}) {
    const Written file = written_by(ros(), nullptr, rig);
    EXPECT_TRUE(prove(program(), file.files.front().document.bytes(), {}, rig, file.files.front().cameras).agrees());
  }
}

// No program reads the message: it becomes a file, whatever was asked to be edited in it.
TEST(Ros, APrintedMessageBecomesAFile) {
  for (const char* name : {"ros1.yaml", "ros2.yaml"}) {
    const Calibration calibration = calibration_of(message(name), "a.yaml");
    const Written written = written_by(ros(), &calibration.documents.front(), calibration.rig);
    EXPECT_EQ(written.files.front().document.bytes(),
              written_by(ros(), nullptr, calibration.rig).files.front().document.bytes());
  }
}

// Gains of a controller have such names, too.
TEST(Ros, ListsOfThoseNamesAloneAreNoMessage) {
  Diagnostics diagnostics;
  EXPECT_FALSE(detect_format(document_of("k: [1.0, 2.0, 3.0]\np: [0.5]\nd: [0.1]\n", "gains.yaml"), diagnostics));
}

}  // namespace
}  // namespace fca::test
