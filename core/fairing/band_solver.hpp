// The band solver solves banded systems, one unknown per sample along a curve.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace talweg {

/// A symmetric positive definite system of n unknowns in a row or in a ring, in which each unknown
/// is coupled with the two before and the two after it. A ring of 5 or more unknowns is folded (0,
/// n - 1, 1, n - 2, …), so its matrix is a band, too. The matrices of smaller rings are full.
class BandSystem {
 public:
  BandSystem() = default;
  BandSystem(std::size_t n, bool ring) { reset(n, ring); }

  /// Makes all coefficients 0. Keeps its memory.
  void reset(std::size_t n, bool ring);
  [[nodiscard]] std::size_t size() const { return n_; }
  /// Adds to the entry of two unknowns that are at most 2 apart, and to its mirror image.
  void add(std::size_t i, std::size_t j, double value) {
    const std::size_t a = place(i), b = place(j);
    entry(std::max(a, b), std::max(a, b) - std::min(a, b)) += value;
  }
  [[nodiscard]] double& right(std::size_t i) { return right_[place(i)]; }
  /// Fixes an unknown at 0.
  void hold(std::size_t i);
  /// Solves by LDLᵀ in the system's own memory, so the coefficients are lost. False if the matrix
  /// is not positive definite. O(n).
  bool solve(std::vector<double>& solution);

 private:
  [[nodiscard]] std::size_t place(std::size_t i) const {
    return !ring_ ? i : 2 * i < n_ ? 2 * i : 2 * (n_ - 1 - i) + 1;
  }
  [[nodiscard]] double& entry(std::size_t row, std::size_t back) {
    return entries_[row * (width_ + 1) + back];
  }
  template <std::size_t kWidth>
  bool eliminate();

  std::size_t n_ = 0, width_ = 2;
  bool ring_ = false;
  std::vector<double> entries_, right_;
};

}  // namespace talweg
