// SPDX-License-Identifier: BSD-3-Clause
// Calibrations next to each other, over all good files: a file next to itself, a common mistake planted into it, and honest
// pairs, of which no mistake may be claimed.
#include "formats/test_files.h"

#include <fca/compare/compare.h>
#include <fca/convert/convert.h>
#include <fca/formats/stated_as.h>
#include <fca/formats/wording.h>
#include <fca/rig/image_change.h>
#include <fca/rig/rotation.h>

#include <cmath>
#include <functional>
#include <map>

namespace fca::test {
namespace {

constexpr double kRadiansPerDegree = 0.017453292519943295;

std::optional<Calibration> read(const fs::path& path) {
  Diagnostics diagnostics;
  std::optional<text::Document> document = text::parse_document({path.filename().string(), read_file(path)}, diagnostics);
  if (!document) return std::nullopt;
  ReadOptions options;
  options.opencv_model = OpenCvModel::kFisheye;
  std::optional<Calibration> calibration = read_calibration({*std::move(document)}, nullptr, options, diagnostics);
  if (!calibration) {
    // Some files are of two formats, or of no ambiguous OpenCV lens.
    Diagnostics again;
    document = text::parse_document({path.filename().string(), read_file(path)}, again);
    calibration = read_calibration({*std::move(document)}, find_format("tumvi"), {}, again);
  }
  if (!calibration) return std::nullopt;
  for (Camera& camera : calibration->rig.cameras) {
    const Pixel centre = principal_point(camera.model);
    if (!camera.image_size)
      camera.image_size = ImageSize{static_cast<int>(2.0 * centre[0]) + 1, static_cast<int>(2.0 * centre[1]) + 1};
  }
  return calibration;
}

const std::map<std::string, Rig>& good_rigs() {
  static const std::map<std::string, Rig> kRigs = [] {
    std::map<std::string, Rig> rigs;
    for (const fs::path& path : files_of_all_formats("good")) {
      std::optional<Calibration> calibration = read(path);
      if (calibration && !calibration->rig.cameras.empty())
        rigs[path.parent_path().parent_path().filename().string() + "/" + path.filename().string()] = calibration->rig;
    }
    return rigs;
  }();
  return kRigs;
}

/// Rigs with models, an IMU and time offsets that few of the good files have.
std::map<std::string, Rig> completed_rigs() {
  std::map<std::string, Rig> rigs;
  for (const char* name : {"kalibr/tumvi.yaml", "kalibr/ds.yaml"}) {
    double offset = 0.0021;
    for (const char* model : {"ds", "eucm", "ucm"}) {
      Rig rig = good_rigs().at(name);
      for (Camera& camera : rig.cameras) {
        Diagnostics diagnostics;
        ConvertOptions options;
        options.model = model;
        options.bound = false;
        if (const std::optional<Conversion> converted = convert(camera, options, diagnostics)) camera = converted->camera;
        camera.time_offset_s = offset = -1.3 * offset;
      }
      rig.imus = {{"imu0", 0.00016, 0.000022, 0.0028, 0.00086, 200.0, ""}};
      rigs[std::string(name) + " as " + model] = rig;
    }
  }
  // Numbers that stay in their ranges when they are exchanged.
  for (const char* name : {"kalibr/tumvi.yaml as ds", "kalibr/ds.yaml as ds"}) {
    Rig& rig = rigs[std::string(name) + ", xi > 0"] = rigs[name];
    for (Camera& camera : rig.cameras) EXPECT_TRUE(set_parameter(camera.model, "xi", 0.2));
  }
  for (const char* name : {"kalibr/tumvi.yaml as eucm", "kalibr/ds.yaml as eucm"}) {
    Rig& rig = rigs[std::string(name) + ", beta < 1"] = rigs[name];
    for (Camera& camera : rig.cameras) EXPECT_TRUE(set_parameter(camera.model, "beta", 0.9));
  }
  return rigs;
}

RigComparison compared(const Rig& reference, const Rig& other) {
  Diagnostics diagnostics;
  return compare(reference, other, {.bound = false}, diagnostics);
}

std::string said(const RigComparison& comparison) {
  std::string text;
  for (const Mistake& mistake : comparison.mistakes)
    text += id_of(mistake.message) + ": " + text::text_of(mistake.message) + "\n";
  return text;
}

bool claims(const RigComparison& comparison, const std::string& code) {
  return std::ranges::any_of(comparison.mistakes, [&](const Mistake& each) { return id_of(each.message) == code; });
}

TEST(CompareFiles, AFileIsExactlyItself) {
  EXPECT_GT(good_rigs().size(), 40U);
  for (const auto& [name, rig] : good_rigs()) {
    SCOPED_TRACE(name);
    Diagnostics diagnostics;
    const RigComparison result = compare(rig, rig, {.bound = false}, diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << message_of(diagnostics.entries().front());
    EXPECT_TRUE(result.identical());
    EXPECT_EQ(said(result), "");
    EXPECT_EQ(result.cameras.size(), rig.cameras.size());
    for (const CameraComparison& camera : result.cameras) EXPECT_EQ(camera.difference.statistics.error.max, 0.0);
    for (const PoseComparison& pose : result.poses) EXPECT_EQ(pose.angle_rad + pose.distance_m, 0.0);
    EXPECT_TRUE(result.only_in_reference.empty() && result.only_in_other.empty());
  }
}

// Also those that specify no image size.
TEST(CompareFiles, EveryFileOfTheCorpusIsExactlyItself) {
  if (!fs::exists(shared_dir() / "corpus" / "kalibr")) GTEST_SKIP() << "needs ../shared/corpus";
  std::size_t compared_files = 0;
  for (const Format& format : all_formats()) {
    for (const fs::path& path : corpus_files_of(format.id)) {
      SCOPED_TRACE(path.string());
      Diagnostics reading;
      std::optional<text::Document> document = text::read_document(path.string(), reading);
      if (!document) continue;
      const std::optional<Calibration> calibration = read_calibration({*std::move(document)}, nullptr, {}, reading);
      if (!calibration) continue;  // tests/formats/corpus_test.cc knows which
      if (calibration->rig.cameras.empty() && calibration->rig.poses.empty() && calibration->rig.imus.empty()) continue;
      Diagnostics diagnostics;
      const RigComparison result = compare(calibration->rig, calibration->rig, {.bound = false}, diagnostics);
      EXPECT_FALSE(diagnostics.has_errors()) << message_of(diagnostics.entries().front());
      EXPECT_TRUE(result.identical() && result.mistakes.empty());
      EXPECT_EQ(result.cameras.size(), calibration->rig.cameras.size());
      for (const CameraComparison& camera : result.cameras) EXPECT_EQ(camera.difference.statistics.error.max, 0.0);
      ++compared_files;
    }
  }
  EXPECT_GT(compared_files, 300U);
}

// Which way a file specifies a pose is its own affair.
TEST(CompareFiles, APoseStatedTheOtherWayIsTheSame) {
  for (const auto& [name, rig] : good_rigs()) {
    SCOPED_TRACE(name);
    Rig other = rig;
    for (PoseEdge& edge : other.poses) edge = {edge.b, edge.a, *inverse(edge.T_a_b)};
    const RigComparison result = compared(rig, other);
    EXPECT_EQ(said(result), "");
    EXPECT_TRUE(result.identical());
    EXPECT_EQ(result.poses.size(), compared(rig, rig).poses.size());
  }
}

TEST(CompareFiles, PosesAndNumbersDifferAsMuchInBothDirections) {
  std::size_t poses = 0;
  for (auto one = good_rigs().begin(); one != good_rigs().end(); ++one) {
    for (auto two = std::next(one); two != good_rigs().end(); ++two) {
      constexpr std::ptrdiff_t kNeighbours = 8;
      if (std::distance(one, two) > kNeighbours || one->second.poses.empty() || two->second.poses.empty()) continue;
      Rig reference = one->second;
      Rig other = two->second;
      for (Rig* rig : {&reference, &other}) {
        for (Camera& camera : rig->cameras) camera.model = Intrinsics<Pinhole>{{100.0, 100.0, 50.0, 50.0}};  // quick
        for (Camera& camera : rig->cameras) camera.image_size = ImageSize{101, 101};
      }
      const RigComparison there = compared(reference, other);
      const RigComparison back = compared(other, reference);
      for (const PoseComparison& pose : there.poses) {
        const auto same = std::ranges::find_if(
            back.poses, [&pose](const PoseComparison& each) { return (each.a == pose.a && each.b == pose.b); });
        if (same == back.poses.end()) continue;  // its names are the reference's
        EXPECT_NEAR(same->angle_rad, pose.angle_rad, 1e-9);
        EXPECT_NEAR(same->distance_m, pose.distance_m, 1e-9);
        EXPECT_EQ(same->reference_length_m, pose.other_length_m);
        ++poses;
      }
      ASSERT_EQ(there.facts.size(), back.facts.size());
      for (std::size_t i = 0; i < there.facts.size(); ++i) EXPECT_EQ(there.facts[i].reference, back.facts[i].other);
    }
  }
  EXPECT_GT(poses, 20U);
}

/// Makes a common mistake in a rig; false where it changes nothing that could be told.
struct Plant {
  std::string code;
  std::size_t fewest;  ///< Good files in which it can be told.
  std::function<bool(Rig&)> plant;
};

/// Far enough from the truth that no two honest calibrations are so far apart.
bool far(const Transform& a, const Transform& b) {
  const double distance = distance_between(a, b);
  return angle_between(a, b) > 3.0 * kRadiansPerDegree || (distance > 0.03 && distance > 0.3 * distance_of(a));
}

bool change_pose(Rig& rig, const std::function<std::optional<Transform>(const Transform&)>& change) {
  for (PoseEdge& edge : rig.poses) {
    const std::optional<Transform> changed = change(edge.T_a_b);
    if (!changed || !far(edge.T_a_b, *changed) || rotation_defect(edge.T_a_b) > 1e-3) continue;
    edge.T_a_b = *changed;
    return true;
  }
  return false;
}

bool shift_centre(Rig& rig, double px) {
  for (Camera& camera : rig.cameras) camera.model = with_pixels(camera.model, {{1.0, 1.0}, {px, px}});
  return !rig.cameras.empty();
}

bool exchange(Rig& rig, ParameterId first, ParameterId second) {
  for (Camera& camera : rig.cameras) {
    const std::optional<double> a = parameter(camera.model, first);
    const std::optional<double> b = parameter(camera.model, second);
    if (!a || !b || std::abs(*a - *b) < 0.05) continue;
    set_parameter(camera.model, first, *b);
    set_parameter(camera.model, second, *a);
    return validate(camera.model).empty();
  }
  return false;
}

/// The numbers of a camera under another model's name. Without a coefficient no model is the wrong one.
bool rename(Rig& rig, std::string_view from, std::string_view to) {
  for (Camera& camera : rig.cameras) {
    constexpr std::size_t kOfPinhole = 4;
    const std::span<const double> all = parameter_values(std::as_const(camera.model));
    const bool bends = std::ranges::any_of(all.subspan(kOfPinhole), [](double number) { return number != 0.0; });
    if (model_info(camera.model).id != from || !bends) continue;
    CameraModel wrong = *make_model(to);
    const std::span<const double> numbers = parameter_values(std::as_const(camera.model));
    const std::span<double> values = parameter_values(wrong);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (i < values.size()) values[i] = numbers[i];
      if (i >= values.size() && numbers[i] != 0.0) return false;
    }
    camera.model = wrong;
    return validate(wrong).empty();
  }
  return false;
}

/// The same focal lengths and centre without any lens.
bool remove_distortion(Rig& rig) {
  for (Camera& camera : rig.cameras) {
    if (!model_info(camera.model).focal_lengths_first || model_info(camera.model).parameters.size() == 4) continue;
    CameraModel straight = *make_model("pinhole");
    std::ranges::copy(std::span(parameter_values(std::as_const(camera.model))).first(4), parameter_values(straight).begin());
    const std::optional<Pixel> bent = project(camera.model, {0.5, 0.3, 1.0});
    const std::optional<Pixel> flat = project(straight, {0.5, 0.3, 1.0});
    if (!bent || !flat || std::hypot((*bent)[0] - (*flat)[0], (*bent)[1] - (*flat)[1]) < 3.0) return false;  // hardly a lens
    camera.model = straight;
    return true;
  }
  return false;
}

bool change_noise(Rig& rig, const std::function<double(double, double)>& change) {
  bool any = false;
  for (Imu& imu : rig.imus) {
    for (std::optional<double> Imu::*member : {&Imu::gyroscope_noise_density, &Imu::accelerometer_noise_density}) {
      if (!(imu.*member) || !imu.rate_hz) continue;
      imu.*member = change(*(imu.*member), *imu.rate_hz);
      any = true;
    }
  }
  return any;
}

Transform scaled(Transform T, double factor) {
  for (int row = 0; row < 3; ++row) T(row, 3) *= factor;
  return T;
}

Transform transposed(const Transform& T) {
  Transform result = T;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) result(row, column) = T(column, row);
  }
  return result;
}

