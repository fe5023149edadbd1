#include <cmath>
#include <fstream>

#include "foundation/errors.h"
#include "inputs/geojson.h"
#include "inputs/json_document.h"
#include "inputs/json_members.h"
#include "inputs/map_draft.h"
#include "inputs/ring_arrangement.h"

namespace orogen {
namespace {

/// Gathers the features of one document; positions stay as written until `project`.
class Reader {
 public:
  Reader(JsonDocument document, const ReadOptions& options)
      : document_(std::move(document)), options_(options), early_(options.strict) {}

  VectorMap read() {
    const json& root = document_.root;
    if (!root.is_object()) refuse("document", "must be a GeoJSON object, not " + brief(root));
    const std::string type = text_member(root, "type", "document");
    read_header(root);
    if (type == "Feature") {
      add_feature(root, 0);
    } else if (type == "FeatureCollection") {
      const json* features = member(root, "features");
      if (!features || !features->is_array()) refuse("features", "must be a list of features");
      if (features->empty()) refuse("features", "the list is empty: a map needs at least one");
      for (std::size_t i = 0; i < features->size(); ++i) add_feature((*features)[i], int(i));
    } else {
      refuse("type", "must be 'FeatureCollection' or 'Feature', not '" + shown(type) + "'");
    }
    return finish();
  }

 private:
  void read_header(const json& root) {
    draft_.map.name = text_member(root, "name", "document");
    const std::string units = text_member(root, "units", "document");
    if (units == "km")
      units_ = MapUnits::Kilometres;
    else if (units == "m")
      units_ = MapUnits::Metres;
    else if (!units.empty() && units != "degrees")
      refuse("units", "must be 'degrees', 'km' or 'm', not '" + shown(units) + "'");
    if (const json* crs = member(root, "crs")) check_crs(*crs);
    const json* frame = member(root, "frame");
    if (!frame) return;
    if (!frame->is_object()) refuse("frame", "must be an object, not " + brief(*frame));
    Frame& f = draft_.map.frame;
    f.proj4 = text_member(*frame, "proj4", "frame");
    const auto origin = pair_member(*frame, "origin_m", "frame");
    const auto size = pair_member(*frame, "size_km", "frame");
    f.origin = origin.value_or(glm::dvec2(0.0));
    if (!(std::fabs(f.origin.x) <= kFarthest && std::fabs(f.origin.y) <= kFarthest))
      refuse("frame.origin_m", "must lie within 20,000 km");
    if (!size) return;
    f.size = *size * 1000.0;
    if (!(std::fmin(f.size.x, f.size.y) >= 100.0) || !(std::fmax(f.size.x, f.size.y) <= kFarthest))
      refuse("frame.size_km", "must be from 0.1 to 20000 km each way");
    if (units_ == MapUnits::Degrees && (f.proj4.empty() || !origin))
      refuse("frame", "a frame with a size needs 'proj4' and 'origin_m' on a map in degrees");
  }

  static void check_crs(const json& crs) {
    const std::string text = crs.dump();
    if (text.find("CRS84") == text.npos && text.find("4326") == text.npos)
      refuse("crs", "only WGS84 longitude and latitude; for a planar map use 'units' and 'frame'");
  }

  void add_feature(const json& feature, int number) {
    const std::string place = "features[" + std::to_string(number) + "]";
    if (!feature.is_object()) refuse(place, "must be an object, not " + brief(feature));
    if (text_member(feature, "type", place) != "Feature")
      refuse(place + ".type", "must be 'Feature'");
    const json* properties = member(feature, "properties");
    static const json kNone = json::object();
    if (properties && !properties->is_object())
      refuse(place + ".properties", "must be an object, not " + brief(*properties));
    const json* geometry = member(feature, "geometry");
    if (!geometry) {
      early_.warn(place + ".geometry: is missing; the feature is left out");
      return;
    }
    const json& said = properties ? *properties : kNone;
    std::string kind = text_member(said, "kind", place + ".properties");
    if (kind == "volcano") kind = "peak", volcano_kind_ = true;
    if (!kind.empty() && kind != "coast" && kind != "river" && kind != "peak" && kind != "lake") {
      early_.warn(place + ".properties.kind: '" + shown(kind) +
                  "' is none of coast, river, peak, lake; the feature is left out");
      return;
    }
    add_geometry(*geometry, said, kind, number, place + ".geometry");
    volcano_kind_ = false;
  }

