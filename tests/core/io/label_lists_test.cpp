// Labels as tables and arrays, and every written format: its bytes, and its round trip.
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/io/nibabel_folder.hpp"
#include "talweg/core/io/label_file.hpp"
#include "talweg/core/io/label_writer.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test::label_lists {
namespace {

using namespace std::string_literals;
using Labels = std::vector<std::int64_t>;

LabelFile read(const std::string& name, const std::string& bytes, const std::string& property = "",
               std::size_t vertices = 4) {
  return read_label_file(name, bytes, {property, vertices});
}

template <class Call>
void expect_refused(const Call& call, std::initializer_list<const char*> words) {
  try {
    call();
    ADD_FAILURE() << "taken, not refused for " << *words.begin();
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_EQ(error.code(), ErrorCode::kBadFile) << what;
    for (const char* word : words) EXPECT_NE(what.find(word), what.npos) << what << "\n" << word;
    EXPECT_LT(what.size(), 300U);
  }
}
void expect_unread(const std::string& name, const std::string& bytes,
                   std::initializer_list<const char*> words, const std::string& property = "") {
  expect_refused([&] { read(name, bytes, property); }, words);
}

TEST(LabelLists, OfTextMayBeRealNumbersThatAreWhole) {
  EXPECT_EQ(read("a.txt", "1.000000000000000000e+00\n0.0\n-2.5e1\n").labels, (Labels{1, 0, -25}));
  EXPECT_EQ(read("a.txt", "# labels\n3 4 # and more\n5").labels, (Labels{3, 4, 5}));
  expect_unread("a.txt", "1.0\n1.5e+00\n", {"a.txt", "line 2", "1.5e+00", "whole"});
  expect_unread("a.txt", "1\nnan\n", {"line 2", "nan"});
  expect_unread("a.txt", "1e300\n", {"line 1"});
}

TEST(LabelLists, OfTables) {
  EXPECT_EQ(read("a.csv", "1\n2\n-3\n").labels, (Labels{1, 2, -3}));
  EXPECT_EQ(read("a.csv", "label\r\n1\r\n2.0\r\n").labels, (Labels{1, 2}));
  EXPECT_EQ(read("a.csv", "vertex,label\n0,5\n2,7\n1,6\n").labels, (Labels{5, 6, 7}));
  EXPECT_EQ(read("a.csv", "face;area;region\n1;0.5;8\n0;0.25;9\n").labels, (Labels{9, 8}));
  EXPECT_EQ(read("a.csv", ",parcel\n0,4\n1,3\n").labels, (Labels{4, 3}));  // as written by pandas
  const std::string names = "name\tparcel\tlobe\n\"a\tb\"\t1\t5\nc\t2\t6\n";
  EXPECT_EQ(read("a.csv", names, "lobe").labels, (Labels{5, 6}));
  expect_unread("a.csv", names, {"no column label", "name, parcel, lobe"});
  expect_unread("a.csv", names, {"no column x"}, "x");
  expect_unread("a.csv", "1,2\n", {"line 1", "vertex,label"});
  expect_unread("a.csv", "vertex,label\n0,5\n0,6\n", {"number 0 comes twice"});
  expect_unread("a.csv", "vertex,label\n0,5\n2,6\n", {"row 1", "number 2", "2 rows"});
  expect_unread("a.csv", "vertex,label\n0,5\n1\n", {"line 3", "expected 2 cells"});
  expect_unread("a.csv", "label\n1\nx\n", {"line 3", "'x'"});
  expect_unread("a.csv", "\n\n", {"no lines"});
}

std::string npy(const std::string& dictionary, const std::string& data, int version = 1) {
  std::string bytes = "\x93NUMPY";
  bytes += static_cast<char>(version);
  bytes += '\0';
  bytes += static_cast<char>(dictionary.size());
  bytes += std::string(version == 1 ? 1 : 3, '\0');
  return bytes + dictionary + data;
}
std::string dictionary(const std::string& type, const std::string& shape) {
  return "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }\n";
}

TEST(LabelLists, OfNumPyArrays) {
  EXPECT_EQ(read("a.npy", npy(dictionary("|i1", "(3,)"), "\x01\xFE\x03")).labels,
            (Labels{1, -2, 3}));
  EXPECT_EQ(read("a.npy", npy(dictionary("|b1", "(3,)"), "\x01\x00\x01"s)).labels,
            (Labels{1, 0, 1}));
  EXPECT_EQ(read("a.npy", npy(dictionary("<i4", "(2,)"), "\x05\0\0\0\xFF\xFF\xFF\xFF"s)).labels,
            (Labels{5, -1}));
  EXPECT_EQ(read("a.npy", npy(dictionary(">u2", "(2, 1)"), "\x01\x02\x00\x03"s, 2)).labels,
            (Labels{258, 3}));
  EXPECT_EQ(read("a.npy", npy(dictionary("<f4", "(1, 2)"), "\0\0\x80\x3F\0\0\0\xC0"s, 3)).labels,
            (Labels{1, -2}));
  EXPECT_EQ(read("a.npy", npy(dictionary(">f8", "(1,)"), "\x40\x14\0\0\0\0\0\0"s)).labels,
            (Labels{5}));
  expect_unread("a.npy", npy(dictionary("<f4", "(1,)"), "\0\0\0\x3F"s), {"number 0", "0.5"});
  expect_unread("a.npy", npy(dictionary("<f4", "(2,)"), "\0\0\0\x3F"s), {"2 numbers", "4 bytes"});
  expect_unread("a.npy", npy(dictionary("<f4", "(4000000000000000000,)"), ""), {"shape"});
  expect_unread("a.npy", npy(dictionary("<f4", "(2, 3)"), std::string(24, '\0')), {"(2, 3)"});
  expect_unread("a.npy", npy(dictionary("<c8", "(1,)"), std::string(8, '\0')), {"<c8"});
  expect_unread("a.npy", npy("{'descr': [('x', '<i4')], 'shape': (1,)}", "1234"), {"descr"});
  expect_unread("a.npy", npy(dictionary("<i4", "(1,)"), "1234", 9), {"version 9"});
  expect_unread("a.npy", "1 2 3\n", {"NUMPY"});
  const std::string whole = npy(dictionary("<i4", "(1,)"), "\1\0\0\0"s);
  for (std::size_t size = 1; size < whole.size(); ++size) {
    expect_unread("a.npy", whole.substr(0, size), {"a.npy"});
  }
}

TEST(LabelLists, OfDataPerVertex) {
  EXPECT_EQ(read("a.dpv", "000 1 2 3 5\n001 1 2 3 -1.0\n").labels, (Labels{5, -1}));
  expect_unread("a.dpv", "000 1 2 3 0.5\n", {"vertex 0", "0.5"});
}

const std::string kTable =
    "<LabelTable><Label Key=\"0\" Red=\"0\" Green=\"0\" Blue=\"0\" Alpha=\"0\"><![CDATA[???]]>"
    "</Label><Label Key=\"7\" Red=\"1\" Green=\"0.2\" Blue=\"0\" Alpha=\"1\">\n motor &amp; more "
    "</Label></LabelTable>";
std::string gifti(const std::string& arrays) {
  return "<GIFTI Version=\"1.0\">" + kTable + arrays + "</GIFTI>";
}
std::string map_of(const std::string& name, const std::string& labels) {
  return "<DataArray Intent=\"NIFTI_INTENT_LABEL\" DataType=\"NIFTI_TYPE_INT32\" "
         "Dimensionality=\"1\" Dim0=\"4\" Encoding=\"ASCII\"><MetaData><MD><Name>Name</Name>"
         "<Value>" +
         name + "</Value></MD></MetaData><Data>" + labels + "</Data></DataArray>";
}

TEST(LabelLists, OfGiftiHaveNamesAndColors) {
  const std::string two = gifti(map_of("first", "0 7 7 0") + map_of("second", "7 7 0 9"));
  const LabelFile file = read("a.label.gii", two);
  EXPECT_EQ(file.labels, (Labels{0, 7, 7, 0}));
  EXPECT_EQ(file.names.at(0), "???");
  EXPECT_EQ(file.names.at(7), "motor & more");
  EXPECT_EQ(file.colors.at(7), (LabelColor{1, 0.2, 0, 1}));
  EXPECT_EQ(read("a.label.gii", two, "second").labels, (Labels{7, 7, 0, 9}));
  expect_unread("a.label.gii", two, {"called third", "first, second"}, "third");
  expect_unread("a.label.gii", gifti(""), {"NIFTI_INTENT_LABEL", "nothing"});
  expect_unread("a.label.gii", gifti(map_of("a", "0 7 7 0.5")), {"vertex 3", "0.5"});
  expect_unread(
      "a.gii",
      "<GIFTI><LabelTable><Label Key=\"x\"/></LabelTable>" + map_of("a", "0 0 0 0") + "</GIFTI>",
      {"Key"});
}

const MeshLists kSquare = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1.5, 0}}, {{0, 1, 2}, {0, 2, 3}}};

