#include "strata/block.h"

#include <algorithm>

#include "foundation/errors.h"

namespace orogen {

namespace {

glm::vec3 place(glm::dvec2 p, double z, glm::dvec2 origin) {
  return {float(p.x - origin.x), float(p.y - origin.y), float(z)};
}

void add_face(RockMesh& mesh, std::array<std::int32_t, 4> face, int layer, int sub_layer,
              std::uint32_t color) {
  mesh.faces.push_back(face);
  mesh.layer.push_back(layer);
  mesh.sub_layer.push_back(sub_layer);
  mesh.color.push_back(color);
}

void append_section(RockMesh& mesh, const Section& section, glm::dvec2 origin) {
  for (const SectionBand& band : section.bands) {
    const auto first = std::int32_t(mesh.vertices.size());
    for (std::size_t i = 0; i < section.points.size(); ++i) {
      mesh.vertices.push_back(place(section.points[i], band.bottom[i], origin));
      mesh.vertices.push_back(place(section.points[i], band.top[i], origin));
    }
    for (std::int32_t i = 0; i + 1 < std::int32_t(section.points.size()); ++i) {
      if (band.bottom[i] == band.top[i] && band.bottom[i + 1] == band.top[i + 1]) continue;
      const std::int32_t a = first + 2 * i;
      add_face(mesh, {a, a + 2, a + 3, a + 1}, band.layer, band.sub_layer, band.color);
    }
  }
}

/// A surface over the whole grid: faces of four neighbouring centres, those of `skip` left out.
template <class Height, class Color, class Skip>
void append_surface(RockMesh& mesh, const Grid& grid, Height&& height, Color&& color, Skip&& skip) {
  const auto first = std::int32_t(mesh.vertices.size());
  for (int r = 0; r < grid.ny; ++r)
    for (int c = 0; c < grid.nx; ++c)
      mesh.vertices.push_back(place(grid.center(r, c), height(grid.index(r, c)), grid.origin));
  for (int r = 0; r + 1 < grid.ny; ++r)
    for (int c = 0; c + 1 < grid.nx; ++c) {
      const auto i = std::int32_t(grid.index(r, c));
      if (skip(i, i + 1, i + 1 + grid.nx, i + grid.nx)) continue;
      const auto [layer, sub_layer, rgb] = color(i);
      add_face(mesh, {first + i, first + i + 1, first + i + 1 + grid.nx, first + i + grid.nx},
               layer, sub_layer, rgb);
    }
}

void check_grid(const Grid& grid) {
  if (grid.nx < 2 || grid.ny < 2) throw InputError("elevation: at least 2 x 2 cells are wanted");
}

struct FaceRock {
  int layer, sub_layer;
  std::uint32_t color;
};

}  // namespace

void check_horizon(const RockBody& body, int horizon) {
  check_grid(body.elevation.grid());
  if (horizon < 0 || horizon > body.horizons.layers())
    throw InputError("horizon: " + std::to_string(horizon) + " is not allowed; 0 to " +
                     std::to_string(body.horizons.layers()) + " is wanted");
}

RockMesh section_mesh(const Section& section, glm::dvec2 origin) {
  RockMesh mesh;
  append_section(mesh, section, origin);
  return mesh;
}

RockMesh block_diagram(const RockBody& body, double base, const Context& context) {
  const Grid& grid = body.elevation.grid();
  check_grid(grid);
  const auto ground = body.elevation.values();
  const float lowest = *std::min_element(ground.begin(), ground.end());
  if (!(base < lowest))
    throw InputError("base: " + detail::format_number(base) + " m must lie below all ground, " +
                     detail::format_number(lowest) + " m");
  RockMesh mesh;
  std::vector<float> h(body.horizons.heights.size());
  const auto rock_of = [&](std::int32_t i) {
    context.check();
    const glm::dvec2 place = grid.center(i / grid.nx, i % grid.nx);
    body.horizons.at(place, h.data());
    const Rock rock = body.rock_at(h.data(), ground[i], body.rock_top_at(place, ground[i]));
    return FaceRock{rock.layer, rock.sub_layer, body.rocks.color(rock)};
  };
  const auto never = [](auto...) { return false; };
  append_surface(
      mesh, grid, [&](std::size_t i) { return ground[i]; }, rock_of, never);
  const glm::dvec2 sw = grid.center(0, 0), ne = grid.center(grid.ny - 1, grid.nx - 1);
  const glm::dvec2 se(ne.x, sw.y), nw(sw.x, ne.y);
  for (const auto& [from, to] : {std::pair{sw, se}, {se, ne}, {ne, nw}, {nw, sw}})
    append_section(mesh, cut_section(body, {from, to}, grid.cell_size, base, context), grid.origin);
  const auto b = std::int32_t(mesh.vertices.size());
  for (const glm::dvec2 corner : {sw, nw, ne, se})
    mesh.vertices.push_back(place(corner, base, grid.origin));
  body.horizons.at((sw + ne) * 0.5, h.data());
  const Rock deep = body.rocks.rock_at(h.data(), float(base));
  add_face(mesh, {b, b + 1, b + 2, b + 3}, deep.layer, deep.sub_layer, body.rocks.color(deep));
  return mesh;
}

RockMesh horizon_mesh(const RockBody& body, int horizon, bool only_below_ground,
                      const Context& context) {
  check_horizon(body, horizon);
  const Grid& grid = body.horizons.grid();
  const Raster<float>& height = body.horizons.heights[horizon];
  const auto above = [&](std::int32_t i) {
    return height[i] > body.ground_at(grid.center(i / grid.nx, i % grid.nx));
  };
  const auto skip = [&](std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    context.check();
    return only_below_ground && above(a) && above(b) && above(c) && above(d);
  };
  const Rock below{horizon, body.rocks.sub_layers(horizon) - 1, 0.0f};
  const FaceRock rock{below.layer, below.sub_layer, body.rocks.color(below)};
  RockMesh mesh;
  append_surface(
      mesh, grid, [&](std::size_t i) { return height[i]; }, [&](std::int32_t) { return rock; },
      skip);
  return mesh;
}

}  // namespace orogen
