// Spaces and units named in files, and the conversion of positions between them.
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/curve_files.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg::coordinate_frames {
namespace {

using Frames = test::CurveFiles;
const CoordinateFrame kInRas{LengthUnit(), PatientSpace::kRas};
const CoordinateFrame kInLps{LengthUnit(), PatientSpace::kLps};

const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

std::string ply(const std::string& comments) {
  return "ply\nformat ascii 1.0\n" + comments +
         "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
}

std::string binary_stl(std::string header) {
  header.resize(80, ' ');
  std::string bytes = header + std::string("\1\0\0\0", 4);
  for (const float x : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) {
    std::array<char, 4> raw{};
    std::memcpy(raw.data(), &x, 4);
    bytes.append(raw.data(), 4);
  }
  return bytes + std::string(2, '\0');
}

TEST_F(Frames, OfMeshesAreReadWhereSlicerWritesThem) {
  const auto space = [&](const char* name, const std::string& bytes) {
    return read_mesh(path(name), bytes).space;
  };
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(space("a.ply", ply("comment 3D Slicer output. SPACE=RAS\n")), PatientSpace::kRas);
  EXPECT_EQ(space("a.ply", ply("comment VTK\ncomment SPACE=LPS\r\n")), PatientSpace::kLps);
  EXPECT_EQ(space("a.ply", ply("obj_info SPACE=RAS\n")), PatientSpace::kRas);
  EXPECT_EQ(space("a.ply", ply("")), PatientSpace::kNotSaid);
  EXPECT_EQ(space("a.obj", "# 3D Slicer output. SPACE=RAS\n" + obj), PatientSpace::kRas);
  EXPECT_EQ(space("a.obj", "# one\n\n  # SPACE=LPS\n" + obj), PatientSpace::kLps);
  EXPECT_EQ(space("a.obj", obj + "# SPACE=RAS\n"), PatientSpace::kNotSaid);
  EXPECT_EQ(space("a.stl", "solid 3D Slicer output. SPACE=RAS\n" + kFacet + "endsolid\n"),
            PatientSpace::kRas);
  EXPECT_EQ(space("a.stl", binary_stl("3D Slicer output. SPACE=LPS")), PatientSpace::kLps);
  // Other words name no space.
  for (const char* note : {"SPACE=RASTER", "SPACE=", "SPACE=LAS", "NOSPACE RAS", "space=RAS"}) {
    EXPECT_EQ(space("a.ply", ply("comment " + std::string(note) + "\n")), PatientSpace::kNotSaid)
        << note;
    EXPECT_EQ(space("a.stl", binary_stl(note)), PatientSpace::kNotSaid) << note;
  }
}

TEST_F(Frames, OfMeshesAreKeptInFiles) {
  MeshLists lists = read_mesh(path("a.ply"), ply("comment SPACE=RAS\n"));
  for (const char* name : {"b.ply", "b.obj", "b.stl"}) {
    EXPECT_TRUE(write_mesh(path(name), lists, {}).empty()) << name;
    const MeshLists back = read_mesh(path(name));
    EXPECT_EQ(back.space, PatientSpace::kRas) << name;
    EXPECT_EQ(back.points, lists.points) << name;
  }
  EXPECT_EQ(write_mesh(path("b.off"), lists, {}),
            (std::vector<std::string>{"the space of coordinates (RAS)"}));
  lists.space = PatientSpace::kNotSaid;
  EXPECT_EQ(mesh_bytes("b.ply", lists).bytes.find("SPACE"), std::string::npos);
}

std::string markup(const std::string& members) {
  return R"({"markups": [{"type": "Curve", )" + members +
         R"("controlPoints": [{"position": [1, 2, 3]}, {"position": [4, 5, 6]}]}]})";
}

const std::vector<Point> kAsIs{{1, 2, 3}, {4, 5, 6}};
const std::vector<Point> kTurned{{-1, -2, 3}, {-4, -5, 6}};

TEST_F(Frames, OfMarkupsAreConvertedToFramesOfMeshes) {
  const auto expect = [&](const std::string& system, const CoordinateFrame& mesh, bool turned) {
    const std::string member = system.empty() ? "" : "\"coordinateSystem\": \"" + system + "\", ";
    const auto curves = read_curves(path("a.mrk.json"), markup(member), mesh);
    EXPECT_EQ(test::positions(curves.at(0)), turned ? kTurned : kAsIs) << system;
    EXPECT_EQ(curves[0].notes.size(), turned ? 1U : 0U) << system;
  };
  for (const char* lps : {"", "LPS", "1"}) {
    expect(lps, {}, false);
    expect(lps, kInLps, false);
    expect(lps, kInRas, true);
  }
  for (const char* ras : {"RAS", "0"}) {
    expect(ras, {}, true);
    expect(ras, kInLps, true);
    expect(ras, kInRas, false);
  }
  expect_refused("a.mrk.json", markup("\"coordinateSystem\": \"2\", "),
                 {"coordinateSystem", "RAS"});
  const auto curves = read_curves(
      path("a.mrk.json"), markup("\"coordinateSystem\": \"LPS\", \"coordinateUnits\": \"cm\", "),
      {LengthUnit::named("mm"), PatientSpace::kRas});
  EXPECT_EQ(test::positions(curves.at(0)).front(), Point(-10, -20, 30));
  EXPECT_EQ(curves[0].notes.at(0),
            "The positions of a.mrk.json were turned from LPS to RAS (x and y change their sign) "
            "and scaled by 10 from cm to mm.");
}

TEST_F(Frames, OfOtherCurveFilesAreKnownByTheirNotes) {
  const std::string obj = "v 1 2 3\nv 4 5 6\nl 1 2\n";
  const std::string lines = "POINTS 2 double\n1 2 3\n4 5 6\nLINES 1 3\n2 0 1\n";
  const auto vtk = [&](const std::string& title) {
    return "# vtk DataFile Version 3.0\n" + title + "\nASCII\nDATASET POLYDATA\n" + lines;
  };
  const auto ply_of = [](const std::string& comment) {
    return "ply\nformat ascii 1.0\n" + comment +
           "element vertex 2\nproperty float x\nproperty float y\nproperty float z\nelement edge "
           "1\nproperty int vertex1\nproperty int vertex2\nend_header\n1 2 3\n4 5 6\n0 1\n";
  };
  const auto vtp = [](const std::string& data) {
    return "<VTKFile type=\"PolyData\"><PolyData>" + data +
           "<Piece NumberOfPoints=\"2\" NumberOfLines=\"1\"><Points><DataArray type=\"Float64\" "
           "NumberOfComponents=\"3\">1 2 3 4 5 6</DataArray></Points><Lines><DataArray "
           "type=\"Int64\" Name=\"connectivity\">0 1</DataArray><DataArray type=\"Int64\" "
           "Name=\"offsets\">2</DataArray></Lines></Piece></PolyData></VTKFile>";
  };
  const std::string field =
      "<FieldData><Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" format=\"ascii\">82 "
      "65 83 0</Array></FieldData>";
  const std::vector<std::array<std::string, 3>> files = {
      {"a.obj", obj, "# 3D Slicer output. SPACE=RAS\n" + obj},
      {"a.vtk", vtk("x"), vtk("3D Slicer output. SPACE=RAS")},
      {"a.ply", ply_of(""), ply_of("comment SPACE=RAS\n")},
      {"a.vtp", vtp(""), vtp(field)}};
  for (const auto& [name, plain, noted] : files) {
    // A file that names no space is in the space of its mesh.
    for (const CoordinateFrame& frame : {CoordinateFrame(), kInLps, kInRas}) {
      EXPECT_EQ(test::positions(read_curves(path(name), plain, frame).at(0)), kAsIs) << name;
    }
    EXPECT_EQ(test::positions(read_curves(path(name), noted, kInRas).at(0)), kAsIs) << name;
    for (const CoordinateFrame& frame : {CoordinateFrame(), kInLps}) {
      const auto curves = read_curves(path(name), noted, frame);
      EXPECT_EQ(test::positions(curves.at(0)), kTurned) << name;
      EXPECT_EQ(curves[0].notes.size(), 1U) << name;
    }
  }
}

TEST_F(Frames, OfWrittenCurvesComeBack) {
  const SurfaceMesh mesh = test::odd_sphere();
  const std::vector<SurfaceCurve> curves{test::ring(mesh)};
  const std::vector<Point> expected = positions_of(mesh, curves[0]);
  for (const char* name : {"a.obj", "a.ply", "a.vtk", "a.vtp", "a.mrk.json", "a.fcsv"}) {
    write_curves(path(name), mesh, curves, kInRas);
    const auto back = read_curves(path(name), kInRas);
    EXPECT_EQ(test::positions(back.at(0)), expected) << name;
    const auto in_lps = test::positions(read_curves(path(name), kInLps).at(0));
    EXPECT_EQ(in_lps.at(1).x(), -expected[1].x()) << name;
    EXPECT_EQ(in_lps.at(1).z(), expected[1].z()) << name;
  }
  const auto root = nlohmann::json::parse(bytes_of(path("a.mrk.json")));
  EXPECT_EQ(root["markups"][0]["coordinateSystem"], "LPS");
  EXPECT_EQ(root["markups"][0]["controlPoints"][1]["position"][1], -expected[1].y());
  EXPECT_NE(bytes_of(path("a.fcsv")).find("# CoordinateSystem = LPS\n"), std::string::npos);
}

TEST_F(Frames, AreNamed) {
  EXPECT_EQ(frame_named("").space, PatientSpace::kNotSaid);
  EXPECT_EQ(frame_named("").unit.code(), "mm");
  EXPECT_EQ(frame_named("cm").unit.code(), "cm");
  EXPECT_EQ(frame_named("RAS").space, PatientSpace::kRas);
  EXPECT_EQ(frame_named("um LPS").unit.code(), "um");
  EXPECT_EQ(frame_named("um LPS").space, PatientSpace::kLps);
  for (const char* wrong : {"RAS mm", "mm LAS", "furlong", "furlong RAS", " ", "mm  RAS"}) {
    EXPECT_THROW(frame_named(wrong), Error) << wrong;
  }
  EXPECT_EQ(frame_text({}, PatientSpace::kNotSaid), "");
  EXPECT_EQ(frame_text({}, PatientSpace::kRas), "RAS");
  EXPECT_EQ(frame_text(LengthUnit::named("m"), PatientSpace::kNotSaid), "m");
  EXPECT_EQ(frame_text(LengthUnit::named("m"), PatientSpace::kLps), "m LPS");
}

}  // namespace
}  // namespace talweg::coordinate_frames
