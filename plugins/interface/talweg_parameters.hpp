// For authors of plugins: descriptions of parameters, and the values that the host sets.
#pragma once

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "talweg_arrays.hpp"

namespace talweg::plugin {

/// The range of a number; a slider should span the soft range.
struct Range {
  double minimum = -HUGE_VAL;
  double maximum = HUGE_VAL;
  double soft_minimum = 0;
  double soft_maximum = 1;
};

inline talweg_parameter number(const char* id, const char* label, const char* unit, double value,
                               const Range& range, const char* doc,
                               std::uint32_t stage = TALWEG_STAGE_RUN, std::uint32_t flags = 0) {
  return {sizeof(talweg_parameter),
          TALWEG_NUMBER,
          stage,
          flags,
          id,
          label,
          unit,
          doc,
          value,
          range.minimum,
          range.maximum,
          range.soft_minimum,
          range.soft_maximum,
          nullptr,
          0,
          nullptr,
          nullptr};
}

inline talweg_parameter integer(const char* id, const char* label, double value, const Range& range,
                                const char* doc, std::uint32_t stage = TALWEG_STAGE_RUN,
                                std::uint32_t flags = 0) {
  talweg_parameter result = number(id, label, "", value, range, doc, stage, flags);
  result.type = TALWEG_INTEGER;
  return result;
}

inline talweg_parameter boolean(const char* id, const char* label, bool value, const char* doc,
                                std::uint32_t stage = TALWEG_STAGE_RUN, std::uint32_t flags = 0) {
  talweg_parameter result = number(id, label, "", value ? 1 : 0, {0, 1, 0, 1}, doc, stage, flags);
  result.type = TALWEG_BOOLEAN;
  return result;
}

/// `ids` and `labels` are arrays that must stay valid.
template <std::size_t n>
talweg_parameter choice(const char* id, const char* label, const char* value,
                        const char* const (&ids)[n], const char* const (&labels)[n],
                        const char* doc, std::uint32_t stage = TALWEG_STAGE_RUN,
                        std::uint32_t flags = 0) {
  talweg_parameter result = number(id, label, "", 0, {0, 0, 0, 0}, doc, stage, flags);
  result.type = TALWEG_CHOICE;
  result.default_choice = value;
  result.choice_count = n;
  result.choices = ids;
  result.choice_labels = labels;
  return result;
}

/// A parameter of type TALWEG_VERTICES, TALWEG_FIELD, TALWEG_PER_CURVE or TALWEG_TRIANGLE_FIELD.
inline talweg_parameter array(std::uint32_t type, const char* id, const char* label,
                              const char* unit, const char* doc,
                              std::uint32_t stage = TALWEG_STAGE_RUN, std::uint32_t flags = 0) {
  talweg_parameter result = number(id, label, unit, 0, {0, 0, 0, 0}, doc, stage, flags);
  result.type = type;
  return result;
}

/// The values of a plugin's parameters, checked against their descriptions.
class Parameters {
 public:
  /// The descriptions must outlive the object.
  explicit Parameters(std::span<const talweg_parameter> descriptions) {
    for (const talweg_parameter& description : descriptions) {
      values_.push_back({&description, {}, {}, {}, {}, 0});
      values_.back().to_default();
    }
  }

  // For the plugin; the id must be one of the plugin's parameters.
  [[nodiscard]] double number(const char* id) const { return at(id).number.value_or(0); }
  [[nodiscard]] std::optional<double> optional(const char* id) const { return at(id).number; }
  [[nodiscard]] bool flag(const char* id) const { return number(id) != 0; }
  [[nodiscard]] const std::string& choice(const char* id) const { return at(id).choice; }
  [[nodiscard]] const std::vector<std::uint32_t>& vertices(const char* id) const {
    return at(id).vertices;
  }
  /// Empty if the host has set no array.
  [[nodiscard]] const std::vector<double>& field(const char* id) const { return at(id).field; }
  /// How often the parameter's value has changed.
  [[nodiscard]] std::uint64_t changes(const char* id) const { return at(id).changes; }
  /// How often any parameter of a stage has changed.
  [[nodiscard]] std::uint64_t changes_of(std::uint32_t stage) const {
    std::uint64_t sum = 0;
    for (const Value& value : values_) {
      if (value.description->stage == stage) sum += value.changes;
    }
    return sum;
  }

