// A line scanner reads a mesh file word by word and line by line, fast enough for millions of
// lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/text_words.hpp"

namespace talweg {

/// Reads the lines of a file that are not blank. Independent of the locale.
class LineScanner {
 public:
  /// The text after `comment` on a line is skipped; '\0' for none. Line 1 starts at byte `from`; a
  /// byte order mark (UTF-8) at the start of the file is skipped.
  explicit LineScanner(const MeshFile& file, char comment = '\0', std::size_t from = 0,
                       std::size_t lines_before = 0)
      : file_(&file), comment_(comment), next_(from), line_(lines_before) {
    if (from == 0 && file.bytes.starts_with("\xEF\xBB\xBF")) next_ = 3;
  }

  /// Goes to the next line that is not blank; false at the end of the file.
  bool next_line();
  /// Like next_line(), but throws at the end of the file; `expected` names the missing part.
  void need_line(const std::string& expected);

  /// The next word of the line; empty at its end.
  std::string_view word();
  /// The next word as a finite number. Throws Error(kBadFile).
  double number(const char* what);
  /// The next word as a coordinate, which may be NaN or infinite; `odd` is then the word.
  double coordinate(std::string_view& odd);
  /// The next word as a whole number. Throws Error(kBadFile).
  std::int64_t integer(const char* what);

  /// Continues the line with the following one, because a backslash ends it.
  void join_next();
  [[nodiscard]] std::size_t line() const { return line_; }
  /// The byte after the line.
  [[nodiscard]] std::size_t offset() const { return next_; }
  [[noreturn]] void fail(const std::string& what) const { bad_line(file_->path, line_, what); }

 private:
  void take_line();
  /// Parses the next word while finding it, if it is a plain number; otherwise takes nothing.
  template <class Value>
  bool take(Value& value);
  /// Parses a number with a plus sign or out of range; throws for other words.
  double unusual_number(const char* what);

  const MeshFile* file_;
  char comment_;
  std::size_t next_;
  std::size_t line_;
  std::string_view rest_;
};

/// A word in quotes, shortened and made printable, for error messages.
std::string quoted(std::string_view word);

}  // namespace talweg
