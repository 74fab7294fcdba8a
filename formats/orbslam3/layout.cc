// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"

#include <fca/formats/text/dialect.h>

#include <algorithm>

namespace fca::orbslam3 {

const std::vector<Layout>& layouts() {
  static const std::vector<Layout> kLayouts = [] {
    const std::vector<Slot> pinhole = {{"fx", "fx"}, {"fy", "fy"}, {"cx", "cx"}, {"cy", "cy"}};
    const auto with = [&pinhole](std::vector<Slot> lens) {
      std::vector<Slot> slots = pinhole;
      slots.insert(slots.end(), lens.begin(), lens.end());
      return slots;
    };
    const std::vector<Slot> radtan = with({{"k1", "k1"}, {"k2", "k2"}, {"p1", "p1"}, {"p2", "p2"}, {"k3", "k3", false}});
    const std::vector<Slot> radtan_or_zero =
        with({{"k1", "k1", false}, {"k2", "k2", false}, {"p1", "p1", false}, {"p2", "p2", false}, {"k3", "k3", false}});
    const std::vector<Slot> kb4 = with({{"k1", "k1"}, {"k2", "k2"}, {"k3", "k3"}, {"k4", "k4"}});
    const std::vector<Slot> kb4_in_radtan_keys = with({{"k1", "k1"}, {"k2", "k2"}, {"p1", "k3"}, {"p2", "k4"}});
    const std::vector<Slot> eucm = with({{"k1", "alpha"}, {"k2", "beta"}, {"p1", std::nullopt}, {"p2", std::nullopt}});
    const std::vector<Slot> ds = with({{"xi", "xi"}, {"alpha", "alpha"}});
    return std::vector<Layout>{
        {Style::kV1, "PinHole", "radtan", radtan},
        {Style::kV1, "PinHole", "pinhole", pinhole},
        {Style::kV1, "Rectified", "pinhole", pinhole},
        {Style::kV1, "KannalaBrandt8", "kb4", kb4},
        {Style::kOld, "PinHole", "radtan", radtan_or_zero},
        {Style::kOld, "PinHole", "pinhole",
         with({{"k1", std::nullopt}, {"k2", std::nullopt}, {"p1", std::nullopt}, {"p2", std::nullopt}})},
        {Style::kOld, "KannalaBrandt8", "kb4", kb4},
        {Style::kOld, "DoubleSphere", "ds", ds},
        {Style::kOrbSlam2, "", "radtan", radtan_or_zero},
        {Style::kOrbSlam2, "", "pinhole",
         with({{"k1", std::nullopt}, {"k2", std::nullopt}, {"p1", std::nullopt}, {"p2", std::nullopt}})},
        {Style::kSlamNoOpt, "EUCM", "eucm", eucm},
        {Style::kSlamNoOpt, "KB", "kb4", kb4_in_radtan_keys},
        {Style::kSlamNoOpt, "KannalaBrandt8", "kb4", kb4_in_radtan_keys},
    };
  }();
  return kLayouts;
}

bool is_fisheye(const Layout& layout) { return layout.type == "KannalaBrandt8" || layout.type == "DoubleSphere"; }

const Layout* find_layout(Style style, std::string_view model) {
  const auto& rows = layouts();
  const auto found = std::ranges::find_if(rows, [&](const Layout& l) { return l.style == style && l.model == model; });
  return found == rows.end() ? nullptr : &*found;
}

const text::Node* find_key(const text::Document& document, std::string_view key) {
  return text::find(document.root(), key, text::Dialect::kOpenCv);
}

Style style_of(const text::Document& document) {
  if (find_key(document, "Camera1.fx") != nullptr || find_key(document, "Camera1.fy") != nullptr) return Style::kV1;
  const text::Node* version = find_key(document, "File.version");
  if (version != nullptr && version->quoted && version->value == "1.0") return Style::kV1;
  const text::Node* type = find_key(document, "Camera.type");
  if (type == nullptr) return Style::kOrbSlam2;
  if (type->value == "EUCM" || type->value == "KB") return Style::kSlamNoOpt;
  // slam_no_opt's own files also say KannalaBrandt8 with k3, k4 in p1, p2.
  const bool without_k3 = find_key(document, "Camera.k3") == nullptr && find_key(document, "Camera.p1") != nullptr;
  return type->value == "KannalaBrandt8" && without_k3 ? Style::kSlamNoOpt : Style::kOld;
}

std::string_view camera_prefix(Style style, std::size_t index) {
  if (index == 1) return "Camera2.";
  return style == Style::kV1 ? "Camera1." : "Camera.";
}

PoseKeys pose_keys(Style style) {
  switch (style) {
    case Style::kV1:
      return {"Stereo.T_c1_c2", "IMU.T_b_c1"};
    case Style::kOld:
    case Style::kOrbSlam2:
      return {"Tlr", "Tbc"};
    case Style::kSlamNoOpt:
      return {"", "Camera.Tbc"};
  }
  return {};
}

std::string_view imu_pose_key(const text::Document& document) {
  const Style style = style_of(document);
  const std::string_view key = pose_keys(style).T_imu_c1;
  if (find_key(document, key) != nullptr) return key;
  // slam_no_opt's files without a type
  constexpr std::string_view kForks = "Camera.Tbc";
  return style == Style::kOrbSlam2 && find_key(document, kForks) != nullptr ? kForks : std::string_view();
}

}  // namespace fca::orbslam3
