#include "Inspection.hh"

#include <algorithm>
#include <limits>
#include <utility>

#include "CurveColours.hh"

namespace talweg::openflipper {
namespace {

using editing::Tooth;
using editing::Vector;

ACG::Vec3d place(const Vector& v) { return {v[0], v[1], v[2]}; }

/// The teeth of a comb, and the line along their tips. `size` is the length of a tooth with
/// curvature 1.
void add_looks(const std::vector<Tooth>& teeth, bool closed, double size, const ACG::Vec4f& colour,
               std::vector<LineLook>& looks) {
  LineLook tips{{}, closed, colour};
  for (const Tooth& tooth : teeth) {
    const Vector tip = editing::plus(tooth.root, editing::times(size * tooth.curvature, tooth.out));
    looks.push_back({{place(tooth.root), place(tip)}, false, colour});
    tips.points.push_back(place(tip));
  }
  looks.push_back(std::move(tips));
}

ACG::Vec3d normal_at(const editing::MeshArrays& mesh, std::uint32_t face) {
  const auto& corners = mesh.triangles.at(face);
  const ACG::Vec3d a = place(mesh.positions[corners[0]]);
  const ACG::Vec3d across =
      (place(mesh.positions[corners[1]]) - a) % (place(mesh.positions[corners[2]]) - a);
  const double size = across.norm();
  return size > 0 ? across / size : ACG::Vec3d(0, 0, 1);
}

}  // namespace

void Inspection::show(const Inspected& now) {
  measure(now);
  draw_combs();
  find_mark(now);
}

/// Measures curvature at equal steps along the curves, so that the number of places depends neither
/// on the mesh nor on the points of the result.
void Inspection::measure(const Inspected& now) {
  const double spacing = size_ / 150;
  combs_.clear();
  most_curved_ = {};
  if (!wants_fields()) return;
  for (std::size_t c = 0; c < now.results.curves.size(); ++c) {
    const host::Curve& curve = now.results.curves[c];
    const bool known = std::any_of(curve.fields.begin(), curve.fields.end(),
                                   [](const host::Field& f) { return f.name == "curvature"; });
    if (!known) break;  // the fields were not requested
    combs_.push_back({editing::comb_of(now.mesh, curve, spacing), curve.closed, now.numbers.at(c)});
    for (const Tooth& tooth : combs_.back().teeth) {
      if (tooth.curvature > most_curved_.curvature) most_curved_ = tooth;
    }
  }
}

void Inspection::show_combs(bool with) {
  with_combs_ = with;
  draw_combs();
}

void Inspection::draw_combs() {
  if (nodes_ == nullptr) return;
  std::vector<LineLook> looks;
  const double size = most_curved_.curvature > 0 ? size_ / 15 / most_curved_.curvature : 0;
  for (const Comb& comb : combs_) {
    if (!with_combs_) break;
    add_looks(comb.teeth, comb.closed, size, colour_of_curve(comb.number), looks);
  }
  nodes_->show_comb(looks);
}

void Inspection::set_mark(Mark mark) {
  mark_ = mark;
  turns_ = mark != Mark::kNothing;
}

std::optional<ACG::Vec3d> Inspection::place_of_largest(const host::Results& results) const {
  if (mark_ == Mark::kCurvature && most_curved_.curvature > 0) return place(most_curved_.root);
  if (mark_ != Mark::kDeviation) return std::nullopt;
  const host::ReportEntry* at = results.find("farthest_at");
  if (at == nullptr || at->numbers.size() < 3 || results.text("farthest_of") == "none") {
    return std::nullopt;
  }
  return ACG::Vec3d(at->numbers[0], at->numbers[1], at->numbers[2]);
}

/// Finds the result's point nearest to the marked place, which gives the curve and the normal of
/// the mesh.
void Inspection::find_mark(const Inspected& now) {
  marked_ = {};
  if (const auto at = place_of_largest(now.results)) {
    marked_.at = at;
    double least = std::numeric_limits<double>::infinity();
    std::uint32_t face = 0;
    for (std::size_t c = 0; c < now.results.curves.size(); ++c) {
      const host::Curve& curve = now.results.curves[c];
      for (std::size_t k = 0; k < curve.positions.size(); ++k) {
        const double away = (place(curve.positions[k]) - *at).sqrnorm();
        if (away >= least) continue;
        least = away;
        face = curve.faces[k];
        marked_.curve = now.numbers.at(c);
      }
    }
    marked_.value =
        mark_ == Mark::kCurvature ? most_curved_.curvature : now.results.number("farthest");
    if (turns_) host_.look_at(*at, normal_at(now.mesh, face));
  }
  turns_ = turns_ && !marked_.at && now.newer_come;
  if (nodes_ != nullptr) nodes_->show_mark(marked_.at);
}

}  // namespace talweg::openflipper
