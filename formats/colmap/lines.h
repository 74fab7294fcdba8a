// SPDX-License-Identifier: BSD-3-Clause
// The lines of a cameras.txt and the camera models that they name.
#pragma once

#include "../fields.h"

#include <fca/code.h>
#include <fca/formats/text/document.h>
#include <fca/rig/rig.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca::colmap {

/// A camera model of COLMAP's. Its parameters are [f or fx fy] cx cy and coefficients.
struct Model {
  std::string_view name;                           ///< "SIMPLE_RADIAL"
  std::string_view model = {};                     ///< Ours; empty: none.
  bool one_focal_length = false;                   ///< f alone: fx = fy.
  std::span<const ParameterId> coefficients = {};  ///< Further parameters of our model are 0.
  Code why_not = {};                               ///< Why there is none of ours, a clause.

  /// How many it has, if it is one of ours.
  [[nodiscard]] constexpr std::size_t parameters() const { return (one_focal_length ? 3 : 4) + coefficients.size(); }
};

/// Null if COLMAP has none of that name.
[[nodiscard]] const Model* find_model(std::string_view name);
/// The names of the models that fca-io reads.
[[nodiscard]] std::vector<std::string> names_of_read_models();
/// The model that a fresh line names.
[[nodiscard]] const Model* written_model(const CameraModel& model);

/// The camera's parameters as that model's line has them; nothing if it cannot hold them.
[[nodiscard]] std::optional<std::vector<double>> parameters_in(const Model& model, const Camera& camera);

/// "f cx cy k1"
[[nodiscard]] std::string parameter_names(const Model& model);

/// Our parameters that the model's number `index` sets.
[[nodiscard]] std::vector<ParameterId> set_by(const Model& model, std::size_t index);

/// The model that the word names. Null, with an error there, if COLMAP has none or fca-io does not read it.
[[nodiscard]] const Model* read_model(const text::Node& word, fields::Reader& reader);
/// Sets the camera's lens from as many numbers as the model has. False with errors at those that cannot be.
[[nodiscard]] bool read_lens(std::span<const text::Node> numbers, const Model& model, Camera& camera, fields::Reader& reader);

/// From a pixel of COLMAP's to ours, and back: the number that is read as exactly that pixel where there is one.
[[nodiscard]] double from_file(double pixel);
[[nodiscard]] double to_file(double pixel);

/// The words in front of the parameters.
inline constexpr std::size_t kFirstParameter = 4;

/// Is it a line whose words begin with all of these?
[[nodiscard]] bool has_words(const text::Node& line, std::initializer_list<std::string_view> beginnings);
/// The lines of cameras: those that are neither blank nor a comment.
[[nodiscard]] std::vector<const text::Node*> camera_lines(const text::Document& document);

}  // namespace fca::colmap
