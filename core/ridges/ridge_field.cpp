#include "talweg/core/ridges/ridge_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/surface/spokes.hpp"

namespace talweg {
namespace {

using Quadric = Eigen::Matrix<double, 6, 1>;  // coefficients of x², xy, y², x, y, 1

constexpr std::size_t kFewest = 8;  // the fewest vertices to which a quadric is fitted

/// Two unit vectors at right angles to a unit normal and to each other.
std::array<Point, 2> plane_of(const Point& normal) {
  const Point beside = std::abs(normal.x()) < 0.7 ? Point(1, 0, 0) : Point(0, 1, 0);
  const Point u = normal.cross(beside).normalized();
  return {u, normal.cross(u)};
}

}  // namespace

RidgeKind ridge_kind(std::string_view name) {
  if (name == "both") return RidgeKind::kBoth;
  if (name == "convex") return RidgeKind::kConvex;
  if (name == "concave") return RidgeKind::kConcave;
  throw Error(ErrorCode::kBadUsage,
              fmt::format("The kind of ridges must be both, convex or concave, not \"{}\".", name));
}

RidgeField::RidgeField(const SurfaceMesh& mesh, RidgeKind kind, double scale, double roughness)
    : mesh_(&mesh), scale_(scale) {
  constexpr double kAngleOfNoise = 10;  // radians per roughness: three deviations of a dihedral
  rough_angle_ = kAngleOfNoise * roughness;
  counts_ = {kind != RidgeKind::kConcave, kind != RidgeKind::kConvex};
  slot_.resize(mesh.surface().vertex_count());
  stamp_.resize(mesh.surface().vertex_count());
}

RidgeField::Known& RidgeField::known(VertexId vertex) {
  std::uint32_t& slot = slot_[vertex.index()];
  if (slot == 0) {
    known_.emplace_back();
    slot = static_cast<std::uint32_t>(known_.size());
  }
  return known_[slot - 1];
}

/// Gathers the vertices that edge paths inside a ball join to its centre, which is the first
/// vertex.
void RidgeField::gather(VertexId vertex, double radius, std::vector<VertexId>& ball) {
  const Surface& surface = mesh_->surface();
  const Point& middle = mesh_->point(vertex);
  const std::uint32_t stamp = ++gathered_;
  ball.assign(1, vertex);
  stamp_[vertex.index()] = stamp;
  for (std::size_t next = 0; next < ball.size(); ++next) {
    for_each_spoke(surface, ball[next], [&](HalfedgeId h) {
      const VertexId v = surface.head(h);
      if (stamp_[v.index()] == stamp) return;
      stamp_[v.index()] = stamp;
      if ((mesh_->point(v) - middle).norm() <= radius) ball.push_back(v);
    });
  }
}

const Point& RidgeField::normal(VertexId vertex) {
  Known& at = known(vertex);
  if (at.normal) return *at.normal;
  const Surface& surface = mesh_->surface();
  Point sum = Point::Zero();
  for_each_spoke(surface, vertex, [&](HalfedgeId h) {
    if (!surface.has_face(h)) return;
    const auto corners = surface.corners(surface.face(h));
    const Point& p = mesh_->point(corners[0]);
    sum += (mesh_->point(corners[1]) - p).cross(mesh_->point(corners[2]) - p);
  });
  at.normal = sum;
  return *at.normal;
}

/// Fits z = a x² + b xy + c y² + d x + e y + f over the plane of the ball's normal.
RidgeField::Turn RidgeField::fitted(VertexId vertex) {
  std::vector<VertexId> ball;
  gather(vertex, scale_, ball);
  Turn turn;
  if (ball.size() < kFewest) return turn;
  Point sum = Point::Zero();
  for (const VertexId v : ball) sum += normal(v);
  const Point unit = sum.stableNormalized();
  if (!(unit.squaredNorm() > 0)) return turn;
  const auto [u, w] = plane_of(unit);
  Eigen::Matrix<double, 6, 6> left = Eigen::Matrix<double, 6, 6>::Zero();
  Quadric right = Quadric::Zero();
  for (const VertexId v : ball) {
    const Point off = (mesh_->point(v) - mesh_->point(vertex)) / scale_;
    const double x = off.dot(u), y = off.dot(w);
    Quadric row;
    row << x * x, x * y, y * y, x, y, 1;
    left += row * row.transpose();
    right += off.dot(unit) * row;
  }
  constexpr double kFloor = 1e-6;  // makes the fit unique for points on a line
  left.diagonal().array() += kFloor * static_cast<double>(ball.size());
  const Quadric fit = left.ldlt().solve(right);
  if (!fit.allFinite()) return turn;
  Eigen::Matrix2d bend;
  bend << 2 * fit[0], fit[1], fit[1], 2 * fit[2];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(bend);
  for (std::size_t side = 0; side < 2; ++side) {
    const auto k = static_cast<Eigen::Index>(side);  // the smaller eigenvalue belongs to a ridge
    const double curvature = solver.eigenvalues()[k] * (side == 0 ? -1 : 1);
    turn.angle[side] = 2 * std::atan(std::max(0.0, curvature) / 2);
    turn.across[side] = solver.eigenvectors()(0, k) * u + solver.eigenvectors()(1, k) * w;
  }
  turn.along_normal = unit;
  turn.fitted = true;
  return turn;
}

const RidgeField::Turn& RidgeField::turn(VertexId vertex) {
  if (!known(vertex).turn) {
    Turn turn = fitted(vertex);
    known(vertex).turn = turn;
  }
  return *known(vertex).turn;
}

/// The height of a ridge: its angle minus the least angle beside it, within two scales; the side
/// with the larger least angle counts.
double RidgeField::height(VertexId vertex, std::size_t side) {
  if (const auto& value = known(vertex).height[side]) return *value;
  const Turn here = turn(vertex);
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::array<double, 2> least{kNone, kNone};
  std::vector<VertexId> ball;
  if (here.angle[side] > 0) gather(vertex, 2 * scale_, ball);
  const Point along = here.along_normal.cross(here.across[side]);
  for (const VertexId v : ball) {
    const Point off = mesh_->point(v) - mesh_->point(vertex);
    const double t = off.dot(here.across[side]);
    if (std::abs(t) < scale_ / 2 || std::abs(off.dot(along)) > scale_ / 2) continue;
    double& beside = least[t < 0 ? 0 : 1];
    beside = std::min(beside, turn(v).angle[side]);
  }
  double most = -kNone;
  for (const double beside : least) {
    if (beside < kNone) most = std::max(most, beside);
  }
  const double height = most < 0 ? 0 : std::max(0.0, here.angle[side] - most);
  known(vertex).height[side] = height;
  return height;
}

/// The height times the fourth power of its ratio to the largest height across the ridge within the
/// scale.
double RidgeField::sharpened(VertexId vertex, std::size_t side) {
  const double here = height(vertex, side);
  if (!(here > 0)) return 0;
  const Turn turned = turn(vertex);
  const Point along = turned.along_normal.cross(turned.across[side]);
  double most = here;
  std::vector<VertexId> ball;
  gather(vertex, scale_, ball);
  for (const VertexId v : ball) {
    const Point off = mesh_->point(v) - mesh_->point(vertex);
    if (std::abs(off.dot(along)) <= scale_ / 2) most = std::max(most, height(v, side));
  }
  const double part = here / most;
  return here * part * part * part * part;
}

double RidgeField::at(VertexId vertex) {
  if (const auto& value = known(vertex).at) return *value;
  double most = 0;
  for (std::size_t side = 0; side < 2; ++side) {
    if (counts_[side]) most = std::max(most, sharpened(vertex, side));
  }
  known(vertex).at = most;
  return most;
}

/// The angle between the normals of both faces, positive on ridges; 0 at the border.
double RidgeField::dihedral(EdgeId edge) const {
  const Surface& surface = mesh_->surface();
  if (surface.on_boundary(edge)) return 0;
  const HalfedgeId h = halfedge_of(edge);
  const Point& a = mesh_->point(surface.tail(h));
  const Point way = mesh_->point(surface.head(h)) - a;
  const Point left = mesh_->point(surface.head(surface.next(h))) - a;
  const Point right = mesh_->point(surface.head(surface.next(twin(h)))) - a;
  const Point n = way.cross(left), m = right.cross(way);
  const double length = way.stableNorm();
  if (!(length > 0)) return 0;
  return std::atan2(n.cross(m).dot(way) / length, n.dot(m));
}

/// The usual dihedral angle near a vertex: the quantile 0.3 over the edges at the vertex and at its
/// neighbours.
double RidgeField::usual_dihedral(VertexId vertex) {
  const Surface& surface = mesh_->surface();
  std::vector<double> angles;
  const auto add = [&](HalfedgeId h) { angles.push_back(std::abs(dihedral(edge_of(h)))); };
  for_each_spoke(surface, vertex, [&](HalfedgeId h) {
    add(h);
    for_each_spoke(surface, surface.head(h), add);
  });
  if (angles.empty()) return 0;
  const auto at = angles.begin() + static_cast<std::ptrdiff_t>(3 * angles.size() / 10);
  std::nth_element(angles.begin(), at, angles.end());
  return *at;
}

double RidgeField::along(EdgeId edge) {
  const double angle = dihedral(edge);
  if (!counts_[angle > 0 ? 0 : 1]) return 0;
  const double excess = std::abs(angle) - rough_angle_;
  constexpr double kLeast = 0.05;  // radians
  if (!(excess > kLeast)) return 0;
  const HalfedgeId h = halfedge_of(edge);
  const Surface& surface = mesh_->surface();
  const double usual = std::max(usual_dihedral(surface.tail(h)), usual_dihedral(surface.head(h)));
  return std::max(0.0, std::min(excess, std::abs(angle) - usual));
}

}  // namespace talweg
