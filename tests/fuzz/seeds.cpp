// One or two valid files of every format and encoding, small enough for changes byte by byte.
#include <algorithm>
#include <cstring>

#include <zlib.h>

#include "fuzz_target.hpp"
#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg::fuzz {
namespace {

template <class T>
void put(std::string& bytes, T value, bool swap = false) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (swap) std::reverse(raw, raw + sizeof value);
  bytes.append(raw, sizeof value);
}

// A pyramid: five vertices, four triangles and a square.
constexpr float kPoints[5][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5F, 0.5F, 1}};
constexpr std::uint32_t kSides[4][3] = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

std::string obj() {
  return "# pyramid\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0 0.5 0.5 0.5\nvt 0 0\nvn 0 0 1\nv .5 .5 1\n"
         "g sides\nf 1 2 5\nf 2/1 3/1 5/1\nf 3//1 4//1 5//1\nf -2 1 \\\n-1\nf 4 3 2 1\n";
}
std::string off() {
  return "OFF\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0 # corner\n0.5 0.5 1e0\n3 0 1 4\n3 1 2 4 255 0 0\n"
         "3 2 3 4\n3 3 0 4\n4 3 2 1 0\n";
}

std::string ply_header(const char* format) {
  return std::string("ply\nformat ") + format +
         " 1.0\ncomment pyramid\nelement vertex 5\nproperty float x\nproperty float y\nproperty "
         "float z\nproperty uchar red\nelement face 4\nproperty list uchar int vertex_indices\n"
         "end_header\n";
}
std::string ply_text() {
  return ply_header("ascii") +
         "0 0 0 255\n1 0 0 255\n1 1 0 0\n0 1 0 7\n0.5 0.5 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n4 3 0 4 "
         "1\n";
}
std::string ply_binary(bool big) {
  std::string bytes = ply_header(big ? "binary_big_endian" : "binary_little_endian");
  for (const auto& p : kPoints) {
    for (const float x : p) put(bytes, x, big);
    bytes.push_back(7);
  }
  for (const auto& t : kSides) {
    bytes.push_back(3);
    for (const std::uint32_t v : t) put(bytes, v, big);
  }
  return bytes;
}
std::string ply_strips() {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
         "float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
         "0 0 0\n1 0 0\n0 1 0\n0 0 1\n8 0 1 2 3 -1 0 3 1\n";
}

