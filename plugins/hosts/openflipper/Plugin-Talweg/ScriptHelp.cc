#include "ScriptHelp.hh"

#include <QCoreApplication>

namespace talweg::openflipper {
namespace {

struct ScriptHelp {
  Q_DECLARE_TR_FUNCTIONS(ScriptHelp)

 public:
  static std::vector<ScriptSlot> all();
};

std::vector<ScriptSlot> ScriptHelp::all() {
  const QString mesh = tr("id of a triangle mesh");
  const QString curve = mesh + tr(";from 0");
  const QString curve_point = mesh + tr(";curve, from 0;point, from 0;");
  return {
      {"draw(int,IdList,bool)", tr("Adds a curve through vertices, straight over the faces."),
       "meshId;vertices;closed", mesh + tr(";vertices from 0;whether the curve is closed")},
      {"addPoint(int,int,Vector)", tr("Adds a point to the curve that is being drawn."),
       "meshId;face;barycentric", mesh + tr(";face from 0;barycentric coordinates in the face")},
      {"finishCurve(int)", tr("Ends the curve that is being drawn."), "meshId", mesh},
      {"closeCurve(int)", tr("Closes the curve that is being drawn."), "meshId", mesh},
      {"takeBackPoint(int)", tr("Takes the last point back."), "meshId", mesh},
      {"dropCurve(int)", tr("Drops the curve that is being drawn."), "meshId", mesh},
      {"fromSelection(int)", tr("Curves from selected vertices or edges."), "meshId", mesh},
      {"fromFaceSelection(int)", tr("Curves along the border of the selected faces."), "meshId",
       mesh},
      {"fromFaceColours(int)", tr("Curves along the borders between face colours."), "meshId",
       mesh},
      {"fromPolyLine(int,int)", tr("A curve from a polyline, put onto the mesh."),
       "meshId;polyLineId", mesh + tr(";id of a polyline")},
      {"removeCurve(int,int)", tr("Removes a curve."), "meshId;curve", mesh + tr(";from 0")},
      {"clear(int)", tr("Removes all curves."), "meshId", mesh},
      {"movePoint(int,int,int,int,Vector)", tr("Moves a drawn point."),
       "meshId;curve;point;face;barycentric",
       curve_point + tr("face from 0;barycentric coordinates in the face")},
      {"setPinned(int,int,int,bool)", tr("Pins a drawn point, or unpins it."),
       "meshId;curve;point;pinned", curve_point + tr("whether the result passes through it")},
      {"setClosed(int,int,bool)", tr("Closes or opens a curve."), "meshId;curve;closed",
       mesh + tr(";from 0;whether the curve is closed")},
      {"setTau(int,double)", tr("0: straight lines; higher values keep closer to the drawing."),
       "meshId;tau", mesh + tr(";0 or more")},
      {"setSlack(int,double)", tr("How exact the drawing is."), "meshId;slack",
       mesh + tr(";mesh units, negative: from the drawing")},
      {"setMaxDeviation(int,double)", tr("The largest deviation; chooses tau and slack."),
       "meshId;bound", mesh + tr(";mesh units, 0: no bound")},
      {"setEnds(int,QString)", tr("The treatment of the ends of curves that are not closed."),
       "meshId;ends",
       mesh + tr(";auto: painted strokes that return to their start are loops, closed: all curves "
                 "are loops, open: none")},
      {"setClickDistance(int,double)", tr("Successive clicks within this distance are merged."),
       "meshId;distance", mesh + tr(";mesh units, negative: an edge of the mesh")},
      {"setRidges(int,double)", tr("How strongly ridges beside the drawing attract it."),
       "meshId;strength", mesh + tr(";0 (not at all) to 1")},
      {"setRidgeKind(int,QString)", tr("The kind of ridges that attract the drawing."),
       "meshId;kind", mesh + tr(";both, convex: ridges, concave: valleys")},
      {"undoEdit(int)", tr("Takes the last edit back."), "meshId", mesh},
      {"redoEdit(int)", tr("Repeats the edit that was taken back."), "meshId", mesh},
      {"repairMesh(int)",
       tr("Draws on the mesh as if it was repaired, if it is not a surface; the mesh itself is "
          "unchanged."),
       "meshId", mesh},
      {"smooth(int)", tr("Waits for the smoothed curves and returns their polylines' ids."),
       "meshId", mesh},
      {"report(int)", tr("Everything that was measured, one \"key = value\" a line."), "meshId",
       mesh},
      {"measure(int,QString)", tr("One number of the report, for all curves together."),
       "meshId;key", mesh + tr(";such as length_after")},
      {"lastError(int)", tr("Why the last edit or smoothing failed; empty if it did not."),
       "meshId", mesh},
      {"writeResult(int,QString)", tr("Writes the smoothed curves."), "meshId;filename",
       mesh + tr(";.json, .vtp, .vtk, .obj, .ply, .mrk.json")},
      {"writeDrawing(int,QString)", tr("Writes the drawn points."), "meshId;filename",
       mesh + tr(";as writeResult")},
      {"readDrawing(int,QString)", tr("Adds the curves of a file."), "meshId;filename",
       mesh + tr(";as writeResult, or .txt")},
      {"cut(int)", tr("Makes the smoothed curves edges of the mesh, and selects them."), "meshId",
       mesh},
      {"selectInside(int)", tr("Cuts, and selects the faces inside the closed curves."), "meshId",
       mesh},
      {"split(int,bool)", tr("Makes a mesh of each part between the smoothed curves."),
       "meshId;lids", mesh + tr(";whether the parts are closed where they were cut")},
      {"offset(int,double,QString)",
       tr("Adds curves at a distance along the surface from the selected one, or from all, and "
          "returns their ids."),
       "meshId;distance;side", mesh + tr(";mesh units, above 0;both, left or right")},
      {"drawMode(bool)", tr("Begins or ends drawing with the mouse."), "on",
       tr("whether the mouse draws")},

      {"renameCurve(int,int,QString)", tr("Gives a curve a name."), "meshId;curve;name",
       curve + tr(";empty: none")},
      {"pinCurve(int,int,bool)", tr("Pins or unpins all points of a curve."), "meshId;curve;pinned",
       curve + tr(";whether the result passes through them")},
      {"continueCurve(int,int)",
       tr("Continues a curve at its end; the curve becomes the last one."), "meshId;curve", curve},
      {"setCurveTau(int,int,double)", tr("Gives a curve a tau of its own."), "meshId;curve;tau",
       curve + tr(";0 or more, negative: as all curves")},
      {"setCurveTolerance(int,int,double)", tr("Gives a curve a tolerance of its own."),
       "meshId;curve;tolerance", curve + tr(";mesh units, negative: none")},
      {"insertPoint(int,int,int,int,Vector)", tr("Inserts a point into a curve."),
       "meshId;curve;before;face;barycentric",
       curve + tr(";the index of the new point, from 0;face from 0;barycentric coordinates in the "
                  "face")},
      {"removePoint(int,int,int)", tr("Removes a point of a curve."), "meshId;curve;point",
       curve + tr(";from 0")},
      {"measureCurve(int,int,QString)", tr("One number of the report, for one curve."),
       "meshId;curve;key", curve + tr(";such as length_after")},

      {"colourBy(int,QString)", tr("Colours the curves or the mesh."), "meshId;what",
       mesh + tr(";nothing, deviation, distance or potential")},
      {"showComb(int,bool)", tr("Shows combs of curvature along the curves."), "meshId;with",
       mesh + tr(";whether the combs are shown")},
      {"largest(int,QString)", tr("Marks the place of the largest value, and returns the place."),
       "meshId;what", mesh + tr(";nothing, deviation or curvature")},
  };
}

}  // namespace

std::vector<ScriptSlot> script_help() { return ScriptHelp::all(); }

}  // namespace talweg::openflipper
