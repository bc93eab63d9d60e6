// A hand draws strokes on any mesh, as tablets, mice and trackers give them.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg::scenes {

/// How a hand moves. Lengths in edges of the mesh, as long as they are where it begins.
struct Hand {
  double length = 60;      ///< of its way
  double bend = 0.06;      ///< radians per edge at most: how strongly the way bends
  double amplitude = 0.6;  ///< of its trembling, across the way
  double wave = 2.5;       ///< wave lengths are between once and twice this
  double radius = 0;       ///< above 0: the way is a circle about a point, of this radius
  double over = 0;  ///< of a circle: how far the end runs over the beginning; may be negative
};

/// How a device samples it. Lengths in edges.
struct Sampling {
  double step = 0.1;       ///< distance of samples along the way
  double uneven = 1;       ///< steps vary between step / uneven and step · uneven
  double jitter = 0;       ///< of each coordinate of each sample, normally distributed
  double off = 0;          ///< distance of a tracker from the surface, changing slowly up to this
  std::size_t rests = 0;   ///< places at which 60 samples are taken within 0.004
  std::size_t spikes = 0;  ///< samples that lie 12 away
  double hook = 0;         ///< the end goes back beside itself so far
  bool doubled = false;    ///< every sample is given twice
};

/// A way on a mesh, and what a hand and a device make of it. The same seed is the same hand.
class HandStroke {
 public:
  /// Begins at a random place from which there is a way of that length; `is_drawn()` says whether
  /// one was found.
  HandStroke(const SurfaceMesh& mesh, const Hand& hand, std::uint64_t seed);

  [[nodiscard]] bool is_drawn() const { return !way_.empty(); }
  /// The way that was meant: positions a tenth of an edge apart.
  [[nodiscard]] const std::vector<Point>& way() const { return way_; }
  /// The edge that all lengths are measured in, mesh units.
  [[nodiscard]] double edge() const { return edge_; }
  /// Positions in space.
  [[nodiscard]] std::vector<Point> sampled(const Sampling& sampling) const;

 private:
  bool walk(const SurfaceMesh& mesh, FaceId face, double heading);
  bool go_round(const SurfaceMesh& mesh, FaceId face, double heading);
  void tremble();
  [[nodiscard]] Point at(double along) const;

  Hand hand_;
  std::uint64_t seed_;
  double edge_ = 0;
  std::vector<Point> way_, side_, normal_, drawn_;
};

}  // namespace talweg::scenes
