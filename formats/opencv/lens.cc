// SPDX-License-Identifier: BSD-3-Clause
#include "lens.h"

#include "numbers.h"

#include <fca/code.h>
#include <fca/formats/opencv_coefficients.h>

#include <algorithm>
#include <array>
#include <span>

namespace fca::opencv {

using text::Node;

namespace {

class LensReader {
 public:
  LensReader(const Layout& layout, const ReadOptions& options, fields::Reader& reader)
      : layout_(layout), options_(options), reader_(reader) {}

  /// The model with its distortion, the matrix still to be read.
  std::optional<CameraModel> read(const CameraKeys& keys, const Node& map) {
    if (!check_foreign_model(keys, map)) return std::nullopt;
    if (!keys.radial.empty()) return read_matlab_lens(keys, map);
    Numbers D;
    if (!keys.distortion.empty()) {
      const std::string what = label(keys, keys.distortion);
      const Node& node = *reader_.find(map, keys.distortion);
      std::optional<Numbers> read = read_numbers(node, what, reader_);
      if (!read) return std::nullopt;
      if (!read->is_vector()) {
        reader_.say(node, Code::kOpencvNotVector, {what, read->rows, read->cols});
        return std::nullopt;
      }
      D = *std::move(read);
      if (!keys.xi.empty()) return read_omnidir(keys, map, node, D);
      return lens_of(keys, node, D);
    }
    if (!keys.xi.empty()) return read_omnidir(keys, map, *reader_.find(map, keys.xi), D);
    const Node& matrix = *reader_.find(map, keys.matrix);
    const Message missing = {Code::kOpencvNoCoefficients, {label(keys, keys.matrix)}};
    if (fisheye_said(keys).value_or(false)) {
      reader_.say(matrix, Code::kOpencvFisheyeWithout, {missing});
      return std::nullopt;
    }
    reader_.say(matrix, Code::kOpencvReadWithout, {missing});
    warn_if_told_in_vain(matrix, missing);
    return make_model("pinhole");
  }

 private:
  /// A model that OpenCV has no function for must not pass for one of its own.
  bool check_foreign_model(const CameraKeys& keys, const Node& map) {
    const bool own = !keys.model.key.empty();
    const ModelKey& model = own ? keys.model : layout_.model;
    if (!model.foreign || !keys.xi.empty()) return true;
    const Node& node = *reader_.find(own ? map : reader_.document().root(), model.key);
    const std::string what = own ? label(keys, model.key) : model.key;
    if (!options_.opencv_model) {
      reader_.say(node, Code::kOpencvForeignModel, {what, node.value});
      return false;
    }
    reader_.say(node, Code::kOpencvForeignModelAsGiven, {what, node.value, name_of(*options_.opencv_model)});
    return true;
  }

  /// ReadOptions::opencv_model decides what four numbers are; `why`: why there is nothing to decide.
  void warn_if_told_in_vain(const Node& node, const Message& why) {
    if (options_.opencv_model == OpenCvModel::kFisheye) reader_.say(node, Code::kOpencvGivenInVain, {why});
  }

  std::optional<CameraModel> with(std::string_view id, std::span<const ParameterId> parameters, const Numbers& D,
                                  const std::string& what) {
    std::optional<CameraModel> model = make_model(id);
    std::size_t place = 0;
    for (const ParameterId each : parameters) {
      if (place < D.values.size() && !set(D, place++, what, each, *model, reader_)) return std::nullopt;
    }
    return model;
  }

  std::optional<CameraModel> lens_of(const CameraKeys& keys, const Node& node, const Numbers& D) {
    const std::string what = label(keys, keys.distortion);
    const std::size_t count = D.values.size();
    const std::optional<bool> said = fisheye_said(keys);
    const std::span<const ParameterId> of_opencv(kOpenCvCoefficients);
    if (count == 4) {
      const std::optional<bool> fisheye = decide(said, node, what, D);
      if (!fisheye) return std::nullopt;
      if (*fisheye) return with("kb4", kFisheyeCoefficients, D, what);
      return with("radtan", of_opencv.first(4), D, what);
    }
    if (said.value_or(false)) {
      reader_.say(node, Code::kOpencvFisheyeWantsFour, {what, count});
      return std::nullopt;
    }
    warn_if_told_in_vain(node, {Code::kOpencvSomeCoefficients, {what, count}});
    if (count == 0) return make_model("pinhole");
    if (std::ranges::find(kOpenCvCounts, count) == kOpenCvCounts.end()) {
      reader_.say(node, Code::kOpencvCoefficientCount, {what, count});
      return std::nullopt;
    }
    const std::string_view model = model_of_coefficients(D.values);
    const std::size_t used = opencv_count(model);
    return used == 0 ? make_model(model) : with(model, of_opencv.first(used), D, what);
  }

