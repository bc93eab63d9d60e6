// The smoothed curves as objects of the host, a polyline for each curve.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "HostCalls.hh"
#include "talweg/editing/drawing.hpp"

namespace talweg::openflipper {

class ResultLines {
 public:
  ResultLines(HostCalls& host, const QString& mesh_name) : host_(host), mesh_name_(mesh_name) {}

  /// Updates the lines. A curve keeps its line when other curves are added or removed. `numbers`
  /// are the numbers of the curves in the drawing.
  void show(const TriMesh& mesh, const std::vector<host::Curve>& curves,
            const std::vector<std::uint32_t>& numbers, const editing::Drawing& drawing);
  /// Makes the line of the curve with this number thicker than the others; 0: no line.
  void select(std::uint32_t number);
  /// Deviations as colours along the lines.
  void show_deviations(bool with);
  /// The value of the last colour, mesh units.
  [[nodiscard]] double largest_deviation() const { return largest_deviation_; }

  /// Ids of the host's objects, in the order of the results.
  [[nodiscard]] std::vector<int> ids() const;
  [[nodiscard]] bool has(int id) const;
  /// The number of the curve whose line was this deleted object; nothing if it was none.
  std::optional<std::uint32_t> was_deleted(int id);

 private:
  struct Line {
    int id;                // id of the host's object
    std::uint32_t number;  // number of the curve
    QString name;          // the user's name of the curve
  };

  void keep(const std::vector<std::uint32_t>& numbers, const editing::Drawing& drawing);
  [[nodiscard]] QString name_of(std::uint32_t number, const editing::Drawing& drawing) const;
  int add(const QString& name, std::uint32_t number);
  void show_widths() const;
  void look(PolyLineObject& line) const;

  HostCalls& host_;
  QString mesh_name_;
  std::vector<Line> lines_;
  std::uint32_t selected_ = 0;
  bool with_deviations_ = false;
  double largest_deviation_ = 0;
};

}  // namespace talweg::openflipper
