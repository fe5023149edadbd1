#include "erosion/mountain_growth.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "erosion/growing_tin.h"
#include "foundation/errors.h"
#include "foundation/kept.h"
#include "foundation/parallel.h"
#include "foundation/tin_sampling.h"

namespace orogen {

namespace {

/// A stretch of steps alike on one mesh in one phase.
struct Stretch {
  int level;  // 0: the finest mesh
  std::size_t phase;
  double begin, end;  // yr
  int steps;
};

/// When each mesh takes over: level L runs from times[L + 1] to times[L].
std::vector<double> level_times(double years, int levels, double fine_share) {
  std::vector<double> times{years};
  const double coarse = levels > 0 ? years * (1.0 - fine_share) : 0.0;
  for (int level = 0; level <= levels; ++level)
    times.push_back(levels > 0 ? coarse * double(levels - level) / levels : 0.0);
  return times;
}

/// Steps of a coarser mesh are twice as long as those of the next.
std::vector<Stretch> schedule(const std::vector<UpliftPhase>& phases,
                              const MountainGrowthParameters& parameters, int levels) {
  double years = 0.0;
  for (const UpliftPhase& phase : phases) years += phase.years;
  const std::vector<double> times = level_times(years, levels, parameters.fine_share);
  const double fine_step = (times[0] - times[1]) / parameters.steps;
  std::vector<Stretch> stretches;
  for (int level = levels; level >= 0; --level) {
    double begin = 0.0;
    for (std::size_t p = 0; p < phases.size(); ++p) {
      const double end = begin + phases[p].years;
      const double from = std::max(begin, times[level + 1]), to = std::min(end, times[level]);
      if (to - from > 1e-9 * years) {
        const double step = fine_step * double(1 << level);
        stretches.push_back(
            {level, p, from, to, std::max(1, int(std::ceil((to - from) / step - 1e-9)))});
      }
      begin = end;
    }
  }
  return stretches;
}

void check_input(const MountainGrowthInput& input, const MountainGrowthParameters& parameters) {
  const auto closed = [](MapSide side) { return side == MapSide::Closed; };
  if (closed(parameters.west_side) && closed(parameters.east_side) &&
      closed(parameters.south_side) && closed(parameters.north_side) && !input.sea)
    throw InputError(
        "west_side, east_side, south_side, north_side: all are closed; water must leave by one");
  const Grid& grid = input.horizons.grid();
  if (input.sea && input.sea->grid() != grid)
    throw InputError("sea: must lie on the terrain's grid");
  if (input.sea && std::ranges::all_of(input.sea->values(), [](auto v) { return v != 0; }))
    throw InputError("sea: is everywhere; nothing can grow");
  for (const auto& [name, raster] : {std::pair{"rain", input.rain},
                                     {"uplift_factor", input.uplift_factor},
                                     {"erodibility_factor", input.erodibility_factor}})
    if (raster && raster->grid() != grid)
      throw InputError(std::string(name) + ": must lie on the terrain's grid");
  if (input.phases.empty()) throw InputError("phases: at least one is wanted");
  for (const UpliftPhase& phase : input.phases) {
    if (!(phase.years > 0.0 && std::isfinite(phase.years)))
      throw InputError("phases: their years must be above 0");
    if (!phase.crust || int(phase.folds.size()) != input.rocks.layers())
      throw InputError("phases: the crust's uplift and that of each layer's folds are wanted");
  }
}

std::size_t bytes_of(const Tin& tin) {
  return tin.points.size() * (sizeof(glm::dvec2) + sizeof(double) + 5) +
         tin.triangles.size() * sizeof(tin.triangles[0]) + tin.neighbors.size() * 8;
}

class Growth {
 public:
  Growth(const MountainGrowthInput& input, const MountainGrowthParameters& parameters,
         std::uint32_t seed, Context& context)
      : input_(input), parameters_(parameters), seed_(seed), context_(context) {
    const Grid& grid = input.horizons.grid();
    domain_ = {grid.origin, {grid.width(), grid.height()}};
    vertices_ = std::max(16.0, parameters.vertices_per_cell * double(grid.size()));
  }

