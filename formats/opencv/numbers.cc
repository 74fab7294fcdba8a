// SPDX-License-Identifier: BSD-3-Clause
#include "numbers.h"

#include <fca/code.h>

namespace fca::opencv {

using text::Node;

namespace {

bool is_float_type(const Node& type, const std::string& what, fields::Reader& reader) {
  if (type.value == "d" || type.value == "f") return true;
  if (type.value.ends_with('i') || type.value.ends_with('u') || type.value.ends_with('s') || type.value.ends_with('w')) {
    reader.say(type, Code::kOpencvMatrixOfIntegers, {what, type.value});
  } else {
    reader.say(type, Code::kOpencvMatrixType, {what, type.value});
  }
  return false;
}

/// cv::FileStorage's way to write an empty matrix.
bool is_empty(const Node& matrix, const fields::Reader& reader) {
  const Node* rows = reader.find(matrix, "rows");
  const Node* cols = reader.find(matrix, "cols");
  return (rows != nullptr && rows->value == "0") || (cols != nullptr && cols->value == "0");
}

}  // namespace

std::optional<Numbers> read_numbers(const Node& node, const std::string& what, fields::Reader& reader) {
  Numbers result;
  const Node* data = &node;
  if (node.is_mapping()) {
    const Node* type = reader.require(node, "dt", what);
    if (type == nullptr || !is_float_type(*type, what, reader)) return std::nullopt;
    result.is_float = type->value == "f";
    if (is_empty(node, reader)) return result;
    const std::optional<fields::Reader::Matrix> matrix = reader.opencv_matrix(node, what);
    if (!matrix) return std::nullopt;
    result.rows = matrix->rows;
    result.cols = matrix->cols;
    result.values = matrix->values;
    data = reader.find(node, "data");
  } else {
    const std::optional<std::vector<double>> values = reader.reals(node, 0, what);
    if (!values) return std::nullopt;
    result.rows = static_cast<int>(values->size());
    result.cols = 1;
    result.values = *values;
  }
  if (data->is_sequence()) {
    for (const Node& item : data->items) result.nodes.push_back(&item);
  } else {
    result.nodes.push_back(data);
  }
  if (result.is_float) {
    for (double& value : result.values) value = static_cast<float>(value);
  }
  return result;
}

bool set(const Numbers& from, std::size_t place, const std::string& what, ParameterId id, CameraModel& model,
         fields::Reader& reader) {
  if (!reader.parameter(*from.nodes[place], what, id, model)) return false;
  return !from.is_float || set_parameter(model, id, from.values[place]);
}

}  // namespace fca::opencv
