#include "tools/picture/render.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Geometry>

#include "talweg/intrinsic/error.hpp"
#include "tools/picture/ambient_occlusion.hpp"
#include "tools/picture/camera.hpp"
#include "tools/picture/caption.hpp"
#include "tools/picture/corner_normals.hpp"
#include "tools/picture/outward.hpp"
#include "tools/picture/sample_buffer.hpp"
#include "tools/picture/scene_check.hpp"
#include "tools/picture/shading.hpp"
#include "tools/picture/view_choice.hpp"

namespace talweg::picture {
namespace {

constexpr std::uint32_t kTube = 0x80000000U;  // a sample's id: a face, or this + 256 curve + facing

constexpr double kDetailEdges = 5;  // radius of a detail without a radius

// The data that all panels of a picture share.
struct Studio {
  Scene scene;
  const RenderOptions& options;
  std::vector<Eigen::Vector3f> normals;
  Point up;
  std::optional<Point> direction;
  double mean_edge = 0;
};

std::vector<std::size_t> curves_of(const Panel& panel, const Scene& scene) {
  if (!panel.curves.empty()) return panel.curves;
  std::vector<std::size_t> all(scene.curves.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

double mean_edge_length(const MeshLists& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum += (mesh.points[t[k]] - mesh.points[t[(k + 1) % 3]]).norm();
    }
  }
  return sum / (3.0 * double(mesh.triangles.size()));
}

bool has_curve_points(const Scene& scene) {
  return std::any_of(scene.curves.begin(), scene.curves.end(),
                     [](const PictureCurve& c) { return !c.points.empty(); });
}

Point shared_direction(Studio& studio) {
  if (!studio.direction) {
    studio.direction = best_direction(studio.scene, studio.normals, studio.up);
  }
  return *studio.direction;
}

Detail turning_detail(Studio& studio, const std::optional<Point>& view) {
  return most_turning_place(studio.scene, studio.normals, view ? *view : shared_direction(studio),
                            studio.up);
}

Camera detail_camera(Studio& studio, const Panel& panel, double width, double height) {
  const Detail detail = panel.detail ? *panel.detail : turning_detail(studio, panel.view);
  const double radius = detail.radius > 0 ? detail.radius : kDetailEdges * studio.mean_edge;
  Camera camera;
  camera.axes = axes_for(panel.view.value_or(detail.normal), studio.up);
  camera.center = detail.center;
  camera.width = width;
  camera.height = height;
  camera.scale = panel.zoom * 0.5 * std::min(width, height) / radius;
  return camera;
}

// The extent of a curve with its surroundings, at most the mesh's.
Extent with_surroundings(Extent curve, const Extent& mesh) {
  const Point grow = 1.2 * Point::Constant(curve.size().head<2>().maxCoeff());
  curve.low = (curve.low - grow).cwiseMax(mesh.low);
  curve.high = (curve.high + grow).cwiseMin(mesh.high);
  // If little of the mesh would be cut off, the whole mesh is shown.
  const double seen = (curve.size().head<2>().cwiseQuotient(mesh.size().head<2>())).minCoeff();
  return seen > 0.75 ? mesh : curve;
}

Camera camera_for(Studio& studio, const Panel& panel, double width, double height) {
  const Scene& scene = studio.scene;
  const bool turning = !scene.curves.empty() && !scene.curves.front().points.empty();
  if (panel.detail || (panel.fit == Fit::kDetail && turning)) {
    return detail_camera(studio, panel, width, height);
  }
  const Point direction = panel.view ? *panel.view : shared_direction(studio);
  const Eigen::Matrix3d axes = axes_for(direction, studio.up);
  const Extent mesh = mesh_extent(scene.mesh, axes);
  Extent extent = mesh;
  if (has_curve_points(scene) && panel.fit != Fit::kMesh) {
    // All curves count, not only the panel's, so that panels have equal frames.
    extent = curve_extent(scene, curves_of({}, scene), axes);
    if (panel.fit == Fit::kAuto) extent = with_surroundings(extent, mesh);
  }
  const double margin = panel.fit == Fit::kCurve ? 0.12 : 0.05;
  Camera camera = framed(axes, extent, width, height, margin);
  camera.scale *= panel.zoom;
  return camera;
}

SampleBuffer rasterize(const Studio& studio, const Panel& panel, const Camera& camera,
                       const std::vector<Point>& projected) {
  const RenderOptions& options = studio.options;
  SampleBuffer buffer(options.panel_width * options.supersampling,
                      options.panel_height * options.supersampling);
  const MeshLists& mesh = studio.scene.mesh;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    buffer.draw_triangle(static_cast<std::uint32_t>(f), projected[a], projected[b], projected[c]);
  }
  const auto samples = static_cast<double>(options.supersampling);
  double order = 0;
  for (const std::size_t c : curves_of(panel, studio.scene)) {
    const PictureCurve& curve = studio.scene.curves[c];
    const double radius = 0.5 * curve.width * samples;
    const double lift = (0.3 + 0.1 * order++) * radius;  // later curves on top where they coincide
    const std::uint32_t id = kTube | (static_cast<std::uint32_t>(c) << 8U);
    const std::size_t n = curve.points.size();
    const std::size_t segments = curve.closed || n < 2 ? n : n - 1;
    for (std::size_t i = 0; i < segments; ++i) {
      buffer.draw_tube(id, camera.project(curve.points[i]),
                       camera.project(curve.points[(i + 1) % n]), radius, lift);
    }
  }
  return buffer;
}

// The colour of one sample of the surface, or of a tube.
class Shader {
 public:
  Shader(const Studio& studio, const Camera& camera, const std::vector<Point>& projected)
      : studio_(studio),
        camera_(camera),
        projected_(projected),
        material_(to_linear(studio.options.material)) {
    const double samples = double(studio.options.supersampling);
    const double edge = studio.mean_edge * camera.scale / samples;  // pixels
    line_ = studio.options.mesh_edges ? 0.42 * std::clamp((edge - 11) / 12, 0.0, 1.0) : 0;
    line_width_ = 0.55 * samples;
    for (const PictureCurve& c : studio.scene.curves) tubes_.push_back(to_linear(c.color));
    for (const Color& c : studio.scene.face_colors) faces_.push_back(to_linear(c));
  }

