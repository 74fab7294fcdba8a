// SPDX-License-Identifier: BSD-3-Clause
#include "edit.h"

#include "../colmap/lines.h"
#include "../fields.h"
#include "layout.h"
#include "read.h"

#include <algorithm>
#include <functional>

namespace fca::nerfstudio {

using fields::Field;
using text::Node;

namespace {

bool is_one_of(const std::vector<std::string_view>& keys, std::string_view key) {
  return std::ranges::find(keys, key) != keys.end();
}
double value_of(const Camera& camera, ParameterId id) { return parameter(camera.model, id).value(); }

/// All of the camera's coefficients, those that its model has not as zeros.
Field coefficient_list(const Camera& camera) {
  std::vector<double> numbers;
  const auto& parameters = model_info(camera.model).parameters;
  for (const std::string_view key : kCoefficients) {
    const auto row = std::ranges::find(parameters, key, &Parameter::name);
    numbers.push_back(row != parameters.end() ? value_of(camera, ParameterId(*row)) : 0.0);
  }
  return fields::list(std::string(kCoefficientList), numbers);
}

/// What an object says before and after.
struct Change {
  std::vector<Field> before;
  std::vector<Field> after;

  void add(const Field* was, const Field* is) {
    if (was != nullptr) before.push_back(*was);
    if (is != nullptr) after.push_back(*is);
  }
};

const Field* find_field(const std::vector<Field>& fields, std::string_view key) {
  const auto found = std::ranges::find(fields, key, &Field::key);
  return found == fields.end() ? nullptr : &*found;
}

/// A camera of the file as it was and as it is to be.
struct EditedCamera {
  const Group& group;
  const Camera& old;
  const Camera& now;
  std::vector<Field> before;
  std::vector<Field> after;

  [[nodiscard]] const Field* was(std::string_view key) const { return find_field(before, key); }
  [[nodiscard]] const Field* is(std::string_view key) const { return find_field(after, key); }
  /// Neither a focal length nor a side of the image along that axis is another one.
  [[nodiscard]] bool same_angle(bool horizontal) const {
    const ParameterId id = horizontal ? ParameterId("fx") : ParameterId("fy");
    return value_of(old, id) == value_of(now, id) && old.image_size == now.image_size;
  }
};

class Editor {
 public:
  Editor(const text::Document& base, const std::vector<Group>& groups, const Rig& old, const Rig& rig)
      : document_(base), root_(base.root()) {
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const Camera& before = old.cameras[i];
      const Camera& after = rig.cameras[i];
      cameras_.push_back({groups[i], before, after, numbers_of(before), numbers_of(after)});
    }
  }

  text::Document run() {
    change_kind();
    for (const std::string_view key : kFocalAndCentre) change(key, same(key));
    for (const std::string_view key : kSize) change(key, same(key));
    const bool same_coefficients = std::ranges::all_of(kCoefficients, [this](std::string_view key) { return same(key); });
    change_list(same_coefficients);
    for (const std::string_view key : kCoefficients) change(key, same_coefficients);
    change_angles();
    fields::apply(document_, root_, kDialect, top_.before, top_.after);
    for (const EditedCamera& camera : cameras_) {
      for (const Node* frame : camera.group.frames) {
        const Change change = in_frame(camera, *frame);
        fields::apply(document_, *frame, kDialect, change.before, change.after);
      }
    }
    return std::move(document_);
  }

 private:
  /// Have all cameras the same number, or none; or each the one that it had?
  [[nodiscard]] bool same(std::string_view key) const {
    const auto equal = [](const Field* a, const Field* b) { return a == nullptr || b == nullptr ? a == b : *a == *b; };
    const Field* first = cameras_.front().is(key);
    return std::ranges::all_of(cameras_, [&](const EditedCamera& camera) { return equal(camera.is(key), first); }) ||
           std::ranges::all_of(cameras_, [&](const EditedCamera& camera) { return equal(camera.is(key), camera.was(key)); });
  }

