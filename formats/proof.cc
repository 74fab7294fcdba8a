// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/proof.h>

#include "reader_pixels.h"

#include <fca/code.h>
#include <fca/formats/format.h>
#include <fca/formats/wording.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace fca {

namespace {

/// `tolerance` is what separates two implementations that hold the same numbers; the parameters, too, are rounded when a
/// program stores them as floats (2.6e-4 px on a T265).
constexpr double kRounding = 5.0;

/// A pixel and that of its ray, in pixels.
constexpr double kSamePixel = 1e-3;

/// Steps of the lattices over a camera's image.
constexpr int kCoarse = 24;
constexpr int kFine = ReaderPoints::kSteps;

/// An image in parts of which both lattices' cells are whole numbers: cameras count alike, and sums are exact.
constexpr double kImageArea = kCoarse * kCoarse * kFine * kFine;

/// Sums are of image area, in parts of kImageArea.
struct Comparison {
  double worst = 0.0;
  double misread = 0.0;
  double asked = 0.0;
  double compared = 0.0;
  double misread_area = 0.0;
  double wrong_rays = 0.0;
  double wrong_ray_px = 0.0;
  bool agrees = true;

  /// What is found stays found; the areas are to be summed again.
  void forget_areas() { asked = compared = misread_area = wrong_rays = 0.0; }
  void add(const Comparison& other) {
    worst = std::max(worst, other.worst);
    misread = std::max(misread, other.misread);
    asked += other.asked;
    compared += other.compared;
    misread_area += other.misread_area;
    wrong_rays += other.wrong_rays;
    wrong_ray_px = std::max(wrong_ray_px, other.wrong_ray_px);
    agrees = agrees && other.agrees;
  }
};

/// On the other side of the program's image centre? So the formulas that divide by z answer rays from behind.
bool is_mirrored(const consumers::ConsumerCamera& theirs, const Pixel& image, const Pixel& pixel) {
  const std::optional<Pixel> centre = theirs.project({0.0, 0.0, 1.0});
  if (!centre) return false;
  return (image[0] - (*centre)[0]) * (pixel[0] * theirs.scale[0] - (*centre)[0]) +
             (image[1] - (*centre)[1]) * (pixel[1] * theirs.scale[1] - (*centre)[1]) <
         0.0;
}

/// For how much of the image a point stands: for the comparison of pixels, and for that of the program's rays with its pixels,
/// which takes as long and is asked for at fewer points; at some for neither.
struct Area {
  double pixels = 0.0;
  std::optional<double> rays = {};
};

/// How far apart the last digits of a ray put its pixels: far where a rational function nearly divides by 0.
double rounding_px(const CameraModel& model, const Ray& ray) {
  constexpr double kLast = std::numeric_limits<double>::epsilon();
  const std::optional<Pixel> pixel = project(model, ray);
  double largest = 0.0;
  for (std::size_t i = 0; pixel && i < ray.size(); ++i) {
    for (const double digits : {-2.0, -1.0, 1.0, 2.0}) {
      Ray near = ray;
      near[i] *= 1.0 + digits * kLast;
      const std::optional<Pixel> other = project(model, near);
      if (other) largest = std::max(largest, distance(*pixel, *other));
    }
  }
  return largest;
}

/// The difference in pixels; 0 where there is nothing to compare. `model`: the ray's; null for one of a table.
double compare_pixel(const Pixel& pixel, const Ray& ray, const CameraModel* model, const consumers::ConsumerCamera& theirs,
                     const Area& area, double tolerance, Comparison& result, ReaderPoint& point) {
  result.asked += area.pixels;
  const std::optional<Pixel>& image = point.image(theirs, ray);
  if (!image) return 0.0;
  const double difference = distance(*image, in_their_pixels(pixel, theirs));
  // From 90 degrees on some programs mirror: that is their limit, told as a warning, not a fault of the file.
  if (ray[2] <= 0.0 && distance(in_file_pixels(*image, theirs), pixel) > 1.0 &&
      (!theirs.misread || is_mirrored(theirs, *image, pixel)))
    return 0.0;
  result.compared += area.pixels;
  constexpr double kWrong = 1.0;  // px
  if (const double off = area.rays ? point.wrong_px(theirs, pixel) : 0.0; off > kWrong) {
    result.wrong_rays += *area.rays;
    result.wrong_ray_px = std::max(result.wrong_ray_px, off);
  }
  if (theirs.misread) {
    result.misread_area += area.pixels;
    result.misread = std::max(result.misread, difference);
    return difference;
  }
  result.worst = std::max(result.worst, difference);
  const double allowed = (kRounding * tolerance + theirs.approximation_px) *
                         std::max({1.0, std::abs(pixel[0]) / 1000.0, std::abs(pixel[1]) / 1000.0});
  if (difference <= allowed) return difference;
  if (model == nullptr || !(difference <= allowed + kRounding * rounding_px(*model, ray))) result.agrees = false;
  return difference;
}

/// Over the camera's image: our ray of a pixel, then the program's pixel of that ray. On a lattice, and on rings about the
/// centre, where a polynomial inverse is worst; from the worst of them on to where the difference is largest.
Comparison compare_camera(const Camera& ours, const consumers::ConsumerCamera& theirs, double tolerance, double max_angle_rad,
                          ReaderPoints& known) {
  Comparison result;
  if (!ours.image_size) return result;
  const Pixel last = {ours.image_size->width - 1.0, ours.image_size->height - 1.0};
  const double last_cosine = max_angle_rad < std::numbers::pi ? std::cos(max_angle_rad) : -2.0;
  Pixel worst_pixel = {0.0, 0.0};
  double worst = 0.0;
  const auto compare_point = [&](const Pixel& pixel, const Area& area, ReaderPoint& point) {
    if (!ours.image_size->holds(pixel)) return false;
    if (ours.lens_circle && !ours.lens_circle->contains(pixel)) return false;
    const std::optional<Ray>& ray = point.ray(ours.model, pixel);
    if (!ray || (*ray)[2] < last_cosine) return false;
    // Near a fold a ray is only nearly that of the pixel: the ray's own is compared.
    const std::optional<Pixel> of_ray = project(ours.model, *ray);
    const bool is_near = of_ray && distance(*of_ray, pixel) < kSamePixel;
    const double difference =
        compare_pixel(is_near ? *of_ray : pixel, *ray, &ours.model, theirs, area, tolerance, result, point);
    if (!(difference > worst)) return false;
    worst = difference;
    worst_pixel = pixel;
    return true;
  };
  const auto compare_at = [&](const Pixel& pixel, const Area& area) {
    ReaderPoint point;
    return compare_point(pixel, area, point);
  };
  // Trapezoids: a point of the border stands for half a cell.
  const auto compare_lattice = [&](int steps, int steps_to_next_ray) {
    const auto width_of = [steps](int step) { return step == 0 || step == steps ? 0.5 : 1.0; };
    const double cell_area = kImageArea / (steps * steps);
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= steps; ++j) {
        Area area{width_of(i) * width_of(j) * cell_area};
        if (i % steps_to_next_ray == 0 && j % steps_to_next_ray == 0)
          area.rays = steps_to_next_ray * steps_to_next_ray * area.pixels;
        const Pixel pixel = {last[0] * i / steps, last[1] * j / steps};
        steps == ReaderPoints::kSteps ? compare_point(pixel, area, known.at(i, j)) : compare_at(pixel, area);
      }
    }
  };
  compare_lattice(kCoarse, 2);
  // By a finer lattice where shares of the image are to be told; and where a lens that is misread ends inside the image: the
  // worst pixel then lies at that edge, which the walk below follows badly.
  const bool ends_inside = result.asked < kImageArea;
  if (result.wrong_rays > 0.0 || result.compared < result.asked || (result.misread_area > 0.0 && ends_inside)) {
    result.forget_areas();
    compare_lattice(kFine, 1);
  }
  const double cell = std::max(last[0], last[1]) / kCoarse;
  constexpr int kDirections = 8;
  const Pixel centre = principal_point(ours.model);
  for (double radius = 0.5; radius < 2.0 * cell; radius *= 2.0) {
    for (int k = 0; k < kDirections; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kDirections;
      compare_at({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)}, {0.0, 0.0});
    }
  }
  constexpr double kFinest = 0.25;  // px
  for (double step = 0.5 * cell; step > kFinest;) {
    const Pixel from = worst_pixel;
    bool moved = false;
    for (const Pixel& way : {Pixel{step, 0.0}, Pixel{-step, 0.0}, Pixel{0.0, step}, Pixel{0.0, -step}})
      moved = compare_at({from[0] + way[0], from[1] + way[1]}, {}) || moved;
    if (!moved) step *= 0.5;
  }
  return result;
}

