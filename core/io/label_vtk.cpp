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
    if (kind == "FIELD") {
      for (VtkLegacy::Array& array : file_.read_fields()) {
        add(std::move(array.name), array.components, std::move(array.numbers));
      }
    } else if (kind == "METADATA") {
      file_.skip_metadata();
    } else if (kind == "SCALARS") {
      read_scalars();
    } else if (kind == "LOOKUP_TABLE") {
      file_.word_on_line();
      const std::uint64_t n = file_.read_count();
      file_.read_numbers(4 * n, file_.is_ascii() ? NumberType::kFloat32 : NumberType::kUint8);
    } else if (kind == "COLOR_SCALARS") {
      file_.word_on_line();
      const std::uint64_t n = file_.read_count();
      file_.read_numbers(n * count_, file_.is_ascii() ? NumberType::kFloat32 : NumberType::kUint8);
    } else if (kind == "TEXTURE_COORDINATES") {
      file_.word_on_line();
      const std::uint64_t n = file_.read_count();
      const NumberType type = file_.read_type();
      file_.read_numbers(n * count_, type);
    } else if (kind == "VECTORS" || kind == "NORMALS" || kind == "TENSORS") {
      const std::uint64_t each = kind == "TENSORS" ? 9 : 3;
      file_.word_on_line();
      const NumberType type = file_.read_type();
      file_.read_numbers(each * count_, type);
    } else {
      file_.fail("SCALARS or FIELD", kind);
    }
  }

  void read_scalars() {
    std::string name(file_.word_on_line());
    const NumberType type = file_.read_type();
    std::uint64_t components = 1;
    const std::string_view given = file_.word_on_line();
    if (given == "2" || given == "3" || given == "4") {
      components = static_cast<std::uint64_t>(given[0] - '0');
    } else if (!given.empty() && given != "1") {
      file_.fail("1 to 4 components", given);
    }
    const std::string_view table = file_.word();
    if (table != "LOOKUP_TABLE") file_.fail("LOOKUP_TABLE", table);
    file_.word_on_line();
    add(std::move(name), components, file_.read_numbers(components * count_, type));
  }

  void add(std::string name, std::uint64_t components, std::vector<double> numbers) {
    if (components == 1 && numbers.size() == count_) {
      found_.push_back({std::move(name), of_faces_, std::move(numbers)});
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
