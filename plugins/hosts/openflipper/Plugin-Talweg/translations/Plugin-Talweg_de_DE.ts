<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>TalwegPlugin</name>
    <message>
        <source>Talweg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw on this mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves from its selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooth this line on the target mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no triangle mesh with the id %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a triangle mesh the target first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Talweg on %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a polyline the target first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves (*.json *.vtp *.vtk *.obj *.ply *.mrk.json *.txt)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make this mesh the target to draw on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click or paint; Enter ends, the first point closes, Backspace takes back, Esc drops.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click or paint on the target mesh to draw.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to close the curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to move, double click to pin, Shift-click to remove.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no polyline with the id %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours are: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>id of a triangle mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;curve, from 0;point, from 0;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a curve through vertices, straight over the faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;vertices from 0;whether it comes back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a point to the curve that is being drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;face from 0;its coordinates there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends the curve that is being drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes the curve that is being drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the last point back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drops the curve that is being drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves from selected vertices or edges.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A curve from a polyline, put onto the mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;id of a polyline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes a curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;from 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes all curves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves a drawn point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>face from 0;its coordinates there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pins a drawn point, or lets it go.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whether the result passes through it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes or opens a curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;from 0;whether it comes back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0: straight lines; more keeps closer to the drawing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;0 or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How exact the drawing is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;mesh units; negative: from the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest deviation; chooses tau and slack.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;mesh units, 0: no bound</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the last edit back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waits for the smoothed curves and returns their polylines&apos; ids.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything that was measured, one &quot;key = value&quot; a line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One number of the report, for all curves together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;such as length_after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why the last edit or smoothing failed; empty if it did not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours the curves or the mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;nothing, deviation, distance or potential</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the smoothed curves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;.json, .vtp, .vtk, .obj, .ply, .mrk.json</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the drawn points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;as writeResult</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds the curves of a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;as writeResult, or .txt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves tau to and fro and tells the time of a step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;how many</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begins or ends drawing with the mouse.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whether</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where a vertex is in the viewer, &quot;x y&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where a widget is on the screen, &quot;x y width height&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>such as talwegUndo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws curves on meshes and smooths them while they stay close to the drawing.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>talweg::openflipper::TalwegPanel</name>
    <message>
        <source>Draw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw on the target mesh: click points or paint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finish</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends the curve, open (Enter).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes the curve (click its first point).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the last point back (Backspace).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drops the curve that is being drawn (Esc).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves through the selected vertices or edges, ordered along the mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves from the target polylines, put onto it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes the last curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes all curves of this mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the last edit back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the smoothed curves: .json, .vtp, .vtk, .obj, .ply, .mrk.json</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the drawn points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads curves from a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops what is being computed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tau</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0: straight lines; more keeps closer to the drawing, and is tighter between clicks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between clicked points the curve is free; this is for painted ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slack</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How exact the drawing is, in mesh units; unticked: from its segments.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The smoothest curve that stays so near to the drawing, in mesh units; chooses tau and slack.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation on the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance on the mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Potential on the mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No drawing yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On %1, %2 curve(s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the last edit back: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does it again: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