  [[nodiscard]] Light operator()(std::uint32_t id, double x, double y, double open) const {
    if ((id & kTube) != 0) {
      return shade_tube(tubes_[(id & ~kTube) >> 8U], double(id & 255U) / 255);
    }
    const Triangle& t = studio_.scene.mesh.triangles[id];
    const Point &a = projected_[t[0]], &b = projected_[t[1]], &c = projected_[t[2]];
    const auto cross = [](double ux, double uy, double vx, double vy) { return ux * vy - uy * vx; };
    const double area = cross(b.x() - a.x(), b.y() - a.y(), c.x() - a.x(), c.y() - a.y());
    const Eigen::Vector3d weight =
        Eigen::Vector3d(cross(b.x() - x, b.y() - y, c.x() - x, c.y() - y),
                        cross(c.x() - x, c.y() - y, a.x() - x, a.y() - y),
                        cross(a.x() - x, a.y() - y, b.x() - x, b.y() - y)) /
        area;
    const Eigen::Vector3f* n = &studio_.normals[3 * std::size_t(id)];
    Eigen::Vector3d normal =
        camera_.axes * (weight[0] * n[0].cast<double>() + weight[1] * n[1].cast<double>() +
                        weight[2] * n[2].cast<double>())
                           .normalized();
    // On the screen a counterclockwise face is clockwise, since y points down. Interpolated normals
    // may point beyond the horizon of a face that is seen from outside; they are then treated as
    // grazing.
    const bool outside = area < 0;
    if (outside != (normal.z() >= 0))
      normal = Eigen::Vector3d(normal.x(), normal.y(), 0).normalized();
    if (!outside) normal.z() = std::min(normal.z(), -1e-9);
    const Light& material = faces_.empty() ? material_ : faces_[id];
    return shade_surface(material, normal, open) * (1 - line_ * on_edge(weight, area, a, b, c));
  }

 private:
  // The part of the sample, in [0, 1], that the face's outline covers.
  [[nodiscard]] double on_edge(const Eigen::Vector3d& weight, double area, const Point& a,
                               const Point& b, const Point& c) const {
    if (line_ == 0) return 0;
    const auto length = [](const Point& p, const Point& q) { return (q - p).head<2>().norm(); };
    const double doubled = std::abs(area);
    const double distance =
        std::min({weight[0] * doubled / length(b, c), weight[1] * doubled / length(c, a),
                  weight[2] * doubled / length(a, b)});
    return std::clamp(line_width_ + 0.5 - distance, 0.0, 1.0);
  }

