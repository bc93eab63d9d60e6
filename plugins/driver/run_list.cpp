#include "run_list.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/args.h>
#include <fmt/format.h>

#include "commands.hpp"
#include "file_plan.hpp"
#include "run_journal.hpp"
#include "suggestion.hpp"
#include "table_lines.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {
namespace {

namespace fs = std::filesystem;

/// A line of the table while its run is being built.
struct Line {
  const std::string& path;
  std::size_t number;
  const std::vector<std::string>& columns;
  const std::vector<std::string>& cells;

  [[noreturn]] void fail(const std::string& what) const { bad_line(path, number, what); }
  [[nodiscard]] std::string cell(const std::string& column) const {
    const auto at = std::find(columns.begin(), columns.end(), column);
    return at == columns.end() ? "" : cells[static_cast<std::size_t>(at - columns.begin())];
  }
};

/// The file's name without folder and ending.
std::string stem(const std::string& path) {
  std::string name = fs::path(path).stem().string();
  constexpr std::string_view kSlicer = ".mrk";
  if (name.size() > kSlicer.size() && name.ends_with(kSlicer)) {
    name.resize(name.size() - kSlicer.size());
  }
  return name;
}

std::string option_of(std::string column) {
  std::replace(column.begin(), column.end(), '_', '-');
  return "--" + column;
}

/// The base options, overridden by the line's cells.
SmoothOptions with_cells(const SmoothOptions& base, const Line& line) {
  SmoothOptions run = base;
  CLI::App app;
  app.set_help_flag();
  add_smooth_options(app, run);
  std::vector<std::string> arguments;
  for (std::size_t c = 0; c < line.columns.size(); ++c) {
    const std::string& column = line.columns[c];
    const std::string& cell = line.cells[c];
    if (cell.empty()) continue;
    if (column == "mesh") {
      run.mesh = cell;
    } else if (app.get_option_no_throw(option_of(column)) != nullptr) {
      arguments.push_back(option_of(column) + "=" + cell);
    }
    if (column == "tau") run.max_deviation.reset();
    if (column == "curve") run.labels.clear();
    if (column == "labels") run.curves.clear();
  }
  try {
    check_values(app, arguments);
    std::reverse(arguments.begin(), arguments.end());
    app.parse(arguments);
    check_method(run);
  } catch (const CLI::ParseError& error) {
    line.fail(error.what());
  } catch (const Error& error) {
    line.fail(error.what());
  }
  if (run.mesh.empty()) line.fail("no mesh is given.");
  if (run.curves.empty() && run.labels.empty()) line.fail("no curve is given.");
  return run;
}

std::string filled(const std::string& pattern, const Line& line, const SmoothOptions& run) {
  fmt::dynamic_format_arg_store<fmt::format_context> values;
  const std::string folder = fs::path(run.mesh).parent_path().string();
  std::map<std::string, std::string> named = {
      {"mesh", stem(run.mesh)},
      {"curve", stem(run.curves.empty() ? run.labels : run.curves.front())},
      {"folder", folder.empty() ? "." : folder}};
  for (std::size_t c = 0; c < line.columns.size(); ++c) {
    named.emplace(line.columns[c], line.cells[c]);
  }
  for (const auto& [name, value] : named) values.push_back(fmt::arg(name.c_str(), value));
  try {
    return fmt::vformat(pattern, values);
  } catch (const fmt::format_error&) {
    std::string known;
    for (const auto& [name, value] : named) known += (known.empty() ? "{" : ", {") + name + "}";
    line.fail(fmt::format("the name \"{}\" may contain only {} in braces.", pattern, known));
  }
}

/// Throws an error for columns without a use, which are misspelt or meant for something else.
void check_columns(const std::string& path, const TableLine& header, const SmoothOptions& base) {
  SmoothOptions unused;
  CLI::App app;
  app.set_help_flag();
  add_smooth_options(app, unused);
  std::string patterns = base.report;
  for (const std::string& output : base.outputs) patterns += "|" + output;
  std::vector<std::string> columns = {"mesh"};
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) columns.push_back(name);
  }
  std::set<std::string> known;
  for (const std::string& column : header.cells) {
    if (column.empty()) bad_line(path, header.line, "a column has no name.");
    if (!known.insert(option_of(column)).second) {
      bad_line(path, header.line, fmt::format("there are two columns \"{}\".", column));
    }
    if (column == "mesh" || app.get_option_no_throw(option_of(column)) != nullptr) continue;
    if (patterns.find("{" + column + "}") == std::string::npos) {
      const std::string meant = suggestion(option_of(column), columns);
      bad_line(path, header.line,
               fmt::format("the column \"{}\" is not an option of smooth, and no output is named "
                           "by it{}",
                           column, meant.empty() ? "." : meant));
    }
  }
}

}  // namespace

void check_files(const std::vector<ListedRun>& runs, const std::string& list,
                 const std::string& summary) {
  FilePlan files;
  files.makes_folders();
  files.reads("--batch", list);
  files.writes("--summary", summary);
  files.writes("--summary", journal_of(summary));
  for (const ListedRun& run : runs) {
    if (run.line > 0) files.at(list, fmt::format("line {}", run.line));
    plan_files(run.options, files);
  }
  files.check();
}

std::vector<ListedRun> read_run_list(const std::string& path, const SmoothOptions& base,
                                     const std::string& summary) {
  const std::vector<TableLine> lines = table_lines(path, read_file(path));
  if (lines.size() < 2) {
    throw Error(ErrorCode::kBadFile, path +
                                         ": expected a line with the names of columns and at "
                                         "least one run below it.");
  }
  check_columns(path, lines.front(), base);
  std::vector<ListedRun> runs;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const Line line{path, lines[i].line, lines.front().cells, lines[i].cells};
    if (line.cells.size() != line.columns.size()) {
      line.fail(fmt::format("{} cells under {} columns.", line.cells.size(), line.columns.size()));
    }
    ListedRun run{line.number, with_cells(base, line)};
    for (std::string& output : run.options.outputs) output = filled(output, line, run.options);
    if (!run.options.report.empty()) {
      run.options.report = filled(run.options.report, line, run.options);
    }
    if (run.options.outputs.empty() && run.options.report.empty() && summary.empty()) {
      line.fail("nothing would be written: give -o, --report or --summary.");
    }
    runs.push_back(std::move(run));
  }
  check_files(runs, path, summary);
  return runs;
}

}  // namespace talweg::driver
