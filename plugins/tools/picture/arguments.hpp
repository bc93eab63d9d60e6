// Some of the renderer's command-line arguments have a form of their own.
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

/// Each of these throws Error(kBadUsage) that quotes what cannot be understood.
CurveArgument curve_argument(const std::string& text);
/// x,y,z
Point direction_argument(const std::string& text);
/// auto, curve, mesh or detail
Fit fit_argument(const std::string& text);

struct PanelArgument : Panel {
  std::string mesh;           ///< a file; empty: that of the picture
  std::string labels;         ///< a file, or "pieces"; empty: no colours
  bool no_curves = false;     ///< curves=none
  std::optional<Point> at;    ///< shown enlarged, mesh units
  std::optional<Point> move;  ///< by which all pieces but the largest are moved, mesh units
};
/// CAPTION[|curves=1,2|none][|fit=FIT][|zoom=Z][|view=x,y,z][|at=x,y,z][|mesh=FILE]
/// [|labels=FILE|pieces][|move=x,y,z]; curves are counted from 1.
PanelArgument panel_argument(const std::string& text);

}  // namespace talweg::picture
