#include "report_json.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace talweg::browser {
namespace {

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json number_of(const host::ReportEntry& entry, double value) {
  if (entry.type == TALWEG_VALUE_BOOLEAN) return value != 0;
  if (entry.type == TALWEG_VALUE_INTEGER) return static_cast<std::int64_t>(value);
  return finite(value);
}

Json value_of(const host::ReportEntry& entry) {
  Json values = Json::array();
  for (const double value : entry.numbers) values.push_back(number_of(entry, value));
  for (const std::string& text : entry.texts) values.push_back(text);
  if (entry.is_list) return values;
  return values.empty() ? Json(nullptr) : values.front();
}

/// The entries of a curve as an object; `time_ms.load` is the member `load` of the group `time_ms`.
Json group_of(const host::Results& results, std::int64_t curve) {
  Json group = Json::object();
  for (const host::ReportEntry& entry : results.report) {
    if (entry.curve != curve) continue;
    std::string path = "/" + entry.key;
    std::replace(path.begin(), path.end(), '.', '/');
    group[Json::json_pointer(path)] = value_of(entry);
  }
  return group;
}

}  // namespace

Json report_json(const host::Results& results) {
  Json report = group_of(results, -1);
  const std::size_t curves = results.curves.size();
  for (std::size_t c = 0; curves > 1 && c < curves; ++c) {
    report["curves"].push_back(group_of(results, static_cast<std::int64_t>(c)));
  }
  return report;
}

Json number_or_null(const host::Results& results, const char* key, std::int64_t curve) {
  return finite(results.number(key, curve, std::nan("")));
}

}  // namespace talweg::browser
