// Incision along a part of a TIN's flow. Private to tin_stream_power.cpp and tin_deposition.cpp.
#pragma once

#include <algorithm>
#include <cstdint>

#include "erosion/tin_stream_power.h"

namespace orogen {

template <class T>
void gather(const T* from, const std::int32_t* vertices, int count, double* to) {
  for (int k = 0; k < count; ++k) to[k] = double(from[vertices[k]]);
}

inline void gather(const VertexValues& from, const std::int32_t* vertices, int count, double* to) {
  if (from.values.empty())
    std::fill_n(to, count, from.value);
  else
    gather(from.values.data(), vertices, count, to);
}

/// k A'^m / length^n: the rate of incision (m/yr) at a rise of 1 m.
void incision_rates(const TinStreamPowerParameters& parameters, const double* area,
                    const double* erodibility, const double* length, int count, double* rate);

}  // namespace orogen