const std::vector<Plant>& plants() {
  static const std::vector<Plant> kPlants = {
      {"pose-inverted", 3, [](Rig& rig) { return change_pose(rig, [](const Transform& T) { return inverse(T); }); }},
      {"pose-transposed", 3,
       [](Rig& rig) {
         return change_pose(rig, [](const Transform& T) -> std::optional<Transform> {
           // Of a pose without translation it is the inverse.
           return distance_of(T) > 0.02 ? std::optional(transposed(T)) : std::nullopt;
         });
       }},
      {"translation-in-mm", 3,
       [](Rig& rig) { return change_pose(rig, [](const Transform& T) { return std::optional(scaled(T, 1000.0)); }); }},
      {"translation-in-mm", 3,
       [](Rig& rig) { return change_pose(rig, [](const Transform& T) { return std::optional(scaled(T, 0.001)); }); }},
      {"translation-in-mm", 3,
       [](Rig& rig) { return change_pose(rig, [](const Transform& T) { return std::optional(scaled(T, 100.0)); }); }},
      {"time-offset-sign", 3,
       [](Rig& rig) {
         bool any = false;
         for (Camera& camera : rig.cameras) {
           if (!camera.time_offset_s || *camera.time_offset_s == 0.0) continue;
           camera.time_offset_s = -*camera.time_offset_s;
           any = true;
         }
         return any;
       }},
      {"imu-noise-discrete", 3,
       [](Rig& rig) { return change_noise(rig, [](double density, double rate) { return density * std::sqrt(rate); }); }},
      {"imu-noise-discrete", 3,
       [](Rig& rig) { return change_noise(rig, [](double density, double rate) { return density / std::sqrt(rate); }); }},
      {"imu-noise-variance", 3,
       [](Rig& rig) { return change_noise(rig, [](double density, double) { return density * density; }); }},
      {"half-pixel", 3, [](Rig& rig) { return shift_centre(rig, 0.5); }},
      {"half-pixel", 3, [](Rig& rig) { return shift_centre(rig, -0.5); }},
      {"one-pixel", 3, [](Rig& rig) { return shift_centre(rig, 1.0); }},
      {"centre-mirrored", 3,
       [](Rig& rig) {
         bool any = false;
         for (Camera& camera : rig.cameras) {
           const double down = camera.image_size->height - 1.0 - 2.0 * principal_point(camera.model)[1];
           camera.model = with_pixels(camera.model, {{1.0, 1.0}, {0.0, down}});
           any = any || std::abs(down) > 3.0;
         }
         return any;
       }},
      // Taken from the height, and not from the last row.
      {"centre-mirrored", 3,
       [](Rig& rig) {
         bool any = false;
         for (Camera& camera : rig.cameras) {
           const double down = camera.image_size->height - 2.0 * principal_point(camera.model)[1];
           camera.model = with_pixels(camera.model, {{1.0, 1.0}, {0.0, down}});
           any = any || std::abs(down) > 3.0;
         }
         return any;
       }},
      {"centre-swapped", 3,
       [](Rig& rig) {
         bool any = false;
         for (Camera& camera : rig.cameras) {
           const Pixel centre = principal_point(camera.model);
           const double difference = centre[1] - centre[0];
           camera.model = with_pixels(camera.model, {{1.0, 1.0}, {difference, -difference}});
           any = any || std::abs(difference) > 3.0;
         }
         return any;
       }},
      {"other-resolution", 3,
       [](Rig& rig) {
         for (Camera& camera : rig.cameras) camera.model = with_pixels(camera.model, {{2.0, 2.0}, {0.5, 0.5}});
         return !rig.cameras.empty();
       }},
      {"other-resolution", 3,
       [](Rig& rig) {
         for (Camera& camera : rig.cameras)
           camera.image_size = ImageSize{3 * camera.image_size->width, 3 * camera.image_size->height};
         return !rig.cameras.empty();
       }},
      {"translation-in-mm", 2,
       [](Rig& rig) {
         if (!rig.baseline_m) return false;
         rig.baseline_m = *rig.baseline_m * 1000.0;
         return true;
       }},
      {"parameters-swapped", 2, [](Rig& rig) { return exchange(rig, "xi", "alpha"); }},
      {"parameters-swapped", 2, [](Rig& rig) { return exchange(rig, "alpha", "beta"); }},
      {"wrong-model", 2, [](Rig& rig) { return rename(rig, "kb4", "radtan"); }},
      {"wrong-model", 2, [](Rig& rig) { return rename(rig, "radtan", "kb4"); }},
      {"wrong-model", 2, [](Rig& rig) { return rename(rig, "eucm", "ds"); }},
      {"wrong-model", 2, [](Rig& rig) { return rename(rig, "ucm", "mei"); }},
      {"distortion-left-out", 3, remove_distortion},
      {"cameras-exchanged", 3,
       [](Rig& rig) {
         if (rig.cameras.size() < 2) return false;
         const std::string first = rig.cameras[0].name;
         const std::string second = rig.cameras[1].name;
         const auto exchanged = [&](std::string& name) { name = name == first ? second : name == second ? first : name; };
         exchanged(rig.cameras[0].name);
         exchanged(rig.cameras[1].name);
         for (PoseEdge& edge : rig.poses) {
           exchanged(edge.a);
           exchanged(edge.b);
         }
         const Pixel a = principal_point(rig.cameras[0].model);
         const Pixel b = principal_point(rig.cameras[1].model);
         return rig.cameras[0].image_size == rig.cameras[1].image_size && std::hypot(a[0] - b[0], a[1] - b[1]) > 1.0;
       }},
      {"pose-of-another-camera", 2,
       [](Rig& rig) {
         if (rig.cameras.size() != 2 || rig.poses.size() != 3) return false;
         std::vector<Transform*> of_imu;
         for (PoseEdge& edge : rig.poses) {
           if (edge.b == "imu0" && rig.find_camera(edge.a) != nullptr) of_imu.push_back(&edge.T_a_b);
         }
         if (of_imu.size() != 2 || !far(*of_imu[0], *of_imu[1])) return false;
         std::swap(*of_imu[0], *of_imu[1]);  // the third statement stays
         return true;
       }},
      {"poses-exchanged", 2,
       [](Rig& rig) {
         PoseEdge* first = nullptr;
         for (PoseEdge& edge : rig.poses) {
           if (edge.b != "imu0" && edge.a != "imu0") continue;
           if (first != nullptr && far(first->T_a_b, edge.T_a_b) && rig.find_camera(edge.a) != nullptr) {
             std::swap(first->T_a_b, edge.T_a_b);
             std::erase_if(rig.poses, [](const PoseEdge& each) { return each.a != "imu0" && each.b != "imu0"; });
             return true;
           }
           first = &edge;
         }
         return false;
       }},
  };
  return kPlants;
}

