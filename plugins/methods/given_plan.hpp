// A given plan is a cut plan in the form for hosts (talweg_cut_plan.h).
#pragma once

#include "host_mesh.hpp"
#include "talweg/core/cutting/cut_plan.hpp"
#include "talweg/plugin/talweg_plugin.hpp"

namespace talweg::plugins {

/// Throws plugin::Failure(TALWEG_UNSUPPORTED) if the mesh was repaired, because the plan does not
/// fit the host's mesh then.
void give(const plugin::TakeCutPlan& take, const CutPlan& plan, const HostMesh& mesh);

}  // namespace talweg::plugins
