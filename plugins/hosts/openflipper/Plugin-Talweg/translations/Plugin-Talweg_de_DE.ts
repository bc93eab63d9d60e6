<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>Edits</name>
    <message>
        <source>Kind of ridges</source>
        <translation>Art der Grate</translation>
    </message>
    <message>
        <source>Snap to ridges</source>
        <translation>An Grate ziehen</translation>
    </message>
    <message>
        <source>Add curve</source>
        <translation>Kurve hinzufügen</translation>
    </message>
    <message>
        <source>Add curves</source>
        <translation>Kurven hinzufügen</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Click distance</source>
        <translation>Abstand von Klicks</translation>
    </message>
    <message>
        <source>Close curve</source>
        <translation>Kurve schließen</translation>
    </message>
    <message>
        <source>Continue curve</source>
        <translation>Kurve weiterzeichnen</translation>
    </message>
    <message>
        <source>Curves from faces</source>
        <translation>Kurven aus Dreiecken</translation>
    </message>
    <message>
        <source>Curves from selection</source>
        <translation>Kurven aus Auswahl</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Drop curve</source>
        <translation>Kurve verwerfen</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Enden</translation>
    </message>
    <message>
        <source>Finish curve</source>
        <translation>Kurve beenden</translation>
    </message>
    <message>
        <source>Insert point</source>
        <translation>Punkt einfügen</translation>
    </message>
    <message>
        <source>Largest deviation</source>
        <translation>Größte Abweichung</translation>
    </message>
    <message>
        <source>Move point</source>
        <translation>Punkt verschieben</translation>
    </message>
    <message>
        <source>Open curve</source>
        <translation>Kurve öffnen</translation>
    </message>
    <message>
        <source>Pin curve</source>
        <translation>Kurve festhalten</translation>
    </message>
    <message>
        <source>Pin point</source>
        <translation>Punkt festhalten</translation>
    </message>
    <message>
        <source>Remove all curves</source>
        <translation>Alle Kurven entfernen</translation>
    </message>
    <message>
        <source>Remove curve</source>
        <translation>Kurve entfernen</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>Punkt entfernen</translation>
    </message>
    <message>
        <source>Rename curve</source>
        <translation>Kurve umbenennen</translation>
    </message>
    <message>
        <source>Reverse curve</source>
        <translation>Kurve umkehren</translation>
    </message>
    <message>
        <source>Slack</source>
        <translation>Spielraum</translation>
    </message>
    <message>
        <source>Take back point</source>
        <translation>Punkt zurücknehmen</translation>
    </message>
    <message>
        <source>Tau</source>
        <translation>Tau</translation>
    </message>
    <message>
        <source>Tau of curve</source>
        <translation>Tau der Kurve</translation>
    </message>
    <message>
        <source>Tolerance of curve</source>
        <translation>Toleranz der Kurve</translation>
    </message>
    <message>
        <source>Unpin curve</source>
        <translation>Kurve lösen</translation>
    </message>
    <message>
        <source>Unpin point</source>
        <translation>Punkt lösen</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>units</source>
        <translation>Einh.</translation>
    </message>
    <message>
        <source>1/unit</source>
        <translation>1/Einh.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length of all curves together, in mesh units.</source>
        <translation>Länge aller Kurven zusammen, in Einheiten des Netzes.</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>The sum of all turns of the curves.</source>
        <translation>Die Summe aller Drehungen der Kurven.</translation>
    </message>
    <message>
        <source>Sharpest turn</source>
        <translation>Schärfste Wendung</translation>
    </message>
    <message>
        <source>The most that a curve turns within the length of a mesh edge.</source>
        <translation>Die größte Drehung einer Kurve auf der Länge einer Netzkante.</translation>
    </message>
    <message>
        <source>Bending</source>
        <translation>Biegung</translation>
    </message>
    <message>
        <source>Curvature squared, along the curves.</source>
        <translation>Krümmung im Quadrat, entlang der Kurven.</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>How far the drawing gets from the result, and the result from the drawing, at most.</source>
        <translation>Wie weit sich die Zeichnung höchstens vom Ergebnis entfernt, und das Ergebnis von der Zeichnung.</translation>
    </message>
    <message>
        <source>Nothing is smoothed yet.</source>
        <translation>Noch ist nichts geglättet.</translation>
    </message>
    <message>
        <source>converged</source>
        <translation>konvergiert</translation>
    </message>
    <message>
        <source>a loop collapsed</source>
        <translation>eine Schleife ist zusammengefallen</translation>
    </message>
    <message>
        <source>stopped at its limit</source>
        <translation>an der Grenze angehalten</translation>
    </message>
    <message>
        <source>%1 after %2 ms</source>
        <translation>%1 nach %2 ms</translation>
    </message>
    <message>
        <source>tau %1, slack %2</source>
        <translation>Tau %1, Spielraum %2</translation>
    </message>
