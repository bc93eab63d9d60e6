// Labels from files: every format from bytes made here, FreeSurfer's from nibabel, too, and
// malformed files.
#include "talweg/core/io/label_file.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "core/temporary_folder.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {
namespace {

using namespace std::string_literals;
using Labels = std::vector<std::int64_t>;

std::string big_endian(std::initializer_list<std::int32_t> values) {
  std::string bytes;
  for (const std::int32_t value : values) {
    char four[4];
    std::memcpy(four, &value, 4);
    if (std::endian::native == std::endian::little) std::reverse(four, four + 4);
    bytes.append(four, 4);
  }
  return bytes;
}

std::string counted(const std::string& text) {
  return big_endian({static_cast<std::int32_t>(text.size() + 1)}) + text + '\0';
}

/// Four vertices: two with the color of "motor", one with "visual", one without color.
constexpr std::int32_t kMotor = 25 + (5 << 8) + (200 << 16), kVisual = 1 + (2 << 8) + (3 << 16);
std::string annot_vertices() { return big_endian({4, 0, kMotor, 1, kVisual, 2, 0, 3, kMotor}); }
std::string annot() {
  return annot_vertices() + big_endian({1, -2, 8}) + counted("colors.txt") + big_endian({2, 5}) +
         counted("motor") + big_endian({25, 5, 200, 0, 7}) + counted("visual") +
         big_endian({1, 2, 3, 0});
}
std::string old_annot() {
  return annot_vertices() + big_endian({1, 2}) + counted("colors.txt") + counted("motor") +
         big_endian({25, 5, 200, 0}) + counted("visual") + big_endian({1, 2, 3, 0});
}

LabelFile read(const std::string& name, const std::string& bytes, const std::string& property = "",
               std::size_t vertices = 6) {
  return read_label_file(name, bytes, {property, vertices});
}

void expect_refused(const std::string& name, const std::string& bytes, const std::string& word,
                    const std::string& property = "") {
  try {
    read(name, bytes, property);
    ADD_FAILURE() << name << " was taken, not refused for " << word;
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_EQ(error.code(), ErrorCode::kBadFile) << what;
    EXPECT_NE(what.find(name), what.npos) << what;
    EXPECT_NE(what.find(word), what.npos) << what;
    EXPECT_LT(what.size(), 300U);
  }
}

TEST(LabelFile, OfFreeSurferHasTheNumbersAndNamesOfTheColorTable) {
  const LabelFile file = read("lh.annot", annot());
  EXPECT_EQ(file.labels, (Labels{5, 7, -1, 5}));
  EXPECT_EQ(file.names, (std::map<std::int64_t, std::string>{{5, "motor"}, {7, "visual"}}));
  const LabelFile old = read("lh.annot", old_annot());
  EXPECT_EQ(old.labels, (Labels{0, 1, -1, 0}));
  EXPECT_EQ(old.names.at(1), "visual");
  // The vertices may come in any order. Without a table the colors are the labels.
  EXPECT_EQ(read("lh.annot", big_endian({2, 1, 5, 0, 6})).labels, (Labels{6, 5}));
  for (const std::string& end : {""s, big_endian({0})}) {
    EXPECT_EQ(read("lh.annot", annot_vertices() + end).labels,
              (Labels{kMotor, kVisual, 0, kMotor}));
  }
}

TEST(LabelFile, OfFreeSurferRefusesMalformedFiles) {
  const std::string whole = annot();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    if (size == annot_vertices().size()) continue;  // without its table the file is complete
    try {
      read("lh.annot", whole.substr(0, size));
      ADD_FAILURE() << "taken at " << size << " bytes";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadFile);
    }
  }
  expect_refused("a.annot", big_endian({1'000'000'000, 0, 0}), "1000000000 vertices");
  expect_refused("a.annot", big_endian({-1}), "-1 vertices");
  expect_refused("a.annot", big_endian({2, 0, 0, 2, 0}), "vertex 2");
  expect_refused("a.annot", big_endian({2, 0, 0, -1, 0}), "vertex -1");
  expect_refused("a.annot", big_endian({2, 0, 0, 0, 0}), "twice");
  expect_refused("a.annot", annot_vertices() + big_endian({1, -3}), "version");
  expect_refused("a.annot", annot_vertices() + big_endian({1, -2, 8, 2'000'000'000}), "2000000000");
  expect_refused("a.annot", annot_vertices() + big_endian({1, -2, 8, -5}), "-5");
  expect_refused("a.annot",
                 annot_vertices() + big_endian({1, -2, 8}) + counted("") + big_endian({0}),
                 "color table does not have");
  expect_refused("a.annot",
                 annot_vertices() + big_endian({1, -2, 8}) + counted("") + big_endian({1, -4}),
                 "number -4");
}

TEST(LabelFile, OfFreeSurferListsVertices) {
  const std::string head = "#!ascii label , from subject x vox2ras=TkReg\n";
  EXPECT_EQ(read("lh.label", head + "2\n1 -1.5 2 3 0\n4 0.25 1e1 3 0.7\n").labels,
            (Labels{0, 1, 0, 0, 1, 0}));
  expect_refused("a.label", "2\n1 0 0 0 0\n", "#");
  expect_refused("a.label", head + "2\n1 0 0 0 0\n", "vertex");
  expect_refused("a.label", head + "1\n6 0 0 0 0\n", "line 3");
  expect_refused("a.label", head + "1\n-1 0 0 0 0\n", "line 3");
  expect_refused("a.label", head + "1\n1 0 0 0\n", "value");
  expect_refused("a.label", head + "1\n1 0 0 0 0\n2 0 0 0 0\n", "end of the file");
  expect_refused("a.label", head + "-3\n", "-3");
}

class NibabelLabels : public TemporaryFolder {
 protected:
  /// Runs a Python script; false if it fails.
  bool python(const std::string& script) {
    const std::string path = write("script.py", script);
    return std::system(
               ("cd '" + file("").string() + "' && /usr/bin/python3 script.py > out.txt 2> err.txt")
                   .c_str()) == 0;
  }
};

TEST_F(NibabelLabels, WritesWhatIsRead) {
  if (!python("import nibabel.freesurfer")) {
    GTEST_SKIP() << "skipped: there is no nibabel (Debian: python3-nibabel)";
  }
  ASSERT_TRUE(
      python("import numpy, nibabel.freesurfer as fs\n"
             "labels = numpy.array([2, 0, -1, 1, 2, 2, 0])\n"
             "colors = numpy.array([[25, 5, 25, 0], [100, 25, 0, 0], [125, 100, 160, 0]])\n"
             "fs.write_annot('lh.annot', labels, colors, ['unknown', 'bankssts', 'caudal'])\n"
             "labels, _, names = fs.read_annot('lh.annot')\n"
             "print(*labels)\n"))
      << bytes_of(file("err.txt"));
  const LabelFile found = read_label_file(file("lh.annot"), {});
  EXPECT_EQ(found.labels, (Labels{2, 0, -1, 1, 2, 2, 0}));
  EXPECT_EQ(bytes_of(file("out.txt")), "2 0 -1 1 2 2 0\n");
  EXPECT_EQ(found.names.at(1), "bankssts");
  // nibabel must read the bytes of this test with the same result.
  write("made.annot", annot());
  write("made.label", "#!ascii label\n2\n1 0 0 0 0\n4 0 0 0 0\n");
  ASSERT_TRUE(
      python("import nibabel.freesurfer as fs\n"
             "labels, _, names = fs.read_annot('made.annot')\n"
             "print(*labels, *[n.decode() for n in names])\n"
             "print(*fs.read_label('made.label'))\n"))
      << bytes_of(file("err.txt"));
  EXPECT_EQ(bytes_of(file("out.txt")), "5 7 -1 5 motor visual\n1 4\n");
}

std::string ply(const std::string& format, const std::string& face_property = "int label") {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
         "property uchar segment\nelement face 3\nproperty list uchar int vertex_indices\n"
         "property " +
         face_property + "\nend_header\n";
}
const std::string kPlyText =
    "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n0 2 0 5\n3 0 1 2 -7\n4 0 1 2 3 8\n3 2 4 3 9\n";

TEST(LabelFile, OfPlyTakesFacesBeforeVerticesAndFans) {
  EXPECT_EQ(read("m.ply", ply("ascii") + kPlyText).labels, (Labels{-7, 8, 8, 9}));
  EXPECT_EQ(read("m.ply", ply("ascii") + kPlyText, "segment").labels, (Labels{1, 2, 3, 4, 5}));
  EXPECT_EQ(read("m.ply", ply("ascii", "float quality") + kPlyText, "quality").labels,
            (Labels{-7, 8, 8, 9}));
  // Without a face property of a usual name, the vertex property is read.
  EXPECT_EQ(read("m.ply", ply("ascii", "float quality") + kPlyText).labels,
            (Labels{1, 2, 3, 4, 5}));
}

TEST(LabelFile, OfBinaryPly) {
  for (const bool big : {false, true}) {
    std::string bytes = ply(big ? "binary_big_endian" : "binary_little_endian");
    const auto number = [&](auto value) {
      char raw[sizeof value];
      std::memcpy(raw, &value, sizeof value);
      if (big == (std::endian::native == std::endian::little)) {
        std::reverse(raw, raw + sizeof value);
      }
      bytes.append(raw, sizeof value);
    };
    for (int v = 0; v < 5; ++v) {
      for (int k = 0; k < 3; ++k) number(float(v));
      bytes.push_back(char(v + 1));
    }
    for (const std::vector<int>& face : {std::vector{0, 1, 2}, {0, 1, 2, 3}, {2, 4, 3}}) {
      bytes.push_back(char(face.size()));
      for (const int v : face) number(v);
      number(face.size() == 4 ? 100'000 : -2);
    }
    EXPECT_EQ(read("m.ply", bytes).labels, (Labels{-2, 100'000, 100'000, -2}));
    EXPECT_EQ(read("m.ply", bytes, "segment").labels, (Labels{1, 2, 3, 4, 5}));
    expect_refused("m.ply", bytes.substr(0, bytes.size() - 1), "face 2");
  }
}

TEST(LabelFile, OfPlyRefusesNumbersThatAreNoLabels) {
  expect_refused("m.ply", ply("ascii") + kPlyText, "segment, label", "color");
  expect_refused("m.ply",
                 ply("ascii", "float label") +
                     "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n"
                     "0 2 0 5\n3 0 1 2 -7\n4 0 1 2 3 8.5\n3 2 4 3 9\n",
                 "8.5");
  expect_refused("m.ply", ply("ascii") + "0 0 0 1\n", "vertex 1");
}

const std::string kVtk =
    "# vtk DataFile Version 3.0\nlabels\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
    "0 0 0 1 0 0 1 1 0 0 1 0\nPOLYGONS 2 8\n3 0 1 2\n3 0 2 3\n"
    "CELL_DATA 2\nSCALARS area double\nLOOKUP_TABLE default\n0.5 0.5\n"
    "SCALARS region int 1\nLOOKUP_TABLE default\n4 -9\n"
    "POINT_DATA 4\nNORMALS n float\n0 0 1 0 0 1 0 0 1 0 0 1\n"
    "FIELD FieldData 2\nlobes 1 4 int\n1 1 2 3\nrgb 3 4 unsigned_char\n1 2 3 4 5 6 7 8 9 1 2 3\n";

TEST(LabelFile, OfLegacyVtk) {
  EXPECT_EQ(read("m.vtk", kVtk).labels, (Labels{4, -9}));
  EXPECT_EQ(read("m.vtk", kVtk, "lobes").labels, (Labels{1, 1, 2, 3}));
  expect_refused("m.vtk", kVtk, "0.5", "area");
  expect_refused("m.vtk", kVtk, "region", "rgb");  // three components
  expect_refused("m.vtk", kVtk.substr(0, kVtk.find("4 -9")), "number");
  std::string binary =
      "# vtk DataFile Version 3.0\nlabels\nBINARY\nDATASET POLYDATA\n"
      "CELL_DATA 2\nSCALARS label int\nLOOKUP_TABLE default\n" +
      big_endian({70'000, -1});
  EXPECT_EQ(read("m.vtk", binary).labels, (Labels{70'000, -1}));
  expect_refused("m.vtk", binary.substr(0, binary.size() - 2), "expected 2 numbers");
}

std::string vtp(const std::string& data) {
  return "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData>"
         "<Piece NumberOfPoints=\"4\" NumberOfPolys=\"2\">" +
         data + "</Piece></PolyData></VTKFile>";
}
std::string array(const std::string& name, const std::string& numbers, int components = 1) {
  return "<DataArray type=\"Int32\" Name=\"" + name + "\" NumberOfComponents=\"" +
         std::to_string(components) + "\" format=\"ascii\">" + numbers + "</DataArray>";
}

TEST(LabelFile, OfVtp) {
  const std::string data = "<PointData>" + array("label", "1 2 3 4") + "</PointData><CellData>" +
                           array("normals", "1 2 3 4 5 6", 3) + array("label", "8 9") +
                           array("patch", "5 5") + "</CellData>";
  EXPECT_EQ(read("m.vtp", vtp(data)).labels, (Labels{8, 9}));
  EXPECT_EQ(read("m.vtp", vtp(data), "patch").labels, (Labels{5, 5}));
  expect_refused("m.vtp", vtp(data), "label, patch, label", "normals");
  expect_refused("m.vtp", vtp(""), "nothing");
  expect_refused("m.vtp", vtp("</Piece><Piece>"), "several pieces");
  expect_refused("m.vtp", "<VTKFile type=\"UnstructuredGrid\"></VTKFile>", "PolyData");
}

TEST(LabelFile, OfTextIsWholeNumbers) {
  EXPECT_EQ(read("labels.txt", "1 2\n-3\n\n9000000000\n").labels,
            (Labels{1, 2, -3, 9'000'000'000}));
  expect_refused("labels.txt", "1\n2.5\n", "line 2");
}

}  // namespace
}  // namespace talweg::test
