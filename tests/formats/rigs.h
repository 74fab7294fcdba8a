// SPDX-License-Identifier: BSD-3-Clause
// Rigs built in code: every model, one or two cameras, with or without IMU and poses. Figures: TUM-VI's published calibration
// and Basalt's of the same cameras (sources in testdata/formats), EuRoC's for the pinhole ones.
#pragma once

#include <fca/rig/rig.h>

#include <initializer_list>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "transforms.h"

namespace fca::test {

inline CameraModel model_of(const std::string& id, std::initializer_list<double> values) {
  std::optional<CameraModel> model = make_model(id);
  EXPECT_TRUE(model) << id;
  const std::span<double> target = parameter_values(*model);
  EXPECT_EQ(target.size(), values.size()) << id;
  std::copy(values.begin(), values.end(), target.begin());
  return *model;
}

struct ParameterValue {
  ParameterId id;
  double value;
};

/// Two cameras of every model Kalibr can hold, the parameters in our order (fx fy cx cy first).
inline CameraModel sample_model(const std::string& id, int camera = 0) {
  const bool first = camera == 0;
  if (id == "pinhole")
    return first ? model_of(id, {458.654, 457.296, 367.215, 248.375}) : model_of(id, {457.587, 456.134, 379.999, 255.238});
  if (id == "radtan") {
    CameraModel model = *make_model(id);
    const std::vector<ParameterValue> left = {{"fx", 458.654},    {"fy", 457.296},       {"cx", 367.215},
                                              {"cy", 248.375},    {"k1", -0.28340811},   {"k2", 0.07395907},
                                              {"p1", 0.00019359}, {"p2", 1.76187114e-05}};
    const std::vector<ParameterValue> right = {{"fx", 457.587},     {"fy", 456.134},        {"cx", 379.999},
                                               {"cy", 255.238},     {"k1", -0.28368365},    {"k2", 0.07451284},
                                               {"p1", -0.00010473}, {"p2", -3.55590700e-05}};
    for (const auto& [name, value] : first ? left : right) EXPECT_TRUE(set_parameter(model, name, value));
    return model;
  }
  if (id == "kb4") {
    return first ? model_of(id, {190.97847715128717, 190.9733070521226, 254.93170605935475, 256.8974428996504,
                                 0.0034823894022493434, 0.0007150348452162257, -0.0020532361418706202, 0.00020293673591811182})
                 : model_of(id, {190.44236969414825, 190.4344384721956, 252.59949716835982, 254.91723064636983,
                                 0.0034003170790442797, 0.001766278153469831, -0.00266312569781606, 0.0003299517423931039});
  }
  CameraModel model = *make_model(id);
  const auto set = [&model, &id](std::initializer_list<ParameterValue> values) {
    for (const auto& [name, value] : values) EXPECT_TRUE(set_parameter(model, name, value)) << id << " " << name.name();
  };
  if (id == "opencv14")  // its prism is that of real lenses, its tilt an OAK camera's
    return first ? model_of(id, {458.654, 457.296, 367.215, 248.375, -0.28, 0.07, 0.0002, 0.00002, 0.001, 0.01, 0.002, 0.0005,
                                 0.0011, -0.0002, -0.0007, 0.0004, 0.0021, -0.0013})
                 : model_of(id, {457.587, 456.134, 379.999, 255.238, -0.283, 0.074, -0.0001, -0.00003, 0.001, 0.01, 0.002,
                                 0.0005, 0.0009, -0.0001, -0.0005, 0.0003, -0.0032, 0.0018});
  if (id == "eucm")
    first ? set({{"fx", 191.14799836282189},
                 {"fy", 191.13150963902818},
                 {"cx", 254.9585771534443},
                 {"cy", 256.88154645599448},
                 {"alpha", 0.6291060881178562},
                 {"beta", 1.0418067381860868}})
          : set({{"fx", 190.47905769226575},
                 {"fy", 190.44567561523216},
                 {"cx", 252.55882115024333},
                 {"cy", 255.02104780344699},
                 {"alpha", 0.6281040684983363},
                 {"beta", 1.041250259119081}});
  if (id == "ds")
    first ? set({{"fx", 158.28600034966977},
                 {"fy", 158.2743455478755},
                 {"cx", 254.96116578191653},
                 {"cy", 256.8894394501779},
                 {"xi", -0.17213086034353243},
                 {"alpha", 0.5931177593944744}})
          : set({{"fx", 157.91830144176309},
                 {"fy", 157.8901286125632},
                 {"cx", 252.56547609702953},
                 {"cy", 255.02489416194656},
                 {"xi", -0.17114780716007858},
                 {"alpha", 0.5925543396658507}});
  if (id == "ucm")
    first ? set({{"fx", 190.5}, {"fy", 190.25}, {"cx", 255.5}, {"cy", 256.5}, {"alpha", 0.6125}})
          : set({{"fx", 191.0}, {"fy", 191.5}, {"cx", 252.0}, {"cy", 254.0}, {"alpha", 0.61}});
  if (id == "mei")
    first ? set({{"fx", 333.25},
                 {"fy", 333.0},
                 {"cx", 254.5},
                 {"cy", 256.75},
                 {"xi", 1.625},
                 {"k1", -0.1},
                 {"k2", 0.05},
                 {"p1", 0.0005},
                 {"p2", -0.0003}})
          : set({{"fx", 334.5},
                 {"fy", 334.25},
                 {"cx", 252.5},
                 {"cy", 254.75},
                 {"xi", 1.65},
                 {"k1", -0.11},
                 {"k2", 0.06},
                 {"p1", 0.0004},
                 {"p2", 0.0002}});
  if (id == "fov")
    first ? set({{"fx", 245.5}, {"fy", 245.25}, {"cx", 255.25}, {"cy", 256.125}, {"w", 0.93}})
          : set({{"fx", 245.0}, {"fy", 244.5}, {"cx", 252.25}, {"cy", 254.125}, {"w", 0.925}});
  if (id == "division")
    return first ? model_of(id, {260.5, 260.25, 255.25, 256.125, -0.31}) : model_of(id, {260.0, 259.5, 252.25, 254.125, -0.3});
  if (id == "thin-prism-fisheye")
    return first
               ? model_of(id, {190.5, 190.25, 255.5, 256.5, 0.0035, 0.0007, 0.0004, -0.0003, -0.002, 0.0002, 0.0006, -0.0002})
               : model_of(id, {190.0, 190.5, 252.5, 254.75, 0.0034, 0.0018, 0.0002, 0.0001, -0.0027, 0.0003, -0.0004, 0.0005});
  if (id == "fisheye624")
    return first ? model_of(id, {241.5, 241.25, 255.5, 256.5, -0.02, 0.09, -0.06, 0.01, 0.003, -0.0008, -0.0006, 0.0005, 0.0008,
                                 -0.0002, 0.0003, -0.0001})
                 : model_of(id, {241.0, 241.5, 252.5, 254.75, -0.021, 0.088, -0.058, 0.009, 0.003, -0.0007, 0.0004, -0.0003,
                                 -0.0006, 0.0001, 0.0005, 0.0002});
  return model;
}

inline ImageSize sample_size(const std::string& id) {
  return id == "pinhole" || id == "radtan" ? ImageSize{752, 480} : ImageSize{512, 512};
}

/// TUM-VI: p_cam0 = T p_imu.
inline Transform T_cam0_imu() {
  return {{-0.9995250378696743, 0.029615343885863205, -0.008522328211654736, 0.04727988224914392, 0.0075019185074052044,
           -0.03439736061393144, -0.9993800792498829, -0.047443232143367084, -0.02989013031643309, -0.998969345370175,
           0.03415885127385616, -0.0681999605066297, 0.0, 0.0, 0.0, 1.0}};
}

/// TUM-VI: p_cam1 = T p_cam0.
inline Transform T_cam1_cam0() {
  return {{0.9999994457734953, -0.0008233639921576076, -0.0006561436136444361, -0.10106110275180535, 0.0007916877528168117,
           0.9988994619156757, -0.04689603624058988, -0.0019764575873431013, 0.0006940340102242531, 0.04689549078870055,
           0.9988995601463054, -0.0011756424802046581, 0.0, 0.0, 0.0, 1.0}};
}

inline Imu tumvi_imu() { return {"imu0", 0.00016, 2.2e-05, 0.0028, 0.00086, 200.0, "/imu0"}; }

struct RigShape {
  bool two = false;
  bool imu = false;
};

inline Rig sample_rig(const std::string& id, RigShape shape) {
  Rig rig;
  for (int i = 0; i < (shape.two ? 2 : 1); ++i) {
    const std::string index = std::to_string(i);
    rig.cameras.push_back(
        {"cam" + index, sample_size(id), sample_model(id, i), std::nullopt, std::nullopt, "/cam" + index + "/image_raw"});
  }
  if (shape.two) rig.poses.push_back({"cam1", "cam0", T_cam1_cam0()});
  if (shape.imu) {
    rig.poses.push_back({"cam0", "imu0", T_cam0_imu()});
    rig.add_frame("imu0", FrameKind::kImu);
    rig.imus.push_back(tumvi_imu());
  }
  return rig;
}

}  // namespace fca::test
