// SPDX-License-Identifier: BSD-3-Clause
// COLMAP: cameras and rigs of a model folder, as text or binary, and rig_config.json. Cameras from colmap/colmap@5d968cf
// (4.2.0.dev0, 2026-08-08), src/colmap/scene/ reconstruction_io_text.cc (ReadCamerasText) and reconstruction_io_binary.cc
// (ReadCamerasBinary). Version 3.8 splits at single blanks and knows the models up to THIN_PRISM_FISHEYE.
#include "colmap.h"

#include <array>
#include <cstdint>
#include <limits>
#include <locale>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "fca/code.h"
#include "programs.h"

namespace fca::consumers {
namespace {

constexpr std::size_t kMaxBytes = 2U << 20U;

using colmap::Bytes;
using colmap::Model;
using colmap::OwnReading;

class Reader {
 public:
  Reader(const OwnReading& own, ConsumerView& view) : own_(own), view_(view) {}

  /// ReadCamerasBinary. True if it takes all bytes.
  bool run_binary(std::string_view bytes) {
    Bytes stream(bytes);
    const std::uint64_t count = stream.number(8);
    for (std::uint64_t i = 1; view_.loads() && i <= count; ++i) {
      const auto id = static_cast<std::uint32_t>(stream.number(4));
      const auto number = static_cast<std::int32_t>(stream.number(4));
      const std::uint64_t width = stream.number(8);
      const std::uint64_t height = stream.number(8);
      if (stream.is_short() || width > kLargest || height > kLargest) {
        refuse(Code::kColmapSaysEnds, {i});
        break;
      }
      if (number < 0 || static_cast<std::size_t>(number) >= colmap::all_models().size()) {
        refuse(Code::kColmapSaysModelNumber, {i, number});
        break;
      }
      const Model& model = colmap::all_models()[static_cast<std::size_t>(number)];
      std::vector<double> params(model.parameters());
      for (double& value : params) value = stream.real();
      if (stream.is_short()) {
        refuse(Code::kColmapSaysEnds, {i});
        break;
      }
      add(model, params, id, {width, height}, static_cast<int>(i));
    }
    if (view_.loads() && view_.cameras.empty()) refuse(Code::kColmapSaysNoCamera, {});
    return view_.loads() && stream.is_at_end();
  }

  void run(std::string_view bytes) {
    std::istringstream lines{std::string(bytes)};
    int number = 0;
    for (std::string line; view_.loads() && std::getline(lines, line);) {
      ++number;
      constexpr std::string_view kBlanks = " \t\r\v\f";
      const std::size_t first = line.find_first_not_of(kBlanks);
      if (first != std::string::npos && line[first] != '#') read_line(line, number);
    }
    if (view_.loads() && view_.cameras.empty()) refuse(Code::kColmapSaysNoCamera, {});
  }

 private:
  static constexpr std::uint64_t kLargest = std::numeric_limits<int>::max();

  void refuse(Code code, std::vector<Argument> arguments) {
    view_.refusals.emplace_back(code, "", std::move(arguments));
    view_.cameras.clear();
  }

  void read_line(const std::string& line, int number) {
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    std::uint32_t id = 0;
    std::string name;
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    if (!(words >> id >> name >> width >> height) || width > kLargest || height > kLargest)
      return refuse(Code::kColmapSaysLine, {number});
    const Model* model = colmap::find_model(name);
    if (model == nullptr) return refuse(Code::kColmapSaysUnknownModel, {number, name.substr(0, 40)});
    std::vector<double> params;
    for (double value = 0.0; words >> value;) params.push_back(value);
    if (params.size() != model->parameters())
      return refuse(Code::kColmapSaysParameterCount, {number, params.size(), name, model->parameters()});
    add(*model, params, id, {width, height}, number);
  }

  /// `number`: of its line, or its own.
  void add(const Model& model, const std::vector<double>& params, std::uint32_t id, const std::array<std::uint64_t, 2>& size,
           int number) {
    if (!ids_.insert(id).second) return refuse(Code::kColmapSaysIdTwice, {number, id});
    if (!model.since.empty() && told_.insert(model.name).second)
      view_.warnings.emplace_back(Code::kColmapSaysNewModel, "", std::vector<Argument>{model.name, model.since});
    ConsumerCamera seen = colmap::seen_camera("cam" + std::to_string(view_.cameras.size()), model, params);
    seen.width = static_cast<int>(size[0]);
    seen.height = static_cast<int>(size[1]);
    if (own_) own_(model, params, seen);
    view_.cameras.push_back(std::move(seen));
  }

  const OwnReading& own_;
  ConsumerView& view_;
  std::set<std::uint32_t> ids_;
  std::set<std::string_view> told_;
};

/// Which of the two a program opens it as its path says; here, what it is.
bool holds_rigs(std::string_view bytes) {
  std::istringstream lines{std::string(bytes)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::array<std::string, 3> first;
    words >> first[0] >> first[1] >> first[2];
    if (!first[0].empty() && first[0][0] != '#') return first[2] == "CAMERA" || first[2] == "IMU";
  }
  return false;
}

/// After a count of 8 bytes.
bool is_binary(std::string_view bytes) { return bytes.size() >= 8 && bytes.substr(4, 4) == std::string_view("\0\0\0\0", 4); }

void load_binary(std::string_view bytes, const OwnReading& own, ConsumerView& view) {
  ConsumerView as_rigs;
  if (Reader(own, view).run_binary(bytes) || !colmap::read_binary_rigs(bytes, as_rigs)) return;
  view = as_rigs;
}

}  // namespace

ConsumerView colmap::load(std::string_view bytes, const OwnReading& own) {
  ConsumerView view;
  if (bytes.empty() || bytes.size() > kMaxBytes) {
    view.refusals.emplace_back(bytes.empty() ? Code::kProgramFileEmpty : Code::kProgramFileTooLarge, "");
    return view;
  }
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && bytes[first] == '[') {
    colmap::read_rig_config(bytes, view);
  } else if (is_binary(bytes)) {
    load_binary(bytes, own, view);
  } else if (holds_rigs(bytes)) {
    colmap::read_rigs(bytes, view);
  } else {
    Reader(own, view).run(bytes);
  }
  return view;
}

ConsumerView load_colmap(std::string_view bytes, const LoadOptions& /*options*/) { return colmap::load(bytes); }

}  // namespace fca::consumers
