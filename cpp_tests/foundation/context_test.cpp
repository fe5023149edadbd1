#include "foundation/context.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "foundation/errors.h"
#include "foundation/parallel.h"
#include "foundation/random.h"

namespace orogen {
namespace {

TEST(Context, ProgressNeverFallsAndNamesTheStage) {
  std::vector<double> seen;
  std::vector<std::string> names;
  Context context([&](std::string_view stage, double fraction) {
    seen.push_back(fraction);
    names.emplace_back(stage);
    return true;
  });
  context.begin_stage("plates", 0.0, 0.5);
  context.report(1.0);
  context.report(0.2);
  context.begin_stage("folds", 0.5, 1.0);
  context.report(1.0);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
  EXPECT_EQ(names.front(), "plates");
  EXPECT_EQ(names.back(), "folds");
}

TEST(Context, RefusingProgressCancels) {
  Context context([](std::string_view, double) { return false; });
  EXPECT_THROW(context.report(1.0), Cancelled);
  EXPECT_TRUE(context.cancelled());
}

TEST(Context, CancelFromAnotherThreadStopsALoop) {
  Context context;
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    context.cancel();
  });
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(
      parallel_rows(context, 1 << 20,
                    [](int) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }),
      Cancelled);
  other.join();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(500));
}

TEST(Context, RefusesAbsurdThreadCounts) {
  EXPECT_THROW(Context({}, -1), InputError);
  EXPECT_THROW(Context({}, 5000), InputError);
}

/// How many threads take part in a loop whose chunks wait a minute for `wanted` to come.
std::size_t threads_at_work(Context& context, std::size_t wanted) {
  std::mutex mutex;
  std::condition_variable came;
  std::set<std::thread::id> seen;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  context.run([&] {
    parallel_chunks(context, 8 * wanted, 1, [&](std::size_t, std::size_t) {
      std::unique_lock lock(mutex);
      seen.insert(std::this_thread::get_id());
      came.notify_all();
      came.wait_until(lock, deadline, [&] { return seen.size() >= wanted; });
    });
  });
  return seen.size();
}

TEST(Context, RunsAsManyThreadsAsAreAskedFor) {
  const int more_than_cores = int(std::thread::hardware_concurrency()) + 2;
  for (int threads : {1, 2, more_than_cores, 3}) {
    Context context({}, threads);
    EXPECT_EQ(threads_at_work(context, threads), std::size_t(threads));
  }
}

TEST(Parallel, SumHasTheSameBitsForAnyThreadCount) {
  std::vector<double> sums;
  for (int threads : {1, 2, 3, 4, 8})
    for (int repeat = 0; repeat < 5; ++repeat) {
      Context context({}, threads);
      context.run([&] {
        sums.push_back(parallel_sum(context, 1000003,
                                    [](std::size_t i) { return random_normal(5, 0, i) * 1e10; }));
      });
    }
  for (double sum : sums) EXPECT_EQ(sum, sums[0]);
}

TEST(Parallel, EveryChunkIsVisitedOnce) {
  Context context;
  for (std::size_t count : {0u, 1u, 7u, 1000u}) {
    std::vector<int> seen(count);
    parallel_chunks(context, count, 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++seen[i];
    });
    EXPECT_EQ(seen, std::vector<int>(count, 1));
  }
}

}  // namespace
}  // namespace orogen
