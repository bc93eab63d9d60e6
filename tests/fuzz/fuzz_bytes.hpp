// Fuzz bytes become values; require() checks promises on any input.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace talweg::fuzz {

/// Takes values from the input; zeros after its end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
  [[nodiscard]] bool empty() const { return left_ == 0; }

  template <class T>
  T take() {
    T value{};
    const std::size_t n = left_ < sizeof value ? left_ : sizeof value;
    std::memcpy(&value, data_, n);
    data_ += n;
    left_ -= n;
    return value;
  }
  /// A number mostly below `bound`, sometimes any.
  std::uint32_t index(std::uint32_t bound) {
    const auto value = take<std::uint16_t>();
    return value > 0xFF00 ? value * 65537U : value % bound;
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

inline void require(bool good, const char* what) {
  if (good) return;
  std::fprintf(stderr, "not as promised: %s\n", what);
  std::abort();
}

}  // namespace talweg::fuzz
