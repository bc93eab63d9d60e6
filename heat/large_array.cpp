#include "talweg/heat/large_array.hpp"

#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace talweg {

LargeArray::LargeArray(std::size_t size) {
  constexpr std::size_t kLargePage = std::size_t{1} << 21, kCacheLine = 64;
  if (size > std::numeric_limits<std::size_t>::max() / 16) throw std::bad_alloc();
  const std::size_t bytes = size * sizeof(double);
  const std::size_t unit = bytes >= kLargePage ? kLargePage : kCacheLine;
  const std::size_t rounded = (bytes / unit + 1) * unit;
  data_.reset(static_cast<double*>(std::aligned_alloc(unit, rounded)));
  if (!data_) throw std::bad_alloc();
#ifdef __linux__
  if (unit == kLargePage) madvise(data_.get(), rounded, MADV_HUGEPAGE);  // a wish, not a need
#endif
  std::memset(data_.get(), 0, bytes);
}

void LargeArray::Free::operator()(double* data) const { std::free(data); }

}  // namespace talweg
