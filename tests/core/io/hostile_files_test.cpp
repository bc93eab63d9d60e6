// Hostile files: false sizes, truncation, deep nesting, binary data as text. Each gives one error
// with the place, and no memory for data that do not exist.
#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "core/temporary_folder.hpp"
#include "memory_limits.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {
namespace {

using namespace std::string_view_literals;
using namespace std::string_literals;

/// Expects an Error(kBadFile) with the name of the file and these words.
template <class Read>
void expect_refused(Read read, std::string_view name, std::string_view bytes,
                    std::initializer_list<const char*> words) {
  try {
    read(std::filesystem::path(name), bytes);
    ADD_FAILURE() << name << " was taken";
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_EQ(error.code(), ErrorCode::kBadFile) << what;
    EXPECT_NE(what.find(name), what.npos) << what;
    for (const char* word : words) EXPECT_NE(what.find(word), what.npos) << what << "\n" << word;
    EXPECT_LT(what.size(), 300U);
  }
}

void expect_bad_mesh(std::string_view name, std::string_view bytes,
                     std::initializer_list<const char*> words) {
  expect_refused([](const auto& path, auto all) { return read_mesh(path, all); }, name, bytes,
                 words);
}
void expect_bad_curve(std::string_view name, std::string_view bytes,
                      std::initializer_list<const char*> words) {
  expect_refused([](const auto& path, auto all) { return read_curves(path, all); }, name, bytes,
                 words);
}

template <class T>
std::string raw(std::initializer_list<T> values) {
  std::string bytes;
  for (const T value : values) {
    char four[sizeof value];
    std::memcpy(four, &value, sizeof value);
    bytes.append(four, sizeof value);
  }
  return bytes;
}

/// Limits the address space of the process to 4 GiB during its lifetime, too little for any false
/// size.
class LittleMemory {
 public:
  LittleMemory() {
    getrlimit(RLIMIT_AS, &before_);
    rlimit limit = before_;
    limit.rlim_cur = rlim_t{1} << 32U;
    if (test::kMemoryCanBeLimited) setrlimit(RLIMIT_AS, &limit);
  }
  ~LittleMemory() { setrlimit(RLIMIT_AS, &before_); }
  LittleMemory(const LittleMemory&) = delete;
  LittleMemory& operator=(const LittleMemory&) = delete;

