// Parallel loops and reductions whose results do not depend on the number of threads.
//
// Chunks are fixed by `grain` alone. Every chunk polls the context, so that a long loop stops soon
// after cancellation.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <cstddef>

#include "foundation/context.h"

namespace orogen {

/// body(begin, end) over chunks of [0, count).
template <class Body>
void parallel_chunks(const Context& context, std::size_t count, std::size_t grain, Body&& body) {
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, grain),
      [&](const tbb::blocked_range<std::size_t>& chunk) {
        context.check();
        body(chunk.begin(), chunk.end());
      },
      tbb::simple_partitioner());
}

/// body(row) for each row of a grid with `rows` rows.
template <class Body>
void parallel_rows(const Context& context, int rows, Body&& body) {
  parallel_chunks(context, std::size_t(rows), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) body(int(r));
  });
}

/// join over chunks of map(begin, end), always in the same order.
template <class Value, class Map, class Join>
Value parallel_reduce(const Context& context, std::size_t count, std::size_t grain, Value identity,
                      Map&& map, Join&& join) {
  return tbb::parallel_deterministic_reduce(
      tbb::blocked_range<std::size_t>(0, count, grain), identity,
      [&](const tbb::blocked_range<std::size_t>& chunk, const Value& value) {
        context.check();
        return join(value, map(chunk.begin(), chunk.end()));
      },
      join, tbb::simple_partitioner());
}

/// Sum of term(i) over [0, count) in double.
template <class Term>
double parallel_sum(const Context& context, std::size_t count, Term&& term) {
  return parallel_reduce(
      context, count, 16384, 0.0,
      [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t i = begin; i < end; ++i) sum += term(i);
        return sum;
      },
      [](double a, double b) { return a + b; });
}

}  // namespace orogen
