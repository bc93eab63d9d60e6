// A face level is the part of a level set of the distance that lies in one face.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talweg/intrinsic/exact_distance/face_paths.hpp"

namespace talweg {

/// Which level set, and how exactly its arcs are drawn. Mesh units.
struct LevelChoice {
  double level = 0;      ///< > 0: the distance of its points
  double tolerance = 0;  ///< > 0: how far the distance may be from that between two points
};

/// What is known of the three sides of a face: side k runs from corner k to the next.
struct FaceRim {
  std::array<bool, 3> near{};                    ///< corners that are not farther than the level
  std::array<std::vector<double>, 3> crossings;  ///< of each side: parts in [0, 1], in order
};

/// A level set in a face: nodes, first those of the rim in its order, and the chords between them.
/// Every chord has what is nearer on its left; a node of the rim is an end of one chord, any other
/// of two.
struct FaceLevel {
  std::vector<std::array<double, 3>> nodes;  ///< barycentrics
  struct Chord {
    std::uint32_t from = 0, to = 0;  ///< numbers of nodes
  };
  std::vector<Chord> chords;
};

/// Finds the level set in a face by halving the face until each part of it is simple: the chords
/// between the crossings of its sides are within the tolerance, and nothing lies between them. No
/// way to a curve is shorter than the shortest, and each has a convex length, so that crossings of
/// lines are found exactly. Holes and gaps narrower than half the tolerance may be missed.
/// O(ways into the face) for each part.
FaceLevel level_in_face(const FacePaths& paths, const FaceRim& rim, const LevelChoice& choice);

}  // namespace talweg
