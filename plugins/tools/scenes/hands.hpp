// Strokes of a hand on any mesh, as tablets, mice and trackers sample them.
#pragma once

#include <cstdint>
#include <vector>

#include "talweg/core/mesh/surface_mesh.hpp"

namespace talweg::scenes {

/// A hand's movement. Lengths in edges of the mesh, measured at the beginning of the path.
struct Hand {
  double length = 60;      ///< of the path
  double bend = 0.06;      ///< radians per edge: the largest bend of the path
  double amplitude = 0.6;  ///< of the tremor, across the path
  double wave = 2.5;       ///< wave lengths are between once and twice this
  double radius = 0;       ///< above 0: the path is a circle of this radius about a point
  double over = 0;  ///< of a circle: the overlap of its end with its beginning; may be negative
};

/// A device's sampling of the path. Lengths in edges.
struct Sampling {
  double step = 0.1;       ///< distance of samples along the path
  double uneven = 1;       ///< steps vary between step / uneven and step · uneven
  double jitter = 0;       ///< of each coordinate of each sample, normally distributed
  double off = 0;          ///< largest distance of a tracker from the surface, changing slowly
  std::size_t rests = 0;   ///< places at which 60 samples are taken within 0.004
  std::size_t spikes = 0;  ///< samples that lie 12 away
  double hook = 0;         ///< length by which the end goes back beside itself
  bool doubled = false;    ///< every sample is given twice
};

/// A path on a mesh, and samples of it. Equal seeds give equal hands.
class HandStroke {
 public:
  /// Begins at a random place with a path of this length; `is_drawn()` tells whether one was found.
  HandStroke(const SurfaceMesh& mesh, const Hand& hand, std::uint64_t seed);

  [[nodiscard]] bool is_drawn() const { return !way_.empty(); }
  /// The intended path: positions a tenth of an edge apart.
  [[nodiscard]] const std::vector<Point>& way() const { return way_; }
  /// The edge that is the unit of all lengths, mesh units.
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
