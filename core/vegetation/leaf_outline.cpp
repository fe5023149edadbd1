#include "vegetation/leaf_outline.h"

namespace orogen {

namespace {

constexpr glm::vec2 kOval[] = {{0.5f, 0.0f}, {0.92f, 0.25f}, {0.88f, 0.65f},
                               {0.5f, 1.0f}, {0.12f, 0.65f}, {0.08f, 0.25f}};
constexpr glm::vec2 kTriangle[] = {{0.5f, 0.0f}, {1.0f, 0.25f}, {0.5f, 1.0f}, {0.0f, 0.25f}};
constexpr glm::vec2 kLobed[] = {{0.5f, 0.0f}, {0.9f, 0.2f},  {0.7f, 0.4f}, {1.0f, 0.65f},
                                {0.5f, 1.0f}, {0.0f, 0.65f}, {0.3f, 0.4f}, {0.1f, 0.2f}};
constexpr glm::vec2 kMaple[] = {{0.5f, 0.0f},   {0.85f, 0.08f}, {0.78f, 0.3f},  {1.0f, 0.55f},
                                {0.68f, 0.58f}, {0.5f, 1.0f},   {0.32f, 0.58f}, {0.0f, 0.55f},
                                {0.22f, 0.3f},  {0.15f, 0.08f}};
constexpr glm::vec2 kNeedle[] = {{0.5f, 0.0f}, {1.0f, 0.35f}, {0.5f, 1.0f}, {0.0f, 0.35f}};
constexpr glm::vec2 kRectangle[] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}};

}  // namespace

std::span<const glm::vec2> leaf_outline(LeafShape shape, bool simple) {
  switch (shape) {
    case LeafShape::Oval:
      return simple ? std::span<const glm::vec2>(kNeedle) : kOval;
    case LeafShape::Triangle:
      return kTriangle;
    case LeafShape::Lobed:
      return simple ? std::span<const glm::vec2>(kNeedle) : kLobed;
    case LeafShape::Maple:
      return simple ? std::span<const glm::vec2>(kTriangle) : kMaple;
    case LeafShape::Needle:
      return kNeedle;
    case LeafShape::Rectangle:
      break;
  }
  return kRectangle;
}

}  // namespace orogen
