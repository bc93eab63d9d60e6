// talweg.draw: points become a curve.
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "curve_files.hpp"
#include "methods/plugins.hpp"
#include "methods/results.hpp"
#include "methods/ridge_choice.hpp"
#include "methods/workspace.hpp"
#include "talweg/core/drawing/edge_dijkstra.hpp"
#include "talweg/core/drawing/point_marks.hpp"
#include "talweg/core/measure/measures.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::plugins {
namespace {

class Draw : public Workspace {
 public:
  using Workspace::Workspace;

  static talweg_plugin about() {
    talweg_plugin about = about_curves(
        "talweg.draw", "Draw curves",
        "Draws curves through points in their order: straight lines over the surface between any "
        "points, or shortest edge paths between vertices, never through itself. Points need not be "
        "neighbours.");
    about.get_extension = extension;
    return about;
  }
  static const void* extension(const char* id) {
    if (id == nullptr) return nullptr;
    if (std::string_view(id) == TALWEG_CURVE_FILES) return curve_files();
    if (std::string_view(id) == TALWEG_CURVE_FILES_2) return curve_files_2();
    if (std::string_view(id) == TALWEG_CURVE_FILES_3) return curve_files_3();
    return std::string_view(id) == TALWEG_WAY_POINTS ? way_points_extension() : nullptr;
  }
  static std::vector<talweg_parameter> parameters() {
    std::vector<talweg_parameter> all = {
        plugin::choice("way", "Way", "auto", kWays, kWayLabels,
                       "How the points are joined. straight: over the faces, where legs may cross; "
                       "edges: along edges of the mesh, where the path never crosses itself; auto: "
                       "straight between way-points, along edges in a stroke.",
                       TALWEG_STAGE_RUN),
        plugin::boolean("straight", "Straight", false, "The same as way = straight.",
                        TALWEG_STAGE_RUN, TALWEG_ADVANCED),
        plugin::choice("points", "Points", "exact", kPoints, kPointLabels,
                       "The kind of the given points. exact: way-points, except points that the "
                       "given curve marks otherwise; rough: a stroke.",
                       TALWEG_STAGE_RUN),
        plugin::boolean(
            "preview", "Preview", false,
            "For use while a point is dragged. If one way-point of a curve has moved since the "
            "last run without preview, only the legs that meet the point are drawn anew, around "
            "the other legs. The next run without preview gives the final curve.",
            TALWEG_STAGE_RUN, TALWEG_ADVANCED)};
    for (const talweg_parameter& parameter : ridge_choice(TALWEG_STAGE_RUN)) {
      all.push_back(parameter);
    }
    return with_repair(all);
  }
  static std::vector<talweg_output> outputs() {
    using plugin::output;
    return {
        output(TALWEG_OUTPUT_CURVES, "curves", "Drawn curves", "",
               "One for each given curve, in their order."),
        output(TALWEG_OUTPUT_POINT_FIELD, "given", "Given points", "",
               "1 at the given points, 0 at the points that join them."),
        output(TALWEG_OUTPUT_POINT_FIELD, TALWEG_EXACT, "Exact", "mesh units",
               "The tolerance of way-points, -2 at painted points, -1 at all others. Present if "
               "points is exact, absent if it is rough."),
        output(TALWEG_OUTPUT_REPORT, "report", "Report", "",
               "Points and length of each curve and in total.")};
  }

  void put(const std::vector<CurveInput>& curves) override {
    std::vector<SnappedCurve> snapped;
    std::vector<std::vector<double>> marks;
    for (const CurveInput& curve : curves) {
      snapped.push_back(points_of(curve));
      marks.push_back(marks_on(snapped.back()));
    }
    snapped_ = std::move(snapped);
    marks_ = std::move(marks);
  }

