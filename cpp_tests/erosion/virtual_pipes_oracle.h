// A slow, plain virtual-pipe step to hold the fast one against: absolute heights, four loops over
// the map, no tiles, no padding, no carried rounding. It covers even rain, evaporation, sea, walls,
// the stream-power capacity and one rock; no slippage.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "erosion/virtual_pipes.h"

namespace orogen {

class PipeOracle {
 public:
  PipeOracle(const Raster<float>& elevation, const PipeParameters& parameters, double dt)
      : p_(parameters),
        dt_(dt),
        nx_(elevation.grid().nx),
        ny_(elevation.grid().ny),
        cell_(elevation.grid().cell_size) {
    const std::size_t n = elevation.size();
    for (auto* v : {&sediment, &wear, &depth, &suspended, &flux_x_, &flux_y_}) v->assign(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      sea_.push_back(!(elevation[i] > 0.0f));
      first_.push_back(sea_[i] ? 0.0 : double(elevation[i]));
    }
  }

  void step() {
    pressures();
    limit();
    move();
  }

  std::vector<double> sediment, wear, depth, suspended;

 private:
  std::size_t at(int r, int c) const { return std::size_t(r) * std::size_t(nx_) + std::size_t(c); }
  double bed(std::size_t i) const { return first_[i] + sediment[i] - wear[i]; }

  double pushed(double old, std::size_t a, std::size_t b) const {
    const double ha = bed(a) + depth[a], hb = bed(b) + depth[b];
    const double d = std::max(std::max(ha, hb) - std::max(bed(a), bed(b)), 1e-6);
    const double r = old + dt_ * p_.gravity * p_.pipe_depth * (ha - hb) / cell_;
    const double k = dt_ * p_.drag_coefficient * p_.pipe_depth / (d * d * d);
    return 2.0 * r / (1.0 + std::sqrt(1.0 + 4.0 * k * std::abs(r)));
  }

  void pressures() {
    for (int r = 0; r < ny_; ++r)
      for (int c = 0; c < nx_; ++c) {
        const std::size_t i = at(r, c);
        if (c + 1 < nx_) flux_x_[i] = pushed(flux_x_[i], i, at(r, c + 1));
        if (r + 1 < ny_) flux_y_[i] = pushed(flux_y_[i], i, at(r + 1, c));
      }
  }

  double west(int r, int c) const { return c > 0 ? flux_x_[at(r, c - 1)] : 0.0; }
  double south(int r, int c) const { return r > 0 ? flux_y_[at(r - 1, c)] : 0.0; }

  void limit() {
    std::vector<double> scale(depth.size());
    for (int r = 0; r < ny_; ++r)
      for (int c = 0; c < nx_; ++c) {
        const std::size_t i = at(r, c);
        const double out = std::max(-west(r, c), 0.0) + std::max(flux_x_[i], 0.0) +
                           std::max(-south(r, c), 0.0) + std::max(flux_y_[i], 0.0);
        const double have = (1.0 - 0x1.0p-20) * depth[i];
        scale[i] = out * dt_ / cell_ > have ? have / (out * dt_ / cell_) : 1.0;
      }
    for (int r = 0; r < ny_; ++r)
      for (int c = 0; c < nx_; ++c) {
        const std::size_t i = at(r, c);
        if (c + 1 < nx_) flux_x_[i] *= scale[flux_x_[i] > 0 ? i : at(r, c + 1)];
        if (r + 1 < ny_) flux_y_[i] *= scale[flux_y_[i] > 0 ? i : at(r + 1, c)];
      }
  }

  void move() {
    const std::vector<double> old_sediment = sediment, old_wear = wear, d = depth, s = suspended;
    const auto old_bed = [&](int r, int c) {
      const std::size_t i = at(std::clamp(r, 0, ny_ - 1), std::clamp(c, 0, nx_ - 1));
      return first_[i] + old_sediment[i] - old_wear[i];
    };
    const auto carried = [&](double q, std::size_t from, std::size_t to) {
      const std::size_t up = q > 0 ? from : to;
      return d[up] > 0 ? q * s[up] / d[up] : 0.0;
    };
    for (int r = 0; r < ny_; ++r)
      for (int c = 0; c < nx_; ++c) {
        const std::size_t i = at(r, c);
        const double qw = west(r, c), qe = flux_x_[i], qs = south(r, c), qn = flux_y_[i];
        double water = d[i] + dt_ / cell_ * (qw - qe + qs - qn), load = s[i];
        if (c > 0) load += dt_ / cell_ * carried(qw, at(r, c - 1), i);
        if (r > 0) load += dt_ / cell_ * carried(qs, at(r - 1, c), i);
        if (c + 1 < nx_) load -= dt_ / cell_ * carried(qe, i, at(r, c + 1));
        if (r + 1 < ny_) load -= dt_ / cell_ * carried(qn, i, at(r + 1, c));
        const double b = old_bed(r, c);
        const double around[] = {old_bed(r, c - 1), old_bed(r, c + 1), old_bed(r - 1, c),
                                 old_bed(r + 1, c)};
        const double lowest = *std::min_element(around, around + 4);
        const double highest = *std::max_element(around, around + 4);
        const double slope = std::hypot(around[1] - around[0], around[3] - around[2]) / (2 * cell_);
        const double q = std::hypot(0.5 * (qw + qe), 0.5 * (qs + qn));
        const double capacity =
            p_.sediment_capacity * std::sqrt(q) * std::clamp(slope, p_.min_slope, p_.max_slope);
        if (sea_[i]) {
          depth[i] = suspended[i] = 0.0;
          continue;
        }
        exchange(i, capacity, 0.5 * std::max(0.0, b - lowest - 1e-4 * cell_),
                 0.5 * std::max(0.0, highest - b) + water, load);
        water *= std::exp(-p_.evaporation_rate * dt_);
        depth[i] = water + p_.rain_rate_mm_per_h / 3.6e6 * dt_;
        suspended[i] = load;
      }
  }

  void exchange(std::size_t i, double capacity, double down, double up, double& load) {
    const auto share = [&](double rate) { return 1.0 - std::exp(-rate * dt_); };
    const double deficit = capacity - load;
    if (deficit > 0) {
      const double k = share(p_.sediment_dissolution_rate);
      const double loose = std::min({sediment[i], k * deficit, down});
      const double rock =
          std::min(share(p_.rock_dissolution_rate) * (deficit - loose / k), down - loose);
      sediment[i] -= loose;
      wear[i] += rock;
      load += loose + rock;
    } else {
      const double laid = std::min(share(p_.deposition_rate) * -deficit, up);
      sediment[i] += laid;
      load -= laid;
    }
  }

  PipeParameters p_;
  double dt_;
  int nx_, ny_;
  double cell_;
  std::vector<char> sea_;
  std::vector<double> first_, flux_x_, flux_y_;
};

}  // namespace orogen
