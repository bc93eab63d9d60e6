// A drawing is what a person draws on a mesh, as a value: points, pins, curves, and how to smooth
// them. A value.
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

/// An edit that cannot be done; what() is a sentence for the person who tried.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A point of a drawing: a triangle of the mesh and coordinates in it, in the order of its corners.
struct Point {
  std::uint32_t face = 0;
  std::array<double, 3> barycentric = {1, 0, 0};  ///< each >= 0, sum 1
  bool pinned = false;                            ///< the smoothed curve passes through it
  /// 0 or more at a point that was clicked: its tolerance in mesh units. Otherwise a mark of
  /// talweg_way_points.h.
  double exact = TALWEG_MARK_NONE;

  bool operator==(const Point&) const = default;
  [[nodiscard]] bool same_place(const Point& other) const {
    return face == other.face && barycentric == other.barycentric;
  }
};

/// The point of a picked position. Coordinates that rounding has put slightly outside the triangle
/// are moved to its rim. Throws Error when they are not finite, or all of them are 0 or less.
Point picked(std::uint32_t face, const std::array<double, 3>& barycentric);

struct Curve {
  std::vector<Point> points;
  bool closed = false;  ///< joined from the last point back to the first, which is not repeated
  std::optional<double> tau = {};  ///< >= 0; none: the settings'
  /// How far the result may pass from what was drawn, mesh units, >= 0: the tolerance of all
  /// way-points that are not pinned, and the slack of strokes. None: that of each point, and the
  /// settings' slack.
  std::optional<double> tolerance = {};
  std::string name = {};     ///< for people; empty: it has only its number
  std::uint32_t number = 0;  ///< tells the curves of a drawing apart; the editor's, from 1

  /// Compares what curves are; the number is which one it is.
  bool operator==(const Curve& other) const;
};

/// What becomes of the ends of curves that are not closed.
enum class Ends {
  kAuto,    ///< a painted stroke that comes back to its beginning is a loop
  kClosed,  ///< every curve is
  kOpen,    ///< none is
};
/// As the parameter of talweg.smooth has it: "auto", "closed", "open".
const char* name_of(Ends ends);
/// Throws Error for another name.
Ends ends_named(const std::string& name);

/// Which ridges attract a drawing.
enum class RidgeKind { kBoth, kConvex, kConcave };
/// As the parameter of talweg.smooth has it: "both", "convex", "concave".
const char* name_of(RidgeKind kind);
/// Throws Error for another name.
RidgeKind ridges_named(const std::string& name);

/// Parameters of talweg.smooth that belong to the drawing.
struct Settings {
  double tau = 1;                       ///< >= 0
  std::optional<double> slack;          ///< mesh units, >= 0; none: the plugin's default
  std::optional<double> max_deviation;  ///< mesh units, > 0; chooses tau and slack
  bool paper = false;  ///< the paper's own potential; then without slack and max_deviation
  Ends ends = Ends::kAuto;
  /// Successive clicks at most so far apart are one; mesh units, >= 0; none: the plugin's default.
  std::optional<double> click_distance = {};
  double ridges = 0;  ///< [0, 1]: how strongly ridges attract the drawing
  RidgeKind ridge_kind = RidgeKind::kBoth;

  bool operator==(const Settings&) const = default;
};

/// Curves at a distance along the surface from the smoothed ones: the choices of a person, which
/// hosts with an offset that follows the drawing hand to talweg.offset.
struct Offset {
  bool on = false;
  std::optional<std::uint32_t> of = {};  ///< the number of a curve; none: of all
  double distance = 0;                   ///< mesh units, above 0 while it is on
  std::string side = "both";             ///< as the parameters of talweg.offset
  std::string caps = "round";

  bool operator==(const Offset&) const = default;
};

/// The state that undo restores. Copies share the curves, which never change.
struct Drawing {
  std::vector<std::shared_ptr<const Curve>> curves;
  bool unfinished = false;  ///< the last curve is still being drawn
  Settings settings;
  Offset offset = {};

  /// Compares contents, not shared pointers.
  bool operator==(const Drawing& other) const;
};

/// The interface's stages that must be repeated when one drawing replaces another.
enum class Stage { kNothing, kRun, kCurves };
Stage stage_between(const Drawing& before, const Drawing& after);

/// The curves that can be smoothed; an unfinished curve of a single point is left out. They are the
/// first curves of the drawing, in its order.
std::vector<host::Curve> host_curves(const Drawing& drawing);

/// Where curves run, by faces and barycentrics, and nothing else of them: a plugin takes one kind
/// of place.
std::vector<host::Curve> courses(const std::vector<host::Curve>& curves);

/// Whether all points were clicked. Slack and largest deviation do not apply then: the curves are
/// free between their points. False without curves.
bool all_clicked(const Drawing& drawing);

/// Whether all points of a curve were clicked.
bool all_clicked(const Curve& curve);

/// Sets the parameters of an instance of talweg.smooth that has these curves: the settings and
/// what is a curve's own. Throws host::Error.
void apply(const Drawing& drawing, host::Instance& smooth);

}  // namespace talweg::editing
