#include "summary_table.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace talweg::driver {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kBefore = 6, kAfter = 3;  // columns that are no report's

std::string as_cell(std::string_view cell) {
  if (cell.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(cell);
  std::string text = "\"";
  for (const char c : cell) {
    if (c == '"') text += '"';
    text += c;
  }
  return text + '"';
}

std::string line_of(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells)
    line += (&cell == &cells.front() ? "" : ",") + as_cell(cell);
  return line + "\n";
}

std::string cell_of(const ordered_json& value) {
  if (value.is_null()) return {};
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// The names and cells of a report, in its order.
std::vector<std::pair<std::string, std::string>> cells_of(const SmoothingReport& report) {
  std::vector<std::pair<std::string, std::string>> cells;
  const ordered_json object = ordered_json::parse(to_json(report));
  for (const auto& [name, value] : object.items()) {
    if (name == "time_ms" || name == "peak_memory_mib" || name == "termination") continue;
    if (name == "warnings") {
      cells.emplace_back(name, fmt::format("{}", fmt::join(report.warnings, " ")));
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

}  // namespace

SummaryRow row_of(std::size_t number, const SmoothingReport& report) {
  SummaryRow row{std::to_string(number), to_string(report.termination), {}, {}};
  for (auto& [name, cell] : cells_of(report)) row.cells.push_back(std::move(cell));
  return row;
}

std::vector<std::string> summary_columns() {
  std::vector<std::string> columns = {"line", "mesh", "curve", "number", "status", "message"};
  for (auto& [name, cell] : cells_of({})) columns.push_back(std::move(name));
  for (const char* name : {"curves", "inputs", "outputs"}) columns.emplace_back(name);
  return columns;
}

std::string summary_header() { return line_of(summary_columns()); }

std::string summary_lines(const SummaryRun& run) {
  static const std::size_t kReport = summary_columns().size() - kBefore - kAfter;
  std::string lines;
  for (const SummaryRow& row : run.rows) {
    std::vector<std::string> cells = {run.line > 0 ? std::to_string(run.line) : "",
                                      run.mesh,
                                      run.curve,
                                      row.number,
                                      row.status,
                                      row.message};
    cells.insert(cells.end(), row.cells.begin(), row.cells.end());
    cells.resize(kBefore + kReport);
    for (const auto& cell : {std::to_string(run.rows.size()), run.inputs, run.outputs}) {
      cells.push_back(cell);
    }
    lines += line_of(cells);
  }
  return lines;
}

std::vector<SummaryRun> runs_of(const std::vector<std::vector<std::string>>& lines) {
  std::vector<SummaryRun> runs;
  const std::size_t columns = summary_columns().size();
  std::string place, count;  // of the last run
  const auto drop_incomplete = [&] {
    if (!runs.empty() && std::to_string(runs.back().rows.size()) != count) runs.pop_back();
  };
  for (const std::vector<std::string>& cells : lines) {
    if (cells.size() != columns) continue;
    const std::string its_place = cells[0] + '\n' + cells[1] + '\n' + cells[2];
    if (runs.empty() || its_place != place || std::to_string(runs.back().rows.size()) == count) {
      drop_incomplete();
      place = its_place;
      count = cells[columns - kAfter];
      SummaryRun run{0, cells[1], cells[2], {}, cells[columns - 2], cells[columns - 1]};
      std::from_chars(cells[0].data(), cells[0].data() + cells[0].size(), run.line);
      runs.push_back(std::move(run));
    }
    const auto at = [&](std::size_t c) { return cells.begin() + static_cast<std::ptrdiff_t>(c); };
    runs.back().rows.push_back({cells[3], cells[4], cells[5], {at(kBefore), at(columns - kAfter)}});
  }
  drop_incomplete();
  return runs;
}

}  // namespace talweg::driver
