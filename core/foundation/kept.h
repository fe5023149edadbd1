// Results of functions of a few numbers, kept from run to run: meshes and noise of a map that stays
// while something moves over it. What is kept is what would be computed anew, to the bit.
//
// Large results are not kept: they cost little beside what is made with them, and much memory.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

#include "foundation/context.h"

namespace orogen {

/// The least recently used goes first. Safe to share between threads.
class Kept {
 public:
  static constexpr std::size_t kCapacity = std::size_t(32) << 20;  // bytes
  static constexpr std::size_t kLargest = kCapacity / 16;

  /// What a function is called and every number that it depends on, to the bit.
  struct Key {
    std::string_view function;  // a literal
    std::vector<std::uint64_t> numbers;

    template <class... Numbers>
    explicit Key(std::string_view name, Numbers... values)
        : function(name), numbers{std::bit_cast<std::uint64_t>(double(values))...} {}
    bool operator==(const Key&) const = default;
  };

  /// nullptr if it is not there.
  std::shared_ptr<const void> find(const Key& key);
  void insert(Key key, std::shared_ptr<const void> result, std::size_t bytes);
  void clear();

 private:
  struct Entry {
    Key key;
    std::shared_ptr<const void> result;
    std::size_t bytes;
  };

  std::mutex mutex_;
  std::size_t bytes_ = 0;
  std::list<Entry> entries_;  // most recently used first
};

/// make(), or what it gave for this key before. `bytes_of(result)`: its size in memory. A key's
/// function has one type of result.
template <class Make, class BytesOf>
auto kept(const Context& context, Kept::Key key, Make&& make, BytesOf&& bytes_of)
    -> std::shared_ptr<const decltype(make())> {
  using Result = decltype(make());
  Kept* const store = context.kept();
  if (!store) return std::make_shared<const Result>(make());
  if (auto found = store->find(key)) return std::static_pointer_cast<const Result>(found);
  auto made = std::make_shared<const Result>(make());
  store->insert(std::move(key), made, bytes_of(*made));
  return made;
}

}  // namespace orogen
