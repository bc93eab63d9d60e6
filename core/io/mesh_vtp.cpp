// VTK XML polydata as meshes: polygons and triangle strips of all pieces.
#include <utility>

#include <fmt/format.h>

#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/polylines.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/io/vtk_faces.hpp"
#include "talweg/core/io/vtk_xml.hpp"

namespace talweg {
namespace {

using formats::VtkArray;
using formats::VtkCell;

class VtpMesh {
 public:
  VtpMesh(const MeshFile& file, MeshAttributes* attributes)
      : source_{file.path, file.bytes, {}},
        xml_(source_),
        attributes_(attributes),
        faces_(lists_, attributes) {}

  MeshLists read() {
    lists_.single_precision = true;
    for (const pugi::xml_node piece : xml_.pieces()) {
      if (piece.attribute("NumberOfPoints").as_ullong(1) > 0) read_piece(piece);
    }
    faces_.end();
    if (lists_.triangles.empty() && !lists_.points.empty()) {
      bad_file(source_.path,
               "it has points but no polygons or triangle strips, so it holds no surface.");
    }
    lists_.space = xml_.space();
    return std::move(lists_);
  }

 private:
  void read_piece(const pugi::xml_node& piece) {
    const pugi::xml_node points = piece.child("Points").child("DataArray");
    if (!points) xml_.fail(piece, "expected <Points> with a <DataArray>");
    const std::vector<double> x = xml_.read_array(points);
    const std::uint64_t claimed = piece.attribute("NumberOfPoints").as_ullong();
    if (x.size() % 3 != 0 || x.size() / 3 != claimed) {
      xml_.fail(points,
                fmt::format("expected 3 coordinates for each of {} points, found {} numbers",
                            claimed, x.size()));
    }
    lists_.single_precision &= std::string_view(points.attribute("type").value()) == "Float32";
    faces_.begin_piece(x);
    faces_.skip_cells(count_of(piece, "Verts"), "vertex cells");
    faces_.skip_cells(count_of(piece, "Lines"), "lines");
    read_cells(piece.child("Polys"), VtkCell::kPolygon);
    read_cells(piece.child("Strips"), VtkCell::kStrip);
    if (attributes_ == nullptr) return;
    std::vector<VtkArray> of_points = arrays(piece.child("PointData"));
    faces_.end_piece(std::move(of_points), arrays(piece.child("CellData")));
  }

  /// The number of cells of a kind: the number of their offsets.
  std::size_t count_of(const pugi::xml_node& piece, const char* kind) const {
    const pugi::xml_node cells = piece.child(kind);
    if (cells.empty() || !cells.child("DataArray")) return 0;
    const pugi::xml_attribute claimed = piece.attribute(fmt::format("NumberOf{}", kind).c_str());
    if (claimed && claimed.as_ullong() == 0) return 0;
    return xml_.read_array(xml_.named(cells, "offsets")).size();
  }

  void read_cells(const pugi::xml_node& cells, VtkCell kind) {
    if (!cells.child("DataArray")) return;
    const std::vector<double> connectivity = xml_.read_array(xml_.named(cells, "connectivity"));
    const std::vector<double> offsets = xml_.read_array(xml_.named(cells, "offsets"));
    const auto fail = [&](const std::string& what) { xml_.fail(cells, what); };
    std::size_t from = 0;
    for (std::size_t k = 0; k < offsets.size(); ++k) {
      const auto to = formats::index_below(offsets[k], connectivity.size() + 1);
      if (!to || *to < from) {
        xml_.fail(cells, fmt::format("face {} has more corners than there are", k));
      }
      faces_.add_cell(kind, std::span(connectivity).subspan(from, *to - from), fail);
      from = *to;
    }
  }

  std::vector<VtkArray> arrays(const pugi::xml_node& data) {
    std::vector<VtkArray> result;
    for (const pugi::xml_node node : data.children("DataArray")) {
      const auto type = xml_.number_type(node);
      const std::string name = node.attribute("Name").value();
      if (!type) {
        attributes_->left_out.push_back(
            fmt::format("array '{}', which has no numbers", printable(name)));
        continue;
      }
      result.push_back(
          {name, *type, node.attribute("NumberOfComponents").as_uint(1), xml_.read_array(node)});
    }
    for (const pugi::xml_node node : data.children("Array")) {  // arrays of texts
      if (attributes_->left_out.size() >= 64) break;
      attributes_->left_out.push_back(fmt::format("array '{}', which has no numbers",
                                                  printable(node.attribute("Name").value())));
    }
    return result;
  }

  formats::Source source_;
  formats::VtkXml xml_;
  MeshAttributes* attributes_;
  MeshLists lists_;
  formats::VtkFaces faces_;
};

}  // namespace

MeshLists read_vtp_mesh(const MeshFile& file, MeshAttributes* attributes) {
  return VtpMesh(file, attributes).read();
}

}  // namespace talweg