  [[nodiscard]] bool is_at_top(std::string_view key) const {
    return is_coefficient(key) ? coefficients_at_top(root_) : value_in(root_, key) != nullptr;
  }

  [[nodiscard]] bool is_in_frames(std::string_view key) const {
    return std::ranges::any_of(cameras_, [key](const EditedCamera& camera) {
      return std::ranges::any_of(camera.group.frames, [key](const Node* frame) {
        return is_coefficient(key) ? has_coefficients(*frame) : value_in(*frame, key) != nullptr;
      });
    });
  }

  /// Would a reader of the file, in which the key does not stand, take another number?
  [[nodiscard]] bool must_state(const EditedCamera& camera, std::string_view key) const {
    const Field* is = camera.is(key);
    if (is == nullptr) return false;
    const Node& frame = camera.group.frames.empty() ? root_ : *camera.group.frames.front();
    const auto has_angle = [&](bool horizontal) {
      return angle_in(root_, horizontal) != nullptr || angle_in(frame, horizontal) != nullptr;
    };
    const auto is_middle = [&camera](ParameterId id, int side) {
      return value_of(camera.now, id) == colmap::from_file(0.5 * side);
    };
    if (key == "fl_x" || key == "fl_y") {
      const bool horizontal = key == "fl_x";
      if (has_angle(horizontal)) return !camera.same_angle(horizontal);
      return value_of(camera.now, "fx") != value_of(camera.now, "fy");
    }
    if (key == "cx") return !is_middle("cx", camera.now.image_size ? camera.now.image_size->width : 0);
    if (key == "cy") return !is_middle("cy", camera.now.image_size ? camera.now.image_size->height : 0);
    if (!is_coefficient(key)) return camera.old.image_size != camera.now.image_size;
    const bool other_model = camera.old.model.index() != camera.now.model.index();
    const bool optional = key == "k3" && !is_fisheye(camera.now);
    return is->tokens.front() != "0.0" || (other_model && !optional);
  }

  /// The list at the top. It goes to the frames where it is no longer that of all cameras.
  void change_list(bool same) {
    if (value_in(root_, kCoefficientList) == nullptr) return;
    const Field before = coefficient_list(cameras_.front().old);
    const Field after = coefficient_list(cameras_.front().now);
    top_.add(&before, same ? &after : nullptr);
    if (!same) moved_.push_back(kCoefficientList);
  }

  /// Notes what the top says of a key; frames are asked for what is left to them.
  void change(std::string_view key, bool same) {
    const EditedCamera& first = cameras_.front();
    const bool there = value_in(root_, key) != nullptr;
    // Next to a list no key is wanted that is not there.
    if (!there && is_coefficient(key) && value_in(root_, kCoefficientList) != nullptr) return;
    if (is_at_top(key)) {
      const Field* is = same && (there || must_state(first, key)) ? first.is(key) : nullptr;
      if (there || is != nullptr) top_.add(there ? first.was(key) : nullptr, is);
      if (same) return;
      moved_.push_back(key);
      // A coefficient that is 0 and none of the model's would keep those of the frames from being read.
      if (there && first.was(key) == nullptr) top_.before.push_back(fields::integer(std::string(key), 0));
    } else if (same && !is_in_frames(key)) {
      if (must_state(first, key)) top_.add(nullptr, first.is(key));
    } else {
      in_frames_.push_back(key);
    }
  }

