// The editor does the edits that a person can make to a drawing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "history.hpp"

namespace talweg::editing {

/// A drawing on one mesh, and all edits of it. Every edit can be undone. An edit that cannot be
/// done throws Error and changes nothing. One thread at a time.
class Editor {
 public:
  Editor() = default;
  /// Begins with these settings, which are no step that could be undone. Throws Error.
  explicit Editor(const Settings& settings);
  /// Begins with this drawing, as that of another editor.
  explicit Editor(Drawing drawing);

  [[nodiscard]] const Drawing& drawing() const { return history_.now(); }
  [[nodiscard]] History& history() { return history_; }
  [[nodiscard]] const History& history() const { return history_; }
  [[nodiscard]] bool is_drawing() const { return drawing().unfinished; }

  // ---- A curve while it is drawn.

  /// Adds a point that was clicked, which is meant exactly, to the curve that is being drawn, or
  /// begins a curve if there is none. A point at the place of the last one is ignored.
  void add_point(const Point& point);
  /// The same for a point over which the mouse was dragged: it is part of a stroke. If the curve
  /// has only one point yet, the stroke began there.
  void paint_point(const Point& point);
  /// Backspace: removes the last point; with its only point the curve is removed too.
  void take_back_point();
  /// Enter: finishes the curve as an open one. Needs two points.
  void finish_curve();
  /// A click on the first point: finishes the curve as a closed one. Needs three points.
  void close_curve();
  /// Esc: removes the curve.
  void drop_curve();

  /// Removes any curve, the one that is being drawn too; that one stays if another goes.
  void remove_curve(std::size_t curve);

  // ---- Whole curves; not while a curve is being drawn.

  /// Adds a curve from another source: selected vertices, another object, a script. Needs two
  /// points, three when closed; of successive points at one place only the first counts.
  void add_curve(Curve curve);
  void set_closed(std::size_t curve, bool closed);
  void reverse_curve(std::size_t curve);
  /// Drawing goes on at the end of an open curve, which becomes the last one.
  void continue_curve(std::size_t curve);
  /// Removes all curves; the settings and the offset's choices stay, but it is of all curves.
  void clear();

  // ---- What is a curve's own; of any curve.

  void rename_curve(std::size_t curve, const std::string& name);
  void set_curve_tau(std::size_t curve, std::optional<double> tau);
  void set_curve_tolerance(std::size_t curve, std::optional<double> tolerance);
  /// Pins all its points, or lets all go.
  void pin_curve(std::size_t curve, bool pinned);

  // ---- Points of any curve.

  /// Keeps its pin, and whether it was clicked or painted.
  void move_point(std::size_t curve, std::size_t point, const Point& to);
  /// A point that is inserted into a curve with way-points is one, too.
  void insert_point(std::size_t curve, std::size_t before, const Point& point);
  /// Removes the whole curve if it would have too few points left.
  void remove_point(std::size_t curve, std::size_t point);
  void set_pinned(std::size_t curve, std::size_t point, bool pinned);

  // ---- Settings.

  void set_tau(double tau);
  void set_slack(std::optional<double> slack);
  void set_max_deviation(std::optional<double> bound);
  void set_paper(bool paper);
  void set_ends(Ends ends);
  void set_click_distance(std::optional<double> distance);
  void set_ridges(double strength);
  void set_ridge_kind(RidgeKind kind);
  /// Smoothing does not depend on it. Throws Error for a distance that is not more than 0 while it
  /// is on.
  void set_offset(const Offset& offset);

 private:
  const Curve& curve_at(std::size_t curve) const;
  const Curve& curve_at(std::size_t curve, std::size_t point) const;
  const Curve& unfinished() const;
  void not_while_drawing() const;
  void append(Point point, double mark);
  [[nodiscard]] std::uint32_t next_number() const;
  void replace(const std::string& name, std::size_t curve, Curve by, bool unfinished);
  void erase(const std::string& name, std::size_t curve);
  void set(const std::string& name, const Settings& settings);

  History history_;
};

}  // namespace talweg::editing
