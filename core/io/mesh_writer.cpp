#include "talweg/core/io/mesh_writer.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/mesh_bytes.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace formats {

std::string off_bytes(MeshContent& content) {
  const MeshLists& lists = content.lists;
  std::string text = fmt::format("OFF\n{} {} 0\n", lists.points.size(), content.face_count());
  const auto out = std::back_inserter(text);
  for (const Point& p : lists.points) fmt::format_to(out, "{} {} {}\n", p.x(), p.y(), p.z());
  std::array<PolygonCorner, 3> own;
  for (std::size_t f = 0; f < content.face_count(); ++f) {
    const auto face = content.face(f, own);
    fmt::format_to(out, "{}", face.size());
    for (const PolygonCorner& at : face) fmt::format_to(out, " {}", content.vertex(at));
    text += '\n';
  }
  return text;
}

std::string stl_bytes(MeshContent& content) {
  const MeshLists& lists = content.lists;
  std::string bytes(80, ' ');
  if (lists.space != PatientSpace::kNotSaid) {
    const std::string note = fmt::format("Talweg. SPACE={}", space_name(lists.space));
    bytes.replace(0, note.size(), note);
  }
  bytes.reserve(84 + 50 * lists.triangles.size());
  put(bytes, static_cast<std::uint32_t>(lists.triangles.size()));
  const auto put_point = [&](const Point& p) {
    for (const double x : p) put(bytes, static_cast<float>(x));
  };
  for (const Triangle& t : lists.triangles) {
    const Point& a = lists.points[t[0]];
    const Point& b = lists.points[t[1]];
    const Point& c = lists.points[t[2]];
    put_point((b - a).cross(c - a).stableNormalized());
    for (const Point* p : {&a, &b, &c}) put_point(*p);
    put(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace formats

namespace {

void check_indices(const MeshLists& lists) {
  for (std::size_t f = 0; f < lists.triangles.size(); ++f) {
    for (const std::uint32_t v : lists.triangles[f]) {
      if (v < lists.points.size()) continue;
      throw Error(ErrorCode::kBadMesh,
                  fmt::format("Face {} refers to vertex {}, but there are only {} vertices.", f, v,
                              lists.points.size()));
    }
  }
}

void check_outlines(const std::filesystem::path& name, const MeshLists& lists,
                    const FaceOutlines& outlines) {
  const std::string extension = lower_extension(name);
  if (extension == ".stl" || extension == ".vtk" || extension == ".vtp") {
    throw Error(ErrorCode::kBadUsage,
                fmt::format("{} cannot hold polygons, as these files are written with triangles "
                            "only; .obj, .off and .ply hold them.",
                            name.string()));
  }
  for (std::size_t f = 0; f < outlines.size(); ++f) {
    const auto face = outlines.face(f);
    const bool exists = std::all_of(face.begin(), face.end(), [&](const PolygonCorner& at) {
      return at.triangle < lists.triangles.size() && at.corner < 3;
    });
    if (exists && face.size() >= 3) continue;
    throw Error(
        ErrorCode::kBadUsage,
        fmt::format("Polygon {} has fewer than three corners, or a corner of a triangle that "
                    "does not exist.",
                    f));
  }
}

void check_attributes(const MeshLists& lists, const MeshAttributes& attributes) {
  const auto check = [](const std::string& name, std::size_t given, std::size_t expected) {
    if (given == expected) return;
    throw Error(ErrorCode::kBadUsage,
                fmt::format("There are {} values of '{}' instead of {}.", given, name, expected));
  };
  for (const AttributeColumn& c : attributes.vertices) {
    check(c.name, c.values.size(), lists.points.size());
  }
  const std::size_t faces = lists.triangles.size();
  for (const AttributeColumn& c : attributes.faces) check(c.name, c.values.size(), faces);
  for (const FaceNames& n : attributes.names) check(n.keyword, n.of_face.size(), faces);
  for (const CornerAttribute* a : {&attributes.texture, &attributes.normals}) {
    if (a->dimension > 0) check("corners", a->corners.size(), faces);
  }
}

/// Descriptions of all attributes and edges, for a format that holds none.
std::vector<std::string> all_of(const MeshAttributes& attributes, bool has_edges) {
  std::vector<std::string> all;
  for (const AttributeColumn& c : attributes.vertices)
    all.push_back(fmt::format("'{}' of vertices", c.name));
  for (const AttributeColumn& c : attributes.faces)
    all.push_back(fmt::format("'{}' of faces", c.name));
  for (const FaceNames& n : attributes.names)
    all.push_back(fmt::format("names of faces ({})", n.keyword));
  if (attributes.texture.dimension > 0) all.emplace_back("texture coordinates");
  if (attributes.normals.dimension > 0) all.emplace_back("normals");
  for (const std::string& line : attributes.references) all.push_back(fmt::format("'{}'", line));
  if (has_edges) all.emplace_back("edges of curves");
  return all;
}

using Bytes = std::string (*)(formats::MeshContent&);

/// The writer for the extension of a name; null if there is none.
Bytes bytes_of(const std::filesystem::path& name) {
  const std::string extension = lower_extension(name);
  if (extension == ".obj") return &formats::obj_bytes;
  if (extension == ".off") return &formats::off_bytes;
  if (extension == ".ply") return &formats::ply_bytes;
  if (extension == ".stl") return &formats::stl_bytes;
  if (extension == ".vtk") return &formats::vtk_bytes;
  if (extension == ".vtp") return &formats::vtp_bytes;
  return nullptr;
}

}  // namespace

void write_mesh(const std::filesystem::path& path, const MeshLists& lists) {
  write_mesh(path, lists, {});
}

std::vector<std::string> write_mesh(const std::filesystem::path& path, const MeshLists& lists,
                                    const MeshAttributes& attributes,
                                    std::span<const TaggedEdge> edges,
                                    const FaceOutlines* outlines) {
  MeshBytes file = mesh_bytes(path, lists, attributes, edges, outlines);
  write_file(path, file.bytes);
  return std::move(file.left_out);
}

MeshBytes mesh_bytes(const std::filesystem::path& name, const MeshLists& lists,
                     const MeshAttributes& attributes, std::span<const TaggedEdge> edges,
                     const FaceOutlines* outlines) {
  check_mesh_name(name);
  const Bytes bytes = bytes_of(name);
  check_indices(lists);
  check_attributes(lists, attributes);
  if (outlines != nullptr) check_outlines(name, lists, *outlines);
  formats::MeshContent content{lists, attributes, edges, {}, outlines};
  if (bytes == &formats::off_bytes || bytes == &formats::stl_bytes) {
    content.left_out = all_of(attributes, !edges.empty());
  }
  if (bytes == &formats::off_bytes && lists.space != PatientSpace::kNotSaid) {
    content.left_out.push_back(
        fmt::format("the space of coordinates ({})", space_name(lists.space)));
  }
  MeshBytes file;
  file.bytes = bytes(content);
  file.left_out = std::move(content.left_out);
  return file;
}

void check_mesh_name(const std::filesystem::path& name) {
  if (bytes_of(name) == nullptr) {
    cannot_write(name, "its name does not end in .obj, .off, .ply, .stl, .vtk or .vtp");
  }
}

}  // namespace talweg
