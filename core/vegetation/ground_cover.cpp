#include "vegetation/ground_cover.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "foundation/units.h"
#include "vegetation/leaf_outline.h"
#include "vegetation/stem_growth.h"

namespace orogen {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr int kStalkSides = 3;
constexpr double kStalkGirth = 0.006;  // diameter beside the length

/// A line that rises from the ground and leans over: where it is, and its frame, x across.
struct Arch {
  std::vector<glm::dvec3> places;
  std::vector<Frame> frames;
};

class Tuft {
 public:
  Tuft(const GroundCoverParameters& parameters, std::uint64_t seed) : p_(parameters), seed_(seed) {}

  PlantMesh run() {
    for (int blade = 0; blade < p_.blades; ++blade) {
      StemDraws draws(seed_, std::uint64_t(blade));
      const double length = p_.height * draws.around(1.0, p_.height_variation);
      const Arch arch = rise(length, p_.lean_deg, p_.droop_deg, draws);
      if (p_.pinnae > 0)
        add_frond(arch, length);
      else
        add_strip(arch, p_.blade_width, PlantMaterial::Leaf, 0);
    }
    for (int stalk = 0; stalk < p_.stalks; ++stalk) {
      StemDraws draws(seed_, std::uint64_t(p_.blades + stalk));
      const double length = p_.stalk_height * draws.around(1.0, 0.5 * p_.height_variation);
      const Arch arch = rise(length, 0.25 * p_.lean_deg, 0.3 * p_.droop_deg, draws);
      add_stalk(arch, 0.5 * kStalkGirth * length);
      add_flower(arch);
    }
    mesh_.face_starts.push_back(std::int32_t(mesh_.corners.size()));
    return std::move(mesh_);
  }

 private:
  Arch rise(double length, double lean_deg, double droop_deg, StemDraws& draws) const {
    const double around = kTurn * draws.uniform(), out = p_.spread * std::sqrt(draws.uniform());
    const double variation = std::min(lean_deg, p_.lean_variation_deg);
    double lean = radians(draws.around(lean_deg, variation));
    const double facing = around + draws.around(0.0, 0.8);
    const glm::dvec3 outwards(std::cos(facing), std::sin(facing), 0.0);
    const glm::dvec3 across(-outwards.y, outwards.x, 0.0);
    glm::dvec3 place(out * std::cos(around), out * std::sin(around), 0.0);
    Arch arch;
    for (int s = 0; s <= p_.blade_segments; ++s) {
      const glm::dvec3 along = std::sin(lean) * outwards + glm::dvec3(0.0, 0.0, std::cos(lean));
      arch.places.push_back(place);
      arch.frames.push_back({across, along});
      place += length / p_.blade_segments * along;
      lean += radians(droop_deg) / p_.blade_segments;
    }
    return arch;
  }

  std::int32_t add_vertex(glm::dvec3 place) {
    mesh_.positions.push_back(place);
    return std::int32_t(mesh_.positions.size()) - 1;
  }

  void begin_face(PlantMaterial material, std::uint8_t level) {
    mesh_.face_starts.push_back(std::int32_t(mesh_.corners.size()));
    mesh_.materials.push_back(material);
    mesh_.levels.push_back(level);
  }

  void add_corner(std::int32_t vertex, glm::dvec2 uv) {
    mesh_.corners.push_back(vertex);
    mesh_.uvs.push_back(uv);
  }

  /// A strip that narrows to a point.
  void add_strip(const Arch& arch, double width, PlantMaterial material, std::uint8_t level) {
    const int segments = int(arch.places.size()) - 1;
    const auto first = std::int32_t(mesh_.positions.size());
    for (int s = 0; s < segments; ++s) {
      const double t = double(s) / segments, half = 0.5 * width * (1.0 - t * t);
      add_vertex(arch.places[s] - half * arch.frames[s].x);
      add_vertex(arch.places[s] + half * arch.frames[s].x);
    }
    add_vertex(arch.places[segments]);
    for (int s = 0; s < segments; ++s) {
      const std::int32_t v = first + 2 * s;
      const double low = double(s) / segments, high = double(s + 1) / segments;
      begin_face(material, level);
      add_corner(v, {0.0, low}), add_corner(v + 1, {1.0, low});
      if (s + 1 == segments) {
        add_corner(v + 2, {0.5, 1.0});
      } else {
        add_corner(v + 3, {1.0, high}), add_corner(v + 2, {0.0, high});
      }
    }
  }

  void add_polygon(std::span<const glm::vec2> outline, glm::dvec3 foot, const Frame& frame,
                   double length, double width, PlantMaterial material, std::uint8_t level) {
    begin_face(material, level);
    for (const glm::vec2 uv : outline)
      add_corner(
          add_vertex(foot + width * (uv.x - 0.5) * frame.x + length * double(uv.y) * frame.z), uv);
  }

