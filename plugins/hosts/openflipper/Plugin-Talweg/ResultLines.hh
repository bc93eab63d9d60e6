// The result lines are the smoothed curves as objects of the host, one polyline for each.
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

  /// Each curve keeps its line, whichever others come and go. `numbers`: those of the curves in the
  /// drawing.
  void show(const TriMesh& mesh, const std::vector<host::Curve>& curves,
            const std::vector<std::uint32_t>& numbers, const editing::Drawing& drawing);
  /// The line of the curve with that number is thicker than the others; 0: none is.
  void select(std::uint32_t number);
  /// Deviations as colours along the lines.
  void show_deviations(bool with);
  /// What the last colour stands for, mesh units.
  [[nodiscard]] double largest_deviation() const { return largest_deviation_; }

  /// Of the host's objects; in the order of the results.
  [[nodiscard]] std::vector<int> ids() const;
  [[nodiscard]] bool has(int id) const;
  /// If that object, which a person has deleted, was a line: the number of its curve.
  std::optional<std::uint32_t> was_deleted(int id);

 private:
  struct Line {
    int id;                // of the host's object
    std::uint32_t number;  // of the curve that it shows
    QString name;          // as it was given
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
