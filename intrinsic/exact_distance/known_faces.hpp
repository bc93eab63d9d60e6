// Known faces cache the windows and corner distances of faces, for queries inside the faces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "talweg/intrinsic/exact_distance/face_paths.hpp"
#include "talweg/intrinsic/exact_distance/polyline_pieces.hpp"
#include "talweg/intrinsic/exact_distance/window_front.hpp"
#include "talweg/intrinsic/surface/surface.hpp"

namespace talweg {

/// A copy holds the front's data about a face at the time of the copy. Values that were final then
/// stay final, so most queries need not read the front. 4 bytes per face. The surface must outlive
/// the object.
class KnownFaces {
 public:
  explicit KnownFaces(const Surface& surface);

  /// Must be called when the front gets new curves. O(copies).
  void clear();

  struct Known {
    FacePaths paths;
    double front = 0;  ///< the front's distance when the face was copied
  };
  [[nodiscard]] bool contain(FaceId face) const { return copy_of_[face.index()] != kNone; }
  /// The last copy of the face, which must exist. Valid until any face is copied.
  const Known& at(FaceId face) {
    Copy& copy = copies_[copy_of_[face.index()]];
    copy.paths.windows = {entering_.data() + copy.first, copy.count};
    return copy;
  }
  /// Copies the front's current data about the face.
  void copy(FaceId face, const WindowFront& front, const PolylinePieces& pieces);

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  struct Copy : Known {
    FaceId face;
    std::uint32_t first = 0, count = 0, room = 0;  // in entering_
  };
  void store_windows(Copy& copy);

  const Surface* surface_;
  std::vector<std::uint32_t> copy_of_;  // per face, in copies_
  std::vector<Copy> copies_;
  std::vector<EnteringWindow> entering_, into_one_face_;
};

}  // namespace talweg
