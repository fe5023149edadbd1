// Results of stages, kept under the hash of everything they depend on, within a bound in bytes.
#pragma once

#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "foundation/kept.h"
#include "pipeline/stages.h"
#include "pipeline/terrain.h"

namespace orogen {

/// What a stage left behind.
struct StageResult {
  FieldMap fields;  // those it writes
  Products products;
};

/// Least recently used results are dropped first. Safe to share between threads.
class Cache {
 public:
  explicit Cache(std::size_t capacity_bytes = std::size_t(1) << 30) : capacity_(capacity_bytes) {}

  std::shared_ptr<const StageResult> find(const std::string& key);
  /// `product_bytes`: memory of the result beside its fields. A result larger than the whole
  /// capacity is not kept.
  void insert(const std::string& key, StageResult result, std::size_t product_bytes = 0);
  void clear();

  std::size_t bytes() const;
  std::size_t capacity() const { return capacity_; }
  std::size_t size() const;

  /// What stages keep of their own, beside their results and the capacity.
  Kept& kept() { return kept_; }

 private:
  struct Entry {
    std::string key;
    std::shared_ptr<const StageResult> result;
    std::size_t bytes;
  };

  mutable std::mutex mutex_;
  std::size_t capacity_;
  std::size_t bytes_ = 0;
  std::list<Entry> entries_;  // most recently used first
  std::map<std::string, std::list<Entry>::iterator> index_;
  Kept kept_;
};

}  // namespace orogen
