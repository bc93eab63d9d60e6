#include "small_mesh.hpp"

#include <cmath>
#include <limits>

namespace talweg::fuzz {
namespace {

/// A sheet of (n + 1) x (n + 1) vertices; `around` and `across` glue opposite sides: tube, torus.
MeshLists sheet(std::uint32_t n, bool around, bool across) {
  MeshLists lists;
  const std::uint32_t columns = around ? n : n + 1, rows = across ? n : n + 1;
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const double a = 6.283185307179586 * i / n, b = 6.283185307179586 * j / n;
      if (!around) {
        lists.points.emplace_back(i, j, 0);
      } else if (!across) {
        lists.points.emplace_back(std::cos(a), std::sin(a), j);
      } else {
        const double r = 3 + std::cos(b);
        lists.points.emplace_back(r * std::cos(a), r * std::sin(a), std::sin(b));
      }
    }
  }
  const auto id = [&](std::uint32_t i, std::uint32_t j) {
    return i % columns + (j % rows) * columns;
  };
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      lists.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      lists.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return lists;
}

MeshLists octahedron() {
  MeshLists lists;
  for (const double s : {1.0, -1.0}) {
    for (int k = 0; k < 3; ++k) lists.points.emplace_back(s * Point::Unit(k));
  }
  lists.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2},
                     {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
  return lists;
}

MeshLists soup(Bytes& bytes) {
  MeshLists lists;
  const std::uint32_t vertices = 3 + bytes.take<std::uint8_t>() % 12;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const auto packed = bytes.take<std::uint16_t>();
    lists.points.emplace_back(packed & 7U, packed >> 3U & 7U, packed >> 6U & 7U);
  }
  for (std::uint32_t f = bytes.take<std::uint8_t>() % 32; f > 0; --f) {
    Triangle t{};
    for (std::uint32_t& v : t) v = bytes.take<std::uint8_t>() % vertices;
    lists.triangles.push_back(t);
  }
  return lists;
}

MeshLists clean(Bytes& bytes, bool any) {
  const std::uint8_t kind = bytes.take<std::uint8_t>();
  const std::uint32_t n = 3 + kind / 8 % 5;
  switch (kind % (any ? 6 : 4)) {
    case 0:
      return sheet(n, false, false);
    case 1:
      return sheet(n, true, false);
    case 2:
      return sheet(n, true, true);
    case 3:
      return octahedron();
    default:
      return soup(bytes);
  }
}

/// Moves a vertex: slightly, onto another vertex, far away, or by the size of rounding.
void move(Bytes& bytes, MeshLists& lists, bool any) {
  Point& p = lists.points[bytes.take<std::uint8_t>() % lists.points.size()];
  const Point& q = lists.points[bytes.take<std::uint8_t>() % lists.points.size()];
  const std::uint8_t how = bytes.take<std::uint8_t>();
  switch (how % 8) {
    case 0:
      p = q;
      break;
    case 1:
      p = q + (p - q) * std::ldexp(1.0, -static_cast<int>(how / 4));
      break;
    case 2:
      p *= std::ldexp(1.0, how / 16);
      break;
    case 3:
      if (any) p[0] = bytes.take<double>();
      break;
    default:
      for (double& x : p) x += bytes.take<std::int8_t>() / 128.0;
  }
}

void damage_face(Bytes& bytes, MeshLists& lists) {
  const auto n = static_cast<std::uint32_t>(lists.points.size());
  Triangle& t = lists.triangles[bytes.take<std::uint8_t>() % lists.triangles.size()];
  switch (bytes.take<std::uint8_t>() % 8) {
    case 0:
      t[0] = bytes.index(n);
      break;
    case 1:
      std::swap(t[0], t[1]);
      break;
    case 2:
      lists.triangles.push_back(Triangle(t));
      break;
    case 3:
      t = lists.triangles.back();
      lists.triangles.pop_back();
      break;
    case 4:  // a copy of a corner: a crack with a duplicate position
      lists.points.push_back(Point(lists.points[t[0] % n]));
      t[0] = n;
      break;
    case 5:  // a fin: a face on an edge
      lists.points.emplace_back(0.5, 0.5, 2);
      lists.triangles.push_back({t[0], t[1], n});
      break;
    case 6:
      t[1] = t[0];
      break;
    default:
      lists.points.push_back(Point::Constant(std::numeric_limits<double>::quiet_NaN()));
  }
}

}  // namespace

MeshLists small_mesh(Bytes& bytes, std::uint8_t damage) {
  MeshLists lists = clean(bytes, damage > 0);
  const std::uint8_t shape = bytes.take<std::uint8_t>();
  for (std::uint32_t k = shape % 16; k > 0; --k) move(bytes, lists, damage > 128);
  if ((shape & 64U) != 0) lists.single_precision = true;
  if (damage > 0) {
    for (std::uint32_t k = bytes.take<std::uint8_t>() % 8; k > 0 && !lists.triangles.empty(); --k) {
      damage_face(bytes, lists);
    }
  }
  const double scale = (shape & 128U) != 0 ? std::ldexp(1.0, bytes.take<std::int8_t>() / 4) : 1;
  for (Point& p : lists.points) p *= scale;
  return lists;
}

}  // namespace talweg::fuzz
