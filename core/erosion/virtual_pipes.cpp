#include "erosion/virtual_pipes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "erosion/slippage_sweep.h"
#include "erosion/virtual_pipes_state.h"
#include "foundation/errors.h"
#include "foundation/parallel.h"
#include "foundation/resample.h"
#include "foundation/units.h"

namespace orogen {

const StageInfo& hydraulic_erosion_stage() {
  static const StageInfo info{
      "hydraulic_erosion",
      "Running water wears gullies, carries sediment and lays it down as fans and valley floors.",
      "Stava et al. 2008, Interactive terrain modeling using hydraulic erosion; Mei et al. 2007",
      {"elevation", "land"},
      {"elevation", "land", "wear", "deposition", "sediment_thickness"},
      {"river_sources"},
      {"moisture", "temperature"}};
  return info;
}

double stable_time_step(double cell_size, const PipeParameters& p) {
  const double celerity = std::sqrt(2.0 * p.gravity * p.pipe_depth);
  return celerity > 0.0 ? 0.7 * cell_size / celerity : 1e5;
}

namespace {

using pipes::PipeState;

constexpr double kCourant = 1.0 / 0.7;  // a given step may be this much longer than the chosen one
constexpr int kMaxSweeps = 20000;       // of the last slippage
constexpr int kSiltingInterval = 16;    // steps

template <class T, class Bad>
void check_raster(const Raster<T>* raster, const Grid& grid, const char* name, const char* allowed,
                  Bad&& bad) {
  if (!raster) return;
  if (raster->grid() != grid)
    throw InputError(std::string(name) + ": its grid differs from the elevation's");
  for (std::size_t i = 0; i < raster->size(); ++i)
    if (bad(double((*raster)[i])))
      throw InputError(std::string(name) + ": row " + std::to_string(i / grid.nx) + ", column " +
                       std::to_string(i % grid.nx) + " holds " + std::to_string((*raster)[i]) +
                       "; allowed is " + allowed);
}

void check_sources(const Raster<float>& elevation, const PipeForcing& forcing) {
  const Grid& grid = elevation.grid();
  for (std::size_t k = 0; k < forcing.sources.size(); ++k) {
    const RiverSource& source = forcing.sources[k];
    const std::string name = "sources[" + std::to_string(k) + "]";
    const int row = grid.row_of(source.position.y), column = grid.column_of(source.position.x);
    if (!grid.contains(row, column))
      throw InputError(name + ": (" + std::to_string(source.position.x) + ", " +
                       std::to_string(source.position.y) + ") lies outside the elevation's grid");
    check_parameters(source, name);
    const bool land =
        forcing.land ? (*forcing.land)(row, column) != 0 : elevation(row, column) > 0.0f;
    if (!land) throw InputError(name + ": it lies in the sea");
  }
}

void check_input(const Raster<float>& elevation, const PipeForcing& forcing,
                 const PipeParameters& p) {
  const Grid& grid = elevation.grid();
  if (elevation.empty()) throw InputError("elevation: it has no cells");
  if (!(grid.cell_size > 0.0 && std::isfinite(grid.cell_size)))
    throw InputError("elevation: its cell size must be above 0 m");
  check_parameters(p, "hydraulic_erosion");
  if (p.min_slope > p.max_slope)
    throw InputError("hydraulic_erosion.min_slope: it is above max_slope");
  const double longest = kCourant * stable_time_step(grid.cell_size, p);
  if (p.time_step > longest)
    throw InputError("hydraulic_erosion.time_step: " + std::to_string(p.time_step) +
                     " s is unstable; up to " + std::to_string(longest) +
                     " s is allowed at this cell size and pipe_depth");
  const auto in = [](double low, double high) {
    return [=](double v) { return !(v >= low && v <= high); };
  };
  check_raster(&elevation, grid, "elevation", "-1e5 to 1e5 m", in(-1e5, 1e5));
  check_raster(forcing.moisture, grid, "moisture", "0 to 1", in(0.0, 1.0));
  check_raster(forcing.temperature, grid, "temperature", "0 to 1", in(0.0, 1.0));
  check_raster(forcing.sediment_thickness, grid, "sediment_thickness", "0 to 1e5 m", in(0.0, 1e5));
  check_raster(forcing.water_depth, grid, "water_depth", "0 to 1e5 m", in(0.0, 1e5));
  check_raster(forcing.erodibility, grid, "erodibility", "0 to 1e9", in(0.0, 1e9));
  check_raster(forcing.land, grid, "land", "0 to 255", in(0.0, 255.0));
  check_raster(forcing.pinned, grid, "pinned", "0 to 255", in(0.0, 255.0));
  check_rock_layers(forcing.layers, grid);
  check_sources(elevation, forcing);
}

/// The slippage that goes with a run.
template <class Real>
class RunSlippage {
 public:
  RunSlippage(PipeState<Real>& state, const PipeForcing& forcing, const PipeParameters& p)
      : s_(state), slider_(state.tiles.size()) {
    tan_repose_ = std::tan(radians(p.sediment_talus_angle_deg));
    bool breaks = false;
    const auto add = [&](double degrees) {
      tan_rock_.push_back(degrees < 90.0 ? std::tan(radians(degrees)) : 1e30);
      breaks |= degrees < 90.0;
    };
    for (const RockLayer& layer : forcing.layers) add(layer.talus_angle_deg);
    add(p.rock_talus_angle_deg);
    if (!breaks) tan_rock_.clear();
  }

