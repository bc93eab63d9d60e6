// Colours show deviations along the smoothed curves, or distances on the mesh.
#pragma once

#include <QString>

#include "HostCalls.hh"
#include "ResultLines.hh"

namespace talweg::openflipper {

enum class ColourBy { kNothing, kDeviation, kDistance, kPotential };

class Colours {
 public:
  Colours(HostCalls& host, TriMeshObject& mesh, ResultLines& lines)
      : host_(host), mesh_(mesh), lines_(lines) {}

  void choose(ColourBy by);
  [[nodiscard]] ColourBy by() const { return by_; }
  /// Whether the chosen colours are on the mesh, so that show() needs fields of the mesh.
  [[nodiscard]] bool on_mesh() const {
    return by_ == ColourBy::kDistance || by_ == ColourBy::kPotential;
  }
  /// Shows the fields of these results on the mesh.
  void show(const host::Results& results);

  struct Scale {
    double most = 0;  ///< value of the last colour; the first colour has the value 0
    QString unit;
  };
  [[nodiscard]] Scale scale() const;

 private:
  HostCalls& host_;
  TriMeshObject& mesh_;
  ResultLines& lines_;
  ColourBy by_ = ColourBy::kNothing;
  double largest_ = 0;  // value on the mesh
};

}  // namespace talweg::openflipper
