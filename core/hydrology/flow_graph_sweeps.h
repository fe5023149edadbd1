// The loops of FlowGraph; included by flow_graph.h.
#pragma once

#include "foundation/parallel.h"
#include "hydrology/flow_graph.h"

namespace orogen {

namespace detail {

/// Few cells are done sooner by one thread.
template <class Body>
void for_blocks(const Context& context, std::span<const FlowBlock> blocks, Body&& body) {
  if (blocks.size() < 2 || blocks.back().end - blocks.front().begin < 16384) {
    context.check();
    for (std::size_t b = 0; b < blocks.size(); ++b) body(b);
  } else {
    parallel_chunks(context, blocks.size(), 1, [&](std::size_t b, std::size_t) { body(b); });
  }
}

}  // namespace detail

template <class Body>
void FlowGraph::visit_upstream(const Context& context, Body&& body) const {
  for (std::size_t r = 0; r < rounds(); ++r)
    detail::for_blocks(context, round(r),
                       [&](std::size_t b) { body(round(r)[b], std::size_t(round_begin_[r]) + b); });
}

template <class Body, class Join>
void FlowGraph::visit_downstream(const Context& context, Body&& body, Join&& join) const {
  for (std::size_t r = rounds(); r-- > 0;) {
    const auto blocks = round(r);
    detail::for_blocks(context, blocks,
                       [&](std::size_t b) { body(blocks[b], std::size_t(round_begin_[r]) + b); });
    for (std::size_t b = blocks.size(); b-- > 0;)
      for (std::int32_t k = blocks[b].heads_end; k-- > blocks[b].begin;) join(k);
  }
}

template <class Body>
void FlowGraph::sweep_upstream(const Context& context, Body&& body) const {
  visit_upstream(context, [&](const FlowBlock& block, std::size_t) {
    for (std::int32_t k = block.begin; k < block.end; ++k) body(order_[k]);
  });
}

template <class Body>
void FlowGraph::sweep_downstream(const Context& context, Body&& body) const {
  visit_downstream(
      context,
      [&](const FlowBlock& block, std::size_t) {
        for (std::int32_t k = block.end; k-- > block.heads_end;) body(order_[k]);
      },
      [&](std::int32_t head) { body(order_[head]); });
}

}  // namespace orogen
