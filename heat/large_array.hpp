// A large array holds numbers in memory that is cheap to walk through.
#pragma once

#include <cstddef>
#include <memory>

namespace talweg {

/// Zeros at first. Where they fill megabytes the system is asked for large pages: walking through a
/// factor of a million-vertex mesh then takes about half as long.
class LargeArray {
 public:
  LargeArray() = default;
  /// Throws std::bad_alloc.
  explicit LargeArray(std::size_t size);

  [[nodiscard]] double* data() { return data_.get(); }
  [[nodiscard]] const double* data() const { return data_.get(); }

 private:
  struct Free {
    void operator()(double* data) const;
  };
  std::unique_ptr<double, Free> data_;
};

}  // namespace talweg
