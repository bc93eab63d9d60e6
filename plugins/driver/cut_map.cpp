#include "cut_map.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <nlohmann/json.hpp>

namespace talweg::driver {
namespace {

using nlohmann::json;

/// [vertex], [a, b, part from a to b] or [a, b, c, barycentrics]; null for a point inside a lid.
json vertex_json(const VertexOrigin& from) {
  const auto end = std::find(from.vertices.begin(), from.vertices.end(), kNoVertex);
  const auto corners = static_cast<std::size_t>(end - from.vertices.begin());
  if (corners == 0) return nullptr;
  json list = json::array();
  for (std::size_t k = 0; k < corners; ++k) list.push_back(from.vertices[k]);
  if (corners == 2) list.push_back(from.weights[1]);
  if (corners == 3) {
    for (const double weight : from.weights) list.push_back(weight);
  }
  return list;
}

json part_json(const PartOrigins& part, const std::string& file) {
  json vertices = json::array(), faces = json::array(), curves = json::array();
  for (const VertexOrigin& from : part.vertices) vertices.push_back(vertex_json(from));
  for (const std::uint32_t face : part.faces) {
    faces.push_back(face == kNoFace ? json(nullptr) : json(face));
  }
  for (const PartOrigins::Curve& curve : part.curves) {
    curves.push_back({{"closed", curve.closed}, {"vertices", curve.vertices}});
  }
  return {{"file", file},
          {"vertices", std::move(vertices)},
          {"faces", std::move(faces)},
          {"curves", std::move(curves)}};
}

}  // namespace

std::string cut_map_json(std::span<const PartOrigins> parts, std::span<const std::string> files) {
  json map = {{"format", "talweg-cut"}, {"version", 1}, {"parts", json::array()}};
  for (std::size_t k = 0; k < parts.size(); ++k) {
    map["parts"].push_back(part_json(parts[k], files[k]));
  }
  // JSON must be UTF-8, but the name of a file need not be.
  return map.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace talweg::driver
