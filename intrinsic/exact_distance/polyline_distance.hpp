// The distance to polylines along the surface is exact, and known only as far out as somebody asks.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"
#include "talweg/intrinsic/exact_distance/polyline_queue.hpp"
#include "talweg/intrinsic/exact_distance/polyline_window.hpp"
#include "talweg/intrinsic/exact_distance/polyline_window_lists.hpp"
#include "talweg/intrinsic/progress.hpp"
#include "talweg/intrinsic/surface/surface.hpp"
#include "talweg/intrinsic/surface/surface_point.hpp"

namespace talweg {

/// The length of the shortest way along the surface to the nearest of a set of curves. It is exact
/// (up to rounding) on the polyhedral surface and for the curves' straight segments. The method,
/// and alternatives that were tried: docs/distance.md.
///
/// Windows (see EdgeWindow) spread from the curve in the order of their distance; a query lets them
/// spread until its answer is final. Answers do not depend on which queries were made before, not
/// even in the last bit. Memory is allocated once per object; set() and queries cost what they
/// touch.
/// One thread at a time. The surface must outlive the object.
class PolylineDistance {
 public:
  /// O(vertices + edges), memory only.
  explicit PolylineDistance(const Surface& surface);

  /// Sets the curves to measure from. O(points of the curves + what the last ones had touched). A
  /// curve of one point is a point. Throws Error(kBadCurve) naming the curve and the point when a
  /// curve has no points or two neighbours have no common face; then no curves are set.
  void set(std::span<const SurfaceCurve> curves);

  /// Sets the asker that is asked while windows spread; null for none. With an asker, set() and
  /// every query may throw Cancelled. Then set() leaves no curves set, and an interrupted query
  /// leaves the object as if it had not been made. See AskedDuring.
  void ask(Asker* asker) { asker_ = asker; }

  struct Nearest {
    double distance = 0;      ///< mesh units; infinite where no curve can be reached
    std::uint32_t curve = 0;  ///< the curve with the nearest point; the first of several
    double arc_length = 0;    ///< the place on that curve, in [0, its length]
  };
  Nearest at_vertex(VertexId v);
  /// Like at_vertex() where the distance is at most `exact` (mesh units, >= 0). Farther out it is
  /// the shortest way along edges to vertices within that distance, which is longer but needs no
  /// exact distances beyond `exact`.
  Nearest at_vertex_roughly(VertexId v, double exact);
  Nearest at(const SurfacePoint& point);
  /// t in [0, 1] from the tail to the head of halfedge_of(edge).
  Nearest on_edge(EdgeId edge, double t);

  /// The distance inside a face at b (barycentrics, in the order of Surface::corners()) and how it
  /// changes along a direction: one of the plane in which corner 0 of the face is the origin,
  /// corner 1 lies on the positive x axis and corner 2 above it (as in FaceFrame).
  struct FaceValue {
    double value = 0;
    double slope = 0;         ///< of the value along the direction
    std::uint32_t curve = 0;  ///< as in Nearest
    double arc_length = 0;    ///< as in Nearest
    double arc_slope = 0;
  };
  using Barycentric = std::array<double, 3>;
  FaceValue at_face(FaceId face, const Barycentric& b, PlanePoint direction);

  /// The distance if it is less than `limit`, otherwise infinite; computes no distances beyond
  /// `limit`.
  double below(double limit, const SurfacePoint& point);

  /// Computes all distances below `distance`; queries do this by themselves.
  void reach(double distance) {
    while (!is_final(distance)) march();
  }

  /// Mesh units; for a closed curve including its last segment.
  [[nodiscard]] double curve_length(std::size_t curve) const { return pieces_.lengths[curve]; }
  /// Arc length at every point of the curve as it was set, not decreasing.
  [[nodiscard]] std::span<const double> point_arcs(std::size_t curve) const {
    return pieces_.arcs[curve];
  }
  /// All distances below this are already known.
  [[nodiscard]] double front() const { return queue_.front(); }
  /// The number of windows made since set(), which measures the cost.
  [[nodiscard]] std::size_t window_count() const { return windows_.size(); }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  // Distances below this, relative to the edges nearby, are rounding: on the curve they are 0.
  static constexpr double kRounding = 1e-14;
  enum ItemKind : std::uint32_t { kWindowItem, kVertexItem };

  // polyline_sources.cpp
  void forget();
  void send_pieces();
  /// To be called only between two complete steps.
  void tell_work() {
    if (asker_ != nullptr) asker_->did(work_);
    work_ = 0;
  }
  [[nodiscard]] double step_width() const;
  void send_vertex(const PolylinePiece& piece);
  void send_point(const PolylinePiece& piece);
  void send_segment(const PolylinePiece& piece);
  void send(HalfedgeId side, EdgeWindow window);

  // polyline_march.cpp
  void march();
  void fetch_ahead() const;
  struct Beyond {
    HalfedgeId right, left;
    double length = 0, right_length = 0, left_length = 0;
    PlanePoint top;
  };
  [[nodiscard]] Beyond beyond(HalfedgeId into) const;
  static EdgeWindow through_right(const EdgeWindow& window, const Beyond& face);
  static EdgeWindow through_left(const EdgeWindow& window, const Beyond& face);
  void propagate(const EdgeWindow& stored);
  void pass_on(const EdgeWindow& window, int most = 64);
  void insert(const EdgeWindow& window);
  void add(const EdgeWindow& window);
  void spread_from(VertexId v);
  void lower(VertexId v, double distance, std::uint32_t curve, double arc);
  bool bends_at(VertexId v);

