// How curves are looked at: combs of curvature, and the place where something is largest.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>

#include "CurveColours.hh"
#include "Session.hh"
#include "talweg/editing/comb.hpp"

namespace talweg::openflipper {
namespace {

using editing::Tooth;
using editing::Vector;

ACG::Vec3d place(const Vector& v) { return {v[0], v[1], v[2]}; }

/// The teeth and the line along their tips. `size`: of a tooth whose curvature is 1.
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

}  // namespace

bool Session::wants_fields() const {
  return colour_by_ == ColourBy::kDeviation || with_comb_ || mark_ == Mark::kCurvature;
}

void Session::ask_again() {
  asked_ = {};
  ask();
}

void Session::show_comb(bool with) {
  if (std::exchange(with_comb_, with) == with) return;
  if (with) {
    ask_again();
  } else {
    show_combs();
  }
  host_.changed();
}

/// Measured at places of which there are as many on every curve of that length, on any mesh.
void Session::measure_combs() {
  const double spacing = diagonal_ / 150;
  combs_.clear();
  most_curved_ = {};
  for (const host::Curve& curve : results_.curves) {
    if (!with_comb_ && mark_ != Mark::kCurvature) break;
    const bool known = std::any_of(curve.fields.begin(), curve.fields.end(),
                                   [](const host::Field& f) { return f.name == "curvature"; });
    if (!known) break;  // it was asked before
    combs_.push_back(editing::comb_of(*arrays_, curve, spacing));
    for (const Tooth& tooth : combs_.back()) {
      if (tooth.curvature > most_curved_.curvature) most_curved_ = tooth;
    }
  }
}

void Session::show_combs() {
  if (!nodes_) return;
  std::vector<LineLook> looks;
  const double size = most_curved_.curvature > 0 ? diagonal_ / 15 / most_curved_.curvature : 0;
  for (std::size_t c = 0; with_comb_ && c < combs_.size(); ++c) {
    const std::uint32_t number = lines_.at(c).number;
    add_looks(combs_[c], results_.curves[c].closed, size, colour_of_curve(number), looks);
  }
  nodes_->show_comb(looks);
}

void Session::mark_largest(Mark mark) {
  mark_ = mark;
  turn_to_mark_ = mark != Mark::kNothing;
  if (mark == Mark::kCurvature && combs_.empty()) {
    ask_again();
  } else {
    find_mark();
  }
  host_.changed();
}

std::optional<ACG::Vec3d> Session::place_of_largest() const {
  if (mark_ == Mark::kCurvature && most_curved_.curvature > 0) return place(most_curved_.root);
  if (mark_ != Mark::kDeviation) return std::nullopt;
  const host::ReportEntry* at = results_.find("deviation_at");
  if (at == nullptr || at->numbers.size() < 3 || results_.text("deviation") == "none") {
    return std::nullopt;
  }
  return ACG::Vec3d(at->numbers[0], at->numbers[1], at->numbers[2]);
}

/// The point of the results next to the place says on which curve it is, and where the mesh faces.
void Session::find_mark() {
  marked_ = {};
  if (const auto at = place_of_largest()) {
    marked_.at = at;
    double least = std::numeric_limits<double>::infinity();
    std::uint32_t face = 0;
    for (std::size_t c = 0; c < std::min(results_.curves.size(), lines_.size()); ++c) {
      const host::Curve& curve = results_.curves[c];
      for (std::size_t k = 0; k < curve.positions.size(); ++k) {
        const double away = (place(curve.positions[k]) - *at).sqrnorm();
        if (away >= least) continue;
        least = away;
        face = curve.faces[k];
        marked_.curve = lines_[c].number;
      }
    }
    marked_.value = mark_ == Mark::kCurvature ? most_curved_.curvature
                                              : results_.number("deviation_to_drawn_max");
    if (turn_to_mark_) host_.look_at(*at, normal_at(face));
  }
  turn_to_mark_ = turn_to_mark_ && !marked_.at && smooths();
  if (nodes_) nodes_->show_mark(marked_.at);
}

ACG::Vec3d Session::normal_at(std::uint32_t face) const {
  const auto& corners = arrays_->triangles.at(face);
  const ACG::Vec3d a = place(arrays_->positions[corners[0]]);
  const ACG::Vec3d across =
      (place(arrays_->positions[corners[1]]) - a) % (place(arrays_->positions[corners[2]]) - a);
  const double size = across.norm();
  return size > 0 ? across / size : ACG::Vec3d(0, 0, 1);
}

Session::Scale Session::scale() const {
  switch (colour_by_) {
    case ColourBy::kNothing:
      return {};
    case ColourBy::kDeviation:
      return {line_largest_, length_unit()};
    case ColourBy::kDistance:
    case ColourBy::kPotential:
      return {mesh_largest_, length_unit()};
  }
  return {};
}

}  // namespace talweg::openflipper
