// The driver's sentences on arguments that are empty or misspelt, and on names, units, places and
// sizes that cannot be meant.
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/generated_meshes.hpp"
#include "places.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/io/mesh_writer.hpp"
#include "talweg/core/version.hpp"
#include "talweg/heat/cholesky_factor.hpp"

namespace talweg {
namespace {

class DriverHabits : public test::DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    write_mesh(file("mesh.ply"), test::grid(30, 20));
  }
};

TEST_F(DriverHabits, RefusesEmptyValuesOfEveryOptionOfEveryCommand) {
  write("a.txt", "64\n65\n66\n");
  const std::pair<const char*, const char*> commands[] = {
      {"draw", "mesh.ply --through 64,65 -o out.txt"},
      {"smooth", "mesh.ply --curve a.txt -o out.obj"},
      {"measure", "mesh.ply a.txt"},
      {"cut", "mesh.ply --curve a.txt -o out.ply"},
      {"labels", "mesh.ply a.txt"},
      {"compare", "mesh.ply --curve a.txt"},
      {"info", "mesh.ply"},
      {"run talweg.smooth", "mesh.ply --curve a.txt"}};
  std::size_t options = 0;
  for (const auto& [command, rest] : commands) {
    // Every option that its help tells, with an empty value in both ways of writing it.
    const std::string help = run(std::string(command) + " --help").out;
    for (std::size_t at = 0; (at = help.find("--", at)) != std::string::npos;) {
      const std::size_t end = help.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", at);
      const std::string option = help.substr(at, end - at);
      at = end;
      if (option.size() < 4 || option == "--help") continue;
      ++options;
      const std::string line = std::string(command) + " " + rest + " " + option;
      expect_failure(line + " ''", 1, {option.c_str(), "is empty"});
      expect_failure(line + "=", 1, {option.c_str(), "is empty"});
    }
    expect_failure(std::string(command) + " '' " + rest, 1, {"is empty"});
  }
  EXPECT_GT(options, 60U);
  expect_failure("smooth mesh.ply --curve a.txt -o ''", 1, {"-o", "is empty"});
  expect_failure("smooth mesh.ply --curve a.txt -o=", 1, {"-o", "is empty"});
  expect_failure("--threads '' info mesh.ply", 1, {"--threads", "is empty"});
  expect_failure("'' mesh.ply", 1, {"is empty"});
  // Lists with a missing element.
  for (const char* list : {",65", "64,", "64,,65", ","}) {
    expect_failure(std::string("draw mesh.ply -o out.txt --through ") + list, 1,
                   {"--through", "empty"});
    expect_failure(std::string("smooth mesh.ply --curve a.txt --pin=") + list, 1,
                   {"--pin", "empty"});
    expect_failure(std::string("run talweg.smooth mesh.ply --curve a.txt --pin ") + list, 1,
                   {"--pin", "empty"});
  }
  for (const char* blank : {"' '", "'1 2'", "'1x'"}) {
    expect_failure(std::string("smooth mesh.ply --curve a.txt --tau ") + blank, 1, {"--tau"});
    expect_failure(std::string("smooth mesh.ply --curve a.txt --max-deviation ") + blank, 1,
                   {"--max-deviation"});
  }
  EXPECT_FALSE(std::filesystem::exists(file("out.obj")));
}