TEST(CompareFiles, PlantedMistakesAreNamed) {
  std::map<std::string, Rig> rigs = completed_rigs();
  rigs.insert(good_rigs().begin(), good_rigs().end());
  for (std::size_t i = 0; i < plants().size(); ++i) {
    const Plant& plant = plants()[i];
    constexpr std::size_t kMost = 3;  // all of them take too long
    std::size_t planted = 0;
    // Begins elsewhere in the list for each.
    auto at = std::next(rigs.begin(), static_cast<std::ptrdiff_t>(7 * i % rigs.size()));
    for (std::size_t tried = 0; tried < rigs.size() && planted < kMost; ++tried) {
      if (++at == rigs.end()) at = rigs.begin();
      const auto& [name, rig] = *at;
      Rig other = rig;
      if (!plant.plant(other)) continue;
      ++planted;
      const RigComparison result = compared(rig, other);
      EXPECT_TRUE(claims(result, plant.code)) << i << ", " << plant.code << " in " << name << " is called\n" << said(result);
      for (const Mistake& mistake : result.mistakes)
        EXPECT_EQ(id_of(mistake.message), plant.code) << name << ": " << said(result);
    }
    EXPECT_GE(planted, plant.fewest) << i << ", " << plant.code;
  }
}

/// Compares each with a few that follow it.
std::size_t expect_no_mistakes(const std::map<std::string, Rig>& rigs, int neighbours) {
  std::size_t pairs = 0;
  for (auto one = rigs.begin(); one != rigs.end(); ++one) {
    auto two = one;
    for (int i = 0; i < neighbours && ++two != rigs.end(); ++i) {
      ++pairs;
      EXPECT_EQ(said(compared(one->second, two->second)), "") << one->first << " and " << two->first;
    }
  }
  return pairs;
}

