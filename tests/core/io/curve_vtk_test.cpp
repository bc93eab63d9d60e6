// Curves in VTK's legacy polydata files.
#include <algorithm>
#include <array>
#include <bit>

#include <gtest/gtest.h>

#include "core/curve_files.hpp"

namespace talweg {
namespace {

using CurveVtk = test::CurveFiles;

template <class T>
void append(std::string& bytes, T value) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (std::endian::native == std::endian::little) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

std::string header(const std::string& version, const std::string& encoding) {
  return "# vtk DataFile Version " + version + "\na title\n" + encoding + "\nDATASET POLYDATA\n";
}

const std::string kPoints = "POINTS 4 float\n0 0 0 1 0 0\n1 1 0\n0 1 0\n";
const std::string kAscii3 = header("3.0", "ASCII") + kPoints;

const std::vector<Point> kUnitSquare{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST_F(CurveVtk, Ascii) {
  const auto curves = read("a.vtk", kAscii3 + "LINES 1 5\n4 0 1 2 3\n");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_FALSE(curves[0].closed);
  EXPECT_EQ(test::positions(curves[0]), kUnitSquare);
}

TEST_F(CurveVtk, ALineThatEndsAtItsFirstIndexIsClosed) {
  const auto curves = read("a.vtk", kAscii3 + "LINES 1 6\n5 0 1 2 3 0\n");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_EQ(test::positions(curves[0]), kUnitSquare);
}

TEST_F(CurveVtk, OtherSectionsArePassedOver) {
  const auto curves =
      read("a.vtk", header("4.2", "ASCII") + "FIELD FieldData 1\nTIME 1 1 double\n0.5\n" + kPoints +
                        "METADATA\nINFORMATION 0\n\nVERTICES 1 2\n1 0\nLINES 2 6\n2 0 1\n2 1 2\n"
                        "POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 4\nSCALARS x float\n");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(test::positions(curves[0]).size(), 3U);
}

TEST_F(CurveVtk, OffsetsAndConnectivityOfVersion5) {
  const auto curves = read("a.vtk", header("5.1", "ASCII") + kPoints +
                                        "LINES 3 5\nOFFSETS vtktypeint64\n0 2 5\n"
                                        "CONNECTIVITY vtktypeint64\n2 3 0 1 0\n");
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(test::positions(curves[0]), (std::vector<Point>{kUnitSquare[2], kUnitSquare[3]}));
  EXPECT_TRUE(curves[1].closed);
}

std::string binary_file(bool version_5) {
  std::string bytes = header(version_5 ? "5.1" : "3.0", "BINARY") + "POINTS 4 double\n";
  for (const Point& p : kUnitSquare) {
    for (int k = 0; k < 3; ++k) append(bytes, p[k]);
  }
  if (!version_5) {
    bytes += "\nLINES 1 5\n";
    for (const std::int32_t k : {4, 0, 1, 2, 3}) append(bytes, k);
    return bytes + "\n";
  }
  bytes += "\nLINES 2 4\nOFFSETS vtktypeint64\n";
  for (const std::int64_t k : {0, 4}) append(bytes, k);
  bytes += "\nCONNECTIVITY vtktypeint64\n";
  for (const std::int64_t k : {0, 1, 2, 3}) append(bytes, k);
  return bytes + "\n";
}

TEST_F(CurveVtk, Binary) {
  for (const bool version_5 : {false, true}) {
    const auto curves = read("a.vtk", binary_file(version_5));
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_EQ(test::positions(curves[0]), kUnitSquare);
  }
}

TEST_F(CurveVtk, RefusesMalformedFiles) {
  expect_refused("a.vtk", "hello\n", {"line 1", "vtk DataFile"});
  expect_refused("a.vtk", "# vtk DataFile Version 3.0\nt\nTEXT\n", {"line 3", "'TEXT'"});
  expect_refused("a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n",
                 {"line 4", "POLYDATA"});
  expect_refused("a.vtk", kAscii3, {"no LINES"});
  expect_refused("a.vtk", kAscii3 + "LINES 1 3\n2 0 4\n",
                 {"line 0 of LINES", "no point 4", "has 4"});
  expect_refused("a.vtk", kAscii3 + "LINES 1 3\n2 0 -1\n", {"-1"});
  expect_refused("a.vtk", kAscii3 + "LINES 1 2\n1 0\n", {"line 0", "two points"});
  expect_refused("a.vtk", kAscii3 + "LINES 1 3\n9 0 1\n", {"more than there are"});
  expect_refused("a.vtk", kAscii3 + "LINES 2 3\n2 0 1\n", {"line 1 is missing"});
  expect_refused("a.vtk", kAscii3 + "LINES 1 9\n2 0 1\n", {"ends earlier"});
  expect_refused("a.vtk", kAscii3 + "LINES -1 3\n2 0 1\n", {"'-1'"});
  expect_refused("a.vtk", kAscii3 + "LINES 1 99999999999\n2 0 1\n", {"99999999999"});
  expect_refused("a.vtk", header("3.0", "ASCII") + "POINTS 1 float\n0 0 nan\nLINES 1 1\n",
                 {"line 6", "finite"});
  expect_refused("a.vtk", header("3.0", "ASCII") + "POINTS 1 quad\n0 0 0\n", {"line 5", "'quad'"});
  expect_refused("a.vtk", header("3.0", "ASCII") + "SPAM\n", {"line 5", "'SPAM'"});
}

TEST_F(CurveVtk, BelievesNoHeaderBeyondTheFile) {
  for (const char* encoding : {"ASCII", "BINARY"}) {
    expect_refused("a.vtk", header("3.0", encoding) + "POINTS 4000000000 double\n0 0 0\n",
                   {"12000000000", "ends earlier"});
    expect_refused("a.vtk", header("5.1", encoding) + "LINES 4000000000 4\nOFFSETS vtktypeint64\n0",
                   {"4000000000", "ends earlier"});
    expect_refused("a.vtk",
                   header("4.0", encoding) +
                       "FIELD f 4000000000\nx 4000000000 4000000000 double\n0\nLINES 0 0\n",
                   {"ends earlier"});
  }
}

TEST_F(CurveVtk, NotFiniteInBinary) {
  std::string bytes = header("3.0", "BINARY") + "POINTS 1 float\n";
  for (const float x : {0.0F, 1.0F, std::numeric_limits<float>::infinity()}) append(bytes, x);
  expect_refused("a.vtk", bytes + "\nLINES 0 0\n", {"byte", "point 0", "not finite"});
}

TEST_F(CurveVtk, SurvivesDamage) {
  for (const bool version_5 : {false, true}) {
    try_every_prefix("a.vtk", binary_file(version_5));
    try_damaged("a.vtk", binary_file(version_5), 500);
  }
}

}  // namespace
}  // namespace talweg
