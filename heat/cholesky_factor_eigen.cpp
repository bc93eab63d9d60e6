// Eigen's factor, for builds without CHOLMOD.
#include <string>
#include <utility>

#include <Eigen/Core>

#include "talweg/heat/cholesky_factor.hpp"
#include "talweg/heat/simplicial_factor.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {

struct SymbolicFactor::Impl {
  SimplicialOrder order;
};

SymbolicFactor::SymbolicFactor(const SymmetricMatrix& pattern, FactorKind)
    : impl_(std::make_shared<const Impl>(Impl{SimplicialOrder(pattern)})) {}

std::size_t SymbolicFactor::size() const { return impl_->order.size(); }
FactorKind SymbolicFactor::kind() const { return FactorKind::kSimplicial; }
std::size_t SymbolicFactor::factor_entries() const { return impl_->order.factor_entries(); }

struct CholeskyFactor::Impl {
  std::size_t size;
  SimplicialFactor factor;
};

CholeskyFactor::CholeskyFactor(const SymbolicFactor& symbolic, const SymmetricMatrix& matrix)
    : impl_(std::make_unique<Impl>(
          Impl{symbolic.size(), SimplicialFactor(symbolic.impl_->order, matrix)})) {}

CholeskyFactor::~CholeskyFactor() = default;
CholeskyFactor::CholeskyFactor(CholeskyFactor&&) noexcept = default;
CholeskyFactor& CholeskyFactor::operator=(CholeskyFactor&&) noexcept = default;

std::size_t CholeskyFactor::size() const { return impl_->size; }

std::vector<double> CholeskyFactor::solve(const std::vector<double>& b) const {
  if (b.size() != size()) {
    throw Error(ErrorCode::kBadUsage, "The right-hand side has " + std::to_string(b.size()) +
                                          " entries instead of " + std::to_string(size()) + ".");
  }
  return impl_->factor.solve(b);
}

std::string factor_libraries() {
  return "Eigen " + std::to_string(EIGEN_WORLD_VERSION) + "." +
         std::to_string(EIGEN_MAJOR_VERSION) + "." + std::to_string(EIGEN_MINOR_VERSION) +
         ", simplicial";
}

}  // namespace talweg