std::string stl_text() {
  std::string text = "solid pyramid\n";
  for (int f = 0; f < 2; ++f) {
    text += "facet normal 0 0 1\nouter loop\n";
    for (int k = 0; k < 3; ++k) {
      text += "vertex " + std::to_string(k % 2) + " " + std::to_string(k / 2 + f) + " 0\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid pyramid\n";
}
std::string stl_binary() {
  std::string bytes(80, ' ');
  put(bytes, std::uint32_t{4});
  for (const auto& t : kSides) {
    bytes.append(12, '\0');
    for (const std::uint32_t v : t) {
      for (const float x : kPoints[v]) put(bytes, x);
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

/// The head of a chunk: entity, type, bits of integers or floats.
void put_chunk(std::string& bytes, unsigned entity, unsigned type, unsigned is_float,
               unsigned dimensions, unsigned code) {
  put(bytes, static_cast<std::uint16_t>(entity << 2U | type << 5U | is_float << 10U |
                                        (dimensions - 1) << 11U | code << 14U));
}
std::string om_header(char version, std::uint32_t vertices, std::uint32_t faces,
                      std::uint32_t edges) {
  std::string bytes = std::string("OMT") + version;
  for (const std::uint32_t n : {vertices, faces, edges}) put(bytes, n);
  put_chunk(bytes, 0, 0, 1, 3, 0);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    for (const float x : kPoints[v]) put(bytes, x);
  }
  return bytes;
}
std::string om_faces() {
  std::string bytes = om_header('\x20', 5, 4, 8);
  put_chunk(bytes, 2, 7, 0, 1, 0);
  for (const auto& t : kSides) {
    for (const std::uint32_t v : t) bytes.push_back(static_cast<char>(v));
  }
  return bytes;
}
/// One triangle: halfedges 0, 2, 4 inside it and 1, 3, 5 around it.
std::string om_halfedges() {
  std::string bytes = om_header('\x40', 3, 1, 3);
  put_chunk(bytes, 6, 7, 0, 1, 0);
  for (const int value : {2, 1, 0, 5, 0, -1, 4, 2, 0, 1, 1, -1, 0, 0, 0, 3, 2, -1}) {
    bytes.push_back(static_cast<char>(value));
  }
  put_chunk(bytes, 2, 7, 0, 1, 0);
  bytes.push_back(0);
  return bytes;
}

std::string off_binary() {
  std::string bytes = "OFF BINARY\n";
  for (const int n : {5, 2, 0}) put(bytes, n, true);
  for (const auto& p : kPoints) {
    for (const float x : p) put(bytes, x, true);
  }
  for (const int n : {3, 0, 1, 4, 0, 4, 3, 2, 1, 0, 3}) put(bytes, n, true);
  for (int k = 0; k < 3; ++k) put(bytes, 0.5F, true);
  return bytes;
}

/// The sides of the pyramid with attributes, from Talweg's writer.
std::string written(const std::string& name) {
  MeshLists lists;
  for (const auto& p : kPoints) lists.points.emplace_back(p[0], p[1], p[2]);
  for (const auto& t : kSides) lists.triangles.push_back({t[0], t[1], t[2]});
  MeshAttributes attributes;
  for (const char* column : {"nx", "ny", "nz"}) {
    attributes.vertices.push_back({column, NumberType::kFloat32, {0, 0, 1, 0, 1}});
  }
  attributes.faces.push_back({"label", NumberType::kInt16, {1, 1, 2, 2}});
  const TaggedEdge edge{0, 1, 0};
  return mesh_bytes(name, lists, attributes, {&edge, 1}).bytes;
}

std::string vtk_text() {
  return "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
         "0 0 0 1 0 0 1 1 0\n0 1 0\nVERTICES 1 2\n1 0\nPOLYGONS 1 5\n4 0 1 2 3\n"
         "TRIANGLE_STRIPS 1 5\n4 0 1 3 2\nCELL_DATA 3\nSCALARS label int\n"
         "LOOKUP_TABLE default\n1 2 3\nPOINT_DATA 4\nFIELD f 1\na%20b 2 4 double\n"
         "1 2 3 4 5 6 7 nan\n";
}

std::string vtp_mesh() {
  return "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\">"
         "<PointData><DataArray type=\"UInt8\" Name=\"RGB\" NumberOfComponents=\"3\" "
         "format=\"ascii\">1 2 3 4 5 6 7 8 9</DataArray></PointData><Points><DataArray "
         "type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0"
         "</DataArray></Points><Polys><DataArray type=\"Int32\" Name=\"connectivity\" "
         "format=\"ascii\">0 1 2</DataArray><DataArray type=\"Int32\" Name=\"offsets\" "
         "format=\"ascii\">3</DataArray></Polys></Piece></PolyData></VTKFile>";
}

std::string msh2(bool binary) {
  const std::string names = "$PhysicalNames\n1\n2 7 \"skin\"\n$EndPhysicalNames\n";
  if (!binary) {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names +
           "$Nodes\n4\n10 0 0 0\n3 1 0 0\n7 1 1 0\n8 0 1 0\n$EndNodes\n$Elements\n3\n"
           "1 1 2 5 1 10 3\n2 2 2 7 1 3 8 7\n3 3 0 10 3 7 8\n$EndElements\n";
  }
  std::string bytes = "$MeshFormat\n2.2 1 8\n";
  put(bytes, 1);
  bytes += "\n$EndMeshFormat\n" + names + "$Nodes\n3\n";
  for (int k = 0; k < 3; ++k) {
    put(bytes, k + 1);
    for (const float x : kPoints[k]) put(bytes, static_cast<double>(x));
  }
  bytes += "\n$EndNodes\n$Elements\n1\n";
  for (const int n : {2, 1, 2, 1, 7, 1, 1, 2, 3}) put(bytes, n);
  return bytes + "\n$EndElements\n";
}

std::string msh4() {
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n1 0 1 0\n1 0 0 0 0\n"
         "1 0 0 0 1 1 0 1 7 0\n$EndEntities\n$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n5\n0 0 0\n"
         "1 0 0\n0 1 0\n$EndNodes\n$Elements\n1 1 1 1\n2 1 2 1\n1 1 2 5\n$EndElements\n";
}

std::string base64(const std::string& bytes);

std::string gltf_buffer() {
  std::string bytes;
  for (int k = 0; k < 3; ++k) {
    for (const float x : kPoints[k]) put(bytes, x);
  }
  for (const int v : {0, 1, 2, 0}) put(bytes, static_cast<std::uint16_t>(v));
  return bytes;
}

std::string gltf(bool inside) {
  const std::string uri =
      inside ? R"(,"uri":"data:;base64,)" + base64(gltf_buffer()) + "\"" : std::string();
  return R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0,"scale":[2,1,-1],"children":[1]},{}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
         R"("buffers":[{"byteLength":44)" +
         uri +
         R"(}],"bufferViews":[{"buffer":0,"byteLength":36},)"
         R"({"buffer":0,"byteOffset":36,"byteLength":8}],"accessors":[)"
         R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
         R"({"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}]})";
}

