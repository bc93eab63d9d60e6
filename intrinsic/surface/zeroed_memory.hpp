// Zeroed memory serves large arrays that begin as zeros and are mostly never written.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <type_traits>
#include <vector>

namespace talweg {

/// An allocator of zeroed memory. The system provides pages only when they are written, so an array
/// over a mesh costs only the pages that a run writes. Elements that a vector creates without a
/// value are not written, so they are zero only in fresh memory; elements that are appended after
/// others were removed must be given a value.
template <class T>
class ZeroedMemory {
 public:
  static_assert(std::is_arithmetic_v<T>);
  using value_type = T;

  ZeroedMemory() = default;
  template <class U>
  explicit ZeroedMemory(const ZeroedMemory<U>& /*other*/) {}

  T* allocate(std::size_t n) {
    void* memory = std::calloc(n, sizeof(T));  // calloc checks the product for overflow
    if (memory == nullptr) throw std::bad_alloc();
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t /*n*/) { std::free(memory); }

  template <class U>
  void construct(U* /*at*/) {}
  template <class U, class Value>
  void construct(U* at, const Value& value) {
    ::new (static_cast<void*>(at)) U(value);
  }

  friend bool operator==(const ZeroedMemory&, const ZeroedMemory&) { return true; }
};

template <class T>
using ZeroedVector = std::vector<T, ZeroedMemory<T>>;

}  // namespace talweg
