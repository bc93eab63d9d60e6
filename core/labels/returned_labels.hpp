// Returned labels are those of a mesh's vertices or faces after the borders were smoothed.
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

/// For each vertex of the mesh, the label of the region that it lies in. A vertex on a border has
/// the label with the largest angle there, but keeps its own if that is one of these; the smallest
/// one of equals. `drawn` are the labels that were smoothed, one per face or per vertex. Vertices
/// without faces keep their own label; 0 if the labels are of faces. O(faces).
std::vector<std::int64_t> labels_of_vertices(const LabelNetwork& network, const Surface& surface,
                                             std::span<const std::int64_t> drawn);

/// A label that smoothing would have lost.
struct LostLabel {
  std::int64_t label = 0;
  std::size_t elements = 0;   ///< vertices or faces that it had
  bool covers_faces = false;  ///< whether the larger share of some face is its
};

/// The labels (ascending) that are among `drawn` but not among `returned` or, with
/// `face_labels`, of no face. If as many were drawn as are returned, their elements get them back.
/// O(labels · log).
std::vector<LostLabel> give_back(std::span<const std::int64_t> drawn,
                                 std::span<const std::int64_t> face_labels,
                                 std::vector<std::int64_t>& returned);

/// A sentence on labels that would be lost, without its period: "Label 7 (1 vertex) covers no face:
/// its vertices keep it". `by_face`: whether the labels that came in are of faces; `of_faces`:
/// whether the new ones are. The first five are named. O(labels).
std::string told_of(const std::vector<LostLabel>& lost, bool by_face, bool of_faces,
                    const LabelNames& names = {});

}  // namespace talweg
