#include "inputs/geojson.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "inputs/projection.h"
#include "inputs/test_maps.h"

namespace orogen {
namespace {

using namespace test;

struct Refused {
  std::string text;
  std::vector<std::string> says;  // all of these stand in the message
};

void expect_refused(const std::vector<Refused>& cases) {
  for (const Refused& c : cases) {
    const std::string message = refusal(c.text);
    for (const std::string& words : c.says)
      EXPECT_NE(message.find(words), std::string::npos)
          << "'" << message << "' does not say '" << words << "'";
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

std::string deep(int levels) {
  return R"({"type": "FeatureCollection", "features": )" + std::string(levels, '[') +
         std::string(levels, ']') + "}";
}

TEST(ReadGeojson, RefusesWhatIsNoJson) {
  expect_refused({
      {"", {"document (offset", "is not JSON"}},
      {"{", {"offset 2"}},
      {R"({"type": "FeatureCollection", "features": [{"type": "Feature", NaN}]})",
       {"features[0]", "offset"}},
      {collection(peak("[NaN, 1]")), {"features[0].geometry.coordinates[0] (offset"}},
      {collection(peak("[1, Infinity]")), {"features[0].geometry.coordinates[1] (offset"}},
      {collection(peak("[1, 1e999]")), {"features[0].geometry.coordinates[1] (offset", "1e999"}},
      {collection(peak("[1, 1]", R"(, "height_m": -1e999)")),
       {"features[0].properties.height_m (offset"}},
      {deep(64), {"features[0][0]", "deeper than 64"}},
      {collection(feature(R"("kind": "coast")", "Polygon",
                          std::string(100000, '[') + std::string(100000, ']'))),
       {"features[0].geometry.coordinates[0]", "deeper than 64"}},
      {R"({"type": "FeatureCollection", "type": "x"})", {"type", "stands twice"}},
      {std::string("{\"type\": \"\xff\"}"), {"offset"}},
      {"{} {}", {"offset"}},
  });
  EXPECT_THROW(read_geojson(deep(62)), InputError);  // for its features, not its depth
}

TEST(ReadGeojson, RefusesWhatIsNoMap) {
  expect_refused({
      {"[]", {"document: must be a GeoJSON object"}},
      {"{}", {"type: must be 'FeatureCollection'"}},
      {R"({"type": 7})", {"document.type: must be text, not 7"}},
      {R"({"type": "Topology"})", {"type:", "'Topology'"}},
      {R"({"type": "FeatureCollection"})", {"features: must be a list"}},
      {R"({"type": "FeatureCollection", "features": {}})", {"features: must be a list"}},
      {collection(""), {"features: the list is empty"}},
      {collection("7"), {"features[0]: must be an object, not 7"}},
      {collection(R"({"type": "Thing"})"), {"features[0].type"}},
      {collection(R"({"type": "Feature", "geometry": null})"), {"features: none is a coast"}},
      {collection(R"({"type": "Feature", "properties": [], "geometry": {}})"),
       {"features[0].properties: must be an object"}},
      {collection(R"({"type": "Feature", "geometry": 3})"), {"features[0].geometry"}},
      {collection(feature(R"("kind": "coast")", "Circle", "[1, 2]")),
       {"features[0].geometry.type", "'Circle'"}},
      {collection(R"({"type": "Feature", "properties": {"kind": "peak"},
                      "geometry": {"type": "Point"}})"),
       {"features[0].geometry.coordinates: must be a list"}},
      {collection(R"({"type": "Feature", "properties": {"kind": "peak"},
                      "geometry": {"type": "Point", "coordinates": 0}})"),
       {"features[0].geometry.coordinates: must be a list"}},
      {collection(island(), R"("units": "miles",)"), {"units:", "'miles'"}},
      {collection(island(), R"("units": 3,)"), {"document.units: must be text"}},
      {collection(island(), R"("crs": {"properties": {"name": "EPSG:27700"}},)"), {"crs:"}},
      {collection(island(), R"("units": "km", "frame": 3,)"), {"frame: must be an object"}},
      {collection(island(), R"("units": "km", "frame": {"size_km": [1]},)"), {"frame.size_km"}},
      {collection(island(), R"("units": "km", "frame": {"size_km": [0, 5]},)"), {"frame.size_km"}},
      {collection(island(), R"("units": "km", "frame": {"origin_m": [1e300, 0]},)"),
       {"frame.origin_m"}},
      {collection(island(), R"("units": "km", "frame": {"proj4": "+proj=robin"},)"),
       {"frame.proj4", "'robin'"}},
      {collection(island(),
                  R"("units": "km", "frame": {"origin_m": [5e6, 0], "size_km": [9, 9]},)"),
       {"frame: no coast lies inside it"}},
      {collection(island(), R"("frame": {"size_km": [9, 9]},)"), {"frame: a frame with a size"}},
  });
}

TEST(ReadGeojson, RefusesWrongTypesAndShapes) {
  const std::string coast = R"("kind": "coast")";
  expect_refused({
      {collection(feature(coast, "Point", "[1, 2]")), {"features[0]", "coast cannot be a Point"}},
      {collection(feature(R"("kind": "peak")", "LineString", "[[1, 2], [3, 4]]")),
       {"features[0]", "peak cannot be a LineString"}},
      {collection(feature(R"("kind": "river")", "Polygon", "[[[1, 2], [3, 4], [1, 2]]]")),
       {"features[0]", "river cannot be a Polygon"}},
      {collection(feature(R"("kind": 5)", "Point", "[1, 2]")), {"features[0].properties.kind"}},
      {collection(peak("[1]")), {"features[0].geometry.coordinates: a position needs two"}},
      {collection(peak("[]")), {"features[0].geometry.coordinates"}},
      {collection(peak("[[1, 2]]")), {"features[0].geometry.coordinates: must be one position"}},
      {collection(peak(R"(["1", 2])")), {"features[0].geometry.coordinates[0]", "not text"}},
      {collection(peak("[1, null]")), {"features[0].geometry.coordinates[1]", "not null"}},
      {collection(river("[1, 2]")), {"features[0].geometry.coordinates"}},
      {collection(river("[[1, 2]]")), {"features[0].geometry.coordinates", "two positions"}},
      {collection(river("[[1, 2], [3]]")), {"features[0].geometry.coordinates[1]"}},
      {collection(river("[[1, 2], [[3, 4]]]")), {"features[0].geometry.coordinates[1]"}},
      {collection(river("[[1, 2], 3]")), {"features[0].geometry.coordinates[1]"}},
      {collection(feature(coast, "Polygon", "[]")), {"features[0].geometry.coordinates", "ring"}},
      {collection(feature(coast, "Polygon", "[[]]")), {"features[0].geometry.coordinates[0]"}},
      {collection(feature(coast, "Polygon", "[[[1, 2], [3, 4]]]")),
       {"features[0].geometry.coordinates[0]", "three"}},
      {collection(feature(coast, "Polygon", "[[1, 2], [3, 4], [5, 6]]")),
       {"features[0].geometry.coordinates", "rings"}},
      {collection(feature(coast, "MultiPolygon", "[[[1, 2], [3, 4], [5, 6]]]")),
       {"features[0].geometry.coordinates[0]"}},
      {collection(peak("[1, 2]", R"(, "height_m": "high")")),
       {"features[0].properties.height_m", "'high'"}},
      {collection(peak("[1, 2]", R"(, "name": 7)")), {"features[0].properties.name"}},
      {collection(peak("[1, 2]", R"(, "volcano": 1)")), {"features[0].properties.volcano"}},
      {collection(island() + "," + river("[[20, 20], [30, 30]]", R"(, "ends": "moon")")),
       {"features[1].properties.ends", "'moon'"}},
      {collection(island() + "," + river("[[20, 20], [30, 30]]", R"(, "rank": -1)")),
       {"features[1].properties.rank"}},
      {collection(island() + "," + river("[[20, 20], [30, 30]]", R"(, "end_height_m": 1e5)")),
       {"features[1] (river)", "end_height_m"}},
  });
}

TEST(ReadGeojson, RefusesPlacesThatCannotBe) {
  expect_refused({
      {collection(peak("[1e12, 0]")), {"features[0].geometry.coordinates", "20,000 km"}},
      {collection(river("[[20, 20], [30, -1e300]]")),
       {"features[0].geometry.coordinates[1]", "20,000 km"}},
      {collection(peak("[500000, 4650000]"), ""),
       {"features[0].geometry.coordinates", "longitude and latitude", "units"}},
      {collection(
           feature(R"("kind": "peak")", "MultiPoint", "[[0, 0], [90, 0], [180, 0], [-90, 0]]"), ""),
       {"features: the places are spread"}},
  });
}

TEST(ReadGeojson, RefusesBrokenCoastsByFeatureVertexAndPlace) {
  const auto polygon = [](const std::string& rings, const std::string& more = "") {
    return feature(R"("kind": "coast", "name": "X")" + more, "Polygon", rings);
  };
  expect_refused({
      {collection(polygon("[[[0,0],[10,10],[10,0],[0,12],[0,0]]]")),
       {"features[0] (coast 'X'), ring 0, vertex ", "crosses or touches itself",
        "(5.455 km, 5.455 km)"}},
      {collection(polygon("[[[0,0],[10,0],[10,10],[5,0],[0,10],[0,0]]]")),
       {"features[0] (coast 'X')", "touches itself", "(5.000 km, 0.000 km)"}},
      {collection(polygon("[[[0,0],[10,0],[10,10],[5,5],[0,10],[5,5],[0,0]]]")),
       {"features[0] (coast 'X')", "touches itself", "(5.000 km, 5.000 km)"}},
      {collection(polygon("[[[0,0],[10,0],[20,0],[10,0],[0,0]]]")),
       {"features[0] (coast 'X'), ring 0", "no area"}},
      {collection(polygon("[[[0,0],[10,0],[10,0],[0,0]]]")),
       {"features[0] (coast 'X'), ring 0", "three different"}},
      {collection(polygon("[[[0,0],[10,0],[10,10],[0,10],[0,5]]]")),
       {"features[0] (coast 'X'), ring 0", "stays open at (0.000 km, 5.000 km)", "5.0 km away"}},
      {collection(island() + "," + polygon("[[[100,100],[120,100],[120,120],[100,100]]]")),
       {"features[0] (coast 'I')", "features[1] (coast 'X')", "(110.000 km, "}},
      {collection(island() + "," + polygon("[[[20,20],[30,20],[30,30],[20,20]]]")),
       {"features[1] (coast 'X')", "on land", "inside features[0] (coast 'I')",
        "(20.000 km, 20.000 km)"}},
      {collection(polygon("[[[0,0],[10,0],[10,10],[0,0]],[[20,20],[30,20],[30,30],[20,20]]]")),
       {"features[0] (coast 'X'), ring 1", "outside its coast at (30.000 km, 30.000 km)"}},
      {collection(
           feature(R"("kind": "coast", "name": "X")", "LineString", "[[0,0],[50,0],[50,50]]")),
       {"features[0] (coast 'X')", "stays open at (50.000 km, 50.000 km)"}},
      {collection(island() + "," +
                  feature(R"("kind": "lake", "name": "L")", "Polygon",
                          "[[[200,0],[210,0],[210,10],[200,0]]]")),
       {"features[1] (lake 'L')", "in the sea", "(200.000 km, 0.000 km)"}},
      {collection(island() + "," +
                  feature(R"("kind": "lake", "name": "L")", "Polygon",
                          "[[[100,20],[120,20],[120,30],[100,20]]]")),
       {"features[1] (lake 'L')", "features[0] (coast 'I')", "(110.000 km"}},
  });
}

TEST(ReadGeojson, RefusesPeaksThatCannotBe) {
  const auto with = [](const std::string& peaks) { return collection(island() + "," + peaks); };
  expect_refused({
      {with(peak("[114.2, 50]", R"(, "name": "Monte X", "height_m": 900)")),
       {"features[1] (peak 'Monte X'): lies 4.2 km out at sea at (114.200 km, 50.000 km); peaks "
        "must stand on land"}},
      {with(peak("[50, 50]", R"(, "height_m": 0)")),
       {"features[1] (peak)", "at most 12000 m", "0 m"}},
      {with(peak("[50, 50]", R"(, "height_m": -5)")), {"features[1] (peak)", "-5 m"}},
      {with(peak("[50, 50]", R"(, "height_m": 12000.5)")), {"features[1] (peak)", "12000.5 m"}},
      {with(peak("[50, 50]", R"(, "name": "A", "height_m": 900)") + "," +
            peak("[50.03, 50]", R"(, "name": "B", "height_m": 901)")),
       {"features[2] (peak 'B')", "features[1] (peak 'A')", "901 m and 900 m"}},
  });
}

TEST(ReadGeojson, PlacesAreInDegreesOnMapsInDegrees) {
  const std::string text = collection(
      feature(R"("kind": "coast")", "Polygon", "[[[9,42],[9.5,42],[9.5,42.5],[9,42.5],[9,42]]]") +
          "," + peak("[9.6, 42.3]", R"(, "name": "Monte X")"),
      "");
  const std::string message = refusal(text);
  EXPECT_NE(message.find("features[1] (peak 'Monte X'): lies 8.2 km out at sea at (9.6000°, "
                         "42.3000°)"),
            std::string::npos)
      << message;
}

TEST(ReadGeojson, MendsWithAWarning) {
  struct Mended {
    std::string features, says;
  };
  const std::vector<Mended> cases{
      {feature(R"("kind": "coast")", "Polygon", "[[[0,0],[50,0],[50,50],[0,50],[0,0.3]]]"),
       "its beginning lies 300 m away; closed"},
      {feature(R"("kind": "coast")", "MultiLineString",
               "[[[0,0],[50,0],[50,50]],[[0,0.1],[0,50],[49.9,50]]]"),
       "a gap of 100 m"},
      {feature(R"("kind": "coast")", "Polygon", "[[[0,0],[50,0],[50,0],[50,50],[0,50],[0,0]]]"),
       "1 repeated point removed"},
      {island() + "," + feature(R"("kind": "city")", "Point", "[20, 20]"), "'city'"},
      {island() + "," + feature("", "Point", "[20, 20]"), "has no kind"},
      {island() + "," + peak("[110.4, 20]"), "400 m out at sea at (110.400 km, 20.000 km); moved"},
      {island() + "," + peak("[50, 50]", R"(, "height_m": 7)") + "," +
           peak("[50, 50]", R"(, "height_m": 7)"),
       "features[2] (peak): repeats features[1] (peak)"},
      {island() + "," + river("[[50, 50], [50, 50]]"), "has no length"},
      {island() + "," + river("[[50, 50], [60, 50], [112, 50]]"), "2.0 km of it lie in the sea"},
      {island() + "," + river("[[50, 50], [60, 50], [107, 50]]"), "ends 3.0 km short of the coast"},
      {island() + R"(, {"type": "Feature", "properties": {}, "geometry": null})", "is missing"},
  };
  for (const Mended& c : cases) {
    const VectorMap map = read_geojson(collection(c.features));
    ASSERT_FALSE(map.warnings.empty()) << c.says;
    EXPECT_NE(map.warnings.back().find(c.says), std::string::npos) << map.warnings.back();
    EXPECT_NE(map.warnings.back().find("features["), std::string::npos) << map.warnings.back();
    EXPECT_THROW(read_geojson(collection(c.features), {.strict = true}), InputError);
    // Mended once, it stays as it is.
    const VectorMap again = read_geojson(write_geojson(map), {.strict = true});
    EXPECT_TRUE(again == map) << c.says;
  }
}

TEST(ReadGeojson, TakesEveryKindOfGeometry) {
  const VectorMap map = read_geojson(collection(
      feature(R"("kind": "coast")", "MultiPolygon",
              "[[[[0,0],[50,0],[50,50],[0,50],[0,0]]],[[[60,0],[90,0],[90,50],[60,0]]]]") +
      "," +
      R"({"type": "Feature", "properties": {"kind": "river"}, "geometry":
          {"type": "GeometryCollection", "geometries": [
            {"type": "LineString", "coordinates": [[10, 10, 7], [10, 0, 7]]},
            {"type": "MultiLineString", "coordinates": [[[20, 10], [20, 0]], [[30, 0], [30, 9]]]}]}})" +
      "," + feature(R"("kind": "peak", "height_m": 5)", "MultiPoint", "[[5, 5], [6, 6]]") + "," +
      feature(R"("kind": "volcano", "height_m": 50)", "Point", "[7, 7]") + "," +
      feature(R"("kind": "lake", "level_m": 300)", "Polygon",
              "[[[40,40],[42,40],[42,42],[40,40]]]")));
  EXPECT_TRUE(map.warnings.empty()) << map.warnings[0];
  EXPECT_EQ(map.coasts.size(), 2u);
  ASSERT_EQ(map.rivers.size(), 3u);
  for (const River& r : map.rivers) EXPECT_EQ(r.points.back().y, 0.0);
  ASSERT_EQ(map.peaks.size(), 3u);
  EXPECT_EQ(map.peaks[1].height_m, 5.0);
  EXPECT_EQ(map.peaks[2].volcano, true);
  EXPECT_EQ(map.peaks[2].feature, 3);
  ASSERT_EQ(map.lakes.size(), 1u);
  EXPECT_EQ(map.lakes[0].level_m, 300.0);
}

