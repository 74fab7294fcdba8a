// SPDX-License-Identifier: BSD-3-Clause
#include "convert_request.h"
#include "made_files.h"

#include <fca/formats/text/message.h>
#include <fca/formats/wording.h>

#include <algorithm>
#include <memory>

namespace fca::python {

namespace {

/// The disk, and the image of weights that the request holds.
class FilesAndWeights : public Files {
 public:
  explicit FilesAndWeights(std::optional<Image> weights) : weights_(std::move(weights)) {}
  std::optional<Image> read_image(const std::string& path, Diagnostics& diagnostics) override {
    return weights_ ? weights_ : Files::read_image(path, diagnostics);
  }

 private:
  std::optional<Image> weights_;
};

ConvertResult convert_source(const py::object& source, const std::string& to, const py::kwargs& keywords) {
  AskedConversion asked = asked_conversion(source, to, keywords);
  FilesAndWeights files(std::move(asked.weights));
  ConvertResult result;
  {
    const py::gil_scoped_release released;
    result = convert(asked.request, files);
  }
  if (result.status != Status::kDone && result.status != Status::kRejected) raise(result.diagnostics, files.sources());
  return result;
}

/// Nothing is written of a file that is not to be used.
void save_into(const ConvertResult& result, const py::object& folder, bool force) {
  if (result.status != Status::kDone) {
    const std::vector<Reason>& reasons = result.verdict.reasons;
    raise_value_error("the verdict is " + std::string(name_of(result.verdict.word)) + ": nothing is written" +
                      (reasons.empty() ? "" : "; " + message_of(reasons.front())));
  }
  save_files(result.files, folder, force);
}

std::optional<ErrorSummary> error_of(const ConvertedCamera& camera) {
  return camera.report ? std::optional(camera.report->statistics.error) : std::nullopt;
}

/// Of a camera's pixels and, where its correlations are known, of the written parameters.
struct CameraUncertainty {
  PixelUncertainty of_pixels;
  CameraModel written;
};

std::optional<CameraUncertainty> uncertainty_of(const ConvertedCamera& camera) {
  if (!camera.report || !camera.report->uncertainty) return std::nullopt;
  return CameraUncertainty{*camera.report->uncertainty, camera.target.model};
}

/// By the written parameters' names.
std::optional<py::dict> sigmas_of(const CameraUncertainty& uncertainty) {
  const std::vector<double>& sigmas = uncertainty.of_pixels.sigmas;
  if (sigmas.empty()) return std::nullopt;
  py::dict by_name;
  for (std::size_t i = 0; i < sigmas.size(); ++i)
    by_name[py::str(std::string(model_info(uncertainty.written).parameters[i].name))] = sigmas[i];
  return by_name;
}

std::optional<Array> covariance_of(const CameraUncertainty& uncertainty) {
  const std::vector<double>& values = uncertainty.of_pixels.covariance;
  if (values.empty()) return std::nullopt;
  const auto side = static_cast<py::ssize_t>(uncertainty.of_pixels.sigmas.size());
  Array matrix(std::vector<py::ssize_t>{side, side});
  std::ranges::copy(values, matrix.mutable_data());
  return matrix;
}

std::optional<Array> turn_of(const ConvertedCamera& camera) {
  if (!camera.report || !camera.report->turn) return std::nullopt;
  return rotation_of(camera.report->turn->T_target_source);
}

std::string name_of_verdict(const ConvertResult& result) { return std::string(name_of(result.verdict.word)); }

void add_camera_classes(py::module_& module) {
  py::class_<CameraUncertainty>(module, "Uncertainty", R"(The calibration's own uncertainty, over the scored part of the image.

One standard deviation of a pixel, along the direction in which it is largest.)")
      .def_property_readonly(
          "rms", [](const CameraUncertainty& each) { return each.of_pixels.rms_px; }, "Pixels.")
      .def_property_readonly(
          "max", [](const CameraUncertainty& each) { return each.of_pixels.max_px; }, "Pixels.")
      .def_property_readonly(
          "max_at", [](const CameraUncertainty& each) { return each.of_pixels.max_at; }, "The source's pixel (u, v).")
      .def_property_readonly(
          "correlations_known", [](const CameraUncertainty& each) { return !each.of_pixels.is_limit; },
          "False: rms and max are no more than upper limits, and there is neither sigmas nor covariance.")
      .def_property_readonly(
          "error_sigmas",
          [](const CameraUncertainty& each) {
            return each.of_pixels.is_limit ? std::nullopt : std::optional(each.of_pixels.most_sigmas);
          },
          "The largest ratio of the conversion's error to the uncertainty there; None without correlations.")
      .def_property_readonly(
          "source", [](const CameraUncertainty& each) { return each.of_pixels.source; },
          "The file that contains it; empty: the residuals of a fit to measured rays.")
      .def_property_readonly("sigmas", &sigmas_of,
                             "One standard deviation of each written parameter, by name, in its unit; None: not known.")
      .def_property_readonly("covariance", &covariance_of, "Of the written parameters (n, n), in the order of sigmas.");
  py::class_<ConvertedCamera>(module, "ConvertedCamera", "One camera before and after.")
      .def_property_readonly(
          "name", [](const ConvertedCamera& camera) { return camera.source.name; }, "As the input has it.")
      .def_readonly("source", &ConvertedCamera::source, "Camera of the input.")
      .def_readonly("target", &ConvertedCamera::target, "Camera that is written.")
      .def_property_readonly("error", &error_of, "PixelError of the fit over the image; None where nothing was computed.")
      .def_property_readonly(
          "exact", [](const ConvertedCamera& camera) { return camera.report ? camera.report->exact : true; },
          "The same pixels by construction: nothing was fitted.")
      .def_property_readonly("turn", &turn_of,
                             "Of absorb_rotation and pair: R (3, 3), takes rays of the source to rays of the target; or None.")
      .def_property_readonly("uncertainty", &uncertainty_of, "Uncertainty, where the input's files contain one; else None.");
}

}  // namespace

void add_convert(py::module_& module) {
  py::class_<Reason>(module, "Reason", "Why a file is less than ready.")
      .def_property_readonly(
          "code", [](const Reason& reason) { return id_of(reason); }, "'pixels-off', ...")
      .def_property_readonly(
          "verdict", [](const Reason& reason) { return std::string(name_of(reason.word)); },
          "The verdict that it leads to: 'use-with-care' or 'do-not-use'.")
      .def_readonly("camera", &Reason::camera, "Empty: it is about the whole file.")
      .def_property_readonly(
          "text", [](const Reason& reason) { return message_of(reason); }, "What is wrong.")
      .def_property_readonly(
          "fix", [](const Reason& reason) { return fix_of(reason); }, "What to do; may be empty.")
      .def("__repr__",
           [](const Reason& reason) { return "<fca_io.Reason " + id_of(reason) + ": " + message_of(reason) + ">"; });
  add_loss(module);
  add_camera_classes(module);
  py::class_<ConvertResult>(module, "Conversion", "Files that were made, and whether to use them. Nothing is on the disk yet.")
      .def_property_readonly("verdict", &name_of_verdict, "'ready', 'use-with-care' or 'do-not-use'")
      .def_property_readonly(
          "reasons", [](const ConvertResult& each) { return each.verdict.reasons; },
          "Why it is less than ready: a list of Reason.")
      .def_property_readonly(
          "headline", [](const ConvertResult& each) { return text::text_of(each.headline); }, "For which program and mode.")
      .def_property_readonly(
          "files", [](const ConvertResult& each) { return bytes_by_name(each.files); }, "Bytes by name.")
      .def_property_readonly(
          "cameras", [](const ConvertResult& each) { return each.cameras; }, "A list of ConvertedCamera.")
      .def_property_readonly(
          "pair", [](const ConvertResult& each) { return each.pair; },
          "PairError of the stereo pair among the written cameras; None where there is none.")
      .def_property_readonly(
          "losses", [](const ConvertResult& each) { return each.losses; }, "What the files cannot say: a list of Loss.")
      .def("save", &save_into, py::arg("folder"), py::kw_only(), py::arg("force") = false,
           "Writes the files into a folder, which is made if it is not there. ValueError where the verdict is 'do-not-use'; "
           "Error where a file exists, unless force is given.")
      .def("__repr__", [](const ConvertResult& each) {
        return "<fca_io.Conversion to " + std::string(each.to->id) + ": " + name_of_verdict(each) + ">";
      });
  module.def("convert", &convert_source, py::arg("source"), py::arg("to"), R"(Converts a calibration, as the command does.

Returns a Conversion: its verdict is what the command says, its files are bytes. All but the first two are keywords, and are
called as the command's options:

source              a path, or a Rig of read()
to                  a format or a program: 'orbslam3', 'vins-fusion'
parts               paths of further files of the same calibration: ['imu.yaml']
camera              these cameras alone, in this order: names, or places from 0
model               the camera model to write; kept, else the best that the program reads
max_angle           what counts as lens, degrees from the axis; the whole image
sensor, layout      of formats that have them: 'stereo-inertial', 'v1'
into                path of a file whose text is edited; a fresh file
rewrite             True: a fresh file even where the input's own text could be edited
objective           what a fit makes small: 'rms', or 'max', the error of the worst pixel
weight              what counts how much in the rms: 'pixel', 'angle' (directions alike), or an image uint8 (height, width):
                    pixels by its grey
degree              of ocamcalib's polynomial; the lowest that is nearly as good as any
fix                 parameters that a fit leaves alone: {'k3': 0.0, 'cx': None, 'fx': 'fy'}; None: as in the input
absorb_rotation     True: a turn of each camera is fitted, too, and written into its poses
pair                True: a stereo pair is fitted together, to the rows in which matches lie
every_pixel         True: errors are those of every pixel, not of a lattice of about 5,000 points
fps, baseline       Hz; metres: for formats that have them
set                 values of the written file that no calibration contains: {'Viewer.PointSize': 3.0}
accept              codes of reasons that do not stop it: ['pixels-off:cam1']
strict              True: nothing that the target's program uses may be lost
max_error           pixels: more is 'do-not-use'
max_error_sigmas    the same in standard deviations of the calibration's own pixels

Raises Error (with code, file, line, column) where a file cannot be read or converted, ValueError and TypeError of requests that
cannot be.)");
}

}  // namespace fca::python
