// Many runs at once: lists, names of outputs, failures, summaries, and the same bytes for any jobs.
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pty.h>
#include <unistd.h>

#include "core/generated_meshes.hpp"
#include "core/small_meshes.hpp"
#include "places.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg {
namespace {

namespace fs = std::filesystem;

class SmoothMany : public test::DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    write_mesh(file("sheet.ply"), test::grid(30, 20));
    write_mesh(file("ball.obj"), test::sphere(5));
    write("across.txt", "64\n65\n66\n98\n99\n131\n132\n164\n");
    write("up.txt", "320\n351\n382\n383\n414\n445\n446\n477\n");
    for (const char* name : {"a", "b"}) {
      const std::string through = name[0] == 'a' ? "100,900,2000" : "5,1500,3000";
      ASSERT_EQ(run("draw ball.obj --through " + through + " -o " + name + ".mrk.json").code, 0);
    }
  }

  /// The summary by column name.
  [[nodiscard]] std::vector<std::map<std::string, std::string>> table(const char* name) const {
    std::istringstream in(bytes_of(file(name)));
    std::vector<std::string> columns;
    std::vector<std::map<std::string, std::string>> rows;
    for (std::string line; std::getline(in, line);) {
      std::vector<std::string> cells(1);
      bool quoted = false;
      for (const char c : line) {
        if (c == '"') quoted = !quoted;
        if (c == ',' && !quoted) cells.emplace_back();
        if (c != '"' && (c != ',' || quoted)) cells.back() += c;
      }
      if (columns.empty()) {
        columns = cells;
        continue;
      }
      EXPECT_EQ(cells.size(), columns.size()) << line;
      rows.emplace_back();
      for (std::size_t c = 0; c < columns.size(); ++c) rows.back()[columns[c]] = cells[c];
    }
    return rows;
  }

  /// A program of its own that does list.csv with two jobs, as soon as it has written some outputs.
  [[nodiscard]] pid_t start_list() const {
    const pid_t child = fork();
    if (child == 0) {
      if (chdir(file("").c_str()) != 0) _exit(99);
      execl(test::driver_program(), test::driver_program(), "-q", "smooth", "--batch", "list.csv",
            "-o", "out/{n}.json", "--summary", "s.csv", "--jobs", "2", static_cast<char*>(nullptr));
      _exit(99);
    }
    for (int wait = 0; wait < 3000 && !fs::exists(file("out/3.json")); ++wait) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return child;
  }

  /// Everything that the files of a folder hold, by name.
  [[nodiscard]] std::map<std::string, std::string> contents(const char* folder) const {
    std::map<std::string, std::string> result;
    for (const auto& entry : fs::recursive_directory_iterator(file(folder))) {
      if (entry.is_regular_file()) {
        result[fs::relative(entry.path(), file(folder)).string()] = bytes_of(entry.path());
      }
    }
    return result;
  }
};

TEST_F(SmoothMany, AListHasAValueForEachCurve) {
  expect_failure("smooth sheet.ply --curve across.txt --tau 1,2,3 -o out.json", 1,
                 {"--tau has 3 values", "1 curve:"});
}

TEST_F(SmoothMany, ACellMayHaveAValueForEachCurve) {
  const auto both = [&](const std::string& name, const std::string& options) {
    return run("smooth sheet.ply --curve across.txt --curve up.txt -o " + name +
               " --report r.json " + options);
  };
  ASSERT_EQ(both("set.json", "--tau 0.5,4 --finish taut,fair --slack auto,0.3").code, 0);
  const auto report = nlohmann::json::parse(bytes_of(file("r.json")));
  EXPECT_EQ(report["curves"][0]["tau"], 0.5);
  EXPECT_EQ(report["curves"][1]["tau"], 4);
  EXPECT_EQ(report["curves"][1]["slack"], 0.3);
  ASSERT_EQ(both("each.json", "--independent --tau 0.5,4 --finish taut,fair --slack auto,0.3").code,
            0);
  ASSERT_EQ(run("smooth sheet.ply --curve across.txt --tau 0.5 --finish taut -o first.json").code,
            0);
  ASSERT_EQ(run("smooth sheet.ply --curve up.txt --tau 4 --slack 0.3 -o second.json").code, 0);
  const auto curves = [&](const char* name) {
    return nlohmann::json::parse(bytes_of(file(name)))["curves"];
  };
  EXPECT_EQ(curves("each.json")[0], curves("first.json")[0]);
  EXPECT_EQ(curves("each.json")[1], curves("second.json")[0]);
  // The same from a table, with both curves in one file.
  write("list.csv",
        "mesh,curve,tau,finish,slack,output\n"
        "sheet.ply,both.json,\"0.5,4\",\"taut,fair\",\"auto,0.3\",batch.json\n");
  const Outcome drawn =
      run("smooth sheet.ply --curve across.txt --curve up.txt --tau 0 -o both.json");
  ASSERT_EQ(drawn.code, 0) << drawn.err;
  ASSERT_EQ(run("smooth --batch list.csv").code, 0);
  ASSERT_EQ(run("smooth sheet.ply --curve both.json --tau 0.5,4 --finish taut,fair "
                "--slack auto,0.3 -o direct.json")
                .code,
            0);
  EXPECT_EQ(bytes_of(file("batch.json")), bytes_of(file("direct.json")));
}

