#include "talweg/core/measure/report_entry.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include <nlohmann/json.hpp>

#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

using Json = nlohmann::ordered_json;

/// Converts a value to JSON; numbers that are not finite become null.
struct AsJson {
  Json operator()(double value) const { return std::isfinite(value) ? Json(value) : Json(nullptr); }
  Json operator()(const std::vector<double>& list) const {
    Json values = Json::array();
    for (const double value : list) values.push_back((*this)(value));
    return values;
  }
  template <class Value>
  Json operator()(const Value& value) const {
    return value;
  }
};

/// JSON must be UTF-8, but a message may contain a file name that is not; invalid bytes are
/// replaced.
std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Whether a part of a key is the index of an element of an array, or of its next element.
bool is_index(const Json& group, const std::string& part) {
  constexpr std::size_t kDigits = 9;
  if (!group.is_array() && !group.is_null()) return false;
  if (part.empty() || part.size() > kDigits || (part.front() == '0' && part.size() > 1) ||
      part.find_first_not_of("0123456789") != std::string::npos) {
    return false;
  }
  return std::stoul(part) <= group.size();
}

/// The member of a group; made if missing.
Json& member(Json& group, const std::string& part, const std::string& key) {
  if (is_index(group, part)) return group[static_cast<std::size_t>(std::stoul(part))];
  if (group.is_object() || group.is_null()) return group[part];
  throw Error(ErrorCode::kBadUsage,
              "The report's entry \"" + key + "\" does not fit the entries before it.");
}

Json object_of(const std::vector<ReportEntry>& entries) {
  Json object = Json::object();
  for (const ReportEntry& entry : entries) {
    Json* place = &object;
    std::size_t begin = 0;
    for (std::size_t dot = entry.key.find('.'); dot != std::string::npos;
         dot = entry.key.find('.', begin)) {
      place = &member(*place, entry.key.substr(begin, dot - begin), entry.key);
      begin = dot + 1;
    }
    member(*place, entry.key.substr(begin), entry.key) = std::visit(AsJson{}, entry.value);
  }
  return object;
}

}  // namespace

void append(std::vector<ReportEntry>& entries, std::string_view prefix,
            std::vector<ReportEntry> more) {
  for (ReportEntry& entry : more) {
    entry.key.insert(0, prefix);
    entries.push_back(std::move(entry));
  }
}

std::string to_json(const std::vector<ReportEntry>& total,
                    const std::vector<std::vector<ReportEntry>>& curves) {
  Json j = object_of(total);
  if (curves.size() > 1) {
    Json& list = j["curves"] = Json::array();
    for (const std::vector<ReportEntry>& entries : curves) list.push_back(object_of(entries));
  }
  return text_of(j);
}

}  // namespace talweg
