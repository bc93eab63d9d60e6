// Bytes as files. A reader returns a result as documented, or throws an Error(kBadFile) that names
// the file.
#include <cmath>
#include <string>
#include <variant>

#include "fuzz_bytes.hpp"
#include "fuzz_target.hpp"
#include "talweg/core/io/click_file.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/field_values.hpp"
#include "talweg/core/io/label_file.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::fuzz {
namespace {

std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

void check_refusal(const Target& target, const Error& error) {
  const std::string_view what = error.what();
  require(error.code() == ErrorCode::kBadFile, "a file's error");
  require(what.find(target.file) != what.npos, "the file's name");
  require(what.size() < 400 && what.back() == '.', "one sentence");
  for (const char c : what) require(c >= ' ' && c <= '~', "printable words");
}

void check_attributes(const MeshLists& lists, const MeshAttributes& a) {
  const std::size_t faces = lists.triangles.size();
  for (const auto& c : a.vertices) require(c.values.size() == lists.points.size(), "values");
  for (const auto& c : a.faces) require(c.values.size() == faces, "values of faces");
  for (const auto& n : a.names) require(n.of_face.size() == faces, "names of faces");
  for (const CornerAttribute* corners : {&a.texture, &a.normals}) {
    if (corners->dimension == 0) continue;
    require(corners->corners.size() == faces, "values of corners");
    for (const auto& face : corners->corners) {
      for (const std::uint32_t c : face) {
        require(c == CornerAttribute::kNone || c < corners->values.size() / corners->dimension,
                "corners in range");
      }
    }
  }
}

}  // namespace

void read_mesh_bytes(const Target& target, const std::uint8_t* data, std::size_t size) {
  try {
    const MeshLists lists = read_mesh(target.file, text_of(data, size));
    MeshAttributes attributes;
    check_attributes(read_mesh(target.file, text_of(data, size), attributes), attributes);
    require(!lists.points.empty(), "vertices");
    for (const Triangle& t : lists.triangles) {
      for (const std::uint32_t v : t) require(v < lists.points.size(), "indices in range");
    }
    require(lists.polygons.size() == lists.polygon_count, "every polygon");
    for (const Polygon& p : lists.polygons) {
      require(p.corners > 3 && p.first + std::size_t{p.corners} - 2 <= lists.triangles.size(),
              "triangles of polygons");
    }
    // A vertex that a face uses has finite coordinates in a text file.
    const bool text = target.name == "mesh_obj";
    for (const Triangle& t : lists.triangles) {
      for (const std::uint32_t v : t) {
        require(!text || lists.points[v].allFinite(), "finite coordinates");
      }
    }
    for (const std::string& note : lists.notes) {
      for (const char c : note) require(c >= ' ' && c <= '~', "printable notes");
    }
  } catch (const Error& error) {
    check_refusal(target, error);
  }
}

namespace {

void check_curve(const CurveInput& curve) {
  const std::size_t n = std::visit([](const auto& list) { return list.size(); }, curve.points);
  require(n > 0, "points");
  for (std::size_t k = 0; k < curve.pins.size(); ++k) {
    require(curve.pins[k] < n && (k == 0 || curve.pins[k - 1] < curve.pins[k]), "pins");
  }
  if (const auto* positions = std::get_if<std::vector<Point>>(&curve.points)) {
    for (const Point& p : *positions) require(p.allFinite(), "finite coordinates");
  } else if (const auto* places = std::get_if<std::vector<FaceCoordinates>>(&curve.points)) {
    for (const FaceCoordinates& at : *places) {
      for (const double b : at.barycentric) require(std::isfinite(b), "finite barycentrics");
    }
  } else if (const auto* between = std::get_if<std::vector<CornerCoordinates>>(&curve.points)) {
    for (const CornerCoordinates& at : *between) {
      for (const double w : at.weights) require(std::isfinite(w) && w >= 0, "weights");
    }
  }
  for (const std::string& sentence : curve.notes) {
    for (const char c : sentence) require(c >= ' ' && c <= '~', "printable sentences");
  }
}

}  // namespace

void read_curve_bytes(const Target& target, const std::uint8_t* data, std::size_t size) {
  try {
    const std::vector<CurveInput> curves = read_curves(target.file, text_of(data, size));
    require(!curves.empty(), "curves");
    for (const CurveInput& curve : curves) check_curve(curve);
  } catch (const Error& error) {
    check_refusal(target, error);
  }
}

void read_click_bytes(const Target& target, const std::uint8_t* data, std::size_t size) {
  try {
    check_curve(read_clicks(target.file, text_of(data, size)));
  } catch (const Error& error) {
    check_refusal(target, error);
  }
}

void read_label_bytes(const Target& target, const std::uint8_t* data, std::size_t size) {
  try {
    const LabelFile file = read_label_file(target.file, text_of(data, size), {"", 10});
    // The label of a polygon is repeated for each triangle of its fan; a .label file gives a label
    // to each of ten vertices.
    require(file.labels.size() <= size + 10, "no more labels than bytes");
    for (const auto& [label, name] : file.names) {
      for (const char c : name) require(c >= ' ' && c <= '~', "printable names");
    }
  } catch (const Error& error) {
    check_refusal(target, error);
  }
}

void read_field_bytes(const Target& target, const std::uint8_t* data, std::size_t size) {
  try {
    const std::vector<double> values = read_field_values(target.file, text_of(data, size));
    require(values.size() <= size, "no more values than bytes");
  } catch (const Error& error) {
    check_refusal(target, error);
  }
}

}  // namespace talweg::fuzz
