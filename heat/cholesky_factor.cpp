#include "talweg/heat/cholesky_factor.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <span>
#include <string>
#include <utility>

#include "talweg/heat/dense_block.hpp"
#include "talweg/heat/fill_reducing_order.hpp"
#include "talweg/heat/large_array.hpp"
#include "talweg/heat/supernodes.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

void check_pattern(const SymmetricMatrix& matrix) {
  const std::size_t n = matrix.size();
  bool good = n > 0 && matrix.column_start[0] == 0 &&
              static_cast<std::size_t>(matrix.column_start[n]) == matrix.row.size();
  for (std::size_t j = 0; good && j < n; ++j) {
    const std::int32_t begin = matrix.column_start[j], end = matrix.column_start[j + 1];
    good = begin < end && static_cast<std::size_t>(matrix.row[begin]) == j;
    for (std::int32_t k = begin + 1; good && k < end; ++k) {
      good = matrix.row[k] > matrix.row[k - 1] && static_cast<std::size_t>(matrix.row[k]) < n;
    }
    if (!good) {
      throw Error(ErrorCode::kNumerical, "Ordering the matrix failed: column " + std::to_string(j) +
                                             " is not a sorted lower triangle with diagonal.");
    }
  }
  if (!good) throw Error(ErrorCode::kNumerical, "Ordering the matrix failed: it is empty.");
}

void check_values(const SymmetricMatrix& matrix) {
  for (std::size_t j = 0; j < matrix.size(); ++j) {
    for (std::int32_t k = matrix.column_start[j]; k < matrix.column_start[j + 1]; ++k) {
      if (std::isfinite(matrix.value[k])) continue;
      throw Error(ErrorCode::kNumerical, "Factoring failed: the matrix has an entry in column " +
                                             std::to_string(j) + " that is not finite.");
    }
  }
}

/// What `task` returns, with an error of ours when memory runs out.
template <class Task>
auto in_memory(const char* name, Task&& task) {
  try {
    return task();
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::kOutOfMemory, std::string(name) + " failed: out of memory.");
  }
}

/// The multifrontal method (Duff & Reid 1983; Liu 1992): supernode by supernode in postorder. The
/// front of a supernode is its block and, for the rows below, a square of what its ancestors are
/// to receive. Squares wait on a stack, those of a supernode's children on top when its turn comes.
class Multifrontal {
 public:
  Multifrontal(const Supernodes& shape, const PermutedEntries& entries,
               const SymmetricMatrix& matrix, double* values)
      : shape_(shape),
        entries_(entries),
        matrix_(matrix),
        values_(values),
        place_(shape.size(), 0) {}

  void run() {
    for (std::size_t s = 0; s < shape_.count(); ++s) {
      assemble(s);
      const std::size_t width = shape_.width(s), height = shape_.height(s);
      double* block = values_ + shape_.block_start[s];
      const std::size_t done = factor_block(block, height, width, scratch_);
      if (done < width) {
        throw Error(ErrorCode::kNumerical,
                    "Factoring failed: the matrix is not positive definite (column " +
                        std::to_string(shape_.old_of_new[shape_.first[s] + done]) + ").");
      }
      const std::size_t below = height - width;
      subtract_outer(square_.data(), below, below, below, block + width, height, width, scratch_);
      push(s, below);
    }
  }

 private:
  struct Waiting {
    std::size_t supernode;
    std::size_t start;  // of its square's lower triangle on the stack
  };

  void assemble(std::size_t s) {
    const std::int32_t first = shape_.first[s], end = shape_.first[s + 1];
    const std::size_t width = shape_.width(s), height = shape_.height(s);
    for (std::int32_t j = first; j < end; ++j) place_[j] = j - first;
    auto place = static_cast<std::int32_t>(width);
    for (const std::int32_t row : shape_.rows_below(s)) place_[row] = place++;
    double* block = values_ + shape_.block_start[s];
    for (std::int32_t j = first; j < end; ++j) {
      double* column = block + static_cast<std::size_t>(j - first) * height;
      for (std::int32_t k = entries_.start[j]; k < entries_.start[j + 1]; ++k) {
        const auto [row, entry] = entries_.entries[k];
        column[place_[row]] = matrix_.value[entry];
      }
    }
    const std::size_t below = height - width;
    square_.assign(below * below, 0.0);
    while (!waiting_.empty() &&
           shape_.parent[waiting_.back().supernode] == static_cast<std::int32_t>(s)) {
      add(waiting_.back(), block, width, height);
      stack_.resize(waiting_.back().start);
      waiting_.pop_back();
    }
  }

  /// Adds a child's square to the front.
  void add(const Waiting& child, double* block, std::size_t width, std::size_t height) {
    const auto rows = shape_.rows_below(child.supernode);
    to_.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) to_[i] = place_[rows[i]];
    const double* from = stack_.data() + child.start;
    const std::size_t below = height - width;
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const auto column = static_cast<std::size_t>(to_[j]);
      double* into = column < width ? block + column * height
                                    : square_.data() + (column - width) * below - width;
      for (std::size_t i = j; i < rows.size(); ++i) into[to_[i]] += *from++;
    }
  }

  void push(std::size_t s, std::size_t below) {
    if (below == 0) return;
    waiting_.push_back({s, stack_.size()});
    for (std::size_t j = 0; j < below; ++j) {
      const auto column = square_.begin() + static_cast<std::ptrdiff_t>(j * below);
      stack_.insert(stack_.end(), column + static_cast<std::ptrdiff_t>(j),
                    column + static_cast<std::ptrdiff_t>(below));
    }
  }

  const Supernodes& shape_;
  const PermutedEntries& entries_;
  const SymmetricMatrix& matrix_;
  double* values_;
  std::vector<std::int32_t> place_;  // of a row in the current front
  std::vector<std::int32_t> to_;
  std::vector<double> square_;  // of the current front, by columns
  std::vector<double> stack_;   // lower triangles of squares
  std::vector<Waiting> waiting_;
  DenseScratch scratch_;
};

}  // namespace

