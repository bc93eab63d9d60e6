// Converts reports of plugins to arrays and tables.
#pragma once

#include <string>
#include <vector>

#include "talweg/plugin/talweg_host.hpp"

class vtkFieldData;
class vtkTable;

namespace talweg::paraview {

/// The entries for all curves, an array for each. Entries of a list of groups (parts.0.faces,
/// parts.1.faces) form one array (parts.faces).
void give_report(const host::Results& results, vtkFieldData& out);

/// The numbers `key` of all groups of a list in their order (left of borders.0.left,
/// borders.1.left).
std::vector<double> numbers_of_group(const host::Results& results, const std::string& group,
                                     const std::string& key);

/// A row for each curve, and a last row "all" for all curves; the column "# curve" has the number.
/// Columns are numbers, the three coordinates of a place, and texts; missing values are NaN or
/// empty. If the report has a list of groups with a group for each curve (borders.0.left), `group`
/// adds columns for its entries. The field data have the report for all curves.
void give_table(const host::Results& results, vtkTable& out, const std::string& group = {});

}  // namespace talweg::paraview
