// A given plan is a cut plan as hosts get it (talweg_cut_plan.h).
#pragma once

#include "host_mesh.hpp"
#include "talweg/core/cutting/cut_plan.hpp"
#include "talweg/plugin/talweg_plugin.hpp"

namespace talweg::plugins {

/// Throws plugin::Failure(TALWEG_UNSUPPORTED) if the mesh was repaired: the plan is then not one
/// for the mesh that came in.
void give(const plugin::TakeCutPlan& take, const CutPlan& plan, const HostMesh& mesh);

}  // namespace talweg::plugins
