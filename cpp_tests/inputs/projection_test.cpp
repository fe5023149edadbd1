#include "inputs/projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "foundation/errors.h"

namespace orogen {
namespace {

struct Case {
  const char* proj4;
  glm::dvec2 lon_lat, metres;
};

// Metres by PROJ 9; laea at (5, 50) is the example of EPSG's guidance note 7-2.
const Case kCases[] = {
    {"+proj=aeqd +lat_0=42.18 +lon_0=9.06 +datum=WGS84 +units=m +no_defs",
     {9.55, 42.097},
     {40534.9518, -9102.9828}},
    {"+proj=aeqd +lat_0=-17.5 +lon_0=179.5 +datum=WGS84 +units=m",
     {-179.2, -16.5},
     {138799.3867, 110204.4972}},
    {"+proj=tmerc +lat_0=49 +lon_0=-2 +k=0.9996012717 +x_0=400000 +y_0=-100000 +ellps=WGS84 "
     "+units=m",
     {-3.5, 52.25},
     {297601.5935, 262449.1361}},
    {"+proj=utm +zone=32 +datum=WGS84 +units=m +no_defs", {9, 42}, {500000.0000, 4649776.2248}},
    {"+proj=utm +zone=19 +south +datum=WGS84 +units=m +no_defs",
     {-70, -33},
     {406582.2218, 6348269.0259}},
    {"+proj=lcc +lat_0=46.5 +lon_0=3 +lat_1=49 +lat_2=44 +x_0=700000 +y_0=6600000 +ellps=GRS80 "
     "+towgs84=0,0,0,0,0,0,0 +units=m +no_defs",
     {7.5, 48.5},
     {1032261.3151, 6831664.4470}},
    {"+proj=lcc +lat_1=18 +lat_0=18 +lon_0=-77 +k_0=1 +x_0=250000 +y_0=150000 +ellps=WGS84 "
     "+units=m",
     {-76.9, 17.9},
     {260596.4671, 138934.8700}},
    {"+proj=merc +lon_0=110 +k=0.997 +x_0=3900000 +y_0=900000 +ellps=WGS84 +units=m",
     {120, -3},
     {5009855.3232, 569119.0954}},
    {"+proj=merc +lat_ts=-41 +lon_0=100 +datum=WGS84", {170, -43}, {5889462.9580, -3992752.6522}},
    {"+proj=aea +lat_0=23 +lon_0=-96 +lat_1=29.5 +lat_2=45.5 +x_0=0 +y_0=0 +datum=NAD83 +units=m "
     "+no_defs",
     {-75, 35},
     {1885428.3905, 1535969.2859}},
    {"+proj=laea +lat_0=52 +lon_0=10 +x_0=4321000 +y_0=3210000 +ellps=GRS80 +units=m +no_defs",
     {5, 50},
     {3962799.4510, 2999718.8532}},
    {"+proj=laea +lat_0=0 +lon_0=20 +datum=WGS84", {30, -12}, {1093590.4997, -1329664.1635}},
    {"+proj=laea +lat_0=90 +lon_0=0 +datum=WGS84", {45, 70}, {1570958.5501, -1570958.5501}},
    {"+proj=laea +lat_0=-90 +lon_0=10 +datum=WGS84", {45, -70}, {1274298.0704, 1819886.2492}},
    {"+proj=stere +lat_0=90 +lat_ts=70 +lon_0=-45 +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m "
     "+no_defs",
     {-30, 75},
     {422879.1313, -1578206.4037}},
    {"+proj=stere +lat_0=-90 +lat_ts=-71 +lon_0=0 +datum=WGS84 +units=m +no_defs",
     {120, -75},
     {1419227.9158, -819391.6192}},
    {"+proj=stere +lat_0=90 +lon_0=-33 +k_0=0.994 +x_0=2000000 +y_0=2000000 +datum=WGS84",
     {44, 73},
     {3852096.8096, 1572409.7598}},
    {"+proj=laea +lat_0=40 +lon_0=10 +R=6371000 +units=m", {15, 45}, {393211.7645, 567120.7856}},
};

TEST(Projection, AgreesWithKnownValues) {
  for (const Case& c : kCases) {
    const glm::dvec2 q = Projection(c.proj4).project(c.lon_lat);
    EXPECT_NEAR(q.x, c.metres.x, 1e-3) << c.proj4;
    EXPECT_NEAR(q.y, c.metres.y, 1e-3) << c.proj4;
  }
}

TEST(Projection, GoesBackToWhereItCameFrom) {
  for (const Case& c : kCases) {
    const Projection p(c.proj4);
    for (const glm::dvec2 off : {glm::dvec2(0.0), glm::dvec2(1.3, -0.7), glm::dvec2(-2.0, 1.9)}) {
      const glm::dvec2 g = p.unproject(p.project(c.lon_lat + off));
      EXPECT_NEAR(std::remainder(g.x - c.lon_lat.x - off.x, 360.0), 0.0, 1e-9) << c.proj4;
      EXPECT_NEAR(g.y, c.lon_lat.y + off.y, 1e-9) << c.proj4;
    }
  }
}

TEST(Projection, RefusesWhatItDoesNotKnowAndSaysWhatItKnows) {
  const auto refusal = [](const char* proj4) -> std::string {
    try {
      Projection p(proj4);
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << proj4;
    return {};
  };
  EXPECT_NE(refusal("+proj=robin").find("known are aeqd"), std::string::npos);
  EXPECT_NE(refusal("+proj=longlat +datum=WGS84").find("degrees are no plane"), std::string::npos);
  EXPECT_NE(refusal("").find("+proj is missing"), std::string::npos);
  EXPECT_NE(refusal("+proj=aeqd +lat_0=91").find("+lat_0 must be a number from -90 to 90"),
            std::string::npos);
  EXPECT_NE(refusal("+proj=aeqd +lat_0=nan").find("+lat_0"), std::string::npos);
  EXPECT_NE(refusal("+proj=aeqd +units=us-ft").find("+units must be m"), std::string::npos);
  EXPECT_NE(refusal("+proj=aeqd +nadgrids=x.gsb").find("+nadgrids"), std::string::npos);
  EXPECT_NE(refusal("+proj=aeqd +ellps=bessel").find("GRS80"), std::string::npos);
  EXPECT_NE(refusal("+proj=utm").find("+zone"), std::string::npos);
  EXPECT_NE(refusal("+proj=utm +zone=32.5").find("+zone"), std::string::npos);
  EXPECT_NE(refusal("+proj=lcc").find("lat_1"), std::string::npos);
  EXPECT_NE(refusal("+proj=stere +lat_0=45").find("pole"), std::string::npos);
  EXPECT_NE(refusal("+proj=aeqd +lat_0=1 +lat_0=2").find("twice"), std::string::npos);
  EXPECT_NE(refusal("+proj=aeqd +towgs84=1,2,3").find("datum shift"), std::string::npos);
}

TEST(MeanDirection, CrossesTheAntimeridian) {
  const std::vector<glm::dvec2> fiji{{179.0, -17.0}, {-179.0, -17.0}, {180.0, -18.0}};
  const glm::dvec2 c = mean_direction(fiji);
  EXPECT_NEAR(std::fabs(c.x), 180.0, 1e-9);
  EXPECT_NEAR(c.y, -17.33, 0.01);
  EXPECT_THROW(mean_direction(std::vector<glm::dvec2>{{0, 0}, {180, 0}, {90, 0}, {-90, 0}}),
               InputError);
}

}  // namespace
}  // namespace orogen
