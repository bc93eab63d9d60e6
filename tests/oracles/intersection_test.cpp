// Contacts of curves and cut meshes against CGAL's exact predicates. Meshes lie in the plane and
// points on a lattice that doubles represent exactly, so nothing is rounded.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include <CGAL/Constrained_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "polygon_soup.hpp"
#include "stress/planted_defects.hpp"
#include "talweg/core/cutting/face_triangulation.hpp"
#include "talweg/core/cutting/mesh_cutting.hpp"
#include "talweg/core/cutting/seam_opening.hpp"
#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/labels/label_borders.hpp"
#include "talweg/core/labels/label_regions.hpp"
#include "talweg/core/measure/self_contacts.hpp"
#include "talweg/core/mesh/mesh_inspection.hpp"

namespace talweg {
namespace {

using stress::Random;
using test::Soup;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

/// A grid scaled so that the lattice points of its triangles have whole coordinates.
MeshLists lattice_grid(std::uint32_t size, std::int64_t parts) {
  MeshLists lists = test::grid(size, size);
  for (Point& p : lists.points) p *= static_cast<double>(parts);
  return lists;
}

/// A curve, and the exact positions of its points.
struct LatticeCurve {
  SurfaceCurve curve;
  std::vector<Exact::Point_2> at;
};

/// Makes random points of a lattice with `parts` places on each side of a triangle.
class Lattice {
 public:
  Lattice(const SurfaceMesh& mesh, std::int64_t parts) : mesh_(mesh), parts_(parts) {}

  void add_point(LatticeCurve& curve, FaceId face, bool on_side, Random& random) const {
    for (;;) {
      std::array<std::int64_t, 3> b{};
      const auto side = random.below(3);
      b[side] = static_cast<std::int64_t>(random.below(static_cast<std::size_t>(parts_) + 1));
      const auto left = static_cast<std::size_t>(parts_ - b[side]);
      b[(side + 1) % 3] = on_side ? 0 : static_cast<std::int64_t>(random.below(left + 1));
      b[(side + 2) % 3] = parts_ - b[side] - b[(side + 1) % 3];
      Eigen::Vector2d sum(0, 0);
      std::array<double, 3> barycentric{};
      const auto corners = mesh_.surface().corners(face);
      for (std::size_t k = 0; k < 3; ++k) {
        barycentric[k] = static_cast<double>(b[k]) / static_cast<double>(parts_);
        sum += barycentric[k] * mesh_.point(corners[k]).head<2>();
      }
      const Exact::Point_2 at(sum.x(), sum.y());
      if (!curve.at.empty() && curve.at.back() == at) continue;
      curve.at.push_back(at);
      curve.curve.points.push_back(
          SurfacePoint::from_barycentric(mesh_.surface(), face, barycentric));
      return;
    }
  }

  LatticeCurve segment(Random& random) const {
    LatticeCurve result;
    const FaceId face{random.below(mesh_.surface().face_count())};
    for (int k = 0; k < 2; ++k) add_point(result, face, random.one_in(3), random);
    return result;
  }

  /// A curve of `segments` segments that wanders from face to face.
  LatticeCurve wandering(std::size_t segments, Random& random) const {
    LatticeCurve result;
    FaceId face{random.below(mesh_.surface().face_count())};
    add_point(result, face, random.one_in(2), random);
    while (result.at.size() <= segments) {
      add_point(result, face, result.at.size() < segments || random.one_in(2), random);
      const std::vector<FaceId> there = faces_at(mesh_.surface(), result.curve.points.back());
      face = there[random.below(there.size())];
    }
    return result;
  }

 private:
  const SurfaceMesh& mesh_;
  std::int64_t parts_;
};

struct ExactSegment {
  std::size_t curve, number;
  Exact::Segment_2 segment;
};

std::vector<ExactSegment> segments_of(const std::vector<LatticeCurve>& curves) {
  std::vector<ExactSegment> all;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t i = 0; i + 1 < curves[c].at.size(); ++i) {
      all.push_back({c, i, {curves[c].at[i], curves[c].at[i + 1]}});
    }
  }
  return all;
}

bool next_to_each_other(const ExactSegment& s, const ExactSegment& t) {
  return s.curve == t.curve && (s.number + 1 == t.number || t.number + 1 == s.number);
}

