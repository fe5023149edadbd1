#include "pipeline/feature_inputs.h"

#include <numbers>

namespace orogen {

namespace {

constexpr double kFarthest = 1e8;   // m
constexpr double kHighest = 12e3;   // m
constexpr double kWidest = 1e7;     // m
constexpr double kSteepest = 89.0;  // degrees
constexpr double kDegree = std::numbers::pi / 180.0;

double number_or(const JsonValue& object, const char* name, double low, double high,
                 double otherwise) {
  return object.has(name) ? object.member(name).number(low, high) : otherwise;
}

FeatureSide read_side(const JsonValue& side) {
  side.only_members({"slope_size", "slope_angle_deg", "envelope"});
  return {number_or(side, "slope_size", 0.0, kWidest, 0.0),
          number_or(side, "slope_angle_deg", -kSteepest, kSteepest, 0.0) * kDegree,
          number_or(side, "envelope", 0.0, kWidest, 0.0)};
}

FeaturePoint read_point(const JsonValue& item) {
  item.only_members({"position", "elevation", "plateau", "sides", "left", "right"});
  const JsonValue position = item.member("position");
  const std::size_t numbers = position.array_size();
  if (numbers != 2 && numbers != 3) position.refuse("two or three numbers are wanted");
  FeaturePoint point;
  point.position.x = position.element(0).number(-kFarthest, kFarthest);
  point.position.y = position.element(1).number(-kFarthest, kFarthest);
  if (numbers == 3) point.position.z = position.element(2).number(-kHighest, kHighest);
  point.elevation = numbers == 3;
  if (item.has("elevation")) {
    const JsonValue elevation = item.member("elevation");
    if (!elevation.json().is_boolean()) elevation.refuse("true or false is wanted");
    point.elevation = elevation.json().get<bool>();
    if (point.elevation && numbers == 2) position.refuse("without a height none can be asked for");
  }
  point.plateau = number_or(item, "plateau", 0.0, kWidest, 0.0);
  if (item.has("sides")) point.left = point.right = read_side(item.member("sides"));
  if (item.has("left")) point.left = read_side(item.member("left"));
  if (item.has("right")) point.right = read_side(item.member("right"));
  return point;
}

}  // namespace

std::vector<FeatureCurve> read_features(const JsonValue& list) {
  std::vector<FeatureCurve> features;
  for (std::size_t i = 0; i < list.array_size(); ++i) {
    const JsonValue item = list.element(i);
    item.only_members({"name", "points"});
    FeatureCurve curve;
    if (item.has("name")) curve.name = item.member("name").text(200);
    const JsonValue points = item.member("points");
    for (std::size_t k = 0; k < points.array_size(); ++k)
      curve.points.push_back(read_point(points.element(k)));
    check_curve(curve, item.place());
    features.push_back(std::move(curve));
  }
  return features;
}

}  // namespace orogen
