// Outputs of all commands: none destroys an input or another output, none fails when the work is
// done, and "-" is the standard output.
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "core/generated_meshes.hpp"
#include "places.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg::test {
namespace {

namespace fs = std::filesystem;

/// A valid command. Its inputs are written as {NAME}, and the tests add its options for outputs.
struct Command {
  std::string line;
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;  ///< options
};

const std::vector<Command>& commands() {
  static const std::vector<Command> all = {
      {"draw {mesh.ply} --through 64,100 --points rough -o ok.json", {"mesh.ply"}, {"-o"}},
      {"smooth {mesh.ply} --curve {curve.json} --slack-field {field.txt}",
       {"mesh.ply", "curve.json", "field.txt"},
       {"-o", "--report", "--summary"}},
      {"smooth {mesh.ply} --curve {curve.json} --curve {other.json} --independent",
       {"mesh.ply", "curve.json", "other.json"},
       {"-o", "--report", "--summary"}},
      {"smooth {mesh.ply} --curve {curve.json} --potential paper --distance {field.txt}",
       {"mesh.ply", "curve.json", "field.txt"},
       {"-o", "--report"}},
      {"smooth {mesh.ply} --labels {labels.txt}", {"mesh.ply", "labels.txt"}, {"-o", "--report"}},
      {"smooth --batch {list.csv}",
       {"list.csv", "mesh.ply", "curve.json"},
       {"-o", "--report", "--summary"}},
      {"measure {mesh.ply} {curve.json} {other.json}",
       {"mesh.ply", "curve.json", "other.json"},
       {"--report"}},
      {"cut {mesh.ply} --curve {curve.json} -o ok.ply", {"mesh.ply", "curve.json"}, {"--map"}},
      {"cut {mesh.ply} --curve {curve.json}", {"mesh.ply", "curve.json"}, {"-o"}},
      {"offset {mesh.ply} --curve {curve.json} --distance 1 -o ok.json",
       {"mesh.ply", "curve.json"},
       {"--report"}},
      {"offset {mesh.ply} --curve {curve.json} --distance 1", {"mesh.ply", "curve.json"}, {"-o"}},
      {"labels {mesh.ply} {labels.txt} --cut ok.ply",
       {"mesh.ply", "labels.txt"},
       {"-o", "--labels-out", "--cut-labels", "--report"}},
      {"labels {mesh.ply} {labels.txt}", {"mesh.ply", "labels.txt"}, {"--cut"}},
      {"compare {mesh.ply} --curve {curve.json} --sweep --methods geodesic",
       {"mesh.ply", "curve.json"},
       {"-o", "--plot", "--report", "--table"}},
      {"run talweg.distance {mesh.ply} --curve {curve.json}",
       {"mesh.ply", "curve.json"},
       {"--write-distance", "--report"}},
      {"run talweg.smooth {mesh.ply} --curve {curve.json} --slack-field {field.txt}",
       {"mesh.ply", "curve.json", "field.txt"},
       {"-o", "--report"}},
  };
  return all;
}

class Outputs : public DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    const MeshLists mesh = grid(30, 20);
    write_mesh(file("mesh.ply"), mesh);
    ASSERT_EQ(run("draw mesh.ply --through 64,400,590 --points rough -o curve.json").code, 0);
    ASSERT_EQ(run("draw mesh.ply --through 40,90 --points rough -o other.json").code, 0);
    std::string field, labels;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) field += "1\n";
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) labels += f < 500 ? "1\n" : "2\n";
    write("field.txt", field);
    write("labels.txt", labels);
    write("list.csv", "mesh,curve\nmesh.ply,curve.json\n");
  }

  /// All files and their contents, except the logs of the last run.
  [[nodiscard]] std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(file(""))) {
      const std::string name = fs::relative(entry.path(), file("")).string();
      if (entry.is_regular_file() && !name.ends_with(".log")) all[name] = bytes_of(entry.path());
    }
    return all;
  }

  /// Fails with code 1 and a line, and every file is as it was.
  void expect_refusal(const std::string& line, std::initializer_list<const char*> words) const {
    const auto before = contents();
    expect_failure(line, 1, words);
    EXPECT_EQ(contents() == before, true) << line;
  }
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::string plain(const Command& command) {
  return replaced(replaced(command.line, "{", ""), "}", "");
}