/// One camera of each model, and the same numbers as another model would have them: fx fy cx cy, then the lens's in their
/// order. Files keep the mirror parameter xi of mei elsewhere, so that it may be there or not.
std::vector<double> numbers_of_lens(const CameraModel& model, bool with_mirror) {
  std::vector<double> numbers;
  for (const Parameter& parameter_of_model : model_info(model).parameters.subspan(4)) {
    if (with_mirror || parameter_of_model.name != "xi" || model_info(model).id != "mei")
      numbers.push_back(*parameter(model, ParameterId(parameter_of_model)));
  }
  return numbers;
}

std::optional<CameraModel> under_the_name(const CameraModel& model, const ModelInfo& name, bool with_mirror) {
  CameraModel wrong = *make_model(name.id);
  for (const char* first : {"fx", "fy", "cx", "cy"}) {
    const auto id = ParameterId(*std::ranges::find(name.parameters, first, &Parameter::name));
    if (!set_parameter(wrong, id, *parameter(model, id))) return std::nullopt;
  }
  std::vector<double> numbers = numbers_of_lens(model, with_mirror);
  for (const Parameter& place : name.parameters.subspan(4)) {
    if (!with_mirror && place.name == "xi" && name.id == "mei") {
      set_parameter(wrong, ParameterId(place), 1.0);
      continue;
    }
    if (numbers.empty()) continue;
    set_parameter(wrong, ParameterId(place), numbers.front());
    numbers.erase(numbers.begin());
  }
  const bool all_fit = std::ranges::all_of(numbers, [](double number) { return number == 0.0; });
  return all_fit && validate(wrong).empty() ? std::optional(wrong) : std::nullopt;
}

