// SPDX-License-Identifier: BSD-3-Clause
// How a fresh file is spelled, and which of its values no input specifies.
#include "settings.h"

#include "../composed.h"

#include <fca/code.h>

#include <algorithm>
#include <array>

namespace fca::orbslam3 {

using fields::Field;

namespace {

/// What to tell people next to a value that no input specifies.
struct Note {
  std::string_view comment;
  bool look_at_it = false;
};

constexpr Note kFrameRateNote = {"Default. Frames per second: not in the input, upstream's example value. Set your camera's.",
                                 true};
constexpr Note kPoseNote = {"Default. Identity: not in the input, and slam_no_opt does not start without it.", true};

/// The note on a field; nothing on a value that an input specifies, or that its group's note covers.
std::optional<Note> note_on(const Field& field, const Target& target, const Rig& rig) {
  if (field.key == "Camera.fps" && !target.frame_rate_known) return kFrameRateNote;
  if (field.key == "Camera.Tbc" && !rig.resolve("imu0", rig.cameras.front().name)) return kPoseNote;
  const TuningKey* key = find_tuning_key(field.key);
  if (key == nullptr || key->note.empty() || target.tuning.states(*key)) return std::nullopt;
  return Note{key->note, key->look_at_it};
}

/// "Viewer." and "ORBextractor.": keys that are told as one.
constexpr std::array<std::string_view, 2> kGroups = {"ORBextractor.", "Viewer."};

bool upstreams(const Field& field, const Target& target) {
  const TuningKey* key = find_tuning_key(field.key);
  return key != nullptr && !target.tuning.states(*key);
}

/// Comments that say what a key means.
struct Heading {
  std::string_view key;
  std::string_view comment;
};

constexpr std::array kHeadings = {
    Heading{"Camera2.fx", "Second camera"},
    Heading{"Stereo.T_c1_c2", "Second camera in the first: p_c1 = T p_c2, metres"},
    Heading{"Tlr", "Right camera in the left: p_left = Tlr p_right, metres"},
    Heading{"LEFT.height", "Both cameras as they take the images, for stereo"},
    Heading{"CAMERA.R", "p_right = R p_left + T, metres"},
    Heading{"Camera.width", "Image"},
    Heading{"Camera.bf", "Baseline times fx"},
    Heading{"Stereo.b", "Baseline, metres"},
    Heading{"IMU.T_b_c1", "First camera in the IMU: p_imu = T p_c1, metres"},
    Heading{"Tbc", "Camera in the IMU: p_imu = Tbc p_camera, metres"},
    Heading{"Camera.Tbc", "Camera in the body or IMU: p_body = Tbc p_camera, metres"},
    Heading{"IMU.NoiseGyro",
            "IMU noise, continuous time: rad/s/sqrt(Hz), m/s^2/sqrt(Hz), rad/s^2/sqrt(Hz), m/s^3/sqrt(Hz); rate in Hz"},
    Heading{"ORBextractor.nFeatures", "ORB extractor: tuning"},
    Heading{"Viewer.KeyFrameSize", "Viewer: demanded even without a window"},
};

}  // namespace

std::vector<DefaultedValue> defaulted(const std::vector<Field>& fields, const Target& target, const Rig& rig) {
  std::vector<DefaultedValue> result;
  for (const Field& field : fields) {
    if (const std::optional<Note> note = note_on(field, target, rig)) {
      const bool is_pose = field.shape == fields::Shape::kMatrix;
      const Argument value = is_pose ? Argument(Message{Code::kIdentity}) : Argument(field.tokens.front());
      result.push_back({field.key, value, note->look_at_it, is_pose});
    }
  }
  for (const std::string_view group : kGroups) {
    const auto in_group = [group](const Field& field) { return field.key.starts_with(group); };
    const auto members = std::ranges::count_if(fields, in_group);
    const auto ours = std::ranges::count_if(fields, [&](const Field& f) { return in_group(f) && upstreams(f, target); });
    if (members > 0 && ours == members) {
      result.push_back({std::string(group) + "*", Message{Code::kOrbslam3Upstreams}, false});
      continue;
    }
    for (const Field& field : fields) {
      if (in_group(field) && upstreams(field, target)) result.push_back({field.key, field.tokens.front(), false});
    }
  }
  return result;
}

std::optional<text::Document> compose(const std::vector<Field>& fields, const Target& target, const Rig& rig,
                                      std::string_view headline, Diagnostics& diagnostics) {
  ComposedYaml text("%YAML:1.0\n# " + std::string(headline) + "\n\n");
  for (const Field& field : fields) {
    for (const Heading& heading : kHeadings) {
      if (heading.key != field.key) continue;
      text.add_comments("\n# " + std::string(heading.comment) + (upstreams(field, target) ? ", upstream's values" : "") + "\n");
    }
    if (const std::optional<Note> note = note_on(field, target, rig))
      text.add_comments("# " + std::string(note->comment) + "\n");
    text.add(field);
    if (field.key == "Camera.type" || field.key == "File.version") text.add_comments("\n");
  }
  return std::move(text).document("settings.yaml", diagnostics);
}

}  // namespace fca::orbslam3
