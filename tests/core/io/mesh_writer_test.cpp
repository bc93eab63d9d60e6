#include "talweg/core/io/mesh_writer.hpp"

#include <string>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/temporary_folder.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {
namespace {

class MeshWriter : public TemporaryFolder {};

MeshLists awkward() {
  MeshLists lists = with_isolated_vertices(sphere(1), 2);
  for (Point& p : lists.points) p = p / 3 + Point(5e6, -1e-7, 0.1);
  return lists;
}

TEST_F(MeshWriter, TextAndPlyReadBackExactly) {
  const MeshLists lists = awkward();
  for (const char* name : {"a.obj", "a.off", "a.ply"}) {
    write_mesh(file(name), lists);
    const MeshLists back = read_mesh(file(name));
    EXPECT_EQ(back.points, lists.points) << name;
    EXPECT_EQ(back.triangles, lists.triangles) << name;
  }
}

TEST_F(MeshWriter, StlKeepsTheTrianglesInSinglePrecision) {
  const MeshLists lists = sphere(1);
  write_mesh(file("a.stl"), lists);
  const MeshLists back = read_mesh(file("a.stl"));
  ASSERT_EQ(back.triangles.size(), lists.triangles.size());
  for (std::size_t f = 0; f < lists.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(back.points[back.triangles[f][k]],
                lists.points[lists.triangles[f][k]].cast<float>().cast<double>());
    }
  }
}

TEST_F(MeshWriter, ReplacesAFileAndLeavesNothingBeside) {
  write("a.off", "old");
  write_mesh(file("a.off"), box());
  EXPECT_EQ(read_mesh(file("a.off")).triangles, box().triangles);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(file("."))) {
    files += entry.exists() ? 1 : 0;
  }
  EXPECT_EQ(files, 1U);
}

TEST_F(MeshWriter, ErrorsNameThePath) {
  for (const char* name : {"absent/a.ply", "a.xyz", "a"}) {
    try {
      write_mesh(file(name), box());
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadFile);
      EXPECT_NE(std::string(error.what()).find(file(name).string()), std::string::npos);
    }
  }
  EXPECT_THROW(write_mesh(file("a.stl"), with_index_out_of_range(box(), 3)), Error);
  EXPECT_FALSE(std::filesystem::exists(file("a.stl")));
}

}  // namespace
}  // namespace talweg::test
