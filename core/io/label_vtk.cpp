// Labels as an array of VTK's polydata: legacy files and XML.
#include <utility>

#include <fmt/format.h>

#include "talweg/core/io/label_formats.hpp"
#include "talweg/core/io/vtk_legacy.hpp"
#include "talweg/core/io/vtk_xml.hpp"

namespace talweg::formats {
namespace {

class LegacyLabels {
 public:
  explicit LegacyLabels(const Source& source) : file_(source) {}

  std::vector<NamedNumbers> read() {
    for (std::string_view section = file_.word(); !section.empty(); section = file_.word()) {
      if (section == "POINT_DATA" || section == "CELL_DATA") {
        of_faces_ = section == "CELL_DATA";
        count_ = file_.read_count();
        in_data_ = true;
      } else if (in_data_) {
        read_attribute(section);
      } else {
        skip_geometry(section);
      }
    }
    return std::move(found_);
  }

 private:
  void skip_geometry(std::string_view section) {
    if (section == "DATASET") {
      const std::string_view type = file_.word_on_line();
      if (type != "POLYDATA") file_.fail("POLYDATA", type);
    } else if (section == "POINTS") {
      const std::uint64_t n = file_.read_count();
      const NumberType type = file_.read_type();
      file_.read_numbers(3 * n, type);
    } else if (section == "POLYGONS" || section == "VERTICES" || section == "LINES" ||
               section == "TRIANGLE_STRIPS") {
      skip_cells();
    } else if (section == "FIELD") {
      file_.read_fields();
    } else if (section == "METADATA") {
      file_.skip_metadata();
    } else {
      file_.fail("POINTS, POLYGONS, CELL_DATA or POINT_DATA", section);
    }
  }

  void skip_cells() {
    const std::uint64_t n = file_.read_count();
    const std::uint64_t size = file_.read_count();
    if (file_.splits_cells()) {
      file_.read_part("OFFSETS", n);
      file_.read_part("CONNECTIVITY", size);
    } else {
      file_.read_numbers(size, NumberType::kInt32);
    }
  }

  void read_attribute(std::string_view kind) {
    for (VtkLegacy::Array& array : file_.read_attribute(kind, count_)) {
      if (array.components == 1 && array.numbers.size() == count_) {
        found_.push_back({std::move(array.name), of_faces_, std::move(array.numbers)});
      }
    }
  }

  VtkLegacy file_;
  bool in_data_ = false, of_faces_ = false;
  std::uint64_t count_ = 0;
  std::vector<NamedNumbers> found_;
};

}  // namespace

LabelFile read_vtk_labels(const Source& source, const std::string& property) {
  const std::vector<NamedNumbers> all = LegacyLabels(source).read();
  return {whole_numbers(source, chosen(source, all, property)), {}};
}

LabelFile read_vtp_labels(const Source& source, const std::string& property) {
  const VtkXml xml(source);
  std::vector<NamedNumbers> all;
  std::size_t pieces = 0;
  for (const pugi::xml_node piece : xml.pieces()) {
    if (++pieces > 1) xml.fail(piece, "labels of a mesh in several pieces cannot be told apart");
    for (const char* kind : {"CellData", "PointData"}) {
      const bool of_faces = kind[0] == 'C';
      for (const pugi::xml_node array : piece.child(kind).children("DataArray")) {
        if (array.attribute("NumberOfComponents").as_uint(1) != 1) continue;
        if (std::string_view(array.attribute("type").value()) == "String") continue;
        all.push_back({array.attribute("Name").value(), of_faces, xml.read_array(array)});
      }
    }
  }
  return {whole_numbers(source, chosen(source, all, property)), {}};
}

}  // namespace talweg::formats