TEST_F(SmoothMany, DecisiveWarningsComeFirstWithTheirRun) {
  std::string dense, line = "l";
  for (int k = 0; k < 20; ++k) {  // a unit apart, and ten in the middle
    dense += "v " + std::to_string(2 + k + (k < 10 ? 0 : 7)) + " 10.3 0\n";
    line += " " + std::to_string(k + 1);
  }
  write("gap.obj", dense + line + "\n");
  write("list.csv", "mesh,curve,output\nsheet.ply,across.txt,a.json\nsheet.ply,gap.obj,b.json\n");
  const Outcome told = run("smooth --batch list.csv");
  ASSERT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(told.err.starts_with(
      "talweg: warning: list.csv, line 3 (sheet.ply): 1 gap of the drawing, over four times"))
      << told.err;
  EXPECT_EQ(told.err.find("line 2"), std::string::npos) << told.err;
  EXPECT_NE(told.out.find("2 runs: 2 done"), std::string::npos) << told.out;
  EXPECT_EQ(run("--quiet smooth --batch list.csv").err, "");
}

TEST_F(SmoothMany, SeveralFilesAreOneSetUnlessTheyAreIndependent) {
  write("both.txt", bytes_of(file("across.txt")) + "\n" + bytes_of(file("up.txt")));
  ASSERT_EQ(
      run("smooth sheet.ply --curve across.txt --curve up.txt -o two.json --report r.json").code,
      0);
  ASSERT_EQ(run("smooth sheet.ply --curve both.txt -o one.json").code, 0);
  EXPECT_EQ(bytes_of(file("two.json")), bytes_of(file("one.json")));
  EXPECT_EQ(nlohmann::json::parse(bytes_of(file("r.json")))["curves"].size(), 2U);

  ASSERT_EQ(run("smooth sheet.ply --curve both.txt --independent -o each.json").code, 0);
  ASSERT_EQ(run("smooth sheet.ply --curve across.txt -o first.json").code, 0);
  ASSERT_EQ(run("smooth sheet.ply --curve up.txt -o second.json").code, 0);
  const auto curves = [&](const char* name) {
    return nlohmann::json::parse(bytes_of(file(name)))["curves"];
  };
  ASSERT_EQ(curves("each.json").size(), 2U);
  EXPECT_EQ(curves("each.json")[0], curves("first.json")[0]);
  EXPECT_EQ(curves("each.json")[1], curves("second.json")[0]);
}

TEST_F(SmoothMany, CurvesOfASetDoNotCrossAndIndependentOnesMay) {
  // The first goes round below the lower end of the second; the straight line would cross it.
  write("two.obj", "v 3 12 0\nv 3 4 0\nv 15 4 0\nv 15 12 0\nv 9 8 0\nv 9 18 0\nl 1 2 3 4\nl 5 6\n");
  const auto length = [&](const std::string& options) {
    const Outcome outcome =
        run("smooth sheet.ply --curve two.obj --tau 0 " + options + " --summary s.csv");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return std::stod(table("s.csv").at(0).at("length_after"));
  };
  EXPECT_NEAR(length("--independent"), 12, 1e-9);
  EXPECT_NEAR(length(""), 2 * std::hypot(6, 4), 1e-9);
}