LabelOutput of_vertices(const Labels& labels) {
  LabelOutput output;
  output.labels = labels;
  return output;
}
LabelOutput of_faces(const Labels& labels) {
  LabelOutput output = of_vertices(labels);
  output.of_faces = true;
  return output;
}

TEST(LabelWriter, WritesLists) {
  EXPECT_EQ(label_bytes("a.txt", of_vertices({1, -2, 3, 4}), {}), "1\n-2\n3\n4\n");
  EXPECT_EQ(label_bytes("/dev/stdout", of_faces({1, 2}), {}), "1\n2\n");
  EXPECT_EQ(label_bytes("a.csv", of_vertices({1, -2}), {}), "vertex,label\n0,1\n1,-2\n");
  EXPECT_EQ(label_bytes("a.csv", of_faces({5}), {}), "face,label\n0,5\n");
  const std::string array = label_bytes("a.npy", of_faces({5, -1}), {});
  EXPECT_EQ(array.size() % 64, 16U);
  EXPECT_EQ(array.substr(array.size() - 16), "\5\0\0\0\0\0\0\0\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF"s);
  EXPECT_EQ(label_bytes("a.dpv", of_vertices({5, 0, 0, -1}), kSquare),
            "000 0 0 0 5\n001 1 0 0 0\n002 1 1 0 0\n003 0 1.5 0 -1\n");
  EXPECT_EQ(label_bytes("a.label", of_vertices({0, 7, -1, 7}), kSquare),
            "#!ascii label\n2\n1 1 0 0 7\n3 0 1.5 0 7\n");
}