TEST_F(Outputs, ThatAreInputsAreRefusedByEveryCommand) {
  for (const Command& command : commands()) {
    for (const std::string& output : command.outputs) {
      for (const std::string& input : command.inputs) {
        expect_refusal(plain(command) + " " + output + " " + input,
                       {output.c_str(), input.c_str(), "would overwrite an input"});
      }
    }
  }
}

TEST_F(Outputs, ThatAreOneFileAreRefusedByEveryCommand) {
  for (const Command& command : commands()) {
    for (const std::string& a : command.outputs) {
      for (const std::string& b : command.outputs) {
        if (a == b && a != "-o") continue;
        const std::string options = " " + a + " ./new.json " + b + " new.json";
        if (a == b && plain(command).find("-o ") == std::string::npos &&
            command.line.starts_with("c")) {
          continue;  // one -o only
        }
        expect_refusal(plain(command) + options, {"written twice", "new.json"});
      }
    }
  }
}

TEST_F(Outputs, OfUnknownNumberAreCheckedByTheirNames) {
  fs::copy(file("mesh.ply"), file("out-12.ply"));
  fs::copy(file("curve.json"), file("r-geodesic.json"));
  fs::copy(file("curve.json"), file("r-corridor-3.json"));
  expect_refusal("cut out-12.ply --curve curve.json --split -o out.ply",
                 {"out-12.ply", "would overwrite an input"});
  expect_refusal("cut mesh.ply --curve curve.json --split -o out.ply --map out-7.ply",
                 {"out-7.ply", "written twice"});
  expect_refusal("compare mesh.ply --curve r-geodesic.json --methods geodesic --results r",
                 {"r-geodesic.json"});
  expect_refusal("compare mesh.ply --curve r-corridor-3.json --sweep --results ./r",
                 {"r-corridor-3.json"});
  // Names that only look alike.
  fs::copy(file("mesh.ply"), file("out-012.ply"));
  EXPECT_EQ(run("cut out-012.ply --curve curve.json --split -o out.ply").code, 0);
}

TEST_F(Outputs, OfOneLineMayNotBeReadByAnother) {
  write("two.csv", "mesh,curve,output\nmesh.ply,curve.json,a.json\nmesh.ply,a.json,b.json\n");
  expect_refusal("smooth --batch two.csv", {"line 2", "line 3 reads it"});
  write("made.csv", "mesh,curve,output\nmesh.ply,curve.json,absent/../curve.json\n");
  expect_refusal("smooth --batch made.csv", {"line 2", "would overwrite an input"});
}

TEST_F(Outputs, ThatCannotBeWrittenAreFoundBeforeTheMeshIsRead) {
  fs::create_directory(file("folder.json"));
  const std::string smooth = "smooth absent.ply --curve curve.json ";
  expect_failure(smooth + "-o nowhere/a.json", 2, {"nowhere/a.json", "No such file"});
  expect_failure(smooth + "--report curve.json/a.json", 2,
                 {"curve.json/a.json", "Not a directory"});
  expect_failure(smooth + "-o folder.json", 2, {"folder.json", "is a directory"});
  expect_failure(smooth + "-o a.xyz", 2, {"a.xyz", ".vtp"});
  expect_failure(smooth + "-o " + std::string(300, 'a') + ".json", 2, {"too long"});
  // Its temporary file's name would be too long.
  expect_failure(smooth + "-o " + std::string(250, 'a') + ".json", 2, {"too long"});
  expect_failure("cut absent.ply --curve curve.json -o a.xyz", 2, {"a.xyz", ".ply"});
  expect_failure("cut absent.ply --curve curve.json -o a.ply --map nowhere/m.json", 2, {"nowhere"});
  expect_failure("labels absent.ply labels.txt --cut a.xyz", 2, {"a.xyz"});
  expect_failure("measure absent.ply curve.json --report nowhere/r.json", 2, {"nowhere"});
  expect_failure("compare absent.ply --curve curve.json --results nowhere/r", 2, {"nowhere"});
  expect_failure("run talweg.smooth absent.ply --curve curve.json -o a.xyz", 2, {"a.xyz"});
  write("bad.csv", "mesh,curve\nmesh.ply,curve.json\n");
  expect_failure("smooth --batch bad.csv -o curve.json/a.json", 2, {"curve.json"});
  EXPECT_FALSE(fs::exists(file("a.json")));
}

