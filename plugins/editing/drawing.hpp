// A drawing consists of the curves that a user draws on a mesh, their points and pins, and the
// settings of smoothing. It is a value.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "talweg/plugin/talweg_host.hpp"

namespace talweg::editing {

/// An edit that is not possible; what() is a sentence for the user.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A point of a drawing: a triangle of the mesh and coordinates in it, in the order of its corners.
struct Point {
  std::uint32_t face = 0;
  std::array<double, 3> barycentric = {1, 0, 0};  ///< each >= 0, sum 1
  bool pinned = false;                            ///< the smoothed curve passes through it
  /// At a clicked point, its tolerance in mesh units, >= 0. At other points, a negative mark of
  /// talweg_way_points.h.
  double exact = TALWEG_MARK_NONE;

  bool operator==(const Point&) const = default;
  [[nodiscard]] bool same_place(const Point& other) const {
    return face == other.face && barycentric == other.barycentric;
  }
};

/// The point at a picked position. Negative coordinates, which rounding may cause, become 0, and
/// the sum becomes 1. Throws Error if a coordinate is not finite, or if none is more than 0.
Point picked(std::uint32_t face, const std::array<double, 3>& barycentric);

struct Curve {
  std::vector<Point> points;
  bool closed = false;  ///< joined from the last point back to the first, which is not repeated
  std::optional<double> tau = {};  ///< >= 0; none: tau of the settings
  /// The largest distance of the result from the drawing, mesh units, >= 0: the tolerance of all
  /// way-points that are not pinned, and the slack of strokes. None: the tolerance of each point,
  /// and the slack of the settings.
  std::optional<double> tolerance = {};
  std::string name = {};     ///< shown to the user; empty: only the number is shown
  std::uint32_t number = 0;  ///< identifies the curve in its drawing; the editor counts from 1

  /// Compares all members but the number.
  bool operator==(const Curve& other) const;
};

/// The treatment of curves that are not drawn as closed.
enum class Ends {
  kAuto,    ///< a painted stroke that returns to its beginning becomes a loop
  kClosed,  ///< every curve becomes a loop
  kOpen,    ///< no curve becomes a loop
};
/// The value of talweg.smooth's parameter `ends`: "auto", "closed" or "open".
const char* name_of(Ends ends);
/// The inverse of name_of(). Throws Error for other names.
Ends ends_named(const std::string& name);

/// The kind of ridges that attract a drawing.
enum class RidgeKind { kBoth, kConvex, kConcave };
/// The value of talweg.smooth's parameter `ridge_kind`: "both", "convex" or "concave".
const char* name_of(RidgeKind kind);
/// The inverse of name_of(). Throws Error for other names.
RidgeKind ridges_named(const std::string& name);

/// Parameters of talweg.smooth that belong to the drawing.
struct Settings {
  double tau = 1;                       ///< >= 0
  std::optional<double> slack;          ///< mesh units, >= 0; none: the plugin's default
  std::optional<double> max_deviation;  ///< mesh units, > 0; chooses tau and slack
  bool paper = false;  ///< the potential of the paper, which ignores slack and max_deviation
  Ends ends = Ends::kAuto;
  /// Successive clicks no farther apart become one; mesh units, >= 0; none: the plugin's default.
  std::optional<double> click_distance = {};
  double ridges = 0;  ///< the strength, in [0, 1], with which ridges attract the drawing
  RidgeKind ridge_kind = RidgeKind::kBoth;

  bool operator==(const Settings&) const = default;
};

/// The user's choices for offset curves of the smoothed curves. Hosts whose offset curves follow
/// the drawing pass the choices to talweg.offset.
struct Offset {
  bool on = false;
  std::optional<std::uint32_t> of = {};  ///< the number of a curve; none: all curves
  double distance = 0;                   ///< along the surface, mesh units; > 0 if `on`
  std::string side = "both";             ///< a value of talweg.offset's parameter `side`
  std::string caps = "round";            ///< a value of talweg.offset's parameter `caps`

  bool operator==(const Offset&) const = default;
};

/// The state that undo restores. Copies of a drawing share their curves, which are immutable.
struct Drawing {
  std::vector<std::shared_ptr<const Curve>> curves;
  bool unfinished = false;  ///< the user still draws the last curve
  Settings settings;
  Offset offset = {};

  /// Compares the curves, not the pointers to them.
  bool operator==(const Drawing& other) const;
};

/// The calls of the plugin that are needed when one drawing replaces another: none, run() alone, or
/// set_curves() and run().
enum class Stage { kNothing, kRun, kCurves };
Stage stage_between(const Drawing& before, const Drawing& after);

/// The curves of the drawing in its order, as input of a plugin. A curve with fewer than two points
/// is left out. Only the unfinished last curve can be so short, so indices are those of the
/// drawing.
std::vector<host::Curve> host_curves(const Drawing& drawing);

/// Copies of curves that have only faces and barycentrics, since a plugin takes one description of
/// a curve's points.
std::vector<host::Curve> courses(const std::vector<host::Curve>& curves);

/// Whether all points of all curves were clicked. Slack and largest deviation do not apply to such
/// a drawing: its curves are free between their points. False without curves.
bool all_clicked(const Drawing& drawing);

/// Whether all points of a curve were clicked.
bool all_clicked(const Curve& curve);

/// Sets the parameters of an instance of talweg.smooth that has these curves: the settings, and tau
/// and slack of single curves. Throws host::Error.
void apply(const Drawing& drawing, host::Instance& smooth);

}  // namespace talweg::editing
