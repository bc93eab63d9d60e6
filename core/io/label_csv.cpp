// Labels as a column of a table, from spreadsheets and data frames.
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/label_formats.hpp"
#include "talweg/core/io/text_words.hpp"

namespace talweg::formats {
namespace {

constexpr std::string_view kNumberColumns[] = {
    "vertex",     "vertex_id", "vertex_index", "face",     "face_id",
    "face_index", "index",     "id",           "triangle", ""};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The cells of a line. A cell in quotes may contain the separator; the quotes are taken off.
std::vector<std::string> cells_of(std::string_view line, char separator) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == separator && !quoted) {
      cells.emplace_back();
    } else {
      cells.back().push_back(c);
    }
  }
  for (std::string& cell : cells) cell = std::string(trimmed(cell));
  return cells;
}

bool is_number(std::string_view cell) {
  double value = 0;
  return parse(cell, value);
}

class TableReader {
 public:
  TableReader(const Source& source, const std::string& property)
      : source_(source), lines_(source.path, source.bytes), property_(property) {}

  LabelFile read() {
    do {
      const std::string_view line = lines_.rest_of_line();
      if (!trimmed(line).empty() && trimmed(line).front() != '#') read_line(line);
    } while (lines_.next_line());
    if (columns_ == 0) fail("it has no lines");
    return ordered();
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void read_line(std::string_view line) {
    if (columns_ == 0) {
      if (line.find(';') != line.npos) separator_ = ';';
      if (line.find('\t') != line.npos) separator_ = '\t';
    }
    const std::vector<std::string> cells = cells_of(line, separator_);
    if (columns_ == 0) {
      columns_ = cells.size();
      if (!std::all_of(cells.begin(), cells.end(), is_number)) return choose_columns(cells);
      if (columns_ > 1) {
        lines_.fail("expected one column, or a header that names them, such as vertex,label");
      }
    }
    if (cells.size() != columns_) {
      lines_.fail(fmt::format("expected {} cells, found {}", columns_, cells.size()));
    }
    labels_.push_back(whole_number(lines_, cells[label_]));
    if (number_ != kNone) numbers_.push_back(whole_number(lines_, cells[number_]));
  }

  void choose_columns(const std::vector<std::string>& names) {
    const auto place = [&](std::string_view name) {
      const auto at = std::find(names.begin(), names.end(), name);
      return at == names.end() ? kNone : static_cast<std::size_t>(at - names.begin());
    };
    for (const std::string_view name : kNumberColumns) {
      if (number_ == kNone && (columns_ > 1 || !name.empty())) number_ = place(name);
    }
    const std::string usual = property_.empty() ? usual_name_among(names) : property_;
    label_ = usual.empty() ? kNone : place(usual);
    const bool one_other = columns_ == (number_ == kNone ? 1U : 2U);
    if (label_ == kNone && property_.empty() && one_other) label_ = number_ == 0 ? 1 : 0;
    if (label_ == kNone) {
      std::string all;
      for (const std::string& name : names) {
        if (all.size() < 100) all += (all.empty() ? "" : ", ") + printable(name);
      }
      fail(fmt::format("it has no column {}, but {}",
                       property_.empty() ? "label, labels, segment, region, class or scalar_label"
                                         : printable(property_),
                       all));
    }
    if (label_ == number_) number_ = kNone;
  }

  /// The labels in the order of the column of vertex or face numbers; in the order of the rows if
  /// there is no such column.
  LabelFile ordered() {
    LabelFile file;
    file.labels = labels_;
    if (number_ == kNone) return file;
    std::vector<bool> seen(labels_.size(), false);
    for (std::size_t k = 0; k < labels_.size(); ++k) {
      const std::int64_t n = numbers_[k];
      if (n < 0 || static_cast<std::size_t>(n) >= labels_.size()) {
        fail(fmt::format("row {} is for number {}, but there are {} rows, which are counted from 0",
                         k, n, labels_.size()));
      }
      if (seen[static_cast<std::size_t>(n)]) fail(fmt::format("number {} comes twice", n));
      seen[static_cast<std::size_t>(n)] = true;
      file.labels[static_cast<std::size_t>(n)] = labels_[k];
    }
    return file;
  }

  [[noreturn]] void fail(const std::string& what) const { cannot_read(source_.path, what); }

  const Source& source_;
  WordScanner lines_;
  const std::string& property_;
  char separator_ = ',';
  std::size_t columns_ = 0, label_ = 0, number_ = kNone;
  std::vector<std::int64_t> labels_, numbers_;
};

}  // namespace

LabelFile read_csv_labels(const Source& source, const std::string& property) {
  return TableReader(source, property).read();
}

}  // namespace talweg::formats
