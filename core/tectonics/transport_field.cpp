#include "tectonics/transport_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "foundation/power.h"
#include "foundation/simd.h"

namespace orogen {

namespace {

constexpr int kMost = TransportField::Patch::kMost;
constexpr double kNoDistance2 = 1e-30;  // m², on the border
constexpr double kAllWeight =
    0x1p500;  // of a hull that holds the place: the others round to nothing

using Lane = std::array<double, kMost>;

// Of one hull, at places of a row.
struct Nearest {
  Lane rest_x, rest_y;  // p − π, m
  Lane squared;         // m²
  Lane outside;         // > 0: to the right of some side
};

struct Sums {
  Lane x, y, weight;
};

template <class Side>
[[gnu::always_inline]] inline void meet_side(const Side& s, const double* x, double y,
                                             Nearest& near, int n) {
  const double ry = y - s.ay;
  for (int j = 0; j < n; ++j) {
    const double rx = x[j] - s.ax;
    double t = (rx * s.ex + ry * s.ey) * s.per_length2;
    t = t < 0.0 ? 0.0 : t;
    t = t > 1.0 ? 1.0 : t;
    const double fx = rx - t * s.ex, fy = ry - t * s.ey;
    const double squared = fx * fx + fy * fy, right = s.ey * rx - s.ex * ry;
    const bool nearer = squared < near.squared[j];
    near.rest_x[j] = nearer ? fx : near.rest_x[j];
    near.rest_y[j] = nearer ? fy : near.rest_y[j];
    near.squared[j] = nearer ? squared : near.squared[j];
    near.outside[j] = right > near.outside[j] ? right : near.outside[j];
  }
}

template <class Hull>
[[gnu::always_inline]] inline void add_hull(const Hull& h, double exponent, const double* x,
                                            double y, const Nearest& near, Sums& sums, int n) {
  for (int j = 0; j < n; ++j) {
    const double beyond = near.outside[j] > 0.0 ? near.squared[j] : 0.0;
    const double squared = beyond > kNoDistance2 ? beyond : kNoDistance2;
    const double power = positive_power(squared, exponent);
    const double weight = beyond > kNoDistance2 ? power : kAllWeight;
    const double px = x[j] - (beyond > kNoDistance2 ? near.rest_x[j] : 0.0);
    const double py = y - (beyond > kNoDistance2 ? near.rest_y[j] : 0.0);
    sums.x[j] += weight * (h.cos_minus_1 * px + h.sine * py + h.shift_x);
    sums.y[j] += weight * (h.cos_minus_1 * py - h.sine * px + h.shift_y);
    sums.weight[j] += weight;
  }
}

template <class Hull, class Side>
[[gnu::always_inline]] inline void meet_sides(const Hull& hull, const Side* begin, const Side* end,
                                              const double* x, double y, Nearest& near, int n) {
  near.squared.fill(std::numeric_limits<double>::infinity());
  near.outside.fill(hull.has_inside ? -1.0 : 1.0);
  near.rest_x.fill(0.0);
  near.rest_y.fill(0.0);
  for (const Side* s = begin; s != end; ++s) meet_side(*s, x, y, near, n);
}

template <class Hull, class Side>
OROGEN_CLONES void act(const Hull& hull, const Side* begin, const Side* end, double exponent,
                       const double* x, double y, Sums& sums, int n) {
  Nearest near;
  meet_sides(hull, begin, end, x, y, near, n);
  add_hull(hull, exponent, x, y, near, sums, n);
}

template <class Hull, class Side>
OROGEN_CLONES void compete(const Hull& hull, const Side* begin, const Side* end, const double* x,
                           double y, std::int32_t number, double* best, std::int32_t* plate,
                           int n) {
  Nearest near;
  meet_sides(hull, begin, end, x, y, near, n);
  for (int j = 0; j < n; ++j) {
    const double squared = near.outside[j] > 0.0 ? near.squared[j] : 0.0;
    plate[j] = squared < best[j] ? number : plate[j];
    best[j] = squared < best[j] ? squared : best[j];
  }
}

OROGEN_CLONES void finish(const Sums& sums, const double* x, double y, double* from_x,
                          double* from_y, int n) {
  for (int j = 0; j < n; ++j) {
    from_x[j] = x[j] + sums.x[j] / sums.weight[j];
    from_y[j] = y + sums.y[j] / sums.weight[j];
  }
}

}  // namespace

TransportField::TransportField(std::vector<RigidPlate> plates,
                               const TransportParameters& parameters)
    : plates_(std::move(plates)), falloff_exponent_(parameters.falloff_exponent) {
  check_parameters(parameters, "transport");
  for (const RigidPlate& plate : plates_) {
    const Ring& ring = plate.moved_hull;
    const RigidMotion& m = plate.motion;
    const glm::dvec2 shift = m.inverse({0.0, 0.0});
    Hull hull{{}, ring.size() > 2, m.cosine - 1.0, m.sine, shift.x, shift.y};
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const glm::dvec2 a = ring[k], e = ring[(k + 1) % ring.size()] - a;
      const double squared = e.x * e.x + e.y * e.y;
      hull.sides.push_back({a.x, a.y, e.x, e.y, squared > 0.0 ? 1.0 / squared : 0.0});
    }
    hulls_.push_back(std::move(hull));
  }
}

