#include "stress/random_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "talweg/core/drawing/point_marks.hpp"
#include "tools/scenes/hands.hpp"

namespace talweg::stress {
namespace {

using Ids = std::vector<VertexId>;

VertexId any_vertex(const Surface& surface, Random& random) {
  const VertexId v{random.below(surface.vertex_count())};
  return surface.halfedge(v).valid() || random.one_in(20)
             ? v
             : surface.tail(HalfedgeId{random.below(surface.halfedge_count())});
}

std::array<double, 3> any_barycentric(Random& random) {
  std::array<double, 3> b = {random.unit(), random.unit(), random.unit()};
  if (random.one_in(4)) b[random.below(3)] = 0;
  if (random.one_in(4)) b[random.below(3)] *= random.scale(1e-18, 1e-6);
  const double sum = b[0] + b[1] + b[2];
  if (!(sum > 0)) return {1, 0, 0};
  for (double& x : b) x /= sum;
  return b;
}

FaceCoordinates any_place(const Surface& surface, Random& random) {
  return {FaceId{random.below(surface.face_count())}, any_barycentric(random)};
}

Point position_of(const SurfaceMesh& mesh, const FaceCoordinates& at) {
  Point p = Point::Zero();
  const auto corners = mesh.surface().corners(at.face);
  for (std::size_t k = 0; k < 3; ++k) p += at.barycentric[k] * mesh.point(corners[k]);
  return p;
}

/// A random walk along edges; vertices may repeat.
Ids walk(const Surface& surface, Random& random, std::size_t steps) {
  Ids path;
  HalfedgeId h{random.below(surface.halfedge_count())};
  path.push_back(surface.tail(h));
  for (std::size_t k = 0; k < steps; ++k) {
    path.push_back(surface.head(h));
    h = twin(h);
    for (std::size_t turn = 1 + random.below(4); turn > 0; --turn) {
      if (!surface.has_face(h)) break;
      h = surface.turn_ccw(h);
    }
  }
  return path;
}

/// A boundary loop; empty for a closed mesh.
Ids boundary(const Surface& surface, Random& random) {
  const std::size_t start = random.below(surface.halfedge_count());
  for (std::size_t i = 0; i < surface.halfedge_count(); ++i) {
    const HalfedgeId first{(start + i) % surface.halfedge_count()};
    if (surface.has_face(first)) continue;
    Ids loop;
    HalfedgeId h = first;
    do {
      loop.push_back(surface.tail(h));
      h = twin(h);
      while (surface.has_face(h)) h = surface.turn_ccw(h);
    } while (h != first && loop.size() <= surface.vertex_count());
    return loop;
  }
  return {};
}

Ids several_vertices(const Surface& surface, Random& random, std::size_t count) {
  Ids result;
  for (std::size_t k = 0; k < count; ++k) result.push_back(any_vertex(surface, random));
  return result;
}

/// A figure with loops, projected onto the mesh from one side; every point goes to the nearest
/// face.
std::vector<Point> figure(const SurfaceMesh& mesh, Random& random) {
  Point low = mesh.points().front(), high = low;
  for (const Point& p : mesh.points()) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Point centre = (low + high) / 2, half = (high - low) / 2;
  const double a = static_cast<double>(1 + random.below(3));
  const double b = static_cast<double>(1 + random.below(3));
  const double phase = random.uniform(0, 6);
  std::vector<Point> points;
  const std::size_t count = 8 + random.below(60);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
    points.push_back(centre +
                     0.8 * half.cwiseProduct(Point(std::sin(a * t + phase), std::sin(b * t), 0.7)));
  }
  return points;
}

template <class List>
void disturb(List& list, Random& random) {
  if (list.empty()) return;
  const auto place = [&] {
    return list.begin() + static_cast<std::ptrdiff_t>(random.below(list.size()));
  };
  if (random.one_in(6)) {  // a repeat
    const auto value = *place();
    list.insert(place(), value);
  }
  if (random.one_in(6)) {  // a point twice in a row
    const auto at = place();
    const auto value = *at;
    list.insert(at, value);
  }
  if (random.one_in(6) && list.size() > 1) {  // a spike
    const std::size_t i = 1 + random.below(list.size() - 1);
    const auto before = list[i - 1], tip = list[i];
    const auto at = list.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    list.insert(at, {before, tip});
  }
  if (random.one_in(6)) {  // a piece reversed
    auto from = place(), to = place();
    if (to < from) std::swap(from, to);
    std::reverse(from, to);
  }
  if (random.one_in(12)) {  // out and back
    const List way = list;
    list.insert(list.end(), way.rbegin(), way.rend());
  }
  if (random.one_in(12))
    list.resize(1 + random.below(std::min<std::size_t>(list.size(), 2)), list[0]);
}

CurveInput random_curve(const SurfaceMesh& mesh, Random& random, RandomDrawing& drawing) {
  const Surface& surface = mesh.surface();
  CurveInput curve;
  curve.closed = random.one_in(2);
  const std::size_t count = 2 + random.below(8);
  switch (random.below(7)) {
    case 0: {
      drawing.kind += "walk ";
      Ids path = walk(surface, random, 1 + random.below(60));
      if (curve.closed && path.size() > 1) path.push_back(path.front());
      drawing.connect |= curve.closed;
      disturb(path, random);
      curve.points = std::move(path);
      break;
    }
    case 1: {
      drawing.kind += "boundary ";
      Ids loop = boundary(surface, random);
      if (loop.empty() || random.one_in(3)) {
        const Ids more = several_vertices(surface, random, 3);
        loop.insert(loop.end(), more.begin(), more.end());
        drawing.connect = true;
      } else if (random.one_in(2)) {
        curve.closed = true;
      }
      if (random.one_in(3)) disturb(loop, random);
      curve.points = std::move(loop);
      break;
    }
    case 2: {
      drawing.kind += "faces ";
      std::vector<FaceCoordinates> places;
      for (std::size_t k = 0; k < count; ++k) places.push_back(any_place(surface, random));
      disturb(places, random);
      curve.points = std::move(places);
      break;
    }
    case 3: {
      drawing.kind += "positions ";
      std::vector<Point> points;
      for (std::size_t k = 0; k < count; ++k) {
        points.push_back(position_of(mesh, any_place(surface, random)));
      }
      const double off = random.one_in(2) ? 0 : random.scale(1e-9, 3);
      for (Point& p : points) p += off * mesh.mean_edge_length() * Point(1, -0.3, 0.5);
      if (random.one_in(20)) points[0] *= random.scale(10, 1e300);
      if (random.one_in(40)) points[0].x() = std::nan("");
      disturb(points, random);
      curve.points = std::move(points);
      break;
    }
    case 4: {
      drawing.kind += "figure ";
      curve.closed = true;
      std::vector<Point> points = figure(mesh, random);
      if (random.one_in(3)) disturb(points, random);
      curve.points = std::move(points);
      break;
    }
    case 5: {
      drawing.kind += "many ";
      std::vector<FaceCoordinates> places;
      FaceCoordinates at = any_place(surface, random);
      for (std::size_t k = 20 + random.below(200); k > 0; --k) {
        if (random.one_in(2)) at = {at.face, any_barycentric(random)};
        if (random.one_in(3)) {
          HalfedgeId h = surface.halfedge(at.face);
          for (std::size_t turn = random.below(3); turn > 0; --turn) h = surface.next(h);
          if (surface.has_face(twin(h))) at = {surface.face(twin(h)), any_barycentric(random)};
        }
        places.push_back(at);
      }
      curve.points = std::move(places);
      break;
    }
    default: {
      drawing.kind += "vertices ";
      drawing.connect = true;
      Ids through = several_vertices(surface, random, count);
      disturb(through, random);
      curve.points = std::move(through);
    }
  }
  if (random.one_in(8)) curve.pins.push_back(random.below(count));
  return curve;
}

/// A stroke of a hand and a device around a path on the mesh; empty if there is no room.
CurveInput hand_drawn(const SurfaceMesh& mesh, Random& random) {
  scenes::Hand hand;
  hand.length = random.scale(4, 60);
  hand.amplitude = random.scale(0.05, 1.5);
  hand.wave = random.scale(1, 6);
  if (random.one_in(3)) {
    hand.radius = random.scale(1, 8);
    hand.over = random.uniform(-1, 3);
  }
  scenes::Sampling sampling;
  sampling.step = random.scale(0.02, 2);
  sampling.uneven = random.one_in(3) ? random.scale(1, 10) : 1;
  sampling.jitter = random.one_in(2) ? random.scale(1e-4, 0.3) : 0;
  sampling.off = random.one_in(3) ? random.scale(0.01, 3) : 0;
  sampling.rests = random.below(4);
  sampling.spikes = random.one_in(4) ? random.below(4) : 0;
  sampling.hook = random.one_in(4) ? random.scale(0.1, 2) : 0;
  sampling.doubled = random.one_in(8);
  CurveInput curve;
  const scenes::HandStroke stroke(mesh, hand, random.next());
  if (stroke.is_drawn()) curve.points = stroke.sampled(sampling);
  return curve;
}

}  // namespace

RandomDrawing random_drawing(const SurfaceMesh& mesh, Random& random) {
  RandomDrawing drawing;
  Random own = random;  // strokes of hands must not change the other drawings of a seed
  if (own.one_in(6)) {
    drawing.curves = {hand_drawn(mesh, own)};
    drawing.kind = "hand ";
    if (point_count(drawing.curves[0]) > 1) return drawing;
    drawing = {};
  }
  const std::size_t curves = random.one_in(4) ? 2 + random.below(3) : 1;
  for (std::size_t c = 0; c < curves; ++c) {
    drawing.curves.push_back(random_curve(mesh, random, drawing));
  }
  return drawing;
}

}  // namespace talweg::stress
