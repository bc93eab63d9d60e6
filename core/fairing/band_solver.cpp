#include "talweg/core/fairing/band_solver.hpp"

namespace talweg {

void BandSystem::reset(std::size_t n, bool ring) {
  n_ = n;
  width_ = ring ? 4 : 2;
  ring_ = ring;
  entries_.assign(n * (width_ + 1), 0.0);
  right_.assign(n, 0.0);
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

/// Replaces the coefficients by factors and the right side by the solution. The width is a template
/// parameter, so loops over it are unrolled.
template <std::size_t kWidth>
bool BandSystem::eliminate() {
  double* const factor = entries_.data();
  double* const x = right_.data();
  const auto at = [factor](std::size_t row, std::size_t back) -> double& {
    return factor[row * (kWidth + 1) + back];
  };
  const auto row = [&](std::size_t i, std::size_t reach) {
    for (std::size_t back = reach; back > 0; --back) {
      const std::size_t j = i - back;
      double sum = at(i, back);
      for (std::size_t k = back + 1; k <= reach; ++k) {
        sum -= at(i, k) * at(j, k - back) * at(i - k, 0);
      }
      at(i, back) = sum / at(j, 0);
    }
    for (std::size_t back = 1; back <= reach; ++back) {
      at(i, 0) -= at(i, back) * at(i, back) * at(i - back, 0);
      x[i] -= at(i, back) * x[i - back];
    }
    return at(i, 0) > 0;
  };
  for (std::size_t i = 0; i < std::min(kWidth, n_); ++i) {
    if (!row(i, i)) return false;
  }
  for (std::size_t i = kWidth; i < n_; ++i) {
    if (!row(i, kWidth)) return false;
  }
  for (std::size_t i = n_; i-- > 0;) {
    x[i] /= at(i, 0);
    for (std::size_t ahead = 1; ahead <= kWidth && i + ahead < n_; ++ahead) {
      x[i] -= at(i + ahead, ahead) * x[i + ahead];
    }
  }
  return true;
}

bool BandSystem::solve(std::vector<double>& solution) {
  if (!(ring_ ? eliminate<4>() : eliminate<2>())) return false;
  solution.resize(n_);
  for (std::size_t i = 0; i < n_; ++i) solution[i] = right_[place(i)];
  return true;
}

}  // namespace talweg