// For every pair of models whose numbers fit into each other.
TEST(CompareFiles, ALensUnderAnotherModelsNameIsRecognised) {
  std::size_t pairs = 0;
  const Camera& tumvi = good_rigs().at("kalibr/tumvi.yaml").cameras.front();
  for (const ModelInfo& right : all_models()) {
    if (!right.focal_lengths_first || right.id == "pinhole") continue;
    Diagnostics diagnostics;
    ConvertOptions options;
    options.model = right.id;
    options.max_angle_rad = 50.0 * kRadiansPerDegree;
    options.bound = false;
    const std::optional<Conversion> converted = convert(tumvi, options, diagnostics);
    ASSERT_TRUE(converted) << right.id;
    for (const ModelInfo& name : all_models()) {
      if (name.id == right.id || !name.focal_lengths_first) continue;
      for (const bool with_mirror : {true, false}) {
        const std::optional<CameraModel> wrong = under_the_name(converted->camera.model, name, with_mirror);
        if (!wrong) continue;
        Rig reference;
        reference.cameras = {converted->camera};
        Rig other = reference;
        other.cameras.front().model = *wrong;
        const RigComparison compared =
            compare(reference, other, {.max_angle_rad = 50.0 * kRadiansPerDegree, .bound = false}, diagnostics);
        if (compared.cameras.empty() || compared.cameras.front().difference.statistics.error.max <= 1.0) continue;
        ++pairs;
        ASSERT_EQ(compared.mistakes.size(), 1U) << right.id << " as " << name.id;
        EXPECT_EQ(id_of(compared.mistakes.front().message), "wrong-model") << right.id << " as " << name.id;
      }
    }
  }
  std::printf("%zu pairs\n", pairs);
  EXPECT_GE(pairs, 20U);
}