TEST(LabelWriter, WritesWhatIsReadAgain) {
  for (const char* name :
       {"a.txt", "a.csv", "a.npy", "a.dpv", "a.annot", "a.label.gii", "a.ply", "a.vtk", "a.vtp"}) {
    const Labels labels = {0, 300, -1, 7};
    EXPECT_EQ(read(name, label_bytes(name, of_vertices(labels), kSquare)).labels, labels) << name;
  }
  for (const char* name : {"a.txt", "a.csv", "a.npy", "a.ply", "a.vtk", "a.vtp"}) {
    const Labels labels = {-5'000'000'000, 7};  // more than 32 bits
    EXPECT_EQ(read(name, label_bytes(name, of_faces(labels), kSquare)).labels, labels) << name;
  }
  EXPECT_EQ(read("a.label", label_bytes("a.label", of_vertices({0, 7, 0, 7}), kSquare)).labels,
            (Labels{0, 1, 0, 1}));
}

TEST(LabelWriter, KeepsNamesAndColors) {
  LabelOutput output = of_vertices({3, 5, 3, 9});
  output.names = {{3, "a & b < c"}, {5, "motor"}, {6, "unused"}};
  // Label 5 has the color of label 3, and label 9 has no color.
  output.colors = {{3, {1, 0, 0.2, 1}}, {5, {1, 0, 0.2, 1}}, {6, {0, 0, 1, 0}}};
  for (const char* name : {"a.annot", "a.label.gii"}) {
    const LabelFile back = read(name, label_bytes(name, output, kSquare));
    EXPECT_EQ(back.labels, output.labels) << name;
    EXPECT_EQ(back.names, (std::map<std::int64_t, std::string>{
                              {3, "a & b < c"}, {5, "motor"}, {6, "unused"}, {9, "label_9"}}))
        << name;
    EXPECT_EQ(back.colors.at(3), (LabelColor{1, 0, 0.2, 1})) << name;
    EXPECT_EQ(back.colors.at(6), (LabelColor{0, 0, 1, 0})) << name;
  }
  // Colors identify labels in an .annot file, so label 5 gets the next free color.
  const LabelFile annot = read("a.annot", label_bytes("a.annot", output, kSquare));
  EXPECT_EQ(annot.colors.at(5), (LabelColor{0, 1.0 / 255, 0.2, 1}));
}

TEST(LabelWriter, KeepsAttributesOfTheMesh) {
  MeshAttributes attributes;
  attributes.faces.push_back({"label", NumberType::kInt32, {1, 1}});
  attributes.faces.push_back({"area", NumberType::kFloat64, {0.5, 0.25}});
  const std::string bytes = label_bytes("a.ply", of_vertices({4, 5, 6, 7}), kSquare, attributes);
  MeshAttributes back;
  EXPECT_EQ(read_mesh("a.ply", bytes, back).points, kSquare.points);
  ASSERT_EQ(back.faces.size(), 1U);  // a reader would find the old labels before the new ones
  EXPECT_EQ(back.faces[0].values, (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(read("a.ply", bytes).labels, (Labels{4, 5, 6, 7}));
}

TEST(LabelWriter, RefusesLabelsThatAFormatCannotHold) {
  const auto write = [](const char* name, const LabelOutput& output) {
    return [name, &output] { return label_bytes(name, output, kSquare); };
  };
  for (const char* name : {"a.obj", "a.nii", "a.Stl"}) {
    expect_refused(write(name, of_vertices({0, 0, 0, 0})), {name, "known are", ".annot"});
  }
  for (const char* name : {"a.annot", "a.label", "a.gii", "a.dpv"}) {
    expect_refused(write(name, of_faces({0, 1})), {name, "of vertices"});
  }
  expect_refused(write("a.annot", of_vertices({0, -2, 0, 0})), {"-2", ".label.gii"});
  expect_refused(write("a.annot", of_vertices({0, 1 << 24, 0, 0})), {"16777216"});
  expect_refused(write("a.gii", of_vertices({0, 3'000'000'000, 0, 0})), {"3000000000", "32 bits"});
  expect_refused(write("a.label", of_vertices({0, 1, 2, 0})), {"1 and 2", ".annot"});
  expect_refused(write("a.ply", of_vertices({0, 1})), {"2 labels", "4 vertices"});
  EXPECT_NO_THROW(check_label_list_name("a.npy"));
  expect_refused([] { check_label_list_name("a.annot"); }, {".txt .csv .npy"});
}

class NibabelLabelFiles : public NibabelFolder {};

TEST_F(NibabelLabelFiles, AreTakenBothWays) {
  if (!has_nibabel()) GTEST_SKIP() << kNoNibabel;
  LabelOutput output = of_vertices({3, 5, -1, 9});
  output.names = {{3, "a & b"}, {5, "motor"}};
  output.colors = {{5, {1, 0, 0.2, 1}}};
  for (const char* name : {"a.annot", "a.label.gii", "a.npy", "a.dpv"}) {
    write(name, label_bytes(name, output, kSquare));
  }
  write("a.label", label_bytes("a.label", of_vertices({0, 7, 0, 7}), kSquare));
  ASSERT_TRUE(
      python("labels, table, names = fs.read_annot('a.annot')\n"
             "print(*labels, *table[5, :4], *(n.decode() for n in names), sep='|')\n"
             "image = nibabel.load('a.label.gii')\n"
             "print(*image.darrays[0].data, *image.labeltable.get_labels_as_dict().items())\n"
             "print(*image.labeltable.labels[2].rgba)\n"
             "print(*numpy.load('a.npy'))\n"
             "print(*fs.read_label('a.label'))\n"
             "print(*numpy.loadtxt('a.dpv')[:, 4].astype(int))\n"
             "numpy.save('b.npy', numpy.array([4, -5, 6], '>i2'))\n"
             "numpy.savetxt('b.txt', numpy.array([4, -5, 6]))\n"
             "from nibabel.gifti import GiftiImage, GiftiDataArray, GiftiLabelTable, GiftiLabel\n"
             "table = GiftiLabelTable()\n"
             "label = GiftiLabel(key=4, red=1, green=0.5, blue=0, alpha=1)\n"
             "label.label = 'four'\n"
             "table.labels.append(label)\n"
             "nibabel.save(GiftiImage(labeltable=table, darrays=[GiftiDataArray("
             "numpy.array([4, -5, 6], 'i4'), 'NIFTI_INTENT_LABEL')]), 'b.label.gii')\n"))
      << bytes_of(file("err.txt"));
  EXPECT_EQ(bytes_of(file("out.txt")),
            "3|5|-1|9|255|0|51|0|a & b|motor|label_9\n"
            "3 5 -1 9 (-1, '\?\?\?') (3, 'a & b') (5, 'motor') (9, 'label_9')\n"
            "1.0 0.0 0.2 1.0\n"
            "3 5 -1 9\n"
            "1 3\n"
            "3 5 -1 9\n");
  for (const char* name : {"b.npy", "b.txt", "b.label.gii"}) {
    EXPECT_EQ(read_label_file(file(name), {}).labels, (Labels{4, -5, 6})) << name;
  }
  EXPECT_EQ(read_label_file(file("b.label.gii"), {}).names.at(4), "four");
}

}  // namespace
}  // namespace talweg::test::label_lists