TEST(ReadGeojson, NestsCoastsDrawnAsLines) {
  const auto line = [](const std::string& p) {
    return feature(R"("kind": "coast")", "LineString", p);
  };
  const VectorMap map =
      read_geojson(collection(line("[[47,33],[47,37],[43,37],[43,33],[47,33]]") + "," +
                              line("[[0,0],[0,99],[99,99],[99,0],[0,0]]") + "," +
                              line("[[40,30],[50,30],[50,40],[40,40],[40,30]]")));
  ASSERT_EQ(map.coasts.size(), 2u);
  EXPECT_EQ(map.coasts[0].feature, 0);  // the isle in the inland sea
  EXPECT_EQ(map.coasts[1].feature, 1);
  ASSERT_EQ(map.coasts[1].holes.size(), 1u);
  EXPECT_TRUE(map.coasts[0].holes.empty());
}

TEST(ReadGeojson, PlacesPlanarMapsByTheirFrame) {
  const VectorMap plain = read_geojson(collection(island()));
  EXPECT_EQ(plain.frame.origin, glm::dvec2(0.0));
  EXPECT_EQ(plain.frame.size, glm::dvec2(114000.0));
  const VectorMap metres = read_geojson(collection(
      feature(R"("kind": "coast")", "Polygon", "[[[0,0],[5e4,0],[5e4,5e4],[0,5e4],[0,0]]]"),
      R"("units": "m", "frame": {"origin_m": [1000, -500]},)"));
  EXPECT_EQ(metres.coasts[0].outer[0], glm::dvec2(1000.0, -500.0));
  EXPECT_EQ(metres.frame.origin, glm::dvec2(-1000.0, -2500.0));
  EXPECT_EQ(metres.frame.size, glm::dvec2(54000.0));
}

