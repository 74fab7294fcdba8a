// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/sample.h>

#include <algorithm>
#include <array>
#include <cmath>
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

/// From `centre` along `direction`: how far the domain reaches. Angles grow along the way, so bisection finds the edge.
double reach(const CameraModel& source, const Domain& domain, const Pixel& centre, const Pixel& direction) {
  double far = std::numeric_limits<double>::infinity();
  const std::array<double, 2> last = {domain.size.width - 1.0, domain.size.height - 1.0};
  for (int axis = 0; axis < 2; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    if (direction[k] > 0.0) far = std::min(far, (last[k] - centre[k]) / direction[k]);
    if (direction[k] < 0.0) far = std::min(far, -centre[k] / direction[k]);
  }
  const auto inside = [&](double distance) {
    return domain.ray(source, {centre[0] + distance * direction[0], centre[1] + distance * direction[1]}).has_value();
  };
  if (inside(far)) return far;
  double near = 0.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (near + far);
    (inside(middle) ? near : far) = middle;
  }
  return near;
}

/// Polar around the principal point. The azimuths are split at the image's corners, where the edge's distance has its kinks.
std::vector<Correspondence> sample_polar(const CameraModel& source, const Domain& domain, const Pixel& centre, int count) {
  const double width = domain.size.width - 1.0;
  const double height = domain.size.height - 1.0;
  std::array<double, 5> kinks{};
  const std::array<Pixel, 4> corners = {{{width, height}, {0.0, height}, {0.0, 0.0}, {width, 0.0}}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    kinks[i] = std::atan2(corners[i][1] - centre[1], corners[i][0] - centre[0]);
    if (i > 0 && kinks[i] < kinks[i - 1]) kinks[i] += 2.0 * std::numbers::pi;
  }
  kinks[4] = kinks[0] + 2.0 * std::numbers::pi;

  constexpr int kRadii = 10;
  const std::vector<Node> radii = gauss_legendre(kRadii);
  const std::vector<Node> azimuths = gauss_legendre(std::max(3, count / (4 * kRadii)));
  std::vector<Correspondence> samples;
  for (std::size_t side = 0; side + 1 < kinks.size(); ++side) {
    const double span = kinks[side + 1] - kinks[side];
    for (const Node& azimuth : azimuths) {
      const double phi = kinks[side] + azimuth.position * span;
      const Pixel direction = {std::cos(phi), std::sin(phi)};
      const double edge = reach(source, domain, centre, direction);
      for (const Node& radius : radii) {
        const double distance = radius.position * edge;
        add_if_seen(source, domain, {centre[0] + distance * direction[0], centre[1] + distance * direction[1]},
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