/// The curves with segments that cross properly, each through the inside of the other.
std::vector<std::size_t> exactly_crossing(const std::vector<ExactSegment>& all) {
  std::set<std::size_t> crossing;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      const auto &p = all[i].segment, &q = all[k].segment;
      const auto parted = [](const Exact::Segment_2& by, const Exact::Segment_2& s) {
        return CGAL::orientation(by.source(), by.target(), s.source()) *
                   CGAL::orientation(by.source(), by.target(), s.target()) ==
               CGAL::NEGATIVE;
      };
      if (parted(p, q) && parted(q, p)) crossing.insert({all[i].curve, all[k].curve});
    }
  }
  return {crossing.begin(), crossing.end()};
}

struct Places {
  std::size_t count = 0, stretches = 0;
  friend bool operator==(const Places&, const Places&) = default;
};
std::ostream& operator<<(std::ostream& out, const Places& places) {
  return out << places.count << " places, " << places.stretches << " of them stretches";
}

/// The connected parts of the set that segments pass more than once.
Places exact_contacts(const std::vector<ExactSegment>& all) {
  using Common = std::variant<Exact::Point_2, Exact::Segment_2>;
  std::vector<Common> common;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      const auto found = CGAL::intersection(all[i].segment, all[k].segment);
      if (!found) continue;
      if (const auto* s = boost::get<Exact::Segment_2>(&*found)) {
        common.emplace_back(*s);
      } else if (!next_to_each_other(all[i], all[k])) {
        common.emplace_back(boost::get<Exact::Point_2>(*found));
      }
    }
  }
  std::vector<std::size_t> part(common.size());
  for (std::size_t i = 0; i < part.size(); ++i) part[i] = i;
  for (std::size_t i = 0; i < common.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const bool meet =
          std::visit([](const auto& a, const auto& b) { return CGAL::do_intersect(a, b); },
                     common[i], common[k]);
      if (!meet || part[i] == part[k]) continue;
      const std::size_t old = part[i];
      std::replace(part.begin(), part.end(), old, part[k]);
    }
  }
  std::set<std::size_t> parts(part.begin(), part.end()), stretches;
  for (std::size_t i = 0; i < common.size(); ++i) {
    if (common[i].index() == 1) stretches.insert(part[i]);
  }
  return {parts.size(), stretches.size()};
}

Places our_contacts(const Surface& surface, const std::vector<SurfaceCurve>& curves) {
  const auto found = self_contacts(surface, curves);
  const auto stretches =
      std::count_if(found.begin(), found.end(), [](const SelfContact& c) { return c.stretch; });
  return {found.size(), static_cast<std::size_t>(stretches)};
}

std::vector<SurfaceCurve> on_surface(const std::vector<LatticeCurve>& curves) {
  std::vector<SurfaceCurve> result;
  for (const LatticeCurve& c : curves) result.push_back(c.curve);
  return result;
}

/// On a coarse lattice many segments touch, overlap and end on each other; a fine lattice gives
/// generic positions.
class Meeting : public ::testing::TestWithParam<std::int64_t> {};

TEST_P(Meeting, SegmentsInFacesAsExactly) {
  const SurfaceMesh mesh = SurfaceMesh::open(lattice_grid(2, GetParam()));
  const Lattice lattice(mesh, GetParam());
  std::size_t contacts = 0, stretches = 0, crossing = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    std::vector<LatticeCurve> curves;
    for (std::size_t n = 2 + random.below(6); n > 0; --n) curves.push_back(lattice.segment(random));
    const auto exact = segments_of(curves);
    const auto ours = on_surface(curves);
    const Places expected = exact_contacts(exact);
    ASSERT_EQ(our_contacts(mesh.surface(), ours), expected) << "seed " << seed;
    const auto crossed = exactly_crossing(exact);
    ASSERT_EQ(crossing_curves(mesh.surface(), ours), crossed) << "seed " << seed;
    contacts += expected.count;
    stretches += expected.stretches;
    crossing += crossed.size();
  }
  std::printf("  %zu contacts, %zu of them stretches; %zu curves cross\n", contacts, stretches,
              crossing);
  EXPECT_GT(contacts, 100);
}

TEST_P(Meeting, CurvesOverManyFacesAsExactly) {
  const SurfaceMesh mesh = SurfaceMesh::open(lattice_grid(3, GetParam()));
  const Lattice lattice(mesh, GetParam());
  std::size_t contacts = 0, stretches = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Random random(seed);
    std::vector<LatticeCurve> curves;
    for (std::size_t n = 1 + random.below(3); n > 0; --n) {
      curves.push_back(lattice.wandering(1 + random.below(12), random));
    }
    const auto exact = segments_of(curves);
    const auto ours = on_surface(curves);
    const Places expected = exact_contacts(exact);
    ASSERT_EQ(our_contacts(mesh.surface(), ours), expected) << "seed " << seed;
    ASSERT_EQ(crossing_curves(mesh.surface(), ours), exactly_crossing(exact)) << "seed " << seed;
    contacts += expected.count;
    stretches += expected.stretches;
  }
  std::printf("  %zu contacts, %zu of them stretches\n", contacts, stretches);
  EXPECT_GT(contacts, 100);
}

