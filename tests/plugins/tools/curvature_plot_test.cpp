// The plot of curvature along curves has the numbers of the library, at the right pixels.
#include "tools/picture/curvature_plot.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "talweg/intrinsic/error.hpp"
#include "tools/picture/caption.hpp"
#include "tools/picture/contact_sheet.hpp"
#include "tools/picture/curve_turning.hpp"
#include "tools/picture/strokes.hpp"

namespace talweg::picture {
namespace {

Image white(std::size_t width, std::size_t height) {
  Image image;
  image.width = width;
  image.height = height;
  image.rgb.assign(3 * width * height, 255);
  return image;
}

bool is_blue(const Image& image, std::size_t x, std::size_t y) {
  const std::uint8_t* p = image.pixel(x, y);
  return p[2] > 150 && p[0] < 60 && p[1] < 60;
}

/// The mean of the blue rows of a column; -1 if no row is blue.
double blue_row(const Image& image, std::size_t x) {
  double sum = 0, count = 0;
  for (std::size_t y = 0; y < image.height; ++y) {
    if (!is_blue(image, x, y)) continue;
    sum += double(y) + 0.5;
    ++count;
  }
  return count > 0 ? sum / count : -1;
}

PlotLine blue(std::vector<CurvatureStep> steps) { return {"a", std::move(steps), {0, 0, 1}, 2}; }

bool refused(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.code() == ErrorCode::kBadUsage;
  }
  return false;
}

TEST(Strokes, APixelIsPaintedOnceByAStrokeThatCrossesItself) {
  Image once = white(40, 20), often = white(40, 20);
  draw_stroke(once, {{5, 10.2}, {35, 10.2}}, 1, Light(0, 0, 0));
  draw_stroke(often, {{5, 10.2}, {35, 10.2}, {5, 10.2}, {35, 10.2}}, 1, Light(0, 0, 0));
  EXPECT_EQ(once.rgb, often.rgb);
  EXPECT_LT(once.pixel(20, 10)[0], 20);
  EXPECT_EQ(once.pixel(20, 13)[0], 255);
  EXPECT_EQ(once.pixel(2, 10)[0], 255);
  EXPECT_LT(once.pixel(20, 11)[0], 255);  // covered in part
  EXPECT_GT(once.pixel(20, 11)[0], once.pixel(20, 10)[0]);
}

TEST(Strokes, PartsOutsideThePictureAreCutOff) {
  Image image = white(20, 20);
  draw_stroke(image, {{-50, 10}, {70, 10}, {70, -40}}, 1, Light(0, 0, 0));
  fill_box(image, {-5, 15}, {50, 90}, Light(0, 0, 0));
  EXPECT_EQ(image.pixel(0, 5)[0], 255);
  EXPECT_LT(image.pixel(0, 10)[0], 60);
  EXPECT_EQ(image.pixel(19, 19)[0], 0);
}

TEST(CaptionWidth, IsTheWidthOfTheDrawnText) {
  Image image = white(200, 40);
  draw_caption(image, "HH", 100, 30, 12, Light(0, 0, 0));
  const double half = 0.5 * caption_width("HH", 12);
  const auto dark = [&](double x) {
    bool any = false;
    for (std::size_t y = 0; y < 40; ++y) any |= image.pixel(std::size_t(x), y)[0] < 128;
    return any;
  };
  EXPECT_TRUE(dark(100 - half));
  EXPECT_TRUE(dark(100 + half));
  EXPECT_FALSE(dark(100 - half - 3));
  EXPECT_FALSE(dark(100 + half + 3));
}

TEST(Stacked, PicturesStandOneBeneathTheOther) {
  Image top = white(4, 2), bottom = white(6, 3);
  top.pixel(3, 1)[0] = 1;
  bottom.pixel(5, 0)[0] = 2;
  const Image both = stacked(top, bottom);
  EXPECT_EQ(both.width, 6U);
  EXPECT_EQ(both.height, 5U);
  EXPECT_EQ(both.pixel(3, 1)[0], 1);
  EXPECT_EQ(both.pixel(5, 2)[0], 2);
  EXPECT_EQ(both.pixel(5, 1)[0], 255);
}

TEST(CurvaturePlot, StepsAreDrawnAtTheirArcLengths) {
  CurvaturePlot plot;
  plot.edge = 0.5;
  plot.lines = {blue({{0, 5, 1}, {5, 10, -1}})};
  const Image image = draw_curvature(plot, 600, 200);
  ASSERT_EQ(image.rgb.size(), 3U * 600 * 200);
  // The frame is 62 to 582 wide and 34 to 156 high; the range is 1.08 times the largest value.
  const double middle = 95, reach = 61 / 1.08;
  EXPECT_NEAR(blue_row(image, 62 + 130), middle - reach, 0.6);
  EXPECT_NEAR(blue_row(image, 62 + 390), middle + reach, 0.6);
  EXPECT_EQ(blue_row(image, 30), -1);
}

TEST(CurvaturePlot, BackgroundLinesAreClippedAndDoNotWidenTheRange) {
  CurvaturePlot plot;
  plot.edge = 1;
  plot.lines = {blue({{0, 1, 100}, {1, 2, 0}}), blue({{0, 7, 1}})};
  plot.lines[0].behind = true;
  plot.lines[0].color = {1, 0, 0};
  const Image image = draw_curvature(plot, 600, 200);
  EXPECT_NEAR(blue_row(image, 300), 95 - 61 / 1.08, 0.6);
  const Image alone = [&] {
    CurvaturePlot only = plot;
    only.lines.erase(only.lines.begin());
    return draw_curvature(only, 600, 200);
  }();
  EXPECT_EQ(blue_row(alone, 300), blue_row(image, 300));
  for (std::size_t x = 80; x < 300; ++x) {  // no pixel above the frame is blue
    const std::uint8_t* p = image.pixel(x, 32);
    EXPECT_LT(std::abs(p[0] - p[1]), 8) << x;
  }
}

TEST(CurvaturePlot, TheStretchesOfPicturesAreShaded) {
  CurvaturePlot plot;
  plot.edge = 1;
  plot.lines = {blue({{0, 1, 1}})};
  plot.shown = {{0.25, 0.5}};
  const Image image = draw_curvature(plot, 600, 200);
  const std::size_t row = 120;
  EXPECT_EQ(image.pixel(62 + 100, row)[0], 255);
  EXPECT_LT(image.pixel(62 + 200, row)[0], 250);
  EXPECT_EQ(image.pixel(62 + 300, row)[0], 255);
}

TEST(CurvaturePlot, PlotsWithoutLinesOrOfBadSizeAreRefused) {
  CurvaturePlot plot;
  plot.edge = 1;
  EXPECT_TRUE(refused([&] { draw_curvature(plot, 600, 200); }));
  plot.lines = {blue({{0, 1, 0}})};
  EXPECT_FALSE(refused([&] { draw_curvature(plot, 600, 200); }));  // straight
  EXPECT_TRUE(refused([&] { draw_curvature(plot, 100, 200); }));
  EXPECT_TRUE(refused([&] { draw_curvature(plot, 600, 9000); }));
  plot.edge = 0;
  EXPECT_TRUE(refused([&] { draw_curvature(plot, 600, 200); }));
}

TEST(StretchesIn, AreThePartsOfACurveWithinABall) {
  PictureCurve curve;
  for (int k = 0; k <= 100; ++k) curve.points.emplace_back(0.1 * k, 0, 0);
  const std::vector<Stretch> one = stretches_in(curve, {3, 0, 0}, 1);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_NEAR(one[0].from, 0.2, 0.011);
  EXPECT_NEAR(one[0].to, 0.4, 0.011);
  EXPECT_TRUE(stretches_in(curve, {3, 5, 0}, 1).empty());
  EXPECT_TRUE(stretches_in({}, {3, 5, 0}, 1).empty());
}

/// A flat sheet of n by n squares of side 1, each of two triangles.
MeshLists sheet(std::uint32_t n) {
  MeshLists mesh;
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i <= n; ++i) mesh.points.emplace_back(i, j, 0);
  }
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  return mesh;
}