struct SymbolicFactor::Impl {
  std::shared_ptr<const Supernodes> shape;
  PermutedEntries entries;
  std::size_t factor_entries = 0;
};

SymbolicFactor::SymbolicFactor(const SymmetricMatrix& pattern) {
  check_pattern(pattern);
  impl_ = in_memory("Ordering the matrix", [&] {
    FillReducingOrder order = fill_reducing_order(pattern);
    auto impl = std::make_shared<Impl>();
    impl->entries = permuted_entries(pattern, order.old_of_new);
    impl->shape = std::make_shared<const Supernodes>(
        supernodes_of(impl->entries, std::move(order.old_of_new), order.column_count));
    impl->factor_entries = impl->shape->block_start.back();
    return impl;
  });
}

std::size_t SymbolicFactor::size() const { return impl_->shape->size(); }
std::size_t SymbolicFactor::factor_entries() const { return impl_->factor_entries; }

struct CholeskyFactor::Impl {
  std::shared_ptr<const Supernodes> shape;
  LargeArray values;

  [[nodiscard]] std::vector<char> reached_from(const double* x) const;
  void forward(double* x) const;
  void backward(double* x) const;
};

CholeskyFactor::CholeskyFactor(const SymbolicFactor& symbolic, const SymmetricMatrix& matrix)
    : impl_(std::make_unique<Impl>()) {
  if (matrix.size() != symbolic.size() || matrix.value.size() != matrix.row.size()) {
    throw Error(ErrorCode::kNumerical, "Factoring failed: the matrix is not the analysed one.");
  }
  check_values(matrix);
  impl_->shape = symbolic.impl_->shape;
  in_memory("Factoring", [&] {
    impl_->values = LargeArray(symbolic.factor_entries() + kSpare);
    Multifrontal(*impl_->shape, symbolic.impl_->entries, matrix, impl_->values.data()).run();
  });
}

CholeskyFactor::~CholeskyFactor() = default;
CholeskyFactor::CholeskyFactor(CholeskyFactor&&) noexcept = default;
CholeskyFactor& CholeskyFactor::operator=(CholeskyFactor&&) noexcept = default;

std::size_t CholeskyFactor::size() const { return impl_->shape->size(); }

/// Supernodes with an entry of x that is not 0, and their ancestors: where L⁻¹ x is not 0.
std::vector<char> CholeskyFactor::Impl::reached_from(const double* x) const {
  std::vector<char> reached(shape->count(), 0);
  for (std::size_t s = 0; s < reached.size(); ++s) {
    for (std::int32_t j = shape->first[s]; reached[s] == 0 && j < shape->first[s + 1]; ++j) {
      if (x[j] != 0) reached[s] = 1;
    }
    if (reached[s] != 0 && shape->parent[s] >= 0) reached[shape->parent[s]] = 1;
  }
  return reached;
}

void CholeskyFactor::Impl::forward(double* x) const {
  const std::vector<char> reached = reached_from(x);
  std::vector<double> local;
  for (std::size_t s = 0; s < shape->count(); ++s) {
    if (reached[s] == 0) continue;
    const std::size_t width = shape->width(s), height = shape->height(s);
    const auto rows = shape->rows_below(s);
    double* own = x + shape->first[s];
    local.assign(height + kSpare, 0.0);
    std::copy_n(own, width, local.begin());
    solve_forward(values.data() + shape->block_start[s], height, width, local.data());
    std::copy_n(local.begin(), width, own);
    for (std::size_t i = 0; i < rows.size(); ++i) x[rows[i]] += local[width + i];
  }
}

void CholeskyFactor::Impl::backward(double* x) const {
  std::vector<double> local;
  for (std::size_t s = shape->count(); s-- > 0;) {
    const std::size_t width = shape->width(s), height = shape->height(s);
    const auto rows = shape->rows_below(s);
    double* own = x + shape->first[s];
    local.resize(height + kSpare);
    std::copy_n(own, width, local.begin());
    for (std::size_t i = 0; i < rows.size(); ++i) local[width + i] = x[rows[i]];
    std::fill_n(local.begin() + static_cast<std::ptrdiff_t>(height), kSpare, 0.0);
    solve_backward(values.data() + shape->block_start[s], height, width, local.data());
    std::copy_n(local.begin(), width, own);
  }
}

std::vector<double> CholeskyFactor::solve(const std::vector<double>& b) const {
  if (b.size() != size()) {
    throw Error(ErrorCode::kBadUsage, "The right-hand side has " + std::to_string(b.size()) +
                                          " entries instead of " + std::to_string(size()) + ".");
  }
  return in_memory("Solving", [&] {
    const std::vector<std::int32_t>& old_of_new = impl_->shape->old_of_new;
    LargeArray x(size());
    for (std::size_t k = 0; k < b.size(); ++k) x.data()[k] = b[old_of_new[k]];
    impl_->forward(x.data());
    impl_->backward(x.data());
    std::vector<double> result(b.size());
    for (std::size_t k = 0; k < b.size(); ++k) result[old_of_new[k]] = x.data()[k];
    return result;
  });
}

}  // namespace talweg
