// Converts drawings to and from the JSON of the page (src/engine/types.ts).
#pragma once

#include "answer.hpp"
#include "talweg/editing/drawing.hpp"

namespace talweg::browser {

editing::Point point_of(const Json& json);
editing::Curve curve_of(const Json& json);
editing::Offset offset_of(const Json& json);
editing::Drawing drawing_of(const Json& json);

Json json_of(const editing::Curve& curve);
Json json_of(const editing::Drawing& drawing);

/// A number; null becomes nothing.
std::optional<double> optional_of(const Json& json);

}  // namespace talweg::browser