CurveInput circle(const Point& center, double radius) {
  std::vector<Point> points;
  for (int k = 0; k < 720; ++k) {
    const double angle = 2 * std::numbers::pi * k / 720;
    points.push_back(center + radius * Point(std::cos(angle), std::sin(angle), 0));
  }
  CurveInput input;
  input.closed = true;
  input.points = std::move(points);
  return input;
}

TEST(TurningOf, ACircleHasConstantCurvature) {
  const std::vector<CurveInput> curves{circle({5, 5, 0}, 3.1), circle({5, 5, 0}, 2.2)};
  const CurveTurning turning = turning_of(sheet(10), curves);
  EXPECT_NEAR(turning.edge, (2 + std::numbers::sqrt2) / 3, 0.05);
  ASSERT_EQ(turning.steps.size(), 2U);
  double k = 3.1;
  for (const std::vector<CurvatureStep>& steps : turning.steps) {
    EXPECT_NEAR(steps.back().to, 2 * std::numbers::pi * k, 1e-3);
    for (const CurvatureStep& step : steps) EXPECT_NEAR(step.curvature, 1 / k, 0.05 / k);
    k = 2.2;
  }
}

TEST(TurningOf, AMeshThatIsNoSurfaceIsRepaired) {
  MeshLists mesh = sheet(4);
  mesh.triangles.push_back(mesh.triangles[3]);  // a repeated triangle
  std::swap(mesh.triangles[20][0], mesh.triangles[20][1]);
  CurveInput line;
  line.points = std::vector<VertexId>{VertexId{6U}, VertexId{7U}, VertexId{8U}};
  const CurveTurning turning = turning_of(mesh, std::vector{line});
  for (const CurvatureStep& step : turning.steps[0]) EXPECT_NEAR(step.curvature, 0, 1e-9);
}

TEST(DetailAt, TheViewIsFromAboveUnlessAPartIsInTheWay) {
  Scene scene;
  scene.mesh = sheet(10);
  scene.curves = {{{{4, 5, 0}, {5, 5, 0}, {6, 5, 0}}, false, {1, 0, 0}, 4}};
  const Detail above = detail_at(scene, {5, 5, 0}, 2);
  EXPECT_EQ(above.normal, Point(0, 0, 1));
  EXPECT_EQ(above.radius, 2);
  // A lid hides the curve from above, and no more.
  const auto first = static_cast<std::uint32_t>(scene.mesh.points.size());
  for (const Point& p : {Point(3, 4, 1.5), Point(7, 4, 1.5), Point(7, 6, 1.5), Point(3, 6, 1.5)}) {
    scene.mesh.points.push_back(p);
  }
  scene.mesh.triangles.push_back({first, first + 1, first + 2});
  scene.mesh.triangles.push_back({first, first + 2, first + 3});
  const Detail aside = detail_at(scene, {5, 5, 0}, 1.2);
  EXPECT_LT(aside.normal.z(), 0.95);
  EXPECT_GT(aside.normal.z(), 0.3);
  EXPECT_GT(std::abs(aside.normal.y()), std::abs(aside.normal.x()));
}

}  // namespace
}  // namespace talweg::picture
