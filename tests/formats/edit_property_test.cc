// SPDX-License-Identifier: BSD-3-Clause
// Any edit of any file: the result says what was asked for, and no byte changes that the edit does not explain.
#include "formats/rigs.h"
#include "formats/test_files.h"
#include "sanitized.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <string_view>

namespace fca::test {
namespace {

/// A calibration that can serve as a base, with its bytes.
struct Base {
  std::string name;
  std::string bytes;
  Calibration calibration;
};

std::optional<Base> base_at(const fs::path& path) {
  Parsed parsed = parse(read_file(path), path.filename().string());
  if (!parsed.document) return std::nullopt;
  std::optional<Calibration> calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
  if (!calibration) return std::nullopt;
  return Base{path.string(), parsed.source.bytes, *std::move(calibration)};
}

/// SVO's flat files are read, and rewritten in today's keys.
bool is_replaced(const Base& base) {
  return base.calibration.format->id == "ncamera" && base.bytes.find("cam_model") != std::string::npos;
}

/// The good files of testdata, and the readable ones of the corpus where there is one.
std::vector<Base> all_bases() {
  std::vector<fs::path> paths = files_of_all_formats("good");
  for (const Format& format : written_formats()) {
    const std::vector<fs::path> found = corpus_files_of(format.id);
    paths.insert(paths.end(), found.begin(), found.end());
  }
  std::vector<Base> bases;
  for (const fs::path& path : paths) {
    std::optional<Base> base = base_at(path);
    if (base && base->calibration.format->is_written() && !is_replaced(*base)) bases.push_back(*std::move(base));
  }
  return bases;
}

/// One file's scalars, and what stands between them.
struct Pieces {
  std::vector<std::string> scalars;
  std::vector<std::string> paths;  ///< Keys above each scalar, "LEFT.D/data".
  std::vector<std::string> gaps;
};

void collect(const text::Node& node, const std::string& path, std::vector<std::pair<text::Span, std::string>>& places) {
  if (node.is_scalar()) places.emplace_back(node.span, path);
  for (const text::Node& item : node.items) collect(item, path, places);
  for (const text::Entry& entry : node.entries) {
    const std::string below = path + (path.empty() ? "" : "/") + entry.key.value;
    places.emplace_back(entry.key.span, below);
    collect(entry.value, below, places);
  }
}

Pieces pieces_of(const text::Document& document) {
  std::vector<std::pair<text::Span, std::string>> places;
  collect(document.root(), "", places);
  std::ranges::sort(places, {}, [](const auto& place) { return place.first.offset; });
  const std::string& bytes = document.source().bytes;
  Pieces pieces;
  std::size_t copied = 0;
  for (const auto& [span, path] : places) {
    pieces.gaps.push_back(bytes.substr(copied, span.offset - copied));
    pieces.scalars.push_back(bytes.substr(span.offset, span.length));
    pieces.paths.push_back(path);
    copied = span.end();
  }
  pieces.gaps.push_back(bytes.substr(copied));
  return pieces;
}

/// A statement that repeats or follows from another one: slam_no_opt's LEFT.* say Camera.* again, and Camera.bf is the baseline
/// times fx; mrcal has a pose under two keys.
bool is_redundant(const std::string& path) { return path == "Camera.bf" || path == "rt_cam_ref" || path.starts_with("LEFT."); }

/// P of a camera_info whose image is K's goes with K, and so does what it says in pixels of a baseline.
bool is_projection(const std::string& path) { return path == "projection_matrix/data"; }

/// A camera of a transforms.json is repeated in each of its images.
bool is_repeated(const std::string& path) { return path.starts_with("frames/"); }

/// Why more changed than one number, and one of each redundant statement; empty if not.
std::string unexplained(const text::Document& before, const text::Document& after) {
  const Pieces was = pieces_of(before);
  const Pieces is = pieces_of(after);
  if (was.scalars.size() != is.scalars.size())
    return std::to_string(was.scalars.size()) + " scalars became " + std::to_string(is.scalars.size());
  if (was.gaps != is.gaps) return "bytes between the scalars changed";
  std::map<std::string, int> changed;
  std::map<std::string, std::string> repeated;
  bool projection = false;
  for (std::size_t i = 0; i < was.scalars.size(); ++i) {
    if (was.scalars[i] == is.scalars[i]) continue;
    projection = projection || is_projection(was.paths[i]);
    if (is_projection(was.paths[i])) continue;
    const std::string statement = is_redundant(was.paths[i]) ? was.paths[i] : "the number";
    const auto [key, is_new] = repeated.emplace(was.paths[i], was.scalars[i] + " " + is.scalars[i]);
    if (!is_new && is_repeated(was.paths[i]) && key->second == was.scalars[i] + " " + is.scalars[i]) continue;
    if (++changed[statement] > 1) return was.paths[i] + " " + was.scalars[i] + " became " + is.scalars[i];
  }
  return changed.contains("the number") || projection ? "" : "nothing changed";
}

std::string written_over(const Base& base, const Rig& rig) {
  Diagnostics diagnostics;
  const std::optional<Written> written =
      base.calibration.format->write(&base.calibration.documents.front(), rig, {}, diagnostics);
  return written && !written->files.empty() ? written->files.front().document.bytes() : "";
}

/// Reads back what was written over a base; with a failure, nothing.
std::optional<Calibration> read_back(const Base& base, const std::string& bytes) {
  Parsed parsed = parse(bytes, base.calibration.documents.front().source().name);
  std::optional<Calibration> back;
  if (parsed.document) back = read_calibration({*parsed.document}, base.calibration.format, {}, parsed.diagnostics);
  EXPECT_TRUE(back) << parsed.rendered();
  return back;
}

/// DSO's camera.txt may specify its numbers relative to the image's size, and ROS's those of the sensor that is binned; pixels
/// that begin at 0.5 lose a bit at a power of two: they come back to rounding.
bool same_cameras(const Base& base, const Rig& a, const Rig& b) {
  const bool binned = base.calibration.format->id == "ros" && base.bytes.find("binning_") != std::string::npos;
  const std::string_view format = base.calibration.format->id;
  // ATAN counts in widths and heights of the image, as DSO's FOV lens does.
  const bool in_shares = format == "fast-livo" && model_info(a.cameras.front().model).id == "fov";
  const bool rounds = format == "dso" || in_shares || format == "colmap" || format == "nerfstudio" || binned;
  if (!rounds) return a.cameras == b.cameras;
  return std::ranges::equal(a.cameras, b.cameras, [](const Camera& x, const Camera& y) {
    return x.model.index() == y.model.index() &&
           std::ranges::equal(parameter_values(x.model), parameter_values(y.model),
                              [](double u, double v) { return std::abs(u - v) <= 1e-12 * std::max(1.0, std::abs(v)); });
  });
}

double largest_pose_difference(const Rig& a, const Rig& b) {
  double worst = 0.0;
  for (const PoseEdge& edge : a.poses) {
    const Transform* stated = b.stated(edge.a, edge.b);
    const std::optional<Transform> there = stated != nullptr ? *stated : b.resolve(edge.a, edge.b);
    worst = std::max(worst, there ? element_difference(edge.T_a_b, *there) : HUGE_VAL);
  }
  return worst;
}

/// OCamCalib's inverse polynomial is fitted to the direct one. camodocal's scaramuzza, the same lens in other numbers, has c in
/// all.
bool others_follow(const Base& base, const ModelInfo& model, const Parameter& parameter) {
  // Angles of view follow the focal lengths.
  if (base.calibration.format->id == "nerfstudio" && base.bytes.find("camera_angle_x") != std::string::npos &&
      parameter.name.starts_with('f'))
    return true;
  // A baseline in pixels follows the focal length.
  const bool has_baseline = base.calibration.rig.baseline_m.has_value();
  if (base.calibration.format->id == "stella" && has_baseline && parameter.name == "fx") return true;
  if (base.calibration.format->id == "vins" && model.id == "ocamcalib") return parameter.name != "cx" && parameter.name != "cy";
  const bool has_inverse = base.calibration.format->id == "ocamcalib" || base.calibration.format->id == "ncamera";
  return has_inverse && model.id == "ocamcalib" && parameter.name.starts_with('a');
}

/// COLMAP's simpler models have one focal length and fewer coefficients: the line gets another model. A transforms.json may
/// lack the principal point, which then is the middle, and begins to state it.
bool states_more(const Base& base, const text::Document& after) {
  const std::string_view format = base.calibration.format->id;
  return (format == "colmap" || format == "nerfstudio") &&
         pieces_of(base.calibration.documents.front()).scalars.size() != pieces_of(after).scalars.size();
}

/// A matrix of floats cannot hold every double: then it becomes one of doubles, which is another edit.
double storable(const Base& base, double value) {
  return base.calibration.format->id == "opencv" ? static_cast<double>(static_cast<float>(value)) : value;
}

// Also where nothing but one number of a list or matrix changes, the others keep their spelling.
TEST(EditProperty, OneParameterChangesItsOwnNumberOnly) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> factor(0.999, 1.001);
  int edits = 0;
  for (const Base& base : all_bases()) {
    for (std::size_t c = 0; c < base.calibration.rig.cameras.size(); ++c) {
      if (!base.calibration.rig.cameras[c].rays.empty()) continue;  // what its numbers are, only the program knows
      const ModelInfo& info = model_info(base.calibration.rig.cameras[c].model);
      for (std::size_t p = 0; p < info.parameters.size(); ++p) {
        if (is_sanitized() && (p + c) % 3 != 0) continue;  // of the code that runs a third shows all
        Rig rig = base.calibration.rig;
        double& value = parameter_values(rig.cameras[c].model)[p];
        // Four coefficients may stand for five of which the last is 0, and twelve for fourteen.
        const std::string_view name = info.parameters[p].name;
        const bool may_be_unstated = value == 0.0 && (name == "k3" || name.starts_with("tau_"));
        if (may_be_unstated || others_follow(base, info, info.parameters[p])) continue;
        // A coefficient that is 0 may be so small that no lens folds by it.
        constexpr double kSmall = 1e-9;
        value = storable(base, value == 0.0 ? kSmall : value * factor(random));
        SCOPED_TRACE(base.name + ": " + rig.cameras[c].name + " " + std::string(info.parameters[p].name));
        const std::string bytes = written_over(base, rig);
        if (bytes.empty()) continue;  // beyond what the format holds: refused, with a diagnostic
        const std::optional<Calibration> back = read_back(base, bytes);
        if (!back) continue;
        EXPECT_TRUE(same_cameras(base, back->rig, rig));
        ++edits;
        if (states_more(base, back->documents.front())) continue;
        EXPECT_EQ(unexplained(base.calibration.documents.front(), back->documents.front()), "");
      }
    }
  }
  EXPECT_GT(edits, 200);
}

/// A single element of a rotation has no number of its own there, in a quaternion or a rotation vector.
bool stores_no_matrix(const Base& base) {
  constexpr std::array<std::string_view, 4> kFormats = {"woodscape", "basalt", "colmap", "mrcal"};
  return std::ranges::find(kFormats, base.calibration.format->id) != kFormats.end();
}

/// Of the place in the rectified image P of a camera_info has two numbers, and stella_vslam one for both cameras: how far the
/// second stands to the right of the first.
bool has_no_number(const Base& base, const PoseEdge& edge, int element) {
  constexpr int kRight = 3;
  constexpr int kDepth = 11;
  if (base.calibration.format->id == "ros") return element == kDepth;
  return base.calibration.format->id == "stella" && element % 4 == 3 && (element != kRight || edge.b == "cam0");
}

TEST(EditProperty, OneElementOfAPoseChangesItsOwnNumberOnly) {
  std::mt19937_64 random(2);
  // Small enough that a rotation stays one as far as readers care.
  std::uniform_real_distribution<double> shift(-1e-4, 1e-4);
  constexpr int kElements = 12;
  int edits = 0;
  for (const Base& base : all_bases()) {
    for (std::size_t p = 0; p < base.calibration.rig.poses.size(); ++p) {
      for (int element = 0; element < kElements; ++element) {
        const bool of_rotation = element % 4 != 3;
        if ((of_rotation && stores_no_matrix(base)) || has_no_number(base, base.calibration.rig.poses[p], element)) continue;
        Rig rig = base.calibration.rig;
        double& value = rig.poses[p].T_a_b(element / 4, element % 4);
        const double before = value;
        value = storable(base, value + shift(random));
        if (value == before) continue;
        SCOPED_TRACE(base.name + ": " + rig.poses[p].a + " " + rig.poses[p].b + " " + std::to_string(element));
        const std::optional<Calibration> back = read_back(base, written_over(base, rig));
        if (!back) continue;
        EXPECT_LE(largest_pose_difference(rig, back->rig), 1e-12);
        EXPECT_EQ(unexplained(base.calibration.documents.front(), back->documents.front()), "");
        ++edits;
      }
    }
  }
  EXPECT_GT(edits, 40);
}

// The file specifies it in its own direction, whatever the rig's.
TEST(EditProperty, APoseStatedTheOtherWayRoundEditsTheStatementThatIsThere) {
  for (const Base& base : all_bases()) {
    for (std::size_t p = 0; p < base.calibration.rig.poses.size(); ++p) {
      Rig rig = base.calibration.rig;
      PoseEdge& edge = rig.poses[p];
      constexpr int kRight = 3;
      if (has_no_number(base, edge, kRight)) continue;
      edge.T_a_b(0, 3) += 0.125;
      const std::optional<Transform> T_b_a = inverse(edge.T_a_b);
      if (!T_b_a) continue;
      SCOPED_TRACE(base.name + ": " + edge.a + " " + edge.b);
      edge = {edge.b, edge.a, *T_b_a};
      const std::optional<Calibration> back = read_back(base, written_over(base, rig));
      if (!back) continue;
      EXPECT_LE(largest_pose_difference(rig, back->rig), 1e-12);
      const Pieces was = pieces_of(base.calibration.documents.front());
      const Pieces is = pieces_of(back->documents.front());
      EXPECT_EQ(was.scalars.size(), is.scalars.size());
      EXPECT_TRUE(was.gaps == is.gaps);
    }
  }
}

}  // namespace
}  // namespace fca::test
