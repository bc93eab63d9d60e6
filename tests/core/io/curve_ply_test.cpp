// Curves in PLY files.
#include <algorithm>
#include <bit>

#include <gtest/gtest.h>

#include "core/curve_files.hpp"

namespace talweg {
namespace {

using CurvePly = test::CurveFiles;

std::string header(const std::string& format, std::size_t vertices, std::size_t edges) {
  return "ply\nformat " + format + " 1.0\ncomment by hand\nelement vertex " +
         std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty uchar red\nproperty double z\n"
         "element face 1\nproperty list uchar int vertex_indices\nelement edge " +
         std::to_string(edges) + "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
}

template <class T>
void append(std::string& bytes, T value, bool big_endian) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (big_endian != (std::endian::native == std::endian::big)) {
    std::reverse(raw.begin(), raw.end());
  }
  bytes.append(raw.data(), raw.size());
}

std::string binary(bool big_endian) {
  std::string bytes = header(big_endian ? "binary_big_endian" : "binary_little_endian", 3, 2);
  for (int k = 0; k < 3; ++k) {
    append(bytes, 0.5F + static_cast<float>(k), big_endian);
    append(bytes, -1.25F, big_endian);
    append(bytes, std::uint8_t{200}, big_endian);
    append(bytes, 0.1, big_endian);
  }
  append(bytes, std::uint8_t{3}, big_endian);
  for (const std::int32_t k : {0, 1, 2}) append(bytes, k, big_endian);
  for (const std::int32_t k : {0, 1, 1, 2}) append(bytes, k, big_endian);
  return bytes;
}

const std::string kAscii =
    header("ascii", 3, 2) + "0.5 -1.25 200 0.1\n1.5 -1.25 200 0.1\n2.5 -1.25 200 0.1\n3 0 1 2\n";

void expect_three_points(const std::vector<CurveInput>& curves) {
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_FALSE(curves[0].closed);
  EXPECT_EQ(test::positions(curves[0]),
            (std::vector<Point>{{0.5, -1.25, 0.1}, {1.5, -1.25, 0.1}, {2.5, -1.25, 0.1}}));
}

TEST_F(CurvePly, Ascii) { expect_three_points(read("a.ply", kAscii + "0 1\n1 2\n")); }

TEST_F(CurvePly, BinaryOfBothByteOrders) {
  expect_three_points(read("a.ply", binary(false)));
  expect_three_points(read("a.ply", binary(true)));
}

TEST_F(CurvePly, EdgesMayComeInAnyOrderAndBeforeTheVertices) {
  const auto curves = read("a.ply",
                           "ply\nformat ascii 1.0\nelement edge 3\nproperty uint vertex1\n"
                           "property uint vertex2\nelement vertex 3\nproperty double x\n"
                           "property double y\nproperty double z\nend_header\n"
                           "0 1\n2 0\n1 2\n0 0 0\n1 0 0\n0 1 0\n");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_EQ(test::positions(curves[0]), (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST_F(CurvePly, RefusesMalformedHeaders) {
  expect_refused("a.ply", "plx\n", {"line 1", "word ply"});
  expect_refused("a.ply", "ply\nformat ascii 1.0\n", {"end_header"});
  expect_refused("a.ply", "ply\nend_header\n", {"no format"});
  expect_refused("a.ply", "ply\nformat text 1.0\nend_header\n", {"line 2", "text"});
  expect_refused("a.ply", "ply\nformat ascii 1.0\nend_header\n", {"no element 'vertex'"});
  expect_refused("a.ply", "ply\nformat ascii 1.0\nproperty float x\nend_header\n", {"line 3"});
  expect_refused("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\nend_header\n",
                 {"line 4", "half"});
  expect_refused("a.ply", "ply\nformat ascii 1.0\nelement vertex -1\nend_header\n", {"line 3"});
  expect_refused("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                 "property float z\nend_header\n0 0 0\n",
                 {"no element 'edge'"});
  expect_refused("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                 "element edge 0\nend_header\n0 0\n",
                 {"'vertex'", "'z'"});
}

TEST_F(CurvePly, RefusesMalformedData) {
  expect_refused("a.ply", kAscii + "0 1\n1 3\n", {"edge 1", "no vertex 3", "has 3"});
  expect_refused("a.ply", kAscii + "0 1\n1 -1\n", {"edge 1", "-1"});
  expect_refused("a.ply", kAscii + "0 1\n1 1\n", {"edge 1", "itself"});
  expect_refused("a.ply", kAscii + "0 1\n1 0.5\n", {"edge 1", "0.5"});
  expect_refused("a.ply", kAscii + "0 1\n", {"line 20", "the end of the file"});
  expect_refused("a.ply", kAscii + "0 1\n1 x\n", {"line 20", "'x'"});
  std::string bad = kAscii + "0 1\n1 2\n";
  bad.replace(bad.find("1.5 -1.25"), 3, "nan");
  expect_refused("a.ply", bad, {"line 16", "vertex 1", "not finite"});
  expect_refused("a.ply", header("ascii", 3, 0) + "0 0 0 0\n0 0 0 0\n0 0 0 0\n3 0 1 2\n",
                 {"no edges"});
}

TEST_F(CurvePly, BelievesNoHeaderBeyondTheFile) {
  for (const char* format : {"ascii", "binary_little_endian"}) {
    expect_refused("a.ply", header(format, 4000000000U, 2) + "0 0 0 0\n", {"4000000000"});
  }
  std::string list = header("binary_little_endian", 0, 1);
  list += "\xFF\x01\x02\x03\x04\x05\x06\x07\x08\x09";
  expect_refused("a.ply", list, {"byte", "longer than the file"});
}

TEST_F(CurvePly, SurvivesDamage) {
  for (const bool big_endian : {false, true}) {
    try_every_prefix("a.ply", binary(big_endian));
    try_damaged("a.ply", binary(big_endian), 500);
  }
}

}  // namespace
}  // namespace talweg