  /// What one of the camera's frames says.
  [[nodiscard]] Change in_frame(const EditedCamera& camera, const Node& frame) const {
    Change change;
    const bool has_list = value_in(frame, kCoefficientList) != nullptr;
    const auto is_new = [&](std::string_view key) {
      if (has_list && is_coefficient(key)) return false;
      const bool missing = is_one_of(in_frames_, key) && must_state(camera, key);
      return value_in(frame, key) == nullptr && (missing || is_one_of(moved_, key));
    };
    const auto add = [&](std::string_view key) {
      if (value_in(frame, key) != nullptr) return change.add(camera.was(key), camera.is(key));
      // instant-ngp reads cx and cy with the size that stands next to them.
      const std::string_view beside = key == "w" ? "cx" : key == "h" ? "cy" : key;
      if (is_new(key) || is_new(beside)) change.add(nullptr, camera.is(key));
    };
    for (const std::string_view key : kFocalAndCentre) add(key);
    for (const std::string_view key : kSize) add(key);
    if (has_list || is_one_of(moved_, kCoefficientList)) {
      const Field before = coefficient_list(camera.old);
      const Field after = coefficient_list(camera.now);
      change.add(has_list ? &before : nullptr, &after);
    }
    for (const std::string_view key : kCoefficients) add(key);
    for (const AngleKey& key : kAngles) {
      if (value_in(frame, key.name) != nullptr) add_angle(key, camera, change);
    }
    // instant-ngp looks for it next to the coefficients.
    const Field flag = fields::scalar(std::string(kIsFisheye), "true");
    if (value_in(frame, kIsFisheye) != nullptr) {
      add_flag(change);
    } else if (is_fisheye(camera.now) && std::ranges::any_of(kCoefficients, is_new)) {
      change.add(nullptr, &flag);
    }
    return change;
  }

  /// Derived numbers follow, whoever reads them.
  static void add_angle(const AngleKey& key, const EditedCamera& camera, Change& change) {
    if (camera.same_angle(key.horizontal) || !camera.old.image_size || !camera.now.image_size) return;
    const auto field = [&key](const Camera& of) {
      const int side = key.horizontal ? of.image_size->width : of.image_size->height;
      const ParameterId id = key.horizontal ? ParameterId("fx") : ParameterId("fy");
      return fields::real(std::string(key.name), angle_of(key, value_of(of, id), side));
    };
    const Field before = field(camera.old);
    const Field after = field(camera.now);
    change.add(&before, &after);
  }

  void change_angles() {
    for (const AngleKey& key : kAngles) {
      if (value_in(root_, key.name) != nullptr && same(key.horizontal ? "fl_x" : "fl_y") && same(key.horizontal ? "w" : "h"))
        add_angle(key, cameras_.front(), top_);
    }
  }

  void add_flag(Change& change) const {
    const auto flag = [](const Camera& camera) {
      return fields::scalar(std::string(kIsFisheye), is_fisheye(camera) ? "true" : "false");
    };
    const Field before = flag(cameras_.front().old);
    const Field after = flag(cameras_.front().now);
    change.add(&before, &after);
  }

  /// The lens's names.
  void change_kind() {
    const Camera& old = cameras_.front().old;
    const Camera& now = cameras_.front().now;
    const bool other_kind = is_fisheye(old) != is_fisheye(now);
    const Node* name = value_in(root_, kCameraModel);
    if (name != nullptr || other_kind) {
      const std::string there = name != nullptr ? name->value : "";
      const Field before = fields::quoted(std::string(kCameraModel), there);
      const auto straight_last = std::ranges::find_if(
          cameras_, [](const EditedCamera& camera) { return model_info(camera.now.model).id != "pinhole"; });
      const Camera& widest = straight_last != cameras_.end() ? straight_last->now : now;
      const bool stays = there.empty() ? false : old.model.index() == now.model.index();
      const Field after = stays ? before : fields::quoted(std::string(kCameraModel), camera_model_for(there, widest.model));
      top_.add(name != nullptr ? &before : nullptr, &after);
    }
    const bool in_frames = is_in_frames(kIsFisheye);
    if (value_in(root_, kIsFisheye) != nullptr || (other_kind && !in_frames)) add_flag(top_);
  }

  text::Document document_;
  const Node& root_;
  std::vector<EditedCamera> cameras_;
  Change top_;
  std::vector<std::string_view> moved_;      ///< From the top to the frames.
  std::vector<std::string_view> in_frames_;  ///< In frames all along.
};

}  // namespace

text::Document edited(const text::Document& base, const Rig& old, const Rig& rig) {
  return Editor(base, groups_of(base.root()), old, rig).run();
}

}  // namespace fca::nerfstudio
