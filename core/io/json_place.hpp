// A JSON place is a value of a JSON file and its path in the file, for error messages.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "talweg/core/io/curve_formats.hpp"

namespace talweg::formats {

/// Parses JSON. Throws Error(kBadFile) naming line and column if the text is not JSON or nests
/// deeper than 64 levels. O(bytes) for flat lists. At the end of each object or list in a list the
/// parser looks at all previous elements of the list, which is quadratic in the points of a curve.
nlohmann::json parsed_json(const Source& source);

/// All accessors throw Error(kBadFile) naming the file and a place such as curves[2].points[0].
class JsonPlace {
 public:
  JsonPlace(const std::filesystem::path& path, const nlohmann::json& value, std::string name)
      : path_(&path), value_(&value), name_(std::move(name)) {}

  [[nodiscard]] bool has(const char* key) const {
    return value_->is_object() && value_->contains(key);
  }
  [[nodiscard]] bool is_array() const { return value_->is_array(); }
  [[nodiscard]] bool is_boolean() const { return value_->is_boolean(); }
  [[nodiscard]] bool is_number() const { return value_->is_number(); }
  /// A required member.
  [[nodiscard]] JsonPlace member(const char* key) const;
  /// An element of an array; k must be below size().
  [[nodiscard]] JsonPlace element(std::size_t k) const;
  /// The length of an array; anything else is an error.
  [[nodiscard]] std::size_t size() const;

  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::string string() const;
  /// A finite number.
  [[nodiscard]] double number() const;
  /// A whole number from 0 to 4294967294.
  [[nodiscard]] std::uint32_t index() const;
  /// Three finite numbers.
  [[nodiscard]] std::array<double, 3> triple() const;

  [[noreturn]] void fail(const std::string& what) const;

 private:
  const std::filesystem::path* path_;
  const nlohmann::json* value_;
  std::string name_;
};

/// The curves of a 3D Slicer markups file, given its root.
std::vector<CurveInput> read_slicer(const JsonPlace& root, const Source& source);
/// The points of the only markup of a 3D Slicer file, see read_clicks().
CurveInput read_slicer_clicks(const JsonPlace& root, const Source& source);

}  // namespace talweg::formats
