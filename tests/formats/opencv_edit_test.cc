// SPDX-License-Identifier: BSD-3-Clause
// Writing a rig over an OpenCV file changes what differs and no other byte; where the keys cannot hold the rig, the file is
// rewritten and that is reported.
#include "formats/lost_facts.h"
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>

#include <set>

namespace fca::test {
namespace {

struct Base {
  std::string bytes;
  Calibration calibration;
  [[nodiscard]] const Rig& rig() const { return calibration.rig; }
};

Base base_of(const std::string& bytes, const std::string& name, const ReadOptions& options = {}) {
  Parsed parsed = parse(bytes, name);
  EXPECT_TRUE(parsed.document) << parsed.rendered();
  std::optional<Calibration> calibration;
  if (parsed.document) calibration = read_calibration({*parsed.document}, nullptr, options, parsed.diagnostics);
  EXPECT_TRUE(calibration) << parsed.rendered() << bytes;
  return {bytes, calibration ? *std::move(calibration) : Calibration()};
}

Base good(const std::string& file) { return base_of(read_file(testdata_dir() / "opencv/good" / file), file); }

Written write(const Base& base, const Rig& rig, const WriteOptions& options = {}) {
  Diagnostics diagnostics;
  std::optional<Written> written = find_format("opencv")->write(&base.calibration.documents.front(), rig, options, diagnostics);
  EXPECT_TRUE(written) << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  return written ? *std::move(written) : Written();
}

std::string bytes_of(const Written& written) { return written.files.empty() ? "" : written.files.front().document.bytes(); }

bool has_loss(const Written& written, const std::string& code) {
  return std::ranges::any_of(written.losses, [&code](const Loss& loss) { return id_of(loss) == code; });
}

struct Case {
  const char* file;
  const char* spelling;  ///< The number as the file spells it; must stand there once.
  std::size_t camera;
  ParameterId parameter;
};

constexpr Case kCases[] = {
    {"calibration.yml", "4.5725000000000000e+02", 0, "fy"},
    {"calibration.yml", "1.7881393432617188e-05", 0, "p2"},
    {"calibration.yml", "-9.7656250000000000e-04", 0, "k3"},
    {"calibration-old.xml", "6.7212500000000000e+002", 0, "fy"},
    {"calibration-old.xml", "-4.4140625000000000e-001", 0, "k3"},
    {"fisheye.json", "254.9375", 0, "cx"},
    {"fisheye.json", "2.13623046875e-04", 0, "k4"},
    {"stereo-14.yml", "3.1406250000000000e+02", 1, "cx"},
    {"stereo-14.yml", "-4.0429687500000000e-01", 0, "k6"},
    {"k1d1.yml", "4.3945312500000000e-02", 1, "k3"},
    {"omnidir.xml", "9.5703125000000000e-01", 0, "xi"},
    {"omnidir.xml", "4.3945312500000000e-04", 0, "p2"},
    {"cameras.yml", "4.8828125000000000e-04 ]", 1, "k4"},
    {"cameras.yml", "-5.1269531250000000e-03", 2, "k3"},
    {"left-right.yml", "1.7844375000000000e+03", 1, "fy"},
    {"fisheye-crlf.yml", "1.46484375e-03", 0, "k3"},  // a float that stays one
};

TEST(OpenCvEdit, OneIntrinsicChangesItsOwnBytesOnly) {
  for (const Case& row : kCases) {
    SCOPED_TRACE(std::string(row.file) + " " + std::string(row.parameter.name()));
    const Base base = good(row.file);
    Rig rig = base.rig();
    const double changed = parameter(rig.cameras.at(row.camera).model, row.parameter).value() + 0.125;
    ASSERT_TRUE(set_parameter(rig.cameras[row.camera].model, row.parameter, changed));
    std::string spelling = row.spelling;
    const bool behind = spelling.ends_with(" ]");
    const Written written = write(base, rig);
    EXPECT_EQ(bytes_of(written), with_replaced(base.bytes, spelling, text::format_real(changed) + (behind ? " ]" : "")));
    EXPECT_FALSE(has_loss(written, "comments-dropped"));
  }
}

// dt: f holds floats; a number that is none makes the matrix one of doubles rather than another number.
TEST(OpenCvEdit, AFloatMatrixThatIsToHoldADoubleBecomesOne) {
  const Base base = good("fisheye-crlf.yml");
  Rig rig = base.rig();
  set_parameter(rig.cameras[0].model, "k2", 0.1);
  const std::string bytes = bytes_of(write(base, rig));
  const Base back = base_of(bytes, "x.yml");
  EXPECT_TRUE(back.rig().cameras == rig.cameras) << bytes;
  EXPECT_EQ(std::ranges::count(bytes, '\r'), std::ranges::count(bytes, '\n'));
  EXPECT_EQ(bytes.substr(0, bytes.find("fisheye_dist")), base.bytes.substr(0, base.bytes.find("fisheye_dist")));
}

// Numbers that have not changed keep their digits, whatever those are; changed ones are doubles or floats as dt has it.
TEST(OpenCvEdit, NumbersThatStayKeepTheirSpelling) {
  for (const char* type : {"d", "f"}) {
    SCOPED_TRACE(type);
    const std::string bytes = std::string("%YAML:1.0\nK: !!opencv-matrix\n  rows: 3\n  cols: 3\n  dt: ") + type +
                              "\n  data: [ 500, 0, 320.1, 0, 501.70, 2.4e+02, 0, 0, 1 ]\nD: !!opencv-matrix\n  rows: 1\n  "
                              "cols: 5\n  dt: " +
                              type + "\n  data: [ 1e-1, 2E-1, 0, -0.3, 0.40 ]\n";
    const Base base = base_of(bytes, "x.yml");
    Rig rig = base.rig();
    set_parameter(rig.cameras[0].model, "fy", 502.5);
    set_parameter(rig.cameras[0].model, "p1", 0.25);
    EXPECT_EQ(bytes_of(write(base, rig)), with_replaced(with_replaced(bytes, "501.70", "502.5"), "2E-1, 0,", "2E-1, 0.25,"));
  }
}

TEST(OpenCvEdit, MapsOfTwoCamerasCanHoldTheirPoseBesideThem) {
  const auto camera = [](const char* name) {
    return std::string(name) +
           ":\n  K: !!opencv-matrix\n    rows: 3\n    cols: 3\n    dt: d\n    data: [ 500., 0., 320.5, 0., "
           "501., 240., 0., 0., 1. ]\n  D: !!opencv-matrix\n    rows: 1\n    cols: 5\n    dt: d\n    data: [ "
           "0.1, 0., 0., 0., 0. ]\n";
  };
  const std::string bytes = "%YAML:1.0\n" + camera("left") + camera("right") +
                            "R: !!opencv-matrix\n  rows: 3\n  cols: 3\n  dt: d\n  data: [ 1., 0., 0., 0., 1., 0., 0., 0., 1. "
                            "]\nT: [ -0.125, 0., 0. ]\n";
  const Base base = base_of(bytes, "x.yml");
  ASSERT_EQ(base.rig().cameras.size(), 2U);
  ASSERT_EQ(base.rig().poses.size(), 1U);
  Rig rig = base.rig();
  rig.poses[0].T_a_b(0, 3) = -0.25;
  EXPECT_EQ(bytes_of(write(base, rig)), with_replaced(bytes, "-0.125", "-0.25"));
}

/// Everything a base may be asked to say again: the result reads as the rig that was requested, and OpenCV agrees.
struct Change {
  const char* what;
  void (*apply)(Rig& rig);
};

void set_models(Rig& rig, const char* model) {
  for (Camera& camera : rig.cameras) camera.model = sample_model(model);
}

const Change kChanges[] = {
    {"the size",
     [](Rig& rig) {
       for (Camera& camera : rig.cameras) camera.image_size = ImageSize{320, 200};
     }},
    {"every parameter",
     [](Rig& rig) {
       for (Camera& camera : rig.cameras) {
         for (double& value : parameter_values(camera.model)) value += 0.015625;
       }
     }},
    {"the pose",
     [](Rig& rig) {
       for (PoseEdge& edge : rig.poses) edge.T_a_b(0, 3) += 0.25;
     }},
    {"to radtan", [](Rig& rig) { set_models(rig, "radtan"); }},
    {"to pinhole", [](Rig& rig) { set_models(rig, "pinhole"); }},
    {"to kb4", [](Rig& rig) { set_models(rig, "kb4"); }},
    {"to mei", [](Rig& rig) { set_models(rig, "mei"); }},
    {"to rational",
     [](Rig& rig) {
       for (Camera& camera : rig.cameras)
         camera.model =
             model_of("rational", {500.0, 501.0, 320.0, 240.0, 0.5, 0.25, 0.001, 0.002, 0.125, 0.625, 0.375, 0.0625});
     }},
};

TEST(OpenCvEdit, FilesSayWhatTheyWereAskedToSay) {
  for (const fs::path& path : files_in(testdata_dir() / "opencv" / "good")) {
    const Base base = good(path.filename().string());
    if (base.rig().cameras.empty()) continue;
    for (const Change& change : kChanges) {
      SCOPED_TRACE(path.filename().string() + ": " + change.what);
      Rig rig = base.rig();
      change.apply(rig);
      // A file that never stated a size need not begin to.
      const bool sized = base.rig().cameras[0].image_size.has_value();
      const Written written = write(base, rig);
      std::vector<Camera> cameras;
      std::vector<PoseEdge> poses;
      for (const Written::File& file : written.files) {
        const Base back = base_of(file.document.bytes(), path.filename().string());
        for (std::size_t i = 0; i < back.rig().cameras.size(); ++i) {
          cameras.push_back(back.rig().cameras[i]);
          cameras.back().name = file.cameras.at(i);
          if (!sized) cameras.back().image_size = rig.cameras[i].image_size;
        }
        poses.insert(poses.end(), back.rig().poses.begin(), back.rig().poses.end());
        const ProofResult proof = prove(*consumers::find_consumer("opencv"), file.document.bytes(), {}, rig, file.cameras);
        // The base's own key "fisheye_dist_coeffs" is one that OpenCV's samples do not read.
        EXPECT_EQ(file.programs.empty(), file.document.bytes().find("fisheye_dist_coeffs") != std::string::npos);
        if (file.programs.empty()) continue;
        EXPECT_TRUE(proof.agrees()) << proof.max_diff_px;
        EXPECT_TRUE(proof.loads) << (proof.refusals.empty() ? "" : sentence_of(proof.refusals.front()))
                                 << file.document.bytes();
        EXPECT_TRUE(proof.poses_agree);
      }
      EXPECT_TRUE(cameras == rig.cameras) << bytes_of(written);
      if (written.files.size() == 1) {
        EXPECT_TRUE(poses == rig.poses) << bytes_of(written);
      }
    }
  }
}

// Every model over every other, in every syntax: also where what goes stands last.
TEST(OpenCvEdit, EveryModelOverEveryOther) {
  constexpr const char* kModels[] = {"pinhole", "radtan", "kb4", "mei"};
  for (const char* extension : {".yml", ".xml", ".json"}) {
    for (const char* from : kModels) {
      for (const char* to : kModels) {
        for (const bool two : {false, true}) {
          SCOPED_TRACE(std::string(from) + " to " + to + extension + (two ? " two" : ""));
          WriteOptions options;
          options.extension = extension;
          Rig first = sample_rig(from, {two, false});
          Rig second = sample_rig(to, {two, false});
          for (Rig* rig : {&first, &second}) {
            for (Camera& camera : rig->cameras) camera.topic.clear();
          }
          Diagnostics diagnostics;
          const std::optional<Written> fresh = find_format("opencv")->write(nullptr, first, options, diagnostics);
          ASSERT_TRUE(fresh);
          const std::string name = std::string("x") + extension;
          const Base base = base_of(bytes_of(*fresh), name);
          const Written written = write(base, second);
          const Base back = base_of(bytes_of(written), name);
          EXPECT_TRUE(back.rig().cameras == second.cameras) << bytes_of(written);
          EXPECT_TRUE(back.rig().poses == second.poses) << bytes_of(written);
          const ProofResult proof = prove(*consumers::find_consumer("opencv"), bytes_of(written), {}, second);
          EXPECT_TRUE(proof.agrees()) << bytes_of(written);
        }
      }
    }
  }
}

// Another model in the same keys: the block changes, its surroundings do not.
TEST(OpenCvEdit, AnotherModelKeepsTheRestOfTheFile) {
  const Base base = good("calibration.yml");
  for (const char* model : {"kb4", "mei", "pinhole"}) {
    SCOPED_TRACE(model);
    Rig rig = base.rig();
    rig.cameras[0].model = sample_model(model);
    const Written written = write(base, rig);
    const std::string bytes = bytes_of(written);
    EXPECT_FALSE(has_loss(written, "comments-dropped"));
    for (const char* kept : {"# As OpenCV's camera_calibration sample", "# flags: +fix_aspectRatio", "calibration_time",
                             "per_view_reprojection_errors", "   data: [ 2.01234564e-01, 1.96543217e-01 ]\n"})
      EXPECT_NE(bytes.find(kept), std::string::npos) << kept;
    EXPECT_NE(bytes.find(std::string("fisheye_model: ") + (std::string(model) == "kb4" ? "1" : "0")), std::string::npos);
    EXPECT_TRUE(base_of(bytes, "x.yml").rig().cameras == rig.cameras) << bytes;
  }
}

TEST(OpenCvEdit, ABaseWithoutAModelKeyGetsOneWhenItTurnsFisheye) {
  const Base base = good("stereo-14.yml");
  Rig rig = base.rig();
  set_models(rig, "kb4");
  const std::string bytes = bytes_of(write(base, rig));
  EXPECT_NE(bytes.find("fisheye_model: 1"), std::string::npos) << bytes;
  EXPECT_TRUE(base_of(bytes, "x.yml").rig().cameras == rig.cameras) << bytes;
}

/// Nothing says what its four numbers are.
std::string ambiguous_bytes() {
  return with_replaced(with_replaced(read_file(testdata_dir() / "opencv/good/fisheye.json"), "    \"fisheye_model\": 1,\n", ""),
                       "3.41796875e-03", "0.0034");
}

TEST(OpenCvEdit, AnAmbiguousBaseStaysAsItIsUntilItsCoefficientsChange) {
  for (const OpenCvModel told : {OpenCvModel::kPinhole, OpenCvModel::kFisheye}) {
    SCOPED_TRACE(name_of(told));
    const Base base = base_of(ambiguous_bytes(), "x.json", {std::nullopt, told});
    EXPECT_EQ(bytes_of(write(base, base.rig())), base.bytes);
    EXPECT_EQ(write(base, base.rig()).opencv_model, told);
    Rig focal = base.rig();
    set_parameter(focal.cameras[0].model, "fx", 191.5);
    EXPECT_EQ(bytes_of(write(base, focal)), with_replaced(base.bytes, "190.875", "191.5"));
    Rig lens = base.rig();
    set_parameter(lens.cameras[0].model, "k2", 0.25);
    const std::string bytes = bytes_of(write(base, lens));
    EXPECT_EQ(write(base, lens).opencv_model, std::nullopt);
    EXPECT_NE(bytes.find("\"fisheye_model\": " + std::string(told == OpenCvModel::kFisheye ? "1" : "0")), std::string::npos)
        << bytes;
    EXPECT_TRUE(base_of(bytes, "x.json").rig().cameras == lens.cameras) << bytes;
  }
}

// A size is a fact: a file that specifies none begins to, where its keys can.
TEST(OpenCvEdit, ASizeThatTheBaseDoesNotStateIsAdded) {
  const Base base = good("k1d1.yml");
  Rig rig = base.rig();
  for (Camera& camera : rig.cameras) camera.image_size = ImageSize{640, 400};
  const Written written = write(base, rig);
  EXPECT_EQ(bytes_of(written), base.bytes + "image_width: 640\nimage_height: 400\n");
  EXPECT_TRUE(written.losses.empty());
  EXPECT_EQ(base_of(bytes_of(written), "x.yml").rig().cameras, rig.cameras);
  rig.cameras[1].image_size = ImageSize{320, 200};
  const Written apart = write(base, rig);
  EXPECT_EQ(bytes_of(apart), base.bytes);
  EXPECT_TRUE(loses(apart, Code::kOpencvSizeDropped, {"cam0", 640, 400}) &&
              loses(apart, Code::kOpencvSizeDropped, {"cam1", 320, 200}));
  std::string cameras = read_file(testdata_dir() / "opencv/good/cameras.yml");
  const std::string size = "   img_width: 1824\n   img_height: 1376\n";
  const Base maps = base_of(cameras.erase(cameras.find(size), size.size()), "x.yml");
  ASSERT_FALSE(maps.rig().cameras[0].image_size);
  Rig sized = maps.rig();
  sized.cameras[0].image_size = ImageSize{1824, 1376};
  EXPECT_EQ(base_of(bytes_of(write(maps, sized)), "x.yml").rig().cameras, sized.cameras);
}

/// A camera's lens with further coefficients.
Rig as_rational(Rig rig) {
  for (Camera& camera : rig.cameras) {
    CameraModel rational = *make_model("rational");
    for (const Parameter& row : model_info(camera.model).parameters)
      EXPECT_TRUE(set_parameter(rational, ParameterId(row), parameter(camera.model, ParameterId(row)).value()));
    EXPECT_TRUE(set_parameter(rational, "k6", 0.0625));
    camera.model = rational;
  }
  return rig;
}

// A longer vector is the old one with more after it: neither its spelling nor its layout changes.
TEST(OpenCvEdit, AVectorGrowsAndShrinksInItsOwnLayout) {
  const Base yaml = good("calibration.yml");
  const std::string longer = with_replaced(with_replaced(yaml.bytes, "rows: 5", "rows: 8"), "-9.7656250000000000e-04 ]",
                                           "-9.7656250000000000e-04, 0.0, 0.0, 0.0625 ]");
  EXPECT_EQ(bytes_of(write(yaml, as_rational(yaml.rig()))), longer);
  EXPECT_EQ(bytes_of(write(base_of(longer, "x.yml"), yaml.rig())), yaml.bytes);

  const Base xml = good("calibration-old.xml");
  const std::string grown = bytes_of(write(xml, as_rational(xml.rig())));
  const std::size_t old_end = xml.bytes.find("</data></Distortion_Coefficients>");
  ASSERT_NE(old_end, std::string::npos) << xml.bytes;
  EXPECT_TRUE(grown.ends_with(" 0.0 0.0 0.0625" + xml.bytes.substr(old_end))) << grown;

  const std::string kOneLine =
      "{\n\"K\": {\"type_id\": \"opencv-matrix\", \"rows\": 3, \"cols\": 3, \"dt\": \"d\", \"data\": [500.50, 0, 320, 0, 501, "
      "240, 0, 0, 1]},\n\"D\": {\"type_id\": \"opencv-matrix\", \"rows\": 1, \"cols\": 5, \"dt\": \"d\", \"data\": [-0.10, "
      "0.20, "
      "0, 0, 1e-3]}\n}\n";
  const Base json = base_of(kOneLine, "x.json");
  EXPECT_EQ(bytes_of(write(json, as_rational(json.rig()))),
            with_replaced(with_replaced(kOneLine, "\"cols\": 5", "\"cols\": 8"), "1e-3]", "1e-3, 0.0, 0.0, 0.0625]"));
}

// New keys take the layout of those that are there.
TEST(OpenCvEdit, ANewMatrixIsLaidOutAsItsNeighbours) {
  Base base = good("k1d1.yml");
  Rig rig = base.rig();
  rig.poses.clear();
  base = base_of(bytes_of(write(base, rig)), "x.yml");
  rig.poses.push_back({"cam1", "cam0", T_cam1_cam0()});
  const std::string bytes = bytes_of(write(base, rig));
  EXPECT_NE(bytes.find("\nR: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: ["), std::string::npos) << bytes;
}

TEST(OpenCvEdit, APoseCanBeginAndEnd) {
  const Base base = good("k1d1.yml");
  Rig rig = base.rig();
  rig.poses.clear();
  const std::string without = bytes_of(write(base, rig));
  EXPECT_EQ(without.find("\nR:"), std::string::npos);
  EXPECT_NE(without.find("\nXR:"), std::string::npos);
  const Base bare = base_of(without, "x.yml");
  EXPECT_TRUE(bare.rig().poses.empty());
  const Base again = base_of(bytes_of(write(bare, base.rig())), "x.yml");
  EXPECT_TRUE(again.rig().poses == base.rig().poses);
}

/// stereo_calib's second file, with what cv::stereoRectify adds.
std::string extrinsics_bytes() {
  return read_file(testdata_dir() / "opencv/good/extrinsics.yml") +
         "P2: !!opencv-matrix\n   rows: 3\n   cols: 4\n   dt: d\n   data: [ 426.5, 0., 321.75, -1423.75, 0., 426.5, 241.25, "
         "0., "
         "0., 0., 1., 0. ]\nvalidRoi: [ 8, 8, 624, 464 ]\n";
}

// Such a file has a place for the pose of the pair: that is edited, and what it has no place for is said.
TEST(OpenCvEdit, AFileOfThePoseAloneKeepsTheRest) {
  const Base base = base_of(extrinsics_bytes(), "extrinsics.yml");
  Rig rig = sample_rig("kb4", {true, true});
  rig.poses[0].T_a_b = base.rig().poses.at(0).T_a_b;
  rig.poses[0].T_a_b(0, 3) = -0.25;
  rig.extra_fields.push_back({"", "baseline_mm", "250."});
  for (const char* first : {"cam0", "left"}) {
    SCOPED_TRACE(first);
    Rig named = rig;
    if (std::string(first) == "left") {
      named.cameras[0].name = "left";
      named.cameras[1].name = "right";
      named.poses = {{"right", "left", rig.poses[0].T_a_b}, {"left", "imu0", T_cam0_imu()}};
    }
    const Written written = write(base, named);
    EXPECT_EQ(bytes_of(written), with_replaced(base.bytes, "-1.2109375000000000e-01", "-0.25"));
    for (const Camera& camera : named.cameras) EXPECT_TRUE(loses(written, Code::kOpencvCameraDropped, {camera.name, "kb4"}));
    EXPECT_TRUE(loses(written, Code::kOpencvPosesDropped, {"T_" + std::string(first) + "_imu0"}));
    EXPECT_FALSE(loses_anything_of(written, "T_cam1_cam0") || loses_anything_of(written, "T_right_left"));
    EXPECT_TRUE(loses(written, Code::kNotCarriedValue, {"baseline_mm", "250."}));
  }
  // Without a pose in the rig there is nothing to say.
  EXPECT_EQ(bytes_of(write(base, sample_rig("kb4", {false, false}))), base.bytes);
}

// What the input says besides its cameras is compared as a whole, matrices too.
TEST(OpenCvEdit, WhatTheInputSaysOtherwiseIsSaid) {
  const std::string changed =
      with_replaced(read_file(testdata_dir() / "opencv/good/k1d1.yml"), "0.0, 0.0, 0.28", "0.0, 0.0, 0.5");
  const Base base = good("k1d1.yml");
  const Written written = write(base, base_of(changed, "x.yml").rig());
  EXPECT_EQ(bytes_of(written), base.bytes);
  ASSERT_EQ(written.losses.size(), 1U);
  EXPECT_EQ(facts_of(written.losses[0]),
            (Message{Code::kNotCarriedValue,
                     {"", "XT", Message{Code::kOpencvKeepsItsOwn, {Message{Code::kOpencvHolds}}}, "3 x 1 [0.0, 0.0, 0.5]"}}));
  // Other spellings of the same numbers are no other fact.
  const std::string respelled = with_replaced(base.bytes, "0.0, 0.0, 0.28", "0., 0., 2.8e-1");
  EXPECT_TRUE(write(base, base_of(respelled, "x.yml").rig()).losses.empty());
}

/// The keys that each loss "stale-derived" names, and whether a warning says each of them.
std::string stale_in(const Base& base, const Rig& rig) {
  Diagnostics diagnostics;
  const std::optional<Written> written =
      find_format("opencv")->write(&base.calibration.documents.front(), rig, {}, diagnostics);
  if (!written) return "not written";
  std::string stale;
  for (const Loss& loss : written->losses) {
    if (id_of(loss) != "stale-derived") continue;
    EXPECT_EQ(loss.kind, Code::kOpencvStaleKept);
    std::string keys;
    for (const std::string& key : std::get<std::vector<std::string>>(loss.values.at(0).value)) keys += " " + key;
    stale += (stale.empty() ? "" : ";") + keys;
    EXPECT_FALSE(remedy_of(loss).empty());
    EXPECT_TRUE(std::ranges::any_of(diagnostics.entries(), [&loss](const Diagnostic& entry) {
      return entry.facts == Message{Code::kOpencvStale, loss.values} && entry.where.length > 0;
    }));
  }
  return stale;
}

// What was computed from the old numbers stays in the file, and is said not to belong to the new ones.
TEST(OpenCvEdit, ValuesThatDoNotFollowAreSaid) {
  std::string bytes = read_file(testdata_dir() / "opencv/good/stereo-14.yml") + "Q: [ 1., 0. ]\nE: [ 1., 0. ]\nrms: 0.25\n";
  const Base pair = base_of(bytes, "x.yml");
  EXPECT_EQ(stale_in(pair, pair.rig()), "");
  Rig moved = pair.rig();
  moved.poses.at(0).T_a_b(0, 3) = -0.5;
  EXPECT_EQ(stale_in(pair, moved), " P1 Q E; rms");
  Rig lens = pair.rig();
  ASSERT_TRUE(set_parameter(lens.cameras[1].model, "fy", 530.0));
  EXPECT_EQ(stale_in(pair, lens), " P1 Q; rms");
  // Stored with further coefficients of 0 it is the lens that it was.
  const Base single = good("calibration.yml");
  Rig more = single.rig();
  CameraModel rational = *make_model("rational");
  for (const Parameter& row : model_info(more.cameras[0].model).parameters)
    ASSERT_TRUE(set_parameter(rational, ParameterId(row), parameter(more.cameras[0].model, ParameterId(row)).value()));
  more.cameras[0].model = rational;
  EXPECT_EQ(stale_in(single, more), "");
  more.cameras[0].model = sample_model("kb4");
  EXPECT_EQ(stale_in(single, more), " fix_aspect_ratio flags avg_reprojection_error per_view_reprojection_errors");
  // In maps each camera's own keys are its own affair.
  const std::string cameras = read_file(testdata_dir() / "opencv/good/cameras.yml");
  const Base maps = base_of(with_replaced(cameras, "camera_1:\n", "camera_1:\n   mean_reprojection_error: 0.5\n"), "x.yml");
  Rig first = maps.rig();
  ASSERT_TRUE(set_parameter(first.cameras[0].model, "fx", 500.0));
  EXPECT_EQ(stale_in(maps, first), "");
  ASSERT_TRUE(set_parameter(first.cameras[1].model, "fx", 500.0));
  EXPECT_EQ(stale_in(maps, first), " camera_1 mean_reprojection_error");
  // stereo_calib's second file, by itself.
  Rig pose = sample_rig("kb4", {true, false});
  EXPECT_EQ(stale_in(base_of(extrinsics_bytes(), "x.yml"), pose), " P2 validRoi");
}

TEST(OpenCvEdit, CamerasComeAndGoInMaps) {
  const Base base = good("cameras.yml");
  // The last one goes: its lines go, and the count.
  Rig fewer = base.rig();
  fewer.cameras.pop_back();
  fewer.poses.pop_back();
  const Written shorter = write(base, fewer);
  EXPECT_EQ(bytes_of(shorter),
            with_replaced(base.bytes.substr(0, base.bytes.find("camera_2:")), "nb_camera: 3", "nb_camera: 2"));
  EXPECT_FALSE(has_loss(shorter, "comments-dropped"));
  // The one in the middle goes: the next one takes its name.
  Rig middle = base.rig();
  middle.cameras.erase(middle.cameras.begin() + 1);
  middle.poses.erase(middle.poses.begin() + 1);
  const Written renumbered = write(base, middle);
  const Base back = base_of(bytes_of(renumbered), "x.yml");
  ASSERT_EQ(back.rig().cameras.size(), 2U);
  EXPECT_EQ(back.rig().cameras[1].model, base.rig().cameras[2].model);
  EXPECT_EQ(bytes_of(renumbered).find("camera_2"), std::string::npos);
  EXPECT_EQ(renumbered.files.front().cameras, (std::vector<std::string>{"cam0", "cam2"}));
  // A fourth one comes, by its siblings' style.
  Rig more = base.rig();
  more.cameras.push_back({"cam3", ImageSize{512, 512}, sample_model("kb4"), std::nullopt, std::nullopt, ""});
  more.poses.push_back({"reference", "cam3", T_cam1_cam0()});
  const Written longer = write(base, more);
  EXPECT_NE(bytes_of(longer).find("\ncamera_3:\n   camera_matrix: !!opencv-matrix\n      rows: 3\n"), std::string::npos)
      << bytes_of(longer);
  EXPECT_NE(bytes_of(longer).find("# a fisheye beside"), std::string::npos);
  EXPECT_TRUE(base_of(bytes_of(longer), "x.yml").rig().cameras == more.cameras) << bytes_of(longer);
  EXPECT_TRUE(base_of(bytes_of(longer), "x.yml").rig().poses == more.poses);
  EXPECT_TRUE(prove(*consumers::find_consumer("opencv"), bytes_of(longer), {}, more).agrees());
}

TEST(OpenCvEdit, CamerasComeAndGoInEverySyntax) {
  const Base yaml = good("cameras.yml");
  for (const char* extension : {".xml", ".json"}) {
    SCOPED_TRACE(extension);
    WriteOptions options;
    options.extension = extension;
    const Written fresh = write(yaml, yaml.rig(), options);
    EXPECT_TRUE(has_loss(fresh, "comments-dropped"));
    const std::string name = std::string("x") + extension;
    const Base base = base_of(bytes_of(fresh), name);
    EXPECT_TRUE(base.rig().cameras == yaml.rig().cameras);
    Rig more = yaml.rig();
    more.cameras.push_back({"cam3", ImageSize{512, 512}, sample_model("kb4"), std::nullopt, std::nullopt, ""});
    more.poses.push_back({"reference", "cam3", T_cam1_cam0()});
    const Base longer = base_of(bytes_of(write(base, more)), name);
    EXPECT_TRUE(longer.rig().cameras == more.cameras);
    EXPECT_TRUE(longer.rig().poses == more.poses);
    for (std::size_t gone = 0; gone < 3; ++gone) {
      Rig fewer = yaml.rig();
      fewer.cameras.erase(fewer.cameras.begin() + static_cast<std::ptrdiff_t>(gone));
      fewer.poses.erase(fewer.poses.begin() + static_cast<std::ptrdiff_t>(gone));
      const Base shorter = base_of(bytes_of(write(base, fewer)), name);
      ASSERT_EQ(shorter.rig().cameras.size(), 2U);
      for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(shorter.rig().cameras[i].model, fewer.cameras[i].model);
    }
  }
}

TEST(OpenCvEdit, WhatTheKeysCannotHoldIsRewrittenAndReported) {
  const Base base = good("calibration.yml");
  const Written pair = write(base, sample_rig("radtan", {true, false}));
  EXPECT_TRUE(has_loss(pair, "comments-dropped"));
  EXPECT_NE(bytes_of(pair).find("M1:"), std::string::npos);
  // mei has no keys in M1 D1 M2 D2.
  const Base stereo = good("stereo-14.yml");
  Rig mei = stereo.rig();
  set_models(mei, "mei");
  EXPECT_NE(bytes_of(write(stereo, mei)).find("xi_1:"), std::string::npos);
  WriteOptions other;
  other.layout = "cameras";
  EXPECT_NE(bytes_of(write(stereo, stereo.rig(), other)).find("camera_0:"), std::string::npos);
}

TEST(OpenCvEdit, TheSyntaxOfTheBaseStays) {
  const Base base = good("omnidir.xml");
  Rig rig = base.rig();
  set_parameter(rig.cameras[0].model, "cx", 510.5);
  const std::string bytes = bytes_of(write(base, rig));
  EXPECT_EQ(bytes, with_replaced(base.bytes, "5.1225000000000000e+02", "510.5"));
  WriteOptions rewrite;
  rewrite.rewrite = true;
  EXPECT_TRUE(bytes_of(write(base, rig, rewrite)).starts_with("<?xml"));
}

}  // namespace
}  // namespace fca::test
