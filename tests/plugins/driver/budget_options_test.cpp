// talweg smooth --budget and --budget-work.
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/jagged_curves.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg {
namespace {

class BudgetOptions : public test::DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    write_mesh(file("mesh.ply"), test::hills(40));
    ASSERT_EQ(run("draw mesh.ply --through 822,1074,998,594,683,1058,858 --points rough "
                  "-o drawn.json")
                  .code,
              0);
  }
  [[nodiscard]] nlohmann::json report(const char* name) const {
    return nlohmann::json::parse(bytes_of(file(name)));
  }
  [[nodiscard]] static std::string smooth(const std::string& options) {
    return "smooth mesh.ply --curve drawn.json " + options;
  }
};

TEST_F(BudgetOptions, EndWithTheBestSoFarAndSaySo) {
  for (const char* budget : {"--budget 1e-9", "--budget-work 1"}) {
    const Outcome outcome = run(smooth(std::string(budget) + " -o early.json --report r.json"));
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.err,
              "talweg: the budget was used up; the best result was written all the same.\n");
    EXPECT_EQ(report("r.json")["termination"], "limit");
    EXPECT_EQ(report("r.json")["deviation_exact"], false);
    EXPECT_FALSE(report("r.json")["warnings"].empty());
    ASSERT_EQ(run("measure mesh.ply early.json drawn.json --report m.json").code, 0);
    for (const char* side : {"to", "from"}) {
      const std::string told = std::string("deviation_") + side + "_drawn_max";
      const std::string true_one = std::string("deviation_") + side + "_other_max";
      EXPECT_GE(report("r.json")[told], report("m.json")[true_one]);
    }
  }
  EXPECT_NE(run(smooth("--budget-work 1")).out.find("deviation at most"), std::string::npos);
}

TEST_F(BudgetOptions, OfWorkGivesTheSameBytesWithAnyThreads) {
  for (const char* work : {"1", "3000", "30000", "100000"}) {
    const std::string options = std::string("--budget-work ") + work + " -o ";
    const int code = run(smooth(options + "a.json")).code;
    EXPECT_EQ(run("--threads 1 " + smooth(options + "b.json")).code, code);
    EXPECT_EQ(run("--threads 2 " + smooth(options + "c.json")).code, code);
    EXPECT_EQ(bytes_of(file("a.json")), bytes_of(file("b.json")));
    EXPECT_EQ(bytes_of(file("a.json")), bytes_of(file("c.json")));
  }
}

TEST_F(BudgetOptions, ThatAreNotUsedUpChangeNothing) {
  ASSERT_EQ(run(smooth("-o plain.json")).code, 0);
  for (const char* budget : {"--budget 1e6", "--budget-work 1000000000000"}) {
    ASSERT_EQ(run(smooth(std::string(budget) + " -o result.json")).code, 0);
    EXPECT_EQ(bytes_of(file("result.json")), bytes_of(file("plain.json")));
  }
}

TEST_F(BudgetOptions, OfEveryLineOfAList) {
  write("runs.csv",
        "mesh,curve,budget_work,output\nmesh.ply,drawn.json,1,a.json\n"
        "mesh.ply,drawn.json,,b.json\n");
  EXPECT_EQ(run("smooth --batch runs.csv --summary all.csv").code, 3);
  ASSERT_EQ(run(smooth("-o plain.json")).code, 0);
  EXPECT_EQ(bytes_of(file("b.json")), bytes_of(file("plain.json")));
  EXPECT_NE(bytes_of(file("a.json")), bytes_of(file("plain.json")));
}

TEST_F(BudgetOptions, MustBePositive) {
  for (const char* bad : {"0", "-1", "nan", "inf"}) {
    expect_failure(smooth(std::string("--budget=") + bad), 1, {"budget"});
  }
  for (const char* bad : {"0", "-1", "nan", "2.5", "1e16"}) {
    expect_failure(smooth(std::string("--budget-work=") + bad), 1, {"budget_work"});
  }
  expect_failure(smooth("--budget=soon"), 1, {"--budget", "soon"});
  expect_failure(smooth("--budget-work="), 1, {"--budget-work"});
}

}  // namespace
}  // namespace talweg