  // For the host. If a function throws Failure(TALWEG_BAD_USAGE), it has changed nothing.
  void set_number(const char* id, double value) {
    Value& parameter = find(id);
    check_number(*parameter.description, value);
    change(parameter, parameter.number, std::optional<double>(value));
  }
  void set_choice(const char* id, const char* value) {
    Value& parameter = find(id);
    const talweg_parameter& p = *parameter.description;
    if (p.type != TALWEG_CHOICE) bad(name_of(p) + " is not a choice.");
    if (value == nullptr) bad(name_of(p) + " is set to null.");
    std::string known;
    for (std::uint32_t k = 0; k < p.choice_count; ++k) {
      if (std::strcmp(value, p.choices[k]) == 0) {
        return change(parameter, parameter.choice, std::string(value));
      }
      known.append(k > 0 ? ", " : "").append(p.choices[k]);
    }
    bad(name_of(p) + " must be one of " + known + ", not \"" + std::string(value, 0, 40) + "\".");
  }
  void set_array(const char* id, const talweg_array* values) {
    Value& parameter = find(id);
    const talweg_parameter& p = *parameter.description;
    if (values == nullptr) bad(name_of(p) + " is set to null.");
    if (p.type == TALWEG_VERTICES) {
      change(parameter, parameter.vertices, indices_of(*values, 1, p.id));
    } else if (p.type == TALWEG_FIELD || p.type == TALWEG_PER_CURVE ||
               p.type == TALWEG_TRIANGLE_FIELD) {
      change(parameter, parameter.field, numbers_of(*values, 1, p.id));
    } else {
      bad(name_of(p) + " is not an array.");
    }
  }
  void reset(const char* id) {
    Value& parameter = find(id);
    Value default_value = parameter;
    default_value.to_default();
    if (parameter.is_set_as(default_value)) return;
    parameter = std::move(default_value);
    ++parameter.changes;
  }

 private:
  struct Value {
    const talweg_parameter* description;
    std::optional<double> number;
    std::string choice;
    std::vector<std::uint32_t> vertices;
    std::vector<double> field;
    std::uint64_t changes = 0;

    [[nodiscard]] bool is_set_as(const Value& other) const {
      return number == other.number && choice == other.choice && vertices == other.vertices &&
             field == other.field;
    }
    void to_default() {
      number.reset();
      if ((description->flags & TALWEG_OPTIONAL) == 0) number = description->default_number;
      choice = description->default_choice == nullptr ? "" : description->default_choice;
      vertices.clear();
      field.clear();
    }
  };

  [[noreturn]] static void bad(const std::string& message) {
    throw Failure(TALWEG_BAD_USAGE, message);
  }
  /// The label with the id: "Largest deviation (max_deviation)".
  static std::string name_of(const talweg_parameter& p) {
    return std::string(p.label) + " (" + p.id + ")";
  }
  static std::string shown(double value) {
    std::string text = std::to_string(value);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
  }
  static void check_number(const talweg_parameter& p, double value) {
    const std::string id = name_of(p);
    if (p.type != TALWEG_NUMBER && p.type != TALWEG_INTEGER && p.type != TALWEG_BOOLEAN) {
      bad(id + " is not a number.");
    }
    if (!std::isfinite(value)) bad(id + " must be a finite number.");
    if (p.type == TALWEG_BOOLEAN && value != 0 && value != 1) bad(id + " must be 0 or 1.");
    if (p.type == TALWEG_INTEGER && value != std::floor(value))
      bad(id + " must be a whole number.");
    const bool open = (p.flags & TALWEG_OPEN_MINIMUM) != 0;
    if (value < p.minimum || (open && value == p.minimum)) {
      bad(id + " must be " + (open ? "> " : ">= ") + shown(p.minimum) + ", not " + shown(value) +
          ".");
    }
    if (value > p.maximum)
      bad(id + " must be <= " + shown(p.maximum) + ", not " + shown(value) + ".");
  }

  template <class Member>
  void change(Value& parameter, Member& member, Member value) {
    if (member == value) return;
    member = std::move(value);
    ++parameter.changes;
  }
  Value& find(const char* id) {
    if (id == nullptr) bad("The parameter's id is null.");
    for (Value& value : values_) {
      if (std::strcmp(value.description->id, id) == 0) return value;
    }
    bad("There is no parameter \"" + std::string(id).substr(0, 40) + "\".");
  }
  [[nodiscard]] const Value& at(const char* id) const {
    return const_cast<Parameters*>(this)->find(id);
  }

  std::vector<Value> values_;
};

}  // namespace talweg::plugin