TEST_F(SmoothMany, IndependentCurvesThatFailAreNamedAndLeftOut) {
  // The middle one goes out and comes back the same way.
  write("three.obj",
        "v 1 1 0\nv 9 1 0\nv 9 9 0\nv 2 12 0\nv 8 18 0\nv 2 12 0\nv 2 18 0\n"
        "v 20 2 0\nv 22 3 0\nv 25 2 0\nl 1 2 3\nl 4 5 6\nl 8 9 10\n");
  for (const char* jobs : {"1", "2"}) {
    const Outcome outcome = run(std::string("smooth sheet.ply --curve three.obj --independent ") +
                                "-o out.json --summary s.csv --jobs " + jobs);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("curve 1"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("comes back"), std::string::npos) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(bytes_of(file("out.json")))["curves"].size(), 2U);
    const auto rows = table("s.csv");
    ASSERT_EQ(rows.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(rows[i].at("number"), std::to_string(i));
      EXPECT_EQ(rows[i].at("status"), i == 1 ? "failed" : "converged");
      EXPECT_EQ(rows[i].at("message").empty(), i != 1);
      EXPECT_EQ(rows[i].at("length_after").empty(), i == 1);
    }
  }
  // As a set, one bad curve is an error.
  expect_failure("smooth sheet.ply --curve three.obj -o set.json", 2, {"comes back"});
}

constexpr const char* kList =
    "mesh,curve,tau,patient\n"
    "sheet.ply,across.txt,2,p1\n"
    "ball.obj,a.mrk.json,,\"p2, left\"\n"
    "# a comment\n"
    "\n"
    "sheet.ply,up.txt,0.5,p3\n"
    "ball.obj,b.mrk.json,1,p4\n";

TEST_F(SmoothMany, AListGivesTheResultsOfSingleRunsForAnyNumberOfJobs) {
  write("list.csv", kList);
  for (const char* jobs : {"1", "2", "7"}) {
    const Outcome outcome = run(std::string("smooth --batch list.csv -o '") + jobs +
                                "/{patient}/{mesh}-{curve}.vtp' -o '" + jobs +
                                "/{patient}.json' --summary " + jobs + ".csv --jobs " + jobs);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::size_t first = outcome.err.find("list.csv, line 3 (ball.obj): The result cuts off");
    const std::size_t second = outcome.err.find("list.csv, line 7 (ball.obj): The result cuts off");
    EXPECT_LT(first, second) << outcome.err;
    EXPECT_NE(second, std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "4 runs: 4 done, 0 of them not converged; 0 failed, 0 cancelled\n");
    EXPECT_EQ(contents(jobs), contents("1"));
    EXPECT_EQ(bytes_of(file(std::string(jobs) + ".csv")), bytes_of(file("1.csv")));
  }
  EXPECT_EQ(contents("1").size(), 8U);
  EXPECT_TRUE(fs::exists(file("1/p2, left/ball-a.vtp")));
  ASSERT_EQ(run("smooth sheet.ply --curve up.txt --tau 0.5 -o alone.json").code, 0);
  EXPECT_EQ(bytes_of(file("1/p3.json")), bytes_of(file("alone.json")));
  ASSERT_EQ(run("smooth ball.obj --curve a.mrk.json -o alone.json --report alone-report.json").code,
            0);
  EXPECT_EQ(bytes_of(file("1/p2, left.json")), bytes_of(file("alone.json")));

  const auto rows = table("1.csv");
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[1].at("line"), "3");
  EXPECT_EQ(rows[2].at("line"), "6");
  EXPECT_EQ(rows[2].at("tau"), "0.5");
  EXPECT_EQ(rows[3].at("mesh"), "ball.obj");
  EXPECT_EQ(rows[3].at("curve"), "b.mrk.json");
  const auto report = nlohmann::json::parse(bytes_of(file("alone-report.json")));
  EXPECT_EQ(std::stod(rows[1].at("length_after")), report["length_after"].get<double>());
  EXPECT_EQ(std::stod(rows[1].at("deviation_at_z")), report["deviation_at"][2].get<double>());
}

