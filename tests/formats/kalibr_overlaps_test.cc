// SPDX-License-Identifier: BSD-3-Clause
// cam_overlaps says which cameras see something in common. Which those are does not change with the order in which they stand.
#include "formats/lost_facts.h"
#include "formats/test_files.h"

#include <fca/code.h>
#include <fca/formats/wording.h>

#include <map>
#include <set>

namespace fca::test {
namespace {

/// A camera that is known by its focal length.
std::string camera(int number, const std::string& overlaps) {
  return "cam" + std::to_string(number) + ":\n  cam_overlaps: " + overlaps + "\n  camera_model: pinhole\n  intrinsics: [" +
         std::to_string(400 + number) +
         ".5, 400.5, 320.0, 240.0]\n  distortion_model: radtan\n  distortion_coeffs: [0.01, 0.02, 0.0, 0.0]\n"
         "  resolution: [640, 480]\n";
}

/// Focal length -> those of the cameras it overlaps with.
using Relation = std::map<double, std::set<double>>;

Relation relation_in(const std::string& bytes) {
  const Calibration calibration = calibration_of(bytes);
  const auto focal_length = [&](std::size_t i) { return *parameter(calibration.rig.cameras.at(i).model, "fx"); };
  Relation relation;
  for (std::size_t i = 0; i < calibration.rig.cameras.size(); ++i) {
    std::set<double>& others = relation[focal_length(i)];
    const text::Node& list = at(calibration.documents.front(), "cam" + std::to_string(i) + "/cam_overlaps");
    for (const text::Node& item : list.items) others.insert(focal_length(std::stoul(item.value)));
  }
  return relation;
}

TEST(KalibrOverlaps, AreTheSameCamerasInAnyOrder) {
  const std::string bytes = camera(0, "[1, 2]") + camera(1, "[0]") + camera(2, "[0, 3]") + camera(3, "[2]");
  const Calibration base = calibration_of(bytes);
  const Relation before = relation_in(bytes);
  for (const std::vector<std::size_t>& order :
       {std::vector<std::size_t>{0, 1, 2, 3}, {3, 2, 1, 0}, {2, 0}, {1, 2}, {2}, {0, 2, 3}, {1, 3, 0, 2}}) {
    for (const bool rewrite : {false, true}) {
      SCOPED_TRACE(testing::PrintToString(order) + (rewrite ? " anew" : ""));
      Rig rig = base.rig;
      rig.cameras.clear();
      for (const std::size_t i : order) rig.cameras.push_back(base.rig.cameras[i]);
      Relation expected;
      std::set<double> present;
      for (const Camera& kept : rig.cameras) present.insert(*parameter(kept.model, "fx"));
      for (const auto& [one, others] : before) {
        if (!present.contains(one)) continue;
        std::ranges::copy_if(others, std::inserter(expected[one], expected[one].end()),
                             [&present](double other) { return present.contains(other); });
      }
      WriteOptions options;
      options.rewrite = rewrite;
      Diagnostics diagnostics;
      const std::optional<Written> written =
          write_calibration(*base.format, &base.documents.front(), rig, options, diagnostics);
      ASSERT_TRUE(written);
      EXPECT_EQ(relation_in(written->files.front().document.bytes()), expected) << written->files.front().document.bytes();
      // Who is left out is left out there, too.
      const bool all = order.size() == before.size();
      EXPECT_FALSE(all && loses_anything_of(*written, "cam_overlaps"));
    }
  }
}

// Without the file that they stand in they are those of the rig's cameras; written into another file they count none of its.
TEST(KalibrOverlaps, AreOfTheRigTheyWereReadWith) {
  const std::string bytes = camera(0, "[1]") + camera(1, "[0]") + camera(2, "[]");
  const Calibration chain = calibration_of(bytes);
  Rig rig = chain.rig;
  std::ranges::reverse(rig.cameras);
  Diagnostics diagnostics;
  const std::optional<Written> fresh = write_calibration(*chain.format, nullptr, rig, {}, diagnostics);
  ASSERT_TRUE(fresh);
  EXPECT_TRUE(fresh->losses.empty()) << what_of(fresh->losses.front());
  EXPECT_EQ(relation_in(fresh->files.front().document.bytes()), relation_in(bytes));
  const Calibration other = calibration_of(camera(0, "[]"));
  const std::optional<Written> into = write_calibration(*chain.format, &other.documents.front(), chain.rig, {}, diagnostics);
  ASSERT_TRUE(into);
  const Loss expected =
      lost(Code::kNotCarriedValue, "cam1", "cam_overlaps", {Message{Code::kCamchainOverlapsOfItsFile}, "[0]"});
  const auto same = [&expected](const Loss& loss) { return facts_of(loss) == facts_of(expected); };
  EXPECT_TRUE(std::ranges::any_of(into->losses, same));
}

}  // namespace
}  // namespace fca::test
