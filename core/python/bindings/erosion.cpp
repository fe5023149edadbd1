// orogen.erosion: virtual pipes, slippage, stream power, hillslopes.
#include <pybind11/stl.h>

#include <cmath>

#include "arrays.h"
#include "erosion/hillslope.h"
#include "erosion/paper_b_setting.h"
#include "erosion/relief_growth.h"
#include "erosion/slippage.h"
#include "erosion/stream_power.h"
#include "erosion/virtual_pipes.h"
#include "foundation/units.h"
#include "interruptible.h"
#include "module.h"
#include "parameters.h"

namespace orogen::python {

namespace {

void bind_results(py::module_& room) {
  py::class_<MassBalance>(room, "MassBalance", "Volumes that a stage moved, in m3.")
      .def_readonly("eroded_m3", &MassBalance::eroded_m3)
      .def_readonly("deposited_m3", &MassBalance::deposited_m3)
      .def_readonly("exported_m3", &MassBalance::exported_m3)
      .def_readonly("supplied_m3", &MassBalance::supplied_m3)
      .def_readonly("stored_m3", &MassBalance::stored_m3)
      .def_readonly("residual_m3", &MassBalance::residual_m3)
      .def_property_readonly("relative_residual", &MassBalance::relative_residual);

  py::class_<PipeErosionResult> pipes(room, "PipeErosionResult", "What running water left.");
  raster_property(pipes, "elevation", &PipeErosionResult::elevation, "Height in metres.");
  raster_property(pipes, "wear", &PipeErosionResult::wear, "How far the ground fell, in metres.");
  raster_property(pipes, "deposition", &PipeErosionResult::deposition,
                  "How far the ground rose, in metres.");
  raster_property(pipes, "sediment_thickness", &PipeErosionResult::sediment_thickness,
                  "Loose sediment in metres.");
  raster_property(pipes, "water_depth", &PipeErosionResult::water_depth,
                  "Water at the end, in metres.");
  pipes.def_readonly("sediment_balance", &PipeErosionResult::sediment_balance)
      .def_readonly("water_balance", &PipeErosionResult::water_balance)
      .def_readonly("time_step", &PipeErosionResult::time_step, "In seconds, as taken.")
      .def_readonly("steps", &PipeErosionResult::steps);

  py::class_<SlippageResult> slippage(room, "SlippageResult", "What slid where.");
  raster_property(slippage, "elevation", &SlippageResult::elevation, "Rock + sediment in metres.");
  raster_property(slippage, "sediment_thickness", &SlippageResult::sediment_thickness,
                  "Loose sediment in metres.");
  slippage.def_readonly("sweeps", &SlippageResult::sweeps)
      .def_readonly("steepest_excess", &SlippageResult::steepest_excess,
                    "Slope above the angle of repose that is left.");
}

void bind_virtual_pipes(py::module_& room) {
  define(
      room,
      {.name = "erode_virtual_pipes",
       .summary = "Lets running water wear gullies, carry sediment and lay it down.",
       .arguments = {elevation_argument(),
                     cell_size_argument(),
                     {"land", "array (ny, nx) of bool or int, or None",
                      "0 at sea; default: where elevation is above 0.", "None"},
                     {"moisture", "array (ny, nx) of float, or None",
                      "From 0 to 1, scales rain; default 1.", "None"},
                     {"temperature", "array (ny, nx) of float, or None",
                      "From 0 to 1, scales evaporation; default 1.", "None"},
                     {"water_depth", "array (ny, nx) of float, or None",
                      "Water at the start in metres; default 0.", "None"},
                     {"sources", "sequence of (x, y, discharge)",
                      "Springs and rivers that enter: metres from the array's lower-left corner, "
                      "m3/s.",
                      "()"},
                     {"progress", "callable or None",
                      "Called as progress(stage, fraction); returning False cancels.", "None"},
                     threads_argument()},
       .parameters = describe_parameters<PipeParameters>(),
       .return_type = "PipeErosionResult",
       .returns = "The ground afterwards, and the balances of water and sediment.",
       .citation = std::string(hydraulic_erosion_stage().citation)},
      [](const py::object& elevation, double cell_size, const py::object& land,
         const py::object& moisture, const py::object& temperature, const py::object& water_depth,
         const std::vector<std::array<double, 3>>& sources, const py::object& progress, int threads,
         const py::kwargs& keywords) {
        const auto parameters = from_keywords<PipeParameters>(keywords);
        const auto z = to_raster<float>(elevation, "elevation", cell_size);
        Raster<std::uint8_t> mask;
        Raster<float> moist, warm, wet;
        PipeForcing forcing;
        if (!land.is_none()) {
          mask = to_mask(land, "land", z.grid());
          forcing.land = &mask;
        }
        const auto take = [&](const py::object& given, const char* name,
                              Raster<float>& kept) -> const Raster<float>* {
          if (given.is_none()) return nullptr;
          kept = to_raster<float>(given, name, z.grid());
          return &kept;
        };
        forcing.moisture = take(moisture, "moisture", moist);
        forcing.temperature = take(temperature, "temperature", warm);
        forcing.water_depth = take(water_depth, "water_depth", wet);
        for (const auto& [x, y, discharge] : sources)
          forcing.sources.push_back({{x, y}, discharge});
        std::optional<PipeErosionResult> result;
        run_interruptible(progress, threads, [&](Context& context) {
          context.begin_stage("hydraulic_erosion", 0.0, 1.0);
          context.run(
              [&] { result.emplace(erode_virtual_pipes<float>(z, forcing, parameters, context)); });
        });
        return std::move(*result);
      },
      py::arg("elevation"), py::arg("cell_size"), py::arg("land") = py::none(),
      py::arg("moisture") = py::none(), py::arg("temperature") = py::none(),
      py::arg("water_depth") = py::none(), py::arg("sources") = py::tuple(),
      py::arg("progress") = py::none(), py::arg("threads") = 0);
  define(
      room,
      {.name = "paper_b_setting",
       .summary = "Paper B's setting of hydraulic erosion in metres and seconds.",
       .arguments = {cell_size_argument(),
                     {"height_unit", "float", "What the paper's height of 1 is, in metres."},
                     {"units", "float", "Duration in units of the paper's time.", "10.0"}},
       .return_type = "dict",
       .returns = "Keyword arguments of `erode_virtual_pipes`.",
       .citation = "Weiss 2015, chapter VI"},
      [](double cell_size, double height_unit, double units) {
        py::dict setting;
        for (const auto& [name, value] :
             parameter_values(paper_b_setting(cell_size, height_unit, units)))
          setting[py::str(name)] = to_python(value);
        return setting;
      },
      py::arg("cell_size"), py::arg("height_unit"), py::arg("units") = 10.0);
}

void bind_slippage(py::module_& room) {
  define(
      room,
      {.name = "slip_sediment",
       .summary = "Lets loose sediment slide until it lies no steeper than its angle of repose.",
       .arguments = {{"rock_elevation", "array (ny, nx) of float32", "In metres."},
                     {"sediment_thickness", "array (ny, nx) of float32", "In metres, >= 0."},
                     cell_size_argument(),
                     threads_argument()},
       .parameters = describe_parameters<SlippageParameters>(),
       .return_type = "SlippageResult",
       .returns = "Sediment and ground afterwards.",
       .citation = "Stava et al. 2008"},
      [](const py::object& rock, const py::object& sediment, double cell_size, int threads,
         const py::kwargs& keywords) {
        const auto parameters = from_keywords<SlippageParameters>(keywords);
        const auto r = to_raster<float>(rock, "rock_elevation", cell_size);
        const auto s = to_raster<float>(sediment, "sediment_thickness", r.grid());
        return interruptible(
            threads, [&](Context& context) { return slip_sediment(r, s, parameters, context); });
      },
      py::arg("rock_elevation"), py::arg("sediment_thickness"), py::arg("cell_size"),
      py::arg("threads") = 0);
}

void bind_stream_power(py::module_& room) {
  define(
      room,
      {.name = "erode_stream_power",
       .summary = "Lets rivers cut into rising rock and lay down what they carry.",
       .arguments = {elevation_argument(),
                     base_level_argument(),
                     cell_size_argument(),
                     {"uplift_rate", "float or array (ny, nx) of float32", "In m/yr.", "0.0005"},
                     {"erodibility", "float or array (ny, nx) of float32",
                      "In m^(1-2m)/yr, with m the area exponent.", "5.5e-07"},
                     threads_argument()},
       .parameters = describe_parameters<StreamPowerParameters>(),
       .return_type = "tuple of two arrays (ny, nx) of float32, and MassBalance",
       .returns = "Elevation in metres, drainage area in m2, and the volumes moved.",
       .citation = std::string(stream_power_stage().citation)},
      [](const py::object& elevation, const py::object& base_level, double cell_size,
         const py::object& uplift_rate, const py::object& erodibility, int threads,
         const py::kwargs& keywords) {
        const auto parameters = from_keywords<StreamPowerParameters>(keywords);
        auto z = to_raster<float>(elevation, "elevation", cell_size);
        const auto base = to_mask(base_level, "base_level", z.grid());
        const VaryingArgument uplift(uplift_rate, "uplift_rate", z.grid());
        const VaryingArgument rock(erodibility, "erodibility", z.grid());
        StreamPowerForcing forcing;
        forcing.uplift_rate = uplift.varying();
        forcing.erodibility = rock.varying();
        Raster<float> area;
        MassBalance balance;
        run_interruptible(py::none(), threads, [&](Context& context) {
          context.run(
              [&] { balance = erode_stream_power(z, base, forcing, parameters, context, &area); });
        });
        return py::make_tuple(to_array(std::move(z)), to_array(std::move(area)), balance);
      },
      py::arg("elevation"), py::arg("base_level"), py::arg("cell_size"),
      py::arg("uplift_rate") = 5e-4, py::arg("erodibility") = 5.5e-7, py::arg("threads") = 0);
}

void bind_relief_growth(py::module_& room) {
  py::class_<ReliefGrowth> type(room, "ReliefGrowth", "Mountains grown against stream power.");
  raster_property(type, "elevation", &ReliefGrowth::elevation, "Height in metres; 0 at sea.");
  raster_property(type, "uplift_rate", &ReliefGrowth::uplift_rate, "In m/yr.");
  raster_property(type, "erodibility", &ReliefGrowth::erodibility, "In m^(1-2m)/yr.");
  raster_property(type, "drainage_area", &ReliefGrowth::drainage_area, "In m2.");
  define(
      room,
      {.name = "grow_relief",
       .summary = "Grows mountains by uplift against stream power until they follow the map.",
       .arguments = {map_argument(),
                     {"combined_relief", "array (ny, nx) of float32",
                      "Large-scale height of the land in metres."},
                     {"land", "array (ny, nx) of bool or int", "Not 0 on land."},
                     {"beds", "RiverBeds", "From `orogen.hydrology.lay_river_beds`."},
                     {"progress", "callable or None",
                      "Called as progress(stage, fraction); returning False cancels.", "None"},
                     seed_argument(),
                     threads_argument()},
       .parameters = describe_parameters<ReliefGrowthParameters>(),
       .return_type = "ReliefGrowth",
       .returns = "The grown relief, and what made it.",
       .citation = std::string(relief_growth_stage().citation)},
      [](const VectorMap& map, const py::object& combined_relief, const py::object& land,
         const RiverBeds& beds, const py::object& progress, std::uint32_t seed, int threads,
         const py::kwargs& keywords) {
        const auto parameters = from_keywords<ReliefGrowthParameters>(keywords);
        const Grid& grid = beds.river.grid();
        const auto aim = to_raster<float>(combined_relief, "combined_relief", grid);
        const auto mask = to_mask(land, "land", grid);
        std::optional<ReliefGrowth> result;
        run_interruptible(progress, threads, [&](Context& context) {
          context.begin_stage("relief_growth", 0.0, 1.0);
          context.run([&] {
            result.emplace(grow_relief(map, aim, mask, beds, parameters, seed, context));
          });
        });
        return std::move(*result);
      },
      py::arg("map"), py::arg("combined_relief"), py::arg("land"), py::arg("beds"),
      py::arg("progress") = py::none(), py::arg("seed") = 0, py::arg("threads") = 0);
}

void bind_hillslopes(py::module_& room) {
  define(
      room,
      {.name = "creep",
       .summary = "Lets soil creep downhill.",
       .arguments = {elevation_argument(),
                     base_level_argument(),
                     cell_size_argument(),
                     {"years", "float", "How long."},
                     threads_argument()},
       .parameters = describe_parameters<CreepParameters>(),
       .return_type = "tuple of array (ny, nx) of float32, and MassBalance",
       .returns = "Elevation in metres, and the volumes moved.",
       .citation = std::string(creep_stage().citation)},
      [](const py::object& elevation, const py::object& base_level, double cell_size, double years,
         int threads, const py::kwargs& keywords) {
        const auto parameters = from_keywords<CreepParameters>(keywords);
        auto z = to_raster<float>(elevation, "elevation", cell_size);
        const auto base = to_mask(base_level, "base_level", z.grid());
        const MassBalance balance = interruptible(
            threads, [&](Context& context) { return creep(z, base, parameters, years, context); });
        return py::make_tuple(to_array(std::move(z)), balance);
      },
      py::arg("elevation"), py::arg("base_level"), py::arg("cell_size"), py::arg("years"),
      py::arg("threads") = 0);
  define(
      room,
      {.name = "landslide",
       .summary = "Lets slopes above the talus angle slide.",
       .arguments = {elevation_argument(),
                     base_level_argument(),
                     cell_size_argument(),
                     {"talus_angle_deg", "float", "Steepest slope that stands."},
                     {"years", "float", "How long; infinite: until nothing is too steep."},
                     threads_argument()},
       .parameters = describe_parameters<LandslideParameters>(),
       .return_type = "tuple of array (ny, nx) of float32, and MassBalance",
       .returns = "Elevation in metres, and the volumes moved.",
       .citation = std::string(landslide_stage().citation)},
      [](const py::object& elevation, const py::object& base_level, double cell_size,
         double talus_angle_deg, double years, int threads, const py::kwargs& keywords) {
        const auto parameters = from_keywords<LandslideParameters>(keywords);
        if (!(talus_angle_deg >= 0.0 && talus_angle_deg < 90.0))
          throw InputError("talus_angle_deg: " + detail::format_number(talus_angle_deg) +
                           " is not allowed; 0 to 90, less than 90, is wanted");
        auto z = to_raster<float>(elevation, "elevation", cell_size);
        const auto base = to_mask(base_level, "base_level", z.grid());
        const MassBalance balance = interruptible(threads, [&](Context& context) {
          return landslide(z, base, std::tan(radians(talus_angle_deg)), parameters, years, context);
        });
        return py::make_tuple(to_array(std::move(z)), balance);
      },
      py::arg("elevation"), py::arg("base_level"), py::arg("cell_size"), py::arg("talus_angle_deg"),
      py::arg("years"), py::arg("threads") = 0);
}

}  // namespace

void bind_erosion(py::module_& module) {
  py::module_ room = module.def_submodule("erosion", "What wears the relief down.");
  bind_results(room);
  bind_virtual_pipes(room);
  bind_slippage(room);
  bind_stream_power(room);
  bind_relief_growth(room);
  bind_hillslopes(room);
  bind_tin(room);
}

}  // namespace orogen::python