</context>
<context>
    <name>Rows</name>
    <message>
        <source>Curve %1</source>
        <translation>Kurve %1</translation>
    </message>
</context>
<context>
    <name>ScriptHelp</name>
    <message>
        <source>How strongly ridges beside the drawing attract it.</source>
        <translation>Wie stark Grate neben der Zeichnung sie anziehen.</translation>
    </message>
    <message>
        <source>;0 (not at all) to 1</source>
        <translation>;0 (gar nicht) bis 1</translation>
    </message>
    <message>
        <source>The kind of ridges that attract the drawing.</source>
        <translation>Die Art der Grate, die die Zeichnung anziehen.</translation>
    </message>
    <message>
        <source>;both, convex: ridges, concave: valleys</source>
        <translation>;both: beide, convex: Grate, concave: Täler</translation>
    </message>
    <message>
        <source>Adds curves at a distance along the surface from the selected one, or from all, and returns their ids.</source>
        <translation>Fügt Kurven in einem Abstand entlang der Fläche von der gewählten oder von allen hinzu und gibt ihre Nummern zurück.</translation>
    </message>
    <message>
        <source>;mesh units, above 0;both, left or right</source>
        <translation>;Einheiten des Netzes, über 0;both, left oder right</translation>
    </message>
    <message>
        <source>id of a triangle mesh</source>
        <translation>Nummer eines Dreiecksnetzes</translation>
    </message>
    <message>
        <source>;from 0</source>
        <translation>;ab 0</translation>
    </message>
    <message>
        <source>;curve, from 0;point, from 0;</source>
        <translation>;Kurve, ab 0;Punkt, ab 0;</translation>
    </message>
    <message>
        <source>Adds a curve through vertices, straight over the faces.</source>
        <translation>Fügt eine Kurve durch Ecken hinzu, gerade über die Dreiecke.</translation>
    </message>
    <message>
        <source>;vertices from 0;whether the curve is closed</source>
        <translation>;Ecken ab 0;ob die Kurve geschlossen ist</translation>
    </message>
    <message>
        <source>Adds a point to the curve that is being drawn.</source>
        <translation>Fügt der Kurve, die gezeichnet wird, einen Punkt hinzu.</translation>
    </message>
    <message>
        <source>;face from 0;barycentric coordinates in the face</source>
        <translation>;Dreieck ab 0;baryzentrische Koordinaten im Dreieck</translation>
    </message>
    <message>
        <source>Ends the curve that is being drawn.</source>
        <translation>Beendet die Kurve, die gezeichnet wird.</translation>
    </message>
    <message>
        <source>Closes the curve that is being drawn.</source>
        <translation>Schließt die Kurve, die gezeichnet wird.</translation>
    </message>
    <message>
        <source>Takes the last point back.</source>
        <translation>Nimmt den letzten Punkt zurück.</translation>
    </message>
    <message>
        <source>Drops the curve that is being drawn.</source>
        <translation>Verwirft die Kurve, die gezeichnet wird.</translation>
    </message>
    <message>
        <source>Curves from selected vertices or edges.</source>
        <translation>Kurven aus ausgewählten Ecken oder Kanten.</translation>
    </message>
    <message>
        <source>Curves along the border of the selected faces.</source>
        <translation>Kurven am Rand der ausgewählten Dreiecke.</translation>
    </message>
    <message>
        <source>Curves along the borders between face colours.</source>
        <translation>Kurven an den Grenzen zwischen Dreiecksfarben.</translation>
    </message>
    <message>
        <source>A curve from a polyline, put onto the mesh.</source>
        <translation>Eine Kurve aus einer Linie, auf das Netz gelegt.</translation>
    </message>
    <message>
        <source>;id of a polyline</source>
        <translation>;Nummer einer Linie</translation>
    </message>
    <message>
        <source>Removes a curve.</source>
        <translation>Entfernt eine Kurve.</translation>
    </message>
    <message>
        <source>Removes all curves.</source>
        <translation>Entfernt alle Kurven.</translation>
    </message>
    <message>
        <source>Moves a drawn point.</source>
        <translation>Verschiebt einen gezeichneten Punkt.</translation>
    </message>
    <message>
        <source>face from 0;barycentric coordinates in the face</source>
        <translation>Dreieck ab 0;baryzentrische Koordinaten im Dreieck</translation>
    </message>
    <message>
        <source>Pins a drawn point, or unpins it.</source>
        <translation>Hält einen gezeichneten Punkt fest oder löst ihn.</translation>
    </message>
    <message>
        <source>whether the result passes through it</source>
        <translation>ob das Ergebnis durch ihn geht</translation>
    </message>
    <message>
        <source>Closes or opens a curve.</source>
        <translation>Schließt oder öffnet eine Kurve.</translation>
    </message>
    <message>
        <source>;from 0;whether the curve is closed</source>
        <translation>;ab 0;ob die Kurve geschlossen ist</translation>
    </message>
    <message>
        <source>0: straight lines; higher values keep closer to the drawing.</source>
        <translation>0: gerade Linien; höhere Werte bleiben näher an der Zeichnung.</translation>
    </message>
    <message>
        <source>;0 or more</source>
        <translation>;0 oder mehr</translation>
    </message>
    <message>
        <source>How exact the drawing is.</source>
        <translation>Wie genau die Zeichnung ist.</translation>
    </message>
    <message>
        <source>;mesh units, negative: from the drawing</source>
        <translation>;Einheiten des Netzes, negativ: aus der Zeichnung</translation>
    </message>
    <message>
        <source>The largest deviation; chooses tau and slack.</source>
        <translation>Die größte Abweichung; wählt Tau und Spielraum.</translation>
    </message>
    <message>
        <source>;mesh units, 0: no bound</source>
        <translation>;Einheiten des Netzes, 0: keine Grenze</translation>
    </message>
    <message>
        <source>The treatment of the ends of curves that are not closed.</source>
        <translation>Die Behandlung der Enden von Kurven, die nicht geschlossen sind.</translation>
    </message>
    <message>
        <source>;auto: painted strokes that return to their start are loops, closed: all curves are loops, open: none</source>
        <translation>;auto: gemalte Striche, die zu ihrem Anfang zurückkehren, sind geschlossen, closed: alle Kurven, open: keine</translation>
    </message>
    <message>
        <source>Successive clicks within this distance are merged.</source>
        <translation>Aufeinander folgende Klicks in diesem Abstand werden zu einem.</translation>
    </message>
    <message>
        <source>;mesh units, negative: an edge of the mesh</source>
        <translation>;Einheiten des Netzes, negativ: eine Kante des Netzes</translation>
    </message>
    <message>
        <source>Takes the last edit back.</source>
        <translation>Nimmt die letzte Änderung zurück.</translation>
    </message>
    <message>
        <source>Repeats the edit that was taken back.</source>
        <translation>Wiederholt die zurückgenommene Änderung.</translation>
    </message>
    <message>
        <source>Draws on the mesh as if it was repaired, if it is not a surface; the mesh itself is unchanged.</source>
        <translation>Zeichnet auf dem Netz, als wäre es repariert, wenn es keine Fläche ist; das Netz selbst bleibt unverändert.</translation>
    </message>
    <message>
        <source>Waits for the smoothed curves and returns their polylines&apos; ids.</source>
        <translation>Wartet auf die geglätteten Kurven und gibt die Nummern ihrer Linien zurück.</translation>
    </message>
    <message>
        <source>Everything that was measured, one &quot;key = value&quot; a line.</source>
        <translation>Alles Gemessene, ein „Schlüssel = Wert“ je Zeile.</translation>
    </message>
    <message>
        <source>One number of the report, for all curves together.</source>
        <translation>Eine Zahl des Berichts, für alle Kurven zusammen.</translation>
    </message>
    <message>
        <source>;such as length_after</source>
        <translation>;etwa length_after</translation>
    </message>
    <message>
        <source>Why the last edit or smoothing failed; empty if it did not.</source>
        <translation>Warum die letzte Änderung oder Glättung misslang; leer, wenn nicht.</translation>
    </message>
    <message>
        <source>Writes the smoothed curves.</source>
        <translation>Schreibt die geglätteten Kurven.</translation>
    </message>
    <message>
        <source>;.json, .vtp, .vtk, .obj, .ply, .mrk.json</source>
        <translation>;.json, .vtp, .vtk, .obj, .ply, .mrk.json</translation>
    </message>
    <message>
        <source>Writes the drawn points.</source>
        <translation>Schreibt die gezeichneten Punkte.</translation>
    </message>
    <message>
        <source>;as writeResult</source>
        <translation>;wie writeResult</translation>
    </message>
    <message>
        <source>Adds the curves of a file.</source>
        <translation>Fügt die Kurven einer Datei hinzu.</translation>
    </message>
    <message>
        <source>;as writeResult, or .txt</source>
        <translation>;wie writeResult, oder .txt</translation>
    </message>
    <message>
        <source>Makes the smoothed curves edges of the mesh, and selects them.</source>
        <translation>Macht die geglätteten Kurven zu Kanten des Netzes und wählt sie aus.</translation>
    </message>
    <message>
        <source>Cuts, and selects the faces inside the closed curves.</source>
        <translation>Schneidet und wählt die Dreiecke in den geschlossenen Kurven aus.</translation>
    </message>
    <message>
        <source>Makes a mesh of each part between the smoothed curves.</source>
        <translation>Macht aus jedem Teil zwischen den geglätteten Kurven ein Netz.</translation>
    </message>
    <message>
        <source>;whether the parts are closed where they were cut</source>
        <translation>;ob die Teile am Schnitt geschlossen werden</translation>
    </message>
    <message>
        <source>Begins or ends drawing with the mouse.</source>
        <translation>Beginnt oder beendet das Zeichnen mit der Maus.</translation>
    </message>
    <message>
        <source>whether the mouse draws</source>
        <translation>ob die Maus zeichnet</translation>
    </message>
    <message>
        <source>Gives a curve a name.</source>
        <translation>Gibt einer Kurve einen Namen.</translation>
    </message>
    <message>
        <source>;empty: none</source>
        <translation>;leer: keiner</translation>
    </message>
    <message>
        <source>Pins or unpins all points of a curve.</source>
        <translation>Hält alle Punkte einer Kurve fest oder gibt sie frei.</translation>
    </message>
    <message>
        <source>;whether the result passes through them</source>
        <translation>;ob das Ergebnis durch sie verläuft</translation>
    </message>
    <message>
        <source>Continues a curve at its end; the curve becomes the last one.</source>
        <translation>Zeichnet am Ende einer Kurve weiter, die dann die letzte ist.</translation>
    </message>
    <message>
        <source>Gives a curve a tau of its own.</source>
        <translation>Gibt einer Kurve ein eigenes Tau.</translation>
    </message>
    <message>
        <source>;0 or more, negative: as all curves</source>
        <translation>;0 oder mehr, negativ: wie alle Kurven</translation>
    </message>
    <message>
        <source>Gives a curve a tolerance of its own.</source>
        <translation>Gibt einer Kurve eine eigene Toleranz.</translation>
    </message>
    <message>
        <source>;mesh units, negative: none</source>
        <translation>;Netzeinheiten, negativ: keine</translation>
    </message>
    <message>
        <source>Inserts a point into a curve.</source>
        <translation>Fügt einen Punkt in eine Kurve ein.</translation>
    </message>
    <message>
        <source>;the index of the new point, from 0;face from 0;barycentric coordinates in the face</source>
        <translation>;der Index des neuen Punkts, ab 0;Dreieck ab 0;baryzentrische Koordinaten im Dreieck</translation>
    </message>
    <message>
        <source>Removes a point of a curve.</source>
        <translation>Entfernt einen Punkt einer Kurve.</translation>
    </message>
    <message>
        <source>One number of the report, for one curve.</source>
        <translation>Eine Zahl des Berichts, für eine Kurve.</translation>
    </message>
    <message>
        <source>Colours the curves or the mesh.</source>
        <translation>Färbt die Kurven oder das Netz.</translation>
    </message>
    <message>
        <source>;nothing, deviation, distance or potential</source>
        <translation>;nothing, deviation, distance oder potential</translation>
    </message>
    <message>
        <source>Shows combs of curvature along the curves.</source>
        <translation>Zeigt Krümmungskämme entlang der Kurven.</translation>
    </message>
    <message>
        <source>;whether the combs are shown</source>
        <translation>;ob die Kämme gezeigt werden</translation>
    </message>
    <message>
        <source>Marks the place of the largest value, and returns the place.</source>
        <translation>Markiert die Stelle des größten Werts und gibt sie zurück.</translation>
    </message>
    <message>
        <source>;nothing, deviation or curvature</source>
        <translation>;nothing, deviation oder curvature</translation>
    </message>
