#include "tools/picture/arguments.hpp"

#include <charconv>
#include <cstdint>
#include <sstream>
#include <vector>

#include "talweg/intrinsic/error.hpp"

namespace talweg::picture {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

[[noreturn]] void refuse(const std::string& text, const std::string& wanted) {
  throw Error(ErrorCode::kBadUsage, "\"" + text + "\" is not " + wanted);
}

double number(const std::string& text, const std::string& whole, const std::string& wanted) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) refuse(whole, wanted);
  return value;
}

bool hex_color(const std::string& text, Color& color) {
  std::uint32_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, 16);
  if (text.size() != 6 || error != std::errc{} || stop != end) return false;
  color = {double(value >> 16U) / 255, double((value >> 8U) & 255U) / 255,
           double(value & 255U) / 255};
  return true;
}

}  // namespace

CurveArgument curve_argument(const std::string& text) {
  const std::string wanted = "FILE[:rrggbb[:width]]";
  CurveArgument result;
  std::vector<std::string> parts = split(text, ':');
  // Parsed from the end, since a file name may contain colons.
  if (parts.size() > 2 && hex_color(parts[parts.size() - 2], result.color)) {
    result.width = number(parts.back(), text, wanted);
    parts.resize(parts.size() - 2);
  } else if (parts.size() > 1 && hex_color(parts.back(), result.color)) {
    parts.pop_back();
  }
  for (const std::string& part : parts) {
    if (!result.file.empty()) result.file += ':';
    result.file += part;
  }
  if (result.file.empty() || !(result.width > 0)) refuse(text, wanted);
  return result;
}

Point direction_argument(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 3) refuse(text, "a direction x,y,z");
  Point direction;
  for (int k = 0; k < 3; ++k) {
    direction[k] = number(parts[static_cast<std::size_t>(k)], text, "a direction x,y,z");
  }
  return direction;
}

Fit fit_argument(const std::string& text) {
  if (text == "auto") return Fit::kAuto;
  if (text == "curve") return Fit::kCurve;
  if (text == "mesh") return Fit::kMesh;
  if (text == "detail") return Fit::kDetail;
  refuse(text, "auto, curve, mesh or detail");
}

PanelArgument panel_argument(const std::string& text) {
  const std::string wanted =
      "a panel CAPTION[|curves=1,2][|fit=FIT][|zoom=Z][|view=x,y,z][|at=x,y,z][|mesh=FILE]"
      "[|labels=FILE][|move=x,y,z]";
  PanelArgument panel;
  const std::vector<std::string> parts = split(text, '|');
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t equal = parts[i].find('=');
    if (i == 0) {
      panel.caption = parts[i];
      continue;
    }
    if (equal == std::string::npos) refuse(text, wanted);
    const std::string name = parts[i].substr(0, equal), value = parts[i].substr(equal + 1);
    if (name == "fit") {
      panel.fit = fit_argument(value);
    } else if (name == "zoom") {
      panel.zoom = number(value, text, wanted);
    } else if (name == "view") {
      panel.view = direction_argument(value);
    } else if (name == "at") {
      panel.at = direction_argument(value);
    } else if (name == "mesh") {
      panel.mesh = value;
    } else if (name == "labels") {
      panel.labels = value;
    } else if (name == "move") {
      panel.move = direction_argument(value);
    } else if (name == "curves" && value == "none") {
      panel.no_curves = true;
    } else if (name == "curves") {
      for (const std::string& item : split(value, ',')) {
        const double curve = number(item, text, wanted);
        if (!(curve >= 1 && curve <= 1e6)) refuse(text, wanted);
        panel.curves.push_back(static_cast<std::size_t>(curve) - 1);
      }
    } else {
      refuse(text, wanted);
    }
  }
  return panel;
}

}  // namespace talweg::picture
