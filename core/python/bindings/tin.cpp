// orogen.erosion: meshes of triangles, and stream power on them.
#include "foundation/tin.h"

#include <pybind11/stl.h>

#include "arrays.h"
#include "erosion/mountain_growth.h"
#include "erosion/tin_stream_power.h"
#include "foundation/errors.h"
#include "foundation/tin_sampling.h"
#include "interruptible.h"
#include "module.h"
#include "parameters.h"

namespace orogen::python {

namespace {

using Pair = std::pair<double, double>;

TinDomain domain_of(const Pair& size, const Pair& origin) {
  return {{origin.first, origin.second}, {size.first, size.second}};
}

using TinClass = py::class_<Tin, std::shared_ptr<Tin>>;

void bind_makers(TinClass& type) {
  type.def_static(
          "jittered",
          [](const Pair& size, double spacing, std::uint32_t seed, const Pair& origin) {
            return interruptible(0, [&](Context& context) {
              return jittered_tin(domain_of(size, origin), spacing, seed, context);
            });
          },
          py::arg("size"), py::arg("spacing"), py::arg("seed") = 0,
          py::arg("origin") = Pair(0.0, 0.0),
          "A hexagonal lattice over (width, height) with its points moved a little; all in metres.")
      .def_static(
          "poisson",
          [](const Pair& size, double spacing, std::uint32_t seed, const Pair& origin) {
            return interruptible(0, [&](Context& context) {
              return poisson_tin(domain_of(size, origin), spacing, seed, context);
            });
          },
          py::arg("size"), py::arg("spacing"), py::arg("seed") = 0,
          py::arg("origin") = Pair(0.0, 0.0),
          "Random points over (width, height), none nearer to another than 0.77 of the spacing.")
      .def_static(
          "grid",
          [](const std::pair<int, int>& shape, double cell_size, const Pair& origin) {
            return grid_tin({{origin.first, origin.second},
                             {shape.second * cell_size, shape.first * cell_size}},
                            shape.second, shape.first);
          },
          py::arg("shape"), py::arg("cell_size"), py::arg("origin") = Pair(0.0, 0.0),
          "The cells of a regular grid of shape (ny, nx), row by row, each with 8 neighbours.")
      .def_static(
          "from_points",
          [](const py::object& points, const Pair& size, const Pair& origin) {
            auto places = to_points(points, "points");
            return interruptible(0, [&](Context& context) {
              return triangulate(domain_of(size, origin), std::move(places), context);
            });
          },
          py::arg("points"), py::arg("size"), py::arg("origin") = Pair(0.0, 0.0),
          "Delaunay's triangles over points (n, 2) in metres, the rectangle's corners among them; "
          "`points` of the result are in another order.");
}

void bind_arrays(TinClass& type) {
  vector_property<double>(type, "points", &Tin::points, "Places (n, 2) of vertices in metres.");
  vector_property<std::int32_t>(type, "triangles", &Tin::triangles,
                                "Vertices (m, 3) of triangles, anticlockwise.");
  vector_property<std::int32_t>(type, "first_edge", &Tin::first_edge,
                                "Where each vertex's neighbours begin in `neighbors` (n + 1).");
  vector_property<std::int32_t>(type, "neighbors", &Tin::neighbors, "Vertices beside each vertex.");
  vector_property<float>(type, "edge_lengths", &Tin::edge_lengths,
                         "Metres to each of `neighbors`.");
  vector_property<double>(type, "cell_areas", &Tin::cell_areas, "Area (n) of each vertex in m2.");
  vector_property<std::uint8_t>(type, "sides", &Tin::sides,
                                "Sides (n) that a vertex lies on: 1 west + 2 east + 4 south + 8 "
                                "north; 0 inside.");
  type.def("__len__", &Tin::size);
}

void bind_sampling(TinClass& type) {
  type.def(
          "sample_to_grid",
          [](const Tin& tin, const py::object& field, const Grid& grid) {
            const auto values = to_vector<double>(field, "field", tin.size());
            return to_array(interruptible(
                0, [&](Context& context) { return sample_to_grid(tin, values, grid, context); }));
          },
          py::arg("field"), py::arg("grid"),
          "A field (n) at the cells of a grid (ny, nx), linear within triangles.")
      .def(
          "sample_at",
          [](const Tin& tin, const py::object& field, const py::object& points) {
            const auto values = to_vector<double>(field, "field", tin.size());
            const auto places = to_points(points, "points");
            return to_array<double>(interruptible(0, [&](Context& context) {
              return sample_at_points(tin, values, places, context);
            }));
          },
          py::arg("field"), py::arg("points"), "A field (n) at places (k, 2) in metres.");
}

/// What drives the erosion, and the memory of what is given vertex by vertex.
class ForcingArguments {
 public:
  ForcingArguments(const Tin& tin, const py::handle& uplift_rate, const py::handle& erodibility,
                   const py::handle& rain_weight, const py::handle& talus_slope)
      : uplift_rate_(uplift_rate, "uplift_rate", tin.size()),
        erodibility_(erodibility, "erodibility", tin.size()),
        rain_weight_(rain_weight, "rain_weight", tin.size()) {
    if (!talus_slope.is_none()) talus_slope_.emplace(talus_slope, "talus_slope", tin.size());
  }

