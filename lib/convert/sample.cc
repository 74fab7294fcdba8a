// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/sample.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace fca {

namespace {

struct Node {
  double position;  ///< in (0, 1)
  double weight;    ///< the weights sum to 1
};

/// Gauss-Legendre nodes on (0, 1): roots of the Legendre polynomial P_n by Newton's method from the classic starting values.
std::vector<Node> gauss_legendre(int n) {
  std::vector<Node> nodes;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    double slope = 1.0;
    for (int iteration = 0; iteration < 8; ++iteration) {
      double p = 1.0;
      double previous = 0.0;
      for (int k = 0; k < n; ++k) {
        const double next = ((2.0 * k + 1.0) * x * p - k * previous) / (k + 1.0);
        previous = p;
        p = next;
      }
      slope = n * (x * p - previous) / (x * x - 1.0);
      x -= p / slope;
    }
    nodes.push_back({0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope)});
  }
  return nodes;
}

void add_if_seen(const CameraModel& source, const Domain& domain, const Pixel& pixel, double weight,
                 std::vector<Correspondence>& samples) {
  if (const std::optional<Ray> ray = domain.ray(source, pixel)) samples.push_back({*ray, pixel, weight});
}

/// Tensor of Gauss-Legendre nodes over the whole image; points outside the lens fall away.
std::vector<Correspondence> sample_rectangle(const CameraModel& source, const Domain& domain, int count) {
  const double width = domain.size.width - 1.0;
  const double height = domain.size.height - 1.0;
  const double aspect = std::clamp((width + 1.0) / (height + 1.0), 0.1, 10.0);
  const int columns = std::max(2, static_cast<int>(std::lround(std::sqrt(count * aspect))));
  const int rows = std::max(2, static_cast<int>(std::lround(static_cast<double>(count) / columns)));
  std::vector<Correspondence> samples;
  const std::vector<Node> vertical = gauss_legendre(rows);
  for (const Node& u : gauss_legendre(columns)) {
    for (const Node& v : vertical) {
      add_if_seen(source, domain, {u.position * width, v.position * height}, u.weight * v.weight, samples);
    }
  }
  return samples;
}

/// How far the domain reaches from a centre on one azimuth, and what ends it there.
struct Reach {
  double distance = 0.0;
  bool at_border = true;  ///< else the lens ends first
};

/// Angles grow along the way, so bisection finds the lens's edge.
Reach reach(const CameraModel& source, const Domain& domain, const Pixel& centre, double azimuth) {
  const Pixel direction = {std::cos(azimuth), std::sin(azimuth)};
  const Pixel last = {domain.size.width - 1.0, domain.size.height - 1.0};
  double far = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < direction.size(); ++k) {
    if (direction[k] > 0.0) far = std::min(far, (last[k] - centre[k]) / direction[k]);
    if (direction[k] < 0.0) far = std::min(far, -centre[k] / direction[k]);
  }
  const auto inside = [&](double distance) {
    return domain.ray(source, {centre[0] + distance * direction[0], centre[1] + distance * direction[1]}).has_value();
  };
  constexpr double kJustInside = 1.0 - 1e-12;  // rounding must not put the border outside the image
  if (inside(far * kJustInside)) return {far * kJustInside, true};
  double near = 0.0;
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (near + far);
    (inside(middle) ? near : far) = middle;
  }
  return {near, false};
}