</context>
<context>
    <name>Session</name>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 ist geschrieben.</translation>
    </message>
</context>
<context>
    <name>Sessions</name>
    <message>
        <source>There is no triangle mesh with the id %1.</source>
        <translation>Es gibt kein Dreiecksnetz mit der Nummer %1.</translation>
    </message>
    <message>
        <source>Make a triangle mesh the target first.</source>
        <translation>Machen Sie zuerst ein Dreiecksnetz zum Ziel (Target).</translation>
    </message>
</context>
<context>
    <name>TalwegPlugin</name>
    <message>
        <source>There is no polyline with the id %1.</source>
        <translation>Es gibt keine Linie mit der Nummer %1.</translation>
    </message>
    <message>
        <source>Colours are: %1.</source>
        <translation>Farben sind: %1.</translation>
    </message>
    <message>
        <source>largest() takes the id of a mesh with a drawing, and one of: %1.</source>
        <translation>largest() erwartet die Nummer eines Netzes mit einer Zeichnung und eines von: %1.</translation>
    </message>
    <message>
        <source>Draws curves on meshes and smooths them while they stay close to the drawing.</source>
        <translation>Zeichnet Kurven auf Netze und glättet sie nah an der Zeichnung.</translation>
    </message>
</context>
<context>
    <name>UnderMouse</name>
    <message>
        <source>Make this mesh the target to draw on it.</source>
        <translation>Machen Sie dieses Netz zum Ziel (Target), um darauf zu zeichnen.</translation>
    </message>