/// The same of a lens that is known by rays alone: of those.
Comparison compare_table(const Camera& ours, const consumers::ConsumerCamera& theirs, double tolerance, double max_angle_rad,
                         ReaderPoints& /*known*/) {
  Comparison result;
  for (const Correspondence& entry : ours.rays) {
    if (angle_from_axis(entry.ray) > max_angle_rad) continue;
    const double area = entry.weight * kImageArea;
    ReaderPoint point;
    compare_pixel(entry.pixel, entry.ray, nullptr, theirs, {area, area}, tolerance, result, point);
  }
  return result;
}

/// Programs count their cameras; the rig may name them otherwise.
std::string name_in(const Rig& rig, const consumers::ConsumerView& view, const std::string& name) {
  for (std::size_t i = 0; i < std::min(rig.cameras.size(), view.cameras.size()); ++i) {
    if (view.cameras[i].name == name) return rig.cameras[i].name;
  }
  return name;
}

double pose_difference(const Rig& rig, const consumers::ConsumerView& view, const consumers::ConsumerPose& pose) {
  const std::optional<Transform> T = rig.resolve(name_in(rig, view, pose.a), name_in(rig, view, pose.b));
  if (!T) return 0.0;
  double worst = 0.0;
  // Relative for long translations: floats are.
  for (std::size_t i = 0; i < T->values.size(); ++i) {
    worst = std::max(worst, std::abs(T->values[i] - pose.T_a_b[i]) / std::max(1.0, std::abs(T->values[i])));
  }
  return worst;
}