TEST_F(SmoothMany, ABadMeshOrCurveDoesNotStopTheOthers) {
  write("broken.ply", "ply\nnonsense\n");
  write("list.csv",
        "mesh,curve,output\n"
        "broken.ply,across.txt,out/1.json\n"
        "sheet.ply,across.txt,out/2.json\n"
        "none.ply,across.txt,out/3.json\n"
        "sheet.ply,none.txt,out/4.json\n"
        "broken.ply,up.txt,out/5.json\n"
        "sheet.ply,up.txt,out/6.json\n");
  for (const char* jobs : {"1", "2"}) {
    const Outcome outcome =
        run(std::string("smooth --batch list.csv --summary s.csv --jobs ") + jobs);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "6 runs: 2 done, 0 of them not converged; 4 failed, 0 cancelled\n");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 4) << outcome.err;
    for (const char* word : {"line 2 (broken.ply)", "line 4 (none.ply)", "none.txt", "line 6"}) {
      EXPECT_NE(outcome.err.find(word), std::string::npos) << word << "\n" << outcome.err;
    }
    const auto rows = table("s.csv");
    ASSERT_EQ(rows.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
      const bool good = i == 1 || i == 5;
      EXPECT_EQ(rows[i].at("status"), good ? "converged" : "failed");
      EXPECT_EQ(rows[i].at("message").empty(), good);
      EXPECT_EQ(fs::exists(file("out/" + std::to_string(i + 1) + ".json")), good);
    }
    fs::remove_all(file("out"));
  }
}

TEST_F(SmoothMany, FailuresBeyondTenAreCounted) {
  std::string list = "mesh,curve\n";
  for (int i = 0; i < 14; ++i) list += "none.ply,curve" + std::to_string(i) + ".txt\n";
  write("list.csv", list);
  const Outcome outcome = run("smooth --batch list.csv -o '{curve}.vtp'");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 11) << outcome.err;
  EXPECT_NE(outcome.err.find("4 more"), std::string::npos);
}

TEST_F(SmoothMany, ALoopThatCollapsesMakesTheWorstOutcomeThree) {
  write("loop.txt", "200\n201\n202\n233\n264\n263\n262\n231\n200\n");
  write("list.tsv", "mesh\tcurve\ttau\nsheet.ply\tacross.txt\t1\nsheet.ply\tloop.txt\t0\n");
  const Outcome outcome = run("smooth --batch list.tsv -o 'out/{curve}.json' --summary s.csv");
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  EXPECT_EQ(table("s.csv")[1].at("status"), "collapsed");
  EXPECT_TRUE(fs::exists(file("out/loop.json")));
}

TEST_F(SmoothMany, RefusesBadListsBeforeAnyWork) {
  const auto refuse = [&](const std::string& list, const std::string& options,
                          std::initializer_list<const char*> words, int code = 2) {
    write("list.csv", list);
    expect_failure("smooth --batch list.csv " + options, code, words);
    EXPECT_FALSE(fs::exists(file("out.json"))) << list;
  };
  const std::string good = "mesh,curve,output\nsheet.ply,across.txt,out.json\n";
  refuse("", "", {"list.csv", "empty"});
  refuse("mesh,curve\n", "", {"list.csv", "at least one run"});
  refuse(good + "sheet.ply,up.txt\n", "", {"line 3", "2 cells under 3 columns"});
  refuse(good + ",up.txt,b.json\n", "", {"line 3", "no mesh"});
  refuse(good + "sheet.ply,,b.json\n", "", {"line 3", "no curve"});
  refuse(good + "sheet.ply,up.txt,\n", "", {"line 3", "nothing would be written"});
  refuse(good + "sheet.ply,\"up.txt,b.json\n", "", {"line 3", "quote"});
  refuse(good + "sheet.ply,\"up\".txt,b.json\n", "", {"line 3", "quotes"});
  refuse("mesh,curve,tua\nsheet.ply,across.txt,1\n", "-o out.json", {"line 1", "tua"});
  refuse("mesh,curve,curve\nsheet.ply,a,b\n", "-o out.json", {"line 1", "two columns"});
  refuse("mesh,curve,\nsheet.ply,a,b\n", "-o out.json", {"line 1", "no name"});
  refuse("mesh,curve,tau\nsheet.ply,across.txt,much\n", "-o out.json", {"line 2", "much"});
  refuse("mesh,curve,potential\nsheet.ply,across.txt,steep\n", "-o out.json", {"line 2", "steep"});
  refuse("mesh,curve,slack\nsheet.ply,across.txt,1\n", "-o out.json --potential paper",
         {"line 2", "--slack"});
  // One value, or one for each curve; how many there are is found while it works.
  refuse("mesh,curve,slack\nsheet.ply,across.txt,\"1,-1\"\n", "-o out.json", {"line 2", "-1"});
  refuse("mesh,curve,finish\nsheet.ply,across.txt,\"fair,loose\"\n", "-o out.json",
         {"line 2", "loose"});
  // Two runs that write one file, however it is spelt; and one that writes what another reads.
  refuse(good + "sheet.ply,up.txt,./out.json\n", "", {"line 3", "out.json", "line 2"}, 1);
  refuse("mesh,curve\nsheet.ply,across.txt\nsheet.ply,up.txt\n", "-o out.json",
         {"line 3", "written twice"}, 1);
  refuse(good, "--report out.json", {"line 2", "written twice"}, 1);
  refuse(good, "--summary out.json", {"line 2", "--summary"}, 1);
  refuse("mesh,curve\nsheet.ply,across.txt\n", "-o '{curve}.txt'", {"line 2", "reads it"}, 1);
  refuse("mesh,curve\nsheet.ply,across.txt\n", "-o '{kurve}.vtp'", {"line 2", "{curve}"});
  refuse("mesh,curve\nsheet.ply,across.txt\n", "-o '{curve.vtp'", {"line 2", "{curve}"});
  refuse(good, "--jobs 0", {"--jobs"}, 1);
  write("list.csv", good);
  expect_failure("smooth sheet.ply --batch list.csv", 1, {"--batch"});
  expect_failure("smooth --batch none.csv", 2, {"none.csv"});
}