TEST(CompareFiles, NoMistakeIsClaimedOfHonestPairs) { EXPECT_GT(expect_no_mistakes(good_rigs(), 2), 70U); }

TEST(CompareFiles, PosesHaveTheNamesOfTheirFiles) {
  const std::map<std::string, std::vector<std::string>> expected = {
      {"orbslam3/good/v1-stereo-inertial.yaml", {"Stereo.T_c1_c2", "IMU.T_b_c1"}},
      {"kalibr/good/tumvi.yaml", {"cam0 T_cam_imu", "cam1 T_cam_imu", "cam1 T_cn_cnm1"}},
      {"woodscape/good/front.json", {"extrinsic translation"}},
  };
  for (const auto& [name, keys] : expected) {
    const std::optional<Calibration> calibration = read(testdata_dir() / name);
    ASSERT_TRUE(calibration) << name;
    std::vector<std::string> found;
    for (std::size_t i = 0; i < calibration->rig.poses.size(); ++i) found.push_back(key_of_pose(*calibration, i));
    std::ranges::sort(found);
    std::vector<std::string> sorted = keys;
    std::ranges::sort(sorted);
    EXPECT_EQ(found, sorted) << name;
  }
}

// As near to each other as two honest calibrations are; but none of those is the other's transpose to the last digit.
TEST(CompareFiles, ATransposedRotationOfAThirdOfADegreeIsNamed) {
  Rig rig = good_rigs().at("kalibr/tumvi.yaml");
  const auto pose = [](double degrees) {
    const double angle = degrees * kRadiansPerDegree;
    Transform T;
    T(0, 0) = T(1, 1) = std::cos(angle);
    T(0, 1) = -std::sin(angle);
    T(1, 0) = std::sin(angle);
    T(0, 3) = 0.11;
    return T;
  };
  rig.poses = {{"cam1", "cam0", pose(0.17)}};
  Rig other = rig;
  other.poses.front().T_a_b = transposed(pose(0.17));
  for (int row = 0; row < 3; ++row) other.poses.front().T_a_b(row, 3) = pose(0.17)(row, 3);
  EXPECT_TRUE(claims(compared(rig, other), "pose-transposed"));
  other.poses.front().T_a_b = pose(-0.16);
  EXPECT_EQ(said(compared(rig, other)), "");
}

