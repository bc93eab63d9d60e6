#include "table_lines.hpp"

#include <utility>

#include <fmt/format.h>

#include "talweg/intrinsic/error.hpp"

namespace talweg::driver {

void bad_line(const std::string& path, std::size_t line, const std::string& what) {
  throw Error(ErrorCode::kBadFile, fmt::format("{}, line {}: {}", path, line, what));
}

std::vector<TableLine> table_lines(const std::string& path, std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::string_view first = text.substr(0, text.find('\n'));
  const char separator = first.find('\t') != std::string_view::npos ? '\t' : ',';
  std::vector<TableLine> lines;
  std::size_t at = 0, number = 1;
  while (at < text.size()) {
    TableLine line{number, {}};
    const bool comment = text[at] == '#';
    std::string cell;
    for (bool more = true; more;) {
      cell.clear();
      const bool quoted = !comment && at < text.size() && text[at] == '"';
      if (quoted) {
        for (++at;; ++at) {
          if (at >= text.size()) bad_line(path, line.line, "a quote is not closed.");
          if (text[at] == '\n') ++number;
          if (text[at] != '"') {
            cell += text[at];
          } else if (at + 1 < text.size() && text[at + 1] == '"') {
            cell += text[at++];
          } else {
            ++at;
            break;
          }
        }
      }
      const std::size_t rest = at;
      while (at < text.size() && text[at] != '\n' && (comment || text[at] != separator)) ++at;
      std::string_view plain = text.substr(rest, at - rest);
      if (plain.ends_with('\r')) plain.remove_suffix(1);
      if (quoted && !plain.empty()) bad_line(path, number, "a cell goes on after its quotes.");
      if (!quoted) cell = plain;
      line.cells.push_back(cell);
      more = at < text.size() && text[at] == separator;
      if (at < text.size()) ++at;
    }
    ++number;
    const bool blank = line.cells.size() == 1 && line.cells[0].empty();
    if (!comment && !blank) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace talweg::driver