/// The edges of the chains, by the numbers of their ends.
std::set<std::pair<std::size_t, std::size_t>> edges_of(const std::vector<CutMesh::Chain>& chains) {
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& [closed, vertices] : chains) {
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      edges.insert(std::minmax<std::size_t>(vertices[i], vertices[i + 1]));
    }
  }
  return edges;
}

/// The number of the connected part of each face if some edges separate faces.
template <class IsBetween>
std::vector<std::size_t> parts_between(Soup::Mesh& mesh, const IsBetween& is_between) {
  auto border = mesh.add_property_map<Soup::Mesh::Edge_index, bool>("e:border", false).first;
  for (const auto e : mesh.edges()) border[e] = is_between(mesh.halfedge(e));
  auto part = mesh.add_property_map<Soup::Mesh::Face_index, std::size_t>("f:part").first;
  CGAL::Polygon_mesh_processing::connected_components(
      mesh, part, CGAL::parameters::edge_is_constrained_map(border));
  std::vector<std::size_t> result;
  for (const auto f : mesh.faces()) result.push_back(part[f]);
  return result;
}

/// Whether two numberings describe the same division.
template <class A, class B>
bool same_division(const std::vector<A>& a, const std::vector<B>& b) {
  std::map<A, B> there;
  std::map<B, A> back;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (there.try_emplace(a[i], b[i]).first->second != b[i]) return false;
    if (back.try_emplace(b[i], a[i]).first->second != a[i]) return false;
  }
  return a.size() == b.size();
}

TEST_P(Meeting, CutsAreMeshesOfPositiveTrianglesInAsManyPieces) {
  const MeshLists lists = lattice_grid(3, GetParam());
  const SurfaceMesh mesh = SurfaceMesh::open(lists);
  const Lattice lattice(mesh, GetParam());
  std::size_t faces = 0, pieces = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    std::vector<SurfaceCurve> curves;
    for (std::size_t n = 1 + random.below(3); n > 0; --n) {
      curves.push_back(lattice.wandering(1 + random.below(12), random).curve);
    }
    const CutMesh cut = cut_along(mesh, curves);
    const Soup soup(cut.lists);
    ASSERT_EQ(soup.polygons.size(), cut.lists.triangles.size());
    ASSERT_TRUE(soup.is_mesh());
    Exact::FT area = 0;
    for (const Soup::Polygon& t : soup.polygons) {
      std::array<Exact::Point_2, 3> p;
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] = Exact::Point_2(soup.points[t[k]].x(), soup.points[t[k]].y());
      }
      ASSERT_EQ(CGAL::orientation(p[0], p[1], p[2]), CGAL::LEFT_TURN);
      area += CGAL::area(p[0], p[1], p[2]);
    }
    const double whole = 9 * std::pow(static_cast<double>(GetParam()), 2);
    EXPECT_NEAR(CGAL::to_double(area), whole, 1e-12 * whole);
    auto theirs = soup.mesh();
    const auto on_chain = edges_of(cut.chains);
    const auto part = parts_between(theirs, [&](const auto h) {
      return on_chain.contains(
          std::minmax<std::size_t>(theirs.source(h).idx(), theirs.target(h).idx()));
    });
    const OpenedSeams seams = open_seams(cut.lists, cut.chains);
    EXPECT_TRUE(same_division(seams.piece_of_face, part));
    faces += soup.polygons.size();
    pieces += seams.pieces;
  }
  std::printf("  %zu triangles, %zu pieces\n", faces, pieces);
  EXPECT_GT(pieces, 500);
}

INSTANTIATE_TEST_SUITE_P(Lattice, Meeting, ::testing::Values(8, std::int64_t{1} << 20),
                         [](const auto& one) { return one.param == 8 ? "coarse" : "fine"; });

