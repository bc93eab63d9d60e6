#include "tools/picture/view_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "tools/picture/sample_buffer.hpp"

namespace talweg::picture {
namespace {

constexpr double kThumbnail = 160;  // samples across, enough to find parts that hide a curve
constexpr std::size_t kDirections = 48;

// Directions spread evenly over the sphere, with "up" as the pole.
std::vector<Point> candidate_directions(const Point& up) {
  const Eigen::Matrix3d axes = axes_for(up, Point::UnitX() + 0.3 * Point::UnitY());
  std::vector<Point> directions;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (std::size_t i = 0; i < kDirections; ++i) {
    const double z = 1 - 2 * (double(i) + 0.5) / double(kDirections);
    const double r = std::sqrt(1 - z * z), angle = golden * double(i);
    directions.push_back(axes.transpose() * Point(r * std::cos(angle), r * std::sin(angle), z));
  }
  return directions;
}

// The visibility of a curve on a face at this cosine: full up to an angle of about 55 degrees.
double worth(double cosine) { return std::clamp(cosine / 0.57, 0.0, 1.0); }

struct Thumbnail {
  Camera camera;
  SampleBuffer buffer;
};

Thumbnail draw_thumbnail(const MeshLists& mesh, const Camera& camera) {
  Thumbnail result{camera, SampleBuffer(std::size_t(kThumbnail), std::size_t(kThumbnail))};
  std::vector<Point> projected(mesh.points.size());
  for (std::size_t v = 0; v < projected.size(); ++v) {
    projected[v] = result.camera.project(mesh.points[v]);
  }
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    result.buffer.draw_triangle(static_cast<std::uint32_t>(f), projected[a], projected[b],
                                projected[c]);
  }
  return result;
}

Thumbnail draw_thumbnail(const MeshLists& mesh, const Point& direction, const Point& up) {
  const Eigen::Matrix3d axes = axes_for(direction, up);
  return draw_thumbnail(mesh, framed(axes, mesh_extent(mesh, axes), kThumbnail, kThumbnail, 0.02));
}

// A thumbnail of a ball's surroundings, without limits in depth.
Thumbnail draw_ball(const MeshLists& mesh, const Point& center, double radius,
                    const Point& direction, const Point& up) {
  Camera camera;
  camera.axes = axes_for(direction, up);
  camera.center = center;
  camera.width = camera.height = kThumbnail;
  camera.scale = 0.5 * kThumbnail / radius;
  return draw_thumbnail(mesh, camera);
}

// The visibility of a point on the surface, in [0, 1]: 0 if the mesh hides it.
double visibility(const std::vector<Eigen::Vector3f>& normals, const Thumbnail& view,
                  const Point& point, const Point& direction) {
  const Point p = view.camera.project(point);
  const auto column = static_cast<std::size_t>(std::clamp(p.x(), 0.0, kThumbnail - 1));
  const auto row = static_cast<std::size_t>(std::clamp(p.y(), 0.0, kThumbnail - 1));
  const std::uint32_t face = view.buffer.id(column, row);
  if (face == SampleBuffer::kNothing || view.buffer.depth(column, row) > p.z() + 3) return 0;
  return worth(normals[3 * std::size_t(face)].cast<double>().dot(direction));
}

// The visible part of the curves' length, weighted by inclination.
double visible_length(const Scene& scene, const std::vector<Eigen::Vector3f>& normals,
                      const Thumbnail& view, const Point& direction) {
  double sum = 0;
  for (const PictureCurve& curve : scene.curves) {
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
      const Point middle = 0.5 * (curve.points[i] + curve.points[i + 1]);
      sum += visibility(normals, view, middle, direction) *
             (curve.points[i + 1] - curve.points[i]).norm();
    }
  }
  return sum;
}

double seen_area(const Thumbnail& view) {
  double samples = 0;
  for (std::size_t y = 0; y < view.buffer.height(); ++y) {
    for (std::size_t x = 0; x < view.buffer.width(); ++x) {
      if (view.buffer.id(x, y) != SampleBuffer::kNothing) ++samples;
    }
  }
  return samples / (view.camera.scale * view.camera.scale);
}

Point mean_normal(const MeshLists& mesh, double& flatness) {
  Point sum = Point::Zero();
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point n = (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
    sum += n;
    area += n.norm();
  }
  flatness = area > 0 ? sum.norm() / area : 0;
  return sum;
}

// Turning angles at the points of a polyline.
std::vector<double> turning(const PictureCurve& curve) {
  const std::size_t n = curve.points.size();
  std::vector<double> angles(n, 0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Point u = curve.points[i] - curve.points[i - 1],
                w = curve.points[i + 1] - curve.points[i];
    angles[i] = std::atan2(u.cross(w).norm(), u.dot(w));
  }
  return angles;
}

