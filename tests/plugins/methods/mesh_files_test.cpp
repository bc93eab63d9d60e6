// Mesh files through the plugin interface, as a host in C has them.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/temporary_folder.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/plugin/talweg_mesh_files.h"

namespace talweg::test {
namespace {

/// What a host keeps of a file.
struct Seen {
  std::vector<float> positions;
  std::vector<std::string> attributes, names, left_out;
  std::vector<float> uv;
  std::vector<std::uint32_t> corners, material;
  std::uint64_t polygons = 0;
  std::string frame;
  talweg_status answer = TALWEG_OK;
};

talweg_status take(void* context, const talweg_mesh_file* file) {
  Seen& seen = *static_cast<Seen*>(context);
  EXPECT_EQ(file->mesh->positions.type, std::uint32_t{TALWEG_FLOAT64});
  for (std::uint32_t k = 0; k < file->attribute_count; ++k) {
    const talweg_attribute& a = *file->attributes[k];
    seen.attributes.emplace_back(a.name);
    if (a.element == TALWEG_OF_CORNERS) {
      const auto* corners = static_cast<const std::uint32_t*>(a.corners.data);
      seen.corners.assign(corners, corners + 3 * a.corners.rows);
    } else if (seen.attributes.back() == "usemtl") {
      EXPECT_EQ(a.values.type, std::uint32_t{TALWEG_UINT32});
      const auto* values = static_cast<const std::uint32_t*>(a.values.data);
      seen.material.assign(values, values + a.values.rows);
    }
  }
  for (std::uint32_t k = 0; k < file->name_list_count; ++k) {
    const talweg_name_list& list = *file->name_lists[k];
    for (std::uint32_t n = 0; n < list.count; ++n) {
      seen.names.push_back(std::string(list.attribute) + ":" + list.names[n]);
    }
  }
  seen.polygons = file->polygon_count;
  seen.frame = file->frame;
  return seen.answer;
}

void left_out(void* context, const char* text) {
  static_cast<Seen*>(context)->left_out.emplace_back(text);
}

class MeshFilesOfPlugin : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    files_ = static_cast<const talweg_mesh_files*>(
        plugin_of_this_build("talweg.repair").get_extension(TALWEG_MESH_FILES));
    ASSERT_NE(files_, nullptr);
    ASSERT_EQ(files_->size, sizeof *files_);
    mesh_.size = sizeof mesh_;
    mesh_.positions = {positions_, 3, 0, 3, TALWEG_FLOAT32};
    mesh_.triangles = {triangle_, 1, 0, 3, TALWEG_INT32};
    file_.size = sizeof file_;
    file_.mesh = &mesh_;
  }
  talweg_status read(const std::string& name, Seen& seen) {
    return files_->read(file(name).string().c_str(), take, left_out, &seen, message_,
                        sizeof message_);
  }
  talweg_status write(const std::string& name, Seen* seen = nullptr) {
    return files_->write(file(name).string().c_str(), &file_, seen == nullptr ? nullptr : left_out,
                         seen, message_, sizeof message_);
  }
  void expect_refused(const std::string& part) {
    write_text("old.ply", "as it was");
    EXPECT_EQ(write("old.ply"), TALWEG_BAD_USAGE);
    EXPECT_NE(std::string(message_).find(part), std::string::npos) << message_;
    EXPECT_EQ(bytes_of(file("old.ply")), "as it was");
  }
  void write_text(const std::string& name, const std::string& text) {
    TemporaryFolder::write(name, text);
  }