  void sweep(const Context& context) {
    if (!tan_rock_.empty()) {
      pipes::loosen_rock(field(), s_.layer, tan_rock_, s_.sediment.now, s_.sediment.next,
                         s_.wear.next, context);
      s_.sediment.now.swap(s_.sediment.next);
      s_.wear.now.swap(s_.wear.next);
    }
    slider_.wake(s_.tiles.size());
    slider_.sweep(field(), s_.sediment.now, s_.sediment.next, context);
  }

  /// Returns the slope above repose that is left.
  double settle(const Context& context) {
    slider_.wake(s_.tiles.size());
    slider_.settle(field(), s_.sediment.now, s_.sediment.next, kMaxSweeps, context);
    return pipes::steepest_excess(field(), s_.sediment.now, context);
  }

  double exported() const { return slider_.exported(); }

 private:
  pipes::SlideField<Real> field() const {
    return {s_.shape,       &s_.tiles,    s_.base.data(), s_.wear.now.data(),
            s_.code.data(), s_.cell_size, tan_repose_};
  }

  PipeState<Real>& s_;
  pipes::Slider<Real> slider_;
  double tan_repose_;
  std::vector<double> tan_rock_;
};

/// Sum over the map's cells of value(padded index), in double.
template <class Real, class Value>
double sum_cells(const PipeState<Real>& s, const Context& context, Value&& value) {
  return parallel_reduce(
      context, std::size_t(s.shape.ny), 16, 0.0,
      [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t r = begin; r < end; ++r) {
          const std::size_t first = s.shape.index(int(r), 0);
          for (int c = 0; c < s.shape.nx; ++c) sum += value(first + std::size_t(c));
        }
        return sum;
      },
      [](double a, double b) { return a + b; });
}

template <class Real>
double water_in(const PipeState<Real>& s, const Context& context) {
  return sum_cells(s, context,
                   [&](std::size_t i) { return double(s.depth.now[i]) + double(s.carry[i]); });
}

template <class Real>
double change_at(const PipeState<Real>& s, std::size_t i) {
  const double first = s.original_sediment.empty() ? 0.0 : double(s.original_sediment[i]);
  return (double(s.sediment.now[i]) - first) - double(s.wear.now[i]);
}

template <class Real>
void settle_suspended(PipeState<Real>& s) {
  for (std::size_t i = 0; i < s.code.size(); ++i) {
    if (!(s.code[i] >= 0)) continue;
    s.sediment.now[i] += s.suspended.now[i];
    s.suspended.now[i] = 0;
  }
}

template <class Real>
void fill_rasters(const PipeState<Real>& s, const Raster<float>& elevation, const Context& context,
                  PipeErosionResult& result) {
  const Grid& grid = elevation.grid();
  result.elevation = elevation;
  for (auto* raster :
       {&result.wear, &result.deposition, &result.sediment_thickness, &result.water_depth})
    *raster = Raster<float>(grid);
  parallel_rows(context, grid.ny, [&](int r) {
    for (int c = 0; c < grid.nx; ++c) {
      const std::size_t i = s.shape.index(r, c), j = grid.index(r, c);
      const bool sea = s.code[i] == Real(pipes::kSink);
      const double laid = sea && !s.sea_room.empty()
                              ? std::max(0.0, -double(elevation[j])) - double(s.sea_room[i])
                              : 0.0;
      const double change = sea ? laid : change_at(s, i);
      if (change != 0.0) result.elevation[j] = float(double(elevation[j]) + change);
      result.wear[j] = float(std::max(0.0, -change));
      result.deposition[j] = float(std::max(0.0, change));
      result.sediment_thickness[j] = float(double(s.sediment.now[i]) + laid);
      result.water_depth[j] = float(s.depth.now[i]);
    }
  });
}

template <class Real>
void show(const PipeState<Real>& s, const Raster<float>& elevation, double seconds,
          GrowthWatch& watch, Context& context) {
  PipeErosionResult now;
  fill_rasters(s, elevation, context, now);
  for (std::size_t i = 0; i < now.deposition.size(); ++i) now.deposition[i] -= now.wear[i];
  const Grid grid = GrowthWatch::grid(elevation.grid());
  const auto coarse = [&](const Raster<float>& fine) { return resample_mean(fine, grid, context); };
  watch.show(seconds / kSecondsPerYear,
             {coarse(now.elevation), coarse(now.water_depth), coarse(now.deposition)});
  context.check();
}

template <class Real>
void fill_balances(const PipeState<Real>& s, double first_water, double slid_out, double max_change,
                   const Context& context, PipeErosionResult& result) {
  const double area = s.cell_size * s.cell_size;
  pipes::TileSums all = s.sums_before;
  for (const pipes::TileSums& tile : s.sums) all.add(tile);
  const auto sum = [&](auto&& value) { return area * sum_cells(s, context, value); };
  MassBalance& water = result.water_balance;
  water.supplied_m3 = area * (all.rain + s.source_water);
  water.stored_m3 = area * (water_in(s, context) - first_water);
  result.evaporated_m3 = area * all.evaporated;
  water.exported_m3 = area * all.exported_water + result.evaporated_m3;
  water.residual_m3 = water.supplied_m3 - water.exported_m3 - water.stored_m3;

  MassBalance& solid = result.sediment_balance;
  solid.eroded_m3 = sum([&](std::size_t i) { return std::max(0.0, -change_at(s, i)); });
  solid.deposited_m3 = sum([&](std::size_t i) { return std::max(0.0, change_at(s, i)); });
  solid.stored_m3 = sum([&](std::size_t i) { return double(s.suspended.now[i]); });
  solid.exported_m3 = area * (all.exported_sediment + slid_out);
  solid.residual_m3 = solid.eroded_m3 - solid.deposited_m3 - solid.stored_m3 - solid.exported_m3;
  result.cells_at_max_change = std::int64_t(sum_cells(s, context, [&](std::size_t i) {
    return s.code[i] >= 0 && std::abs(change_at(s, i)) >= max_change * (1.0 - 1e-6) ? 1.0 : 0.0;
  }));
}

template <class Real>
void run_storm(const Raster<float>& elevation, const PipeForcing& forcing, const PipeParameters& p,
               Context& context, PipeErosionResult& result) {
  auto state = pipes::make_pipe_state<Real>(elevation, forcing, p, result.time_step);
  const double first_water = water_in(state, context);
  RunSlippage<Real> slippage(state, forcing, p);
  for (int step = 0; step < result.steps; ++step) {
    pipes::advance(state, step, context);
    if (p.slippage_interval > 0 && (step + 1) % p.slippage_interval == 0) slippage.sweep(context);
    if ((step + 1) % kSiltingInterval == 0) pipes::silt_up(state, elevation);
    context.report(0.95 * (step + 1) / result.steps);
    if (forcing.watch && forcing.watch->due())
      show(state, elevation, (step + 1) * result.time_step, *forcing.watch, context);
  }
  if (p.settle_at_end) settle_suspended(state);
  result.steepest_excess = slippage.settle(context);
  fill_balances(state, first_water, slippage.exported(), p.max_change, context, result);
  fill_rasters(state, elevation, context, result);
  context.report(1.0);
}

}  // namespace

