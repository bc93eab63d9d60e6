#include "suggestion.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace talweg::driver {
namespace {

/// The number of letters to replace, insert, remove or exchange with their neighbour.
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> edits(a.size() + 1,
                                              std::vector<std::size_t>(b.size() + 1, 0));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& least = edits[i][j];
      if (i == 0 || j == 0) {
        least = i + j;
        continue;
      }
      least = std::min({edits[i - 1][j] + 1, edits[i][j - 1] + 1,
                        edits[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        least = std::min(least, edits[i - 2][j - 2] + 1);
      }
    }
  }
  return edits[a.size()][b.size()];
}

std::string_view letters_of(std::string_view word) {
  const std::size_t first = word.find_first_not_of('-');
  return first == std::string_view::npos ? std::string_view() : word.substr(first);
}

}  // namespace

std::string suggestion(std::string_view written, std::span<const std::string> known) {
  constexpr std::size_t kLongest = 40;  // longer than any name of an option
  const std::string_view letters = letters_of(written);
  if (letters.size() < 2 || letters.size() > kLongest) return "";
  const std::string* best = nullptr;
  std::size_t least = letters.size() < 5 ? 2 : 3;  // a suggestion must have fewer edits
  for (const std::string& word : known) {
    const std::string_view other = letters_of(word);
    const std::size_t edits =
        letters.size() > 2 && other.starts_with(letters) ? 1 : edits_between(letters, other);
    if (edits >= least || edits >= other.size()) continue;
    least = edits;
    best = &word;
  }
  return best == nullptr ? "" : "; did you mean " + *best + "?";
}

}  // namespace talweg::driver
