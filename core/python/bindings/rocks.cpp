// orogen.strata.Rocks: sections, block diagrams, horizons and volumes of folded rock.
#include "rocks.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>

#include "arrays.h"
#include "foundation/errors.h"
#include "interruptible.h"
#include "json_argument.h"
#include "parameters.h"
#include "pipeline/recipe_inputs.h"
#include "strata/block.h"
#include "strata/horizon_trace.h"
#include "strata/outcrop.h"
#include "strata/rock_volume.h"
#include "strata/section_svg.h"

namespace orogen::python {

namespace {

struct CutSection {
  Rocks rocks;
  Section section;
};

/// 0xRRGGBB to (n, 3) bytes.
py::array to_rgb(const std::vector<std::uint32_t>& colors) {
  py::array_t<std::uint8_t> rgb({py::ssize_t(colors.size()), py::ssize_t(3)});
  auto view = rgb.mutable_unchecked<2>();
  for (std::size_t i = 0; i < colors.size(); ++i)
    for (int k = 0; k < 3; ++k) view(i, k) = std::uint8_t(colors[i] >> (16 - 8 * k) & 255u);
  return rgb;
}

py::dict to_dict(const RockMesh& mesh) {
  py::dict d;
  d["vertices"] = to_array<float>(mesh.vertices);
  d["faces"] = to_array<std::int32_t>(mesh.faces);
  d["layer"] = to_array<std::int32_t>(mesh.layer);
  d["sub_layer"] = to_array<std::int32_t>(mesh.sub_layer);
  d["color"] = to_rgb(mesh.color);
  return d;
}

double base_or_default(const Rocks& rocks, const std::optional<double>& base) {
  if (base) return *base;
  const auto ground = rocks.elevation->values();
  const auto deep = rocks.strata->horizons.heights[0].values();
  const double lowest = std::min<double>(*std::min_element(ground.begin(), ground.end()),
                                         *std::min_element(deep.begin(), deep.end()));
  return lowest - 500.0;
}

CutSection cut(const Rocks& rocks, const std::vector<std::pair<double, double>>& line,
               const std::optional<double>& spacing, const std::optional<double>& base) {
  Polyline points;
  for (const auto& [x, y] : line) points.emplace_back(x, y);
  return {rocks, interruptible(0, [&](Context& context) {
            return cut_section(rocks.body(), points,
                               spacing.value_or(rocks.elevation->grid().cell_size),
                               base_or_default(rocks, base), context);
          })};
}

py::list bands_of(const CutSection& cut) {
  py::list list;
  for (const SectionBand& band : cut.section.bands) {
    py::dict d;
    d["layer"] = band.layer;
    d["sub_layer"] = band.sub_layer;
    d["color"] = py::make_tuple(band.color >> 16 & 255u, band.color >> 8 & 255u, band.color & 255u);
    d["bottom"] = to_array<float>(band.bottom);
    d["top"] = to_array<float>(band.top);
    list.append(d);
  }
  return list;
}

py::array picture_of(const CutSection& cut, int width, int height,
                     const std::optional<double>& top) {
  const auto& surface = cut.section.surface;
  const double highest = *std::max_element(surface.begin(), surface.end());
  const SectionPicture picture =
      draw_section(cut.rocks.body(), cut.section, width, height, top.value_or(highest));
  py::array_t<std::uint8_t> rgba({height, width, 4});
  auto view = rgba.mutable_unchecked<3>();
  for (int r = 0; r < height; ++r)
    for (int c = 0; c < width; ++c) {
      const std::uint32_t pixel = picture.pixels[std::size_t(r) * width + c];
      for (int k = 0; k < 3; ++k) view(r, c, k) = std::uint8_t(pixel >> (16 - 8 * k) & 255u);
      view(r, c, 3) = std::uint8_t(pixel >> 24);
    }
  return rgba;
}

py::dict rock_at(const Rocks& rocks, double x, double y, double z) {
  std::vector<float> h(rocks.strata->horizons.heights.size());
  rocks.strata->horizons.at({x, y}, h.data());
  const RockTable& table = rocks.strata->rocks;
  const RockBody body = rocks.body();
  const Rock rock =
      body.rock_at(h.data(), float(z), body.rock_top_at({x, y}, body.ground_at({x, y})));
  py::dict d;
  d["layer"] = rock.layer;
  d["sub_layer"] = rock.sub_layer;
  d["lithology"] = lithology_info(table.lithology(rock)).name;
  d["depth_in_layer"] = rock.layer > table.layers()
                            ? 0.0
                            : rock.gamma * (h[rock.layer] - table.bottom_of(rock.layer, h.data()));
  return d;
}

py::list traces_of(const Rocks& rocks, int horizon) {
  const auto traces = interruptible(
      0, [&](Context& context) { return horizon_traces(rocks.body(), horizon, context); });
  py::list list;
  for (const Trace& trace : traces) list.append(to_array<float>(trace));
  return list;
}

Rocks from_arrays(const py::object& column, const py::list& horizons, const py::object& elevation,
                  double cell_size, const py::object& sediment, const py::kwargs& keywords) {
  StratigraphicColumn read = read_column({to_json(column, "column"), "column"});
  const auto palette = from_keywords<OutcropParameters>(keywords).palette;
  auto ground =
      std::make_shared<const Raster<float>>(to_raster<float>(elevation, "elevation", cell_size));
  HorizonStack stack;
  for (std::size_t k = 0; k < horizons.size(); ++k)
    stack.heights.push_back(to_raster<float>(
        horizons[k], ("horizons[" + std::to_string(k) + "]").c_str(), ground->grid()));
  if (stack.heights.size() != read.layers.size() + 1)
    throw InputError("horizons: " + std::to_string(stack.heights.size()) +
                     " are given; one more than the column's " +
                     std::to_string(read.layers.size()) + " layers are wanted");
  for (int k = 0; k < stack.layers(); ++k)
    for (std::size_t i = 0; i < ground->size(); ++i)
      if (stack.heights[k][i] > stack.heights[k + 1][i])
        throw InputError("horizons[" + std::to_string(k + 1) + "]: lies below the one before it");
  Raster<float> loose;
  if (!sediment.is_none()) {
    loose = to_raster<float>(sediment, "sediment_thickness", ground->grid());
    for (const float depth : loose.values())
      if (!(depth >= 0.0f)) throw InputError("sediment_thickness: at least 0 m is wanted");
  }
  RockTable table(read, {}, palette);
  return {std::make_shared<const Strata>(
              Strata{std::move(read), std::move(table), std::move(stack), std::move(loose)}),
          std::move(ground)};
}

void bind_section(py::module_& room) {
  py::class_<CutSection>(room, "Section", "The ground cut open along a line.")
      .def_property_readonly(
          "points", [](const CutSection& c) { return to_array<double>(c.section.points); },
          "Places (n, 2) on the map, in metres.")
      .def_property_readonly(
          "distance", [](const CutSection& c) { return to_array<double>(c.section.distance); },
          "Metres along the line.")
      .def_property_readonly(
          "surface", [](const CutSection& c) { return to_array<float>(c.section.surface); },
          "Height of the ground in metres.")
      .def_property_readonly(
          "base", [](const CutSection& c) { return c.section.base; },
          "Height of the lower edge in metres.")
      .def_property_readonly("bands", &bands_of,
                             "Sub-layers from the bottom up: dictionaries of layer, sub_layer, "
                             "color, bottom and top (metres, at each point).")
      .def("picture", &picture_of, py::arg("width") = 1600, py::arg("height") = 400,
           py::arg("top") = py::none(),
           "(height, width, 4) bytes, transparent above ground; up to `top` metres.")
      .def(
          "svg",
          [](const CutSection& c, double exaggeration) {
            return section_svg(c.section, c.rocks.strata->column, exaggeration);
          },
          py::arg("exaggeration") = 1.0, "The section as an SVG document.")
      .def(
          "mesh",
          [](const CutSection& c) {
            return to_dict(section_mesh(c.section, c.rocks.elevation->grid().origin));
          },
          "Vertices (less the grid's origin), faces, layer, sub_layer and color of each face.");
}

}  // namespace

void bind_rocks(py::module_& room) {
  bind_section(room);
  py::class_<Rocks>(room, "Rocks", "Folded rocks under a ground.")
      .def_static("from_arrays", &from_arrays, py::arg("column"), py::arg("horizons"),
                  py::arg("elevation"), py::arg("cell_size"),
                  py::arg("sediment_thickness") = py::none(),
                  "Rocks of a column (a dictionary as recipes have it), its horizons (arrays (ny, "
                  "nx) in metres, the basement's top first) and a ground, with loose sediment on "
                  "it (metres); `palette`: map or natural.")
      .def_property_readonly(
          "column", [](const Rocks& r) { return from_json(write_column(r.strata->column)); },
          "The stratigraphic column, as recipes have it.")
      .def_property_readonly(
          "horizons",
          [](const Rocks& r) {
            py::list list;
            for (const Raster<float>& h : r.strata->horizons.heights)
              list.append(to_array(RealField(r.strata, &h)));
            return list;
          },
          "Tops of basement and layers: arrays (ny, nx) in metres, read-only.")
      .def("rock_at", &rock_at, py::arg("x"), py::arg("y"), py::arg("z"),
           "The rock at a place in metres: layer, sub_layer, lithology and depth_in_layer.")
      .def("section", &cut, py::arg("line"), py::arg("spacing") = py::none(),
           py::arg("base") = py::none(), "The section along a line of places [(x, y), ...].")
      .def(
          "block_diagram",
          [](const Rocks& r, const std::optional<double>& base) {
            return to_dict(interruptible(0, [&](Context& context) {
              return block_diagram(r.body(), base_or_default(r, base), context);
            }));
          },
          py::arg("base") = py::none(),
          "The terrain with strata on its four walls, and a base: vertices, faces, layer, "
          "sub_layer and color of each face.")
      .def(
          "horizon_mesh",
          [](const Rocks& r, int horizon, bool only_below_ground) {
            return to_dict(interruptible(0, [&](Context& context) {
              return horizon_mesh(r.body(), horizon, only_below_ground, context);
            }));
          },
          py::arg("horizon"), py::arg("only_below_ground") = true, "A horizon as a mesh.")
      .def("horizon_traces", &traces_of, py::arg("horizon"),
           "Lines (n, 3) on the ground, less the grid's origin, along which a horizon comes to "
           "light; on their left it lies above the ground.")
      .def(
          "write_volume",
          [](const Rocks& r, const std::filesystem::path& file, const std::optional<double>& base,
             double voxel_height, double voxel_size) {
            run_interruptible(py::none(), 0, [&](Context& context) {
              context.run([&] {
                write_rock_volume(file, r.body(), r.strata->column,
                                  {base_or_default(r, base), voxel_size, voxel_height}, context);
              });
            });
          },
          py::arg("file"), py::arg("base") = py::none(), py::arg("voxel_height") = 100.0,
          py::arg("voxel_size") = 0.0, "Writes the rocks as an OpenVDB index volume.");
}

}  // namespace orogen::python
