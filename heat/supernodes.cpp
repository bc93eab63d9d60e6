#include "talweg/heat/supernodes.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace talweg {
namespace {

/// Liu's algorithm: the parent of column j is the first row below the diagonal of the factor's
/// column j. Wants the entries by rows: below_of[i] lists the columns j < i of row i.
std::vector<std::int32_t> elimination_tree(const PermutedEntries& matrix) {
  const std::size_t n = matrix.start.size() - 1;
  std::vector<std::int32_t> start(n + 1, 0);
  for (const auto& [row, entry] : matrix.entries) ++start[row + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::int32_t> columns(matrix.entries.size());
  std::vector<std::int32_t> place(start.begin(), start.end() - 1);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::int32_t k = matrix.start[j]; k < matrix.start[j + 1]; ++k) {
      columns[place[matrix.entries[k].row]++] = static_cast<std::int32_t>(j);
    }
  }
  std::vector<std::int32_t> parent(n, -1), ancestor(n, -1);
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = static_cast<std::int32_t>(i);
    for (std::int32_t k = start[i]; k < start[i + 1]; ++k) {
      std::int32_t j = columns[k];
      while (j != -1 && j < row) {
        const std::int32_t above = std::exchange(ancestor[j], row);
        if (above == -1) parent[j] = row;
        j = above;
      }
    }
  }
  return parent;
}

/// Supernodes while they are merged: columns, rows of the first column, zeros stored.
struct Group {
  std::int32_t first = 0;
  std::int32_t width = 0;
  std::int32_t height = 0;
  double zeros = 0;
};

/// Whether b, the parent that follows on a, should be stored with it as one block.
bool worth_merging(const Group& a, const Group& b, Group& both) {
  both.first = a.first;
  both.width = a.width + b.width;
  both.height = a.width + b.height;
  const auto added = static_cast<double>(both.height - a.height);
  both.zeros = a.zeros + b.zeros + added * a.width;
  const double w = both.width;
  const double share = both.zeros / (w * (w + 1) / 2 + w * (both.height - both.width));
  if (added == 0) return true;
  // What pays was measured on meshes of 80,000 to a million faces (docs/performance.md).
  return both.width <= 4 ? share < 0.3 : both.width <= 16 ? share < 0.15 : share < 0.05;
}

/// One pass in postorder: each column joins the group that ends before it if that is its child.
std::vector<Group> merged_columns(const std::vector<std::int32_t>& parent,
                                  std::span<const std::int32_t> column_count) {
  std::vector<Group> groups;
  for (std::size_t j = 0; j < parent.size(); ++j) {
    Group group{static_cast<std::int32_t>(j), 1, column_count[j], 0};
    if (!groups.empty() && parent[j - 1] == group.first &&
        groups.back().height == group.height + groups.back().width) {
      ++groups.back().width;  // the same structure
    } else {
      groups.push_back(group);
    }
  }
  std::vector<Group> merged;
  for (Group group : groups) {
    Group both;
    while (!merged.empty() && parent[group.first - 1] == group.first &&
           worth_merging(merged.back(), group, both)) {
      group = both;
      merged.pop_back();
    }
    merged.push_back(group);
  }
  return merged;
}

/// The rows of each block: those of its columns in the matrix and those of its children.
void gather_rows(const PermutedEntries& matrix, Supernodes& s) {
  const std::size_t n = s.size();
  std::vector<std::int32_t> seen(n, -1), supernode_of(n);
  for (std::size_t k = 0; k < s.count(); ++k) {
    std::fill(supernode_of.begin() + s.first[k], supernode_of.begin() + s.first[k + 1],
              static_cast<std::int32_t>(k));
  }
  std::vector<std::vector<std::int32_t>> children(s.count());
  s.row_start.assign(1, 0);
  for (std::size_t k = 0; k < s.count(); ++k) {
    const std::int32_t end = s.first[k + 1];
    const auto add = [&](std::int32_t row) {
      if (row < end || std::exchange(seen[row], end) == end) return;
      s.rows.push_back(row);
    };
    for (std::int32_t i = matrix.start[s.first[k]]; i < matrix.start[end]; ++i) {
      add(matrix.entries[i].row);
    }
    for (const std::int32_t child : children[k]) {
      for (std::size_t i = s.row_start[child]; i < s.row_start[child + 1]; ++i) add(s.rows[i]);
    }
    std::sort(s.rows.begin() + static_cast<std::ptrdiff_t>(s.row_start[k]), s.rows.end());
    s.row_start.push_back(s.rows.size());
    const auto below = s.rows_below(k);
    s.parent[k] = below.empty() ? -1 : supernode_of[below.front()];
    if (s.parent[k] >= 0) children[s.parent[k]].push_back(static_cast<std::int32_t>(k));
  }
}

}  // namespace

PermutedEntries permuted_entries(const SymmetricMatrix& pattern,
                                 std::span<const std::int32_t> old_of_new) {
  const std::size_t n = pattern.size();
  std::vector<std::int32_t> new_of_old(n);
  for (std::size_t k = 0; k < n; ++k) new_of_old[old_of_new[k]] = static_cast<std::int32_t>(k);
  PermutedEntries result;
  result.start.assign(n + 1, 0);
  const auto for_each = [&](auto&& visit) {
    for (std::size_t j = 0; j < n; ++j) {
      const std::int32_t column = new_of_old[j];
      for (std::int32_t k = pattern.column_start[j]; k < pattern.column_start[j + 1]; ++k) {
        const std::int32_t row = new_of_old[pattern.row[k]];
        visit(std::min(row, column), std::max(row, column), k);
      }
    }
  };
  for_each([&](std::int32_t column, std::int32_t, std::int32_t) { ++result.start[column + 1]; });
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  result.entries.resize(pattern.row.size());
  std::vector<std::int32_t> place(result.start.begin(), result.start.end() - 1);
  for_each([&](std::int32_t column, std::int32_t row, std::int32_t k) {
    result.entries[place[column]++] = {row, k};
  });
  return result;
}

Supernodes supernodes_of(const PermutedEntries& matrix, std::vector<std::int32_t> old_of_new,
                         std::span<const std::int32_t> column_count) {
  Supernodes s;
  s.old_of_new = std::move(old_of_new);
  const std::vector<Group> groups = merged_columns(elimination_tree(matrix), column_count);
  for (const Group& group : groups) s.first.push_back(group.first);
  s.first.push_back(static_cast<std::int32_t>(s.size()));
  s.parent.assign(groups.size(), -1);
  gather_rows(matrix, s);
  s.block_start.assign(1, 0);
  for (std::size_t k = 0; k < s.count(); ++k) {
    s.block_start.push_back(s.block_start.back() + s.width(k) * s.height(k));
  }
  return s;
}

}  // namespace talweg
