#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/intrinsic/error.hpp"
#include "tools/picture/arguments.hpp"
#include "tools/picture/corner_normals.hpp"
#include "tools/picture/face_colors.hpp"
#include "tools/picture/image.hpp"
#include "tools/picture/outward.hpp"
#include "tools/picture/render.hpp"
#include "tools/picture/sample_buffer.hpp"

namespace talweg::picture {
namespace {

MeshLists square() {
  MeshLists mesh;
  mesh.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// A square in z = 0 seen from +z, with y upwards; one sample per pixel.
Scene square_scene() {
  Scene scene;
  scene.mesh = square();
  scene.up = Point::UnitY();
  Panel panel;
  panel.fit = Fit::kMesh;
  panel.view = Point::UnitZ();
  scene.panels = {panel};
  return scene;
}

RenderOptions plain() {
  RenderOptions options;
  options.panel_width = options.panel_height = 100;
  options.supersampling = 1;
  options.mesh_edges = false;
  return options;
}

bool is_red(const Image& image, std::size_t x, std::size_t y) {
  const std::uint8_t* p = image.pixel(x, y);
  return p[0] > 2 * p[1] + 20 && p[0] > 2 * p[2] + 20;
}

std::size_t count_red(const Image& image) {
  std::size_t count = 0;
  for (std::size_t y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < image.width; ++x) count += is_red(image, x, y) ? 1U : 0U;
  }
  return count;
}

PictureCurve red_line(const Point& a, const Point& b, double width) {
  return {{a, b}, false, {1, 0, 0}, width};
}

ErrorCode code_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "no Error was thrown";
  return ErrorCode::kNumerical;
}

TEST(SampleBuffer, ATriangleCoversTheSamplesWithCentresInsideIt) {
  SampleBuffer buffer(10, 10);
  buffer.draw_triangle(7, {0, 0, 1}, {10, 0, 1}, {0, 10, 1});
  for (std::size_t y = 0; y < 10; ++y) {
    for (std::size_t x = 0; x < 10; ++x) {
      const double sum = double(x) + double(y) + 1;  // sum of the coordinates of the centre
      if (sum == 10) continue;                       // the centre is on the edge
      EXPECT_EQ(buffer.id(x, y), sum < 10 ? 7U : SampleBuffer::kNothing) << x << ' ' << y;
    }
  }
}

TEST(SampleBuffer, DepthIsInterpolatedAndTheNearestTriangleStays) {
  SampleBuffer buffer(8, 8);
  // z = 2 x + 3 y over the whole raster, and a plane z = 10 across it.
  buffer.draw_triangle(1, {-8, -8, -40}, {24, -8, 24}, {-8, 24, 56});
  EXPECT_FLOAT_EQ(buffer.depth(2, 5), 2 * 2.5F + 3 * 5.5F);
  buffer.draw_triangle(2, {-8, -8, 10}, {-8, 24, 10}, {24, -8, 10});
  for (std::size_t y = 0; y < 8; ++y) {
    for (std::size_t x = 0; x < 8; ++x) {
      const double z = 2 * (double(x) + 0.5) + 3 * (double(y) + 0.5);
      if (std::abs(z - 10) < 1e-9) continue;
      EXPECT_EQ(buffer.id(x, y), z > 10 ? 1U : 2U);
    }
  }
}

TEST(SampleBuffer, ATriangleOutsideTheRasterCoversNoSample) {
  SampleBuffer buffer(4, 4);
  buffer.draw_triangle(1, {-9, -9, 0}, {-5, -9, 0}, {-5, -5, 0});
  buffer.draw_triangle(1, {1, 1, 0}, {2, 2, 0}, {3, 3, 0});  // no area
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(buffer.id(i % 4, i / 4), SampleBuffer::kNothing);
}

TEST(SampleBuffer, ATubeIsARoundCylinder) {
  SampleBuffer buffer(20, 11);
  buffer.draw_tube(0, {-5, 5.5, 0}, {25, 5.5, 0}, 4, 0);
  // Sample centres are 0, 1, ... 5 away from the axis.
  for (std::size_t away = 0; away <= 3; ++away) {
    const auto d = double(away);
    EXPECT_FLOAT_EQ(buffer.depth(10, 5 + away), static_cast<float>(std::sqrt(16 - d * d)));
    EXPECT_EQ(buffer.id(10, 5 + away), buffer.id(10, 5 - away));
  }
  EXPECT_EQ(buffer.id(10, 10), SampleBuffer::kNothing);
  EXPECT_EQ(buffer.id(10, 5), 255U);
}

TEST(CornerNormals, SmoothBelowTheCreaseAngleSharpAboveIt) {
  MeshLists roof;  // two faces at a right angle
  roof.points = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  roof.triangles = {{0, 2, 1}, {0, 1, 3}};
  const auto sharp = corner_normals(roof);
  EXPECT_NEAR(sharp[0].z(), 1, 1e-6);
  EXPECT_NEAR(sharp[3].x(), 1, 1e-6);
  const auto smooth = corner_normals(roof, 2.0);
  EXPECT_NEAR(smooth[0].x(), std::sqrt(0.5), 1e-6);  // both faces have the same area
  EXPECT_NEAR(smooth[0].z(), std::sqrt(0.5), 1e-6);
}

TEST(Render, TheCentreShowsTheMeshAndTheCornerTheBackground) {
  const RenderOptions options = plain();
  const Image image = render(square_scene(), options);
  ASSERT_EQ(image.rgb.size(), 3U * 100 * 100);
  // The frame leaves 5 % free on each side: the square covers pixels 5 to 94.
  const std::uint8_t* background = image.pixel(0, 50);
  const std::uint8_t* mesh = image.pixel(50, 50);
  EXPECT_GT(std::abs(background[2] - mesh[2]), 10);
  EXPECT_LT(std::abs(image.pixel(3, 50)[2] - background[2]), 4);
  EXPECT_LT(std::abs(image.pixel(6, 50)[2] - mesh[2]), 10);
  EXPECT_LT(std::abs(image.pixel(93, 50)[2] - mesh[2]), 10);
  EXPECT_LT(std::abs(image.pixel(96, 50)[2] - background[2]), 4);
}

TEST(Render, ACurveOnTheSurfaceHasItsFullWidth) {
  Scene scene = square_scene();
  scene.curves = {red_line({-0.5, 0, 0}, {0.5, 0, 0}, 6)};
  const Image image = render(scene, plain());
  EXPECT_TRUE(is_red(image, 50, 50));
  std::size_t width = 0;
  for (std::size_t y = 0; y < 100; ++y) width += is_red(image, 50, y) ? 1U : 0U;
  EXPECT_EQ(width, 6U);
  EXPECT_FALSE(is_red(image, 15, 50));  // beyond the end of the line
}

TEST(Render, ACurveBehindTheSurfaceIsHidden) {
  Scene scene = square_scene();
  scene.curves = {red_line({-0.5, 0, -0.5}, {0.5, 0, -0.5}, 6)};
  EXPECT_EQ(count_red(render(scene, plain())), 0U);
  scene.panels[0].view = -Point::UnitZ();  // seen from the other side, the curve is in front
  EXPECT_GT(count_red(render(scene, plain())), 100U);
}

MeshLists unit_box() {
  MeshLists box;
  for (int i = 0; i < 8; ++i) box.points.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
  box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return box;
}

MeshLists turned_over(MeshLists mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// A sphere with a small hole at its top.
MeshLists punctured_sphere() {
  MeshLists sphere = test::sphere(3);
  std::erase_if(sphere.triangles, [&](const Triangle& t) {
    return std::ranges::all_of(t, [&](auto v) { return sphere.points[v].z() > 0.9; });
  });
  return sphere;
}

TEST(TurnedOutward, TurnsMeshesWhoseNormalsCancel) {
  MeshLists box = unit_box();
  EXPECT_EQ(turned_outward(box).triangles, box.triangles);
  EXPECT_EQ(turned_outward(turned_over(box)).triangles, box.triangles);
  const MeshLists punctured = punctured_sphere();
  EXPECT_LT(punctured.triangles.size(), test::sphere(3).triangles.size());
  EXPECT_EQ(turned_outward(punctured).triangles, punctured.triangles);
  EXPECT_EQ(turned_outward(turned_over(punctured)).triangles, punctured.triangles);
  box.triangles.resize(10);  // without the side x = 1
  EXPECT_EQ(turned_outward(box).triangles, box.triangles);
  EXPECT_EQ(turned_outward(turned_over(box)).triangles, turned_over(box).triangles);
  box.triangles.resize(8);  // without x = 0, too: a tube
  EXPECT_EQ(turned_outward(box).triangles, box.triangles);
  EXPECT_EQ(turned_outward(turned_over(box)).triangles, box.triangles);
}

TEST(TurnedOutward, VerticesWithoutAFaceChangeNothing) {
  const MeshLists correct = punctured_sphere();
  for (const Point& unused : {Point(0, 0, -1e5), Point(0, 0, 1e5), Point::Constant(NAN).eval()}) {
    MeshLists mesh = correct;
    mesh.points.push_back(unused);
    EXPECT_EQ(turned_outward(mesh).triangles, correct.triangles) << unused.transpose();
    EXPECT_EQ(turned_outward(turned_over(mesh)).triangles, correct.triangles) << unused.transpose();
  }
}

TEST(Render, TheViewIsFromASideThatShowsTheCurve) {
  const MeshLists box = unit_box();
  const std::vector<std::pair<Point, Point>> lines{{{0.3, 0.5, 0}, {0.7, 0.5, 0}},
                                                   {{0.3, 0.5, 1}, {0.7, 0.5, 1}},
                                                   {{0, 0.5, 0.3}, {0, 0.5, 0.7}},
                                                   {{1, 0.5, 0.3}, {1, 0.5, 0.7}}};
  for (const auto& [a, b] : lines) {
    Scene scene;
    scene.mesh = box;
    scene.curves = {red_line(a, b, 4)};
    const Image image = render(scene, plain());
    EXPECT_GT(count_red(image), 40U) << a.transpose();
    for (Triangle& t : scene.mesh.triangles) std::swap(t[1], t[2]);  // inside out, as some files
    EXPECT_TRUE(render(scene, plain()).rgb == image.rgb) << a.transpose();
  }
}

TEST(Render, ScaleOfTheSceneDoesNotMatter) {
  const auto picture = [](double scale) {
    Scene scene = square_scene();
    scene.curves = {red_line({-0.5, 0, 0}, {0.5, 0.25, 0}, 6)};
    for (Point& p : scene.mesh.points) p *= scale;
    for (Point& p : scene.curves[0].points) p *= scale;
    return render(scene, plain()).rgb;
  };
  EXPECT_TRUE(picture(0x1p-40) == picture(1));  // powers of two scale without rounding
  EXPECT_TRUE(picture(0x1p40) == picture(1));
}

TEST(Render, PanelsStandSideBySideWithTheirOwnCurves) {
  Scene scene = square_scene();
  scene.curves = {red_line({-0.5, 0, 0}, {0.5, 0, 0}, 6), red_line({0, -0.5, 0}, {0, 0.5, 0}, 6)};
  scene.panels.push_back(scene.panels[0]);
  scene.panels[0].curves = {0};
  scene.panels[1].curves = {1};
  const Image image = render(scene, plain());
  ASSERT_EQ(image.width, 200U);
  EXPECT_TRUE(is_red(image, 30, 50));
  EXPECT_FALSE(is_red(image, 130, 50));
  EXPECT_TRUE(is_red(image, 150, 30));
  EXPECT_FALSE(is_red(image, 50, 30));
}

TEST(Render, ZoomEnlarges) {
  Scene scene = square_scene();
  scene.curves = {red_line({-0.2, 0, 0}, {0.2, 0, 0}, 6)};
  const std::size_t before = count_red(render(scene, plain()));
  scene.panels[0].zoom = 2;
  const std::size_t after = count_red(render(scene, plain()));
  // The line is 18 pixels long, then 36; its width in pixels and its round ends stay.
  EXPECT_NEAR(double(after) - double(before), 18 * 6, 6);
}

TEST(Render, BadScenesAreRefused) {
  EXPECT_EQ(code_of([] { render(Scene{}); }), ErrorCode::kBadMesh);
  Scene scene = square_scene();
  scene.mesh.triangles[1][2] = 4;
  EXPECT_EQ(code_of([&] { render(scene); }), ErrorCode::kBadMesh);
  scene = square_scene();
  scene.mesh.points[2].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code_of([&] { render(scene); }), ErrorCode::kBadMesh);
  scene = square_scene();
  for (Point& p : scene.mesh.points) p = Point(1, 2, 3);
  EXPECT_EQ(code_of([&] { render(scene); }), ErrorCode::kBadMesh);
  scene = square_scene();
  scene.curves = {red_line({0, 0, 0}, {0, std::numeric_limits<double>::infinity(), 0}, 5)};
  EXPECT_EQ(code_of([&] { render(scene); }), ErrorCode::kBadCurve);
  scene = square_scene();
  scene.panels[0].curves = {0};
  EXPECT_EQ(code_of([&] { render(scene); }), ErrorCode::kBadUsage);
  RenderOptions options;
  options.supersampling = 9;
  EXPECT_EQ(code_of([&] { render(square_scene(), options); }), ErrorCode::kBadUsage);
}

TEST(Arguments, CurvesWithColourAndWidth) {
  const CurveArgument full = curve_argument("a/b.json:ff0080:7.5");
  EXPECT_EQ(full.file, "a/b.json");
  EXPECT_EQ(full.color, (Color{1, 0, 128 / 255.0}));
  EXPECT_EQ(full.width, 7.5);
  EXPECT_EQ(curve_argument("x.obj").file, "x.obj");
  EXPECT_EQ(curve_argument("c:x.obj:00ff00").file, "c:x.obj");
  EXPECT_EQ(code_of([] { curve_argument(""); }), ErrorCode::kBadUsage);
  EXPECT_EQ(code_of([] { curve_argument("x:00ff00:wide"); }), ErrorCode::kBadUsage);
  EXPECT_EQ(code_of([] { curve_argument("x:00ff00:0"); }), ErrorCode::kBadUsage);
}

TEST(Arguments, Panels) {
  const Panel panel = panel_argument("Before|curves=1,3|fit=detail|zoom=2|view=0,0,-1");
  EXPECT_EQ(panel.caption, "Before");
  EXPECT_EQ(panel.curves, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(panel.fit, Fit::kDetail);
  EXPECT_EQ(panel.zoom, 2);
  ASSERT_TRUE(panel.view.has_value());
  EXPECT_EQ(*panel.view, Point(0, 0, -1));
  EXPECT_FALSE(panel_argument("A").at.has_value());
  EXPECT_EQ(panel_argument("A|at=1,-2.5,3").at, Point(1, -2.5, 3));
  const PanelArgument own = panel_argument("A|mesh=b.ply|labels=pieces|move=0,1,2|curves=none");
  EXPECT_EQ(own.mesh, "b.ply");
  EXPECT_EQ(own.labels, "pieces");
  EXPECT_TRUE(own.no_curves);
  ASSERT_TRUE(own.move.has_value());
  EXPECT_EQ(*own.move, Point(0, 1, 2));
  for (const char* bad : {"A|curves=0", "A|fit=all", "A|zoom", "A|view=1,2", "A|tilt=3"}) {
    EXPECT_EQ(code_of([&] { panel_argument(bad); }), ErrorCode::kBadUsage) << bad;
  }
}

TEST(FaceColors, TellLabelsAndPiecesApart) {
  // Three triangles in two pieces, the smaller one first.
  MeshLists mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {6, 1, 0}, {5, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {3, 5, 6}};
  EXPECT_EQ(pieces_of(mesh), (std::vector<std::int64_t>{1, 0, 0}));
  const auto colors = label_colors({7, -3, 7});
  EXPECT_EQ(colors[0], colors[2]);
  EXPECT_NE(colors[0], colors[1]);
  for (const double x : colors[1]) EXPECT_TRUE(x >= 0 && x <= 1);
  move_apart(mesh, {0, 0, 2});
  EXPECT_EQ(mesh.points[0], Point(0, 0, 2));
  EXPECT_EQ(mesh.points[3], Point(5, 0, 0));
}

TEST(Render, ColoursFacesAndRefusesTooFewColours) {
  Scene scene = square_scene();
  scene.face_colors.assign(scene.mesh.triangles.size(), {0.1, 0.2, 0.9});
  const Image image = render(scene, plain());
  const std::uint8_t* middle = image.pixel(image.width / 4, image.height / 3);
  EXPECT_GT(middle[2], 2 * middle[0]);  // blue
  scene.face_colors.pop_back();
  EXPECT_EQ(code_of([&] { render(scene, plain()); }), ErrorCode::kBadUsage);
}

TEST(WritePng, AFileIsWrittenAndAnErrorNamesTheFile) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "talweg_picture_test.png";
  write_png(path, render(square_scene(), plain()));
  std::ifstream file(path, std::ios::binary);
  std::string start(8, ' ');
  file.read(start.data(), 8);
  EXPECT_EQ(start, "\x89PNG\r\n\x1a\n");
  std::filesystem::remove(path);
  EXPECT_EQ(code_of([] { write_png("/nowhere/at/all.png", render(square_scene(), plain())); }),
            ErrorCode::kBadFile);
}

}  // namespace
}  // namespace talweg::picture