TEST_F(SmoothMany, ListsAreReadAsSpreadsheetsWriteThem) {
  // A byte order mark, carriage returns, quotes with quotes and line ends in them, no last line
  // end.
  write("list.csv",
        "\xEF\xBB\xBFmesh,curve,name\r\nsheet.ply,across.txt,\"a \"\"b\"\"\"\r\n"
        "\"sheet.ply\",\"up.txt\",\"c, d\"");
  ASSERT_EQ(run("smooth --batch list.csv -o 'out/{name}.json'").code, 0);
  EXPECT_TRUE(fs::exists(file("out/a \"b\".json")));
  EXPECT_TRUE(fs::exists(file("out/c, d.json")));
}

TEST_F(SmoothMany, OutputFoldersAreThoseOfTheMesh) {
  for (const char* name : {"case1", "case2"}) {
    fs::create_directory(file(name));
    fs::copy(file("sheet.ply"), file(name) / "mesh.ply");
    fs::copy(file("across.txt"), file(name) / "drawn.txt");
  }
  write("list.csv", "mesh,curve\ncase1/mesh.ply,case1/drawn.txt\ncase2/mesh.ply,case2/drawn.txt\n");
  ASSERT_EQ(
      run("smooth --batch list.csv -o '{folder}/smooth.json' --report '{folder}/r.json'").code, 0);
  EXPECT_NE(bytes_of(file("case1/smooth.json")), "");
  EXPECT_EQ(bytes_of(file("case1/smooth.json")), bytes_of(file("case2/smooth.json")));
  EXPECT_TRUE(nlohmann::json::accept(bytes_of(file("case2/r.json"))));
}

TEST_F(SmoothMany, BordersOfLabelsAreSmoothedTogether) {
  std::string labels;
  for (int j = 0; j < 20; ++j) {
    for (int i = 0; i < 30; ++i) {
      const int label = j < 10 + (i / 3) % 2 ? (i < 15 + (j < 8 ? (j / 2) % 2 : 0) ? 1 : 2) : 3;
      labels += std::to_string(label) + "\n" + std::to_string(label) + "\n";
    }
  }
  write("labels.txt", labels);
  const Outcome outcome =
      run("smooth sheet.ply --labels labels.txt --tau 2 -o out.json --summary s.csv");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = table("s.csv");
  ASSERT_EQ(rows.size(), 3U);  // three regions meet at one junction
  for (const auto& row : rows) {
    EXPECT_LT(std::stod(row.at("curvature_after")), 0.5 * std::stod(row.at("curvature_before")));
  }
  // They still meet, and nowhere else.
  ASSERT_EQ(run("measure sheet.ply out.json --report r.json").code, 0);
  EXPECT_EQ(nlohmann::json::parse(bytes_of(file("r.json")))["self_contacts"].get<int>(), 1);
  write("few.txt", "1 2 3\n");
  expect_failure("smooth sheet.ply --labels few.txt -o x.json", 2, {"few.txt", "3 labels"});
  write("half.txt", "1\n2.5\n");
  expect_failure("smooth sheet.ply --labels half.txt -o x.json", 2, {"half.txt", "line 2", "2.5"});
  expect_failure("smooth sheet.ply --labels labels.txt --curve up.txt", 1, {"--labels"});
}

