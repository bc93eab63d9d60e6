#include "talweg/core/io/word_scanner.hpp"

#include <algorithm>
#include <cmath>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/text_words.hpp"

namespace talweg::formats {
namespace {

bool is_space(char c) { return is_blank(c) || c == '\n'; }

}  // namespace

std::size_t line_of(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, position);
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

WordScanner::WordScanner(const std::filesystem::path& path, std::string_view text,
                         std::size_t position, std::size_t line)
    : path_(path), text_(text), position_(position), line_(line) {
  if (position_ == 0 && text_.substr(0, 3) == "\xEF\xBB\xBF") position_ = 3;
}

std::string_view WordScanner::word() {
  while (position_ < text_.size() && is_space(text_[position_])) {
    if (text_[position_++] == '\n') ++line_;
  }
  const std::size_t start = position_;
  while (position_ < text_.size() && !is_space(text_[position_])) ++position_;
  return text_.substr(start, position_ - start);
}

std::string_view WordScanner::word_on_line() {
  for (;;) {
    while (position_ < text_.size() && is_blank(text_[position_])) ++position_;
    if (position_ == text_.size() || text_[position_] != '\\') break;
    const std::string_view rest = rest_of_line();
    if (rest != "\\" && rest != "\\\r") break;
    if (!next_line()) break;
  }
  const std::size_t start = position_;
  while (position_ < text_.size() && !is_space(text_[position_])) ++position_;
  return text_.substr(start, position_ - start);
}

bool WordScanner::next_line() {
  const std::size_t end = text_.find('\n', position_);
  if (end == std::string_view::npos) {
    position_ = text_.size();
    return false;
  }
  position_ = end + 1;
  ++line_;
  return position_ < text_.size();
}

std::string_view WordScanner::rest_of_line() const {
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  return text_.substr(position_, end - position_);
}

std::string_view WordScanner::bytes(std::size_t n) {
  const std::string_view result = text_.substr(position_, n);
  position_ += result.size();
  return result;
}

void WordScanner::skip_to(std::size_t position) {
  line_ += line_of(text_.substr(position_, position - position_), position - position_) - 1;
  position_ = position;
}

double WordScanner::number(std::string_view word, const char* expected) const {
  double value = 0;
  if (!parse(word, value)) fail(expected, word);
  if (!std::isfinite(value)) fail("a finite number", word);
  return value;
}

std::int64_t WordScanner::integer(std::string_view word, const char* expected) const {
  std::int64_t value = 0;
  if (!parse(word, value)) fail(expected, word);
  return value;
}

std::uint64_t WordScanner::count(std::string_view word, const char* expected,
                                 std::uint64_t limit) const {
  const std::int64_t value = integer(word, expected);
  if (value < 0 || static_cast<std::uint64_t>(value) >= limit) fail(expected, word);
  return static_cast<std::uint64_t>(value);
}

void WordScanner::fail(const std::string& expected, std::string_view found) const {
  if (found.empty()) {
    fail("expected " + expected + ", found the end of the " +
         (position_ >= text_.size() ? "file" : "line"));
  }
  fail("expected " + expected + ", found '" + printable(found) + "'");
}

void WordScanner::fail(const std::string& what) const {
  cannot_read(path_, "line " + std::to_string(line_) + ": " + what);
}

}  // namespace talweg::formats
