#include "label_borders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "talweg/editing/selection_order.hpp"

namespace talweg::browser {
namespace {

using Edge = std::array<std::uint32_t, 2>;

/// A side of a triangle, the smaller vertex first, with the triangle's label.
struct Side {
  Edge edge;
  double label;
};

std::vector<Edge> edges_between(const editing::MeshArrays& mesh,
                                const std::vector<double>& labels) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      sides.push_back({{a, b}, labels[t]});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.label < b.label;
  });
  std::vector<Edge> edges;
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    const bool differ = sides[k].edge == sides[k + 1].edge && sides[k].label != sides[k + 1].label;
    if (differ && (edges.empty() || edges.back() != sides[k].edge)) edges.push_back(sides[k].edge);
  }
  return edges;
}

bool is_label(const host::Attribute& attribute) {
  if (attribute.element != TALWEG_OF_TRIANGLES || attribute.columns != 1) return false;
  return std::all_of(attribute.values.begin(), attribute.values.end(),
                     [](double value) { return value == std::floor(value); });
}

}  // namespace

std::vector<double> labels_of(const FileMesh& mesh) {
  const auto found = std::find_if(mesh.attributes.begin(), mesh.attributes.end(), is_label);
  if (found == mesh.attributes.end()) {
    throw editing::Error("The mesh's file has no labels: a whole number for each face.");
  }
  return found->values;
}

std::vector<editing::Curve> label_borders(const editing::MeshArrays& mesh,
                                          const std::vector<double>& labels) {
  if (labels.size() != mesh.triangles.size()) {
    throw editing::Error("There are " + std::to_string(labels.size()) +
                         " labels, and the mesh has " + std::to_string(mesh.triangles.size()) +
                         " faces.");
  }
  const std::vector<Edge> edges = edges_between(mesh, labels);
  if (edges.empty()) throw editing::Error("All faces have the same label, so there is no border.");
  std::vector<editing::Curve> curves;
  for (const editing::OrderedVertices& border : editing::order_between_branches(edges)) {
    editing::Curve curve;
    curve.points = editing::points_at(mesh, border.vertices);
    curve.closed = border.closed;
    for (editing::Point& point : curve.points) point.exact = TALWEG_MARK_PAINTED;
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace talweg::browser
