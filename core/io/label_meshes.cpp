// Labels as a property of a mesh: PLY, and VTK's polydata.
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/io/label_bytes.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg::formats {
namespace {

constexpr std::string_view kLabel = "label";

bool fits_int32(const std::vector<std::int64_t>& labels) {
  return std::all_of(labels.begin(), labels.end(),
                     [](std::int64_t label) { return label == static_cast<std::int32_t>(label); });
}

}  // namespace

std::string ply_labels(const LabelContent& content) {
  MeshAttributes attributes = content.attributes;
  for (std::vector<AttributeColumn>* columns : {&attributes.vertices, &attributes.faces}) {
    std::erase_if(*columns, [](const AttributeColumn& column) { return column.name == kLabel; });
  }
  AttributeColumn column;
  column.name = kLabel;
  column.type = fits_int32(content.labels.labels) ? NumberType::kInt32 : NumberType::kFloat64;
  for (const std::int64_t label : content.labels.labels) {
    column.values.push_back(static_cast<double>(label));
  }
  (content.labels.of_faces ? attributes.faces : attributes.vertices).push_back(std::move(column));
  return mesh_bytes(content.path, content.mesh, attributes).bytes;
}

std::string vtk_labels(const LabelContent& content) {
  const MeshLists& mesh = content.mesh;
  std::string text =
      fmt::format("# vtk DataFile Version 3.0\nlabels\nASCII\nDATASET POLYDATA\nPOINTS {} double\n",
                  mesh.points.size());
  const auto out = std::back_inserter(text);
  for (const Point& p : mesh.points) {
    fmt::format_to(out, "{:.17g} {:.17g} {:.17g}\n", p.x(), p.y(), p.z());
  }
  fmt::format_to(out, "POLYGONS {} {}\n", mesh.triangles.size(), 4 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) fmt::format_to(out, "3 {} {} {}\n", t[0], t[1], t[2]);
  fmt::format_to(out, "{} {}\nSCALARS {} {} 1\nLOOKUP_TABLE default\n",
                 content.labels.of_faces ? "CELL_DATA" : "POINT_DATA", content.labels.labels.size(),
                 kLabel, fits_int32(content.labels.labels) ? "int" : "long");
  return text + text_labels(content);
}

std::string vtp_labels(const LabelContent& content) {
  const MeshLists& mesh = content.mesh;
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
      mesh.points.size(), mesh.triangles.size());
  const auto out = std::back_inserter(text);
  const char* data = content.labels.of_faces ? "CellData" : "PointData";
  const auto open_array = [&](const char* type, std::string_view name, int components) {
    fmt::format_to(out,
                   "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
                   "format=\"ascii\">\n",
                   type, name, components);
  };
  fmt::format_to(out, "<{} Scalars=\"{}\">\n", data, kLabel);
  open_array("Int64", kLabel, 1);
  text += text_labels(content);
  fmt::format_to(out, "</DataArray>\n</{}>\n<Points>\n", data);
  open_array("Float64", "Points", 3);
  for (const Point& p : mesh.points) {
    fmt::format_to(out, "{:.17g} {:.17g} {:.17g}\n", p.x(), p.y(), p.z());
  }
  fmt::format_to(out, "</DataArray>\n</Points>\n<Polys>\n");
  open_array("Int64", "connectivity", 1);
  for (const Triangle& t : mesh.triangles) fmt::format_to(out, "{} {} {}\n", t[0], t[1], t[2]);
  fmt::format_to(out, "</DataArray>\n");
  open_array("Int64", "offsets", 1);
  for (std::size_t f = 1; f <= mesh.triangles.size(); ++f) fmt::format_to(out, "{}\n", 3 * f);
  return text + "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace talweg::formats
