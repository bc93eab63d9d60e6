#include "talweg/core/io/json_place.hpp"

#include <cmath>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/word_scanner.hpp"

namespace talweg::formats {

using nlohmann::json;

namespace {

/// Throws if the text nests too deep. The parser's callback is not an alternative: with a callback
/// the parser looks at all elements of an array after each element.
void check_depth(const Source& source) {
  constexpr int kDeepest = 64;
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < source.bytes.size(); ++i) {
    const char c = source.bytes[i];
    if (c == '"') in_string = !in_string;
    if (in_string) {
      if (c == '\\') ++i;
    } else if (c == '[' || c == '{') {
      if (++depth > kDeepest) cannot_read(source.path, "its JSON nests deeper than 64 levels");
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
}

}  // namespace

json parsed_json(const Source& source) {
  check_depth(source);
  try {
    return json::parse(source.bytes);
  } catch (const json::parse_error& error) {
    const std::size_t at = error.byte > 0 ? error.byte - 1 : 0;
    const std::size_t line = line_of(source.bytes, at);
    const std::size_t start = source.bytes.substr(0, at).rfind('\n');
    const std::size_t column = at - (start == std::string_view::npos ? 0 : start + 1) + 1;
    cannot_read(source.path, "line " + std::to_string(line) + ", column " + std::to_string(column) +
                                 ": it is not valid JSON" +
                                 (at >= source.bytes.size() ? " (it ends too early)" : ""));
  } catch (const json::exception&) {
    cannot_read(source.path, "it has a number that is too large for JSON readers");
  }
}

JsonPlace JsonPlace::member(const char* key) const {
  const std::string name = name_.empty() ? key : name_ + "." + key;
  if (!value_->is_object()) fail("expected an object with '" + std::string(key) + "'");
  const auto found = value_->find(key);
  if (found == value_->end()) fail("'" + std::string(key) + "' is missing");
  return {*path_, *found, name};
}

JsonPlace JsonPlace::element(std::size_t k) const {
  return {*path_, (*value_)[k], name_ + "[" + std::to_string(k) + "]"};
}

std::size_t JsonPlace::size() const {
  if (!value_->is_array()) fail("expected an array");
  return value_->size();
}

bool JsonPlace::boolean() const {
  if (!value_->is_boolean()) fail("expected true or false");
  return value_->get<bool>();
}

std::string JsonPlace::string() const {
  if (!value_->is_string()) fail("expected a string");
  return value_->get<std::string>();
}

double JsonPlace::number() const {
  if (!value_->is_number()) fail("expected a number");
  const auto value = value_->get<double>();
  if (!std::isfinite(value)) fail("expected a finite number");
  return value;
}

std::uint32_t JsonPlace::index() const {
  if (!value_->is_number_unsigned() || value_->get<std::uint64_t>() >= VertexId::kInvalid) {
    fail("expected a whole number from 0 to 4294967294");
  }
  return value_->get<std::uint32_t>();
}

std::array<double, 3> JsonPlace::triple() const {
  if (size() != 3) fail("expected three numbers");
  return {element(0).number(), element(1).number(), element(2).number()};
}

void JsonPlace::fail(const std::string& what) const {
  cannot_read(*path_, (name_.empty() ? "at the top level" : name_) + ": " + what);
}

}  // namespace talweg::formats