  void add_geometry(const json& geometry, const json& said, std::string kind, int number,
                    const std::string& place) {
    if (!geometry.is_object()) refuse(place, "must be an object, not " + brief(geometry));
    const std::string type = text_member(geometry, "type", place);
    if (type == "GeometryCollection") {
      const json* parts = member(geometry, "geometries");
      if (!parts || !parts->is_array()) refuse(place + ".geometries", "must be a list");
      for (std::size_t i = 0; i < parts->size(); ++i)
        add_geometry((*parts)[i], said, kind, number,
                     place + ".geometries[" + std::to_string(i) + "]");
      return;
    }
    static constexpr struct {
      const char *type, *kind;
      int depth;
    } kTypes[] = {{"Point", "peak", 0},       {"MultiPoint", "peak", 1},
                  {"LineString", "river", 1}, {"MultiLineString", "river", 2},
                  {"Polygon", "coast", 2},    {"MultiPolygon", "coast", 3}};
    for (const auto& t : kTypes) {
      if (type != t.type) continue;
      if (kind.empty()) {
        kind = t.kind;
        early_.warn("features[" + std::to_string(number) + "]: has no kind; as a " + type +
                    " it is taken for a " + kind);
      }
      add_shape(coordinates(geometry, place), type, t.depth,
                {said, kind, number, place + ".coordinates"});
      return;
    }
    refuse(place + ".type", "must be a GeoJSON geometry, not '" + shown(type) + "'");
  }

  const Coordinates& coordinates(const json& geometry, const std::string& place) const {
    const auto it = geometry.find("coordinates");
    if (it == geometry.end() || !it->is_binary())
      refuse(place + ".coordinates", "must be a list of positions");
    return document_.coordinates[it->get_binary().subtype()];
  }

  struct Subject {
    const json& said;
    std::string kind;
    int feature;
    std::string place;  // of the coordinates
  };

  void add_shape(const Coordinates& c, const std::string& type, int depth, const Subject& s) {
    const bool area = type == "Polygon" || type == "MultiPolygon";
    const bool line = type == "LineString" || type == "MultiLineString";
    if (s.kind == "peak" ? area || line : s.kind == "river" ? !line : !area && !line)
      refuse("features[" + std::to_string(s.feature) + "].geometry.type",
             "a " + s.kind + " cannot be a " + type);
    if (type == "MultiPolygon" || type == "MultiLineString" || type == "MultiPoint") {
      if (type == "MultiPoint") {
        expect_positions(c, s.place);
        for (std::size_t i = 0; i < c.positions.size(); ++i) add_peak(c.positions[i], at(s, i));
        return;
      }
      if (c.single || !c.positions.empty()) refuse(s.place, "is nested too little for a " + type);
      for (std::size_t i = 0; i < c.parts.size(); ++i) add_one(c.parts[i], depth - 1, at(s, i));
      return;
    }
    add_one(c, depth, s);
  }

  void add_one(const Coordinates& c, int depth, const Subject& s) {
    if (depth == 0) {
      if (!c.single) refuse(s.place, "must be one position");
      add_peak(c.positions[0], s);
    } else if (depth == 1) {
      expect_positions(c, s.place);
      if (c.positions.size() < 2) refuse(s.place, "a line needs at least two positions");
      add_line(c.positions, s);
    } else {
      add_polygon(c, s);
    }
  }

  static Subject at(const Subject& s, std::size_t i) {
    return {s.said, s.kind, s.feature, s.place + "[" + std::to_string(i) + "]"};
  }
  static void expect_positions(const Coordinates& c, const std::string& place) {
    if (c.single || !c.parts.empty()) refuse(place, "must be a list of positions");
    if (c.positions.empty()) refuse(place, "is empty");
  }