TEST(ReadGeojson, CrossesTheAntimeridian) {
  const VectorMap map = read_geojson(collection(
      feature(R"("kind": "coast")", "Polygon",
              "[[[179.5,-17.5],[-179.5,-17.5],[-179.5,-17],[179.5,-17],[179.5,-17.5]]]") +
          "," + peak("[-179.9, -17.2]", R"(, "height_m": 900)") + "," + peak("[179.9, -17.3]"),
      ""));
  EXPECT_NE(map.frame.proj4.find("+proj=aeqd"), std::string::npos);
  EXPECT_NEAR(map.frame.size.x, 106.4e3 + 2 * 4.26e3, 1e3);
  EXPECT_EQ(map.peaks.size(), 2u);
}

TEST(ReadGeojson, DegreesAndKilometresAgree) {
  for (const std::string name : {"corsica_sketch", "cyprus"}) {
    const auto degrees = map_file(name + ".geojson"), km = map_file(name + "_km.geojson");
    if (!degrees || !km) GTEST_SKIP() << "the shared maps are not here";
    const VectorMap a = read_geojson_file(*degrees), b = read_geojson_file(*km);
    EXPECT_EQ(a.frame.proj4, b.frame.proj4);
    EXPECT_EQ(a.frame.origin, b.frame.origin);
    EXPECT_EQ(a.frame.size, b.frame.size);
    ASSERT_EQ(a.coasts.size(), b.coasts.size());
    ASSERT_EQ(a.rivers.size(), b.rivers.size());
    ASSERT_EQ(a.peaks.size(), b.peaks.size());
    // Corsica's degrees are rounded to 0.0001 (11 m), Cyprus' kilometres to 0.02.
    const double near = name == "cyprus" ? 15.0 : 8.0;
    for (std::size_t i = 0; i < a.peaks.size(); ++i)
      EXPECT_LT(glm::length(a.peaks[i].position - b.peaks[i].position), near);
    ASSERT_EQ(a.coasts[0].outer.size(), b.coasts[0].outer.size());
    for (std::size_t i = 0; i < a.coasts[0].outer.size(); ++i)
      EXPECT_LT(glm::length(a.coasts[0].outer[i] - b.coasts[0].outer[i]), near);
    for (std::size_t i = 0; i < a.rivers.size(); ++i) EXPECT_EQ(a.rivers[i].end, b.rivers[i].end);
  }
}