</context>
<context>
    <name>talweg::openflipper::CurveTable</name>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Double click a name to change it.</source>
        <translation>Doppelklick auf einen Namen ändert ihn.</translation>
    </message>
    <message>
        <source>Length of the smoothed curve, in mesh units.</source>
        <translation>Länge der geglätteten Kurve, in Netzeinheiten.</translation>
    </message>
    <message>
        <source>The largest distance between result and drawing, in either direction, in mesh units.</source>
        <translation>Der größte Abstand zwischen Ergebnis und Zeichnung, in beiden Richtungen, in Netzeinheiten.</translation>
    </message>
    <message>
        <source>The sum of all turns of the smoothed curve.</source>
        <translation>Die Summe aller Drehungen der geglätteten Kurve.</translation>
    </message>
</context>
<context>
    <name>talweg::openflipper::CurvesBox</name>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Adds the curves of a file.</source>
        <translation>Fügt die Kurven einer Datei hinzu.</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Writes the drawn points; .json keeps which were clicked and pinned.</source>
        <translation>Schreibt die gezeichneten Punkte; .json behält, welche geklickt und festgehalten sind.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the selected curve (Del).</source>
        <translation>Entfernt die ausgewählte Kurve (Entf).</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Alle entfernen</translation>
    </message>
    <message>
        <source>Removes all curves of this mesh.</source>
        <translation>Entfernt alle Kurven dieses Netzes.</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Pins or unpins all points of the selected curve.</source>
        <translation>Hält alle Punkte der ausgewählten Kurve fest oder gibt sie frei.</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Closes the selected curve, or opens it.</source>
        <translation>Schließt die ausgewählte Kurve oder öffnet sie.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Continues the selected curve at its end.</source>
        <translation>Zeichnet am Ende der ausgewählten Kurve weiter.</translation>
    </message>
    <message>
        <source>Own tau</source>
        <translation>Eigenes Tau</translation>
    </message>
    <message>
        <source>Tau of the selected curve alone. Unticked: the tau of all curves.</source>
        <translation>Tau nur der ausgewählten Kurve. Ohne Haken: das Tau aller Kurven.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>How far the selected curve may pass from its clicked points, and how exact its strokes are. Unticked: clicked points are exact.</source>
        <translation>Wie weit die ausgewählte Kurve an ihren geklickten Punkten vorbeigehen darf und wie genau ihre Striche sind. Ohne Haken: Geklickte Punkte gelten genau.</translation>
    </message>
    <message>
        <source>units</source>
        <translation>Einh.</translation>
    </message>
    <message>
        <source>Select a curve in the list or in the scene.</source>
        <translation>Wählen Sie eine Kurve in der Liste oder in der Szene aus.</translation>
    </message>
