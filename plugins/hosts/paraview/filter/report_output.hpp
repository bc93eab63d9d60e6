// Reports of plugins as arrays and tables.
#pragma once

#include <string>
#include <vector>

#include "talweg/plugin/talweg_host.hpp"

class vtkFieldData;
class vtkTable;

namespace talweg::paraview {

/// The entries for all, one array each. Those of a list of groups (parts.0.faces, parts.1.faces)
/// are one array (parts.faces).
void give_report(const host::Results& results, vtkFieldData& out);

/// The numbers under `key` of each group of a list (borders.0.left, borders.1.left), in their
/// order.
std::vector<double> numbers_of_group(const host::Results& results, const std::string& group,
                                     const std::string& key);

/// A row for each curve and a last one, all, for them together; the column "# curve" says which.
/// Columns are the numbers, the three coordinates of a place, and the texts; what a row has not is
/// NaN or empty. If the report has a group for each curve (borders.0.left), its name makes columns
/// of it, too. The field data have the report on all.
void give_table(const host::Results& results, vtkTable& out, const std::string& group = {});

}  // namespace talweg::paraview