TEST(ReadGeojson, TakesAllMapsAsTheyAre) {
  int found = 0;
  for (const std::string name :
       {"corsica.geojson", "corsica_sketch.geojson", "corsica_sketch_km.geojson", "cyprus.geojson",
        "cyprus_km.geojson", "imaginary.geojson", "sierra_nevada_km.geojson"}) {
    const auto path = map_file(name);
    if (!path) continue;
    ++found;
    const VectorMap map = read_geojson_file(*path);
    EXPECT_FALSE(map.coasts.empty()) << name;
    const VectorMap again = read_geojson(write_geojson(map), {.strict = true});
    EXPECT_TRUE(again == map) << name;
    EXPECT_TRUE(again.warnings.empty()) << name;
  }
  EXPECT_GE(found, 3);
}

TEST(ReadGeojsonFile, NamesTheFile) {
  const auto folder = std::filesystem::temp_directory_path();
  try {
    read_geojson_file(folder / "no such map.geojson");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no such map.geojson"), std::string::npos);
  }
  EXPECT_THROW(read_geojson_file(folder), InputError);
}

TEST(CheckMap, ChecksMapsMadeInCode) {
  VectorMap map;
  map.coasts.push_back({{{0, 0}, {0, 50e3}, {50e3, 50e3}, {50e3, 0}}, {}, false, "I", -1});
  map.peaks.push_back({{20e3, 20e3}, 900.0, "P", -1, {}});
  map.rivers.push_back({{{30e3, 1e3}, {30.0005e3, 30e3}}, RiverEnd::Sea, -1, {}, 0, "R", -1});
  const VectorMap checked = check_map(map);
  EXPECT_GT(checked.frame.size.x, 50e3);
  EXPECT_EQ(checked.rivers[0].points.front(), glm::dvec2(30000.5, 30e3));  // to the nearer sea
  EXPECT_TRUE(check_map(checked, {.strict = true}) == checked);
  EXPECT_TRUE(read_geojson(write_geojson(checked), {.strict = true}) == checked);

  map.peaks[0].position.x = std::nan("");
  try {
    check_map(map);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("peaks[0] ('P'), vertex 0"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(check_map({}), InputError);
}

}  // namespace
}  // namespace orogen
