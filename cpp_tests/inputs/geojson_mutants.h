// Broken GeoJSON: what a careless hand, a bad disk or an enemy makes of a good map.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "inputs/test_maps.h"

namespace orogen::test {

/// Places of numbers in a JSON text: [begin, end).
inline std::vector<std::pair<std::size_t, std::size_t>> numbers_in(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t begin = text.find_first_of("-0123456789", i);
    if (begin == text.npos) break;
    const std::size_t end = std::min(text.find_first_not_of("+-.eE0123456789", begin), text.size());
    places.emplace_back(begin, end);
    i = end;
  }
  return places;
}

/// Balanced pieces in brackets, from `open` to the one that closes it.
inline std::string balanced(const std::string& text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size() && i < open + 4000; ++i) {
    depth += text[i] == '[' || text[i] == '{';
    depth -= text[i] == ']' || text[i] == '}';
    if (depth == 0) return text.substr(open, i - open + 1);
  }
  return "[]";
}

inline std::string mutated(std::string text, Dice& dice) {
  static const char* const kOdd[] = {"NaN",
                                     "Infinity",
                                     "1e999",
                                     "-1e308",
                                     "null",
                                     "true",
                                     "\"x\"",
                                     "{}",
                                     "[]",
                                     "0",
                                     "-0.0",
                                     "1e-320",
                                     "999999999999999999999",
                                     "[[[[[[]]]]]]",
                                     "\"\\ud800\"",
                                     "90.0000001",
                                     "361"};
  const auto anywhere = [&](const char* set) {
    const std::size_t start = std::size_t(dice.below(int(text.size())));
    const std::size_t found = text.find_first_of(set, start);
    return found == text.npos ? text.find_first_of(set) : found;
  };
  for (int k = 1 + dice.below(3); k-- > 0 && !text.empty();) {
    const auto numbers = numbers_in(text);
    const auto number = [&] { return numbers[std::size_t(dice.below(int(numbers.size())))]; };
    switch (dice.below(9)) {
      case 0:  // flip a bit
        text[std::size_t(dice.below(int(text.size())))] ^= char(1 << dice.below(8));
        break;
      case 1:  // break off
        text.resize(std::size_t(dice.below(int(text.size()))));
        break;
      case 2:  // another number
        if (!numbers.empty()) {
          const auto [begin, end] = number();
          text.replace(begin, end - begin, std::to_string(dice.uniform(-200.0, 200.0)));
        }
        break;
      case 3:  // something else in place of a number
        if (!numbers.empty()) {
          const auto [begin, end] = number();
          text.replace(begin, end - begin, kOdd[dice.below(17)]);
        }
        break;
      case 4:  // two numbers change places
        if (!numbers.empty()) {
          const auto a = number(), b = number();
          const std::string x = text.substr(a.first, a.second - a.first);
          const std::string y = text.substr(b.first, b.second - b.first);
          const bool before = a.first < b.first;
          text.replace((before ? b : a).first, (before ? y : x).size(), before ? x : y);
          text.replace((before ? a : b).first, (before ? x : y).size(), before ? y : x);
        }
        break;
      case 5:  // a piece doubled
        if (const std::size_t at = anywhere("[{"); at != text.npos)
          text.insert(at, balanced(text, at) + ",");
        break;
      case 6:  // a piece gone
        if (const std::size_t at = anywhere("[{"); at != text.npos)
          text.erase(at, balanced(text, at).size());
        break;
      case 7:  // a piece in place of another
        if (const std::size_t at = anywhere("[{"), to = anywhere("[{"); at != text.npos) {
          const std::string piece = balanced(text, at);
          text.replace(to, balanced(text, to).size(), piece);
        }
        break;
      default:  // another word
        for (const auto& [word, other] :
             {std::pair("coast", "river"), std::pair("river", "coast"), std::pair("peak", "lake"),
              std::pair("Polygon", "LineString"), std::pair("Point", "MultiPoint"),
              std::pair("km", "m"), std::pair("degrees", "km"), std::pair("aeqd", "utm")})
          if (dice.below(4) == 0)
            if (const std::size_t at = text.find(word); at != text.npos)
              text.replace(at, std::string(word).size(), other);
    }
  }
  return text;
}

/// A small random map of every kind of feature, mostly in order.
inline std::string random_map(Dice& dice) {
  const bool degrees = dice.below(3) == 0;
  const double scale = degrees ? 0.01 : 1.0, shift = degrees ? dice.uniform(-170.0, 179.0) : 0.0;
  const auto position = [&](double x, double y) {
    return "[" + std::to_string(shift + scale * x) + "," + std::to_string(scale * y) + "]";
  };
  const auto ring = [&](double x, double y, double radius, int n) {
    std::string text = "[";
    std::string first;
    for (int i = 0; i < n; ++i) {
      const double a = 6.283185307 * i / n, r = radius * dice.uniform(0.5, 1.0);
      const std::string p = position(x + r * std::cos(a), y + r * std::sin(a));
      if (i == 0) first = p;
      text += p + ",";
    }
    return text + first + "]";
  };
  std::string features =
      feature(R"("kind":"coast")", "Polygon", "[" + ring(60, 60, 50, 3 + dice.below(60)) + "]");
  if (dice.below(2))
    features += "," + feature(R"("kind":"coast")", "Polygon", "[" + ring(140, 60, 25, 9) + "]");
  if (dice.below(3) == 0)
    features += "," + feature(R"("kind":"lake")", "Polygon", "[" + ring(60, 60, 6, 8) + "]");
  for (int r = dice.below(8); r-- > 0;) {
    std::string line = "[";
    double x = dice.uniform(30, 90), y = dice.uniform(30, 90);
    for (int k = 2 + dice.below(12); k-- > 0;) {
      line += position(x, y) + (k ? "," : "]");
      x += dice.uniform(-12, 14);
      y += dice.uniform(-12, 14);
    }
    features += "," + feature(R"("kind":"river","name":"r")", "LineString", line);
  }
  for (int k = dice.below(6); k-- > 0;)
    features += "," + feature(R"("kind":"peak","height_m":)" + std::to_string(dice.below(4000)),
                              "Point", position(dice.uniform(40, 80), dice.uniform(40, 80)));
  return collection(features, degrees ? "" : R"("units":"km",)");
}

/// Does a refusal say where?
inline bool names_a_place(const std::string& message) {
  for (const char* word :
       {"features", "offset", "document", "frame", "units", "type", "crs", "name", "coordinates"})
    if (message.find(word) != message.npos) return true;
  return false;
}

}  // namespace orogen::test