/// What numbers in floats may differ by, relatively, and elements of poses.
constexpr double kFloatPrecision = 1e-6;

struct ImuNumber {
  std::string_view name;
  std::optional<double> Imu::*ours;
  std::optional<double> consumers::ConsumerImu::*theirs;
  double rounded_to = 0.0;  ///< Where a format rounds, and lists that as a loss.
};
constexpr std::array kImuNumbers = {
    ImuNumber{"gyroscope noise density", &Imu::gyroscope_noise_density, &consumers::ConsumerImu::gyroscope_noise_density},
    ImuNumber{"gyroscope random walk", &Imu::gyroscope_random_walk, &consumers::ConsumerImu::gyroscope_random_walk},
    ImuNumber{"accelerometer noise density", &Imu::accelerometer_noise_density,
              &consumers::ConsumerImu::accelerometer_noise_density},
    ImuNumber{"accelerometer random walk", &Imu::accelerometer_random_walk, &consumers::ConsumerImu::accelerometer_random_walk},
    ImuNumber{"rate", &Imu::rate_hz, &consumers::ConsumerImu::rate_hz, 0.5},
};

/// Collects the numbers that differ, of those that both specify.
class NumberComparison {
 public:
  /// `owner`: a camera, the IMU, or nothing.
  void compare(std::string_view owner, std::string_view what, const std::optional<double>& ours,
               const std::optional<double>& theirs, double rounded_to = 0.0) {
    if (!ours || !theirs) return;
    const double allowed = std::max(rounded_to, kFloatPrecision * std::abs(*ours));
    if (std::abs(*ours - *theirs) <= allowed) return;
    differing_.push_back({Code::kProgramOtherNumber, {owner, what, *theirs, *ours}});
  }

