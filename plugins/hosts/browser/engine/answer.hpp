// An answer to a call of the page: JSON, and arrays of numbers beside it, which JavaScript reads
// directly from memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace talweg::browser {

using Json = nlohmann::ordered_json;

/// In the order of `kinds` in module.ts.
enum class NumberKind : std::uint32_t { kFloat64, kFloat32, kUint32, kInt32, kUint8 };

struct OutArray {
  NumberKind kind;
  std::size_t count;
  const void* data;
  std::shared_ptr<const void> kept;
};

class Answer {
 public:
  Json json = Json::object();

  /// Keeps the numbers; returns the JSON value that refers to them.
  template <class Number>
  Json array(std::vector<Number> values) {
    auto kept = std::make_shared<const std::vector<Number>>(std::move(values));
    arrays_.push_back({kind_of<Number>(), kept->size(), kept->data(), kept});
    return Json{{"$array", arrays_.size() - 1}};
  }
  [[nodiscard]] const std::vector<OutArray>& arrays() const { return arrays_; }

 private:
  template <class Number>
  static constexpr NumberKind kind_of() {
    if constexpr (std::is_same_v<Number, double>) return NumberKind::kFloat64;
    if constexpr (std::is_same_v<Number, float>) return NumberKind::kFloat32;
    if constexpr (std::is_same_v<Number, std::uint32_t>) return NumberKind::kUint32;
    if constexpr (std::is_same_v<Number, std::int32_t>) return NumberKind::kInt32;
    return NumberKind::kUint8;
  }

  std::vector<OutArray> arrays_;
};

}  // namespace talweg::browser