 private:
  rlimit before_{};
};

const std::string kPlyVertices =
    "property float x\nproperty float y\nproperty float z\nelement face 1\n"
    "property list uint int vertex_indices\nend_header\n";

TEST(HostileFiles, FalseSizesTakeNoMemory) {
  const LittleMemory little;
  const std::string vertices = "element vertex 4000000000\n" + kPlyVertices;
  expect_bad_mesh("a.ply", "ply\nformat ascii 1.0\n" + vertices + "0 0 0\n", {"vertex 1 of 4000"});
  expect_bad_mesh("a.ply", "ply\nformat binary_little_endian 1.0\n" + vertices + "123456789012",
                  {"ends in vertex 1 of 4000000000"});
  expect_bad_mesh("a.ply",
                  "ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + kPlyVertices +
                      std::string(12, '\0') + raw({0xFFFFFFFFU, 0U, 0U, 0U}),
                  {"ends in face 0 of 1"});
  expect_bad_mesh("a.ply", "ply\nformat ascii 1.0\nelement vertex -3\n" + kPlyVertices,
                  {"line 3", "negative"});
  expect_bad_mesh("a.off", "OFF\n4000000000 4000000000 0\n0 0 0\n", {"vertex 1 of 4000000000"});
  expect_bad_mesh("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n",
                  {"line 6", "end of the line"});
  expect_bad_mesh("a.stl", std::string(80, ' ') + raw({0xFFFFFFFFU}), {"4294967295 triangles"});
  expect_bad_mesh("a.om", "OMT\x20"s + raw({0x7FFFFFFFU, 1U, 3U}), {"2147483647 vertices"});
  expect_bad_mesh("a.off", "OFF BINARY\n\x7F\xFF\xFF\xFF\x7F\xFF\xFF\xFF\0\0\0\0"s,
                  {"vertex 0 of"});
  const std::string vtk = "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET POLYDATA\n";
  expect_bad_mesh("a.vtk", vtk + "POINTS 4000000000 float\n0000", {"byte ", "12000000000"});
  expect_bad_mesh("a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4000000000\n1 0 0 0\n",
                  {"line 5", "4000000000 nodes"});
  expect_bad_mesh(
      "a.msh",
      "$MeshFormat\n4.1 1 8\n" + raw({1}) + "\n$EndMeshFormat\n$Nodes\n" +
          raw({std::uint64_t{1}, std::uint64_t{1} << 62U, std::uint64_t{1}, std::uint64_t{1}}),
      {"byte ", "nodes are announced"});
  expect_bad_mesh("a.glb", "glTF" + raw({2U, 100U, 0xFFFFFFFFU}) + "JSON{}", {"chunk"});
  // A header with sizes that the length of the file allows, but not the positions.
  expect_bad_mesh("a.om",
                  "OMT\x20"s + raw({999'999U, 1U, 3U}) + raw({std::uint16_t{0x1400}}) +
                      std::string(1'000'000, '\0'),
                  {"ends in the positions"});
}

TEST(HostileFiles, FalseSizesOfCurveFilesTakeNoMemory) {
  const LittleMemory little;
  expect_bad_curve("a.ply",
                   "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty "
                   "float y\nproperty float z\nelement edge 1\nproperty int vertex1\nproperty int "
                   "vertex2\nend_header\n0 0 0\n",
                   {"line ", "4000000000"});
  const std::string vtk = "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET POLYDATA\n";
  expect_bad_curve("a.vtk", vtk + "POINTS 4000000000 float\n0000", {"byte ", "12000000000"});
  expect_bad_curve("a.vtk", vtk + "FIELD f 1\nx 4000000000 4000000000 float\n0000", {"byte "});
  const std::string vtp =
      "<VTKFile type=\"PolyData\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">"
      "<PolyData><Piece NumberOfPoints=\"1\" NumberOfLines=\"1\"><Points><DataArray "
      "type=\"Float32\" format=\"appended\" offset=\"0\"/></Points><Lines/></Piece></PolyData>"
      "<AppendedData encoding=\"raw\">_";
  constexpr std::uint64_t kMany = std::uint64_t{1} << 62U;
  for (const std::string& sizes :
       {raw({kMany, kMany, kMany, kMany}), raw({std::uint64_t{1}, kMany, std::uint64_t{0}, kMany}),
        raw({std::uint64_t{1}, kMany, std::uint64_t{0}, std::uint64_t{8}}) + "12345678"}) {
    expect_bad_curve("a.vtp", vtp + sizes + "</AppendedData></VTKFile>", {"line 1", "DataArray"});
  }
}

TEST(HostileFiles, IndicesOutOfRange) {
  expect_bad_mesh("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", {"line 4", "vertex 4", "3"});
  expect_bad_mesh("a.obj", "v 0 0 0\nf 1 -1 -2\n", {"line 2", "-2"});
  expect_bad_mesh("a.obj", "v 0 0 0\nf 1 1 0\n", {"line 2", "'0'"});
  expect_bad_mesh("a.obj", "v 0 0 0\nf 1 1 99999999999999999999\n", {"line 2"});
  expect_bad_mesh("a.off", "OFF 1 1 0\n0 0 0\n3 0 0 1\n", {"line 3", "vertex 1"});
  expect_bad_curve("a.obj", "v 0 0 0\nv 1 0 0\nl 1 3\n", {"line 3", "3"});
  expect_bad_curve("a.txt", "1\n4294967295\n", {"line 2"});
  expect_bad_curve("a.json",
                   R"({"format": "talweg-curves", "version": 1, "curves": [{"closed": false,
                   "points": [{"face": -1, "barycentric": [1, 0, 0]}]}]})",
                   {"curves[0].points[0].face"});
}