  TinForcing forcing() const {
    TinForcing forcing;
    forcing.uplift_rate = uplift_rate_.values();
    forcing.erodibility = erodibility_.values();
    forcing.rain_weight = rain_weight_.values();
    if (talus_slope_) forcing.talus_slope = talus_slope_->values();
    return forcing;
  }

 private:
  VertexArgument uplift_rate_, erodibility_, rain_weight_;
  std::optional<VertexArgument> talus_slope_;
};

struct Eroded {
  std::vector<double> elevation, drainage_area;
  std::vector<std::int32_t> receivers;
  MassBalance balance;
};

Eroded erode(const Tin& tin, std::vector<double> z, const std::vector<std::uint8_t>& base,
             const TinForcing& forcing, TinStreamPower rivers, double dt_years, int steps,
             const Context& context) {
  TinFlow flow(tin, base);
  MassBalance balance;
  for (int s = 0; s < steps; ++s) balance += rivers.step(flow, z, forcing, dt_years, context);
  const auto area = rivers.drainage_area();
  const auto receivers = flow.receivers();
  return {std::move(z), {area.begin(), area.end()}, {receivers.begin(), receivers.end()}, balance};
}

void bind_stream_power(py::module_& room) {
  define(
      room,
      {.name = "erode_stream_power_tin",
       .summary = "Lets rivers cut into rising rock on a mesh of triangles.",
       .arguments = {{"tin", "Tin", "The mesh, of n vertices."},
                     {"elevation", "array (n,) of float64", "Height of each vertex in metres."},
                     {"base_level", "array (n,) of bool or int", "Not 0 where water leaves."},
                     {"dt_years", "float", "Length of a step; infinite: the steady state."},
                     {"steps", "int", "How many.", "1"},
                     {"uplift_rate", "float or array (n,) of float32", "In m/yr.", "0.0005"},
                     {"erodibility", "float or array (n,) of float32",
                      "In m^(1-2m)/yr, with m the area exponent.", "5.5e-07"},
                     {"rain_weight", "float or array (n,) of float32", "1: mean rain.", "1.0"},
                     {"talus_slope", "float or array (n,) of float32 or None",
                      "Steepest slope that stands, rise over run; default: any.", "None"},
                     threads_argument()},
       .parameters = describe_parameters<TinStreamPowerParameters>(),
       .return_type = "tuple of three arrays (n,) of float64, float64 and int32, and MassBalance",
       .returns = "Elevation in metres; drainage area in m2 and the vertex that each drains to, "
                  "during the last step; the volumes moved.",
       .citation = "Cordonnier et al. 2018, equation 5; Braun and Willett 2013"},
      [](const Tin& tin, const py::object& elevation, const py::object& base_level, double dt_years,
         int steps, const py::object& uplift_rate, const py::object& erodibility,
         const py::object& rain_weight, const py::object& talus_slope, int threads,
         const py::kwargs& keywords) {
        const TinStreamPower rivers(from_keywords<TinStreamPowerParameters>(keywords));
        if (steps < 1)
          throw InputError("steps: " + std::to_string(steps) + " is not allowed; 1 or more");
        auto z = to_vector<double>(elevation, "elevation", tin.size());
        const auto leaves = to_vector<std::int32_t>(base_level, "base_level", tin.size());
        std::vector<std::uint8_t> base(leaves.size());
        for (std::size_t v = 0; v < base.size(); ++v) base[v] = leaves[v] != 0;
        const ForcingArguments forcing(tin, uplift_rate, erodibility, rain_weight, talus_slope);
        const Eroded made = interruptible(threads, [&](Context& context) {
          return erode(tin, std::move(z), base, forcing.forcing(), rivers, dt_years, steps,
                       context);
        });
        return py::make_tuple(to_array<double>(made.elevation),
                              to_array<double>(made.drainage_area),
                              to_array<std::int32_t>(made.receivers), made.balance);
      },
      py::arg("tin"), py::arg("elevation"), py::arg("base_level"), py::arg("dt_years"),
      py::arg("steps") = 1, py::arg("uplift_rate") = 5e-4, py::arg("erodibility") = 5.5e-7,
      py::arg("rain_weight") = 1.0, py::arg("talus_slope") = py::none(), py::arg("threads") = 0);
}

}  // namespace

void bind_tin(py::module_& erosion) {
  TinClass type(erosion, "Tin",
                "A mesh of Delaunay's triangles over a rectangle. Arrays are views.");
  bind_makers(type);
  bind_arrays(type);
  bind_sampling(type);
  py::class_<GrownTin, Tin, std::shared_ptr<GrownTin>> grown(
      erosion, "GrownTin", "The mesh that mountains grew on, as they are at the end.");
  vector_property<double>(grown, "elevation", &GrownTin::elevation,
                          "Height (n) of each vertex in metres, before the detail on slopes.");
  vector_property<double>(grown, "sediment_thickness", &GrownTin::sediment_thickness,
                          "Depth (n) of what rivers laid down in metres; (0) if they lay down "
                          "nothing.");
  bind_stream_power(erosion);
}

}  // namespace orogen::python
