#include "hydrology/lower_envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "foundation/parallel.h"

namespace orogen {

namespace {

constexpr int kRounds = 8;
constexpr int kMostPanels = 8;
constexpr float kMuch = 1e-4f;   // relative, and
constexpr float kMuchM = 0.01f;  // in metres: a smaller fall does not ask for another round

struct State {
  Raster<float> height;
  Raster<std::int32_t> source;
  std::vector<char> changed;  // rows that fell much
};

class Envelope {
 public:
  Envelope(const Raster<float>& sources, const Raster<std::uint8_t>& domain,
           const Hillside& hillside)
      : sources_(sources),
        domain_(domain),
        steepness_(hillside.steepness),
        grid_(domain.grid()),
        slope_(float(hillside.slope * grid_.cell_size)),
        floor_(float(hillside.floor_width / grid_.cell_size)),
        per_panel_(float(grid_.cell_size / hillside.smooth_over)) {}

  State start(Raster<std::int32_t>& source, const Context& context) const {
    State state{Raster<float>(grid_), std::move(source), std::vector<char>(grid_.ny, 1)};
    parallel_rows(context, grid_.ny, [&](int r) {
      for (int c = 0; c < grid_.nx; ++c) {
        const std::size_t i = grid_.index(r, c);
        const std::int32_t s = state.source[i];
        state.height[i] = !domain_[i] ? 0.0f
                          : s < 0     ? std::numeric_limits<float>::infinity()
                                      : height_over(r, c, s);
      }
    });
    return state;
  }

  // Both sweeps start from the same state, so that they can run side by side.
  bool sweep_both_ways(State& state, const Context& context) const {
    State other = state;
    parallel_chunks(context, 2, 1, [&](std::size_t way, std::size_t) {
      sweep(way ? other : state, way == 0, context);
    });
    parallel_rows(context, grid_.ny, [&](int r) {
      state.changed[r] |= other.changed[r];
      if (!other.changed[r]) return;
      for (std::size_t i = grid_.index(r, 0), end = i + grid_.nx; i < end; ++i)
        if (other.height[i] < state.height[i]) {
          state.height[i] = other.height[i];
          state.source[i] = other.source[i];
        }
    });
    return std::any_of(state.changed.begin(), state.changed.end(), [](char c) { return c; });
  }

 private:
  float height_over(int r, int c, std::int32_t s) const {
    const int sr = int(std::uint32_t(s) / std::uint32_t(grid_.nx)), sc = s - sr * grid_.nx;
    const float dr = float(r - sr), dc = float(c - sc), d = std::sqrt(dr * dr + dc * dc);
    if (d == 0.0f) return sources_[s];
    const float rise = slope_ * d * (d / (d + floor_));
    return sources_[s] + (steepness_ ? rise * mean_steepness(r, c, sr, sc, d) : rise);
  }

  float mean_steepness(int r, int c, int sr, int sc, float d) const {
    const Raster<float>& n = *steepness_;
    const int panels = std::min(1 + int(d * per_panel_), kMostPanels);
    if (panels == 1) return (n(r, c) + n(sr, sc) + 4.0f * n((r + sr) / 2, (c + sc) / 2)) / 6.0f;
    const float step = 0.5f / float(panels), dr = float(r - sr), dc = float(c - sc);
    float sum = n(r, c) + n(sr, sc);
    for (int k = 1; k < 2 * panels; ++k) {
      const float t = float(k) * step;
      sum +=
          (k % 2 ? 4.0f : 2.0f) * n(int(float(sr) + t * dr + 0.5f), int(float(sc) + t * dc + 0.5f));
    }
    return sum / float(6 * panels);
  }

  bool offer(State& state, int r, int c, std::int32_t s) const {
    const std::size_t i = grid_.index(r, c);
    const float old = state.height[i];
    if (s == state.source[i] || s < 0) return false;
    const float h = height_over(r, c, s);
    if (!(h < old)) return false;
    state.height[i] = h;
    state.source[i] = s;
    return old - h > kMuch * old + kMuchM;
  }

  // Rows one after the other, northwards or southwards: each from the row before it, then along.
  void sweep(State& state, bool northwards, const Context& context) const {
    const std::vector<char> fell_before = std::exchange(state.changed, std::vector<char>(grid_.ny));
    for (int k = 0; k < grid_.ny; ++k) {
      if (k % 16 == 0) context.check();
      const int r = northwards ? k : grid_.ny - 1 - k, before = northwards ? r - 1 : r + 1;
      const bool from_before = k > 0 && (fell_before[before] || state.changed[before]);
      if (!from_before && !fell_before[r]) continue;
      const std::uint8_t* inside = domain_.row(r);
      bool fell = false;
      for (int c = 0; k > 0 && c < grid_.nx; ++c)
        for (int b = std::max(c - 1, 0); inside[c] && b <= std::min(c + 1, grid_.nx - 1); ++b)
          fell |= offer(state, r, c, state.source(before, b));
      for (int c = 1; c < grid_.nx; ++c)
        if (inside[c]) fell |= offer(state, r, c, state.source(r, c - 1));
      for (int c = grid_.nx - 2; c >= 0; --c)
        if (inside[c]) fell |= offer(state, r, c, state.source(r, c + 1));
      state.changed[r] = fell;
    }
  }

  const Raster<float>& sources_;
  const Raster<std::uint8_t>& domain_;
  const Raster<float>* steepness_;
  const Grid grid_;
  const float slope_, floor_;  // m per cell, cells
  const float per_panel_;      // panels per cell
};

}  // namespace

Raster<float> lower_envelope(const Raster<float>& source_height, const Raster<std::uint8_t>& domain,
                             Raster<std::int32_t>& source, const Hillside& hillside,
                             const Context& context) {
  const Envelope envelope(source_height, domain, hillside);
  State state = envelope.start(source, context);
  for (int round = 0; round < kRounds; ++round)
    if (!envelope.sweep_both_ways(state, context)) break;
  source = std::move(state.source);
  return std::move(state.height);
}

}  // namespace orogen
