// Surfaces and values of brains, GIFTI and FreeSurfer: every encoding, from bytes given here or
// made by Python and nibabel, and malformed files.
#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "core/io/nibabel_folder.hpp"
#include "talweg/core/io/field_values.hpp"
#include "talweg/core/io/label_file.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {
namespace {

using namespace std::string_literals;

/// A tetrahedron.
const std::vector<Point> kPoints = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.5}};
const std::vector<Triangle> kTriangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

// These numbers as encoded by Python's struct, base64, zlib and gzip.
const std::string kPointsLittle =
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAMA/";
const std::string kTrianglesLittle =
    "AAAAAAIAAAABAAAAAAAAAAEAAAADAAAAAQAAAAIAAAADAAAAAgAAAAAAAAADAAAA";
const std::string kPointsBig = "AAAAAAAAAAAAAAAAP4AAAAAAAAAAAAAAAAAAAD+AAAAAAAAAAAAAAAAAAAA/wAAA";
const std::string kTrianglesBig =
    "AAAAAAAAAAIAAAABAAAAAAAAAAEAAAADAAAAAQAAAAIAAAADAAAAAgAAAAAAAAAD";
const std::string kPackedPoints = "eJxjYEAGDfYMePkH7AEoPQJ+";
const std::string kPackedTriangles = "eJxjYGBgYAJiRgYIANHMUJoJymaCyoHYAAG4ABM=";
const std::string kGzippedTriangles = "H4sIAAAAAAACA2NgYGBgAmJGBggA0cxQmgnKZoLKgdgAs8U1ZjAAAAA=";

std::string array(const std::string& intent, const std::string& type, const std::string& sizes,
                  const std::string& encoding, const std::string& data,
                  const std::string& rest = "Endian=\"LittleEndian\"") {
  return "<DataArray Intent=\"NIFTI_INTENT_" + intent + "\" DataType=\"NIFTI_TYPE_" + type + "\" " +
         sizes + " Encoding=\"" + encoding + "\" " + rest + ">\n<Data>" + data +
         "</Data></DataArray>\n";
}
std::string gifti(const std::string& arrays) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE GIFTI SYSTEM "
         "\"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n<GIFTI Version=\"1.0\" "
         "NumberOfDataArrays=\"2\">\n" +
         arrays + "</GIFTI>\n";
}
const std::string kFourByThree = "Dimensionality=\"2\" Dim0=\"4\" Dim1=\"3\"";
std::string points_array(const std::string& encoding, const std::string& data,
                         const std::string& rest = "Endian=\"LittleEndian\"") {
  return array("POINTSET", "FLOAT32", kFourByThree, encoding, data, rest);
}
std::string triangles_array(const std::string& encoding, const std::string& data,
                            const std::string& rest = "Endian=\"LittleEndian\"") {
  return array("TRIANGLE", "INT32", kFourByThree, encoding, data, rest);
}
const std::string kTextPoints = "0 0 0\n1 0 0\n0 1 0\n0 0 1.5\n";
const std::string kTextTriangles = "0 2 1 0 1 3 1 2 3 2 0 3";

std::string big_endian(std::initializer_list<std::int32_t> values) {
  std::string bytes;
  for (const std::int32_t value : values) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift);
  }
  return bytes;
}
std::string big_floats(std::initializer_list<float> values) {
  std::string bytes;
  for (const float value : values) bytes += big_endian({std::bit_cast<std::int32_t>(value)});
  return bytes;
}
std::string big_shorts(std::initializer_list<int> values) {
  std::string bytes;
  for (const int value : values) {
    bytes += static_cast<char>(value >> 8);
    bytes += static_cast<char>(value);
  }
  return bytes;
}
std::string three_bytes(std::initializer_list<int> values) {
  std::string bytes;
  for (const int value : values) bytes += big_endian({value}).substr(1);
  return bytes;
}

std::string freesurfer() {
  return "\xFF\xFF\xFE"
         "created by somebody\n\n" +
         big_endian({4, 4}) + big_floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1.5F}) +
         big_endian({0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3});
}

void expect_tetrahedron(const MeshLists& lists) {
  EXPECT_EQ(lists.points, kPoints);
  EXPECT_EQ(lists.triangles, kTriangles);
  EXPECT_TRUE(lists.single_precision);
}