</context>
<context>
    <name>talweg::openflipper::DrawingHand</name>
    <message>
        <source>Click or paint; Enter ends, the first point closes, Backspace takes back, Esc discards. The wheel zooms, the middle button moves, the right one turns.</source>
        <translation>Klicken oder malen; Eingabe beendet, der erste Punkt schließt, Rücktaste nimmt zurück, Esc verwirft. Das Rad zoomt, die mittlere Taste verschiebt, die rechte dreht.</translation>
    </message>
    <message>
        <source>Click or paint on the target mesh to draw. The wheel zooms, the middle button moves, the right one turns.</source>
        <translation>Zum Zeichnen auf das Zielnetz klicken oder malen. Das Rad zoomt, die mittlere Taste verschiebt, die rechte dreht.</translation>
    </message>
    <message>
        <source>Click to close the curve.</source>
        <translation>Klick schließt die Kurve.</translation>
    </message>
    <message>
        <source>Drag to move, double click to pin, Shift-click to remove.</source>
        <translation>Ziehen verschiebt, Doppelklick hält fest, Umschalt-Klick entfernt.</translation>
    </message>
    <message>
        <source>Ctrl-click to insert a point.</source>
        <translation>Strg-Klick fügt einen Punkt ein.</translation>
    </message>
    <message>
        <source>Click to select the curve, Ctrl-click to insert a point; paint to draw.</source>
        <translation>Klick wählt die Kurve aus, Strg-Klick fügt einen Punkt ein; Malen zeichnet.</translation>
    </message>
