// VTK legacy files as meshes: polygons and triangle strips of polydata, and the faces of an
// unstructured grid; ascii and binary, versions 1 to 5.
#include <utility>

#include <fmt/format.h>

#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/polylines.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/io/vtk_faces.hpp"
#include "talweg/core/io/vtk_legacy.hpp"

namespace talweg {
namespace {

using formats::VtkCell;
using formats::VtkLegacy;

/// The cells of one section; cell k has the points from begins[k] up to ends[k].
struct LegacyCells {
  std::vector<std::size_t> begins, ends;
  std::vector<double> points;
  [[nodiscard]] std::size_t size() const { return begins.size(); }
  [[nodiscard]] std::span<const double> at(std::size_t k) const {
    return std::span(points).subspan(begins[k], ends[k] - begins[k]);
  }
};

class LegacyMesh {
 public:
  LegacyMesh(const MeshFile& file, MeshAttributes* attributes)
      : source_{file.path, file.bytes, {}},
        file_(source_, true),
        mesh_file_(file),
        with_attributes_(attributes != nullptr),
        faces_(lists_, attributes) {}

  MeshLists read() {
    std::string_view section = file_.word();
    for (; !section.empty(); section = file_.word()) {
      if (section == "POINT_DATA" || section == "CELL_DATA") break;
      read_section(section);
    }
    faces_.begin_piece(points_);
    add_cells();
    if (with_attributes_) read_data(section);
    faces_.end_piece(std::move(of_points_), std::move(of_cells_));
    faces_.end();
    lists_.space = file_.space();
    return std::move(lists_);
  }

 private:
  void read_section(std::string_view section) {
    if (section == "DATASET") {
      const std::string_view type = file_.word_on_line();
      grid_ = type == "UNSTRUCTURED_GRID";
      if (!grid_ && type != "POLYDATA") {
        file_.fail(
            fmt::format("the dataset is {}, no surface; extract one (in ParaView: Extract "
                        "Surface) and save it as .vtp",
                        printable(type)));
      }
    } else if (section == "POINTS") {
      if (!points_.empty()) file_.fail("POINTS comes twice");
      const std::uint64_t n = file_.read_count();
      const NumberType type = file_.read_type();
      points_ = file_.read_numbers(3 * n, type);
      lists_.single_precision = type == NumberType::kFloat32;
    } else if (section == "CELL_TYPES") {
      types_ = file_.read_numbers(file_.read_count(), NumberType::kInt32);
    } else if (section == "FIELD") {
      file_.read_fields();
    } else if (section == "METADATA") {
      file_.skip_metadata();
    } else {
      read_cells(section);
    }
  }

  void read_cells(std::string_view section) {
    for (LegacyCells* cells : {&vertices_, &lines_, &polygons_, &strips_, &grid_cells_}) {
      if (section != name_of(*cells)) continue;
      if (cells->size() > 0) file_.fail(fmt::format("{} comes twice", section));
      *cells = read_list();
      return;
    }
    file_.fail(grid_ ? "POINTS, CELLS or CELL_TYPES" : "POINTS, POLYGONS or TRIANGLE_STRIPS",
               section);
  }

  [[nodiscard]] std::string_view name_of(const LegacyCells& cells) const {
    if (&cells == &vertices_) return "VERTICES";
    if (&cells == &lines_) return "LINES";
    if (&cells == &polygons_) return "POLYGONS";
    if (&cells == &strips_) return "TRIANGLE_STRIPS";
    return "CELLS";
  }

  LegacyCells read_list() {
    const std::uint64_t n = file_.read_count();
    const std::uint64_t size = file_.read_count();
    LegacyCells cells;
    if (file_.splits_cells()) {  // n is the number of cells plus one
      const std::vector<double> offsets = file_.read_part("OFFSETS", n);
      cells.points = file_.read_part("CONNECTIVITY", size);
      for (std::size_t k = 1; k < offsets.size(); ++k) add(cells, offsets[k - 1], offsets[k]);
      return cells;
    }
    cells.points = file_.read_numbers(size, NumberType::kInt32);
    std::size_t at = 0;
    for (std::uint64_t k = 0; k < n; ++k) {
      if (at >= cells.points.size()) file_.fail(fmt::format("cell {} is missing", k));
      const double from = static_cast<double>(at) + 1;
      add(cells, from, from + cells.points[at]);
      at = cells.ends.back();
    }
    return cells;
  }