template <class Read>
void expect_refused(const Read& read, const std::string& name, const std::string& bytes,
                    std::initializer_list<const char*> words) {
  try {
    read(name, bytes);
    ADD_FAILURE() << name << " was taken";
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_EQ(error.code(), ErrorCode::kBadFile) << what;
    EXPECT_NE(what.find(name), what.npos) << what;
    for (const char* word : words) EXPECT_NE(what.find(word), what.npos) << what << "\n" << word;
    EXPECT_LT(what.size(), 400U);
  }
}
void expect_bad_mesh(const std::string& name, const std::string& bytes,
                     std::initializer_list<const char*> words) {
  expect_refused([](const auto& path, const auto& all) { return read_mesh(path, all); }, name,
                 bytes, words);
}
void expect_bad_field(const std::string& name, const std::string& bytes,
                      std::initializer_list<const char*> words) {
  expect_refused([](const auto& path, const auto& all) { return read_field_values(path, all); },
                 name, bytes, words);
}

TEST(Gifti, SurfacesInEveryEncoding) {
  const std::string big = "Endian=\"BigEndian\"";
  for (const std::string& arrays : {
           points_array("ASCII", kTextPoints) + triangles_array("ASCII", kTextTriangles),
           triangles_array("Base64Binary", kTrianglesLittle) +
               points_array("Base64Binary", kPointsLittle),
           points_array("Base64Binary", kPointsBig, big) +
               triangles_array("Base64Binary", "\n" + kTrianglesBig + "\n", big),
           points_array("GZipBase64Binary", kPackedPoints) +
               triangles_array("GZipBase64Binary", kPackedTriangles),
           points_array("GZipBase64Binary", kPackedPoints) +
               triangles_array("GZipBase64Binary", kGzippedTriangles),
       }) {
    expect_tetrahedron(read_mesh("lh.surf.gii", gifti(arrays)));
  }
  // Column-major order.
  const std::string columns = "ArrayIndexingOrder=\"ColumnMajorOrder\"";
  expect_tetrahedron(
      read_mesh("A.GII", gifti(points_array("ASCII", "0 1 0 0 0 0 1 0 0 0 0 1.5", columns) +
                               triangles_array("ASCII", "0 0 1 2 2 1 2 0 1 3 3 3", columns))));
  const MeshLists doubles =
      read_mesh("a.gii", gifti(array("POINTSET", "FLOAT64", kFourByThree, "ASCII", kTextPoints) +
                               array("TRIANGLE", "UINT8", kFourByThree, "ASCII", kTextTriangles)));
  EXPECT_FALSE(doubles.single_precision);
  EXPECT_EQ(doubles.triangles, kTriangles);
}

TEST(Gifti, DataThatAreNotReadAreNamed) {
  MeshAttributes attributes;
  read_mesh("a.gii",
            gifti(points_array("ASCII", kTextPoints) + triangles_array("ASCII", kTextTriangles) +
                  array("SHAPE", "FLOAT32", "Dimensionality=\"1\" Dim0=\"4\"", "ASCII", "1 2 3 4")),
            attributes);
  ASSERT_EQ(attributes.left_out.size(), 1U);
  EXPECT_NE(attributes.left_out[0].find("NIFTI_INTENT_SHAPE"), std::string::npos);
}

TEST(Gifti, MalformedFilesAreRefused) {
  const std::string points = points_array("ASCII", kTextPoints);
  expect_bad_mesh("a.gii", "no xml", {"XML"});
  expect_bad_mesh("a.gii", "<VTKFile/>", {"<GIFTI>"});
  expect_bad_mesh("a.gii", gifti(points), {"NIFTI_INTENT_TRIANGLE", "POINTSET of 4 x 3"});
  expect_bad_mesh("a.label.gii", gifti(""), {"not a surface", "found nothing"});
  expect_bad_mesh("a.gii", gifti(points + triangles_array("ASCII", "0 2 1 0 1 3 1 2 3 2 0 4")),
                  {"line 10", "face 3", "vertex 4", "there are 4"});
  expect_bad_mesh("a.gii", gifti(points + triangles_array("ASCII", "0 2 1 0 1 3 1 2 3 2 0 -1")),
                  {"vertex -1"});
  expect_bad_mesh("a.gii", gifti(points + triangles_array("ASCII", "0 2 1")),
                  {"expected 12 numbers, found 3"});
  expect_bad_mesh("a.gii", gifti(points + triangles_array("ASCII", "0 2 x")), {"'x'"});
  expect_bad_mesh("a.gii", gifti(points + triangles_array("Base64Binary", kTrianglesBig)),
                  {"face 0"});
  expect_bad_mesh("a.gii", gifti(points + triangles_array("Base64Binary", "AAAA")),
                  {"expected 48 bytes", "found 3"});
  expect_bad_mesh("a.gii", gifti(points + triangles_array("Base64Binary", "AA!A")), {"base64"});
  expect_bad_mesh("a.gii", gifti(points + triangles_array("GZipBase64Binary", kPackedPoints)),
                  {"face"});
  expect_bad_mesh("a.gii", gifti(points + triangles_array("GZipBase64Binary", "AAAAAAAA")),
                  {"zlib"});
  expect_bad_mesh("a.gii",
                  gifti(points + triangles_array("ExternalFileBinary", "",
                                                 "ExternalFileName=\"../../etc/passwd\"")),
                  {"ExternalFileBinary", "another file"});
  expect_bad_mesh("a.gii", gifti(points + triangles_array("Morse", "")), {"Morse"});
  const std::string many = "Dimensionality=\"2\" Dim0=\"4000000000\" Dim1=\"3\"";
  for (const char* encoding : {"ASCII", "Base64Binary", "GZipBase64Binary"}) {
    expect_bad_mesh("a.gii", gifti(points + array("TRIANGLE", "INT32", many, encoding, "AAAA")),
                    {"line 10"});
  }
  for (const char* sizes : {"Dimensionality=\"3\" Dim0=\"1\"", "Dimensionality=\"1\" Dim0=\"-4\"",
                            "Dimensionality=\"2\" Dim0=\"4\""}) {
    expect_bad_mesh("a.gii", gifti(points + array("TRIANGLE", "INT32", sizes, "ASCII", "")),
                    {"line 10", "Dim"});
  }
  expect_bad_mesh("a.gii", gifti(array("POINTSET", "RGB24", kFourByThree, "ASCII", "")),
                  {"NIFTI_TYPE_RGB24"});
}