TEST(FaceTriangulationOracle, TurnsLeftEverywhereAndItsSegmentsDoNotCross) {
  using Kernel = Soup::Kernel;
  using Triangulation = CGAL::Constrained_triangulation_2<
      Kernel, CGAL::Default, CGAL::No_constraint_intersection_requiring_constructions_tag>;
  constexpr std::int64_t kOne = FaceTriangulation::kOne;
  double farthest = 0;
  std::size_t triangles = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    FaceTriangulation ours({{{0, 0}, {1, 0}, {random.uniform(-1, 2), random.scale(1e-3, 1)}}});
    // Points of a coarse lattice, of the finest lattice, or crowded around one lattice point.
    const int kind = static_cast<int>(random.below(3));
    const auto count = static_cast<std::int64_t>(kind == 0 ? 8 : kind == 1 ? kOne : 16);
    const std::int64_t unit = kind == 0 ? kOne / 8 : 1, corner = kind == 2 ? kOne / 3 : 0;
    std::vector<std::uint32_t> points;
    for (std::size_t n = 2 + random.below(12); n > 0; --n) {
      const auto some = [&](std::int64_t most) {
        return static_cast<std::int64_t>(random.below(static_cast<std::size_t>(most) + 1));
      };
      const std::int64_t a = some(count), b = some(count - a);
      const FaceTriangulation::Place place = {corner + a * unit, corner + b * unit,
                                              kOne - 2 * corner - (a + b) * unit};
      points.push_back(ours.insert(place));
    }
    std::vector<std::array<std::uint32_t, 2>> segments;
    for (std::size_t n = 1 + random.below(6); n > 0; --n) {
      const std::uint32_t a = points[random.below(points.size())];
      const std::uint32_t b = points[random.below(points.size())];
      if (a == b) continue;
      ours.connect(a, b);
      segments.push_back({a, b});
    }
    ours.improve();
    // Barycentrics 1 and 2 are the coordinates, with 40 bits, so doubles represent them.
    std::vector<Kernel::Point_2> at;
    Triangulation theirs;
    std::vector<Triangulation::Vertex_handle> handles;
    for (const auto& place : ours.places()) {
      at.emplace_back(static_cast<double>(place[1]), static_cast<double>(place[2]));
      handles.push_back(theirs.insert(at.back()));
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& t : ours.triangles()) {
      ASSERT_EQ(CGAL::orientation(at[t[0]], at[t[1]], at[t[2]]), CGAL::LEFT_TURN);
      for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
    EXPECT_EQ(ours.triangles().size(), theirs.number_of_faces());
    triangles += ours.triangles().size();
    for (std::size_t s = 0; s < segments.size(); ++s) {
      const auto chain = ours.chain(s);
      ASSERT_EQ(chain.front(), segments[s][0]);
      ASSERT_EQ(chain.back(), segments[s][1]);
      const Kernel::Line_2 line(at[chain.front()], at[chain.back()]);
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        EXPECT_TRUE(edges.contains(std::minmax(chain[i], chain[i + 1])));
        EXPECT_NO_THROW(theirs.insert_constraint(handles[chain[i]], handles[chain[i + 1]]));
        farthest = std::max(farthest, CGAL::squared_distance(line, at[chain[i]]));
      }
    }
    EXPECT_EQ(ours.triangles().size(), theirs.number_of_faces());
  }
  std::printf("  %zu triangles; points of segments at most %.2f lattice units beside them\n",
              triangles, std::sqrt(farthest));
  EXPECT_LE(std::sqrt(farthest), 8);
}

TEST(RegionsOracle, PartsOfLabelsAreConnectedComponents) {
  std::size_t parts = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const MeshLists lists = stress::random_mesh(random);
    if (inspect(lists).verdict != MeshVerdict::kUsable) continue;  // a one-sided strip
    const SurfaceMesh mesh = SurfaceMesh::open(lists);
    // The labels are slabs, and single faces with any other label.
    const Point across(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const double width = random.uniform(0.2, 2);
    std::vector<std::int64_t> labels;
    for (const Triangle& t : lists.triangles) {
      const auto slab = std::llround(across.dot(lists.points[t[0]]) / width);
      labels.push_back(random.one_in(10) ? static_cast<std::int64_t>(random.below(3)) : slab % 3);
    }
    if (std::set(labels.begin(), labels.end()).size() < 2) continue;
    const RegionParts ours = parts_of_regions(mesh, labels, label_borders(mesh.surface(), labels));
    auto theirs = Soup(lists).mesh();
    const auto part = parts_between(theirs, [&](const auto h) {
      const auto f = theirs.face(h), g = theirs.face(theirs.opposite(h));
      return theirs.is_border(theirs.edge(h)) || labels[f.idx()] != labels[g.idx()];
    });
    EXPECT_TRUE(same_division(ours.of_element, part));
    parts += ours.parts.size();
  }
  std::printf("  %zu parts\n", parts);
  EXPECT_GT(parts, 1000);
}

}  // namespace
}  // namespace talweg