std::string glb() {
  std::string text = gltf(false), bytes = "glTF";
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string data = gltf_buffer();
  for (const std::size_t n : {std::size_t{2}, 28 + text.size() + data.size(), text.size()}) {
    put(bytes, static_cast<std::uint32_t>(n));
  }
  bytes += "JSON" + text;
  put(bytes, static_cast<std::uint32_t>(data.size()));
  bytes += std::string("BIN\0", 4);
  return bytes + data;
}

/// An archive with only the model, stored.
std::string three_mf() {
  const std::string name = "3D/3dmodel.model";
  const std::string model =
      "<model unit=\"inch\"><resources><object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"0\" "
      "z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"1\" z=\"0\"/></vertices>"
      "<triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh></object></resources>"
      "<build><item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 5\"/></build></model>";
  const auto size = static_cast<std::uint32_t>(model.size());
  const auto sum = static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(model.data()), static_cast<uInt>(size)));
  const auto head = [&](std::string& bytes) {
    for (int k = 0; k < 4; ++k) put(bytes, std::uint16_t{0});  // flags, method, time, date
    for (const std::uint32_t x : {sum, size, size}) put(bytes, x);
    put(bytes, static_cast<std::uint16_t>(name.size()));
    put(bytes, std::uint16_t{0});
  };
  std::string bytes("PK\3\4\x14\0", 6);
  head(bytes);
  bytes += name + model;
  const auto at = static_cast<std::uint32_t>(bytes.size());
  bytes += std::string("PK\1\2\x14\0\x14\0", 8);
  head(bytes);
  bytes += std::string(14, '\0') + name;  // the offset of the file is 0
  const auto length = static_cast<std::uint32_t>(bytes.size()) - at;
  bytes += std::string("PK\5\6\0\0\0\0\1\0\1\0", 12);
  put(bytes, length);
  put(bytes, at);
  return bytes + std::string(2, '\0');
}

std::vector<PlacedCurve> two_curves() {
  std::vector<PlacedCurve> curves;
  for (const bool closed : {false, true}) {
    PlacedCurve curve;
    curve.closed = closed;
    for (std::size_t k = 0; k < 3; ++k) {
      curve.positions.emplace_back(static_cast<double>(k), closed ? 1 : 0, k * k);
      curve.faces.push_back({FaceId{k}, {0.5, 0.25, 0.25}});
      curve.vertices.emplace_back(k + (closed ? 4 : 0));
    }
    if (closed) curve.exact = {0, 0.25, -2};  // a click, an inexact click, a painted point
    curves.push_back(curve);
  }
  return curves;
}

std::string base64(const std::string& bytes) {
  static const char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const unsigned char c = k + i < bytes.size() ? static_cast<unsigned char>(bytes[k + i]) : 0;
      bits = bits << 8U | c;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text.push_back(k + i > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * i) & 63U]);
    }
  }
  return text;
}