TEST(Gifti, ValuesPerVertex) {
  const std::string four = "Dimensionality=\"1\" Dim0=\"4\"";
  const std::string shape = array("SHAPE", "FLOAT32", four, "ASCII", "0.5 -1 2e3 0.25");
  const std::vector<double> expected = {0.5, -1, 2000, 0.25};
  EXPECT_EQ(read_field_values("a.shape.gii", gifti(shape)), expected);
  EXPECT_EQ(read_field_values("a.func.gii", gifti(points_array("ASCII", kTextPoints) + shape)),
            expected);
  expect_bad_field("a.gii", gifti(points_array("ASCII", kTextPoints)),
                   {"no values", "NIFTI_INTENT_SHAPE", "POINTSET"});
}

TEST(FreeSurferSurface, IsRead) {
  for (const char* name : {"lh.white", "rh.pial", "lh.INFLATED", "lh.sphere", "lh.sphere.reg"}) {
    expect_tetrahedron(read_mesh(name, freesurfer()));
  }
  // The geometry of the volume follows the triangles.
  MeshAttributes attributes;
  expect_tetrahedron(read_mesh("lh.white", freesurfer() + "valid = 1\n", attributes));
  EXPECT_EQ(attributes.left_out.size(), 1U);
}

TEST(FreeSurferSurface, QuadsAreDividedAsFreeSurferDividesThem) {
  const std::string corners = three_bytes({0, 1, 2, 3, 1, 2, 3, 0});
  // An even first corner gives 0 1 3 and 2 3 1, an odd first corner 1 2 3 and 1 3 0.
  const std::vector<Triangle> expected = {{0, 1, 3}, {2, 3, 1}, {1, 2, 3}, {1, 3, 0}};
  const MeshLists old =
      read_mesh("lh.orig", "\xFF\xFF\xFF" + three_bytes({4, 2}) +
                               big_shorts({0, 0, 0, 100, 0, 0, 0, 250, -50, 0, 0, 150}) + corners);
  EXPECT_EQ(old.triangles, expected);
  EXPECT_EQ(old.polygon_count, 0U);
  EXPECT_EQ(old.unit.value_or(LengthUnit::named("m")).code(), "mm");
  EXPECT_EQ(old.points[2], Point(0, 2.5, -0.5));  // stored in hundredths
  const MeshLists floats = read_mesh(
      "lh.orig", "\xFF\xFF\xFD" + three_bytes({4, 2}) +
                     big_floats({0, 0, 0, 1, 0, 0, 0, 2.5F, -0.5F, 0, 0, 1.5F}) + corners);
  EXPECT_EQ(floats.triangles, expected);
  EXPECT_EQ(floats.points, old.points);
}

