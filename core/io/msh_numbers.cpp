#include "talweg/core/io/msh_numbers.hpp"

#include <fmt/format.h>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/text_words.hpp"

namespace talweg::formats {

bool MshNumbers::parse_real(std::string_view word, double& value) { return parse(word, value); }

std::size_t MshNumbers::count(std::int64_t value, const char* what, std::size_t size) const {
  if (value < 0) fail(fmt::format("there are {} {}", value, what));
  const std::size_t each = binary_ ? size : 2;
  if (static_cast<std::uint64_t>(value) > scanner_.remaining() / each + 1) {
    fail(fmt::format("{} {} are announced, but the file ends earlier", value, what));
  }
  return static_cast<std::size_t>(value);
}

void MshNumbers::fail(const std::string& what) const {
  if (!binary_) scanner_.fail(what);
  cannot_read(scanner_.path(), fmt::format("byte {}: {}", scanner_.position(), what));
}

}  // namespace talweg::formats