  /// The midrib with pairs of leaflets, longest a third of the way up.
  void add_frond(const Arch& arch, double length) {
    add_strip(arch, 0.015 * length, PlantMaterial::Stem, 0);
    const int segments = int(arch.places.size()) - 1;
    for (int pair = 0; pair < p_.pinnae; ++pair) {
      const double t = 0.12 + 0.86 * (pair + 0.5) / p_.pinnae;
      const int s = std::min(int(t * segments), segments - 1);
      const double within = t * segments - s;
      const glm::dvec3 foot = arch.places[s] + within * (arch.places[s + 1] - arch.places[s]);
      const double wide = std::min(1.0, (t + 0.05) / 0.38) * std::sqrt(1.0 - t);
      const double leaflet = 0.5 * p_.blade_width * wide;
      for (const double side : {-1.0, 1.0}) {
        const Frame frame = arch.frames[s].about_y(side * radians(72.0)).about_x(radians(12.0));
        add_polygon(leaf_outline(LeafShape::Triangle, true), foot, frame, leaflet,
                    std::max(0.3 * leaflet, 0.8 * length / p_.pinnae), PlantMaterial::Leaf, 1);
      }
    }
  }

  void add_stalk(const Arch& arch, double radius) {
    const auto first = std::int32_t(mesh_.positions.size());
    const auto rings = int(arch.places.size());
    for (int r = 0; r < rings; ++r)
      for (int k = 0; k < kStalkSides; ++k) {
        const Frame frame = arch.frames[r].about_z(kTurn * k / kStalkSides);
        add_vertex(arch.places[r] + radius * frame.x);
      }
    for (int r = 0; r + 1 < rings; ++r)
      for (int k = 0; k < kStalkSides; ++k) {
        const int next = (k + 1) % kStalkSides;
        const std::int32_t low = first + r * kStalkSides, high = low + kStalkSides;
        const double u = double(k) / kStalkSides, v = double(k + 1) / kStalkSides;
        const double from = double(r) / (rings - 1), to = double(r + 1) / (rings - 1);
        begin_face(PlantMaterial::Stem, 0);
        add_corner(low + k, {u, from}), add_corner(low + next, {v, from});
        add_corner(high + next, {v, to}), add_corner(high + k, {u, to});
      }
  }

  void add_flower(const Arch& arch) {
    const glm::dvec3 top = arch.places.back();
    const Frame frame = arch.frames.back();
    const double length = p_.petal_length, width = length * p_.petal_width;
    if (p_.petals == 0) {  // an ear: two leaves of it crossed, along the stalk
      for (const double turn : {0.0, 0.25 * kTurn})
        add_polygon(leaf_outline(LeafShape::Oval, false), top, frame.about_z(turn), length, width,
                    PlantMaterial::Petal, 1);
      return;
    }
    const auto outline = leaf_outline(LeafShape::Oval, false);
    for (int petal = 0; petal < p_.petals; ++petal) {
      const Frame turned = frame.about_z(kTurn * petal / p_.petals);
      const Frame lifted = turned.about_x(0.25 * kTurn - radians(p_.petal_lift_deg));
      add_polygon(outline, top, lifted, length, width, PlantMaterial::Petal, 1);
    }
    begin_face(PlantMaterial::FlowerCentre, 1);
    const int corners = 8;
    for (int k = 0; k < corners; ++k) {
      const double angle = kTurn * k / corners;
      const glm::dvec2 at(std::cos(angle), std::sin(angle));
      const glm::dvec3 place =
          top + 0.3 * length * (at.x * frame.x + at.y * frame.y()) + 0.08 * length * frame.z;
      add_corner(add_vertex(place), 0.5 + 0.5 * at);
    }
  }

  const GroundCoverParameters& p_;
  std::uint64_t seed_;
  PlantMesh mesh_;
};

PlantMesh crossed(const PlantMesh& tuft) {
  double wide = 0.0, high = 0.0;
  for (const glm::vec3 p : tuft.positions) {
    wide = std::max(wide, std::hypot(double(p.x), double(p.y)));
    high = std::max(high, double(p.z));
  }
  PlantMesh mesh;
  for (const glm::dvec3 along : {glm::dvec3(wide, 0.0, 0.0), glm::dvec3(0.0, wide, 0.0)}) {
    mesh.face_starts.push_back(std::int32_t(mesh.corners.size()));
    mesh.materials.push_back(PlantMaterial::Leaf);
    mesh.levels.push_back(0);
    for (const glm::dvec2 uv :
         {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(1, 1), glm::dvec2(0, 1)}) {
      mesh.corners.push_back(std::int32_t(mesh.positions.size()));
      mesh.positions.push_back((2.0 * uv.x - 1.0) * along + glm::dvec3(0.0, 0.0, uv.y * high));
      mesh.uvs.push_back(uv);
    }
  }
  mesh.face_starts.push_back(std::int32_t(mesh.corners.size()));
  return mesh;
}

}  // namespace

PlantMesh make_ground_cover(const GroundCoverParameters& parameters, std::uint64_t seed,
                            bool crossed_quads) {
  check_parameters(parameters);
  const PlantMesh tuft = Tuft(parameters, seed).run();
  return crossed_quads ? crossed(tuft) : tuft;
}

}  // namespace orogen
