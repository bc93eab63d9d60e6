// Curves at a distance along the surface from smoothed curves, made by talweg.offset.
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "HostCalls.hh"
#include "talweg/editing/workplace.hpp"

namespace talweg::openflipper {

struct Offset {
  double distance = 0;  ///< > 0, mesh units
  QString side;         ///< "both", "left" or "right"
};

/// A curve for each component. `say` gets a sentence on each warning. Throws host::Error if no
/// point has this distance.
std::vector<host::Curve> offset_of(const editing::Plugins& plugins,
                                   const editing::MeshArrays& arrays, editing::Defects defects,
                                   const std::vector<host::Curve>& curves, const Offset& offset,
                                   const std::function<void(const QString&)>& say);

/// Adds the curves to the host as objects of no session. Returns their ids.
std::vector<int> add_lines(HostCalls& host, const QString& name, const TriMesh& mesh,
                           const std::vector<host::Curve>& curves);

}  // namespace talweg::openflipper
