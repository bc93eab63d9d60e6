// Curves in OBJ files and vertex-id lists.
#include <gtest/gtest.h>

#include "core/curve_files.hpp"

namespace talweg {
namespace {

using test::CurveFiles;
using Ids = std::vector<std::size_t>;
using CurveObj = CurveFiles;
using CurveTxt = CurveFiles;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::vector<double> xs(const CurveInput& curve) {
  std::vector<double> result;
  for (const Point& p : test::positions(curve)) result.push_back(p.x() + 10 * p.y());
  return result;
}

TEST_F(CurveObj, OneLineIsOneCurve) {
  const auto curves = read("a.obj", "# made by hand\n" + kSquare + "l 1 2 3\n");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_FALSE(curves[0].closed);
  EXPECT_EQ(xs(curves[0]), (std::vector<double>{0, 1, 11}));
  EXPECT_TRUE(curves[0].pins.empty());
}

TEST_F(CurveObj, TheFirstIndexAtTheEndCloses) {
  const auto curves = read("a.obj", kSquare + "l 1 2 3 4 1\n");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_EQ(xs(curves[0]), (std::vector<double>{0, 1, 11, 10}));
}

TEST_F(CurveObj, ACopyOfTheFirstPointAtTheEndCloses) {
  const auto curves = read("a.obj", kSquare + "v 0 0 0\nl 1 2 3 4 5\n");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_EQ(xs(curves[0]), (std::vector<double>{0, 1, 11, 10}));
}

TEST_F(CurveObj, SegmentsAreJoinedInTheDirectionOfTheFirst) {
  const auto curves = read("a.obj", kSquare + "l 2 3\nl 4 3\nl 2 1\n");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_FALSE(curves[0].closed);
  EXPECT_EQ(xs(curves[0]), (std::vector<double>{0, 1, 11, 10}));
}

TEST_F(CurveObj, SegmentsAreJoinedToLoops) {
  const auto curves = read("a.obj", kSquare + "l 3 4\nl 1 2\nl 4 1\nl 3 2\n");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_EQ(xs(curves[0]), (std::vector<double>{11, 10, 0, 1}));
}

TEST_F(CurveObj, JunctionsStayEnds) {
  const auto curves = read("a.obj", kSquare + "l 1 2\nl 2 3\nl 2 4\n");
  EXPECT_EQ(curves.size(), 3U);
}

TEST_F(CurveObj, ARepeatedSegmentCountsOnce) {
  const auto curves = read("a.obj", kSquare + "l 1 2\nl 2 1\nl 2 3\n");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(xs(curves[0]), (std::vector<double>{0, 1, 11}));
}

TEST_F(CurveObj, ReadsWhatOtherProgramsWrite) {
  const auto curves = read("a.obj",
                           "mtllib x.mtl\r\no curve\r\nv 0 0 0 1.0\r\nv +1 0 0 0.5 0.5 0.5\r\n"
                           "vt 0 0\r\nv 1e0 1 0\r\nf 1 2 3\r\nl -3/1 -2/1 \\\r\n -1/1\r\n");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(xs(curves[0]), (std::vector<double>{0, 1, 11}));
}

TEST_F(CurveObj, RefusesMalformedFiles) {
  expect_refused("a.obj", kSquare, {"no line elements"});
  expect_refused("a.obj", "v 0 0\nl 1 1\n", {"line 1", "a coordinate", "end of the line"});
  expect_refused("a.obj", "v 0 0 nan\nl 1 1\n", {"line 1", "finite", "nan"});
  expect_refused("a.obj", "v 0 inf 0\nl 1 1\n", {"line 1", "finite"});
  expect_refused("a.obj", "v 0 1e999 0\nl 1 1\n", {"line 1", "finite"});
  expect_refused("a.obj", "v 0 zero 0\nl 1 1\n", {"line 1", "'zero'"});
  expect_refused("a.obj", kSquare + "l 1 5\n", {"line 5", "no vertex 5", "has 4"});
  expect_refused("a.obj", kSquare + "l 0 1\n", {"line 5", "'0'"});
  expect_refused("a.obj", kSquare + "l 1 -5\n", {"line 5", "'-5'"});
  expect_refused("a.obj", kSquare + "l 1 4294967297\n", {"line 5", "4294967297"});
  expect_refused("a.obj", kSquare + "l 1 99999999999999999999\n", {"line 5"});
  expect_refused("a.obj", kSquare + "l 1\n", {"line 5", "two vertices"});
  expect_refused("a.obj", kSquare + "l 1 x\n", {"line 5", "'x'"});
  expect_refused("a.obj", std::string("\0\1\2\3", 4), {"line 1", "NUL"});
}

TEST_F(CurveTxt, IdsOneALineOrSeparated) {
  for (const char* text : {"7\n3\n5\n", "7 3 5", "7,3,5", "7, 3,\n5\n",
                           "# ids\n7\n# more\n3 # c\n5", "\n\n7\r\n3\r\n5\r\n\r\n",
                           "\xEF\xBB\xBF"
                           "7 3 5"}) {
    const auto curves = read("a.txt", text);
    ASSERT_EQ(curves.size(), 1U) << text;
    EXPECT_FALSE(curves[0].closed);
    EXPECT_EQ(test::ids(curves[0]), (Ids{7, 3, 5}));
  }
}

TEST_F(CurveTxt, TheFirstIdAtTheEndCloses) {
  const auto curves = read("a.txt", "7 3 5 7\n");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_EQ(test::ids(curves[0]), (Ids{7, 3, 5}));
}

TEST_F(CurveTxt, BlankLinesSeparateCurves) {
  const auto curves = read("a.txt", "1\n2\n\n  \n3\n4\n3\n");
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(test::ids(curves[0]), (Ids{1, 2}));
  EXPECT_TRUE(curves[1].closed);
  EXPECT_EQ(test::ids(curves[1]), (Ids{3, 4}));
}

TEST_F(CurveTxt, TheLargestId) {
  EXPECT_EQ(test::ids(read("a.txt", "4294967294 0")[0]), (Ids{4294967294U, 0}));
}

TEST_F(CurveTxt, RefusesMalformedFiles) {
  expect_refused("a.txt", "", {"empty"});
  expect_refused("a.txt", "\n \n", {"no vertex ids"});
  expect_refused("a.txt", "# nothing\n", {"no vertex ids"});
  expect_refused("a.txt", "1\n2\n-3\n", {"line 3", "'-3'"});
  expect_refused("a.txt", "1\n2.5\n", {"line 2", "'2.5'"});
  expect_refused("a.txt", "1 two 3", {"line 1", "'two'"});
  expect_refused("a.txt", "1\n4294967295\n", {"line 2", "4294967295"});
  expect_refused("a.txt", "1\n99999999999999999999999\n", {"line 2"});
  expect_refused("a.txt", "nan", {"line 1", "'nan'"});
  expect_refused("a.txt", std::string("1\n\0\n", 4), {"line 2", "NUL"});
}

}  // namespace
}  // namespace talweg