  // The best known values, which later windows may still improve.
  static bool is_nearer(const Nearest& a, const Nearest& b) {
    if (a.distance != b.distance) return a.distance < b.distance;
    return a.curve != b.curve ? a.curve < b.curve : a.arc_length < b.arc_length;
  }
  static Nearest farther(const Nearest& from, double way) {
    return {from.distance + way, from.curve, from.arc_length};
  }
  [[nodiscard]] static Nearest along_edge(const Nearest& tail, const Nearest& head, double length,
                                          double x);
  [[nodiscard]] Nearest known_on_edge(EdgeId edge, double x) const;
  /// Stores values in the copy's room, or allocates twice the room that they need.
  template <class Copy, class Value>
  static void store(Copy& copy, std::vector<Value>& all, const std::vector<Value>& values) {
    copy.count = static_cast<std::uint32_t>(values.size());
    if (copy.count > copy.room) {
      copy.room = copy.room == 0 ? copy.count : 2 * copy.count;
      copy.first = static_cast<std::uint32_t>(all.size());
      all.resize(all.size() + copy.room);
    }
    std::copy(values.begin(), values.end(), all.begin() + copy.first);
  }
  // polyline_along_edges.cpp
  struct EdgeWay {
    Nearest nearest;
    VertexId vertex;
  };
  struct Reached {
    VertexId vertex;
    double way = 0;  // along edges
    bool settled = false;
  };
  void reach_along(HalfedgeId spoke, double way);
  Nearest along_edges(VertexId v, double exact);
  // polyline_in_face.cpp
  struct LedIn;  // see below
  struct FaceHit {
    Nearest nearest;
    std::size_t side = 0;  // the side in whose frame the way arrives
    const LedIn* window = nullptr;
    const PolylinePiece* piece = nullptr;  // if both are null: from the corner of that side
  };
  struct FaceCopy;                            // see below
  using Corners = std::array<PlanePoint, 3>;  // one point in the frames of the three sides
  void offer_windows(const FaceCopy& copy, const Corners& at, FaceHit& best) const;
  void offer_pieces(const FaceCopy& copy, PlanePoint at, FaceHit& best) const;
  [[nodiscard]] FaceHit hit_in(const FaceCopy& copy, const Barycentric& b) const;
  void copy_face(FaceId face);
  const FaceCopy& fresh_copy(FaceId face);
  const FaceCopy& final_copy(FaceId face, const Barycentric& b, FaceHit& hit);
  Nearest in_face(FaceId face, const Barycentric& b);
  [[nodiscard]] VertexId vertex_beside(const SurfacePoint& point) const;
  double known_at(const SurfacePoint& point);
  [[nodiscard]] Nearest finish(Nearest nearest) const;
  [[nodiscard]] bool marches_in_vain(VertexId v);
  [[nodiscard]] bool is_final(double distance) const {
    return queue_.empty() || distance + queue_.step() / 64 < queue_.front();
  }

  const Surface* surface_;
  std::vector<std::uint32_t> component_;   // per vertex; made when first needed
  std::vector<std::uint8_t> bends_;        // per vertex: not known yet, no, yes
  std::vector<std::uint32_t> with_curve_;  // components, in order; made when first needed
  std::vector<Nearest> vertex_;

  // Copies of faces for at_face(), with everything that it reads stored side by side: frames,
  // corners and the windows that lead into the face. A face is copied as it is known then; what was
  // final then stays final.
  struct FaceCopy {
    FaceId face;
    std::uint32_t first = 0, count = 0, room = 0;  // in led_in_
    double front = 0;                              // of the queue
    double longest = 0;                            // longest side
    std::span<const PolylinePiece> pieces;
    std::array<SideFrame, 3> frames;
    std::array<Nearest, 3> corners;
  };
  struct LedIn {
    EdgeWindow window;
    double lowest = 0;
    std::uint32_t side = 0;
    bool own = true;  // whether the window's x runs along the side rather than against it
  };
  std::vector<std::uint32_t> face_copy_of_;  // per face, in face_copies_
  std::vector<FaceCopy> face_copies_;
  std::vector<LedIn> led_in_, into_one_face_;

  std::vector<Reached> reached_;  // reached by the last search along edges
  // The search along edges from all exact distances: its limit, queue and settled vertices.
  double edge_ways_from_ = -1;
  std::vector<EdgeWay> edge_ways_;
  std::unordered_map<VertexId, Nearest> by_edges_;

  WindowLists windows_;
  StepQueue queue_;
  PolylinePieces pieces_;
  std::vector<VertexId> touched_vertices_;
  Asker* asker_ = nullptr;
  std::size_t work_ = 0;  // work since the asker was last told
};

/// Sets a distance's asker during a scope.
class AskedDuring {
 public:
  AskedDuring(PolylineDistance& distance, Asker& asker) : distance_(distance) {
    distance_.ask(&asker);
  }
  ~AskedDuring() { distance_.ask(nullptr); }
  AskedDuring(const AskedDuring&) = delete;
  AskedDuring& operator=(const AskedDuring&) = delete;

 private:
  PolylineDistance& distance_;
};

}  // namespace talweg
