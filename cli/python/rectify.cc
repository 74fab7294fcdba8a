// SPDX-License-Identifier: BSD-3-Clause
#include "made_files.h"
#include "request_words.h"

#include <fca/toolkit/rectify.h>

#include <array>

namespace fca::python {

namespace {

void take_size(const Value& value, RectifyRequest& request) { request.size = size_of(value.as<Size>()); }

void take_view(RectifiedViewChoice view, RectifyRequest& request) {
  if (!std::holds_alternative<std::monostate>(request.view))
    raise_value_error("pinhole and alpha each say how wide the rectified images are; give one of them");
  request.view = view;
}

void take_field(const Value& value, RectifyRequest& request) {
  const auto degrees = value.as<double>();
  constexpr double kHalfTurn = 180.0;
  if (!(degrees > 0.0 && degrees < kHalfTurn)) value.refuse("the full field of view in degrees, more than 0 and less than 180");
  take_view(RectifiedByField{degrees / kDegreesPerRadian}, request);
}

void take_alpha(const Value& value, RectifyRequest& request) {
  const auto alpha = value.as<double>();
  if (!(alpha >= 0.0 && alpha <= 1.0)) value.refuse("a number from 0 to 1");
  take_view(RectifiedByAlpha{alpha}, request);
}

void take_target(const Value& value, RectifyRequest& request) {
  Target target = target_named(value.as<std::string>());
  request.to = target.format;
  request.layout = target.layout;
  request.extension = std::move(target.extension);
  request.made_by = "Python: fca_io.rectify(to='" + value.as<std::string>() + "')";
}

constexpr std::array kKeywords = {
    Keyword<RectifyRequest>{"parts", [](const Value& value, RectifyRequest& request) { take_parts(value, request.inputs); }},
    Keyword<RectifyRequest>{"camera", [](const Value& value, RectifyRequest& request) { take_cameras(value, request.inputs); }},
    Keyword<RectifyRequest>{"max_angle",
                            [](const Value& value, RectifyRequest& request) { take_max_angle(value, request.inputs); }},
    Keyword<RectifyRequest>{"to", &take_target},
    Keyword<RectifyRequest>{"alpha", &take_alpha},
    Keyword<RectifyRequest>{"pinhole", &take_field},
    Keyword<RectifyRequest>{"out_size", &take_size},
    Keyword<RectifyRequest>{"maps", [](const Value& value, RectifyRequest& request) { request.maps = value.as<bool>(); }},
};

RectifyResult rectify_source(const py::object& source, const py::kwargs& keywords) {
  RectifyRequest request;
  request.inputs = inputs_of(source);
  take_keywords(kKeywords, keywords, request);
  Files files;
  RectifyResult result;
  {
    const py::gil_scoped_release released;
    result = rectify(request, files);
  }
  if (result.status != Status::kDone && result.status != Status::kRejected) raise(result.diagnostics, files.sources());
  return result;
}

Array rotation_of_view(const RectifyResult& result, std::size_t view) {
  return rotation_of(result.pair.views.at(view).T_rectified_camera);
}

/// OpenCV's P1 or P2: of points in the first rectified frame, in metres.
Array projection_of(const RectifyResult& result, std::size_t view) {
  const auto& [fx, fy] = result.pair.focal_lengths;
  const auto& [cx, cy] = result.pair.views.at(view).centre;
  std::array P = {fx, 0.0, cx, 0.0, 0.0, fy, cy, 0.0, 0.0, 0.0, 1.0, 0.0};
  constexpr std::size_t kShiftInU = 3;
  constexpr std::size_t kShiftInV = 7;
  if (view == 1) {
    const bool is_vertical = result.pair.is_vertical;
    P.at(is_vertical ? kShiftInV : kShiftInU) = -(is_vertical ? fy : fx) * result.pair.offset_m;
  }
  Array matrix(std::vector<py::ssize_t>{3, 4});
  std::ranges::copy(P, matrix.mutable_data());
  return matrix;
}

std::vector<Camera> rectified_cameras(const RectifyResult& result) {
  return {rectified_camera(result.pair, 0, result.size), rectified_camera(result.pair, 1, result.size)};
}

/// (x, y, width, height), as cv2's validPixROI.
using Region = std::array<int, 4>;

std::vector<std::optional<Region>> valid_regions(const RectifyResult& result) {
  std::vector<std::optional<Region>> regions;
  for (const RectifiedPair::View& view : result.pair.views) {
    regions.emplace_back();
    if (view.valid) regions.back() = {view.valid->x, view.valid->y, view.valid->size.width, view.valid->size.height};
  }
  return regions;
}

/// (u, v) of each image; None where they were not asked for.
std::optional<std::vector<py::tuple>> maps_of(const RectifyResult& result) {
  if (result.maps.empty()) return std::nullopt;
  std::vector<py::tuple> maps;
  for (const ImageMap& map : result.maps) maps.push_back(as_maps(map));
  return maps;
}

void save_into(const RectifyResult& result, const py::object& folder, bool force) {
  if (result.status != Status::kDone) raise_value_error("the program does not understand the settings: nothing is written");
  if (result.files.empty()) raise_value_error("there are no settings: say with to= for which program");
  save_files(result.files, folder, force);
}

void add_disparity(py::module_& module) {
  py::class_<RowDifference>(module, "RowDifference", R"(By how many rows the two images of a point differ after rectification.

Columns, of a vertical pair; over what both rectified images show.)")
      .def_readonly("rms", &RowDifference::rms_px, "Pixels.")
      .def_readonly("max", &RowDifference::max_px, "Pixels; the largest magnitude.")
      .def_readonly("max_at", &RowDifference::max_at, "The pixel (u, v) of the first rectified image where it is.")
      .def_readonly("share", &RowDifference::share, "Of the first rectified image, what both see: 0 to 1.");
  py::class_<VerticalDisparity>(module, "VerticalDisparity", "What is left of the epipolar error after a rectification.")
      .def_readonly("at_infinity", &VerticalDisparity::at_infinity, "RowDifference of points far away.")
      .def_readonly("at_ten_baselines", &VerticalDisparity::at_ten_baselines,
                    "RowDifference of points ten baselines away from the first camera.");
  py::class_<PairError>(module, "PairError", "What stereo feels of a pair that is written otherwise than it is.")
      .def_readonly("first", &PairError::first, "Name of a camera.")
      .def_readonly("second", &PairError::second, "Name of the other one.")
      .def_property_readonly(
          "rms", [](const PairError& each) { return each.rms_px(); },
          "Rows in pixels; the larger of far away and at ten baselines.")
      .def_property_readonly(
          "max", [](const PairError& each) { return each.max_px(); }, "The same at the worst pixel.")
      .def_readonly("disparity", &PairError::disparity, "VerticalDisparity.");
}

}  // namespace

void add_rectify(py::module_& module) {
  add_disparity(module);
  py::class_<RectifyResult>(module, "Rectification", R"(A rectified stereo pair: matches lie in one row.

Where one camera stands above the other they lie in one column. The first view is the left (upper) camera's, whichever the file
has first.)")
      .def_property_readonly(
          "cameras", [](const RectifyResult& each) { return each.cameras; }, "The two as they take images: left, right.")
      .def_property_readonly("rectified_cameras", &rectified_cameras, "The two as rectified images have them: pinhole Cameras.")
      .def_property_readonly(
          "R1", [](const RectifyResult& each) { return rotation_of_view(each, 0); },
          "(3, 3): takes rays of the left camera to rays of its rectified image. As cv2.stereoRectify's.")
      .def_property_readonly(
          "R2", [](const RectifyResult& each) { return rotation_of_view(each, 1); }, "The same of the right camera.")
      .def_property_readonly(
          "P1", [](const RectifyResult& each) { return projection_of(each, 0); },
          "(3, 4): takes points of the left rectified frame, in metres, to pixels of the left rectified image.")
      .def_property_readonly(
          "P2", [](const RectifyResult& each) { return projection_of(each, 1); }, "The same to pixels of the right one.")
      .def_property_readonly(
          "image_size",
          [](const RectifyResult& each) {
            return Size{each.size.width, each.size.height};
          },
          "(width, height) of the rectified images.")
      .def_property_readonly(
          "baseline", [](const RectifyResult& each) { return each.baseline_m(); }, "Metres, positive.")
      .def_property_readonly(
          "bf", [](const RectifyResult& each) { return each.bf(); }, "Baseline times fx, metres times pixels.")
      .def_property_readonly(
          "full_fov", [](const RectifyResult& each) { return each.full_fov_rad * kDegreesPerRadian; },
          "Degrees across the width of the rectified images.")
      .def_property_readonly("valid", &valid_regions,
                             "Of both rectified images the part whose pixels the camera sees: [x, y, width, height], or None.")
      .def_readonly("disparity", &RectifyResult::disparity,
                    "VerticalDisparity: 0 but for rounding unless the files state R and P.")
      .def_property_readonly("maps", &maps_of,
                             "Of both images two float32 arrays (height, width), u and v in the camera's image, as cv2.remap "
                             "takes them; far outside of it where it has none. None unless asked for with maps=True.")
      .def_readonly("stated", &RectifyResult::is_stated, "The files state it; else it was computed.")
      .def_property_readonly(
          "vertical", [](const RectifyResult& each) { return each.pair.is_vertical; }, "One camera stands above the other.")
      .def_readonly("exchanged", &RectifyResult::is_exchanged, "The files' first camera is the right (lower) one.")
      .def_property_readonly(
          "accepted", [](const RectifyResult& each) { return each.status == Status::kDone; },
          "Does the program understand the settings? Else nothing is saved.")
      .def_property_readonly(
          "files", [](const RectifyResult& each) { return bytes_by_name(each.files); },
          "Settings: bytes by name. Empty unless asked for with to=.")
      .def_readonly("losses", &RectifyResult::losses, "What the settings cannot say: a list of Loss.")
      .def_property_readonly(
          "warnings", [](const RectifyResult& each) { return warnings_of(each.diagnostics); }, "Texts.")
      .def("save", &save_into, py::arg("folder"), py::kw_only(), py::arg("force") = false,
           "Writes the settings into a folder, which is made if it is not there. Error where a file exists, unless force is "
           "given.")
      .def("__repr__", [](const RectifyResult& each) {
        return "<fca_io.Rectification of " + each.cameras[0].name + " and " + each.cameras[1].name + ">";
      });
  module.def("rectify", &rectify_source, py::arg("source"), R"(Rectifies a stereo pair, as the command does.

Takes what the files state, else computes it: R1, R2 and one camera for both as cv2.stereoRectify makes them, for every camera
model. Returns a Rectification. All but the first are keywords, and are called as the command's options:

source              a path, or a Rig of read(); of more than two cameras those that have most in common
parts               paths of further files of the same calibration: ['imu.yaml']
camera              these two: names, or places from 0
max_angle           what counts as lens in maps, degrees from the axis; the whole image
to                  settings for: 'orbslam3', 'orbslam2', 'ros' or 'opencv'
alpha               as OpenCV's: 0: only what the cameras see; 1: all that they see
pinhole             in its place the full field of view across the width, degrees, up to 120
out_size            (width, height) of the rectified images; the cameras'
maps                True: also compute the maps

    left, right = fca_io.rectify(rig, maps=True).maps
    cv2.remap(image, *left, cv2.INTER_LINEAR)

Raises Error (with code, file, line, column) where there is no such pair, ValueError and TypeError of requests that cannot be.)");
}

}  // namespace fca::python
