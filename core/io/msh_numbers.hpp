// MSH numbers are the contents of the sections of Gmsh's files, as text or as bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "talweg/core/io/byte_cursor.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg::formats {

/// Reads one number after the other. All errors are Error(kBadFile) with the line, or the byte.
class MshNumbers {
 public:
  explicit MshNumbers(const MeshFile& file) : scanner_(file.path, file.bytes) {}

  /// From here on numbers are bytes; `large` is the size of a size_t.
  void set_binary(bool swap, std::size_t large) {
    binary_ = true;
    swap_ = swap;
    large_ = large;
  }
  void set_swap(bool swap) { swap_ = swap; }
  [[nodiscard]] bool is_binary() const { return binary_; }

  /// An int, a size_t (4 or 8 bytes) and a double; `what` names it in errors.
  std::int64_t whole(const char* what) {
    if (!binary_) return scanner_.integer(scanner_.word(), what);
    return load<std::int32_t>(bytes(4, what), swap_);
  }
  std::int64_t large(const char* what) {
    if (!binary_) return scanner_.integer(scanner_.word(), what);
    if (large_ == 4) return load<std::uint32_t>(bytes(4, what), swap_);
    return load<std::int64_t>(bytes(8, what), swap_);
  }
  double real(const char* what) {
    if (binary_) return load<double>(bytes(8, what), swap_);
    const std::string_view word = scanner_.word();
    double value = 0;
    if (!parse_real(word, value)) scanner_.fail(what, word);
    return value;
  }
  /// Checks a count against the rest of the file: an element has at least `size` bytes, in text
  /// two.
  std::size_t count(std::int64_t value, const char* what, std::size_t size) const;

  void skip(std::size_t n, const char* what) { bytes(n, what); }
  WordScanner& scanner() { return scanner_; }
  [[noreturn]] void fail(const std::string& what) const;

 private:
  static bool parse_real(std::string_view word, double& value);
  const char* bytes(std::size_t n, const char* what) {
    if (n > scanner_.remaining()) fail(std::string("the file ends where it should have ") + what);
    return scanner_.bytes(n).data();
  }

  WordScanner scanner_;
  bool binary_ = false, swap_ = false;
  std::size_t large_ = 8;
};

}  // namespace talweg::formats
