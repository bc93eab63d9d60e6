// Labels of vertices after smoothing, and labels that would be lost.
#include "talweg/core/labels/returned_labels.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "core/voronoi_labels.hpp"

namespace talweg {
namespace {

using Labels = std::vector<std::int64_t>;

/// A sheet of 8 x 8 squares: 0 on the left of x = 4.5 and 1 on its right, with islands of one
/// vertex each.
Labels with_islands(std::int64_t on_left, std::int64_t on_right) {
  Labels labels;
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 9; ++x) labels.push_back(x > 4 ? 1 : 0);
  }
  labels[2 * 9 + 2] = on_left;
  labels[6 * 9 + 6] = on_right;
  return labels;
}

TEST(ReturnedLabels, OfAStraightBorderAreThoseThatWereDrawn) {
  const auto mesh = OpenedMesh::open(test::grid(8, 8));
  const Labels drawn = with_islands(0, 1);
  const LabelNetwork network = smooth_labels(mesh, drawn);
  EXPECT_EQ(labels_of_vertices(network, mesh->surface(), drawn), drawn);
}

TEST(ReturnedLabels, OfVerticesThatCoverNoFaceAreGivenBack) {
  const auto mesh = OpenedMesh::open(test::grid(8, 8));
  const Labels drawn = with_islands(7, 9);
  const LabelNetwork network = smooth_labels(mesh, drawn);
  Labels returned = labels_of_vertices(network, mesh->surface(), drawn);
  const auto lost = give_back(drawn, network.face_labels, returned);
  ASSERT_EQ(lost.size(), 2U);
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_EQ(lost[k].label, k == 0 ? 7 : 9);
    EXPECT_EQ(lost[k].elements, 1U);
    EXPECT_FALSE(lost[k].covers_faces);
  }
  EXPECT_EQ(returned, drawn);
  EXPECT_EQ(note_on_lost(lost, false, false, {{9, "motor"}}),
            "Labels 7 (1 vertex) and 9 (motor, 1 vertex) cover no face: their vertices keep them");
  EXPECT_EQ(note_on_lost({lost[0]}, false, true),
            "Label 7 (1 vertex) covers no face: the new labels of faces do not have it");
  const std::vector<LostLabel> many(7, {3, 2, true});
  EXPECT_EQ(
      note_on_lost(many, true, true),
      "Labels 3 (2 faces), 3 (2 faces), 3 (2 faces), 3 (2 faces), 3 (2 faces) and 2 more have "
      "no vertex or no face of their own: their faces keep them");
  // New labels of faces cannot contain the labels of single vertices.
  Labels of_faces = network.face_labels;
  EXPECT_EQ(give_back(drawn, network.face_labels, of_faces).size(), 2U);
  EXPECT_EQ(of_faces, network.face_labels);
}

TEST(ReturnedLabels, OfLabelsOfFacesLieWhereTheRegionsAre) {
  const MeshLists lists = test::hills(40);
  const auto mesh = OpenedMesh::open(lists);
  const Labels drawn = test::voronoi_labels(mesh->mesh(), 12, 3);
  const LabelNetwork network = smooth_labels(mesh, drawn);
  const Labels labels = labels_of_vertices(network, mesh->surface(), drawn);
  ASSERT_EQ(labels.size(), lists.points.size());
  // The label of a vertex is that of a face of the cut mesh around it, and nearly always of all
  // faces around it.
  std::vector<std::set<std::int64_t>> around(labels.size());
  for (std::size_t f = 0; f < network.cut_labels.size(); ++f) {
    for (const std::uint32_t v : network.cut.lists.triangles[f]) {
      if (v < labels.size()) around[v].insert(network.cut_labels[f]);
    }
  }
  std::size_t on_borders = 0;
  for (std::size_t v = 0; v < labels.size(); ++v) {
    EXPECT_TRUE(around[v].contains(labels[v])) << v;
    if (around[v].size() > 1) ++on_borders;
  }
  EXPECT_GT(on_borders, 0U);
  EXPECT_LT(on_borders, labels.size() / 20);
}

TEST(ReturnedLabels, OfVerticesWithoutFacesStay) {
  MeshLists lists = test::grid(8, 8);
  lists.points.emplace_back(20, 20, 0);
  const auto mesh = OpenedMesh::open(lists);
  Labels drawn = with_islands(0, 1);
  drawn.push_back(5);
  const LabelNetwork network = smooth_labels(mesh, drawn);
  Labels returned = labels_of_vertices(network, mesh->surface(), drawn);
  EXPECT_EQ(returned, drawn);
  const auto lost = give_back(drawn, network.face_labels, returned);
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost[0].label, 5);
  EXPECT_EQ(returned, drawn);
}

}  // namespace
}  // namespace talweg
