// How a computation is watched and stopped: progress, cancellation, thread limit.
//
// A Context belongs to the thread that runs the computation. `cancel()` may be called from any
// thread; everything long calls `check()` (cheap) inside its parallel loops and `report()` between
// its steps, so that cancellation is seen within some 50 ms.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace orogen {

class Kept;

class Context {
 public:
  /// Receives the stage's name and the fraction of the whole work done, in [0, 1], never falling.
  /// Returning false cancels. Called on the computing thread, at most some 30 times a second.
  using Progress = std::function<bool(std::string_view stage, double fraction)>;

  explicit Context(Progress progress = {}, int threads = 0);
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }

  /// Throws Cancelled if cancellation was asked for. Any thread.
  void check() const;

  /// Reports how much of the current stage is done, in [0, 1]; throws Cancelled. Owning thread
  /// only.
  void report(double fraction_of_stage);

  /// Starts a stage that is the part [begin, end] of the whole work.
  void begin_stage(std::string_view name, double begin, double end);

  /// Runs `work` with up to `threads` threads (0: as many as cores), be they more than cores.
  void run(const std::function<void()>& work);

  int threads() const { return threads_; }

  /// Where results for later runs are kept (foundation/kept.h); nullptr: nowhere.
  Kept* kept() const { return kept_; }
  void keep_in(Kept* kept) { kept_ = kept; }

 private:
  Progress progress_;
  int threads_;
  Kept* kept_ = nullptr;
  std::atomic<bool> cancelled_{false};
  std::string stage_;
  double begin_ = 0.0, end_ = 1.0, reached_ = 0.0;
  std::chrono::steady_clock::time_point last_call_{};
};

}  // namespace orogen
