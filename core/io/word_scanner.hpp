// A word scanner reads a text word by word, across lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace talweg::formats {

/// The line, counted from 1, that contains a byte of a text.
std::size_t line_of(std::string_view text, std::size_t position);

/// Reads words one after the other. Numbers do not depend on the locale. All errors are
/// Error(kBadFile) and name the file, the line of the last word, what was expected and what was
/// found.
class WordScanner {
 public:
  /// Begins at a byte on the given line; a byte order mark at the start is skipped.
  WordScanner(const std::filesystem::path& path, std::string_view text, std::size_t position = 0,
              std::size_t line = 1);

  /// The next word on any line; empty at the end of the file.
  std::string_view word();
  /// The next word on this line; empty at its end. A backslash before the end joins lines.
  std::string_view word_on_line();
  /// Goes to the start of the next line; false at the end of the file.
  bool next_line();
  /// The rest of this line, without its end; does not advance.
  [[nodiscard]] std::string_view rest_of_line() const;

  /// A finite number.
  double number(std::string_view word, const char* expected) const;
  std::int64_t integer(std::string_view word, const char* expected) const;
  /// An integer in [0, limit).
  std::uint64_t count(std::string_view word, const char* expected, std::uint64_t limit) const;

  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] std::size_t remaining() const { return text_.size() - position_; }
  /// The next n bytes, unchanged; throws if there are fewer. Lines in them are not counted.
  std::string_view bytes(std::size_t n);
  /// Continues at a later byte. Skipped lines are counted.
  void skip_to(std::size_t position);
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  [[noreturn]] void fail(const std::string& expected, std::string_view found) const;
  [[noreturn]] void fail(const std::string& what) const;

 private:
  const std::filesystem::path& path_;
  std::string_view text_;
  std::size_t position_;
  std::size_t line_;
};

}  // namespace talweg::formats
