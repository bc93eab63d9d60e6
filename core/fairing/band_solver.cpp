#include "talweg/core/fairing/band_solver.hpp"

#include <algorithm>

namespace talweg {

BandSystem::BandSystem(std::size_t n, bool ring)
    : n_(n), width_(ring ? 4 : 2), ring_(ring), entries_(n * (width_ + 1)), right_(n) {}

void BandSystem::clear() {
  std::fill(entries_.begin(), entries_.end(), 0.0);
  std::fill(right_.begin(), right_.end(), 0.0);
}

void BandSystem::add(std::size_t i, std::size_t j, double value) {
  const std::size_t a = place(i), b = place(j);
  entry(std::max(a, b), std::max(a, b) - std::min(a, b)) += value;
}

void BandSystem::hold(std::size_t i) {
  const std::size_t row = place(i);
  for (std::size_t back = 1; back <= width_; ++back) {
    entry(row, back) = 0;
    if (row + back < n_) entry(row + back, back) = 0;
  }
  entry(row, 0) = 1;
  right_[row] = 0;
}

bool BandSystem::solve(std::vector<double>& solution) {
  factor_ = entries_;
  const auto at = [&](std::size_t row, std::size_t back) -> double& {
    return factor_[row * (width_ + 1) + back];
  };
  std::vector<double> x = right_;
  for (std::size_t i = 0; i < n_; ++i) {
    const std::size_t reach = std::min(i, width_);
    for (std::size_t back = reach; back > 0; --back) {
      const std::size_t j = i - back;
      double sum = at(i, back);
      for (std::size_t k = back + 1; k <= reach; ++k) {
        const std::size_t l = i - k;
        if (j - l <= width_) sum -= at(i, k) * at(j, j - l) * at(l, 0);
      }
      at(i, back) = sum / at(j, 0);
    }
    for (std::size_t back = 1; back <= reach; ++back) {
      at(i, 0) -= at(i, back) * at(i, back) * at(i - back, 0);
      x[i] -= at(i, back) * x[i - back];
    }
    if (!(at(i, 0) > 0)) return false;
  }
  for (std::size_t i = n_; i-- > 0;) {
    x[i] /= at(i, 0);
    for (std::size_t ahead = 1; ahead <= width_ && i + ahead < n_; ++ahead) {
      x[i] -= at(i + ahead, ahead) * x[i + ahead];
    }
  }
  solution.resize(n_);
  for (std::size_t i = 0; i < n_; ++i) solution[i] = x[place(i)];
  return true;
}

}  // namespace talweg
