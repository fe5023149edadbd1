#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

#include "pipeline/pipeline.h"

namespace orogen {

namespace {

constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();

/// The number after `word` in a file, or the file's first if there is no word.
std::size_t read_number(const char* file, std::string_view word = "") {
  std::ifstream stream(file);
  std::string name;
  while (!word.empty() && stream >> name)
    if (name == word) break;
  std::size_t value = 0;
  return stream >> value ? value : kUnknown;  // "max" is no number
}

/// What a container (control group, version 2) may still take; files it has cached do not count.
std::size_t left_in_container() {
  const std::string group = "/sys/fs/cgroup/memory.";
  const std::size_t limit = read_number((group + "max").c_str());
  const std::size_t used = read_number((group + "current").c_str());
  if (limit == kUnknown || used == kUnknown) return kUnknown;
  const std::size_t cached = read_number((group + "stat").c_str(), "inactive_file");
  const std::size_t taken = used - (cached == kUnknown ? 0 : std::min(cached, used));
  return limit > taken ? limit - taken : 0;
}

}  // namespace

std::size_t available_memory() {
  const std::size_t kibibytes = read_number("/proc/meminfo", "MemAvailable:");
  return std::min(kibibytes == kUnknown ? kUnknown : kibibytes * 1024, left_in_container());
}

}  // namespace orogen
