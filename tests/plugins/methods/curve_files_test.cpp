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
};

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