// A format that cannot hold the curve fails only after smoothing; the other files are written.
TEST_F(Outputs, ThatFailDoNotTakeTheWorkFromTheOthers) {
  for (const char* command : {"smooth", "run talweg.smooth"}) {
    const std::string line = std::string(command) + " mesh.ply --curve curve.json ";
    expect_failure(line + "-o a.txt -o b.json --report c.json", 2, {"a.txt"});
    EXPECT_FALSE(fs::exists(file("a.txt")));
    EXPECT_EQ(read_curves(file("b.json")).size(), 1U);
    EXPECT_TRUE(nlohmann::json::accept(bytes_of(file("c.json"))));
    fs::remove(file("b.json"));
    fs::remove(file("c.json"));
  }
  expect_failure("labels mesh.ply labels.txt --labels-out /dev/full --report c.json", 2,
                 {"/dev/full"});
  EXPECT_TRUE(fs::exists(file("c.json")));
}

TEST_F(Outputs, OfABatchHaveTheirFoldersMade) {
  EXPECT_EQ(run("smooth --batch list.csv -o made/a/b.json --summary made/too/s.csv").code, 0);
  EXPECT_TRUE(fs::exists(file("made/a/b.json")));
  EXPECT_TRUE(fs::exists(file("made/too/s.csv")));
}

TEST_F(Outputs, WithTheNameOfAStrokeAreTheStandardOutput) {
  ASSERT_EQ(run("smooth mesh.ply --curve curve.json -o a.vtp --report r.json").code, 0);
  Outcome outcome = run("smooth mesh.ply --curve curve.json -o -.vtp");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, bytes_of(file("a.vtp")));
  outcome = run("-v smooth mesh.ply --curve curve.json --report -");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["termination"], "converged");
  EXPECT_NE(outcome.err.find("total curvature"), std::string::npos);  // text for people
  ASSERT_EQ(run("cut mesh.ply --curve curve.json -o cut.ply").code, 0);
  outcome = run("cut mesh.ply --curve curve.json -o -.ply");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, bytes_of(file("cut.ply")));
  EXPECT_NE(outcome.err.find("vertices"), std::string::npos);
  for (const char* line :
       {"measure mesh.ply curve.json --report -", "draw mesh.ply --through 64,100 -o -.json",
        "labels mesh.ply labels.txt -o -.mrk.json", "labels mesh.ply labels.txt --report -",
        "cut mesh.ply --curve curve.json -o new.ply --map -",
        "compare mesh.ply --curve curve.json --methods geodesic --report -",
        "run talweg.smooth mesh.ply --curve curve.json -o -.json"}) {
    outcome = run(line);
    EXPECT_EQ(outcome.code, 0) << line << outcome.err;
    EXPECT_TRUE(nlohmann::json::accept(outcome.out)) << line << outcome.out.substr(0, 300);
  }
  EXPECT_EQ(run("smooth --batch list.csv --summary -").out.substr(0, 5), "line,");
  EXPECT_EQ(run("compare mesh.ply --curve curve.json --methods geodesic -o -").out.substr(1, 3),
            "PNG");
  EXPECT_EQ(run("run talweg.distance mesh.ply --curve curve.json --write-distance -").code, 0);
  for (const auto& [name, bytes] : contents()) EXPECT_NE(name.front(), '-') << name;

  expect_failure("smooth mesh.ply --curve curve.json -o -", 1, {"-o -", "-.ply"});
  expect_failure("smooth mesh.ply --curve curve.json -o -.xyz", 2, {".xyz"});
  expect_failure("smooth mesh.ply --curve curve.json -o -.vtp --report -", 1, {"written twice"});
  expect_failure("cut mesh.ply --curve curve.json --split -o -.ply", 1, {"--split"});
  expect_failure("compare mesh.ply --curve curve.json --results -", 1, {"--results"});
  EXPECT_EQ(run("smooth mesh.ply --curve curve.json -o /dev/null --report /dev/null").code, 2);
  EXPECT_EQ(run("labels mesh.ply labels.txt --labels-out /dev/null --report /dev/null").code, 0);
}