  void run(const plugin::Parameters& parameters, const plugin::Outputs& outputs) {
    const bool preview = parameters.flag("preview");
    const bool exact = parameters.choice("points") == "exact";
    const std::string& way = parameters.choice("way");
    const bool straight =
        parameters.flag("straight") || way == "straight" || (way == "auto" && exact);
    std::vector<PlacedCurve> placed;
    std::vector<std::vector<PointField>> fields(snapped_.size());
    std::vector<double> lengths;
    std::vector<DrawnPath> paths;
    std::vector<RidgeMoves> moves;
    const RidgeOptions ridges = ridge_options_of(parameters);
    std::vector<std::string> notes = host_mesh().changes();
    double total = 0;
    for (std::size_t c = 0; c < snapped_.size(); ++c) {
      go_on("draw", static_cast<double>(c) / static_cast<double>(snapped_.size()));
      const DrawnPath* last = preview && c < paths_.size() ? &paths_[c] : nullptr;
      SurfaceCurve curve = cancellable([&] {
        return straight ? lines().join(snapped_[c].points, snapped_[c].closed, progress())
                        : along_edges(snapped_[c], last, paths.emplace_back());
      });
      std::vector<double> marks;
      if (exact) marks = marks_through(curve, snapped_[c].points, marks_[c]);
      if (ridges.strength > 0) {
        moves.push_back(snap_to_ridges(c, ridges, curve, marks));
        notes.push_back(moves.back().sentence(c));
      }
      placed.push_back(host_mesh().to_host(place(mesh(), curve, c)));
      placed.back().exact = std::move(marks);
      if (outputs.wants_point_fields()) fields[c] = {given_field(snapped_[c], curve)};
      lengths.push_back(curve_length(mesh().surface(), curve));
      total += lengths.back();
    }
    if (!preview) paths_ = std::move(paths);
    outputs.report(-1, "length", total);
    give(outputs, -1, total_entries(moves));
    give(outputs, -1, {{"warnings", notes}});
    for (std::size_t c = 0; c < placed.size(); ++c) {
      const auto number = static_cast<std::int64_t>(c);
      give(outputs, placed[c], fields[c]);
      outputs.report(number, "points", static_cast<double>(placed[c].faces.size()),
                     TALWEG_VALUE_INTEGER);
      outputs.report(number, "length", lengths[c]);
      if (c < moves.size()) give(outputs, number, entries_of(moves[c]));
    }
  }

 private:
  static constexpr const char* kWays[] = {"auto", "straight", "edges"};
  static constexpr const char* kWayLabels[] = {"Automatic", "Straight", "Along edges"};
  static constexpr const char* kPoints[] = {"exact", "rough"};
  static constexpr const char* kPointLabels[] = {"Exact: way-points", "Rough: a stroke"};

  /// The marks of a curve's points; empty without marks, when all points are way-points.
  static std::vector<double> marks_on(const SnappedCurve& curve) {
    const bool is_stroke = !curve.why_stroke.empty();
    if (curve.way_points.empty() && curve.painted.empty() && !is_stroke) return {};
    std::vector<double> marks(curve.points.size(), kNotSaid);
    for (const InputWayPoint& way : curve.way_points) marks[way.point] = way.tolerance;
    for (const std::size_t k : curve.painted) marks[k] = kPainted;
    return marks;
  }

  /// Moves a drawn curve and its marks onto ridges. Pins stay.
  RidgeMoves snap_to_ridges(std::size_t c, const RidgeOptions& options, SurfaceCurve& curve,
                            std::vector<double>& marks) {
    std::vector<SurfacePoint> pins;
    for (const std::size_t pin : snapped_[c].pins) pins.push_back(snapped_[c].points[pin]);
    RidgedDrawing ridged = cancellable([&] {
      return snapped_to_ridges(mesh(), std::span(&curve, 1), pins, marked_points(curve, marks),
                               options, progress());
    });
    curve = std::move(ridged.curves.front());
    if (!marks.empty()) marks = marks_of_points(curve, ridged.points);
    return ridged.moves.front();
  }

