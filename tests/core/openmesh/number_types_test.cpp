// The same mesh in every type of number and every encoding that PLY has.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/temporary_folder.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {
namespace {

class PlyNumberTypes : public TemporaryFolder {};

/// An octahedron: its coordinates fit any type with a sign, its indices any type.
MeshLists octahedron_with_whole_coordinates() { return sphere(0); }

template <class T>
void append(std::string& bytes, double value, bool big) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(static_cast<T>(value));
  if (big != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

using Append = void (*)(std::string&, double, bool);
struct Type {
  const char* name;
  Append append;
  bool is_signed;
  bool whole;
};
const std::vector<Type> kTypes = {
    {"char", &append<std::int8_t>, true, true},   {"uint8", &append<std::uint8_t>, false, true},
    {"short", &append<std::int16_t>, true, true}, {"uint16", &append<std::uint16_t>, false, true},
    {"int32", &append<std::int32_t>, true, true}, {"uint", &append<std::uint32_t>, false, true},
    {"float32", &append<float>, true, false},     {"double", &append<double>, true, false},
};

std::string header(const char* encoding, const Type& coordinate, const Type& count,
                   const Type& index, const MeshLists& lists) {
  std::string text("ply\nformat ");
  text.append(encoding).append(" 1.0\nelement vertex ").append(std::to_string(lists.points.size()));
  for (const char* name : {"x", "y", "z"}) {
    text.append("\nproperty ").append(coordinate.name).append(" ").append(name);
  }
  text.append("\nelement face ").append(std::to_string(lists.triangles.size()));
  text.append("\nproperty list ").append(count.name).append(" ").append(index.name);
  return text.append(" vertex_indices\nend_header\n");
}

/// Unsigned coordinates cannot hold -1, so the octahedron is shifted for them.
MeshLists shifted_for(const Type& type) {
  MeshLists lists = octahedron_with_whole_coordinates();
  if (!type.is_signed) {
    for (Point& p : lists.points) p += Point(1, 1, 1);
  }
  return lists;
}

TEST_F(PlyNumberTypes, OfCoordinatesCountsAndIndicesInBothByteOrders) {
  for (const bool big : {false, true}) {
    for (const Type& coordinate : kTypes) {
      for (const Type& whole : kTypes) {
        if (!whole.whole) continue;
        const MeshLists lists = shifted_for(coordinate);
        std::string bytes = header(big ? "binary_big_endian" : "binary_little_endian", coordinate,
                                   whole, whole, lists);
        for (const Point& p : lists.points) {
          for (const double x : p) coordinate.append(bytes, x, big);
        }
        for (const Triangle& t : lists.triangles) {
          whole.append(bytes, 3, big);
          for (const std::uint32_t v : t) whole.append(bytes, v, big);
        }
        const MeshLists read = read_mesh(write("a.ply", bytes));
        EXPECT_EQ(read.points, lists.points) << coordinate.name << " " << whole.name << big;
        EXPECT_EQ(read.triangles, lists.triangles) << coordinate.name << " " << whole.name << big;
      }
    }
  }
}

TEST_F(PlyNumberTypes, CountsAndIndicesMustBeWhole) {
  for (const Type& type : kTypes) {
    if (type.whole) continue;
    const MeshLists lists = octahedron_with_whole_coordinates();
    const Type& whole = kTypes.front();
    EXPECT_THROW(read_mesh(write("a.ply", header("ascii", type, type, whole, lists))), Error);
    EXPECT_THROW(read_mesh(write("a.ply", header("ascii", type, whole, type, lists))), Error);
  }
}

TEST_F(PlyNumberTypes, NegativeCountsAndIndicesAreRefused) {
  const MeshLists lists = octahedron_with_whole_coordinates();
  const Type& signed_byte = kTypes.front();
  const std::string head =
      header("binary_little_endian", signed_byte, signed_byte, signed_byte, lists);
  std::string points;
  for (const Point& p : lists.points) {
    for (const double x : p) signed_byte.append(points, x, false);
  }
  const auto refusal = [&](const std::string& faces) -> std::string {
    try {
      read_mesh(write("a.ply", head + points + faces));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal(std::string("\xFF", 1)).find("negative length"), std::string::npos);
  EXPECT_NE(refusal(std::string("\x03\x01\x02\xFE", 4)).find("vertex -2"), std::string::npos);
}

}  // namespace
}  // namespace talweg::test