// The middle of the first window of 2 half + 1 values with the largest sum.
std::size_t fullest_window(const std::vector<double>& values, std::size_t half) {
  double sum = 0, most = -1;
  std::size_t middle = values.size() / 2;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += values[i];
    if (i > 2 * half) sum -= values[i - 2 * half - 1];
    if (i >= 2 * half && sum > most) {
      most = sum;
      middle = i - half;
    }
  }
  return middle;
}

}  // namespace

Extent mesh_extent(const MeshLists& mesh, const Eigen::Matrix3d& axes) {
  Extent extent;
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) extent.add(axes * mesh.points[v]);
  }
  return extent;
}

Extent curve_extent(const Scene& scene, const std::vector<std::size_t>& curves,
                    const Eigen::Matrix3d& axes) {
  Extent extent;
  for (const std::size_t c : curves) {
    for (const Point& p : scene.curves[c].points) extent.add(axes * p);
  }
  return extent;
}

Point upright_of(const Scene& scene) {
  if (scene.up) return *scene.up;
  double flatness = 0;
  const Point normal = mean_normal(scene.mesh, flatness);
  if (flatness > 0.5) {
    const Point size = mesh_extent(scene.mesh, axes_for(normal, Point::UnitY())).size();
    if (size.z() < 0.4 * std::min(size.x(), size.y())) return normal.normalized();
  }
  return Point::UnitY();
}

Point best_direction(const Scene& scene, const std::vector<Eigen::Vector3f>& normals,
                     const Point& up) {
  const bool any_curve = std::any_of(scene.curves.begin(), scene.curves.end(),
                                     [](const auto& c) { return c.points.size() > 1; });
  Point best = Point::UnitZ();
  double best_score = -1;
  for (const Point& direction : candidate_directions(up)) {
    const Thumbnail view = draw_thumbnail(scene.mesh, direction, up);
    const double seen =
        any_curve ? visible_length(scene, normals, view, direction) : seen_area(view);
    const double elevation = direction.dot(up.normalized());
    const double score = seen * (1 - 0.25 * std::abs(elevation - 0.45));
    if (score > best_score) {
      best_score = score;
      best = direction;
    }
  }
  return best;
}

Detail most_turning_place(const Scene& scene, const std::vector<Eigen::Vector3f>& normals,
                          const Point& direction, const Point& up) {
  Detail detail;
  const std::vector<Point>& points = scene.curves.front().points;
  const std::size_t n = points.size();
  const std::size_t half = std::max<std::size_t>(2, std::min<std::size_t>(n / 8, 13));
  std::vector<double> angles = turning(scene.curves.front());
  const Thumbnail view = draw_thumbnail(scene.mesh, direction, up);
  for (std::size_t i = 0; i < n; ++i) {
    angles[i] = (angles[i] + 0.1) * visibility(normals, view, points[i], direction);
  }
  const std::size_t place = fullest_window(angles, half);
  const std::size_t begin = place - std::min(place, half), end = std::min(n, place + half + 1);
  Extent extent;
  for (std::size_t i = begin; i < end; ++i) extent.add(points[i]);
  detail.center = extent.center();
  detail.radius = 0.5 * extent.size().norm();
  detail.normal = normal_around(scene.mesh, normals, detail.center, detail.radius);

  const Thumbnail above = draw_thumbnail(scene.mesh, detail.normal, up);
  double clear = 0, before = 0;
  for (std::size_t i = begin; i < end; ++i) {
    clear += visibility(normals, above, points[i], detail.normal);
    before += visibility(normals, view, points[i], direction);
  }
  if (clear < before) detail.normal = direction;
  return detail;
}

Point normal_around(const MeshLists& mesh, const std::vector<Eigen::Vector3f>& normals,
                    const Point& center, double radius) {
  Point normal = Point::Zero();
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = mesh.points[mesh.triangles[f][k]];
      if ((p - center).norm() < radius) normal += normals[3 * f + k].cast<double>();
    }
  }
  return normal.norm() > 0 ? Point(normal.normalized()) : Point(Point::UnitZ());
}

Point clear_direction(const Scene& scene, const std::vector<Eigen::Vector3f>& normals,
                      const Point& center, double radius, const Point& normal, const Point& up) {
  const auto seen_from = [&](const Point& direction) {
    const Thumbnail view = draw_ball(scene.mesh, center, radius, direction, up);
    double sum = 0;
    for (const PictureCurve& curve : scene.curves) {
      for (const Point& p : curve.points) {
        if ((p - center).norm() < radius) sum += visibility(normals, view, p, direction);
      }
    }
    return sum;
  };
  constexpr double kClearly = 1.15, kAside = 0.4;  // at most 66 degrees from the normal
  Point best = normal;
  double most = kClearly * seen_from(normal);
  for (const Point& direction : candidate_directions(normal)) {
    if (direction.dot(normal) < kAside) continue;
    const double seen = seen_from(direction);
    if (seen <= most) continue;
    most = seen;
    best = direction;
  }
  return best;
}

}  // namespace talweg::picture
