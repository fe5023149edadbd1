#include "foundation/kept.h"

#include <algorithm>

namespace orogen {

std::shared_ptr<const void> Kept::find(const Key& key) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(entries_, key, &Entry::key);
  if (found == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found);
  return found->result;
}

void Kept::insert(Key key, std::shared_ptr<const void> result, std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  if (bytes > kLargest || std::ranges::find(entries_, key, &Entry::key) != entries_.end()) return;
  entries_.push_front({std::move(key), std::move(result), bytes});
  bytes_ += bytes;
  while (bytes_ > kCapacity) {
    bytes_ -= entries_.back().bytes;
    entries_.pop_back();
  }
}

void Kept::clear() {
  const std::lock_guard lock(mutex_);
  entries_.clear();
  bytes_ = 0;
}

}  // namespace orogen