  void run() {
    const auto stretches = schedule(input_.phases, parameters_, levels());
    double all_cost = 0.0, done = 0.0;
    for (const Stretch& s : stretches) all_cost += cost(s);
    years_ = stretches.back().end;
    for (const Stretch& s : stretches) {
      enter(s);
      for (int i = 0; i < s.steps; ++i) {
        balance_ += mesh_->step((s.end - s.begin) / s.steps, context_);
        done += cost(s) / s.steps;
        context_.report(0.98 * done / all_cost);
        const double now = s.begin + (s.end - s.begin) * (i + 1) / s.steps;
        keep_frame(now);
        show(now);
      }
    }
    mesh_->carry(context_);
  }

  MountainGrowth result() {
    const Grid& grid = input_.horizons.grid();
    const std::vector<double> rates = mesh_->uplift_rates(context_);
    const std::vector<double> sediment = mesh_->sediment_thickness();
    std::vector<VertexField> wanted{mesh_->elevation(), rates, mesh_->drainage_area()};
    if (!sediment.empty()) wanted.push_back(sediment);
    GroundSample sampled = mesh_->sample(grid, wanted, context_);
    MountainGrowth made;
    made.elevation = std::move(sampled.fields[0]);
    made.uplift_rate = std::move(sampled.fields[1]);
    made.drainage_area = std::move(sampled.fields[2]);
    if (!sediment.empty()) made.sediment_thickness = std::move(sampled.fields[3]);
    made.horizons = std::move(sampled.horizons);
    add_cover(made);
    made.frames = std::move(frames_);
    made.years = years_;
    made.balance = balance_;
    made.tin = {mesh_->tin(), mesh_->elevation(), mesh_->sediment_thickness()};
    return made;
  }

 private:
  /// Work of a stretch, in vertex steps.
  static double cost(const Stretch& s) { return s.steps * std::pow(0.25, s.level); }

  /// A mesh of 2^level times the finest one's spacing.
  std::shared_ptr<const Tin> mesh_of(int level) const {
    const auto& [origin, size] = domain_;
    const Kept::Key key("growth mesh", int(parameters_.mesh), origin.x, origin.y, size.x, size.y,
                        vertices_, level, seed_);
    return kept(
        context_, key, [&] { return make_mesh(level); }, bytes_of);
  }

  Tin make_mesh(int level) const {
    const double coarsening = double(1 << level);
    const double spacing = spacing_for(domain_, vertices_) * coarsening;
    const std::uint32_t seed = seed_ + std::uint32_t(level);
    switch (parameters_.mesh) {
      case GrowthMesh::Jittered:
        return jittered_tin(domain_, spacing, seed, context_);
      case GrowthMesh::PoissonDisc:
        return poisson_tin(domain_, spacing, seed, context_);
      case GrowthMesh::Grid:
        break;
    }
    const double cell = std::sqrt(domain_.area() / vertices_) * coarsening;
    const auto cells = [&](double length) { return std::max(2, int(std::lround(length / cell))); };
    return grid_tin(domain_, cells(domain_.size.x), cells(domain_.size.y));
  }

  /// Makes the stretch's mesh the one that grows, with its phase's rates.
  void enter(const Stretch& s) {
    if (!mesh_ || s.level != level_) {
      auto next = std::make_unique<GrowingTin>(mesh_of(s.level), input_, parameters_);
      if (mesh_)
        next->take_over(*mesh_, context_);
      else
        next->begin(seed_, context_);
      mesh_ = std::move(next);
      level_ = s.level;
      balance_ = {};
    }
    mesh_->set_phase(input_.phases[s.phase], context_);
  }