  const talweg_mesh_files* files_ = nullptr;
  char message_[200] = "";
  float positions_[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::int32_t triangle_[3] = {0, 1, 2};
  talweg_mesh mesh_ = {};
  talweg_mesh_file file_ = {};
};

TEST_F(MeshFilesOfPlugin, GiveEverythingThatAFileSays) {
  write_text("a.obj",
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
             "usemtl red\nf 1/1 2/2 3/3\nusemtl blue\nf 1 3 4\ncurv 0 1 1 2\n");
  Seen seen;
  ASSERT_EQ(read("a.obj", seen), TALWEG_OK) << message_;
  EXPECT_EQ(seen.attributes, (std::vector<std::string>{"uv", "usemtl"}));
  EXPECT_EQ(seen.names, (std::vector<std::string>{"usemtl:", "usemtl:red", "usemtl:blue"}));
  EXPECT_EQ(seen.material, (std::vector<std::uint32_t>{1, 2}));
  constexpr std::uint32_t kNone = TALWEG_NO_ENTRY;
  EXPECT_EQ(seen.corners, (std::vector<std::uint32_t>{0, 1, 2, kNone, kNone, kNone}));
}

TEST_F(MeshFilesOfPlugin, CountPolygonsAndListUnreadContents) {
  write_text("a.off", "COFF\n4 1 0\n0 0 0 9\n1 0 0 9\n1 1 0 9\n0 1 0 9\n4 0 1 2 3\n");
  Seen seen;
  ASSERT_EQ(read("a.off", seen), TALWEG_OK) << message_;
  EXPECT_EQ(seen.polygons, 1U);
  EXPECT_EQ(seen.left_out.size(), 1U);
  seen.answer = TALWEG_OUT_OF_MEMORY;
  EXPECT_EQ(read("a.off", seen), TALWEG_HOST_FAILED);
  EXPECT_STREQ(message_, "The host refused the mesh.");
}

TEST_F(MeshFilesOfPlugin, WriteColumnsOfAttributesAndEdges) {
  const std::uint8_t colours[9] = {255, 0, 0, 0, 255, 0, 0, 0, 255};
  const talweg_attribute colour = {sizeof colour,
                                   TALWEG_OF_VERTICES,
                                   TALWEG_CARRY_ROUNDED,
                                   0,
                                   "colors",
                                   0,
                                   {colours, 3, 0, 3, TALWEG_UINT8},
                                   {}};
  const talweg_attribute* attributes[] = {&colour};
  const std::uint32_t edges[3] = {0, 2, 5};
  file_.attribute_count = 1;
  file_.attributes = attributes;
  file_.edges = {edges, 1, 0, 3, TALWEG_UINT32};
  Seen seen;
  ASSERT_EQ(write("a.ply", &seen), TALWEG_OK) << message_;
  const std::string bytes = bytes_of(file("a.ply"));
  for (const char* line : {"property uchar red\n", "property uchar blue\n", "element edge 1\n"}) {
    EXPECT_NE(bytes.find(line), std::string::npos) << line;
  }
  EXPECT_TRUE(seen.left_out.empty());
  ASSERT_EQ(write("a.stl", &seen), TALWEG_OK) << message_;
  EXPECT_EQ(seen.left_out.size(), 4U);  // three columns, and edges
}

TEST_F(MeshFilesOfPlugin, TellAndKeepTheSpaceOfCoordinates) {
  file_.frame = "mm RAS";
  ASSERT_EQ(write("a.ply"), TALWEG_OK) << message_;
  EXPECT_NE(bytes_of(file("a.ply")).find("comment SPACE=RAS\n"), std::string::npos);
  Seen seen;
  ASSERT_EQ(read("a.ply", seen), TALWEG_OK) << message_;
  EXPECT_EQ(seen.frame, "RAS");  // PLY has no unit
  for (const char* nothing : {"", static_cast<const char*>(nullptr)}) {
    file_.frame = nothing;
    ASSERT_EQ(write("b.ply"), TALWEG_OK) << message_;
    ASSERT_EQ(read("b.ply", seen), TALWEG_OK) << message_;
    EXPECT_EQ(seen.frame, "");
  }
  file_.frame = "mm LAS";
  expect_refused("LAS");
  // A host of interface 1.2 has no frame.
  file_.size = offsetof(talweg_mesh_file, frame);
  EXPECT_EQ(write("b.ply"), TALWEG_OK) << message_;
  file_.size = 8;
  expect_refused("too small");
}

TEST_F(MeshFilesOfPlugin, RefuseBadInputAndLeaveFilesAsTheyWere) {
  Seen seen;
  write_text("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 zero\n");
  EXPECT_EQ(read("bad.off", seen), TALWEG_BAD_FILE);
  EXPECT_NE(std::strstr(message_, "bad.off, line 4"), nullptr) << message_;
  EXPECT_EQ(files_->read(nullptr, take, nullptr, &seen, nullptr, 0), TALWEG_BAD_USAGE);
  EXPECT_EQ(files_->read("a.ply", nullptr, nullptr, &seen, nullptr, 0), TALWEG_BAD_USAGE);
  EXPECT_EQ(files_->write("a.ply", nullptr, nullptr, nullptr, nullptr, 0), TALWEG_BAD_USAGE);
  EXPECT_EQ(write("a.vtu"), TALWEG_BAD_FILE);
  const std::uint32_t edges[3] = {0, 3, 0};
  file_.edges = {edges, 1, 0, 3, TALWEG_UINT32};
  expect_refused("vertex 3, and the mesh has 3");
  file_.edges = {};
  const char* texts[] = {"none"};
  talweg_name_list list = {sizeof list, 1, "g", texts};
  const talweg_name_list* lists[] = {&list};
  file_.name_lists = lists;
  file_.name_list_count = 1;
  expect_refused("\"g\"");
  file_.name_list_count = 0;
  file_.attribute_count = 1;
  expect_refused("The attributes are null.");
  file_.attribute_count = 0;
  triangle_[2] = 7;
  EXPECT_EQ(write("old.ply"), TALWEG_BAD_MESH);
  EXPECT_NE(std::strstr(message_, "vertex 7"), nullptr) << message_;
  EXPECT_EQ(bytes_of(file("old.ply")), "as it was");
}

}  // namespace
}  // namespace talweg::test