glm::dvec2 TransportField::inverse(glm::dvec2 p) const {
  glm::dvec2 from;
  Patch(*this, p, 0.0).inverse(&p.x, p.y, &from.x, &from.y, 1);
  return from;
}

glm::dvec2 TransportField::plate_displacement(int i, glm::dvec2 p) const {
  const glm::dvec2 projection = nearest_on_hull(plates_[i].moved_hull, p);
  return projection - plates_[i].motion.inverse(projection);
}

int TransportField::nearest_plate(glm::dvec2 p) const {
  int nearest = -1;
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < int(plates_.size()); ++i)
    if (const double d = distance(i, p); d < best) {
      best = d;
      nearest = i;
    }
  return nearest;
}

TransportField::Patch::Patch(const TransportField& field, glm::dvec2 center, double radius)
    : field_(&field) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < field.hulls_.size(); ++i) {
    const Hull& hull = field.hulls_[i];
    const glm::dvec2 foot = nearest_on_hull(field.plates_[i].moved_hull, center);
    const double distance = std::hypot(center.x - foot.x, center.y - foot.y);
    const double size = std::fabs(center.x) + std::fabs(center.y) + distance;
    const double reach = radius + 1e-9 * (radius + size);  // more than rounding
    const int begin = int(sides_.size());
    for (const Side& s : hull.sides) {
      const double rx = foot.x - s.ax, ry = foot.y - s.ay;
      const double t = std::clamp((rx * s.ex + ry * s.ey) * s.per_length2, 0.0, 1.0);
      const double dx = rx - t * s.ex, dy = ry - t * s.ey;
      if (dx * dx + dy * dy <= reach * reach) sides_.push_back(s);
    }
    if (begin == int(sides_.size())) within_ = &hull;
    parts_.push_back({&hull, begin, int(sides_.size()), distance});
    least = std::min(least, distance + reach);
  }
  for (std::size_t i = 0; i < parts_.size(); ++i)
    if (parts_[i].distance <= least + 1.01 * radius) nearest_.push_back(int(i));
}

void TransportField::Patch::inverse(const double* x, double y, double* from_x, double* from_y,
                                    int n) const {
  if (within_ || parts_.empty()) {
    const Hull still{{}, true, 0.0, 0.0, 0.0, 0.0};
    const Hull& h = within_ ? *within_ : still;
    for (int j = 0; j < n; ++j) {
      from_x[j] = x[j] + (h.cos_minus_1 * x[j] + h.sine * y + h.shift_x);
      from_y[j] = y + (h.cos_minus_1 * y - h.sine * x[j] + h.shift_y);
    }
    return;
  }
  Sums sums{};
  for (const Part& part : parts_)
    act(*part.hull, sides_.data() + part.begin, sides_.data() + part.end,
        -0.5 * field_->falloff_exponent_, x, y, sums, n);
  finish(sums, x, y, from_x, from_y, n);
}

void TransportField::Patch::nearest_plate(const double* x, double y, std::int32_t* plate,
                                          int n) const {
  std::fill_n(plate, n, nearest_.empty() ? -1 : nearest_.front());
  if (nearest_.size() < 2) return;
  Lane best;
  best.fill(std::numeric_limits<double>::infinity());
  for (const int i : nearest_)
    compete(*parts_[i].hull, sides_.data() + parts_[i].begin, sides_.data() + parts_[i].end, x, y,
            i, best.data(), plate, n);
}

}  // namespace orogen
