// The properties of every smoothed network of borders.
#pragma once

#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/jagged_curves.hpp"
#include "core/label_parts.hpp"
#include "core/mesh_numbers.hpp"
#include "talweg/core/drawing/crossings.hpp"
#include "talweg/core/labels/label_network.hpp"

namespace talweg::test {

/// Expects the properties that hold for all options.
inline void expect_sound(const MeshLists& lists, const OpenedMesh& mesh, const Labels& labels,
                         const LabelNetwork& network) {
  const Surface& surface = mesh.surface();
  std::vector<SurfaceCurve> curves, drawn;
  for (const SmoothedBorder& border : network.borders) curves.push_back(border.border.curve);
  for (const LabelBorder& border : label_borders(surface, labels)) drawn.push_back(border.curve);
  ASSERT_EQ(curves.size(), drawn.size());
  EXPECT_TRUE(crossing_curves(surface, curves).empty());
  // Borders that met still meet; at the same point if no node was moved.
  std::vector<std::pair<SurfacePoint, SurfacePoint>> nodes;
  const auto expect_same_node = [&](const SurfacePoint& before, const SurfacePoint& now) {
    if (network.moved == 0) {
      EXPECT_TRUE(now == before);
    }
    for (const auto& [home, at] : nodes) {
      if (home == before) {
        EXPECT_TRUE(at == now);
        return;
      }
    }
    nodes.emplace_back(before, now);
  };
  for (std::size_t c = 0; c < curves.size(); ++c) {
    EXPECT_EQ(curves[c].closed, drawn[c].closed);
    if (drawn[c].closed) continue;
    expect_same_node(drawn[c].points.front(), curves[c].points.front());
    expect_same_node(drawn[c].points.back(), curves[c].points.back());
  }
  const bool by_face = labels.size() == surface.face_count();
  const auto before = by_face ? parts(lists, labels) : parts_of_vertices(surface, labels);
  EXPECT_EQ(parts(network.cut.lists, network.cut_labels), before);
  if (by_face) {
    EXPECT_EQ(degrees(network.cut.lists, network.cut_labels), degrees(lists, labels));
  }
  ASSERT_EQ(network.regions.size(), before.size());
  double area_before = 0, area_after = 0;
  for (const LabelRegion& region : network.regions) {
    EXPECT_EQ(region.parts_before, before.at(region.label));
    EXPECT_EQ(region.parts_after, region.parts_before) << region.label;
    EXPECT_GT(region.area_after, 0) << region.label;
    area_before += region.area_before;
    area_after += region.area_after;
  }
  EXPECT_NEAR(area_before, area(lists), 1e-9 * area(lists));
  EXPECT_NEAR(area_after, area(lists), 1e-9 * area(lists));
  EXPECT_NO_THROW(SurfaceMesh::open(network.cut.lists));
}

/// Expects borders within the bound. The meter is exact up to 1e-3 of the distance or of a mean
/// edge.
inline void expect_within(const OpenedMesh& mesh, const Labels& labels, const LabelNetwork& network,
                          double bound) {
  const auto drawn = label_borders(mesh.surface(), labels);
  for (std::size_t c = 0; c < drawn.size(); ++c) {
    EXPECT_LE(test::apart(mesh.mesh(), network.borders[c].border.curve, drawn[c].curve),
              bound * (1 + 2e-3) + 2e-3 * mesh.mesh().mean_edge_length());
  }
}

}  // namespace talweg::test
