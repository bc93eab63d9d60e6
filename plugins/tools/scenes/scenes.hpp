// Generates realistic meshes with a jagged curve on each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "talweg/core/mesh/mesh_lists.hpp"
#include "tools/scenes/waypoints.hpp"

namespace talweg::scenes {

struct DemoScene {
  std::string name;
  MeshLists mesh;  ///< manifold, consistently oriented, one component, no unused vertex
  Waypoints through;
};

/// A blood vessel with a bifurcation and an aneurysm, as from a segmentation, open where it leaves
/// the scanned volume; the curve goes around the aneurysm's neck. About 60,000 faces.
DemoScene vessel_scene();
/// A closed, bumpy clay figure with limbs; the curve runs across the bumps like a sash. About
/// 80,000 faces.
DemoScene figure_scene();
/// An open terrain, irregularly triangulated; the curve is a border along a river. About 60,000
/// faces.
DemoScene terrain_scene();

/// All demo scenes, in this order, with the same bytes on every run.
std::vector<DemoScene> demo_scenes();

/// The lower end of a thigh bone; the curve is a resection line drawn around it by hand. About
/// 82,000 faces.
DemoScene bone_scene();
/// A folded surface like a brain, without a curve. About 43,000 faces.
DemoScene cortex_scene();
/// A label for each face of the cortex, from 1: regions as from a segmentation, whose borders are
/// jagged along edges.
std::vector<int> cortex_parcels(const MeshLists& cortex);

/// The scenes of ./run gallery: vessel, bone, cortex, and the terrain with a border that runs from
/// one side to the other.
std::vector<DemoScene> gallery_scenes();

}  // namespace talweg::scenes