/// An array in the encoding of VTK: the size and the data, or one packed block.
std::string vtk_block(const std::string& data, bool packed) {
  std::string head;
  if (!packed) {
    put(head, static_cast<std::uint32_t>(data.size()));
    return head + data;
  }
  std::string zipped(compressBound(data.size()), '\0');
  uLongf length = zipped.size();
  compress(reinterpret_cast<Bytef*>(zipped.data()), &length,
           reinterpret_cast<const Bytef*>(data.data()), data.size());
  zipped.resize(length);
  for (const std::size_t n : {std::size_t{1}, data.size(), std::size_t{0}, zipped.size()}) {
    put(head, static_cast<std::uint32_t>(n));
  }
  return head + zipped;
}

/// Three points and one line; `how`: inline base64, raw at the end, base64 packed by zlib.
std::string vtp(int how) {
  std::string points, line, ends;
  for (const double x : {0., 0., 0., 1., 0., 0., 1., 1., 0.}) put(points, x);
  for (const std::int32_t v : {0, 1, 2}) put(line, v);
  put(ends, std::int32_t{3});
  std::string appended;
  const auto array = [&](const char* type, const char* name, const std::string& data) {
    const std::string block = vtk_block(data, how == 2);
    std::string text = std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\"";
    if (how == 1) {
      text += " format=\"appended\" offset=\"" + std::to_string(appended.size()) + "\"/>";
      appended += block;
      return text;
    }
    // VTK encodes the head and the data separately.
    const std::size_t head = how == 2 ? 16 : 4;
    return text + " format=\"binary\">" + base64(block.substr(0, head)) +
           base64(block.substr(head)) + "</DataArray>";
  };
  std::string text =
      "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" header_type=\"UInt32\"";
  if (how == 2) text += " compressor=\"vtkZLibDataCompressor\"";
  text += "><PolyData><Piece NumberOfPoints=\"3\" NumberOfLines=\"1\"><Points>";
  text += array("Float64", "Points", points) + "</Points><Lines>";
  text += array("Int32", "connectivity", line) + array("Int32", "offsets", ends);
  text += "</Lines></Piece></PolyData>";
  if (how == 1) text += "<AppendedData encoding=\"raw\">_" + appended + "</AppendedData>";
  return text + "</VTKFile>";
}

std::string vtk_binary() {
  std::string bytes = "# vtk DataFile Version 5.1\nx\nBINARY\nDATASET POLYDATA\nPOINTS 3 float\n";
  for (int k = 0; k < 3; ++k) {
    for (const float x : kPoints[k]) put(bytes, x, true);
  }
  bytes += "\nLINES 2 3\nOFFSETS vtktypeint64\n";
  for (const std::int64_t x : {0, 3}) put(bytes, x, true);
  bytes += "\nCONNECTIVITY vtktypeint64\n";
  for (const std::int64_t x : {0, 1, 2}) put(bytes, x, true);
  return bytes + "\n";
}

std::string curve_ply_binary() {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\nproperty float "
      "y\nproperty list uchar float extra\nproperty int z\nelement edge 2\nproperty uint vertex1\n"
      "property short vertex2\nend_header\n";
  for (std::int32_t k = 0; k < 3; ++k) {
    put(bytes, double{0.5} * k);
    put(bytes, 1.0F);
    bytes.push_back(1);
    put(bytes, 2.0F);
    put(bytes, k);
  }
  for (std::uint32_t k = 0; k < 2; ++k) {
    put(bytes, k);
    put(bytes, static_cast<std::int16_t>(k + 1));
  }
  return bytes;
}