  void add_polygon(const Coordinates& c, const Subject& s) {
    if (c.single || !c.positions.empty()) refuse(s.place, "must be a list of rings");
    if (c.parts.empty()) refuse(s.place, "is empty: a polygon needs a ring");
    std::vector<Ring> rings;
    for (std::size_t r = 0; r < c.parts.size(); ++r) {
      const std::string place = s.place + "[" + std::to_string(r) + "]";
      expect_positions(c.parts[r], place);
      if (c.parts[r].positions.size() < 3)
        refuse(place, "a ring needs at least three different positions");
      if (c.parts[r].positions.front() != c.parts[r].positions.back())
        draft_.open_rings.push_back(
            {s.kind == "lake",
             s.kind == "lake" ? draft_.map.lakes.size() : draft_.map.coasts.size(), r});
      rings.push_back(planar(c.parts[r].positions, place));
    }
    const std::string words = "features[" + std::to_string(s.feature) + "].properties";
    const std::string name = text_member(s.said, "name", words);
    std::vector<Ring> holes(rings.begin() + 1, rings.end());
    if (s.kind == "lake") {
      draft_.map.lakes.push_back({std::move(rings[0]), std::move(holes),
                                  number_member(s.said, "level_m", words), name, s.feature});
      return;
    }
    const bool clipped = boolean_member(s.said, "clipped", words).value_or(false);
    draft_.map.coasts.push_back({std::move(rings[0]), std::move(holes), clipped, name, s.feature});
  }

  void add_line(const std::vector<glm::dvec2>& positions, const Subject& s) {
    const std::string words = "features[" + std::to_string(s.feature) + "].properties";
    const std::string name = text_member(s.said, "name", words);
    Polyline points = planar(positions, s.place);
    if (s.kind == "coast") {
      const bool clipped = boolean_member(s.said, "clipped", words).value_or(false);
      draft_.pieces.push_back({std::move(points), clipped, name, s.feature});
      return;
    }
    if (s.kind == "lake") {
      if (points.front() != points.back())
        draft_.open_rings.push_back({true, draft_.map.lakes.size(), 0});
      draft_.map.lakes.push_back(
          {std::move(points), {}, number_member(s.said, "level_m", words), name, s.feature});
      return;
    }
    River river{
        std::move(points), RiverEnd::Sea, -1, number_member(s.said, "end_height_m", words), 0, name,
        s.feature};
    RiverHint hint;
    const std::string ends = text_member(s.said, "ends", words);
    if (ends == "sea") hint.end = RiverEnd::Sea;
    if (ends == "river") hint.end = RiverEnd::River;
    if (ends == "lake") hint.end = RiverEnd::Lake;
    if (ends == "frame") hint.end = RiverEnd::Frame;
    if (!ends.empty() && !hint.end)
      refuse(words + ".ends", "must be sea, river, lake or frame, not '" + shown(ends) + "'");
    hint.source_first = text_member(s.said, "direction", words) == "source to mouth";
    const auto rank = number_member(s.said, "rank", words).value_or(0.0);
    if (!(rank >= 0.0 && rank <= 100.0)) refuse(words + ".rank", "must be from 0 to 100");
    river.rank = int(rank);
    draft_.map.rivers.push_back(std::move(river));
    draft_.hints.push_back(hint);
  }

  void add_peak(glm::dvec2 position, const Subject& s) {
    const std::string words = "features[" + std::to_string(s.feature) + "].properties";
    Peak peak{planar({position}, s.place)[0], number_member(s.said, "height_m", words),
              text_member(s.said, "name", words), s.feature,
              boolean_member(s.said, "volcano", words)};
    if (volcano_kind_) peak.volcano = true;
    draft_.map.peaks.push_back(std::move(peak));
  }

