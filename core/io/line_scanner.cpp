#include "talweg/core/io/line_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

#include <fmt/format.h>

#include "talweg/core/io/number_text.hpp"

namespace talweg {
namespace {

void skip_blanks(std::string_view& text) {
  std::size_t n = 0;
  while (n < text.size() && is_blank(text[n])) ++n;
  text.remove_prefix(n);
}

}  // namespace

std::string quoted(std::string_view word) {
  constexpr std::size_t kLongest = 24;
  return fmt::format("'{}'", printable(word, kLongest));
}

void LineScanner::take_line() {
  const std::string_view text = file_->bytes;
  const std::size_t end = std::min(text.find('\n', next_), text.size());
  rest_ = text.substr(next_, end - next_);
  next_ = std::min(end + 1, text.size());
  ++line_;
  if (comment_ != '\0') rest_ = rest_.substr(0, rest_.find(comment_));
}

bool LineScanner::next_line() {
  while (next_ < file_->bytes.size()) {
    take_line();
    skip_blanks(rest_);
    if (!rest_.empty()) return true;
  }
  rest_ = {};
  return false;
}

void LineScanner::need_line(const std::string& expected) {
  if (!next_line()) bad_file(file_->path, "the file ends where " + expected + " should follow.");
}

void LineScanner::join_next() {
  if (next_ < file_->bytes.size()) take_line();
}

std::string_view LineScanner::word() {
  skip_blanks(rest_);
  std::size_t n = 0;
  while (n < rest_.size() && !is_blank(rest_[n])) ++n;
  const std::string_view result = rest_.substr(0, n);
  rest_.remove_prefix(n);
  return result;
}

template <class Value>
bool LineScanner::take(Value& value) {
  skip_blanks(rest_);
  const char* const last = rest_.data() + rest_.size();
  const auto [end, error] = from_text(rest_.data(), last, value);
  if (error != std::errc() || (end != last && !is_blank(*end))) return false;
  rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
  return true;
}

double LineScanner::number(const char* what) {
  double value = 0;
  const std::string_view before = rest_;
  if (take(value) && std::isfinite(value)) return value;
  rest_ = before;
  return unusual_number(what);
}

double LineScanner::coordinate(std::string_view& odd) {
  double value = 0;
  const std::string_view before = rest_;
  if (take(value) && std::isfinite(value)) return value;
  rest_ = before;
  const std::string_view found = word();
  if (parse(found, value) && !std::isfinite(value)) {
    odd = found;
    return value;
  }
  rest_ = before;
  return unusual_number("a coordinate");
}

double LineScanner::unusual_number(const char* what) {
  const std::string_view found = word();
  double value = 0;
  if (found.empty()) fail("expected " + std::string(what) + ", found the end of the line.");
  if (!parse(found, value))
    fail("expected " + std::string(what) + ", found " + quoted(found) + ".");
  if (!std::isfinite(value)) {
    fail(std::string(what) + " is " + quoted(found) + ", which is not a finite number.");
  }
  return value;
}

std::int64_t LineScanner::integer(const char* what) {
  std::int64_t value = 0;
  if (take(value)) return value;
  const std::string_view found = word();
  if (found.empty()) fail("expected " + std::string(what) + ", found the end of the line.");
  if (!parse(found, value))
    fail("expected " + std::string(what) + ", found " + quoted(found) + ".");
  return value;
}

}  // namespace talweg
