// Reports of plugins as arrays and tables.
#pragma once

#include <vtkType.h>

#include "talweg/plugin/talweg_host.hpp"

class vtkDataSetAttributes;
class vtkFieldData;
class vtkTable;

namespace talweg::paraview {

/// The entries for all, one array each. Those of a list of groups (parts.0.faces, parts.1.faces)
/// are one array (parts.faces).
void give_report(const host::Results& results, vtkFieldData& out);

/// A number for each of `count` curves: the entries that every curve has, and those of `group`
/// (borders.0.left), if it is not empty.
void give_reports_of_curves(const host::Results& results, const char* group, vtkIdType count,
                            vtkDataSetAttributes& out);

/// A row for each curve and a last one, all, for them together; the column "# curve" says which.
/// Columns are the numbers, the three coordinates of a place, and the texts; what a row has not is
/// NaN or empty. The field data have the report on all.
void give_table(const host::Results& results, vtkTable& out);

}  // namespace talweg::paraview
