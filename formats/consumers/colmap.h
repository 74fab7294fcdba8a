// SPDX-License-Identifier: BSD-3-Clause
// Private: what COLMAP's readers share.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fca/formats/consumers/consumer.h"

namespace fca::consumers::colmap {

/// A camera model of COLMAP's.
struct Model {
  std::string_view name;
  std::size_t focal_lengths = 0;
  std::size_t coefficients = 0;
  /// A point of the image plane before the focal lengths; `c`: the coefficients. Null: EUCM, and what is not computed here.
  std::array<double, 2> (*bend)(const std::vector<double>& c, double u, double v) = nullptr;
  std::string_view since = {};

  [[nodiscard]] constexpr std::size_t parameters() const { return focal_lengths + 2 + coefficients; }
};

/// By their numbers.
[[nodiscard]] std::span<const Model> all_models();
/// Null if there is none of that name.
[[nodiscard]] const Model* find_model(std::string_view name);

/// A camera with that lens, as it projects. `params`: as many as the model has.
[[nodiscard]] ConsumerCamera seen_camera(std::string name, const Model& model, const std::vector<double>& params);

/// Little endian.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  /// A number of that many bytes; 0, and is_short(), where there are not so many.
  std::uint64_t number(std::size_t size) {
    std::uint64_t value = 0;
    short_ = short_ || bytes_.size() < size;
    if (short_) return 0;
    for (std::size_t i = size; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes_[i]);
    bytes_.remove_prefix(size);
    return value;
  }
  double real() { return std::bit_cast<double>(number(sizeof(double))); }
  [[nodiscard]] bool is_short() const { return short_; }
  [[nodiscard]] bool is_at_end() const { return !short_ && bytes_.empty(); }

 private:
  std::string_view bytes_;
  bool short_ = false;
};

/// Changes a camera as COLMAP reads it into what another program reads. `params`: of its line.
using OwnReading = std::function<void(const Model& model, const std::vector<double>& params, ConsumerCamera& camera)>;

/// COLMAP's reading of a file; with `own` that of a program which reads cameras otherwise.
[[nodiscard]] ConsumerView load(std::string_view bytes, const OwnReading& own = {});

/// ReadRigsText and ReadRigsBinary. Sensors are called as there: "CAMERA 2".
void read_rigs(std::string_view bytes, ConsumerView& view);
/// True if it takes all bytes.
bool read_binary_rigs(std::string_view bytes, ConsumerView& view);
/// ReadRigConfig.
void read_rig_config(std::string_view bytes, ConsumerView& view);

}  // namespace fca::consumers::colmap
