// Returned labels are the labels of a mesh's vertices or faces after smoothing of the borders.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/labels/label_network.hpp"
#include "talweg/core/labels/label_report.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// Per vertex of the mesh, the label of the region around it. A vertex on a border keeps its drawn
/// label if this label is beside the border there; otherwise it gets the label with the largest
/// angle, of equal angles the smallest label. `drawn` are the labels before smoothing, one per face
/// or per vertex. A vertex without faces keeps its label, or gets 0 if the labels are of faces.
/// O(faces).
std::vector<std::int64_t> labels_of_vertices(const LabelNetwork& network, const Surface& surface,
                                             std::span<const std::int64_t> drawn);

/// A label that smoothing would have lost.
struct LostLabel {
  std::int64_t label = 0;
  std::size_t elements = 0;   ///< its number of vertices or faces in the drawing
  bool covers_faces = false;  ///< whether it has the largest share of some face
};

/// The labels (ascending) of `drawn` that are missing in `returned` or in `face_labels`. If `drawn`
/// and `returned` have equal sizes, the elements of these labels get them back in `returned`. O(n
/// log n) for n labels.
std::vector<LostLabel> give_back(std::span<const std::int64_t> drawn,
                                 std::span<const std::int64_t> face_labels,
                                 std::vector<std::int64_t>& returned);

/// A sentence about lost labels, without a period: "Label 7 (1 vertex) covers no face: its vertices
/// keep it". `by_face`: whether the given labels are of faces; `of_faces`: whether the new labels
/// are of faces. The first five labels are named. O(labels).
std::string note_on_lost(const std::vector<LostLabel>& lost, bool by_face, bool of_faces,
                         const LabelNames& names = {});

}  // namespace talweg
