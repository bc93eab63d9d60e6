#include "workspace.hpp"

#include <algorithm>
#include <utility>

#include "talweg/core/version.hpp"

namespace talweg::plugins {
namespace {

bool same(const std::vector<SurfaceCurve>& a, const std::vector<SurfaceCurve>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const SurfaceCurve& p, const SurfaceCurve& q) {
                      return p.closed == q.closed && p.points == q.points;
                    });
}

}  // namespace

talweg_plugin about_curves(const char* id, const char* label, const char* doc) {
  talweg_plugin about = {};
  about.flags = TALWEG_TAKES_CURVES;
  about.id = id;
  about.label = label;
  about.version = version();
  about.doc = doc;
  return about;
}

void Workspace::set_curves(std::span<const talweg_curve* const> curves) {
  std::vector<CurveInput> inputs;
  for (const talweg_curve* curve : curves) inputs.push_back(input_of(*curve));
  put(from_host(inputs));
  curves_ = std::move(inputs);
}

void Workspace::put(const std::vector<CurveInput>& curves) {
  SnappedDrawing drawing = drawing_of(host_mesh(), lines(), curves);
  if (!same(drawing.curves, snapped_.curves)) ++drawings_;
  snapped_ = std::move(drawing);
  drawing_ = snapped_;
}

void Workspace::finish_ends(CurveEnds ends, std::optional<ExtendedCurves> extended) {
  if (ends != ends_ || extended != extended_) ++drawings_;
  ends_ = ends;
  extended_ = extended;
  drawing_ = with_loops_closed(mesh(), snapped_, lines(), ends);
  if (extended) drawing_ = with_ends_at_border(mesh(), std::move(drawing_), lines(), *extended);
}

void Workspace::put_again() {
  if (!curves_.empty()) put(from_host(curves_));
}

std::vector<CurveInput> Workspace::from_host(const std::vector<CurveInput>& curves) const {
  std::vector<CurveInput> result;
  result.reserve(curves.size());
  for (const CurveInput& curve : curves) result.push_back(host_mesh().from_host(curve));
  return result;
}

void Workspace::forget() {
  lines_.reset();  // the lines refer to the mesh
  snapped_ = {};
  drawing_ = {};
  ++drawings_;
}

StraightLines& Workspace::lines() {
  if (!lines_) lines_.emplace(mesh().surface());
  return *lines_;
}

std::vector<std::string> Workspace::reading_warnings() const {
  std::vector<std::string> warnings = drawing_.warnings();
  const std::vector<std::string>& changes = host_mesh().changes();
  warnings.insert(warnings.end(), changes.begin(), changes.end());
  return warnings;
}

}  // namespace talweg::plugins