TEST_F(DriverHabits, SuggestsTheWordNearestToAMisspeltOne) {
  write("a.txt", "64\n65\n66\n");
  const std::pair<const char*, const char*> misspelt[] = {
      {"smoth mesh.ply", "did you mean smooth?"},
      {"mesure mesh.ply a.txt", "did you mean measure?"},
      {"lables mesh.ply a.txt", "did you mean labels?"},
      {"inof mesh.ply", "did you mean info?"},
      {"smooth mesh.ply --curve a.txt --taw 2", "did you mean --tau?"},
      {"smooth mesh.ply --curve a.txt --taw=2", "did you mean --tau?"},
      {"smooth mesh.ply --curve a.txt --max-dev 2", "did you mean --max-deviation?"},
      {"smooth mesh.ply --curve a.txt --max-deviaton 2", "did you mean --max-deviation?"},
      {"smooth mesh.ply --curve a.txt --quite", "did you mean --quiet?"},
      {"draw mesh.ply --trough 1,2 -o a.obj", "did you mean --through?"},
      {"cut mesh.ply --curves a.txt -o b.ply", "did you mean --curve?"},
      {"info --jsn mesh.ply", "did you mean --json?"},
      {"run talweg.smooth mesh.ply --curve a.txt --taw 1", "did you mean --tau?"}};
  for (const auto& [line, words] : misspelt) expect_failure(line, 1, {words});
  expect_failure("run talweg.smoth mesh.ply --curve a.txt", 2, {"did you mean talweg.smooth?"});
  write("list.csv", "mesh,curve,max_devation\nmesh.ply,a.txt,1\n");
  expect_failure("smooth --batch list.csv -o b.obj", 2, {"did you mean max-deviation?"});
  // Words that resemble no known word.
  for (const char* line : {"polish mesh.ply", "smooth mesh.ply --curve a.txt --colour red",
                           "smooth mesh.ply other.ply --curve a.txt"}) {
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.code, 1) << line;
    EXPECT_NE(outcome.err.find("was not expected"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("did you mean"), std::string::npos) << outcome.err;
  }
}

TEST_F(DriverHabits, TheVersionIsTheFirstLineAndTheLibrariesOfTheFactorTheSecond) {
  const Outcome outcome = run("--version");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, std::string("talweg ") + version() + "\n" + factor_libraries() + "\n");
}

TEST_F(DriverHabits, OutputThatCannotBePrintedIsAnError) {
  write("a.txt", "64\n65\n66\n");
  for (const char* words :
       {"--help", "--version", "smooth --help", "run talweg.smooth --help", "plugins",
        "info mesh.ply", "measure mesh.ply a.txt", "measure mesh.ply a.txt --report -"}) {
    const std::string command = "cd '" + file("").string() + "' && '" + test::driver_program() +
                                "' " + words + " >/dev/full 2>err.txt </dev/null";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 2) << words;
    EXPECT_NE(bytes_of(file("err.txt")).find("standard output"), std::string::npos) << words;
  }
}