  /// What the file says of a camera's four numbers.
  [[nodiscard]] std::optional<bool> fisheye_said(const CameraKeys& keys) const {
    if (keys.fisheye) return true;
    return keys.model.fisheye ? keys.model.fisheye : layout_.model.fisheye;
  }

  /// Are four numbers cv::fisheye's? Nothing, with an error, where nobody says.
  std::optional<bool> decide(std::optional<bool> said, const Node& node, const std::string& what, const Numbers& D) {
    if (options_.opencv_model) {
      const bool fisheye = options_.opencv_model == OpenCvModel::kFisheye;
      if (said && *said != fisheye) {
        reader_.say(node, Code::kOpencvGivenOtherwise, {what, *said ? "fisheye" : "pinhole", name_of(*options_.opencv_model)});
      }
      return fisheye;
    }
    if (said) return said;
    reader_.say(node, Code::kOpencvAmbiguousModel, {what, D.values[0], D.values[1], D.values[2], D.values[3]});
    return std::nullopt;
  }

  std::optional<CameraModel> read_omnidir(const CameraKeys& keys, const Node& map, const Node& place, const Numbers& D) {
    const Message omnidir = {Code::kOpencvSaysOmnidir, {label(keys, keys.xi)}};
    warn_if_told_in_vain(place, omnidir);
    if (D.values.size() != 4) {
      reader_.say(place, Code::kOpencvOmnidirWantsFour, {omnidir, D.values.size()});
      return std::nullopt;
    }
    const std::string what = label(keys, keys.xi);
    std::optional<CameraModel> model = with("mei", std::span(kOpenCvCoefficients).first(4), D, label(keys, keys.distortion));
    const Node& node = *reader_.find(map, keys.xi);
    if (node.is_scalar()) {
      if (!model || !reader_.parameter(node, what, "xi", *model)) return std::nullopt;
      return model;
    }
    // The 1 x 1 matrix that cv::omnidir::calibrate returns.
    const std::optional<Numbers> xi = read_numbers(node, what, reader_);
    if (!xi || !model) return std::nullopt;
    if (xi->values.size() != 1) {
      reader_.say(node, Code::kOpencvXiNumbers, {what, xi->values.size()});
      return std::nullopt;
    }
    if (!set(*xi, 0, what, "xi", *model, reader_)) return std::nullopt;
    return model;
  }

  std::optional<CameraModel> read_matlab_lens(const CameraKeys& keys, const Node& map) {
    const Node& node = *reader_.find(map, keys.radial);
    warn_if_told_in_vain(node, {Code::kOpencvIsMatlabs, {keys.radial}});
    const std::optional<Numbers> radial = read_numbers(node, keys.radial, reader_);
    if (!radial) return std::nullopt;
    if (radial->values.size() != 2 && radial->values.size() != 3) {
      reader_.say(node, Code::kOpencvRadialNumbers, {keys.radial, radial->values.size()});
      return std::nullopt;
    }
    constexpr std::array<ParameterId, 3> kRadial = {"k1", "k2", "k3"};
    std::optional<CameraModel> model = with("radtan", kRadial, *radial, keys.radial);
    if (!model || keys.tangential.empty()) return model;
    const Node& second = *reader_.find(map, keys.tangential);
    const std::optional<Numbers> tangential = read_numbers(second, keys.tangential, reader_);
    if (!tangential) return std::nullopt;
    if (tangential->values.size() != 2) {
      reader_.say(second, Code::kNumbersWanted, {keys.tangential, tangential->values.size(), 2});
      return std::nullopt;
    }
    if (!set(*tangential, 0, keys.tangential, "p1", *model, reader_) ||
        !set(*tangential, 1, keys.tangential, "p2", *model, reader_))
      return std::nullopt;
    return model;
  }

  const Layout& layout_;
  const ReadOptions& options_;
  fields::Reader& reader_;
};

}  // namespace

std::string_view model_of_coefficients(std::span<const double> D) {
  const auto is_zero = [](double value) { return value == 0.0; };
  const auto all_zero = [&D, is_zero](std::size_t from, std::size_t to) {
    return std::ranges::all_of(D.subspan(from, to - from), is_zero);
  };
  if (D.size() > kRationalCount && !all_zero(kRationalCount, D.size())) return "opencv14";
  if (all_zero(0, std::min(D.size(), kRationalCount))) return "pinhole";
  const bool is_radtan = D.size() <= kRadtanCount || (D.size() > kRationalCount && all_zero(kRadtanCount, kRationalCount));
  return is_radtan ? "radtan" : "rational";
}

std::optional<CameraModel> read_lens(const Layout& layout, const CameraKeys& keys, const Node& map, const ReadOptions& options,
                                     fields::Reader& reader) {
  return LensReader(layout, options, reader).read(keys, map);
}

std::string label(const CameraKeys& keys, std::string_view key) {
  return (keys.map.empty() ? "" : keys.map + " ") + std::string(key);
}

}  // namespace fca::opencv
