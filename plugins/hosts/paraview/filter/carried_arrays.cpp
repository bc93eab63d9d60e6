#include "carried_arrays.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <string>

#include <vtkAbstractArray.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

namespace talweg::paraview {
namespace {

using Ids = std::vector<vtkIdType>;

bool is_colour(const vtkAbstractArray& array) {
  auto& a = const_cast<vtkAbstractArray&>(array);  // the getters are not const
  return a.GetDataType() == VTK_UNSIGNED_CHAR &&
         (a.GetNumberOfComponents() == 3 || a.GetNumberOfComponents() == 4);
}

/// Whether new values are interpolated between the corners, rather than copied from the nearest.
bool is_linear(vtkAbstractArray& array) {
  std::string name = array.GetName() == nullptr ? "" : array.GetName();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (name.find("label") != std::string::npos) return false;
  const int type = array.GetDataType();
  return type == VTK_FLOAT || type == VTK_DOUBLE || is_colour(array);
}

bool is_normals(vtkAbstractArray& array, vtkDataSetAttributes& of) {
  const std::string name = array.GetName() == nullptr ? "" : array.GetName();
  return array.GetNumberOfComponents() == 3 &&
         (&array == of.GetNormals() || name == "Normals" || name == "normals");
}

vtkSmartPointer<vtkAbstractArray> like(vtkAbstractArray& array, std::size_t count) {
  const auto result = vtkSmartPointer<vtkAbstractArray>::Take(array.NewInstance());
  result->SetName(array.GetName());
  result->SetNumberOfComponents(array.GetNumberOfComponents());
  result->CopyComponentNames(&array);
  result->CopyInformation(array.GetInformation());
  result->SetNumberOfTuples(static_cast<vtkIdType>(count));
  auto* numbers = vtkDataArray::SafeDownCast(&array);
  if (numbers != nullptr) {
    vtkDataArray::SafeDownCast(result)->SetLookupTable(numbers->GetLookupTable());
  }
  return result;
}

void fill(vtkAbstractArray& array, vtkIdType row) {
  auto* numbers = vtkDataArray::SafeDownCast(&array);
  if (numbers == nullptr) return;  // new texts are already empty
  const double value = is_colour(array) ? 255 : 0;
  for (int k = 0; k < array.GetNumberOfComponents(); ++k) numbers->SetComponent(row, k, value);
}

/// Copies rows; a row without a source (-1) gets the fill value.
void copy_rows(vtkAbstractArray& from, const Ids& sources, vtkAbstractArray& to) {
  vtkNew<vtkIdList> source, target;
  for (std::size_t k = 0; k < sources.size(); ++k) {
    const auto row = static_cast<vtkIdType>(k);
    if (sources[k] < 0) {
      fill(to, row);
    } else {
      source->InsertNextId(sources[k]);
      target->InsertNextId(row);
    }
  }
  if (source->GetNumberOfIds() > 0) to.InsertTuples(target, source, &from);
}

void make_unit(vtkDataArray& array, vtkIdType row) {
  double x[3];
  array.GetTuple(row, x);
  const double length = std::hypot(x[0], x[1], x[2]);
  if (!(length > 0)) return;
  for (double& c : x) c /= length;
  array.SetTuple(row, x);
}

/// Interpolates the rows of vertices that lie between others.
void interpolate_rows(vtkAbstractArray& from, const host::Origin& origin, bool directions,
                      vtkAbstractArray& to) {
  vtkNew<vtkIdList> corners;
  for (std::size_t v = 0; v < origin.vertices.size(); ++v) {
    double weights[3];
    corners->Reset();
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(origin.weights[v][k] > 0)) continue;
      weights[corners->GetNumberOfIds()] = origin.weights[v][k];
      corners->InsertNextId(origin.vertices[v][k]);
    }
    if (corners->GetNumberOfIds() < 2) continue;
    const auto row = static_cast<vtkIdType>(v);
    to.InterpolateTuple(row, corners, &from, weights);
    if (directions) make_unit(*vtkDataArray::SafeDownCast(&to), row);
  }
}

/// For each vertex the corner of largest weight, the first of equals; -1: the vertex has no origin.
Ids nearest_corners(const host::Origin& origin) {
  Ids result;
  for (std::size_t v = 0; v < origin.vertices.size(); ++v) {
    const auto& weights = origin.weights[v];
    const auto most = std::max_element(weights.begin(), weights.end());
    const auto corner = origin.vertices[v][static_cast<std::size_t>(most - weights.begin())];
    result.push_back(*most > 0 ? static_cast<vtkIdType>(corner) : -1);
  }
  return result;
}

/// Makes the same arrays active (as scalars, normals, ...) in the other data set.
void copy_active(vtkDataSetAttributes& from, vtkDataSetAttributes& to) {
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type) {
    vtkAbstractArray* active = from.GetAbstractAttribute(type);
    if (active != nullptr && active->GetName() != nullptr) {
      to.SetActiveAttribute(active->GetName(), type);
    }
  }
}

void carry(vtkDataSetAttributes& from, const Ids& sources, vtkDataSetAttributes& to,
           const std::function<void(vtkAbstractArray&, vtkAbstractArray&)>& improve) {
  for (int k = 0; k < from.GetNumberOfArrays(); ++k) {
    vtkAbstractArray& array = *from.GetAbstractArray(k);
    const auto made = like(array, sources.size());
    copy_rows(array, sources, *made);
    improve(array, *made);
    to.AddArray(made);
  }
  copy_active(from, to);
}

}  // namespace

void carry_points(vtkDataSetAttributes& from, const host::Origin& origin,
                  vtkDataSetAttributes& to) {
  carry(from, nearest_corners(origin), to, [&](vtkAbstractArray& array, vtkAbstractArray& made) {
    if (is_linear(array)) interpolate_rows(array, origin, is_normals(array, from), made);
  });
}

void carry_cells(vtkDataSetAttributes& from, const std::vector<vtkIdType>& sources,
                 vtkDataSetAttributes& to) {
  carry(from, sources, to, [](vtkAbstractArray&, vtkAbstractArray&) {});
}

}  // namespace talweg::paraview