  void compare(const Camera& ours, const consumers::ConsumerCamera& theirs) {
    constexpr double kHalfNanosecond = 0.5e-9;  // Basalt counts whole ones
    compare(ours.name, "time offset", ours.time_offset_s, theirs.time_offset_s, kHalfNanosecond);
    if (!ours.image_size || theirs.width == 0) return;
    // What a program scales it cuts to ints.
    const auto cut = [](double scale) { return scale == 1.0 ? 0.0 : 1.0; };
    compare(ours.name, "image width", ours.image_size->width * theirs.scale[0], theirs.width, cut(theirs.scale[0]));
    compare(ours.name, "image height", ours.image_size->height * theirs.scale[1], theirs.height, cut(theirs.scale[1]));
  }

  void compare(const Imu& ours, const consumers::ConsumerImu& theirs) {
    for (const ImuNumber& number : kImuNumbers)
      compare(ours.name, number.name, ours.*number.ours, theirs.*number.theirs, number.rounded_to);
  }

  [[nodiscard]] std::vector<Message> differing() && { return std::move(differing_); }

 private:
  std::vector<Message> differing_;
};

std::vector<Message> differing_numbers(const Rig& rig, const consumers::ConsumerView& view) {
  NumberComparison numbers;
  for (std::size_t i = 0; i < std::min(rig.cameras.size(), view.cameras.size()); ++i)
    numbers.compare(rig.cameras[i], view.cameras[i]);
  if (!rig.imus.empty() && view.imu) numbers.compare(rig.imus.front(), *view.imu);
  numbers.compare("", "the baseline", rig.baseline_m, view.baseline_m);
  return std::move(numbers).differing();
}

}  // namespace

void one_after_the_other(std::size_t count, const std::function<void(std::size_t)>& body) {
  for (std::size_t i = 0; i < count; ++i) body(i);
}