</context>
<context>
    <name>talweg::openflipper::HostLink</name>
    <message>
        <source>Talweg</source>
        <translation>Talweg</translation>
    </message>
    <message>
        <source>Draw on this mesh</source>
        <translation>Auf diesem Netz zeichnen</translation>
    </message>
    <message>
        <source>Curves from its selection</source>
        <translation>Kurven aus seiner Auswahl</translation>
    </message>
    <message>
        <source>Smooth this line on the target mesh</source>
        <translation>Diese Linie auf dem Zielnetz glätten</translation>
    </message>
    <message>
        <source>Talweg on %1</source>
        <translation>Talweg auf %1</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
</context>
<context>
    <name>talweg::openflipper::LookBox</name>
    <message>
        <source>No colours</source>
        <translation>Keine Farben</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Potential</source>
        <translation>Potential</translation>
    </message>
    <message>
        <source>Deviation from the drawing along the curves; distance to the drawing or potential on the mesh.</source>
        <translation>Abweichung von der Zeichnung entlang der Kurven; Abstand zur Zeichnung oder Potential auf dem Netz.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Hidden points cannot be moved; curves show as before.</source>
        <translation>Verborgene Punkte lassen sich nicht bewegen; Kurven bleiben sichtbar.</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>Kamm</translation>
    </message>
    <message>
        <source>Teeth across the curves, whose lengths show the curvature.</source>
        <translation>Zähne quer zu den Kurven, so lang wie sie dort gekrümmt sind.</translation>
    </message>
    <message>
        <source>Mark nothing</source>
        <translation>Nichts markieren</translation>
    </message>
    <message>
        <source>Largest deviation</source>
        <translation>Größte Abweichung</translation>
    </message>
    <message>
        <source>Largest curvature</source>
        <translation>Größte Krümmung</translation>
    </message>
    <message>
        <source>Marks the place of the largest value, and turns the view to it.</source>
        <translation>Markiert die Stelle des größten Werts und dreht die Ansicht dorthin.</translation>
    </message>
</context>
<context>
    <name>talweg::openflipper::OffsetRow</name>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Makes curves at this distance along the surface from the selected smoothed curve, or from all.</source>
        <translation>Macht Kurven in diesem Abstand entlang der Fläche von der gewählten geglätteten Kurve oder von allen.</translation>
    </message>
    <message>
        <source>The distance along the surface, in mesh units.</source>
        <translation>Der Abstand entlang der Fläche, in Einheiten des Netzes.</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>Beide Seiten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>The side as seen along the curve from outside; offsets on one side have no caps.</source>
        <translation>Die Seite, von außen entlang der Kurve gesehen; auf nur einer Seite gibt es keine Kappen.</translation>
    </message>
