#include "interruptible.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "foundation/errors.h"

namespace orogen::python {

namespace {

constexpr auto kPoll = std::chrono::milliseconds(30);

struct News {
  std::string stage;
  double fraction = 0.0;
};

/// What the working thread tells the waiting one.
class Mailbox {
 public:
  void post(std::string_view stage, double fraction) {
    const std::lock_guard lock(mutex_);
    news_.push_back({std::string(stage), fraction});
  }
  void finish() {
    const std::lock_guard lock(mutex_);
    finished_ = true;
    changed_.notify_one();
  }
  /// Waits until the work is finished, kPoll at most; true if it is.
  bool wait(std::vector<News>& news) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, kPoll, [&] { return finished_; });
    news.swap(news_);
    news_.clear();
    return finished_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<News> news_;
  bool finished_ = false;
};

/// Lets Python's signal handlers run and tells `progress` the news; the last again if there is
/// none, so that it can always answer.
bool tell(const py::object& progress, const std::vector<News>& news, News& last) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (!news.empty()) last = news.back();
  if (progress.is_none() || last.stage.empty()) return true;
  const auto call = [&](const News& item) {
    const py::object answer = progress(item.stage, item.fraction);
    return !answer.is(py::bool_(false));
  };
  if (news.empty()) return call(last);
  for (const News& item : news)
    if (!call(item)) return false;
  return true;
}

}  // namespace

void run_interruptible(const py::object& progress, int threads,
                       const std::function<void(Context&)>& work) {
  if (!progress.is_none() && !PyCallable_Check(progress.ptr()))
    throw py::type_error("progress must be None or a callable (stage, fraction)");
  Mailbox mailbox;
  Context context(
      [&](std::string_view stage, double fraction) {
        mailbox.post(stage, fraction);
        return true;
      },
      threads);
  std::exception_ptr of_work, of_python;
  bool refused = false;
  std::thread thread([&] {
    try {
      work(context);
    } catch (...) {
      of_work = std::current_exception();
    }
    mailbox.finish();
  });

  News last;
  std::vector<News> news;
  for (bool finished = false; !finished;) {
    {
      const py::gil_scoped_release release;
      finished = mailbox.wait(news);
    }
    if (of_python || refused) continue;
    try {
      refused = !tell(progress, news, last);
    } catch (...) {
      of_python = std::current_exception();
    }
    if (of_python || refused) context.cancel();
  }
  {
    const py::gil_scoped_release release;
    thread.join();
  }
  if (of_python) std::rethrow_exception(of_python);
  if (refused) throw Cancelled();
  if (of_work) std::rethrow_exception(of_work);
}

}  // namespace orogen::python
