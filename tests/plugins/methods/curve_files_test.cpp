// Curve files through the plugin interface: units.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/temporary_folder.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/plugin/talweg_curve_files.h"
#include "talweg/plugin/talweg_host.hpp"

namespace talweg::test {
namespace {

class CurveFileUnits : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    const talweg_plugin& draw = plugin_of_this_build("talweg.draw");
    first_ = static_cast<const talweg_curve_files*>(draw.get_extension(TALWEG_CURVE_FILES));
    second_ = static_cast<const talweg_curve_files_2*>(draw.get_extension(TALWEG_CURVE_FILES_2));
    ASSERT_NE(first_, nullptr);
    ASSERT_NE(second_, nullptr);
    ASSERT_EQ(second_->size, sizeof *second_);
    third_ = static_cast<const talweg_curve_files_3*>(draw.get_extension(TALWEG_CURVE_FILES_3));
    ASSERT_NE(third_, nullptr);
    ASSERT_EQ(third_->size, sizeof *third_);
    write("cm.mrk.json",
          R"({"markups": [{"type": "Curve", "coordinateUnits": "cm", "controlPoints": [
             {"position": [1, 2, 3]}, {"position": [4, 5, 6]}]}]})");
  }

  static talweg_status take(void* context, const talweg_curve* curve) {
    const auto* xyz = static_cast<const double*>(curve->positions.data);
    static_cast<std::vector<double>*>(context)->assign(xyz, xyz + 3 * curve->positions.rows);
    return TALWEG_OK;
  }

  const talweg_curve_files* first_ = nullptr;
  const talweg_curve_files_2* second_ = nullptr;
  const talweg_curve_files_3* third_ = nullptr;
};

/// A square of two triangles.
class SquareMesh {
 public:
  [[nodiscard]] const talweg_mesh* view() const { return &view_; }

 private:
  std::vector<double> positions_ = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  std::vector<std::uint32_t> triangles_ = {0, 1, 2, 0, 2, 3};
  talweg_mesh view_ = {sizeof view_, 0, host::view(positions_.data(), 4, 3),
                       host::view(triangles_.data(), 2, 3), nullptr};
};

talweg_status keep(void* context, const talweg_curve* curve) {
  static_cast<std::vector<host::Curve>*>(context)->push_back(host::detail::copy(*curve));
  return TALWEG_OK;
}

TEST_F(CurveFileUnits, BordersNeedTheMeshWhoseVerticesTheyName) {
  const auto border = [&](const std::string& vertices) {
    write("a.border",
          "<BorderFile Version=\"3\" SurfaceNumberOfVertices=\"5\"><Class><Border><BorderPart "
          "Closed=\"False\"><Vertices>" +
              vertices +
              "</Vertices><Weights>0.5 0.25 0.25 1 0 0"
              "</Weights></BorderPart></Border></Class></BorderFile>");
    return file("a.border").string();
  };
  const SquareMesh square;
  std::vector<host::Curve> found;
  const talweg_sink sink = {sizeof sink, 0, &found, keep, nullptr, nullptr, nullptr};
  char message[400] = "";
  const auto read = [&](const std::string& path, const talweg_mesh* mesh) {
    found.clear();
    return third_->read(path.c_str(), nullptr, mesh, &sink, message, sizeof message);
  };
  // Vertex 3 is only in the second triangle, whose corners are 0, 2 and 3.
  ASSERT_EQ(read(border("3 0 2 1 1 1"), square.view()), TALWEG_OK) << message;
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].faces, (std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(found[0].barycentrics[0], (std::array<double, 3>{0.25, 0.25, 0.5}));
  EXPECT_EQ(found[0].barycentrics[1], (std::array<double, 3>{0, 1, 0}));

  EXPECT_EQ(read(border("3 1 2 1 1 1"), square.view()), TALWEG_BAD_CURVE);
  EXPECT_NE(std::string(message).find("vertices 3, 1 and 2; does the curve belong to this mesh?"),
            std::string::npos)
      << message;
  EXPECT_EQ(read(border("4 4 4 1 1 1"), square.view()), TALWEG_BAD_CURVE);
  EXPECT_EQ(read(border("3 0 2 1 1 1"), nullptr), TALWEG_BAD_FILE);
  EXPECT_NE(std::string(message).find("together with that mesh"), std::string::npos) << message;
  EXPECT_TRUE(found.empty());
}

