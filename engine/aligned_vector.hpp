// Arrays that vector instructions and the memory system like.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#include <sys/mman.h>

namespace packstone::engine {

/// Gives memory aligned to cache lines; large arrays in huge pages where the system has them, for a particle's
/// neighbours lie in few pages then.
template <class T>
struct AlignedAllocator {
  using value_type = T;
  static constexpr std::align_val_t cache_line{64};
  static constexpr std::align_val_t huge_page{std::size_t{2} << 20};

  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>&) {}

  static std::align_val_t alignment(std::size_t n) {
    return n * sizeof(T) < static_cast<std::size_t>(huge_page) ? cache_line : huge_page;
  }
  T* allocate(std::size_t n) {
    void* memory = ::operator new(n * sizeof(T), alignment(n));
    if (alignment(n) == huge_page) madvise(memory, n * sizeof(T), MADV_HUGEPAGE);
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t n) { ::operator delete(memory, alignment(n)); }

  template <class U>
  bool operator==(const AlignedAllocator<U>&) const {
    return true;
  }
};

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

}  // namespace packstone::engine
