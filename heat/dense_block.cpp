#include "talweg/heat/dense_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Core>

namespace talweg {
namespace {

constexpr std::size_t kTile = 4;  // rows and columns of what stays in registers
using Lanes = Eigen::Array<double, kTile, 1>;
constexpr std::size_t kInner = 64;  // columns of A at a time: their rows' tiles stay in the cache
constexpr std::size_t kPanel = 8;   // columns that factor_block takes at a time

Lanes lanes(const double* from) { return Eigen::Map<const Lanes>(from); }

/// The rows of A in tiles of four, each tile by columns, the last one filled up with zeros.
void pack(const double* a, std::size_t stride, std::size_t rows, std::size_t inner, double* to) {
  for (std::size_t i = 0; i < rows; i += kTile) {
    const std::size_t there = std::min(kTile, rows - i);
    for (std::size_t t = 0; t < inner; ++t) {
      for (std::size_t r = 0; r < kTile; ++r) *to++ = r < there ? a[t * stride + i + r] : 0.0;
    }
  }
}

struct Tile {
  std::array<Lanes, kTile> column;
};

/// Σ a bᵀ over the columns of two packed tiles.
Tile product(const double* a, const double* b, std::size_t inner) {
  Tile sum;
  sum.column.fill(Lanes::Zero());
  for (std::size_t t = 0; t < inner; ++t, a += kTile, b += kTile) {
    const Lanes rows = lanes(a);
    for (std::size_t j = 0; j < kTile; ++j) sum.column[j] += rows * b[j];
  }
  return sum;
}

void subtract(double* c, std::size_t stride, std::size_t rows, std::size_t columns,
              const Tile& tile) {
  for (std::size_t j = 0; j < columns; ++j, c += stride) {
    if (rows == kTile) {
      Eigen::Map<Lanes>{c} -= tile.column[j];
    } else {
      for (std::size_t i = 0; i < rows; ++i) c[i] -= tile.column[j][static_cast<int>(i)];
    }
  }
}

/// Columns [begin, end) of a block, from those to the left of `begin` already taken off.
std::size_t factor_panel(double* block, std::size_t height, std::size_t begin, std::size_t end) {
  for (std::size_t j = begin; j < end; ++j) {
    double* column = block + j * height;
    for (std::size_t k = begin; k < j; ++k) {
      const double* left = block + k * height;
      const double factor = left[j];
      for (std::size_t i = j; i < height; ++i) column[i] -= factor * left[i];
    }
    if (!(column[j] > 0)) return j;
    column[j] = std::sqrt(column[j]);
    const double inverse = 1 / column[j];
    for (std::size_t i = j + 1; i < height; ++i) column[i] *= inverse;
  }
  return end;
}

}  // namespace

void subtract_outer(double* c, std::size_t c_stride, std::size_t rows, std::size_t columns,
                    const double* a, std::size_t a_stride, std::size_t inner,
                    DenseScratch& scratch) {
  const std::size_t padded = (rows + kTile - 1) / kTile * kTile;
  scratch.resize(std::max(scratch.size(), padded * std::min(inner, kInner)));
  for (std::size_t t = 0; t < inner; t += kInner) {
    const std::size_t some = std::min(kInner, inner - t);
    pack(a + t * a_stride, a_stride, rows, some, scratch.data());
    for (std::size_t j = 0; j < columns; j += kTile) {
      for (std::size_t i = j; i < rows; i += kTile) {
        const Tile tile = product(scratch.data() + i * some, scratch.data() + j * some, some);
        double* to = c + j * c_stride + i;
        subtract(to, c_stride, std::min(kTile, rows - i), std::min(kTile, columns - j), tile);
      }
    }
  }
}

std::size_t factor_block(double* block, std::size_t height, std::size_t width,
                         DenseScratch& scratch) {
  for (std::size_t begin = 0; begin < width; begin += kPanel) {
    const std::size_t end = std::min(begin + kPanel, width);
    subtract_outer(block + begin * height + begin, height, height - begin, end - begin,
                   block + begin, height, begin, scratch);
    const std::size_t done = factor_panel(block, height, begin, end);
    if (done < end) return done;
  }
  return width;
}

namespace {

/// Columns [j, j + kColumns) of a block; all of them at once read and write x once.
template <std::size_t kColumns>
void forward(const double* block, std::size_t height, std::size_t j, double* x) {
  std::array<const double*, kColumns> column;
  std::array<double, kColumns> known;
  for (std::size_t k = 0; k < kColumns; ++k) {
    column[k] = block + (j + k) * height;
    for (std::size_t l = 0; l < k; ++l) x[j + k] -= column[l][j + k] * known[l];
    known[k] = x[j + k] /= column[k][j + k];
  }
  for (std::size_t i = j + kColumns; i < height; i += kTile) {
    Lanes below = lanes(x + i);
    for (std::size_t k = 0; k < kColumns; ++k) below -= lanes(column[k] + i) * known[k];
    Eigen::Map<Lanes>{x + i} = below;
  }
}

/// Asks for what is stored `before` numbers before this place, perhaps in the block of another
/// supernode or nowhere. Memory that is walked through backwards is not foreseen by the machine.
void fetch_ahead(const double* place, std::size_t before) {
  const auto address = reinterpret_cast<std::uintptr_t>(place) - before * sizeof(double);
  // NOLINTNEXTLINE(performance-no-int-to-ptr): only a hint, which never faults
  __builtin_prefetch(reinterpret_cast<const void*>(address));
}

template <std::size_t kColumns>
void backward(const double* block, std::size_t height, std::size_t j, double* x) {
  std::array<const double*, kColumns> column;
  std::array<Lanes, kColumns> sum;
  sum.fill(Lanes::Zero());
  for (std::size_t k = 0; k < kColumns; ++k) column[k] = block + (j + k) * height;
  for (std::size_t i = j + kColumns; i < height; i += kTile) {
    const Lanes below = lanes(x + i);
    for (std::size_t k = 0; k < kColumns; ++k) fetch_ahead(column[k] + i, kTile * height + 16);
    for (std::size_t k = 0; k < kColumns; ++k) sum[k] += lanes(column[k] + i) * below;
  }
  for (std::size_t k = kColumns; k-- > 0;) {
    double& here = x[j + k];
    here -= sum[k].sum();
    for (std::size_t l = k + 1; l < kColumns; ++l) here -= column[k][j + l] * x[j + l];
    here /= column[k][j + k];
  }
}

}  // namespace

void solve_forward(const double* block, std::size_t height, std::size_t width, double* x) {
  std::size_t j = 0;
  for (; j + kTile <= width; j += kTile) forward<kTile>(block, height, j, x);
  switch (width - j) {
    case 3:
      return forward<3>(block, height, j, x);
    case 2:
      return forward<2>(block, height, j, x);
    case 1:
      return forward<1>(block, height, j, x);
    default:
      return;
  }
}

void solve_backward(const double* block, std::size_t height, std::size_t width, double* x) {
  std::size_t j = width / kTile * kTile;
  switch (width - j) {
    case 3:
      backward<3>(block, height, j, x);
      break;
    case 2:
      backward<2>(block, height, j, x);
      break;
    case 1:
      backward<1>(block, height, j, x);
      break;
    default:
      break;
  }
  for (; j > 0; j -= kTile) backward<kTile>(block, height, j - kTile, x);
}

}  // namespace talweg