</context>
<context>
    <name>talweg::openflipper::PanelLink</name>
    <message>
        <source>up to %1 %2</source>
        <translation>bis %1 %2</translation>
    </message>
    <message>
        <source>Make a polyline the target first.</source>
        <translation>Machen Sie zuerst eine Linie (Polyline) zum Ziel (Target).</translation>
    </message>
    <message>
        <source>Curves (*.json *.vtp *.vtk *.obj *.ply *.mrk.json *.fcsv *.border *.txt)</source>
        <translation>Kurven (*.json *.vtp *.vtk *.obj *.ply *.mrk.json *.fcsv *.border *.txt)</translation>
    </message>
    <message>
        <source>Read curves</source>
        <translation>Kurven lesen</translation>
    </message>
    <message>
        <source>Write curves</source>
        <translation>Kurven schreiben</translation>
    </message>
</context>
<context>
    <name>talweg::openflipper::ResultTable</name>
    <message>
        <source>drawn</source>
        <translation>gezeichnet</translation>
    </message>
    <message>
        <source>smoothed</source>
        <translation>geglättet</translation>
    </message>
</context>
<context>
    <name>talweg::openflipper::TalwegPanel</name>
    <message>
        <source>Repair</source>
        <translation>Reparieren</translation>
    </message>
    <message>
        <source>Draws on the mesh as if it was repaired; the mesh itself is unchanged.</source>
        <translation>Zeichnet auf dem Netz, als wäre es repariert; das Netz selbst bleibt unverändert.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Draw on the target mesh: click points or paint.</source>
        <translation>Auf dem Zielnetz zeichnen: Punkte klicken oder malen.</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Ends the curve, open (Enter).</source>
        <translation>Beendet die Kurve, offen (Eingabe).</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes the curve (click its first point).</source>
        <translation>Schließt die Kurve (Klick auf ihren ersten Punkt).</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Removes the last point of the curve (Backspace).</source>
        <translation>Entfernt den letzten Punkt der Kurve (Rücktaste).</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Removes the curve that is being drawn (Esc).</source>
        <translation>Entfernt die Kurve, die gezeichnet wird (Esc).</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Curves from a selection, from face colours or from polylines.</source>
        <translation>Kurven aus einer Auswahl, aus Dreiecksfarben oder aus Linien.</translation>
    </message>
    <message>
        <source>Selected vertices or edges</source>
        <translation>Ausgewählte Ecken oder Kanten</translation>
    </message>
    <message>
        <source>Border of the selected faces</source>
        <translation>Rand der ausgewählten Dreiecke</translation>
    </message>
    <message>
        <source>Borders between face colours</source>
        <translation>Grenzen zwischen Dreiecksfarben</translation>
    </message>
    <message>
        <source>Target polylines</source>
        <translation>Ziel-Linien (Polylines)</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Tau</source>
        <translation>Tau</translation>
    </message>
    <message>
        <source>0: straight lines; higher values keep closer to the drawing, and are tighter between clicks.</source>
        <translation>0: gerade Linien; höhere Werte bleiben näher an der Zeichnung und sind zwischen Klicks straffer.</translation>
    </message>
    <message>
        <source>Slack</source>
        <translation>Spielraum</translation>
    </message>
    <message>
        <source>How exact the drawing is, in mesh units. Unticked: the width of the hand's tremor.</source>
        <translation>Wie genau die Zeichnung ist, in Einheiten des Netzes. Ohne Haken: die Breite des Zitterns der Hand.</translation>
    </message>
    <message>
        <source>units</source>
        <translation>Einh.</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Innerhalb</translation>
    </message>
    <message>
        <source>The smoothest curve that stays within this distance of the drawing, in mesh units; chooses tau and slack. Unticked: the present distance.</source>
        <translation>Die glatteste Kurve in diesem Abstand von der Zeichnung, in Einheiten des Netzes; wählt Tau und Spielraum. Ohne Haken: der jetzige Abstand.</translation>
    </message>
    <message>
        <source>One click</source>
        <translation>Ein Klick</translation>
    </message>
    <message>
        <source>Successive clicks within this distance are merged, in mesh units. Unticked: an edge of the mesh.</source>
        <translation>Aufeinander folgende Klicks in diesem Abstand werden zu einem, in Einheiten des Netzes. Ohne Haken: eine Kante des Netzes.</translation>
    </message>
    <message>
        <source>Ridges</source>
        <translation>Grate</translation>
    </message>
    <message>
        <source>How strongly ridges and valleys beside the drawing attract it: 0 not at all, 0.3 sharp edges only, 1 weak ones, too.</source>
        <translation>Wie stark Grate und Täler neben der Zeichnung sie anziehen: 0 gar nicht, 0,3 nur scharfe Kanten, 1 auch schwache.</translation>
    </message>
    <message>
        <source>Snap to</source>
        <translation>Anziehen</translation>
    </message>
    <message>
        <source>Ridges and valleys</source>
        <translation>Grate und Täler</translation>
    </message>
    <message>
        <source>Ridges, which stand out</source>
        <translation>Grate, die vorstehen</translation>
    </message>
    <message>
        <source>Valleys</source>
        <translation>Täler</translation>
    </message>
    <message>
        <source>The kind of ridges that attract the drawing.</source>
        <translation>Die Art der Grate, die die Zeichnung anziehen.</translation>
    </message>
    <message>
        <source>Returning strokes are loops</source>
        <translation>Rückkehrende Striche schließen</translation>
    </message>
    <message>
        <source>All curves are loops</source>
        <translation>Alle Kurven sind geschlossen</translation>
    </message>
    <message>
        <source>Open curves stay open</source>
        <translation>Offene Kurven bleiben offen</translation>
    </message>
    <message>
        <source>The treatment of the ends of curves that are not closed.</source>
        <translation>Die Behandlung der Enden von Kurven, die nicht geschlossen sind.</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Enden</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Makes the smoothed curves edges of the mesh, and selects them.</source>
        <translation>Macht die geglätteten Kurven zu Kanten des Netzes und wählt sie aus.</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Teilen</translation>
    </message>
    <message>
        <source>Makes a mesh of each part between the smoothed curves.</source>
        <translation>Macht aus jedem Teil zwischen den geglätteten Kurven ein Netz.</translation>
    </message>
    <message>
        <source>with lids</source>
        <translation>Deckel</translation>
    </message>
    <message>
        <source>Split closes the parts where they were cut.</source>
        <translation>Teilen schließt die Teile, wo sie geschnitten sind.</translation>
    </message>
    <message>
        <source>Select inside</source>
        <translation>Inneres</translation>
    </message>
    <message>
        <source>Cuts, and selects the faces inside the closed curves: the smaller side.</source>
        <translation>Schneidet und wählt die Dreiecke in den geschlossenen Kurven aus: die kleinere Seite.</translation>
    </message>
    <message>
        <source>Write result</source>
        <translation>Ergebnis schreiben</translation>
    </message>
    <message>
        <source>Writes the smoothed curves: .json, .vtp, .vtk, .obj, .ply, .mrk.json</source>
        <translation>Schreibt die geglätteten Kurven: .json, .vtp, .vtk, .obj, .ply, .mrk.json</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stops the computation.</source>
        <translation>Hält die Berechnung an.</translation>
    </message>
    <message>
        <source>No drawing yet.</source>
        <translation>Noch keine Zeichnung.</translation>
    </message>
    <message>
        <source>Takes the last edit back (Ctrl+Z): %1</source>
        <translation>Nimmt die letzte Änderung zurück (Strg+Z): %1</translation>
    </message>
    <message>
        <source>Repeats the edit that was taken back (Ctrl+Y): %1</source>
        <translation>Wiederholt die zurückgenommene Änderung (Strg+Y): %1</translation>
    </message>
    <message>
        <source>The curve is free between clicked points; this value is for painted strokes.</source>
        <translation>Zwischen geklickten Punkten ist die Kurve frei; dieser Wert gilt für gemalte Striche.</translation>
    </message>
    <message>
        <source>&quot;Within&quot; chooses it.</source>
        <translation>„Innerhalb“ wählt es.</translation>
    </message>
    <message>
        <source>%1
A repair for drawing would do this: %2</source>
        <translation>%1
Eine Reparatur zum Zeichnen täte dies: %2</translation>
    </message>
</context>
</TS>
