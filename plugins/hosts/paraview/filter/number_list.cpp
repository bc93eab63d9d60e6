#include "number_list.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "talweg/plugin/talweg_plugin.h"

namespace talweg::paraview {
namespace {

std::vector<std::string_view> words_of(std::string_view text) {
  constexpr std::string_view kBetween = " ,;\t\n\r";
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(kBetween); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBetween, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(kBetween, end);
  }
  return words;
}

/// False if the word is not a number, or has letters after the number.
template <class Number>
bool parse(std::string_view word, Number& number) {
  const char* end = word.data() + word.size();
  const auto parsed = std::from_chars(word.data(), end, number);
  return parsed.ec == std::errc{} && parsed.ptr == end;
}

[[noreturn]] void refuse(std::string_view word, std::string_view what, const char* wanted) {
  throw std::runtime_error(std::string(what) + ": '" + std::string(word) + "' is not a " + wanted +
                           ".");
}

}  // namespace

std::vector<std::uint32_t> vertex_numbers(const std::string& text, std::string_view what) {
  std::vector<std::uint32_t> result;
  for (const std::string_view word : words_of(text)) {
    std::uint32_t number = 0;
    if (!parse(word, number) || number == TALWEG_NO_VERTEX) refuse(word, what, "vertex number");
    result.push_back(number);
  }
  return result;
}

std::vector<double> numbers(const std::string& text, std::string_view what) {
  std::vector<double> result;
  for (const std::string_view word : words_of(text)) {
    double number = 0;
    if (!parse(word, number)) refuse(word, what, "number");
    result.push_back(number);
  }
  return result;
}

}  // namespace talweg::paraview