TEST_F(DriverHabits, NamesThatAreNoUtf8AreNamesAllTheSame) {
  write("a.txt", "64\n65\n66\n");
  const Outcome outcome =
      run("cut mesh.ply --curve a.txt -o \"$(printf 'b\\377.ply')\" --map m.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(file("b\xff.ply")));
  const auto map = nlohmann::json::parse(bytes_of(file("m.json")));
  EXPECT_EQ(map["parts"][0]["file"], "b\xEF\xBF\xBD.ply");  // the mark of what cannot be shown
  EXPECT_EQ(run("measure mesh.ply a.txt --report \"$(printf 'r\\377.json')\"").code, 0);
  EXPECT_TRUE(nlohmann::json::accept(bytes_of(file("r\xff.json"))));
}

TEST_F(DriverHabits, ASoupIsToldToBeWeldedByVerdictAndRefusal) {
  const MeshLists mesh = test::grid(30, 20);
  MeshLists soup;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t v : t) soup.points.push_back(mesh.points[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  write_mesh(file("soup.ply"), soup);
  const char* words[] = {"with --repair=weld the mesh", "1 part instead of 1,200",
                         "1 boundary loop instead of 1,200 boundary loops"};
  const Outcome info = run("info soup.ply");
  EXPECT_EQ(info.code, 0);
  for (const char* word : words) EXPECT_NE(info.out.find(word), std::string::npos) << info.out;
  const auto json = nlohmann::json::parse(run("info soup.ply --json").out);
  EXPECT_EQ(json["weld"]["steps"], "weld");
  EXPECT_EQ(json["weld"]["components"], 1);
  EXPECT_EQ(json["weld"]["vertices"], 3 * 1200 - 651);
  EXPECT_TRUE(nlohmann::json::parse(run("info mesh.ply --json").out)["weld"].is_null());
  write("a.obj", "v 1 1 0\nv 9 8 0\nl 1 2\n");
  write("a.txt", "0\n3000\n");
  expect_failure("draw soup.ply --through 0,3000 -o b.obj", 2, {words[0], words[1], words[2]});
  write("c.fcsv",
        "# CoordinateSystem = LPS\n# columns = id,x,y,z\n1,1.2,1.3,0\n2,9.2,8.3,0\n3,2.2,9.3,0\n");
  expect_failure("draw soup.ply --clicks c.fcsv -o b.obj", 2, {words[0], words[1], words[2]});
  for (const char* command : {"smooth", "cut -o b.ply", "compare", "run talweg.smooth"}) {
    for (const char* curve : {" --curve a.obj", " --curve a.txt"}) {
      const std::string line = std::string(command) + " soup.ply" + curve;
      expect_failure(line, 2, {words[0], words[1], words[2]});
    }
  }
  expect_failure("measure soup.ply a.obj", 2, {words[0]});
  std::string labels;
  for (int f = 0; f < 1200; ++f) labels += f < 600 ? "1\n" : "2\n";
  write("labels.txt", labels);
  expect_failure("labels soup.ply labels.txt", 2, {"no border", words[0]});
  EXPECT_EQ(run("draw soup.ply --through 0,3000 -o b.obj --repair=weld").code, 0);
  // No hint where welding changes nothing.
  const std::string far = run("draw mesh.ply --through 1,1 -o b.obj").err;
  EXPECT_EQ(far.find("repair=weld"), std::string::npos) << far;
}

TEST_F(DriverHabits, ReadsAndWritesMarkupsInTheirUnit) {
  ASSERT_EQ(run("draw mesh.ply --through 64,400,590 -o mm.mrk.json").code, 0);
  const auto in = [&](const char* unit, double scale) {
    auto json = nlohmann::json::parse(bytes_of(file("mm.mrk.json")));
    auto& markup = json["markups"][0];
    markup["coordinateUnits"] = unit;
    for (auto& point : markup["controlPoints"]) {
      for (auto& x : point["position"]) x = x.get<double>() * scale;
    }
    write(std::string(unit) + ".mrk.json", json.dump());
  };
  in("cm", 0.1);
  in("um", 1000);
  in("m", 0.001);
  ASSERT_EQ(run("smooth mesh.ply --curve mm.mrk.json -o mm.json").code, 0);
  for (const char* unit : {"cm", "um", "m"}) {
    const std::string name = unit;
    ASSERT_EQ(run("smooth mesh.ply --curve " + name + ".mrk.json -o " + name + ".json").code, 0);
    ASSERT_EQ(run("measure mesh.ply mm.json " + name + ".json --report r.json").code, 0);
    const auto report = nlohmann::json::parse(bytes_of(file("r.json")));
    EXPECT_LT(report["deviation_to_other_max"], 1e-9) << unit;
  }
  // On a mesh in centimetres it is a tenth as long.
  const auto drawn_length = [&](const std::string& options) -> double {
    EXPECT_EQ(run("smooth mesh.ply --curve mm.mrk.json --report r.json " + options).code, 0);
    return nlohmann::json::parse(bytes_of(file("r.json")))["length_before"];
  };
  EXPECT_NEAR(drawn_length("--mesh-units cm"), drawn_length("") / 10, 1e-12);
  write("plain.mrk.json", [&] {
    std::string text = bytes_of(file("mm.mrk.json"));
    const std::string mm = "\"coordinateUnits\": \"mm\"";
    return text.replace(text.find(mm), mm.size(), "\"coordinateUnits\": \"cm\"");
  }());
  for (const char* command :
       {"smooth mesh.ply --curve plain.mrk.json -o cm.mrk.json", "measure mesh.ply plain.mrk.json",
        "cut mesh.ply --curve plain.mrk.json -o cut.ply",
        "compare mesh.ply --methods geodesic --curve plain.mrk.json",
        "run talweg.smooth mesh.ply --curve plain.mrk.json -o run.mrk.json"}) {
    EXPECT_EQ(run(std::string(command) + " --mesh-units cm").code, 0) << command;
    expect_failure(std::string(command) + " --mesh-units furlong", 1, {"furlong", "mm"});
  }
  EXPECT_EQ(run("draw mesh.ply --through 64,400 -o draw.mrk.json --mesh-units cm").code, 0);
  for (const char* name : {"cm.mrk.json", "run.mrk.json", "draw.mrk.json"}) {
    const auto json = nlohmann::json::parse(bytes_of(file(name)));
    EXPECT_EQ(json["markups"][0]["coordinateUnits"], "cm") << name;
  }
  write("list.csv", "mesh,curve,mesh-units\nmesh.ply,plain.mrk.json,cm\nmesh.ply,mm.mrk.json,\n");
  EXPECT_EQ(run("smooth --batch list.csv -o '{curve}.json'").code, 0);
  EXPECT_EQ(bytes_of(file("plain.json")), bytes_of(file("mm.json")));
}

TEST_F(DriverHabits, ADrawingThatWasMovedFarIsTheFirstThingThatIsSaid) {
  const MeshLists mesh = test::grid(60, 60);  // mean edge 1.1, diagonal 85
  write_mesh(file("large.ply"), mesh);
  const auto at = [](const char* z) { return std::string("v 5 5 ") + z + "\nv 50 40 0\nl 1 2\n"; };
  write("near.obj", at("2"));
  write("far.obj", at("6"));
  write("farther.obj", at("20"));
  const std::pair<std::string, std::string> commands[] = {
      {"smooth large.ply --curve ", " -o a.json --report r.json"},
      {"smooth large.ply --curve ", " --independent -o a.json"},
      {"measure large.ply ", ""},
      {"cut large.ply -o a.ply --curve ", ""},
      {"compare large.ply --methods geodesic --curve ", ""},
      {"run talweg.smooth large.ply -o a.json --curve ", ""}};
  for (const auto& [before, after] : commands) {
    const Outcome near = run(before + "near.obj" + after), far = run(before + "far.obj" + after);
    EXPECT_EQ(near.code, 0);
    EXPECT_EQ(near.err, "") << before;
    EXPECT_EQ(far.code, 0);
    EXPECT_TRUE(far.err.starts_with("talweg: warning: ")) << before << far.err;
    EXPECT_NE(far.err.find("far from the mesh"), std::string::npos) << far.err;
    EXPECT_NE(far.err.find("by up to 6 mesh units"), std::string::npos) << far.err;
    const Outcome farther = run(before + "farther.obj" + after);
    EXPECT_EQ(farther.code, 2);
    EXPECT_NE(farther.err.find("lies 20 away"), std::string::npos) << farther.err;
    EXPECT_EQ(run("-q " + before + "far.obj" + after).err, "");
  }
  ASSERT_EQ(run("smooth large.ply --curve far.obj --tau 3 --report r.json").code, 0);
  const std::string first = nlohmann::json::parse(bytes_of(file("r.json")))["warnings"][0];
  EXPECT_TRUE(first.starts_with("The drawing lies far from the mesh")) << first;
}

TEST_F(DriverHabits, CoordinatesBeyondTheLimitsAreRefusedByEveryCommand) {
  for (const double unit : {1e76, 1e-81}) {
    MeshLists mesh = test::grid(30, 20);
    for (Point& p : mesh.points) p *= unit;
    write_mesh(file("odd.obj"), mesh);
    write("a.txt", "64\n65\n66\n");
    const char* limit = unit > 1 ? "1e+40" : "1e-40";
    const char* found = unit > 1 ? "3e+77" : "3.61e-80";
    for (const char* line :
         {"draw odd.obj --through 64,400 -o out.obj", "smooth odd.obj --curve a.txt -o out.obj",
          "measure odd.obj a.txt", "cut odd.obj --curve a.txt -o out.ply",
          "labels odd.obj a.txt -o out.obj", "compare odd.obj --curve a.txt",
          "run talweg.smooth odd.obj --curve a.txt -o out.obj",
          "smooth odd.obj --curve a.txt --repair -o out.obj"}) {
      expect_failure(line, 2, {"odd.obj", limit, found});
    }
    const Outcome info = run("info odd.obj");
    EXPECT_EQ(info.code, 2);
    EXPECT_NE(info.out.find(limit), std::string::npos) << info.out;
    EXPECT_NE(info.out.find(found), std::string::npos) << info.out;
  }
}

}  // namespace
}  // namespace talweg
