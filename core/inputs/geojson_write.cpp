#include <nlohmann/json.hpp>

#include "inputs/geojson.h"

namespace orogen {
namespace {

using nlohmann::ordered_json;

class Writer {
 public:
  explicit Writer(const VectorMap& map) : map_(map) {}

  std::string write() {
    for (const Coast& c : map_.coasts) {
      ordered_json p{{"kind", "coast"}, {"name", c.name}};
      if (c.clipped) p["clipped"] = true;
      add("Polygon", polygon(c.outer, c.holes), std::move(p));
    }
    for (const Lake& l : map_.lakes) {
      ordered_json p{{"kind", "lake"}, {"name", l.name}};
      if (l.level_m) p["level_m"] = *l.level_m;
      add("Polygon", polygon(l.outer, l.islands), std::move(p));
    }
    for (const River& r : map_.rivers) add_river(r);
    for (const Peak& k : map_.peaks) {
      ordered_json p{{"kind", "peak"}, {"name", k.name}};
      if (k.height_m) p["height_m"] = *k.height_m;
      if (k.volcano) p["volcano"] = *k.volcano;
      add("Point", position(k.position), std::move(p));
    }
    const Frame& f = map_.frame;
    ordered_json frame{{"origin_m", {f.origin.x, f.origin.y}},
                       {"size_km", {f.size.x / 1000.0, f.size.y / 1000.0}}};
    if (!f.proj4.empty()) frame["proj4"] = f.proj4;
    return ordered_json{{"type", "FeatureCollection"},
                        {"name", map_.name},
                        {"units", "m"},
                        {"frame", std::move(frame)},
                        {"features", std::move(features_)}}
        .dump();
  }

 private:
  void add_river(const River& r) {
    static constexpr const char* kEnds[] = {"sea", "river", "lake", "frame"};
    ordered_json p{{"kind", "river"},
                   {"name", r.name},
                   {"ends", kEnds[int(r.end)]},
                   {"direction", "source to mouth"}};
    if (r.end_height_m) p["end_height_m"] = *r.end_height_m;
    if (r.rank) p["rank"] = r.rank;
    add("LineString", line(r.points), std::move(p));
  }
  ordered_json position(glm::dvec2 p) const {
    const glm::dvec2 q = p - map_.frame.origin;
    return {q.x, q.y};
  }
  ordered_json line(const std::vector<glm::dvec2>& points) const {
    ordered_json list = ordered_json::array();
    for (const glm::dvec2 p : points) list.push_back(position(p));
    return list;
  }
  ordered_json ring(const Ring& points) const {
    ordered_json list = line(points);
    if (!points.empty()) list.push_back(position(points.front()));
    return list;
  }
  ordered_json polygon(const Ring& outer, const std::vector<Ring>& inner) const {
    ordered_json list = ordered_json::array({ring(outer)});
    for (const Ring& r : inner) list.push_back(ring(r));
    return list;
  }
  void add(const char* type, ordered_json coordinates, ordered_json properties) {
    if (properties["name"] == "") properties.erase("name");
    features_.push_back({{"type", "Feature"},
                         {"properties", std::move(properties)},
                         {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}}});
  }

  const VectorMap& map_;
  ordered_json features_ = ordered_json::array();
};

}  // namespace

std::string write_geojson(const VectorMap& map) {
  return Writer(map).write();
}

}  // namespace orogen