TEST(FreeSurferSurface, MalformedFilesAreRefused) {
  const std::string whole = freesurfer();
  for (std::size_t size = 1; size < whole.size(); ++size) {
    expect_bad_mesh("lh.white", whole.substr(0, size), {});
  }
  expect_bad_mesh("lh.white", "OFF\n", {"not a surface of FreeSurfer", "4F4646"});
  const std::string head = "\xFF\xFF\xFE\n\n";
  expect_bad_mesh("lh.pial", head + big_endian({2'000'000'000, 4}) + "0000", {"2000000000"});
  expect_bad_mesh("lh.pial", head + big_endian({-1, 4}), {"-1 vertices"});
  std::string bad = whole;
  bad.back() = 4;
  expect_bad_mesh("lh.pial", bad, {"face 3", "vertex 4", "there are 4"});
}

TEST(FreeSurferValues, InBothFormats) {
  const std::vector<double> expected = {0.5, -1, 2};
  const std::string new_format = "\xFF\xFF\xFF" + big_endian({3, 2, 1}) + big_floats({0.5F, -1, 2});
  for (const char* name : {"lh.curv", "lh.thickness", "lh.area.pial", "lh.w"}) {
    EXPECT_EQ(read_field_values(name, new_format), expected) << name;
  }
  const std::string old = three_bytes({3, 2}) + big_shorts({50, -100, 200});
  EXPECT_EQ(read_field_values("lh.sulc", old), expected);
  EXPECT_EQ(read_field_values("v.dpv", "000 1 2 3 0.5\n001 1 2 3 -1\n002 0 0 0 2\n"), expected);
  EXPECT_EQ(read_field_values("v.txt", "0.5 -1\n2"), expected);
}

TEST(FreeSurferValues, MalformedFilesAreRefused) {
  const std::string head = "\xFF\xFF\xFF";
  expect_bad_field("lh.curv", head + big_endian({2'000'000'000, 2, 1}) + "0000", {"2000000000"});
  expect_bad_field("lh.curv", head + big_endian({1, 2, 3}) + "0000", {"3 values per vertex"});
  expect_bad_field("lh.curv", head + big_endian({2}), {"ends"});
  expect_bad_field("lh.curv", three_bytes({3, 2}) + big_shorts({50, -100}), {"3 values"});
  expect_bad_field("lh.curv", three_bytes({1, 2}) + big_shorts({50, -100}), {"2 bytes follow"});
  expect_bad_field("v.dpv", "000 1 2 3 0.5\n002 1 2 3 -1\n", {"line 2", "number 1"});
  expect_bad_field("v.dpv", "000 1 2 0.5\n", {"line 1", "value"});
  expect_bad_field("v.txt", "1\nx\n", {"line 2", "'x'"});
}

class NibabelMeshes : public NibabelFolder {};

TEST_F(NibabelMeshes, AreReadAsTheyWereWritten) {
  if (!has_nibabel()) GTEST_SKIP() << kNoNibabel;
  ASSERT_TRUE(
      python("p = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.5]], 'f4')\n"
             "t = numpy.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], 'i4')\n"
             "fs.write_geometry('lh.white', p, t, volume_info={'head': [2, 0, 20], 'valid': '1',"
             " 'filename': 'x.mgz', 'volume': [2, 2, 2], 'voxelsize': [1, 1, 1],"
             " 'xras': [1, 0, 0], 'yras': [0, 1, 0], 'zras': [0, 0, 1], 'cras': [3, 4, 5]})\n"
             "fs.write_morph_data('lh.thickness', numpy.array([0.5, -1, 2000, 0.25]))\n"
             "from nibabel.gifti import GiftiImage, GiftiDataArray as Array\n"
             "for encoding in 'ASCII', 'Base64Binary', 'GZipBase64Binary':\n"
             "  for endian in 'little', 'big':\n"
             "    image = GiftiImage(darrays=[\n"
             "      Array(p, 'NIFTI_INTENT_POINTSET', encoding=encoding, endian=endian),\n"
             "      Array(t, 'NIFTI_INTENT_TRIANGLE', encoding=encoding, endian=endian)])\n"
             "    nibabel.save(image, f'{encoding}-{endian}.surf.gii')\n"
             "values = numpy.array([0.5, -1, 2000, 0.25], 'f4')\n"
             "nibabel.save(GiftiImage(darrays=[Array(values, 'NIFTI_INTENT_SHAPE')]),"
             " 'v.shape.gii')\n"))
      << bytes_of(file("err.txt"));
  expect_tetrahedron(read_mesh(file("lh.white")));
  const std::vector<double> expected = {0.5, -1, 2000, 0.25};
  EXPECT_EQ(read_field_values(file("lh.thickness")), expected);
  EXPECT_EQ(read_field_values(file("v.shape.gii")), expected);
  // nibabel writes BigEndian in the header, but the bytes in the order of the machine.
  for (const char* encoding : {"ASCII", "Base64Binary", "GZipBase64Binary"}) {
    expect_tetrahedron(read_mesh(file(encoding + "-little.surf.gii"s)));
  }
}

}  // namespace
}  // namespace talweg::test
