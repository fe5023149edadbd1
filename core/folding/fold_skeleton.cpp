#include "folding/fold_skeleton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "foundation/bilinear.h"
#include "foundation/errors.h"
#include "foundation/parallel.h"

namespace orogen {

namespace {

constexpr double kSteepest = 0.5;  // energy below which an edge may be a crest
constexpr double kAcross = 1.0;    // energy where nothing is compressed

double energy(glm::dvec2 direction, glm::dvec2 compression) {
  return std::fabs(glm::dot(direction, compression)) /
         (glm::length(direction) * glm::length(compression));
}

// Middles of the two edges of a face other than `edge`.
std::array<glm::dvec2, 2> other_middles(const FoldMesh& mesh, int face, int edge) {
  const auto& edges = mesh.faces[face].edges;
  const int k = int(std::find(edges.begin(), edges.end(), edge) - edges.begin());
  return {mesh.middle(edges[(k + 1) % 3]), mesh.middle(edges[(k + 2) % 3])};
}

bool below_dual_edges(const FoldMesh& mesh, int edge, glm::dvec2 compression, double e) {
  const auto left = other_middles(mesh, mesh.edges[edge].left, edge);
  const auto right = other_middles(mesh, mesh.edges[edge].right, edge);
  for (const glm::dvec2 p : left)
    for (const glm::dvec2 q : right)
      if (!(e < energy(q - p, compression))) return false;
  return true;
}

int chosen_edges(const FoldSkeleton& skeleton, const FoldMesh::Face& face) {
  return int(std::count_if(face.edges.begin(), face.edges.end(),
                           [&](int e) { return skeleton.choice[e] != FoldChoice::None; }));
}

void open_closed_faces(FoldSkeleton& skeleton, const std::vector<double>& energies) {
  auto& choice = skeleton.choice;
  for (const auto& face : skeleton.mesh.faces)
    if (chosen_edges(skeleton, face) == 3) {
      // What was chosen by hand goes last.
      const auto rank = [&](int e) {
        return std::pair(choice[e] == FoldChoice::ByEnergy, energies[e]);
      };
      choice[*std::max_element(face.edges.begin(), face.edges.end(),
                               [&](int d, int e) { return rank(d) < rank(e); })] = FoldChoice::None;
    }
}

void append_bottom(const FoldSkeleton& skeleton, int f, std::vector<Segment>& bottom) {
  const FoldMesh& mesh = skeleton.mesh;
  std::array<glm::dvec2, 3> middles;
  int unchosen = 0;
  for (const int e : mesh.faces[f].edges)
    if (skeleton.choice[e] == FoldChoice::None) middles[unchosen++] = mesh.middle(e);
  if (unchosen == 2)
    bottom.push_back({middles[0], middles[1]});
  else
    for (int k = 0; k < unchosen; ++k) bottom.push_back({middles[k], mesh.center(f)});
}

void check_field(const CompressionField& field) {
  if (field.compression_x.empty() || field.compression_x.grid() != field.compression_y.grid())
    throw InputError("compression: both components must lie on one grid of at least one cell");
}

}  // namespace

glm::dvec2 compression_at(const CompressionField& field, glm::dvec2 p) {
  const Bilinear place = bilinear_at(field.compression_x.grid(), p);
  glm::dvec2 sum(0.0);
  const auto add = [&](int r, int c, double weight) {
    const glm::dvec2 one(field.compression_x(r, c), field.compression_y(r, c));
    sum += weight * (glm::dot(sum, one) < 0.0 ? -one : one);
  };
  add(place.r0, place.c0, (1.0 - place.u) * (1.0 - place.v));
  add(place.r0, place.c1, place.u * (1.0 - place.v));
  add(place.r1, place.c0, (1.0 - place.u) * place.v);
  add(place.r1, place.c1, place.u * place.v);
  return sum;
}

FoldSkeleton fold_skeleton(const CompressionField& field, const FoldWavelength& wavelength,
                           std::span<const FoldEdit> edits, std::uint32_t seed,
                           const Context& context) {
  check_field(field);
  check_fold_edits(edits);
  const Grid& grid = field.compression_x.grid();
  FoldSkeleton skeleton;
  FoldMesh& mesh = skeleton.mesh;
  mesh = fold_mesh(grid.origin, grid.origin + glm::dvec2(grid.width(), grid.height()), wavelength,
                   seed, context);
  skeleton.choice.resize(mesh.edges.size(), FoldChoice::None);
  std::vector<double> energies(mesh.edges.size(), kAcross);
  parallel_chunks(context, mesh.edges.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (int e = int(begin); e < int(end); ++e) {
      const glm::dvec2 compression = compression_at(field, mesh.middle(e));
      if (compression == glm::dvec2(0.0)) continue;
      energies[e] = energy(mesh.along(e), compression);
      if (energies[e] < kSteepest && mesh.edges[e].left >= 0 && mesh.edges[e].right >= 0 &&
          below_dual_edges(mesh, e, compression, energies[e]))
        skeleton.choice[e] = FoldChoice::ByEnergy;
    }
  });
  skeleton.edits_without_effect = edit_choice(mesh, wavelength, edits, skeleton.choice);
  open_closed_faces(skeleton, energies);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    if (skeleton.choice[e] != FoldChoice::None)
      skeleton.top.push_back({mesh.points[mesh.edges[e].a], mesh.points[mesh.edges[e].b]});
  skeleton.bottom.reserve(2 * mesh.faces.size());
  for (int f = 0; f < int(mesh.faces.size()); ++f) append_bottom(skeleton, f, skeleton.bottom);
  return skeleton;
}

}  // namespace orogen
