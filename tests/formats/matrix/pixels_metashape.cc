// SPDX-License-Identifier: BSD-3-Clause
// Metashape's exported lens by the formulas of its manual (appendix "Camera models"): offsets from the middle of the image,
// whose corner is (0, 0); p1 multiplies r^2 + 2 x^2.
#include "pixels_metashape.h"

#include "opencv_lens.h"

#include <tinyxml2.h>

namespace fca::matrix::metashape {

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  tinyxml2::XMLDocument document;
  if (index > 0 || document.Parse(bytes.c_str(), bytes.size()) != tinyxml2::XML_SUCCESS) return std::nullopt;
  const tinyxml2::XMLElement* root = document.RootElement();
  const auto number = [root](const char* key) {
    const tinyxml2::XMLElement* element = root->FirstChildElement(key);
    return element != nullptr ? std::stod(element->GetText()) : 0.0;
  };
  const std::string type = root->FirstChildElement("projection")->GetText();
  const RayToPixel lens = type == "frame" ? pinhole({number("k1"), number("k2"), number("p2"), number("p1"), number("k3")})
                                          : fisheye({number("k1"), number("k2"), number("k3"), number("k4")});
  PixelFormula formula;
  formula.size = Size{static_cast<int>(number("width")), static_cast<int>(number("height"))};
  const RayToPixel straight =
      in_image(lens, number("f") + number("b1"), number("f"), formula.size->width / 2.0 + number("cx") - 0.5,
               formula.size->height / 2.0 + number("cy") - 0.5);
  formula.pixel = [lens, straight, b2 = number("b2")](const Ray& ray) -> std::optional<Pixel> {
    const std::optional<Pixel> bent = lens(ray);
    const std::optional<Pixel> pixel = straight(ray);
    return bent && pixel ? std::optional(Pixel{(*pixel)[0] + b2 * (*bent)[1], (*pixel)[1]}) : std::nullopt;
  };
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& /*files*/) { return {}; }

}  // namespace fca::matrix::metashape