TEST_F(SmoothMany, TheBarOnATerminalCountsTheRuns) {
  std::string list = "mesh,curve,n\n";
  for (int i = 0; i < 600; ++i) list += "ball.obj,a.mrk.json," + std::to_string(i) + "\n";
  write("list.csv", list + "none.ply,a.mrk.json,bad\n");
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  ASSERT_GE(child, 0);
  if (child == 0) {
    if (chdir(file("").c_str()) != 0) _exit(99);
    execl(test::driver_program(), test::driver_program(), "smooth", "--batch", "list.csv", "-o",
          "out/{n}.json", "--jobs", "2", static_cast<char*>(nullptr));
    _exit(99);
  }
  std::string seen;
  char block[4096];
  for (ssize_t got; (got = read(terminal, block, sizeof block)) > 0;) {
    seen.append(block, static_cast<std::size_t>(got));
  }
  close(terminal);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 2);
  int last = 0, bars = 0;
  for (std::size_t at = 0; (at = seen.find("% ", at)) != std::string::npos; ++at) {
    int done = 0, total = 0;
    if (std::sscanf(seen.c_str() + at, "%% %d/%d", &done, &total) != 2) continue;
    ++bars;
    EXPECT_EQ(total, 601);
    EXPECT_GE(done, last);
    EXPECT_LE(done, total);
    last = done;
    // The rate times the time that is left makes the rest, within the rounding up to a second.
    double rate = 0;
    int minutes = 0, seconds = 0;
    if (std::sscanf(seen.c_str() + at, "%% %*d/%*d, %lf/s, %d:%d left", &rate, &minutes,
                    &seconds) == 3) {
      EXPECT_NEAR(total - done, rate * (60 * minutes + seconds), 1.1 * rate + 1);
    }
  }
  EXPECT_GT(bars, 0) << seen;
  // The bar is erased before the last message.
  EXPECT_NE(seen.find("none.ply"), std::string::npos);
  EXPECT_EQ(seen.find("left", seen.find("talweg: ")), std::string::npos);
}

TEST_F(SmoothMany, ResumingKeepsUnchangedOutputsAndMakesTheRest) {
  write("list.csv", kList);
  const std::string command = "smooth --batch list.csv -o 'out/{patient}.json' --summary s.csv";
  ASSERT_EQ(run(command).code, 0);
  EXPECT_FALSE(fs::exists(file("s.csv.part")));
  const auto before = contents("out");
  const std::string summary = bytes_of(file("s.csv"));
  const auto resumed = [&](const std::string& counts, const std::string& options = "") {
    const Outcome outcome = run(command + " --resume" + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.substr(0, outcome.out.find(';')), "4 runs: " + counts);
  };
  const auto untouched = fs::last_write_time(file("out/p1.json"));
  resumed("4 kept as they were, 0 made of which 0 anew");
  EXPECT_EQ(fs::last_write_time(file("out/p1.json")), untouched);
  EXPECT_EQ(bytes_of(file("s.csv")), summary);
  // An output that is missing or was changed, a drawing that was changed, an option.
  fs::remove(file("out/p1.json"));
  write("out/p3.json", "{}");
  resumed("2 kept as they were, 2 made of which 1 anew");
  EXPECT_EQ(contents("out"), before);
  EXPECT_EQ(bytes_of(file("s.csv")), summary);
  write("up.txt", "320\n351\n382\n383\n414\n445\n446\n");
  resumed("3 kept as they were, 1 made of which 1 anew");
  EXPECT_NE(bytes_of(file("out/p3.json")), before.at("p3.json"));
  // Only one line has no tau of its own.
  resumed("3 kept as they were, 1 made of which 1 anew", " --tau 5");
}