TEST_F(CurveFileUnits, BordersAreWrittenWithTheCornersOfTheFaces) {
  host::Curve curve;
  curve.faces = {1, 1};
  curve.barycentrics = {{0.25, 0.25, 0.5}, {1, 0, 0}};
  curve.positions = {{0.25, 0.75, 0}, {0, 0, 0}};
  const SquareMesh square;
  const auto written = [&](const talweg_mesh* mesh) {
    const talweg_curve view = host::detail::view_of(curve);
    const talweg_curve* list[] = {&view};
    return third_->write(file("lh.border").c_str(), nullptr, mesh, list, 1, nullptr, 0);
  };
  EXPECT_EQ(written(nullptr), TALWEG_BAD_FILE);
  ASSERT_EQ(written(square.view()), TALWEG_OK);
  const std::string text = bytes_of(file("lh.border"));
  EXPECT_NE(text.find("SurfaceNumberOfVertices=\"4\""), text.npos);
  EXPECT_NE(text.find("<Vertices>0 2 3\n0 2 3\n</Vertices>"), text.npos) << text;
  EXPECT_NE(text.find("<Weights>0.25 0.25 0.5\n1 0 0\n</Weights>"), text.npos) << text;
  curve.faces = {1, 2};
  EXPECT_EQ(written(square.view()), TALWEG_BAD_USAGE);
}

TEST_F(CurveFileUnits, AreConvertedToMillimetresOrToTheUnitThatIsTold) {
  const std::string path = file("cm.mrk.json").string();
  std::vector<double> found;
  const talweg_sink sink = {sizeof sink, 0, &found, take, nullptr, nullptr, nullptr};
  char message[200] = "";
  ASSERT_EQ(first_->read(path.c_str(), &sink, message, sizeof message), TALWEG_OK) << message;
  EXPECT_EQ(found, (std::vector<double>{10, 20, 30, 40, 50, 60}));
  ASSERT_EQ(second_->read(path.c_str(), nullptr, &sink, message, sizeof message), TALWEG_OK);
  EXPECT_EQ(found, (std::vector<double>{10, 20, 30, 40, 50, 60}));
  ASSERT_EQ(second_->read(path.c_str(), "cm", &sink, message, sizeof message), TALWEG_OK);
  EXPECT_EQ(found, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(second_->read(path.c_str(), "furlong", &sink, message, sizeof message),
            TALWEG_BAD_USAGE);
  EXPECT_NE(std::string(message).find("furlong"), std::string::npos);
}

TEST_F(CurveFileUnits, SpacesAreThoseOfTheMeshAndTheSuccessTellsWhatWasTurned) {
  const std::string path = file("cm.mrk.json").string();
  std::vector<double> found;
  const talweg_sink sink = {sizeof sink, 0, &found, take, nullptr, nullptr, nullptr};
  char message[200] = "x";
  ASSERT_EQ(second_->read(path.c_str(), "cm LPS", &sink, message, sizeof message), TALWEG_OK);
  EXPECT_EQ(found, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_STREQ(message, "");
  ASSERT_EQ(second_->read(path.c_str(), "RAS", &sink, message, sizeof message), TALWEG_OK);
  EXPECT_EQ(found, (std::vector<double>{-10, -20, 30, -40, -50, 60}));
  EXPECT_NE(std::string(message).find("turned from LPS to RAS"), std::string::npos) << message;
  EXPECT_EQ(second_->read(path.c_str(), "cm LAS", &sink, message, sizeof message),
            TALWEG_BAD_USAGE);
}

TEST_F(CurveFileUnits, NameTheUnitOfTheMesh) {
  host::Curve curve;
  curve.faces = {0, 0};
  curve.barycentrics = {{1, 0, 0}, {0, 1, 0}};
  curve.positions = {{0, 0, 0}, {1, 0, 0}};
  const talweg_curve view = host::detail::view_of(curve);
  const talweg_curve* list[] = {&view};
  const std::string path = file("out.mrk.json").string();
  const auto unit = [&] {
    return nlohmann::json::parse(bytes_of(path))["markups"][0]["coordinateUnits"];
  };
  ASSERT_EQ(first_->write(path.c_str(), list, 1, nullptr, 0), TALWEG_OK);
  EXPECT_EQ(unit(), "mm");
  ASSERT_EQ(second_->write(path.c_str(), "um", list, 1, nullptr, 0), TALWEG_OK);
  EXPECT_EQ(unit(), "um");
  EXPECT_EQ(second_->write(path.c_str(), "furlong", list, 1, nullptr, 0), TALWEG_BAD_USAGE);
  EXPECT_EQ(unit(), "um");  // as it was
}

}  // namespace
}  // namespace talweg::test
