#include "tectonics/plate_merging.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace orogen {

namespace {

struct Cluster {
  double area;
  glm::dvec2 velocity;
  std::vector<int> members;  // in order
  std::set<int> neighbours;
};

class Merger {
 public:
  Merger(const std::vector<SubPlate>& sub_plates,
         const std::vector<std::pair<int, int>>& neighbours, const MergeThresholds& thresholds)
      : sub_plates_(sub_plates), thresholds_(thresholds), owner_(sub_plates.size()) {
    double fastest = 0.0;
    for (int i = 0; i < int(sub_plates.size()); ++i) {
      const SubPlate& s = sub_plates[i];
      clusters_.push_back({s.area, s.velocity, {i}, {}});
      owner_[i] = i;
      fastest = std::max(fastest, std::hypot(s.velocity.x, s.velocity.y));
    }
    slow_ = thresholds.slow * fastest;
    for (auto [a, b] : neighbours)
      if (a != b) clusters_[a].neighbours.insert(b), clusters_[b].neighbours.insert(a);
  }

  std::vector<int> run() {
    while (merge_alike() || merge_small()) {
    }
    std::vector<int> number(owner_.size(), -1), result;
    int count = 0;
    for (int owner : owner_) {
      if (number[owner] < 0) number[owner] = count++;
      result.push_back(number[owner]);
    }
    return result;
  }

 private:
  bool may_merge(int a, int b) const {
    for (int m : clusters_[a].members) {
      const int opposite = sub_plates_[m].opposite;
      if (opposite >= 0 && owner_[opposite] == b) return false;
    }
    return true;
  }

  // Cosine between two directions; -2 if either has none.
  double likeness(int a, int b) const {
    const glm::dvec2 u = clusters_[a].velocity, v = clusters_[b].velocity;
    const double lu = std::hypot(u.x, u.y), lv = std::hypot(v.x, v.y);
    return lu > slow_ && lv > slow_ ? (u.x * v.x + u.y * v.y) / (lu * lv) : -2.0;
  }

  bool merge_alike() {
    int best_a = -1, best_b = -1;
    double best = thresholds_.direction;
    for (int a = 0; a < int(clusters_.size()); ++a)
      for (int b : clusters_[a].neighbours) {
        if (b < a) continue;
        const double cosine = likeness(a, b);
        if (cosine > best && may_merge(a, b)) best = cosine, best_a = a, best_b = b;
      }
    if (best_a < 0) return false;
    merge(best_a, best_b);
    return true;
  }

  int largest_neighbour(int a) const {
    int largest = -1;
    for (int b : clusters_[a].neighbours)
      if (may_merge(a, b) && (largest < 0 || clusters_[b].area > clusters_[largest].area))
        largest = b;
    return largest;
  }

  bool merge_small() {
    int smallest = -1, into = -1;
    for (int a = 0; a < int(clusters_.size()); ++a) {
      if (clusters_[a].members.empty()) continue;
      const int b = largest_neighbour(a);
      if (b < 0 || !(clusters_[a].area < thresholds_.area * clusters_[b].area)) continue;
      if (smallest < 0 || clusters_[a].area < clusters_[smallest].area) smallest = a, into = b;
    }
    if (smallest < 0) return false;
    merge(std::min(smallest, into), std::max(smallest, into));
    return true;
  }

  void merge(int a, int b) {
    Cluster &to = clusters_[a], &from = clusters_[b];
    const double area = to.area + from.area;
    if (area > 0.0) to.velocity = (to.area * to.velocity + from.area * from.velocity) / area;
    to.area = area;
    for (int m : from.members) owner_[m] = a;
    to.members.insert(to.members.end(), from.members.begin(), from.members.end());
    for (int n : from.neighbours) {
      clusters_[n].neighbours.erase(b);
      if (n != a) clusters_[n].neighbours.insert(a), to.neighbours.insert(n);
    }
    from = {0.0, {0.0, 0.0}, {}, {}};
  }

  const std::vector<SubPlate>& sub_plates_;
  const MergeThresholds thresholds_;
  std::vector<int> owner_;
  std::vector<Cluster> clusters_;
  double slow_ = 0.0;
};

}  // namespace

std::vector<int> merge_plates(const std::vector<SubPlate>& sub_plates,
                              const std::vector<std::pair<int, int>>& neighbours,
                              const MergeThresholds& thresholds) {
  return Merger(sub_plates, neighbours, thresholds).run();
}

}  // namespace orogen
