#include "drawing_json.hpp"

#include <memory>
#include <optional>

namespace talweg::browser {
namespace {

Json number_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json point_json(const editing::Point& point) {
  return {{"face", point.face},
          {"barycentric", point.barycentric},
          {"pinned", point.pinned},
          {"exact", point.exact}};
}

Json offset_json(const editing::Offset& offset) {
  return {{"on", offset.on},
          {"of", offset.of ? Json(*offset.of) : Json(nullptr)},
          {"distance", offset.distance},
          {"side", offset.side},
          {"caps", offset.caps}};
}

}  // namespace

std::optional<double> optional_of(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

editing::Point point_of(const Json& json) {
  const auto barycentric = json.at("barycentric").get<std::array<double, 3>>();
  editing::Point point = editing::picked(json.at("face").get<std::uint32_t>(), barycentric);
  point.pinned = json.value("pinned", false);
  point.exact = json.value("exact", point.exact);
  return point;
}

editing::Curve curve_of(const Json& json) {
  editing::Curve curve;
  for (const Json& point : json.at("points")) curve.points.push_back(point_of(point));
  curve.closed = json.at("closed").get<bool>();
  curve.tau = optional_of(json.value("tau", Json()));
  curve.tolerance = optional_of(json.value("tolerance", Json()));
  curve.name = json.value("name", "");
  curve.number = json.value("number", 0U);
  return curve;
}

editing::Offset offset_of(const Json& json) {
  editing::Offset offset;
  offset.on = json.at("on").get<bool>();
  if (!json.at("of").is_null()) offset.of = json.at("of").get<std::uint32_t>();
  offset.distance = json.at("distance").get<double>();
  offset.side = json.at("side").get<std::string>();
  offset.caps = json.at("caps").get<std::string>();
  return offset;
}

editing::Drawing drawing_of(const Json& json) {
  editing::Drawing drawing;
  for (const Json& curve : json.at("curves")) {
    drawing.curves.push_back(std::make_shared<const editing::Curve>(curve_of(curve)));
  }
  drawing.unfinished = json.at("unfinished").get<bool>();
  const Json& settings = json.at("settings");
  drawing.settings = {settings.at("tau").get<double>(),
                      optional_of(settings.at("slack")),
                      optional_of(settings.at("maxDeviation")),
                      settings.value("paper", false),
                      editing::ends_named(settings.value("ends", "auto")),
                      optional_of(settings.value("clickDistance", Json())),
                      settings.value("ridges", 0.0),
                      editing::ridges_named(settings.value("ridgeKind", "both"))};
  if (json.contains("offset")) drawing.offset = offset_of(json.at("offset"));
  return drawing;
}

Json json_of(const editing::Curve& curve) {
  Json points = Json::array();
  for (const editing::Point& point : curve.points) points.push_back(point_json(point));
  return {{"points", std::move(points)},
          {"closed", curve.closed},
          {"tau", number_json(curve.tau)},
          {"tolerance", number_json(curve.tolerance)},
          {"name", curve.name},
          {"number", curve.number}};
}

Json json_of(const editing::Drawing& drawing) {
  Json curves = Json::array();
  for (const auto& curve : drawing.curves) curves.push_back(json_of(*curve));
  return {{"curves", std::move(curves)},
          {"unfinished", drawing.unfinished},
          {"settings",
           {{"tau", drawing.settings.tau},
            {"slack", number_json(drawing.settings.slack)},
            {"maxDeviation", number_json(drawing.settings.max_deviation)},
            {"paper", drawing.settings.paper},
            {"ends", editing::name_of(drawing.settings.ends)},
            {"clickDistance", number_json(drawing.settings.click_distance)},
            {"ridges", drawing.settings.ridges},
            {"ridgeKind", editing::name_of(drawing.settings.ridge_kind)}}},
          {"offset", offset_json(drawing.offset)}};
}

}  // namespace talweg::browser
