#include "inputs/plate_gesture.h"

#include <cmath>
#include <cstddef>

#include "foundation/errors.h"

namespace orogen {

namespace {

constexpr std::size_t kMostGestures = 1000, kMostPoints = 10'000, kMostInAll = 100'000;
constexpr double kFarthest = 1e8;  // m

void check_places(const std::vector<glm::dvec2>& places, const std::string& field) {
  for (std::size_t k = 0; k < places.size(); ++k)
    if (!(std::fabs(places[k].x) <= kFarthest && std::fabs(places[k].y) <= kFarthest))
      throw InputError(field + "[" + std::to_string(k) +
                       "]: finite numbers from -1e8 to 1e8 m are wanted");
}

}  // namespace

void check_gestures(std::span<const PlateGesture> gestures, std::string_view place) {
  const std::string root(place);
  if (gestures.size() > kMostGestures)
    throw InputError(root + ": " + std::to_string(gestures.size()) + " plates; at most " +
                     std::to_string(kMostGestures) + " are allowed");
  std::size_t in_all = 0;
  for (std::size_t i = 0; i < gestures.size(); ++i) {
    const PlateGesture& gesture = gestures[i];
    const std::string at = root + "[" + std::to_string(i) + "]";
    const std::size_t n = gesture.points.size();
    if (n < 1 || n > kMostPoints)
      throw InputError(at + ".points: " + std::to_string(n) + " points; 1 to " +
                       std::to_string(kMostPoints) + " are allowed");
    if ((in_all += n) > kMostInAll)
      throw InputError(root + ": more than " + std::to_string(kMostInAll) +
                       " points in all are not allowed");
    if (gesture.arrows.size() != n)
      throw InputError(at + ".arrows: " + std::to_string(gesture.arrows.size()) + " arrows for " +
                       std::to_string(n) + " points; one a point is wanted");
    check_places(gesture.points, at + ".points");
    check_places(gesture.arrows, at + ".arrows");
    if (gesture.crust != PlateCrust::Continental && gesture.crust != PlateCrust::Oceanic)
      throw InputError(at + ".crust: continental or oceanic is wanted");
  }
}

}  // namespace orogen
