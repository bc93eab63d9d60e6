// Parses command-line arguments of the renderer that have several parts.
#pragma once

#include <optional>
#include <string>

#include "tools/picture/render.hpp"

namespace talweg::picture {

/// FILE[:rrggbb[:width]]; the colour in hexadecimal sRGB, the width in pixels.
struct CurveArgument {
  std::string file;
  Color color{0.1, 0.1, 0.1};
  double width = 5;
};

/// Each function throws Error(kBadUsage), which quotes an argument that cannot be parsed.
CurveArgument curve_argument(const std::string& text);
/// x,y,z
Point direction_argument(const std::string& text);
/// auto, curve, mesh or detail
Fit fit_argument(const std::string& text);

struct PanelArgument : Panel {
  std::string mesh;           ///< a file; empty: the picture's mesh
  std::string labels;         ///< a file, or "pieces"; empty: no colours
  bool no_curves = false;     ///< curves=none
  std::optional<Point> at;    ///< centre of an enlarged place, mesh units
  std::optional<Point> move;  ///< translation of all pieces but the largest, mesh units
};
/// CAPTION[|curves=1,2|none][|fit=FIT][|zoom=Z][|view=x,y,z][|at=x,y,z][|mesh=FILE]
/// [|labels=FILE|pieces][|move=x,y,z]; curves are counted from 1.
PanelArgument panel_argument(const std::string& text);

}  // namespace talweg::picture
