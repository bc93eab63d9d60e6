#include "Colours.hh"

#include "HostMesh.hh"
#include "Report.hh"

namespace talweg::openflipper {

void Colours::choose(ColourBy by) {
  const bool were_on_mesh = on_mesh();
  by_ = by;
  if (were_on_mesh && !on_mesh()) {
    mesh_.setObjectDrawMode(ACG::SceneGraph::DrawModes::SOLID_SMOOTH_SHADED);
    host_.show_colours(mesh_.id());
  }
  lines_.show_deviations(by == ColourBy::kDeviation);
}

void Colours::show(const host::Results& results) {
  const char* wanted = by_ == ColourBy::kPotential ? "potential" : "distance";
  for (const host::Field& field : results.fields) {
    if (field.name != wanted) continue;
    largest_ = largest_of(field.values);
    colour(*mesh_.mesh(), field.values);
    mesh_.setObjectDrawMode(ACG::SceneGraph::DrawModes::SOLID_POINTS_COLORED_SHADED);
    host_.show_colours(mesh_.id());
  }
}

Colours::Scale Colours::scale() const {
  if (by_ == ColourBy::kNothing) return {};
  return {on_mesh() ? largest_ : lines_.largest_deviation(), length_unit()};
}

}  // namespace talweg::openflipper
