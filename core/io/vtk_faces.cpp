#include "talweg/core/io/vtk_faces.hpp"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/polylines.hpp"
#include "talweg/core/io/text_words.hpp"

namespace talweg::formats {
namespace {

/// The limit of PLY files: the numbers of a polygon are stored once per triangle.
constexpr std::size_t kMostColumns = 64;

/// Names of the columns of an array. Normals, colours and texture coordinates get the names of PLY.
std::vector<std::string> column_names(const VtkArray& array) {
  const auto is = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), array.name) != names.end();
  };
  const bool real = array.type >= NumberType::kFloat32;
  if (array.components == 3 && real && is({"Normals", "normals"})) {
    return {kNormals.begin(), kNormals.end()};
  }
  const bool colours = array.components == 3 || array.components == 4;
  if (colours && array.type == NumberType::kUint8 &&
      is({"RGB", "RGBA", "Colors", "colors", "Color", "color"})) {
    return {kColours.begin(), kColours.begin() + static_cast<std::ptrdiff_t>(array.components)};
  }
  if (array.components == 2 && real &&
      is({"TextureCoordinates", "Texture Coordinates", "TCoords", "uv"})) {
    return {"s", "t"};
  }
  std::string name = array.name.empty() ? "array" : array.name;
  for (char& c : name) {
    if (c <= ' ' || c > '~') c = '_';
  }
  if (array.components == 1) return {name};
  std::vector<std::string> names;
  for (std::size_t c = 0; c < array.components; ++c) names.push_back(fmt::format("{}_{}", name, c));
  return names;
}

/// Makes a name that differs from x, y, z and the names of other columns.
std::string free_name(std::string name, const std::vector<AttributeColumn>& columns) {
  const auto taken = [&] {
    if (name == "x" || name == "y" || name == "z") return true;
    return std::any_of(columns.begin(), columns.end(),
                       [&](const AttributeColumn& c) { return c.name == name; });
  };
  while (taken()) name += '_';
  return name;
}

}  // namespace

VtkCell cell_kind(double type) {
  if (type == 5 || type == 7 || type == 9 || type == 22 || type == 23 || type == 28) {
    return VtkCell::kPolygon;
  }
  if (type == 6) return VtkCell::kStrip;
  if (type == 8) return VtkCell::kPixel;
  return type <= 4 || type == 21 || type == 35 ? VtkCell::kLess : VtkCell::kVolume;
}

std::size_t cell_corners(double type, std::size_t points) {
  if (type == 22 && points == 6) return 3;
  if ((type == 23 && points == 8) || (type == 28 && points == 9)) return 4;
  return points;
}

void VtkFaces::begin_piece(std::span<const double> coordinates) {
  first_point_ = lists_.points.size();
  points_ = coordinates.size() / 3;
  first_triangle_ = lists_.triangles.size();
  cells_ = 0;
  cell_of_triangle_.clear();
  lists_.points.reserve(first_point_ + points_);
  for (std::size_t k = 0; k < points_; ++k) {
    lists_.points.emplace_back(coordinates[3 * k], coordinates[3 * k + 1], coordinates[3 * k + 2]);
  }
}

void VtkFaces::add_cell(VtkCell kind, std::span<const double> corners, const Fail& fail) {
  const std::size_t cell = cells_++;
  if (corners.size() < 3) {
    fail(fmt::format("face {} has {} corners, but a face needs three or more", cell,
                     corners.size()));
  }
  corners_.clear();
  for (const double corner : corners) {
    const auto index = index_below(corner, points_);
    if (!index) {
      fail(fmt::format("face {} refers to point {:.17g}, but there are {} points", cell, corner,
                       points_));
      return;
    }
    corners_.push_back(static_cast<std::uint32_t>(first_point_ + *index));
  }
  if (kind == VtkCell::kPixel && corners_.size() == 4) std::swap(corners_[2], corners_[3]);
  if (kind == VtkCell::kStrip) {
    for (std::size_t k = 2; k < corners_.size(); ++k) {
      const std::uint32_t a = corners_[k - 2], b = corners_[k - 1], c = corners_[k];
      if (a == b || b == c || c == a) continue;  // only continues the strip
      lists_.triangles.push_back(k % 2 == 0 ? Triangle{a, b, c} : Triangle{b, a, c});
    }
  } else {
    add_polygon(lists_, corners_);
  }
  if (attributes_ == nullptr) return;
  cell_of_triangle_.resize(lists_.triangles.size() - first_triangle_,
                           static_cast<std::uint32_t>(cell));
}

