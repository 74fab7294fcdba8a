// SPDX-License-Identifier: BSD-3-Clause
// A loss without advice is half a message: each says what to do.
#include "formats/rigs.h"
#include "formats/test_files.h"
#include "id_and_arguments.h"

#include <fca/code.h>
#include <fca/formats/wording.h>

namespace fca::test {
namespace {

/// A rig that specifies whatever a rig can state.
Rig talkative_rig(const Format& format) {
  Rig rig = sample_rig("kb4", {true, true});
  for (Camera& camera : rig.cameras) {
    if (format.id == "ocamcalib") camera.model = model_of("ocamcalib", {256, 256, 1, 0, 0, -190, 0, 2e-3, 0, 0, 0, 0, 0, 0});
    if (format.id == "woodscape") camera.model = model_of("woodscape", {190.5, -3.25, 6.75, -0.875, 1.0, 255.5, 255.5});
    if (format.id == "mrcal") camera.model = sample_model("radtan");
    camera.time_offset_s = -0.0021;
    camera.frame_rate_hz = 29.97;
  }
  rig.imus.push_back({"imu1", 1e-3, {}, {}, {}, {}, {}});
  rig.extra_fields.push_back({"cam0", "line_delay", "1e-5"});
  rig.baseline_m = 0.1;
  return rig;
}

TEST(Remedies, EveryLossSaysWhatToDo) {
  std::size_t losses = 0;
  for (const Format& format : written_formats()) {
    Diagnostics diagnostics;
    const std::optional<Written> written = write_calibration(format, nullptr, talkative_rig(format), {}, diagnostics);
    ASSERT_TRUE(written) << format.id;
    EXPECT_FALSE(written->losses.empty()) << format.id;
    for (const Loss& loss : written->losses) {
      EXPECT_NE(remedy_of(loss), "") << format.id << " " << what_of(loss);
      if (id_of(loss) == "time-offset-dropped") {
        // t_imu = t_cam + offset: an image's time stamp becomes the IMU's by adding the offset, sign and all.
        EXPECT_TRUE(speaks_of(facts_of(loss), -0.0021)) << remedy_of(loss);
      }
    }
    losses += written->losses.size();
  }
  EXPECT_GT(losses, 20U);
}

}  // namespace
}  // namespace fca::test