namespace {

ProofResult proof_of(const consumers::Consumer& consumer, const consumers::ConsumerView& view, const Rig& rig,
                     double max_angle_rad, const ForEach& each_camera, std::span<const CalibratedCamera> calibrated) {
  ProofResult result;
  result.program = consumer.program;
  result.loads = view.loads();
  result.refusals = view.refusals;
  result.warnings = view.warnings;
  result.wanted_name = view.wanted_name;
  result.undistorts_points =
      std::ranges::any_of(view.cameras, [](const auto& each) { return each.unproject_fault.code == Code::kRaysInFiveSteps; });
  if (!result.loads) return result;
  // The rig's cameras by position: formats may rename them.
  std::vector<Comparison> comparisons(std::min(rig.cameras.size(), view.cameras.size()));
  std::vector<CameraDistance> distances(comparisons.size());
  each_camera(comparisons.size(), [&](std::size_t i) {
    const Camera& camera = rig.cameras[i];
    const auto compare = camera.rays.empty() ? compare_camera : compare_table;
    ReaderPoints known;
    comparisons[i] = compare(camera, view.cameras[i], consumer.tolerance_px, max_angle_rad, known);
    const auto before = std::ranges::find(calibrated, camera.name,
                                          [](const CalibratedCamera& each) -> const std::string& { return each.camera.name; });
    const bool was_fitted = before != calibrated.end();
    const AngleLimits limits = {max_angle_rad, was_fitted ? before->fitted_to_rad : std::numbers::pi};
    const bool has_gaps =
        comparisons[i].compared < comparisons[i].asked || comparisons[i].wrong_rays > 0.0 || limits.fitted < std::numbers::pi;
    distances[i] = distance_of(was_fitted ? before->camera : camera, camera.model, view.cameras[i], limits, has_gaps,
                               was_fitted ? before->T_written_camera : std::nullopt, known);
  });
  Comparison comparison;
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const consumers::ConsumerCamera& theirs = view.cameras[i];
    const Comparison& one = comparisons[i];
    comparison.add(one);
    const bool agrees = one.agrees && one.misread == 0.0 && (one.compared > 0.0 || one.asked == 0.0);
    result.cameras.push_back({rig.cameras[i].name, theirs.model, theirs.width, theirs.height, theirs.misread, agrees,
                              std::max(one.worst, one.misread), one.asked > 0.0 ? one.compared / one.asked : 0.0,
                              distances[i]});
  }
  result.without_cameras = rig.cameras.empty();
  result.max_diff_px = comparison.worst;
  result.misread_px = comparison.misread;
  result.all_misread = comparison.misread_area > 0.0 && comparison.misread_area == comparison.compared;
  result.compared_share = comparison.asked > 0.0 ? comparison.compared / comparison.asked : 0.0;
  result.unanswered_share = comparison.asked > 0.0 ? 1.0 - result.compared_share : 0.0;
  result.wrong_ray_px = comparison.wrong_ray_px;
  if (comparison.wrong_rays > 0.0) {
    const auto named = std::ranges::find_if(view.cameras, [](const auto& each) { return each.unproject_fault.is_said(); });
    if (named != view.cameras.end()) result.wrong_ray_why = named->unproject_fault;
  }
  result.wrong_ray_share = comparison.asked > 0.0 ? comparison.wrong_rays / comparison.asked : 0.0;
  for (const consumers::ConsumerPose& pose : view.poses) {
    result.max_diff_pose = std::max(result.max_diff_pose, pose_difference(rig, view, pose));
    result.poses.push_back("T_" + name_in(rig, view, pose.a) + "_" + name_in(rig, view, pose.b));
  }
  result.pixels_agree = comparison.agrees && (comparison.compared > 0.0 || comparison.asked == 0.0);
  if (view.cameras.size() < rig.cameras.size()) result.pixels_agree = false;  // it does not see a camera at all
  result.poses_agree = result.max_diff_pose <= kFloatPrecision;
  result.other_numbers = differing_numbers(rig, view);
  return result;
}

}  // namespace

ProofResult prove(const consumers::Consumer& consumer, const consumers::ConsumerView& view, const Rig& rig,
                  std::span<const std::string> cameras, double max_angle_rad, const ForEach& each_camera,
                  std::span<const CalibratedCamera> calibrated) {
  Rig written = rig;
  written.cameras.clear();
  for (const std::string& name : cameras) {
    if (const Camera* camera = rig.find_camera(name)) written.cameras.push_back(*camera);
  }
  return proof_of(consumer, view, written, max_angle_rad, each_camera, calibrated);
}

ProofResult prove(const consumers::Consumer& consumer, std::string_view bytes, const consumers::LoadOptions& options,
                  const Rig& rig, std::span<const std::string> cameras, double max_angle_rad, const ForEach& each_camera,
                  std::span<const CalibratedCamera> calibrated) {
  return prove(consumer, consumer.load(bytes, options), rig, cameras, max_angle_rad, each_camera, calibrated);
}

ProofResult prove(const consumers::Consumer& consumer, std::string_view bytes, const consumers::LoadOptions& options,
                  const Rig& rig, double max_angle_rad, const ForEach& each_camera,
                  std::span<const CalibratedCamera> calibrated) {
  return proof_of(consumer, consumer.load(bytes, options), rig, max_angle_rad, each_camera, calibrated);
}