void VtkFaces::skip_cells(std::size_t count, std::string_view what) {
  if (count == 0) return;
  cells_ += count;
  const auto same = std::find_if(skipped_.begin(), skipped_.end(),
                                 [&](const auto& pair) { return pair.first == what; });
  if (same != skipped_.end()) {
    same->second += count;
  } else {
    skipped_.emplace_back(what, count);
  }
}

void VtkFaces::end_piece(std::vector<VtkArray> of_points, std::vector<VtkArray> of_cells) {
  if (attributes_ == nullptr) return;
  add_columns(attributes_->vertices, of_points, points_, {}, first_point_);
  add_columns(attributes_->faces, of_cells, cells_, cell_of_triangle_, first_triangle_);
  ++pieces_;
}

/// The tuple of element k is tuple_of[k], or k itself if `tuple_of` is empty. All pieces must have
/// the same arrays; others are dropped.
void VtkFaces::add_columns(std::vector<AttributeColumn>& columns, std::vector<VtkArray>& arrays,
                           std::size_t tuples, std::span<const std::uint32_t> tuple_of,
                           std::size_t before) {
  const bool of_cells = &columns == &attributes_->faces;
  const std::size_t elements = of_cells ? tuple_of.size() : tuples;
  std::vector<AttributeColumn> made;
  for (VtkArray& array : arrays) {
    if (array.components == 0 || array.numbers.size() / array.components != tuples ||
        array.numbers.size() % array.components != 0) {
      leave_out(array.name, of_cells ? " of cells" : " of points");
      continue;
    }
    if (made.size() + array.components > kMostColumns) {
      leave_out(array.name, of_cells ? " of cells" : " of points");
      continue;
    }
    const std::vector<std::string> names = column_names(array);
    for (std::size_t c = 0; c < array.components; ++c) {
      AttributeColumn column{free_name(names[c], made), array.type, {}};
      column.values.reserve(elements);
      for (std::size_t k = 0; k < elements; ++k) {
        const std::size_t tuple = of_cells ? tuple_of[k] : k;
        column.values.push_back(array.numbers[tuple * array.components + c]);
      }
      made.push_back(std::move(column));
    }
    array.numbers = {};
  }
  if (pieces_ == 0) {
    for (AttributeColumn& column : made) {  // pieces without points came before
      column.values.insert(column.values.begin(), before, 0);
    }
    columns = std::move(made);
    return;
  }
  std::vector<AttributeColumn> both;
  for (AttributeColumn& column : columns) {
    const auto same = std::find_if(made.begin(), made.end(), [&](const AttributeColumn& other) {
      return other.name == column.name;
    });
    if (same == made.end()) {
      leave_out(column.name, ", which not all pieces have");
      continue;
    }
    if (same->type != column.type) column.type = NumberType::kFloat64;
    column.values.insert(column.values.end(), same->values.begin(), same->values.end());
    both.push_back(std::move(column));
  }
  columns = std::move(both);
}

void VtkFaces::leave_out(const std::string& name, const char* why) {
  if (attributes_->left_out.size() >= kMostColumns) return;
  attributes_->left_out.push_back(fmt::format("array '{}'{}", printable(name), why));
}

void VtkFaces::end() {
  for (const auto& [what, count] : skipped_) {
    lists_.notes.push_back(fmt::format("{} {} of the file were left out.", count, what));
  }
}

}  // namespace talweg::formats
