#include "pipeline/cache.h"

namespace orogen {

std::shared_ptr<const StageResult> Cache::find(const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto found = index_.find(key);
  if (found == index_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found->second);
  return found->second->result;
}

void Cache::insert(const std::string& key, StageResult result, std::size_t product_bytes) {
  std::size_t bytes = product_bytes;
  for (const auto& [name, field] : result.fields) bytes += field_bytes(field);
  const std::lock_guard lock(mutex_);
  if (bytes > capacity_ || index_.contains(key)) return;
  entries_.push_front({key, std::make_shared<const StageResult>(std::move(result)), bytes});
  index_[key] = entries_.begin();
  bytes_ += bytes;
  while (bytes_ > capacity_) {
    bytes_ -= entries_.back().bytes;
    index_.erase(entries_.back().key);
    entries_.pop_back();
  }
}

void Cache::clear() {
  const std::lock_guard lock(mutex_);
  index_.clear();
  entries_.clear();
  bytes_ = 0;
  kept_.clear();
}

std::size_t Cache::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

std::size_t Cache::size() const {
  const std::lock_guard lock(mutex_);
  return entries_.size();
}

}  // namespace orogen