  void add(LegacyCells& cells, double from, double to) const {
    const auto first = formats::index_below(from, cells.points.size() + 1);
    const auto last = formats::index_below(to, cells.points.size() + 1);
    if (!first || !last || *last < *first) {
      file_.fail(fmt::format("cell {} has more points than there are", cells.size()));
    }
    cells.begins.push_back(*first);
    cells.ends.push_back(*last);
  }

  /// Adds the cells in VTK's order.
  void add_cells() {
    const auto fail = [this](const std::string& what) { bad_file(mesh_file_.path, what + "."); };
    faces_.skip_cells(vertices_.size(), "vertex cells");
    faces_.skip_cells(lines_.size(), "lines");
    for (std::size_t k = 0; k < polygons_.size(); ++k) {
      faces_.add_cell(VtkCell::kPolygon, polygons_.at(k), fail);
    }
    for (std::size_t k = 0; k < strips_.size(); ++k) {
      faces_.add_cell(VtkCell::kStrip, strips_.at(k), fail);
    }
    add_grid(fail);
    if (!lists_.triangles.empty() || points_.empty()) return;
    bad_file(mesh_file_.path,
             volumes_
                 ? "its grid has volumes but no faces; extract its surface (in ParaView: "
                   "Extract Surface) and save it as .vtp."
                 : "it has points but no polygons or triangle strips, so it holds no surface.");
  }

  void add_grid(const formats::VtkFaces::Fail& fail) {
    if (types_.size() != grid_cells_.size()) {
      fail(fmt::format("there are {} cells, but {} types of cells", grid_cells_.size(),
                       types_.size()));
    }
    for (std::size_t k = 0; k < grid_cells_.size(); ++k) {
      const VtkCell kind = formats::cell_kind(types_[k]);
      const std::span<const double> points = grid_cells_.at(k);
      if (kind == VtkCell::kLess) {
        faces_.skip_cells(1, "vertex cells and lines");
      } else if (kind == VtkCell::kVolume) {
        volumes_ = true;
        faces_.skip_cells(1, "volumes, whose boundary is not taken,");
      } else {
        const std::size_t corners = formats::cell_corners(types_[k], points.size());
        quadratic_ |= corners < points.size();
        faces_.add_cell(kind, points.first(corners), fail);
      }
    }
    if (!quadratic_) return;
    lists_.notes.emplace_back("Of quadratic faces only the corners were taken.");
  }

  void read_data(std::string_view section) {
    std::vector<formats::VtkArray>* to = &of_points_;
    std::uint64_t count = 0;
    for (; !section.empty(); section = file_.word()) {
      if (section == "POINT_DATA" || section == "CELL_DATA") {
        to = section == "POINT_DATA" ? &of_points_ : &of_cells_;
        count = file_.read_count();
        continue;
      }
      for (VtkLegacy::Array& array : file_.read_attribute(section, count)) {
        to->push_back({std::move(array.name), array.type,
                       static_cast<std::size_t>(array.components), std::move(array.numbers)});
      }
    }
  }

  formats::Source source_;
  VtkLegacy file_;
  const MeshFile& mesh_file_;
  bool with_attributes_, grid_ = false, volumes_ = false, quadratic_ = false;
  MeshLists lists_;
  formats::VtkFaces faces_;
  std::vector<double> points_, types_;
  LegacyCells vertices_, lines_, polygons_, strips_, grid_cells_;
  std::vector<formats::VtkArray> of_points_, of_cells_;
};

}  // namespace

MeshLists read_vtk_mesh(const MeshFile& file, MeshAttributes* attributes) {
  return LegacyMesh(file, attributes).read();
}

}  // namespace talweg