TEST_F(Outputs, TheStandardOutputIsCheckedLikeFiles) {
  const std::string before = bytes_of(file("curve.json"));
  const std::string command = "cd '" + file("").string() + "' && '" + driver_program() +
                              "' smooth mesh.ply --curve curve.json --report - "
                              ">>curve.json 2>err.txt </dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1);
  EXPECT_EQ(bytes_of(file("curve.json")), before);
  EXPECT_NE(bytes_of(file("err.txt")).find("would overwrite an input"), std::string::npos);
}

/// Any way to name a file of the folder, which may have to be made.
class Spelling {
 public:
  Spelling(fs::path folder, std::mt19937& random) : folder_(std::move(folder)), random_(random) {}

  std::string of(const std::string& name) {
    const fs::path target = folder_ / name;
    const std::string fresh = "link" + std::to_string(++made_);
    const bool exists = fs::exists(target);
    switch (random_() % (exists ? 9 : 8)) {
      case 0:
        return name;
      case 1:
        return "./" + name;
      case 2:
        return target.string();
      case 3:
        return "sub/../" + name;
      case 4:
        return "sub//.././/" + name;
      case 5:
        return "to_here/" + name;
      case 6:
        fs::create_symlink(name, folder_ / fresh);
        return fresh;
      case 7:
        fs::create_symlink(target, folder_ / (fresh + "a"));
        fs::create_symlink("to_here/" + fresh + "a", folder_ / fresh);
        return fresh;
      default:
        fs::create_hard_link(target, folder_ / fresh);
        return "sub/../" + fresh;
    }
  }

 private:
  fs::path folder_;
  std::mt19937& random_;
  int made_ = 0;
};

TEST_F(Outputs, RandomPairsOfFilesByAnyNameLeaveEveryInputAsItIs) {
  std::mt19937 random(20);
  fs::create_directory(file("sub"));
  fs::create_directory_symlink(".", file("to_here"));
  Spelling spelling(file(""), random);
  const auto any = [&](const auto& list) { return list[random() % list.size()]; };
  const std::map<std::string, std::string> before = contents();
  std::set<std::string> tried;
  constexpr int kRuns = 150;
  for (int k = 0; k < kRuns; ++k) {
    const Command command = any(commands());
    std::string line = command.line;
    for (const std::string& input : command.inputs) {
      line = replaced(line, "{" + input + "}", random() % 3 == 0 ? spelling.of(input) : input);
    }
    const std::string output = any(command.outputs);
    const bool twice = command.outputs.size() > 1 && random() % 3 == 0;
    if (twice) {
      std::string other = any(command.outputs);
      while (other == output) other = any(command.outputs);
      const std::string name = "absent" + std::to_string(k) + ".json";
      line += " " + output + " " + spelling.of(name) + " " + other + " " + spelling.of(name);
    } else {
      line += " " + output + " " + spelling.of(any(command.inputs));
    }
    tried.insert(command.line + output);
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.code, 1) << line << "\n" << outcome.err;
    for (const auto& [name, bytes] : before) {
      ASSERT_TRUE(bytes_of(file(name)) == bytes) << name << " was changed by " << line;
    }
    ASSERT_FALSE(fs::exists(file("absent" + std::to_string(k) + ".json"))) << line;
  }
  EXPECT_GT(tried.size(), 20U);  // else the runs would try little
}

}  // namespace
}  // namespace talweg::test