/// Azimuths between which the domain's edge is smooth: the image's corners, and where the edge changes between border and lens.
std::vector<double> smooth_pieces(const CameraModel& source, const Domain& domain, const Pixel& centre) {
  const double width = domain.size.width - 1.0;
  const double height = domain.size.height - 1.0;
  std::vector<double> corners;
  for (const Pixel& corner : {Pixel{width, height}, Pixel{0.0, height}, Pixel{0.0, 0.0}, Pixel{width, 0.0}}) {
    double azimuth = std::atan2(corner[1] - centre[1], corner[0] - centre[0]);
    if (!corners.empty() && azimuth < corners.back()) azimuth += 2.0 * std::numbers::pi;
    corners.push_back(azimuth);
  }
  corners.push_back(corners.front() + 2.0 * std::numbers::pi);

  const auto at_border = [&](double azimuth) { return reach(source, domain, centre, azimuth).at_border; };
  constexpr int kStepsPerSide = 12;
  std::vector<double> pieces = {corners.front()};
  for (std::size_t side = 0; side + 1 < corners.size(); ++side) {
    const double span = corners[side + 1] - corners[side];
    // The corners themselves belong to two sides: look a hair inside.
    const auto azimuth_of = [&](int step) {
      return corners[side] + span * std::clamp(static_cast<double>(step) / kStepsPerSide, 1e-9, 1.0 - 1e-9);
    };
    for (int step = 0; step < kStepsPerSide; ++step) {
      double before = azimuth_of(step);
      double after = azimuth_of(step + 1);
      const bool kind = at_border(before);
      if (at_border(after) == kind) continue;
      constexpr int kHalvings = 30;
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (before + after);
        (at_border(middle) == kind ? before : after) = middle;
      }
      pieces.push_back(0.5 * (before + after));
    }
    pieces.push_back(corners[side + 1]);
  }
  return pieces;
}

/// Polar around the principal point.
std::vector<Correspondence> sample_polar(const CameraModel& source, const Domain& domain, const Pixel& centre, int count) {
  const std::vector<double> pieces = smooth_pieces(source, domain, centre);
  // Errors change fast along the radius (tan^7 for radtan) and slowly around it: three azimuths a piece, and radii as many as
  // are left.
  constexpr int kAzimuthsPerPiece = 3;
  constexpr int kFewestRadii = 10;
  constexpr int kMostRadii = 40;
  const int radial = std::clamp(count / (kAzimuthsPerPiece * static_cast<int>(pieces.size() - 1)), kFewestRadii, kMostRadii);
  const std::vector<Node> radii = gauss_legendre(radial);
  const double azimuths_per_radian = count / (radial * 2.0 * std::numbers::pi);
  std::vector<Correspondence> samples;
  for (std::size_t piece = 0; piece + 1 < pieces.size(); ++piece) {
    const double span = pieces[piece + 1] - pieces[piece];
    for (const Node& azimuth :
         gauss_legendre(std::max(kAzimuthsPerPiece, static_cast<int>(std::lround(azimuths_per_radian * span))))) {
      const double phi = pieces[piece] + azimuth.position * span;
      const double edge = reach(source, domain, centre, phi).distance;
      for (const Node& radius : radii) {
        const double distance = radius.position * edge;
        add_if_seen(source, domain, {centre[0] + distance * std::cos(phi), centre[1] + distance * std::sin(phi)},
                    azimuth.weight * span * radius.weight * edge * distance, samples);
      }
    }
  }
  return samples;
}

bool whole_image(const CameraModel& source, const Domain& domain) {
  const double width = domain.size.width - 1.0;
  const double height = domain.size.height - 1.0;
  return std::ranges::all_of(std::array<Pixel, 4>{{{0.0, 0.0}, {width, 0.0}, {0.0, height}, {width, height}}},
                             [&](const Pixel& corner) { return domain.ray(source, corner).has_value(); });
}

}  // namespace

std::vector<Correspondence> sample(const CameraModel& source, const Domain& domain, int count) {
  const std::optional<Pixel> centre = project(source, {0.0, 0.0, 1.0});
  const bool centred = centre && (*centre)[0] > 0.0 && (*centre)[1] > 0.0 && (*centre)[0] < domain.size.width - 1.0 &&
                       (*centre)[1] < domain.size.height - 1.0;
  std::vector<Correspondence> samples;
  if (centred && !whole_image(source, domain)) {
    samples = sample_polar(source, domain, *centre, count);
  } else {
    // An image whose centre lies outside it is rare; a finer tensor grid makes up for the points that fall away.
    samples = sample_rectangle(source, domain, centred ? count : 4 * count);
  }
  double total = 0.0;
  for (const Correspondence& s : samples) total += s.weight;
  for (Correspondence& s : samples) s.weight /= total;
  return samples;
}

}  // namespace fca