std::string gifti_array(const char* intent, const char* type, const char* rows,
                        const char* encoding, const std::string& data) {
  return std::string("<DataArray Intent=\"NIFTI_INTENT_") + intent + "\" DataType=\"NIFTI_TYPE_" +
         type + "\" Dimensionality=\"2\" Dim0=\"" + rows + "\" Dim1=\"3\" Encoding=\"" + encoding +
         "\" Endian=\"LittleEndian\"><Data>" + data + "</Data></DataArray>";
}
std::string gifti_text() {
  return "<GIFTI>" + gifti_array("POINTSET", "FLOAT32", "4", "ASCII", "0 0 0 1 0 0 0 1 0 0 0 1.5") +
         gifti_array("TRIANGLE", "INT32", "2", "ASCII", "0 2 1 0 1 3") + "</GIFTI>";
}
/// The first array is plain base64, the second is packed by zlib.
std::string gifti_packed() {
  return "<GIFTI>" +
         gifti_array("POINTSET", "FLOAT32", "4", "Base64Binary",
                     "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAMA/") +
         gifti_array("TRIANGLE", "INT32", "4", "GZipBase64Binary",
                     "eJxjYGBgYAJiRgYIANHMUJoJymaCyoHYAAG4ABM=") +
         "</GIFTI>";
}
std::string freesurfer_triangles() {
  std::string bytes = "\xFF\xFF\xFEmade\n\n";
  for (const std::int32_t count : {5, 4}) put(bytes, count, true);
  for (const auto& p : kPoints) {
    for (const float x : p) put(bytes, x, true);
  }
  for (const auto& t : kSides) {
    for (const std::uint32_t v : t) put(bytes, v, true);
  }
  return bytes;
}
std::string freesurfer_quads() {
  std::string bytes("\xFF\xFF\xFF\0\0\4\0\0\1", 9);
  for (int k = 0; k < 12; ++k) put(bytes, static_cast<std::int16_t>(100 * k % 250), true);
  return bytes + std::string("\0\0\0\0\0\1\0\0\2\0\0\3", 12);
}

}  // namespace

std::vector<std::string> mesh_seeds(const Target& target) {
  if (target.name == "mesh_obj") return {obj(), "# SPACE=RAS\n" + obj()};
  if (target.name == "mesh_off") return {off(), off_binary()};
  if (target.name == "mesh_vtk") {
    return {written(target.file), vtk_text(),
            "# vtk DataFile Version 2.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
            "0 0 0 1 0 0 1 1 0 0 1 0\nCELLS 2 8\n3 0 1 2\n3 0 2 3\nCELL_TYPES 2\n5 5\n"};
  }
  if (target.name == "mesh_vtp") return {written(target.file), vtp_mesh()};
  if (target.name == "mesh_msh") return {msh2(false), msh2(true), msh4()};
  if (target.name == "mesh_gltf") return {gltf(true), glb()};
  if (target.name == "mesh_3mf") return {three_mf()};
  if (target.name == "mesh_ply")
    return {ply_text(), ply_binary(false), ply_binary(true), ply_strips()};
  if (target.name == "mesh_stl") return {stl_text(), stl_binary()};
  if (target.name == "mesh_gifti") return {gifti_text(), gifti_packed()};
  if (target.name == "mesh_freesurfer") return {freesurfer_triangles(), freesurfer_quads()};
  return {om_faces(), om_halfedges()};
}

std::vector<std::string> curve_seeds(const Target& target) {
  const std::vector<PlacedCurve> curves = two_curves();
  if (target.name == "curve_obj")
    return {formats::write_obj(curves), "v 0 0 0\nv 1 0 0\nl -2 -1\n"};
  if (target.name == "curve_ply") return {formats::write_ply(curves), curve_ply_binary()};
  if (target.name == "curve_vtp")
    return {formats::write_vtp(curves), formats::write_vtp(curves, {}, PatientSpace::kRas), vtp(0),
            vtp(1), vtp(2)};
  if (target.name == "curve_vtk") return {formats::write_vtk(curves), vtk_binary()};
  if (target.name == "curve_txt") return {formats::write_txt("c.txt", curves), "0,1 2 # here\n\n3"};
  if (target.name == "curve_json") return {formats::write_json(curves)};
  if (target.name == "curve_border") {
    return {
        "<BorderFile Version=\"3\" SurfaceNumberOfVertices=\"4\"><Class><Border><BorderPart "
        "Closed=\"True\"><Vertices>0 1 2 3 2 1</Vertices><Weights>0.5 0.25 0.25 0 1 0</Weights>"
        "</BorderPart></Border></Class></BorderFile>"};
  }
  if (target.name == "curve_fcsv") {
    return {formats::write_fcsv("c.fcsv", std::span(curves).first(1), {}),
            "# CoordinateSystem = 0\n# columns = label,x,y,z,sel,vis\n\"a, \"\"b\",1,2,3,1,1\n"};
  }
  if (target.name == "clicks") {
    return {formats::write_slicer(std::span(curves).first(1), {}),
            R"({"markups": [{"type": "Fiducial", "coordinateSystem": "RAS", "controlPoints":
[{"position": [1, 2, 3]}, {"positionStatus": "undefined"}]}]})"};
  }
  return {formats::write_slicer(curves, {})};
}

