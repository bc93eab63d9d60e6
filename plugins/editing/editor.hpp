// The editor changes a drawing as the user does: each edit is one function.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "history.hpp"

namespace talweg::editing {

/// A drawing on one mesh with its history. Every edit can be undone. An edit that is not possible
/// throws Error and changes nothing. Only one thread at a time may use the editor.
class Editor {
 public:
  Editor() = default;
  /// Begins with an empty drawing. Undo does not go back before these settings. Throws Error for
  /// settings out of range.
  explicit Editor(const Settings& settings);
  /// Begins with a drawing, such as the drawing of another editor. Throws Error for settings out of
  /// range.
  explicit Editor(Drawing drawing);

  [[nodiscard]] const Drawing& drawing() const { return history_.now(); }
  [[nodiscard]] History& history() { return history_; }
  [[nodiscard]] const History& history() const { return history_; }
  [[nodiscard]] bool is_drawing() const { return drawing().unfinished; }

  // ---- The unfinished curve, which the user still draws.

  /// Adds a clicked point, which is a way-point, to the unfinished curve, or begins a curve. A
  /// point at the place of the last point is ignored.
  void add_point(const Point& point);
  /// Adds a point over which the mouse was dragged, as part of a stroke. A single point before it
  /// becomes the beginning of the stroke.
  void paint_point(const Point& point);
  /// Backspace: removes the last point. A curve without points left is removed.
  void take_back_point();
  /// Enter: finishes the curve as an open curve. Throws Error for fewer than two points.
  void finish_curve();
  /// A click on the first point: finishes the curve as a closed curve. Throws Error for fewer than
  /// three points in different places.
  void close_curve();
  /// Esc: removes the unfinished curve.
  void drop_curve();

  /// Removes a curve, finished or not.
  void remove_curve(std::size_t curve);

  // ---- Whole curves. All but clear() throw Error while a curve is unfinished.

  /// Adds a curve from another source: selected vertices, another object, a script. Of successive
  /// points at one place, the first is kept. Throws Error for fewer than two points, or fewer than
  /// three points of a closed curve.
  void add_curve(Curve curve);
  void set_closed(std::size_t curve, bool closed);
  void reverse_curve(std::size_t curve);
  /// Makes an open curve the unfinished curve, which is the last one. Throws Error for a closed
  /// curve.
  void continue_curve(std::size_t curve);
  /// Removes all curves. The settings and the choices of the offset stay, but `Offset::of` is
  /// reset.
  void clear();

  // ---- Properties of any curve, finished or not.

  void rename_curve(std::size_t curve, const std::string& name);
  void set_curve_tau(std::size_t curve, std::optional<double> tau);
  void set_curve_tolerance(std::size_t curve, std::optional<double> tolerance);
  /// Pins or unpins all points of the curve.
  void pin_curve(std::size_t curve, bool pinned);

  // ---- Points of any curve, finished or not.

  /// Moves a point to the place of `to`. The point keeps its pin and its mark.
  void move_point(std::size_t curve, std::size_t point, const Point& to);
  /// Inserts a point before the point `before`. In a curve with way-points, a point without a mark
  /// becomes a way-point.
  void insert_point(std::size_t curve, std::size_t before, const Point& point);
  /// Removes a point, or the whole curve if too few points would be left.
  void remove_point(std::size_t curve, std::size_t point);
  void set_pinned(std::size_t curve, std::size_t point, bool pinned);

  // ---- Settings. Setters of numbers throw Error for values out of range.

  void set_tau(double tau);
  void set_slack(std::optional<double> slack);
  void set_max_deviation(std::optional<double> bound);
  void set_paper(bool paper);
  void set_ends(Ends ends);
  void set_click_distance(std::optional<double> distance);
  void set_ridges(double strength);
  void set_ridge_kind(RidgeKind kind);
  /// Smoothing does not depend on the offset. Throws Error if the offset is on and its distance is
  /// not more than 0.
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