  /// Metres for a planar map; degrees, checked and gathered, for the others.
  std::vector<glm::dvec2> planar(std::vector<glm::dvec2> points, const std::string& place) {
    const double metres = units_ == MapUnits::Kilometres ? 1000.0 : 1.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      glm::dvec2& p = points[i];
      const auto where = [&] {
        return points.size() > 1 ? place + "[" + std::to_string(i) + "]" : place;
      };
      if (units_ == MapUnits::Degrees) {
        if (!(std::fabs(p.x) <= 360.0 && std::fabs(p.y) <= 90.0))
          refuse(where(), "(" + json(p.x).dump() + ", " + json(p.y).dump() +
                              ") is no longitude and latitude in degrees; a planar map says "
                              "\"units\": \"km\" or \"m\"");
        continue;
      }
      p = p * metres + draft_.map.frame.origin;
      if (!(std::fabs(p.x) <= kFarthest && std::fabs(p.y) <= kFarthest))
        refuse(where(), "(" + json(points[i].x).dump() + " m, " + json(points[i].y).dump() +
                            " m) lies beyond 20,000 km");
    }
    return points;
  }

  template <class Change>
  void for_each_line(Change&& change) {
    for (Coast& c : draft_.map.coasts) {
      change(c.outer, c.feature);
      for (Ring& hole : c.holes) change(hole, c.feature);
    }
    for (Lake& l : draft_.map.lakes) {
      change(l.outer, l.feature);
      for (Ring& island : l.islands) change(island, l.feature);
    }
    for (CoastPiece& c : draft_.pieces) change(c.points, c.feature);
    for (River& r : draft_.map.rivers) change(r.points, r.feature);
    for (Peak& p : draft_.map.peaks) {
      std::vector<glm::dvec2> one{p.position};
      change(one, p.feature);
      p.position = one[0];
    }
  }

  void project(const Projection& projection) {
    for_each_line([&](std::vector<glm::dvec2>& points, int feature) {
      for (glm::dvec2& p : points) {
        const glm::dvec2 g = p;
        p = projection.project(g);
        if (!(std::fabs(p.x) <= kFarthest && std::fabs(p.y) <= kFarthest))
          refuse("features[" + std::to_string(feature) + "]",
                 "(" + json(g.x).dump() + "°, " + json(g.y).dump() +
                     "°) cannot be shown in the projection '" + projection.proj4() + "'");
      }
    });
  }

  VectorMap finish() {
    Frame& frame = draft_.map.frame;
    std::optional<Projection> projection;
    if (!frame.proj4.empty()) {
      try {
        projection.emplace(frame.proj4);
      } catch (const InputError& error) {
        throw InputError("frame." + std::string(error.what()));
      }
    }
    if (units_ == MapUnits::Degrees) {
      if (!projection) {
        std::vector<glm::dvec2> all;
        for_each_line(
            [&](const auto& points, int) { all.insert(all.end(), points.begin(), points.end()); });
        if (all.empty()) refuse("features", "none is a coast, river, peak or lake");
        const glm::dvec2 middle = mean_direction(all);
        projection = Projection::about(middle.x, middle.y);
        frame.proj4 = projection->proj4();
      }
      project(*projection);
    }
    MapReport report(options_.strict, units_, frame.origin);
    if (projection) report.set_projection(*projection);
    for (const std::string& warning : early_.take_warnings()) report.warn(warning);
    return finish_map(std::move(draft_), options_, std::move(report));
  }

  JsonDocument document_;
  ReadOptions options_;
  MapReport early_;
  MapUnits units_ = MapUnits::Degrees;
  MapDraft draft_;
  bool volcano_kind_ = false;
};

}  // namespace

VectorMap read_geojson(std::string_view text, const ReadOptions& options) {
  return Reader(parse_json(text), options).read();
}

VectorMap read_geojson_file(const std::filesystem::path& path, const ReadOptions& options) {
  std::error_code error;
  const auto bytes = std::filesystem::file_size(path, error);
  if (error) throw InputError(path.string() + ": cannot be read: " + error.message());
  if (bytes > JsonLimits{}.bytes)
    throw InputError(path.string() + ": larger than " + std::to_string(JsonLimits{}.bytes >> 20) +
                     " MiB (" + std::to_string(bytes) + " bytes)");
  std::string text(bytes, '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(text.data(), std::streamsize(bytes)))
    throw InputError(path.string() + ": cannot be read");
  try {
    VectorMap map = read_geojson(text, options);
    if (map.name.empty()) map.name = path.stem().string();
    return map;
  } catch (const InputError& error) {
    throw InputError(path.filename().string() + ": " + error.what());
  }
}

}  // namespace orogen
