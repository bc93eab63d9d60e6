// Invalid results of a plugin are errors in hosts: the error names the plugin and the result, and
// the host keeps no result of the run.
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "places.hpp"
#include "plugins/driver_runs.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg::test {
namespace {

/// The faults of the plugin, and the words that the error must have.
const std::map<std::string, std::string> kFaults = {
    {"nan_position", "positions has a number in row 1 that is not finite"},
    {"infinite_position", "positions has a number in row 2 that is not finite"},
    {"face_out_of_range", "faces has 1000000000 in row 1, but there are 1200"},
    {"vertex_out_of_range", "vertices has 77777777 in row 2, but there are 651"},
    {"nan_weights", "barycentrics has weights that are negative or do not add up to 1, in row 1"},
    {"large_weights", "barycentrics has weights that are negative or do not add up to 1, in row 2"},
    {"few_positions", "positions has 2 rows, not 3"},
    {"few_weights", "barycentrics has 1 rows, not 3"},
    {"no_points", "A curve has no points"},
    {"null_data", "has rows but no data"},
    {"real_faces", "must be integers"},
    {"short_field", "A curve's field toy has 2 rows, not 3"},
    {"null_name", "A field's name is null"},
    {"null_fields", "The list of fields is null"},
    {"curve_number", "The report's entry value is about curve 1000000000000, but there are 1"},
    {"null_key", "A key of the report is null"},
    {"null_text", "A text of the report is null"},
    {"no_value", "The report's entry value has no single value"},
    {"short_mesh_field", "The field field has 650 rows, not 651"},
    {"mesh_corner", "triangles has 99 in row 0, but there are 3"},
    {"goes_on", "positions has a number in row 1 that is not finite"}};

class HostilePlugin : public DriverRuns {
 protected:
  HostilePlugin() : loader_(talweg_loader_open(toy_folder())), lists_(grid(30, 20)) {}

  [[nodiscard]] host::Results run_hostile(const std::string& fault) const {
    const host::Services services("test", "1");
    host::Instance instance(*talweg_loader_find(loader_.get(), "toy.hostile"), services);
    instance.set("fault", fault);
    test::set_mesh(instance, lists_);
    host::Curve curve;
    curve.vertices = {0, 1};
    instance.set_curves({curve});
    return instance.run({true, true, true});
  }

  Loader loader_;
  MeshLists lists_;
};

TEST_F(HostilePlugin, ValidResultsAreAccepted) {
  const host::Results results = run_hostile("none");
  ASSERT_EQ(results.curves.size(), 1U);
  EXPECT_EQ(results.curves[0].faces.size(), 3U);
  EXPECT_EQ(results.fields.size(), 1U);
  EXPECT_EQ(results.meshes.size(), 1U);
  EXPECT_EQ(results.number("value"), 1);
}

TEST_F(HostilePlugin, InvalidResultsAreErrorsThatNameTheResult) {
  for (const auto& [fault, words] : kFaults) {
    try {
      (void)run_hostile(fault);
      ADD_FAILURE() << fault << " was taken";
    } catch (const host::Error& error) {
      EXPECT_EQ(error.status(), TALWEG_INTERNAL) << fault;
      const std::string sentence = error.what();
      EXPECT_NE(sentence.find("The plugin toy.hostile gave an invalid result. "), std::string::npos)
          << sentence;
      EXPECT_NE(sentence.find(words), std::string::npos) << fault << ": " << sentence;
    }
  }
}

TEST_F(HostilePlugin, TheDriverReportsTheErrorAndWritesNothing) {
  write_mesh(file("mesh.ply"), lists_);
  ASSERT_EQ(run("draw mesh.ply --through 64,400,590 -o drawn.obj").code, 0);
  for (const char* fault : {"nan_position", "face_out_of_range", "curve_number", "null_text"}) {
    const Outcome outcome =
        run("run toy.hostile mesh.ply --curve drawn.obj -o out.obj --report out.json --fault " +
                std::string(fault),
            "export TALWEG_PLUGIN_PATH='" + std::string(toy_folder()) + "'");
    EXPECT_EQ(outcome.code, 5) << outcome.err;
    EXPECT_NE(outcome.err.find(kFaults.at(fault)), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(file("out.obj"))) << fault;
    EXPECT_FALSE(std::filesystem::exists(file("out.json"))) << fault;
  }
}

}  // namespace
}  // namespace talweg::test
