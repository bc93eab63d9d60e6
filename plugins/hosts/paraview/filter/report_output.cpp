#include "report_output.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

namespace talweg::paraview {
namespace {

/// The key without indices of groups: parts.faces for parts.0.faces.
std::string without_places(const std::string& key) {
  std::string result;
  for (std::size_t at = 0; at < key.size();) {
    const std::size_t end = std::min(key.find('.', at), key.size());
    const bool is_place = std::isdigit(static_cast<unsigned char>(key[at])) != 0;
    if (!is_place) result.append(result.empty() ? "" : ".").append(key, at, end - at);
    at = end + 1;
  }
  return result;
}

bool is_one_number(const host::ReportEntry& entry) {
  return entry.type != TALWEG_VALUE_TEXT && !entry.is_list && entry.numbers.size() == 1;
}

/// How a column of the table stores an entry.
enum class Kind { kNone, kNumber, kPlace, kText };

Kind kind_of(const host::ReportEntry& entry) {
  if (without_places(entry.key) != entry.key) return Kind::kNone;  // an entry of a list of groups
  if (is_one_number(entry)) return Kind::kNumber;
  if (entry.type == TALWEG_VALUE_TEXT) return entry.is_list ? Kind::kNone : Kind::kText;
  return entry.numbers.size() == 3 ? Kind::kPlace : Kind::kNone;
}

/// Whether the entry is about the program or the mesh, or repeats the first column.
bool is_of_no_curve(const host::ReportEntry& entry) {
  const auto& keys = {"version", "faces", "vertices", "curve"};
  return std::find(keys.begin(), keys.end(), entry.key) != keys.end();
}

vtkSmartPointer<vtkAbstractArray> column_for(const host::ReportEntry& entry, vtkIdType rows) {
  vtkSmartPointer<vtkAbstractArray> column;
  if (kind_of(entry) == Kind::kText) {
    column = vtkSmartPointer<vtkStringArray>::New();
  } else {
    column = vtkSmartPointer<vtkDoubleArray>::New();
    column->SetNumberOfComponents(kind_of(entry) == Kind::kPlace ? 3 : 1);
  }
  column->SetName(entry.key.c_str());
  column->SetNumberOfTuples(rows);
  if (auto* numbers = vtkDoubleArray::SafeDownCast(column)) numbers->Fill(std::nan(""));
  return column;
}

void put(const host::ReportEntry& entry, vtkIdType row, vtkAbstractArray& column) {
  if (auto* texts = vtkStringArray::SafeDownCast(&column)) {
    if (!entry.texts.empty()) texts->SetValue(row, entry.texts.front());
  } else if (auto* numbers = vtkDoubleArray::SafeDownCast(&column);
             static_cast<std::size_t>(column.GetNumberOfComponents()) == entry.numbers.size()) {
    numbers->SetTuple(row, entry.numbers.data());
  }
}

}  // namespace

void give_report(const host::Results& results, vtkFieldData& out) {
  std::set<std::string> fresh;  // keys of this report
  for (const host::ReportEntry& entry : results.report) {
    if (entry.curve >= 0) continue;
    const std::string key = without_places(entry.key);
    if (fresh.insert(key).second) {
      vtkSmartPointer<vtkAbstractArray> array;
      if (entry.type == TALWEG_VALUE_TEXT) {
        array = vtkSmartPointer<vtkStringArray>::New();
      } else {
        array = vtkSmartPointer<vtkDoubleArray>::New();
      }
      array->SetName(key.c_str());
      out.AddArray(array);
    }
    vtkAbstractArray* array = out.GetAbstractArray(key.c_str());
    auto* texts = vtkStringArray::SafeDownCast(array);
    auto* numbers = vtkDoubleArray::SafeDownCast(array);
    for (const std::string& text : entry.texts) {
      if (texts != nullptr) texts->InsertNextValue(text);
    }
    for (const double number : entry.numbers) {
      if (numbers != nullptr) numbers->InsertNextValue(number);
    }
  }
}

std::vector<double> numbers_of_group(const host::Results& results, const std::string& group,
                                     const std::string& key) {
  std::vector<double> numbers;
  for (const host::ReportEntry& entry : results.report) {
    if (!is_one_number(entry) || without_places(entry.key) != group + "." + key) continue;
    numbers.push_back(entry.numbers.front());
  }
  return numbers;
}

namespace {

/// The entry as an entry of a curve, if it belongs to a list of groups with this name:
/// borders.2.left becomes left of curve 2.
host::ReportEntry of_its_curve(const host::ReportEntry& entry, const std::string& group) {
  host::ReportEntry own = entry;
  const std::string start = group + ".";
  if (group.empty() || entry.curve >= 0 || !entry.key.starts_with(start)) return own;
  const std::size_t end = entry.key.find('.', start.size());
  if (end == std::string::npos || without_places(entry.key) == entry.key) return own;
  own.curve = std::stoll(entry.key.substr(start.size(), end - start.size()));
  own.key = entry.key.substr(end + 1);
  return own;
}

}  // namespace

void give_table(const host::Results& results, vtkTable& out, const std::string& group) {
  std::int64_t curves = 0;
  for (const host::ReportEntry& entry : results.report) curves = std::max(curves, entry.curve + 1);
  const vtkIdType rows = curves + 1;
  vtkNew<vtkStringArray> names;
  names->SetName("# curve");  // a spreadsheet view sorts columns by name, and # comes first
  for (std::int64_t c = 0; c < curves; ++c) names->InsertNextValue(std::to_string(c));
  names->InsertNextValue("all");
  out.AddColumn(names);
  for (const host::ReportEntry& given : results.report) {
    const host::ReportEntry entry = of_its_curve(given, group);
    if (kind_of(entry) == Kind::kNone || is_of_no_curve(entry) || entry.curve >= curves) continue;
    vtkSmartPointer<vtkAbstractArray> column = out.GetColumnByName(entry.key.c_str());
    if (column == nullptr) {
      column = column_for(entry, rows);
      out.AddColumn(column);
    }
    put(entry, entry.curve < 0 ? rows - 1 : static_cast<vtkIdType>(entry.curve), *column);
  }
  give_report(results, *out.GetFieldData());
}

}  // namespace talweg::paraview