TEST(HostileFiles, DeepNesting) {
  expect_bad_curve("a.json", std::string(1'000'000, '['), {"64 levels"});
  std::string objects;
  for (int k = 0; k < 200'000; ++k) objects += "{\"a\":";
  expect_bad_curve("a.json", objects, {"64 levels"});
  std::string elements;
  for (int k = 0; k < 500'000; ++k) elements += "<a>";
  expect_bad_curve("a.vtp", elements, {"line 1"});
  for (int k = 0; k < 500'000; ++k) elements += "</a>";
  expect_bad_curve("a.vtp", elements, {"VTKFile"});
  expect_bad_curve("a.vtp", "<!DOCTYPE a [<!ENTITY b \"&b;&b;\">]><VTKFile>&b;</VTKFile>", {});
}

TEST(HostileFiles, EndlessLines) {
  const std::string digits(32U << 20U, '1');
  expect_bad_mesh("a.obj", "v " + digits, {"line 1"});
  expect_bad_mesh("a.off", digits, {"line 1", "OFF"});
  expect_bad_mesh("a.ply", "ply\nformat " + digits, {"line 2", "1111..."});
  expect_bad_curve("a.txt", digits, {"line 1", "1111..."});
  expect_bad_curve("a.json", digits, {"number"});
  expect_bad_curve("a.fcsv", digits, {"line 1", "1111..."});
  expect_bad_curve("a.fcsv", std::string(32U << 20U, ','), {"line 1"});
  expect_bad_curve("a.fcsv", "1,2,3,\"" + digits, {"line 1", "1111..."});
}

TEST(HostileFiles, NulBytesAndOtherEncodings) {
  expect_bad_mesh("a.obj", "v 0 0 0\nv\0 1 0 0\n"sv, {"line 2", "byte 9", "NUL"});
  expect_bad_mesh("a.off", "OFF\n1 0 0\n0 0\0 0\n"sv, {"line 3", "NUL"});
  expect_bad_curve("a.txt", "1\n2\0\n3\n"sv, {"line 2", "NUL"});
  expect_bad_curve("a.fcsv", "a,1,2,3\nb,\0,2,3\n"sv, {"line 2", "NUL"});
  expect_bad_curve("a.obj", "v 0 0 0\nv 1 0 0\n\0l 1 2\n"sv, {"line 3", "NUL"});
  expect_bad_curve("a.json", "{\"format\": \0}"sv, {"line 1, column 12"});
  expect_bad_curve("a.vtp", "<VTKFile type=\"PolyData\">\0</VTKFile>"sv, {"line 1"});
  expect_bad_mesh("a.3mf", "PK\3\4 and nothing more"sv, {"no directory"});
  for (const std::string_view bom : {"\xFF\xFE"sv, "\xFE\xFF"sv, "\0\0\xFE\xFF"sv}) {
    const std::string text = std::string(bom) + "v\0 \0000\0"s;
    for (const char* name : {"a.obj", "a.off", "a.ply"}) expect_bad_mesh(name, text, {"UTF-16"});
    for (const char* name : {"a.obj", "a.txt", "a.json", "a.vtk", "a.vtp", "a.fcsv"}) {
      expect_bad_curve(name, text, {"UTF-16"});
    }
  }
  expect_bad_mesh("a.obj", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", {"carriage returns"});
  expect_bad_curve("a.txt", "1\r2\r3\r", {"carriage returns"});
  expect_bad_mesh("a.off", "OFF\n1 0 0\n0 0 \xC3\xA9\n", {"line 3", "'?"});
}

TEST(HostileFiles, AByteOrderMarkOfUtf8HidesNothing) {
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(read_mesh("a.obj", mark + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").points.size(), 3U);
  EXPECT_EQ(read_mesh("a.off", mark + "OFF 1 0 0\n1 2 3\n").points[0], Point(1, 2, 3));
  EXPECT_EQ(read_curves("a.obj", mark + "v 0 0 0\nv 1 0 0\nl 1 2\n").size(), 1U);
  EXPECT_EQ(read_curves("a.txt", mark + "1\n2\n").size(), 1U);
}

class OddPaths : public TemporaryFolder {};

TEST_F(OddPaths, SpacesUnicodeAndQuotesAreOnlyNames) {
  MeshLists lists;
  lists.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  lists.triangles = {{0, 1, 2}};
  for (const char* name : {"a mesh", "Gefäß 血管 🙂", "it's \"quoted\"; $HOME", "-o", "a.b.c",
                           "new\nline", "\xFF\xFE latin"}) {
    const std::filesystem::path path = file(std::string(name) + ".ply");
    write_mesh(path, lists);
    EXPECT_EQ(read_mesh(path).triangles, lists.triangles) << name;
    const std::filesystem::path broken = write(std::string(name) + ".off", "OFF x");
    EXPECT_THROW(read_mesh(broken), Error);
  }
}

}  // namespace
}  // namespace talweg::test
