#include "talweg/intrinsic/exact_distance/known_faces.hpp"

#include <algorithm>

namespace talweg {

KnownFaces::KnownFaces(const Surface& surface)
    : surface_(&surface), copy_of_(surface.face_count(), kNone) {}

void KnownFaces::clear() {
  for (const Copy& copy : copies_) copy_of_[copy.face.index()] = kNone;
  copies_.clear();
  entering_.clear();
}

void KnownFaces::copy(FaceId face, const WindowFront& front, const PolylinePieces& pieces) {
  std::uint32_t& id = copy_of_[face.index()];
  if (id == kNone) {
    id = static_cast<std::uint32_t>(copies_.size());
    copies_.emplace_back().face = face;
  }
  Copy& copy = copies_[id];
  copy.front = front.distance();
  copy.paths.segments = pieces.segments_in(face);
  into_one_face_.clear();
  HalfedgeId h = surface_->halfedge(face);
  for (std::uint32_t k = 0; k < 3; ++k, h = surface_->next(h)) {
    copy.paths.frames[k] = side_frame(*surface_, face, k);
    copy.paths.corners[k] = front.vertices()[surface_->tail(h)];
    copy.paths.longest = std::max(copy.paths.longest, copy.paths.frames[k].length);
    const EdgeId edge = edge_of(h);
    front.windows().each(edge, [&](const EdgeWindow& w) {
      if (w.into == h) into_one_face_.push_back({w, w.lowest(), k, h == halfedge_of(edge)});
    });
  }
  store_windows(copy);
}

/// Stores the windows in the memory of the copy; allocates twice the needed memory if it is too
/// small.
void KnownFaces::store_windows(Copy& copy) {
  copy.count = static_cast<std::uint32_t>(into_one_face_.size());
  if (copy.count > copy.room) {
    copy.room = copy.room == 0 ? copy.count : 2 * copy.count;
    copy.first = static_cast<std::uint32_t>(entering_.size());
    entering_.resize(entering_.size() + copy.room);
  }
  std::copy(into_one_face_.begin(), into_one_face_.end(), entering_.begin() + copy.first);
}

}  // namespace talweg
