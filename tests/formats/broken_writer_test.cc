// SPDX-License-Identifier: BSD-3-Clause
// A writer that is wrong in one of the ways in which writers are wrong in practice: the proof, asked whether the file says what
// was meant, notices. Each breaks a rig or a text and asks for the proof against the rig as it was meant.
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/formats/proof.h>
#include <fca/formats/wording.h>

#include <functional>

namespace fca::test {
namespace {

/// The file written for a rig, which the format's programs are to read as `meant`.
bool proven(const Format& format, const Rig& written_rig, const Rig& meant,
            const std::function<std::string(std::string)>& garbled = {}) {
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(format, nullptr, written_rig, {}, diagnostics);
  EXPECT_TRUE(written) << format.id << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  if (!written) return true;
  bool good = true;
  for (const Written::File& file : written->files) {
    const std::string bytes = garbled ? garbled(file.document.bytes()) : file.document.bytes();
    for (const std::string& program : file.programs) {
      consumers::LoadOptions options;
      if (!written->sensor.empty()) options.sensor = written->sensor;
      good = good && prove(*consumers::find_consumer(program), bytes, options, meant, file.cameras).agrees();
    }
  }
  return good;
}

struct Sample {
  std::string format;
  Rig rig;
};

/// Each format with what it holds: all its ways of saying a lens, and poses.
std::vector<Sample> samples() {
  std::vector<Sample> result;
  for (const char* model : {"kb4", "radtan", "mei", "eucm", "ds", "ucm", "fov"}) {
    result.push_back({"kalibr", sample_rig(model, {true, true})});
  }
  // With a beta that can be an alpha, too.
  result.push_back({"kalibr", sample_rig("eucm", {false, false})});
  EXPECT_TRUE(set_parameter(result.back().rig.cameras[0].model, "beta", 0.9375));
  for (const char* model : {"kb4", "radtan", "mei"}) result.push_back({"opencv", sample_rig(model, {true, false})});
  for (const char* model : {"kb4", "radtan"}) result.push_back({"orbslam3", sample_rig(model, {true, true})});
  for (const char* model : {"eucm", "ds"}) result.push_back({"orbslam3", sample_rig(model, {false, false})});
  for (const char* model : {"kb4", "mei"}) result.push_back({"tumvi", sample_rig(model, {true, true})});
  for (const char* file : {"ocamcalib/good/toolbox.txt", "woodscape/good/front.json", "dso/good/equidistant.txt"}) {
    result.push_back(
        {std::string(file).substr(0, std::string(file).find('/')), calibration_of(read_file(testdata_dir() / file), file).rig});
  }
  // ORB-SLAM3 V1.0 misreads a second camera with another lens; that one is not held against a file.
  for (Sample& sample : result) {
    if (sample.format == "orbslam3" && sample.rig.cameras.size() > 1) sample.rig.cameras[1].model = sample.rig.cameras[0].model;
    if (!find_format(sample.format)->time_offset) continue;
    for (Camera& camera : sample.rig.cameras) camera.time_offset_s = 0.0625;
  }
  return result;
}

/// One way to be wrong: false where it does not apply to that rig.
struct Mistake {
  const char* name;
  bool (*make)(Rig& rig);
};

bool swap_parameters(Rig& rig, ParameterId a, ParameterId b) {
  bool done = false;
  for (Camera& camera : rig.cameras) {
    const std::optional<double> value_a = parameter(camera.model, a);
    const std::optional<double> value_b = parameter(camera.model, b);
    if (!value_a || !value_b || *value_a == *value_b) continue;
    set_parameter(camera.model, a, *value_b);
    set_parameter(camera.model, b, *value_a);
    done = validate(camera.model).empty();
  }
  return done;
}

bool shift_centre(Rig& rig, ParameterId name) {
  for (Camera& camera : rig.cameras) {
    if (!set_parameter(camera.model, name, *parameter(camera.model, name) + 0.5)) return false;
  }
  return true;
}

bool change_poses(Rig& rig, Transform (*change)(const Transform&)) {
  for (PoseEdge& edge : rig.poses) edge.T_a_b = change(edge.T_a_b);
  return !rig.poses.empty();
}

Transform transposed(const Transform& T) {
  Transform result = T;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) result(row, column) = T(column, row);
  }
  return result;
}

Transform inverted(const Transform& T) { return inverse(T).value(); }

Transform in_centimetres(const Transform& T) {
  Transform result = T;
  for (int row = 0; row < 3; ++row) result(row, 3) *= 100.0;
  return result;
}

bool exchange_noise_and_walk(Rig& rig) {
  for (Imu& imu : rig.imus) std::swap(imu.gyroscope_noise_density, imu.gyroscope_random_walk);
  return !rig.imus.empty();
}

