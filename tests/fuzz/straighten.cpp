// FlipOut on random Delta-complexes: faces with random lengths, glued at random, also to
// themselves.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "fuzz_bytes.hpp"
#include "fuzz_target.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/flips/edge_path.hpp"
#include "talweg/intrinsic/flips/flip_out.hpp"
#include "talweg/intrinsic/flips/signpost_triangulation.hpp"
#include "talweg/intrinsic/flips/trace.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg::fuzz {
namespace {

/// A surface of glued faces. Corners joined by glued sides are one vertex, so every vertex has one
/// fan.
Surface glued(Bytes& bytes) {
  const std::uint32_t faces = 1 + bytes.take<std::uint8_t>() % 12;
  std::vector<std::uint32_t> gluing(3 * faces, Surface::kNoSide), open(3 * faces);
  std::vector<std::uint32_t> parent(3 * faces);
  std::iota(open.begin(), open.end(), 0U);
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t c) {
    while (parent[c] != c) c = parent[c];
    return c;
  };
  const auto next = [](std::uint32_t side) { return side / 3 * 3 + (side + 1) % 3; };
  while (open.size() >= 2) {
    const std::uint32_t a = open.back();
    open.pop_back();
    const std::uint8_t pick = bytes.take<std::uint8_t>();
    if (pick >= 240) continue;  // the side stays on the boundary
    const std::size_t k = pick % open.size();
    const std::uint32_t b = open[k];
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(k));
    gluing[a] = b;
    gluing[b] = a;
    parent[root(a)] = root(next(b));
    parent[root(next(a))] = root(b);
  }
  std::vector<std::uint32_t> number(3 * faces, Surface::kNoSide);
  std::uint32_t vertices = 0;
  std::vector<Triangle> triangles(faces);
  for (std::uint32_t c = 0; c < 3 * faces; ++c) {
    std::uint32_t& id = number[root(c)];
    if (id == Surface::kNoSide) id = vertices++;
    triangles[c / 3][c % 3] = id;
  }
  return Surface::from_gluing(vertices, triangles, gluing);
}

/// Sets lengths: mostly valid triangles, also flat ones and needles, sometimes lengths of no
/// triangle.
void set_lengths(Bytes& bytes, Surface& surface) {
  const std::uint8_t how = bytes.take<std::uint8_t>();
  std::vector<double> lengths(surface.edge_count());
  for (double& length : lengths) {
    const std::uint8_t value = bytes.take<std::uint8_t>();
    length = how % 4 == 0 ? 1 + value / 8 % 2                           // many triangles are flat
                          : 1 + value / (how % 4 == 1 ? 256.0 : 64.0);  // or invalid triangles
    if (how >= 224 && value % 16 == 0) length = std::ldexp(length, -(value / 4));
  }
  surface.set_lengths(lengths);
}

/// Walks over edges, turning as the bytes say. Empty where it stands on nothing.
std::vector<HalfedgeId> walk(Bytes& bytes, const SignpostTriangulation& t, bool closed) {
  std::vector<HalfedgeId> path;
  HalfedgeId h{bytes.take<std::uint8_t>() % (2 * t.edge_count())};
  const VertexId start = t.tail(h);
  for (std::uint32_t steps = 1 + bytes.take<std::uint8_t>() % 24; steps > 0; --steps) {
    path.push_back(h);
    const VertexId at = t.head(h);
    if (closed && at == start && steps < 12) return path;
    HalfedgeId out = t.halfedge(at);
    for (std::uint32_t turns = bytes.take<std::uint8_t>() % 16; turns > 0; --turns) {
      if (!t.has_face(out)) break;
      out = t.turn_ccw(out);
    }
    h = out;
  }
  if (closed && t.head(path.back()) != start) path.clear();
  return path;
}

bool faces_stretch(SignpostTriangulation& t) {
  for (std::size_t h = 0; h < 2 * t.edge_count(); ++h) {
    const HalfedgeId side{h};
    if (!t.has_face(side)) continue;
    const double rest = t.length(t.next(side)) + t.length(t.prev(side));
    if (t.length(side) > rest * (1 + 1e-12)) return false;
  }
  return true;
}

}  // namespace

void straighten(const Target& /*target*/, const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  Surface surface = glued(bytes);
  set_lengths(bytes, surface);
  SignpostTriangulation t(surface);
  const bool triangles = faces_stretch(t);
  std::vector<EdgePath> paths;
  for (std::uint32_t n = 1 + bytes.take<std::uint8_t>() % 2; n > 0; --n) {
    const bool closed = bytes.take<std::uint8_t>() % 2 == 1;
    const std::vector<HalfedgeId> path = walk(bytes, t, closed);
    if (!path.empty()) paths.push_back(EdgePath::make(t, path, closed));
  }
  if (paths.empty()) return;
  FlipOutOptions options;
  options.max_iterations = 2000;
  FlipOutResult result;
  try {
    result = FlipOut(t).run(paths, options);
  } catch (const Error& error) {
    require(error.code() == ErrorCode::kBadCurve, "paths that cross are refused");
    return;
  }
  std::vector<EdgePath> straight;
  for (const FlipOutResult::Path& path : result.paths) {
    require(std::isfinite(path.length_after), "a finite length");
    require(path.length_after <= path.length_before, "no longer than before");
    straight.push_back(path.path);
  }
  const TraceResult traced = Tracer(t).trace_and_undo(straight);
  require(traced.curves.size() == straight.size(), "all curves");
  require(t.flip_count() == 0, "all flips undone");
  for (const SurfaceCurve& curve : traced.curves) {
    const std::size_t n = curve.points.size();
    require(n > 0, "points");
    for (std::size_t k = 0; k + (curve.closed ? 0 : 1) < n; ++k) {
      const FaceId face = common_face(surface, curve.points[k], curve.points[(k + 1) % n]);
      require(face.valid() || !triangles, "each point and the next in one face");
    }
  }
}

}  // namespace talweg::fuzz
