#include "vegetation/tree_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "foundation/parallel.h"
#include "foundation/random.h"
#include "vegetation/leaf_outline.h"

namespace orogen {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr std::size_t kGrain = 256;
constexpr std::size_t kMostCorners = 500'000'000;
constexpr std::uint64_t kTwigDraw = 1, kLeafDraw = 2;  // streams of what is kept

/// Sides and rings beside those of the trunk, by level.
constexpr std::array<double, kStemLevels> kSides{1.0, 0.5, 0.25, 0.2};
constexpr std::array<int, kStemLevels> kRings{4, 2, 1, 1};

/// How much a stem adds to the mesh, and from where.
struct Tube {
  std::int32_t stem = 0;
  int sides = 3, rings = 0;
  bool pointed = false;  // ends in one vertex; else in a ring with a face
  std::int32_t vertex = 0, face = 0, corner = 0;
  std::vector<double> along = {};  // m, of the rings if they are not even

  std::int32_t vertices() const { return sides * rings + pointed; }
  std::int32_t faces() const { return pointed ? sides * rings : sides * (rings - 1) + 1; }
  std::int32_t corners() const { return 4 * sides * (rings - 1) + (pointed ? 3 * sides : sides); }
};

class Mesher {
 public:
  Mesher(const TreeSkeleton& tree, const TreeMeshParameters& parameters)
      : tree_(tree), p_(parameters), detail_(std::sqrt(parameters.quality)) {}