namespace {

bool misreads_all(const consumers::ConsumerView& view) {
  return !view.cameras.empty() && std::ranges::all_of(view.cameras, &consumers::ConsumerCamera::misread);
}

/// The modes of the format's programs; an empty one where they have none.
std::span<const std::string_view> modes_of(std::string_view format_id) {
  static constexpr std::array<std::string_view, 1> kNoModes = {""};
  const Format* format = find_format(format_id);
  return format != nullptr && !format->modes.empty() ? format->modes : std::span<const std::string_view>(kNoModes);
}

/// What a mode (empty: the first) has to say that is not said yet.
void add_warnings(Readers::Program& program, std::string_view mode, const std::vector<consumers::Complaint>& warnings) {
  for (const consumers::Complaint& warning : warnings) {
    const Message facts = warning.facts;
    const auto is_said = [&facts](const consumers::Complaint& said) {
      if (said.facts.code == Code::kProgramAsMode) return said.facts.arguments.back() == Argument(facts);
      return said.facts == facts;
    };
    if (std::ranges::any_of(program.warnings, is_said)) continue;
    if (mode.empty()) {
      program.warnings.push_back(warning);
    } else {
      program.warnings.emplace_back(Code::kProgramAsMode, warning.key, std::vector<Argument>{mode, facts});
    }
  }
}

}  // namespace

consumers::LoadOptions load_options(const ReadOptions& reading, std::string mode) {
  consumers::LoadOptions options = {std::move(mode), reading.opencv_model};
  if (const std::optional<ImageSize>& size = reading.image_size)
    options.image_size = {static_cast<double>(size->width), static_cast<double>(size->height)};
  return options;
}

Readers ask_readers(std::string_view format_id, std::string_view bytes, std::optional<bool> with_cameras,
                    const consumers::LoadOptions& options) {
  Readers readers;
  const std::span<const std::string_view> modes = modes_of(format_id);
  for (const consumers::Consumer& consumer : consumers::all_consumers()) {
    if (!consumer.reads(format_id) || (with_cameras && consumer.cameras != *with_cameras)) continue;
    Readers::Program program;
    program.program = consumer.program;
    program.other_syntax = consumer.other_syntax && consumer.format != format_id;
    std::size_t fewest = SIZE_MAX;
    for (const std::string_view mode : modes) {
      consumers::LoadOptions asked = options;
      asked.sensor = mode;
      const consumers::ConsumerView view = consumer.load(bytes, asked);
      if (view.loads() && misreads_all(view)) {
        const bool says = !view.warnings.empty();
        const std::string key = says ? view.warnings.front().key : std::string();
        const std::vector<Argument> why = {says ? view.warnings.front().facts : Message{Code::kProgramOtherModel}};
        program.refusals = {{Code::kProgramWouldMisread, key, why}};
        add_warnings(program, mode, {{Code::kProgramMisreadsAll, key, why}});
        fewest = 0;
      } else if (view.loads()) {
        add_warnings(program, program.loads ? mode : "", view.warnings);
        program.loads = true;
        if (!mode.empty()) program.sensors.emplace_back(mode);
      } else if (view.refusals.size() < fewest) {
        fewest = view.refusals.size();
        program.refusals = view.refusals;
      }
    }
    program.loads ? program.refusals.clear() : program.warnings.clear();
    readers.programs.push_back(std::move(program));
  }
  return readers;
}

Message refused_by_all(std::string_view format, std::string_view bytes, bool with_cameras,
                       const consumers::LoadOptions& options) {
  Message first;
  for (const consumers::Consumer& consumer : consumers::all_consumers()) {
    if (!consumer.reads(format) || consumer.cameras != with_cameras) continue;
    for (const std::string_view mode : modes_of(format)) {
      consumers::LoadOptions asked = options;
      asked.sensor = mode;
      const consumers::ConsumerView view = consumer.load(bytes, asked);
      if (view.loads() || view.finds_no_camera) return {};
      if (!first.is_said()) first = {Code::kProgramSays, {consumer.program, view.refusals.front().facts}};
    }
  }
  return first;
}

}  // namespace fca