std::vector<std::string> label_seeds(const Target& target) {
  if (target.name == "label_annot") {
    std::string bytes;
    const auto number = [&](std::int32_t value) { put(bytes, value, true); };
    const auto text = [&](std::string_view name) {
      number(static_cast<std::int32_t>(name.size() + 1));
      bytes.append(name).push_back('\0');
    };
    for (const std::int32_t value : {2, 0, 0x030201, 1, 0, 1, -2, 1}) number(value);
    text("table");
    for (const std::int32_t value : {1, 0}) number(value);
    text("motor");
    for (const std::int32_t value : {1, 2, 3, 0}) number(value);
    return {bytes, bytes.substr(0, 20)};
  }
  if (target.name == "label_list") return {"#!ascii label\n2\n1 0.5 1e0 -2 0\n4 0 0 0 1\n"};
  if (target.name == "label_ply") {
    std::string text = ply_text(), binary = ply_binary(true);
    for (std::string* bytes : {&text, &binary}) {
      bytes->replace(bytes->find("uchar red"), 9, "uchar label");
    }
    return {text, binary};
  }
  if (target.name == "label_gifti") {
    return {
        "<GIFTI><LabelTable><Label Key=\"1\" Red=\"0.5\">one</Label></LabelTable><DataArray "
        "Intent=\"NIFTI_INTENT_LABEL\" DataType=\"NIFTI_TYPE_INT32\" Dimensionality=\"1\" "
        "Dim0=\"3\" Encoding=\"ASCII\"><Data>1 2 1</Data></DataArray></GIFTI>"};
  }
  if (target.name == "label_csv") return {"vertex,label\n0,5\n2,7\n1,6.0\n", "label\n1\n\"2\"\n"};
  if (target.name == "label_dpv") return {"000 0 0 0 5\n001 1 0 0.5 -1.0\n"};
  if (target.name == "label_npy") {
    std::string bytes("\x93NUMPY\x01\x00", 8);
    const std::string header = "{'descr': '<i2', 'fortran_order': False, 'shape': (3,), }\n";
    put(bytes, static_cast<std::uint16_t>(header.size()));
    return {bytes + header + std::string("\1\0\2\0\3\0", 6)};
  }
  if (target.name == "field_curv") {
    std::string bytes = "\xFF\xFF\xFF";
    for (const std::int32_t number : {2, 1, 1}) put(bytes, number, true);
    for (const float value : {0.5F, -1.0F}) put(bytes, value, true);
    return {bytes, std::string("\0\0\2\0\0\1\0\x32\xFF\x9C", 10)};
  }
  if (target.name == "label_vtk") {
    const std::string head = "# vtk DataFile Version 3.0\nlabels\n";
    const std::string data = "CELL_DATA 2\nSCALARS label int 1\nLOOKUP_TABLE default\n";
    return {head + "ASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\nPOLYGONS 1 4\n3 0 0 0\n" +
                data + "1 2\nPOINT_DATA 1\nFIELD f 1\nregion 1 1 int\n7\n",
            head + "BINARY\nDATASET POLYDATA\n" + data + std::string(8, '\1')};
  }
  return {
      "<VTKFile type=\"PolyData\"><PolyData><Piece><CellData><DataArray type=\"Int32\" "
      "Name=\"label\" format=\"ascii\">1 2</DataArray></CellData></Piece></PolyData></VTKFile>"};
}

}  // namespace talweg::fuzz