  PlantMesh run(const Context& context) {
    plan_tubes();
    plan_leaves();
    mesh_.face_starts.back() = std::int32_t(mesh_.corners.size());
    parallel_chunks(context, tubes_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) fill_tube(tubes_[t]);
    });
    parallel_chunks(context, leaves_.size(), 16 * kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t l = begin; l < end; ++l) fill_leaf(l);
    });
    return std::move(mesh_);
  }

 private:
  bool is_drawn(std::size_t index) const {
    const int level = tree_.stems[index].level;
    if (level < 2 || level < tree_.parameters.levels - 1) return true;
    std::size_t twig = index;  // a fork is kept with its twig
    while (tree_.stems[twig].forked_from >= 0) twig = std::size_t(tree_.stems[twig].forked_from);
    return random_uniform(0, kTwigDraw, twig) < p_.quality;
  }

  Tube tube_of(std::size_t index) const {
    const Stem& stem = tree_.stems[index];
    const bool trunk = stem.level == 0;
    const int full = std::max(p_.trunk_sides, trunk ? 4 * tree_.parameters.lobes : 0);
    Tube tube;
    tube.stem = std::int32_t(index);
    tube.sides = std::max(3, int(std::lround(full * kSides[stem.level] * detail_)));
    const int each = std::max(1, int(std::lround(kRings[stem.level] * detail_)));
    tube.rings = (stem.nodes - 1) * each + 1;
    tube.along = uneven_rings(stem, tube.rings);
    if (!tube.along.empty()) tube.rings = int(tube.along.size());
    tube.pointed = stem_radius(tree_, stem, stem.length) < 1e-3 * stem.radius;
    if (tube.pointed) --tube.rings;
    return tube;
  }

  /// More rings where a stem's radius is not that of a cone: where the trunk flares, in the ground,
  /// at a round tip. Empty if it has none of these.
  std::vector<double> uneven_rings(const Stem& stem, int even) const {
    std::vector<double> along;
    if (stem.level == 0 && stem.forked_from < 0) {
      along.push_back(-2.0 * stem.radius);
      const int more = tree_.parameters.flare > 0.0 ? int(std::lround(6.0 * detail_)) : 0;
      for (int r = 1; r <= more; ++r)
        along.push_back(stem.length * 0.125 * r * r / double(more * more + 1));
    }
    if (stem.level < 2 && tree_.parameters.stems[stem.level].taper > 1.0)
      for (const double share : {0.6, 0.3, 0.1}) {
        const double tip = stem.length - share * stem.radius;
        if (tip > stem.start) along.push_back(tip);
      }
    if (along.empty()) return along;
    for (int r = 0; r < even; ++r)
      along.push_back(stem.start + (stem.length - stem.start) * r / (even - 1));
    std::sort(along.begin(), along.end());
    return along;
  }

  void plan_tubes() {
    std::size_t vertex = 0, face = 0, corner = 0;
    for (std::size_t s = 0; s < tree_.stems.size(); ++s) {
      if (!is_drawn(s)) continue;
      Tube tube = tube_of(s);
      tube.vertex = std::int32_t(vertex);
      tube.face = std::int32_t(face);
      tube.corner = std::int32_t(corner);
      vertex += tube.vertices(), face += tube.faces(), corner += tube.corners();
      tubes_.push_back(std::move(tube));
    }
    first_leaf_ = {vertex, face, corner};
  }

  void plan_leaves() {
    const TreeParameters& p = tree_.parameters;
    outline_ = leaf_outline(p_.leaf_cards ? LeafShape::Rectangle : p.leaf_shape, p_.quality < 0.5);
    for (std::size_t l = 0; l < tree_.leaves.size(); ++l)
      if (random_uniform(0, kLeafDraw, l) < p_.quality) leaves_.push_back(l);
    const auto [vertex, face, corner] = first_leaf_;
    const std::size_t count = leaves_.size(), corners = count * outline_.size();
    if (corner + corners > kMostCorners)
      throw InputError("a mesh of " + std::to_string(corner + corners) +
                       " corners is not allowed; " + std::to_string(kMostCorners) +
                       " at most: lower `quality` or `trunk_sides`");
    mesh_.positions.resize(vertex + corners);
    mesh_.corners.resize(corner + corners);
    mesh_.uvs.resize(corner + corners);
    mesh_.face_starts.resize(face + count + 1);
    mesh_.materials.resize(face + count);
    mesh_.levels.resize(face + count);
  }

  void fill_tube(const Tube& tube) {
    const Stem& stem = tree_.stems[tube.stem];
    for (int r = 0; r < tube.rings; ++r) fill_ring(tube, stem, r, along_of(tube, stem, r));
    if (tube.pointed)
      mesh_.positions[tube.vertex + tube.sides * tube.rings] =
          stem_place(tree_, stem, stem.length).position;
    fill_faces(tube, stem);
  }

  void fill_ring(const Tube& tube, const Stem& stem, int ring, double along) {
    const TreeParameters& p = tree_.parameters;
    StemNode place = stem_place(tree_, stem, along);
    if (along < 0.0) place.position += along * place.frame.z;
    const double radius = stem_radius(tree_, stem, along);
    const glm::dvec3 x = place.frame.x, y = place.frame.y();
    for (int k = 0; k < tube.sides; ++k) {
      const double angle = kTurn * k / tube.sides;
      const double lobe = stem.level == 0 ? 1.0 + p.lobe_depth * std::sin(p.lobes * angle) : 1.0;
      mesh_.positions[tube.vertex + ring * tube.sides + k] =
          place.position + radius * lobe * (std::cos(angle) * x + std::sin(angle) * y);
    }
  }

  double along_of(const Tube& tube, const Stem& stem, int ring) const {
    if (ring < int(tube.along.size())) return tube.along[ring];
    const int even = tube.rings - !tube.pointed;
    return stem.start + (stem.length - stem.start) * ring / even;
  }

  void fill_faces(const Tube& tube, const Stem& stem) {
    std::int32_t corner = tube.corner, face = tube.face;
    const int sides = tube.sides, last = tube.rings - 1;
    const double around = 1.0 / (kTurn * stem.radius);
    const auto add_corner = [&](int ring, int k) {
      const bool tip = ring == tube.rings;
      mesh_.corners[corner] = tube.vertex + ring * sides + (tip ? 0 : k % sides);
      mesh_.uvs[corner++] = {(k + 0.5 * tip) / sides, along_of(tube, stem, ring) * around};
    };
    const auto begin_face = [&] {
      mesh_.face_starts[face] = corner;
      mesh_.materials[face] = PlantMaterial::Stem;
      mesh_.levels[face++] = std::uint8_t(stem.level);
    };
    for (int r = 0; r < last; ++r)
      for (int k = 0; k < sides; ++k) {
        begin_face();
        add_corner(r, k), add_corner(r, k + 1), add_corner(r + 1, k + 1), add_corner(r + 1, k);
      }
    if (!tube.pointed) begin_face();
    for (int k = 0; k < sides; ++k) {
      if (tube.pointed) begin_face();
      add_corner(last, k);
      if (tube.pointed) add_corner(last, k + 1), add_corner(last + 1, k);
    }
  }

  void fill_leaf(std::size_t index) {
    const TreeParameters& p = tree_.parameters;
    const TreeLeaf& leaf = tree_.leaves[leaves_[index]];
    const auto length = float(p.leaf_scale / detail_), width = length * float(p.leaf_scale_x);
    const std::size_t count = outline_.size(), first = index * count;
    const auto [vertex, face, corner] = first_leaf_;
    for (std::size_t k = 0; k < count; ++k) {
      const glm::vec2 uv = outline_[k];
      mesh_.positions[vertex + first + k] =
          leaf.position + width * (uv.x - 0.5f) * leaf.side + length * uv.y * leaf.direction;
      mesh_.corners[corner + first + k] = std::int32_t(vertex + first + k);
      mesh_.uvs[corner + first + k] = uv;
    }
    mesh_.face_starts[face + index] = std::int32_t(corner + first);
    mesh_.materials[face + index] = PlantMaterial::Leaf;
    mesh_.levels[face + index] = std::uint8_t(p.levels);
  }

  struct Counts {
    std::size_t vertex = 0, face = 0, corner = 0;
  };

  const TreeSkeleton& tree_;
  const TreeMeshParameters& p_;
  double detail_;
  std::vector<Tube> tubes_;
  std::vector<std::size_t> leaves_;  // those that are kept
  std::span<const glm::vec2> outline_;
  Counts first_leaf_;
  PlantMesh mesh_;
};

}  // namespace

PlantMesh mesh_tree(const TreeSkeleton& tree, const TreeMeshParameters& parameters,
                    const Context& context) {
  check_parameters(parameters);
  return Mesher(tree, parameters).run(context);
}

}  // namespace orogen
