#include "summary_table.hpp"

#include <array>
#include <charconv>
#include <cstddef>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace talweg::driver {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kBefore = 6, kAfter = 3;  // columns before and after those of the report

std::string as_cell(std::string_view cell) {
  if (cell.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(cell);
  std::string text = "\"";
  for (const char c : cell) {
    if (c == '"') text += '"';
    text += c;
  }
  return text + '"';
}

std::string joined(std::span<const std::string> cells) {
  std::string text;
  for (const std::string& cell : cells) {
    text += (&cell == &cells.front() ? "" : ",") + as_cell(cell);
  }
  return text;
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
    if (name == "decisive_at") continue;  // would need a column per warning
    if (name == "warnings" || name == "decisive") {
      cells.emplace_back(name,
                         fmt::format("{}", fmt::join(value.get<std::vector<std::string>>(), " ")));
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
  std::vector<std::string> cells;
  for (auto& [name, cell] : cells_of(report)) cells.push_back(std::move(cell));
  return {std::to_string(number), to_string(report.termination), {}, joined(cells)};
}

std::vector<std::string> summary_columns() {
  std::vector<std::string> columns = {"line", "mesh", "curve", "number", "status", "message"};
  for (auto& [name, cell] : cells_of({})) columns.push_back(std::move(name));
  for (const char* name : {"curves", "inputs", "outputs"}) columns.emplace_back(name);
  return columns;
}

std::string summary_header() { return joined(summary_columns()) + "\n"; }

std::string summary_lines(const SummaryRun& run) {
  static const std::string kNone(summary_columns().size() - kBefore - kAfter - 1, ',');
  const std::string line = run.line > 0 ? std::to_string(run.line) : "";
  std::string lines;
  for (const SummaryRow& row : run.rows) {
    const std::array place = {line, run.mesh, run.curve, row.number, row.status, row.message};
    const std::array stamps = {std::to_string(run.rows.size()), run.inputs, run.outputs};
    const std::string& cells = row.cells.empty() ? kNone : row.cells;
    lines += joined(place) + "," + cells + "," + joined(stamps) + "\n";
  }
  return lines;
}

std::vector<SummaryRun> runs_of(const std::vector<std::vector<std::string>>& lines) {
  std::vector<SummaryRun> runs;
  const std::size_t columns = summary_columns().size();
  std::string place, count;  // cells of the last run
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
    const std::span report = std::span(cells).subspan(kBefore, columns - kBefore - kAfter);
    const bool none = report.front().empty();
    runs.back().rows.push_back({cells[3], cells[4], cells[5], none ? "" : joined(report)});
  }
  drop_incomplete();
  return runs;
}

}  // namespace talweg::driver
