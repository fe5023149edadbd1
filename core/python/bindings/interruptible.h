// Runs the core's work from Python: the GIL released, progress reported, Ctrl-C heard.
//
// The work has a thread of its own. The calling thread waits for it, and at least every 50 ms takes
// the GIL to call `progress` and to let Python handle signals; so the work stops soon after either
// asks for it, however rarely the work itself reports.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>

#include "foundation/context.h"

namespace orogen::python {

namespace py = pybind11;

/// `progress`: None or a callable (stage, fraction) that may return False to cancel. Rethrows what
/// the work, `progress` or a signal handler has thrown; Cancelled if `progress` returned False.
void run_interruptible(const py::object& progress, int threads,
                       const std::function<void(Context&)>& work);

/// The same for work that returns something and reports no progress to Python.
template <class Work>
auto interruptible(int threads, Work&& work) {
  std::optional<decltype(work(std::declval<Context&>()))> result;
  run_interruptible(py::none(), threads,
                    [&](Context& context) { context.run([&] { result.emplace(work(context)); }); });
  return std::move(*result);
}

}  // namespace orogen::python
