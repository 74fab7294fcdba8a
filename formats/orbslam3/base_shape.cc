// SPDX-License-Identifier: BSD-3-Clause
#include "base_shape.h"

#include "layout.h"

#include <fca/formats/text/dialect.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>

namespace fca::orbslam3 {

using fields::Field;
using text::Node;

namespace {

/// How many numbers stand in an opencv-matrix, or in a plain list of them (of rows, even).
std::size_t count_in(const Node& value) {
  if (value.is_scalar()) return 1;
  std::size_t count = 0;
  for (const Node& item : value.items) count += count_in(item);
  return count;
}

constexpr std::size_t kWholeTransform = 16;
constexpr std::size_t kThreeRows = 12;

/// False if there is no room.
bool resize(std::vector<std::string>& tokens, std::size_t count) {
  if (tokens.size() == count) return true;
  const std::array<std::string, 4> last_row = {"0.0", "0.0", "0.0", "1.0"};
  if (tokens.size() == kThreeRows && count == kWholeTransform) {
    tokens.insert(tokens.end(), last_row.begin(), last_row.end());
    return true;
  }
  if (tokens.size() == kWholeTransform && count == kThreeRows) {
    tokens.resize(count);
    return true;
  }
  // Coefficients: those that are not there are 0.
  const auto is_zero = [](const std::string& token) { return text::parse_real(token) == 0.0; };
  if (tokens.size() > count && !std::all_of(tokens.begin() + static_cast<std::ptrdiff_t>(count), tokens.end(), is_zero))
    return false;
  tokens.resize(count, "0.0");
  return true;
}

void shape_as(Field& field, const Node& value) {
  const Node* data = value.is_mapping() ? text::find(value, "data", text::Dialect::kOpenCv) : &value;
  const Node* rows = text::find(value, "rows", text::Dialect::kOpenCv);
  const Node* cols = text::find(value, "cols", text::Dialect::kOpenCv);
  if (data == nullptr || !data->is_sequence()) return;
  // OpenCV reads as many numbers as rows and cols say, or nothing.
  const int stated = rows != nullptr && cols != nullptr
                         ? text::parse_int(rows->value).value_or(0) * text::parse_int(cols->value).value_or(0)
                         : 0;
  if (!resize(field.tokens, stated > 0 ? static_cast<std::size_t>(stated) : count_in(*data))) return;
  const Node* type = text::find(value, "dt", text::Dialect::kOpenCv);
  if (cols != nullptr) field.columns = text::parse_int(cols->value).value_or(field.columns);
  if (type != nullptr) field.element_type = type->value;
}

}  // namespace

std::vector<Field> shaped_as(std::vector<Field> fields, const text::Document& base) {
  for (Field& field : fields) {
    const Node* value = field.shape == fields::Shape::kMatrix ? find_key(base, field.key) : nullptr;
    if (value != nullptr) shape_as(field, *value);
  }
  return fields;
}

}  // namespace fca::orbslam3
