#include "foundation/context.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "foundation/errors.h"

namespace orogen {

namespace {
constexpr auto kCallInterval = std::chrono::milliseconds(33);
}

Context::Context(Progress progress, int threads)
    : progress_(std::move(progress)), threads_(threads) {
  if (threads < 0 || threads > 1024)
    throw InputError("threads: " + std::to_string(threads) + " is outside 0 (all cores) to 1024");
}

void Context::check() const {
  if (cancelled()) throw Cancelled();
}

void Context::report(double fraction_of_stage) {
  check();
  if (!progress_) return;
  const double here = begin_ + (end_ - begin_) * std::clamp(fraction_of_stage, 0.0, 1.0);
  reached_ = std::max(reached_, here);
  const auto now = std::chrono::steady_clock::now();
  if (now - last_call_ < kCallInterval && fraction_of_stage < 1.0) return;
  last_call_ = now;
  if (!progress_(stage_, reached_)) cancel();
  check();
}

void Context::begin_stage(std::string_view name, double begin, double end) {
  stage_ = name;
  begin_ = begin;
  end_ = end;
  last_call_ = {};
  report(0.0);
}

void Context::run(const std::function<void()>& work) {
  if (threads_ == 0) return work();
  // TBB keeps a thread a core; more that are asked for must be allowed.
  constexpr auto kMost = tbb::global_control::max_allowed_parallelism;
  const tbb::global_control allowed(
      kMost, std::max(std::size_t(threads_), tbb::global_control::active_value(kMost)));
  tbb::task_arena arena(threads_);
  arena.execute(work);
}

}  // namespace orogen
