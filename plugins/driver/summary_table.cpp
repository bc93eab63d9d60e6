#include "summary_table.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace talweg::driver {
namespace {

using nlohmann::ordered_json;

std::string as_cell(std::string_view cell) {
  if (cell.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(cell);
  std::string text = "\"";
  for (const char c : cell) {
    if (c == '"') text += '"';
    text += c;
  }
  return text + '"';
}

std::string cell_of(const ordered_json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return as_cell(value.get<std::string>());
  return value.dump();
}

/// The names and cells of a report, in its order.
std::vector<std::pair<std::string, std::string>> cells_of(const SmoothingReport& report) {
  std::vector<std::pair<std::string, std::string>> cells;
  const ordered_json object = ordered_json::parse(to_json(report));
  for (const auto& [name, value] : object.items()) {
    if (name == "time_ms" || name == "peak_memory_mib" || name == "termination") continue;
    if (name == "warnings") {
      cells.emplace_back(name, as_cell(fmt::format("{}", fmt::join(report.warnings, " "))));
    } else if (value.is_array()) {
      for (std::size_t k = 0; k < value.size(); ++k) {
        cells.emplace_back(name + "_" + "xyz"[k], cell_of(value[k]));
      }
    } else {
      cells.emplace_back(name, cell_of(value));
    }
  }
  return cells;
}

std::string start_of(const SummaryTable::Place& place) {
  return (place.line > 0 ? std::to_string(place.line) : "") + "," + as_cell(place.mesh) + "," +
         as_cell(place.curve) + ",";
}

}  // namespace

SummaryTable::SummaryTable() : text_("line,mesh,curve,number,status,message") {
  for (const auto& [name, cell] : cells_of({})) {
    text_ += "," + name;
    ++columns_;
  }
  text_ += "\n";
}

void SummaryTable::add(const Place& place, std::size_t number, const SmoothingReport& report) {
  text_ += start_of(place) + std::to_string(number) + "," + to_string(report.termination) + ",";
  for (const auto& [name, cell] : cells_of(report)) text_ += "," + cell;
  text_ += "\n";
}

void SummaryTable::add(const Place& place, const std::string& number, std::string_view status,
                       std::string_view message) {
  text_ += start_of(place) + number + "," + std::string(status) + "," + as_cell(message) +
           std::string(columns_, ',') + "\n";
}

}  // namespace talweg::driver
