// SPDX-License-Identifier: BSD-3-Clause
// A transforms.json, for the programs that read one.
#pragma once

#include <fca/formats/consumers/consumer.h>
#include <rapidjson/document.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::consumers {

/// The first image of a camera.
struct NerfCamera {
  std::string name;  ///< As fca names it: frames with the same numbers are of one camera.
  const rapidjson::Value* frame = nullptr;
  std::size_t index = 0;  ///< Of the frame.
};

class NerfFile {
 public:
  using Json = rapidjson::Value;

  /// Refuses what is no object with a list of images. `of_nlohmann`: its parser skips comments; else Python's, which reads NaN.
  NerfFile(std::string_view bytes, bool of_nlohmann, ConsumerView& view);

  void refuse(Code code, std::vector<Argument> arguments = {}, const std::string& key = "");
  void warn(Code code, std::vector<Argument> arguments = {}, const std::string& key = "");

  [[nodiscard]] bool loads() const { return view_.loads(); }
  [[nodiscard]] const Json& root() const { return document_; }
  [[nodiscard]] const Json& frames() const;
  /// One for each camera.
  [[nodiscard]] std::vector<NerfCamera> cameras() const;

  /// The last of equal keys; null if there is none.
  [[nodiscard]] static const Json* find(const Json& object, std::string_view key);
  /// A number; nothing where there is none, and a refusal where something else stands there.
  std::optional<double> number(const Json& object, std::string_view key);
  /// The same as Python's float() has it, which reads a text, too.
  std::optional<double> number_or_text(const Json& object, std::string_view key);
  /// The numbers of distortion_params; nothing where it is not there, and a refusal where it is no list of at least six
  /// numbers.
  std::optional<std::vector<double>> coefficient_list(const Json& object);
  /// Where an object has distortion_params: true, with a warning that the program does not read them, if one is not 0 and no
  /// coefficient stands next to the list.
  bool warn_of_list(const Json& object);
  /// True or false; false where nothing stands there, and a refusal where something else does.
  bool flag(const Json& object, std::string_view key);
  /// Is it nerfstudio's OPENCV_FISHEYE?
  [[nodiscard]] bool is_named_fisheye() const;
  /// Every frame has an image and a pose of at least so many rows of four numbers; else a refusal.
  void check_frames(std::size_t rows);

 private:
  void check_document();

  ConsumerView& view_;
  rapidjson::Document document_;
};

/// The ray's direction (x right, y down, z forward) to a pixel of the file; nothing if it has none.
using NerfProjection = std::function<std::optional<std::array<double, 2>>(const std::array<double, 3>& ray)>;

/// A camera whose pixels begin at 0.5, as those of transforms.json do.
[[nodiscard]] ConsumerCamera nerf_camera(const NerfCamera& camera, double width, double height, std::string_view model,
                                         NerfProjection project);

/// x, y of a point in front of the camera on the plane at distance 1; nothing behind it.
[[nodiscard]] std::optional<std::array<double, 2>> nerf_plane(const std::array<double, 3>& ray);

}  // namespace fca::consumers