  /// The points of a curve on the mesh. Vertices may come in any order and any number of times;
  /// other points are snapped.
  SnappedCurve points_of(const CurveInput& input) {
    const auto* ids = std::get_if<std::vector<VertexId>>(&input.points);
    if (ids == nullptr) return std::move(snapped_on(host_mesh(), {input}).front());
    SnappedCurve result;
    result.closed = input.closed;
    for (const VertexId v : *ids) {
      result.points.push_back(SurfacePoint::at_vertex(mesh().surface(), v));
    }
    for (const std::size_t pin : input.pins) {
      if (pin >= ids->size()) {
        throw Error(ErrorCode::kBadCurve,
                    fmt::format("There is no point {} that could be pinned; the curve has {}, "
                                "counted from 0.",
                                pin, ids->size()));
      }
    }
    if (ids->size() < 2) throw Error(ErrorCode::kBadCurve, "A curve needs at least two points.");
    result.way_points = input.way_points;
    result.painted = input.painted;
    return result;
  }

  /// A path along edges, and the way-points through which it was drawn.
  struct DrawnPath {
    bool closed = false;
    std::vector<VertexId> through, vertices;
  };

  static std::vector<VertexId> way_points(const SnappedCurve& points) {
    std::vector<VertexId> through;
    for (const SurfacePoint& point : points.points) {
      const auto* at = std::get_if<AtVertex>(&point.where());
      if (at == nullptr) {
        throw Error(ErrorCode::kBadCurve, "Point " + std::to_string(through.size()) +
                                              " is not at a vertex, so no edges lead there; draw "
                                              "straight instead.");
      }
      through.push_back(at->vertex);
    }
    return through;
  }

  /// Draws a path along edges, which keeps as much as possible of the path `last`, if not null.
  SurfaceCurve along_edges(const SnappedCurve& points, const DrawnPath* last, DrawnPath& path) {
    path.closed = points.closed;
    path.through = way_points(points);
    if (!dijkstra_) dijkstra_.emplace(mesh().surface());
    const std::optional<std::size_t> moved =
        last != nullptr ? only_change(*last, path) : std::nullopt;
    path.vertices =
        moved ? dijkstra_->redraw(last->vertices, path.through, *moved, path.closed, progress())
              : dijkstra_->draw(path.through, path.closed, progress());
    SurfaceCurve curve{path.closed, {}};
    for (const VertexId v : path.vertices) {
      curve.points.push_back(SurfacePoint::at_vertex(mesh().surface(), v));
    }
    return curve;
  }

  /// The field "given": 1 at given points, which the drawn curve has unchanged and in order, else
  /// 0.
  static PointField given_field(const SnappedCurve& given, const SurfaceCurve& drawn) {
    PointField field{"given", "", {}};
    std::size_t next = 0;
    for (const SurfacePoint& point : drawn.points) {
      const bool is_given = next < given.points.size() && point == given.points[next];
      if (is_given) ++next;
      field.values.push_back(is_given ? 1.0 : 0.0);
    }
    return field;
  }

  /// The index of the only way-point in which two paths differ; none if they differ otherwise.
  static std::optional<std::size_t> only_change(const DrawnPath& a, const DrawnPath& b) {
    if (a.closed != b.closed || a.through.size() != b.through.size()) return std::nullopt;
    const auto first = std::mismatch(a.through.begin(), a.through.end(), b.through.begin());
    const auto moved = first.first - a.through.begin();
    if (first.first == a.through.end()) return std::nullopt;
    const bool only = std::equal(first.first + 1, a.through.end(), first.second + 1);
    return only ? std::optional(static_cast<std::size_t>(moved)) : std::nullopt;
  }

  void forget() override {
    Workspace::forget();
    dijkstra_.reset();
    paths_.clear();
  }

  std::vector<SnappedCurve> snapped_;
  std::vector<std::vector<double>> marks_;  // per curve and point
  std::optional<EdgeDijkstra> dijkstra_;    // made when first needed
  std::vector<DrawnPath> paths_;            // paths of the last run without preview
};

}  // namespace

const talweg_plugin* draw_plugin() { return plugin::Adapter<Draw>::plugin(); }

}  // namespace talweg::plugins