TEST(CompareFiles, PosesAloneAreCompared) {
  const std::optional<Calibration> calibration = read(testdata_dir() / "opencv/good/extrinsics.yml");
  ASSERT_TRUE(calibration && calibration->rig.cameras.empty());
  EXPECT_TRUE(compared(calibration->rig, calibration->rig).identical());
  Rig other = calibration->rig;
  other.poses.front().T_a_b(0, 3) += 0.25;
  const RigComparison result = compared(calibration->rig, other);
  ASSERT_EQ(result.poses.size(), calibration->rig.poses.size());
  EXPECT_NEAR(result.poses.front().distance_m, 0.25, 1e-12);
}

// Neighbours by name are often calibrations of one camera.
TEST(CompareFiles, NoMistakeIsClaimedOfRealPairs) {
  const fs::path corpus = shared_dir() / "corpus";
  if (!fs::exists(corpus)) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  std::size_t pairs = 0;
  for (const char* format : {"kalibr", "opencv", "ocamcalib", "orbslam3", "tumvi", "woodscape"}) {
    std::map<std::string, Rig> rigs;
    std::size_t at = 0;
    for (const fs::path& path : files_in(corpus / format)) {
      if (at++ % 4 >= 2) continue;  // pairs of neighbours; all of them take too long
      if (std::optional<Calibration> calibration = read(path)) rigs[path.filename().string()] = calibration->rig;
    }
    pairs += expect_no_mistakes(rigs, 1);
  }
  EXPECT_GT(pairs, 100U);
}

}  // namespace
}  // namespace fca::test
