// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rectify/rectify.h>

#include <fca/rig/rotation.h>

#include <array>

namespace fca {

namespace {

/// Does the camera see a pixel of a rectified image?
class Seen {
 public:
  Seen(const Camera& camera, const RectifiedPair& pair, std::size_t view)
      : camera_(camera),
        focal_lengths_(pair.focal_lengths),
        centre_(pair.views.at(view).centre),
        T_camera_rectified_(*inverse(pair.views.at(view).T_rectified_camera)) {}

  bool operator()(int u, int v) const {
    const Ray ray = {(u - centre_[0]) / focal_lengths_[0], (v - centre_[1]) / focal_lengths_[1], 1.0};
    const std::optional<Pixel> pixel = project(camera_.model, rotated(T_camera_rectified_, ray));
    if (!pixel || !camera_.image_size->holds(*pixel)) return false;
    return !camera_.lens_circle || camera_.lens_circle->contains(*pixel);
  }

 private:
  const Camera& camera_;
  std::array<double, 2> focal_lengths_;
  Pixel centre_;
  Transform T_camera_rectified_;
};

/// A rectangle that shrinks, and how many pixels of each border are not seen: left, top, right, bottom.
class Shrinking {
 public:
  Shrinking(const Seen& seen, const ImageSize& size) : seen_(seen), ends_{0, 0, size.width - 1, size.height - 1} {
    for (std::size_t border = 0; border < 4; ++border) missing_.at(border) = count(border);
  }

  [[nodiscard]] bool is_empty() const { return ends_[0] > ends_[2] || ends_[1] > ends_[3]; }
  [[nodiscard]] ImageRegion region() const { return {ends_[0], ends_[1], {ends_[2] - ends_[0] + 1, ends_[3] - ends_[1] + 1}}; }
  /// That of which most is not seen, as a share; nothing where all of each is.
  [[nodiscard]] std::optional<std::size_t> worst() const {
    const auto share = [this](std::size_t border) { return static_cast<double>(missing_.at(border)) / length(border); };
    std::size_t worst = 0;
    for (std::size_t border = 1; border < 4; ++border) {
      if (share(border) > share(worst)) worst = border;
    }
    return missing_.at(worst) > 0 ? std::optional(worst) : std::nullopt;
  }
  void shrink(std::size_t border) {
    for (const std::size_t beside : {(border + 1) % 4, (border + 3) % 4}) missing_.at(beside) -= sees(border, beside) ? 0 : 1;
    ends_.at(border) += border < 2 ? 1 : -1;
    if (!is_empty()) missing_.at(border) = count(border);
  }

 private:
  [[nodiscard]] int length(std::size_t border) const { return ends_.at(2 + (border + 1) % 2) - ends_.at((border + 1) % 2) + 1; }
  /// The corner of two borders.
  [[nodiscard]] bool sees(std::size_t border, std::size_t beside) const {
    return border % 2 == 0 ? seen_(ends_.at(border), ends_.at(beside)) : seen_(ends_.at(beside), ends_.at(border));
  }
  [[nodiscard]] int count(std::size_t border) const {
    const std::size_t along = (border + 1) % 2;
    int missing = 0;
    for (int i = ends_.at(along); i <= ends_.at(along + 2); ++i) {
      const bool sees = border % 2 == 0 ? seen_(ends_.at(border), i) : seen_(i, ends_.at(border));
      missing += sees ? 0 : 1;
    }
    return missing;
  }

  const Seen& seen_;
  std::array<int, 4> ends_;
  std::array<int, 4> missing_{};
};

}  // namespace

std::optional<ImageRegion> valid_region(const Camera& camera, const RectifiedPair& pair, std::size_t view,
                                        const ImageSize& size) {
  if (!camera.image_size || !inverse(pair.views.at(view).T_rectified_camera)) return std::nullopt;
  const Seen seen(camera, pair, view);
  Shrinking part(seen, size);
  while (!part.is_empty()) {
    const std::optional<std::size_t> border = part.worst();
    if (!border) return part.region();
    part.shrink(*border);
  }
  return std::nullopt;
}

}  // namespace fca