  const Studio& studio_;
  const Camera& camera_;
  const std::vector<Point>& projected_;
  Light material_;
  std::vector<Light> tubes_, faces_;
  double line_ = 0, line_width_ = 0;
};

Light background_at(const RenderOptions& options, double height_fraction) {
  return to_linear(options.background) * (1.02 - 0.14 * height_fraction);
}

// The place of captions at the bottom of a panel, pixels.
struct CaptionBand {
  double letters;
  double height;
};

CaptionBand caption_band(const RenderOptions& options, const Panel& panel) {
  const double letters = std::max(9.0, 0.022 * double(options.panel_height));
  const double height = std::min(3.4 * letters, 0.5 * double(options.panel_height));
  return {letters, options.captions && !panel.caption.empty() ? height : 0};
}

void draw_panel(Studio& studio, const Panel& panel, std::size_t left, Image& image) {
  const RenderOptions& options = studio.options;
  const std::size_t samples = options.supersampling;
  const CaptionBand band = caption_band(options, panel);
  const Camera camera = camera_for(studio, panel, double(options.panel_width * samples),
                                   (double(options.panel_height) - band.height) * double(samples));
  std::vector<Point> projected(studio.scene.mesh.points.size());
  for (std::size_t v = 0; v < projected.size(); ++v) {
    projected[v] = camera.project(studio.scene.mesh.points[v]);
  }
  const SampleBuffer buffer = rasterize(studio, panel, camera, projected);
  const double reach = 0.03 * double(std::min(options.panel_width, options.panel_height));
  const std::vector<float> open = openness(buffer, samples, reach);
  const Shader shader(studio, camera, projected);
  for (std::size_t y = 0; y < options.panel_height; ++y) {
    const Light behind = background_at(options, double(y) / double(options.panel_height));
    for (std::size_t x = 0; x < options.panel_width; ++x) {
      Light sum = Light::Zero();
      for (std::size_t k = 0; k < samples * samples; ++k) {
        const std::size_t i = x * samples + k % samples, j = y * samples + k / samples;
        const std::uint32_t id = buffer.id(i, j);
        sum += id == SampleBuffer::kNothing ? behind
                                            : shader(id, double(i) + 0.5, double(j) + 0.5,
                                                     open[y * options.panel_width + x]);
      }
      store(sum / double(samples * samples), image.pixel(left + x, y));
    }
  }
  if (band.height == 0) return;
  // The caption has a plain background, since it could not be read over curves and dark places.
  for (auto y = options.panel_height - static_cast<std::size_t>(band.height);
       y < options.panel_height; ++y) {
    for (std::size_t x = 0; x < options.panel_width; ++x) {
      store(to_linear(options.background), image.pixel(left + x, y));
    }
  }
  draw_caption(image, panel.caption, double(left) + 0.5 * double(options.panel_width),
               double(options.panel_height) - 1.4 * band.letters, band.letters,
               to_linear({0.2, 0.2, 0.22}));
}

Scene seen_from_outside(Scene scene) {
  check_scene(scene);
  scene.mesh = turned_outward(std::move(scene.mesh));
  return scene;
}

Studio studio_of(const Scene& given, const RenderOptions& options) {
  Studio studio{seen_from_outside(given), options, {}, {}, {}};
  studio.normals = corner_normals(studio.scene.mesh);
  studio.up = upright_of(studio.scene);
  studio.mean_edge = mean_edge_length(studio.scene.mesh);
  return studio;
}

// A white line at the right of a panel.
void draw_separator(const RenderOptions& options, std::size_t right, Image& image) {
  const std::size_t width = std::max<std::size_t>(1, options.panel_width / 160);
  for (std::size_t y = 0; y < image.height; ++y) {
    std::fill_n(image.pixel(right - width, y), 3 * width, std::uint8_t{255});
  }
}

}  // namespace

void RenderOptions::validate() const {
  const auto size = [](const char* name, std::size_t value, std::size_t low, std::size_t high) {
    if (value >= low && value <= high) return;
    throw Error(ErrorCode::kBadUsage, std::string(name) + " is " + std::to_string(value) +
                                          ", but must be in [" + std::to_string(low) + ", " +
                                          std::to_string(high) + "]");
  };
  size("panel_width", panel_width, 16, 8192);
  size("panel_height", panel_height, 16, 8192);
  size("supersampling", supersampling, 1, 8);
}

Image render(const Scene& scene, const RenderOptions& options) {
  options.validate();
  Studio studio = studio_of(scene, options);
  const std::vector<Panel> panels = scene.panels.empty() ? std::vector<Panel>(1) : scene.panels;
  Image image;
  image.width = options.panel_width * panels.size();
  image.height = options.panel_height;
  image.rgb.resize(3 * image.width * image.height);
  for (std::size_t k = 0; k < panels.size(); ++k) {
    draw_panel(studio, panels[k], k * options.panel_width, image);
    if (k > 0) draw_separator(options, k * options.panel_width, image);
  }
  return image;
}

Detail turning_detail(const Scene& scene, const std::optional<Point>& view) {
  const RenderOptions options;
  Studio studio = studio_of(scene, options);
  if (scene.curves.empty() || scene.curves.front().points.empty()) {
    throw Error(ErrorCode::kBadUsage, "a detail needs a first curve with points");
  }
  Detail detail = turning_detail(studio, view);
  if (!(detail.radius > 0)) detail.radius = kDetailEdges * studio.mean_edge;
  return detail;
}

Detail detail_at(const Scene& given, const Point& center, double radius) {
  const Scene scene = seen_from_outside(given);
  if (!(radius > 0)) radius = kDetailEdges * mean_edge_length(scene.mesh);
  const std::vector<Eigen::Vector3f> normals = corner_normals(scene.mesh);
  const Point normal = normal_around(scene.mesh, normals, center, radius);
  return {center, clear_direction(scene, normals, center, radius, normal, upright_of(scene)),
          radius};
}

}  // namespace talweg::picture