  /// What lies above the highest horizon, where no thickness of what rivers laid down is known; and
  /// the rock that is gone.
  void add_cover(MountainGrowth& made) {
    const Grid& grid = made.elevation.grid();
    const Raster<float>& top = made.horizons.heights.back();
    made.exhumation = Raster<float>(grid);
    const bool laid_down = !made.sediment_thickness.empty();
    if (!laid_down) made.sediment_thickness = Raster<float>(grid);
    for (std::size_t i = 0; i < grid.size(); ++i) {
      float& loose = made.sediment_thickness[i];
      const float above = made.elevation[i] - loose - top[i];
      made.exhumation[i] = std::max(-above, 0.0f);
      if (!laid_down) loose = above;
      if (!(loose > kSedimentGap)) loose = 0.0f;
    }
  }

  int levels() const { return parameters_.frames > 0 ? 0 : parameters_.coarse_levels; }

  void keep_frame(double now) {
    const double due = years_ * double(frames_.size() + 1) / parameters_.frames;
    if (parameters_.frames == 0 || now < due * (1.0 - 1e-9)) return;
    if (now >= years_ * (1.0 - 1e-9)) mesh_->carry(context_);
    const Grid& grid = input_.horizons.grid();
    const std::vector<double> thickness = mesh_->sediment_thickness();
    std::vector<VertexField> wanted{mesh_->elevation()};
    if (!thickness.empty()) wanted.push_back(thickness);
    GroundSample sampled = mesh_->sample(grid, wanted, context_);
    GrowthFrame frame{now, std::move(sampled.fields[0]), Raster<std::int32_t>(grid)};
    const HorizonStack& horizons = sampled.horizons;
    const Raster<float> sediment =
        thickness.empty() ? Raster<float>() : std::move(sampled.fields[1]);
    parallel_rows(context_, grid.ny, [&](int r) {
      std::vector<float> h(horizons.heights.size());
      for (std::size_t i = grid.index(r, 0); i < grid.index(r, 0) + grid.nx; ++i) {
        for (std::size_t k = 0; k < h.size(); ++k) h[k] = horizons.heights[k][i];
        const bool hidden = !sediment.empty() && sediment[i] >= kHidingSediment;
        const float top = sediment.empty() ? frame.elevation[i] : frame.elevation[i] - sediment[i];
        frame.rock[i] = input_.rocks.number(hidden ? loose_sediment(input_.rocks)
                                                   : input_.rocks.rock_at(h.data(), top));
      }
    });
    frames_.push_back(std::move(frame));
  }

  void show(double now) {
    if (!input_.watch || !input_.watch->due()) return;
    const Grid grid = GrowthWatch::grid(input_.horizons.grid());
    input_.watch->show(now, {sample_to_grid(mesh_->tin(), mesh_->elevation(), grid, context_)});
    context_.check();
  }

  const MountainGrowthInput& input_;
  const MountainGrowthParameters& parameters_;
  std::uint32_t seed_;
  Context& context_;
  TinDomain domain_;
  double vertices_ = 0.0, years_ = 0.0;  // vertices of the finest mesh, about
  int level_ = -1;
  std::vector<GrowthFrame> frames_;
  std::unique_ptr<GrowingTin> mesh_;
  MassBalance balance_;
};

}  // namespace

MountainGrowth grow_mountains(const MountainGrowthInput& input,
                              const MountainGrowthParameters& parameters, std::uint32_t seed,
                              Context& context) {
  check_parameters(parameters);
  check_input(input, parameters);
  Growth growth(input, parameters, seed, context);
  growth.run();
  return growth.result();
}

const StageInfo& mountain_growth_stage() {
  static const StageInfo info{
      "mountain_growth",
      "Grows mountains by uplift and folds while rivers cut into the rock that comes to light.",
      "Cordonnier et al. 2018, section 6",
      {"crust_uplift_rate", "fold_uplift_rate"},
      {"elevation", "uplift_rate", "drainage_area", "exhumation", "sediment_thickness"},
      {"column", "rain", "rasters.uplift_factor", "rasters.erodibility_factor"},
      {"land"}};
  return info;
}

}  // namespace orogen