template <class Real>
std::size_t pipe_erosion_memory(const Grid& grid) {
  const std::size_t padded = pipes::PaddedShape(grid.nx, grid.ny).size();
  // 12 fields that are read and written, 3 fixed ones, up to 4 optional ones, 5 results.
  return padded * sizeof(Real) * 19 + grid.size() * sizeof(float) * 5;
}

template <class Real>
PipeErosionResult erode_virtual_pipes(const Raster<float>& elevation, const PipeForcing& forcing,
                                      const PipeParameters& parameters, Context& context) {
  check_input(elevation, forcing, parameters);
  const double wanted = parameters.time_step > 0.0
                            ? parameters.time_step
                            : stable_time_step(elevation.grid().cell_size, parameters);
  const double steps = std::ceil(parameters.duration / wanted * (1.0 - 1e-9));
  if (steps > 1e7)
    throw InputError("hydraulic_erosion.duration: it takes " + std::to_string(steps) +
                     " steps; at most 1e7 are allowed");
  PipeErosionResult result;
  result.steps = int(steps);
  result.time_step = steps > 0.0 ? parameters.duration / steps : wanted;
  context.run([&] { run_storm<Real>(elevation, forcing, parameters, context, result); });
  return result;
}

#define OROGEN_VIRTUAL_PIPES(Real)                                                               \
  template std::size_t pipe_erosion_memory<Real>(const Grid&);                                   \
  template PipeErosionResult erode_virtual_pipes<Real>(const Raster<float>&, const PipeForcing&, \
                                                       const PipeParameters&, Context&);
OROGEN_VIRTUAL_PIPES(float)
OROGEN_VIRTUAL_PIPES(double)

}  // namespace orogen
