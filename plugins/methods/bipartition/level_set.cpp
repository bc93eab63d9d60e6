#include "level_set.hpp"

#include <algorithm>
#include <cstddef>

namespace talweg::plugins {
namespace {

constexpr double kMargin = 1e-6;  // as a fraction of an edge's length

class ZeroSet {
 public:
  ZeroSet(const Surface& surface, const std::vector<double>& value, const std::vector<char>& known)
      : surface_(surface), value_(value), known_(known), passed_(surface.edge_count(), 0) {}

  std::vector<SurfaceCurve> curves();

 private:
  [[nodiscard]] bool is_positive(VertexId v) const { return value_[v.index()] >= 0; }
  /// Whether the curve enters the face of h: the function goes from positive to negative along h.
  [[nodiscard]] bool enters(HalfedgeId h) const {
    return known_[surface_.tail(h).index()] != 0 && is_positive(surface_.tail(h)) &&
           !is_positive(surface_.head(h));
  }
  [[nodiscard]] SurfacePoint crossing(EdgeId e) const;
  SurfaceCurve follow(HalfedgeId into);

  const Surface& surface_;
  const std::vector<double>& value_;
  const std::vector<char>& known_;
  std::vector<char> passed_;  // per edge
};

SurfacePoint ZeroSet::crossing(EdgeId e) const {
  const double from = value_[surface_.tail(halfedge_of(e)).index()];
  const double to = value_[surface_.head(halfedge_of(e)).index()];
  return SurfacePoint::on_edge(surface_, e, std::clamp(from / (from - to), kMargin, 1 - kMargin));
}

SurfaceCurve ZeroSet::follow(HalfedgeId into) {
  SurfaceCurve curve;
  for (HalfedgeId h = into;;) {
    passed_[edge_of(h).index()] = 1;
    curve.points.push_back(crossing(edge_of(h)));
    if (!surface_.has_face(h)) return curve;
    const HalfedgeId next = surface_.next(h), last = surface_.next(next);
    h = twin(enters(twin(next)) ? next : last);
    if (h != into) continue;
    curve.closed = true;
    return curve;
  }
}

std::vector<SurfaceCurve> ZeroSet::curves() {
  std::vector<SurfaceCurve> result;
  for (const bool at_boundary : {true, false}) {
    for (std::size_t i = 0; i < surface_.halfedge_count(); ++i) {
      const HalfedgeId h{i};
      const bool begins = at_boundary ? !surface_.has_face(twin(h)) : true;
      if (!begins || !surface_.has_face(h) || passed_[i / 2] != 0 || !enters(h)) continue;
      result.push_back(follow(h));
    }
  }
  return result;
}

}  // namespace

std::vector<SurfaceCurve> zero_set(const Surface& surface, const std::vector<double>& value,
                                   const std::vector<char>& known) {
  return ZeroSet(surface, value, known).curves();
}

}  // namespace talweg::plugins