TEST_F(SmoothMany, ResumedRowsHaveThePlacesOfTheNewList) {
  write("list.csv", kList);
  const std::string command = "smooth --batch list.csv -o 'out/{patient}.json' --summary ";
  ASSERT_EQ(run(command + "s.csv").code, 0);
  write("list.csv",
        "mesh,curve,tau,patient\nball.obj,b.mrk.json,1,p4\nsheet.ply,across.txt,2,p1\n"
        "sheet.ply,across.txt,3,p5\n");
  const Outcome outcome = run(command + "s.csv --resume");
  EXPECT_EQ(outcome.out.substr(0, 38), "3 runs: 2 kept as they were, 1 made of") << outcome.err;
  ASSERT_EQ(run(command + "fresh.csv").code, 0);
  EXPECT_EQ(bytes_of(file("s.csv")), bytes_of(file("fresh.csv")));
}

TEST_F(SmoothMany, FailedRunsAreTriedAgain) {
  write("list.csv", "mesh,curve\nsheet.ply,across.txt\nsheet.ply,late.txt\n");
  const std::string command = "smooth --batch list.csv -o '{curve}.json' --summary s.csv";
  EXPECT_EQ(run(command).code, 2);
  write("late.txt", bytes_of(file("up.txt")));
  const Outcome outcome = run(command + " --resume");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "2 runs: 1 kept as they were, 1 made of which 0 anew; 2 done, 0 of them not "
            "converged; 0 failed, 0 cancelled\n");
}

TEST_F(SmoothMany, RefusesToResumeWithoutATable) {
  write("list.csv", kList);
  expect_failure("smooth --batch list.csv -o '{patient}.json' --resume", 1, {"--summary"});
  expect_failure("smooth --batch list.csv -o '{patient}.json' --summary - --resume", 1,
                 {"--summary"});
  // A table of another version: everything is made, and the reason told.
  write("s.csv", "line,mesh\n1,sheet.ply\n");
  const Outcome outcome =
      run("smooth --batch list.csv -o '{patient}.json' --summary s.csv --resume");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("s.csv has other columns"), std::string::npos) << outcome.err;
  EXPECT_EQ(table("s.csv").size(), 4U);
}

TEST_F(SmoothMany, AKilledListIsResumed) {
  std::string list = "mesh,curve,n\n";
  for (int i = 0; i < 400; ++i) list += "ball.obj,a.mrk.json," + std::to_string(i) + "\n";
  write("list.csv", list);
  const pid_t child = start_list();
  ASSERT_GE(child, 0);
  kill(child, SIGKILL);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_FALSE(fs::exists(file("s.csv")));
  // Half a line, as a machine that lost its power leaves it.
  write("s.csv.part", bytes_of(file("s.csv.part")) + "17,ball.obj,\"a.mrk");
  const Outcome outcome = run("smooth --batch list.csv -o 'out/{n}.json' --summary s.csv --resume");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  int kept = 0, made = 0, anew = 0;
  ASSERT_EQ(std::sscanf(outcome.out.c_str(), "400 runs: %d kept as they were, %d made of which %d",
                        &kept, &made, &anew),
            3)
      << outcome.out;
  EXPECT_GE(kept, 2);
  EXPECT_EQ(kept + made, 400);
  EXPECT_LE(anew, 2);  // one for each job, killed after it wrote an output and before its record
  EXPECT_EQ(table("s.csv").size(), 400U);
  EXPECT_EQ(contents("out").size(), 400U);
}

TEST_F(SmoothMany, AnInterruptKeepsWhatIsDoneAndNothingHalf) {
  std::string list = "mesh,curve,n\n";
  for (int i = 0; i < 20000; ++i) list += "ball.obj,a.mrk.json," + std::to_string(i) + "\n";
  write("list.csv", list);
  const pid_t child = start_list();
  ASSERT_GE(child, 0);
  kill(child, SIGINT);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 4);
  const auto rows = table("s.csv");
  ASSERT_EQ(rows.size(), 20000U);
  const std::string whole = bytes_of(file("out/0.json"));
  EXPECT_TRUE(nlohmann::json::accept(whole));
  std::size_t done = 0, cancelled = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const fs::path out = file("out/" + std::to_string(i) + ".json");
    const bool written = rows[i].at("status") == "converged";
    ASSERT_EQ(fs::exists(out), written) << i;
    if (written) {
      ASSERT_EQ(bytes_of(out), whole) << i;
    }
    ++(written ? done : cancelled);
  }
  EXPECT_GE(done, 4U);
  EXPECT_GT(cancelled, 0U);
  EXPECT_EQ(contents("out").size(), done);  // no temporary files
}

}  // namespace
}  // namespace talweg