bool turn_time_offsets_round(Rig& rig) {
  bool done = false;
  for (Camera& camera : rig.cameras) {
    if (camera.time_offset_s.value_or(0.0) == 0.0) continue;
    camera.time_offset_s = -*camera.time_offset_s;
    done = true;
  }
  return done;
}

bool exchange_width_and_height(Rig& rig) {
  for (Camera& camera : rig.cameras) std::swap(camera.image_size->width, camera.image_size->height);
  return rig.cameras.front().image_size->width != rig.cameras.front().image_size->height;
}

/// What the format does not state, it cannot state wrongly.
bool states_the_difference(const Format& format, const Rig& broken, const Rig& meant) {
  if (broken.poses != meant.poses) return format.extrinsics;
  if (broken.imus != meant.imus) return format.imu;
  if (broken.cameras.front().time_offset_s != meant.cameras.front().time_offset_s) return format.time_offset;
  return true;
}

constexpr std::array kMistakes = {
    Mistake{"half a pixel to the right", [](Rig& rig) { return shift_centre(rig, "cx"); }},
    Mistake{"half a pixel down", [](Rig& rig) { return shift_centre(rig, "cy"); }},
    Mistake{"the centre's coordinates exchanged", [](Rig& rig) { return swap_parameters(rig, "cx", "cy"); }},
    Mistake{"alpha and beta exchanged", [](Rig& rig) { return swap_parameters(rig, "alpha", "beta"); }},
    Mistake{"k1 and k2 exchanged", [](Rig& rig) { return swap_parameters(rig, "k1", "k2"); }},
    Mistake{"d and e exchanged", [](Rig& rig) { return swap_parameters(rig, "d", "e"); }},
    Mistake{"k2 and p1 exchanged", [](Rig& rig) { return swap_parameters(rig, "k2", "p1"); }},
    Mistake{"rotations transposed", [](Rig& rig) { return change_poses(rig, transposed); }},
    Mistake{"poses inverted", [](Rig& rig) { return change_poses(rig, inverted); }},
    Mistake{"centimetres for metres", [](Rig& rig) { return change_poses(rig, in_centimetres); }},
    Mistake{"noise density and random walk exchanged", exchange_noise_and_walk},
    Mistake{"time offsets of the other sign", turn_time_offsets_round},
    Mistake{"width and height exchanged", exchange_width_and_height},
};

TEST(BrokenWriter, IsNotedByTheProof) {
  std::map<std::string, int> caught;
  for (const Sample& sample : samples()) {
    const Format& format = *find_format(sample.format);
    SCOPED_TRACE(sample.format + " " + std::string(model_info(sample.rig.cameras.front().model).id));
    EXPECT_TRUE(proven(format, sample.rig, sample.rig)) << "as it should be";
    for (const Mistake& mistake : kMistakes) {
      Rig broken = sample.rig;
      if (!mistake.make(broken)) continue;
      if (!states_the_difference(format, broken, sample.rig)) continue;
      EXPECT_FALSE(proven(format, broken, sample.rig)) << mistake.name;
      ++caught[mistake.name];
    }
  }
  for (const Mistake& mistake : kMistakes) EXPECT_GT(caught[mistake.name], 0) << mistake.name;
}

// V1.0 knows k1 k2 p1 p2 [k3]; the paper's and Kalibr's orders have something else in third place.
TEST(BrokenWriter, K3InP1sPlaceIsNoted) {
  Rig meant = sample_rig("radtan", {false, false});
  ASSERT_TRUE(set_parameter(meant.cameras[0].model, "k3", 0.01));
  Rig broken = meant;
  ASSERT_TRUE(swap_parameters(broken, "k3", "p1"));
  for (const char* format : {"opencv", "orbslam3"}) {
    EXPECT_TRUE(proven(*find_format(format), meant, meant)) << format;
    EXPECT_FALSE(proven(*find_format(format), broken, meant)) << format;
  }
}

// ORB-SLAM3 reads its matrices with .at<float>, whatever their type.
TEST(BrokenWriter, AMatrixOfDoublesIsNoted) {
  Rig meant = sample_rig("kb4", {true, true});
  meant.cameras[1].model = meant.cameras[0].model;
  for (const char* key : {"Stereo.T_c1_c2", "IMU.T_b_c1"}) {
    const auto as_doubles = [key](std::string bytes) {
      const std::size_t at = bytes.find("dt: f", bytes.find(key));
      EXPECT_NE(at, std::string::npos);
      return bytes.replace(at, 5, "dt: d");
    };
    EXPECT_FALSE(proven(*find_format("orbslam3"), meant, meant, as_doubles)) << key;
  }
}

}  // namespace
}  // namespace fca::test
