// A face level is the part of a level set of the distance that lies in one face.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/intrinsic/exact_distance/face_paths.hpp"

namespace talweg {

/// A level set and the accuracy of its polylines. Mesh units.
struct LevelChoice {
  double level = 0;      ///< > 0: the distance of the points of the level set
  double tolerance = 0;  ///< > 0: largest error of the distance between two nodes
};

/// The crossings of the level set with the three sides of a face. Side k runs from corner k to
/// corner k + 1.
struct FaceRim {
  std::array<bool, 3> near{};  ///< whether the distance of a corner is at most the level
  std::array<std::vector<double>, 3> crossings;  ///< per side: fractions in [0, 1], in order
};

/// A level set in a face: nodes and the chords between them. The nodes of the rim come first, in
/// the order of the rim. The nearer side of a chord is on its left. A node of the rim is an end of
/// one chord, any other node of two.
struct FaceLevel {
  std::vector<std::array<double, 3>> nodes;  ///< barycentrics
  struct Chord {
    std::uint32_t from = 0, to = 0;  ///< numbers of nodes
  };
  std::vector<Chord> chords;
};

/// Finds the level set in a face by halving the face until each part is simple: the chords between
/// the crossings of its sides are within the tolerance, and no other component of the level set
/// lies in the part. The distance is the least length of a way, and the length of a way is convex,
/// so crossings of lines are found exactly. Holes and gaps narrower than half the tolerance may be
/// missed. O(paths into the face) for each part.
FaceLevel level_in_face(const FacePaths& paths, const FaceRim& rim, const LevelChoice& choice);

}  // namespace talweg
