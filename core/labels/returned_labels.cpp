#include "talweg/core/labels/returned_labels.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

namespace talweg {
namespace {

/// The angle of a face at a corner, in radians.
double angle_at(const MeshLists& lists, const Triangle& t, std::size_t corner) {
  const Point& p = lists.points[t[corner]];
  const Point a = lists.points[t[(corner + 1) % 3]] - p;
  const Point b = lists.points[t[(corner + 2) % 3]] - p;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

struct CornerShare {
  std::uint32_t vertex;
  std::int64_t label;
  double angle;
};

/// The labels around each vertex with several labels, with their angles.
std::vector<CornerShare> shares_on_borders(const LabelNetwork& network,
                                           const std::vector<bool>& mixed) {
  std::vector<CornerShare> shares;
  const auto& triangles = network.cut.lists.triangles;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = triangles[f][c];
      if (v >= mixed.size() || !mixed[v]) continue;
      shares.push_back({v, network.cut_labels[f], angle_at(network.cut.lists, triangles[f], c)});
    }
  }
  std::stable_sort(shares.begin(), shares.end(), [](const CornerShare& a, const CornerShare& b) {
    return std::tie(a.vertex, a.label) < std::tie(b.vertex, b.label);
  });
  return shares;
}

std::vector<std::int64_t> sorted(std::span<const std::int64_t> labels) {
  std::vector<std::int64_t> result(labels.begin(), labels.end());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace

std::vector<std::int64_t> labels_of_vertices(const LabelNetwork& network, const Surface& surface,
                                             std::span<const std::int64_t> drawn) {
  const std::size_t n = surface.vertex_count();
  const bool of_faces = drawn.size() == surface.face_count();
  std::vector<std::int64_t> labels(n, 0);
  if (!of_faces) labels.assign(drawn.begin(), drawn.end());
  std::vector<bool> seen(n, false), mixed(n, false);
  std::vector<std::int64_t> around(n, 0);
  for (std::size_t f = 0; f < network.cut.lists.triangles.size(); ++f) {
    for (const std::uint32_t v : network.cut.lists.triangles[f]) {
      if (v >= n) continue;  // a new vertex of the cut mesh
      const std::int64_t label = network.cut_labels[f];
      if (seen[v] && around[v] != label) mixed[v] = true;
      seen[v] = true;
      around[v] = label;
    }
  }
  for (std::size_t v = 0; v < n; ++v) {
    if (seen[v] && !mixed[v]) labels[v] = around[v];
  }
  const std::vector<CornerShare> shares = shares_on_borders(network, mixed);
  for (std::size_t i = 0, next = 0; i < shares.size();) {
    const std::uint32_t v = shares[i].vertex;
    bool own = false;
    double most = -1;
    std::int64_t best = 0;
    for (; i < shares.size() && shares[i].vertex == v; i = next) {
      double angle = 0;
      for (next = i; next < shares.size() && shares[next].vertex == v &&
                     shares[next].label == shares[i].label;
           ++next) {
        angle += shares[next].angle;
      }
      own = own || (!of_faces && drawn[v] == shares[i].label);
      if (angle > most) best = shares[i].label;
      most = std::max(most, angle);
    }
    if (!own) labels[v] = best;
  }
  return labels;
}

std::vector<LostLabel> give_back(std::span<const std::int64_t> drawn,
                                 std::span<const std::int64_t> face_labels,
                                 std::vector<std::int64_t>& returned) {
  const std::vector<std::int64_t> of_faces = sorted(face_labels), there = sorted(returned);
  std::map<std::int64_t, LostLabel> lost;
  for (const std::int64_t label : sorted(drawn)) {
    const bool covers = std::binary_search(of_faces.begin(), of_faces.end(), label);
    if (covers && std::binary_search(there.begin(), there.end(), label)) continue;
    lost[label] = {label, 0, covers};
  }
  const bool same_elements = drawn.size() == returned.size();
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const auto found = lost.find(drawn[k]);
    if (found == lost.end()) continue;
    ++found->second.elements;
    if (same_elements) returned[k] = drawn[k];
  }
  std::vector<LostLabel> list;
  list.reserve(lost.size());
  for (const auto& [label, entry] : lost) list.push_back(entry);
  return list;
}

std::string note_on_lost(const std::vector<LostLabel>& lost, bool by_face, bool of_faces,
                         const LabelNames& names) {
  constexpr std::size_t kNamed = 5;
  const bool one = lost.size() == 1;
  std::string list;
  for (std::size_t k = 0; k < std::min(lost.size(), kNamed); ++k) {
    const LostLabel& label = lost[k];
    const auto found = names.find(label.label);
    const std::string name = found == names.end() ? "" : fmt::format("{}, ", found->second);
    const char* element = by_face ? (label.elements == 1 ? "face" : "faces")
                                  : (label.elements == 1 ? "vertex" : "vertices");
    const char* separator = k == 0 ? "" : k + 1 == lost.size() ? " and " : ", ";
    list += fmt::format("{}{} ({}{} {})", separator, label.label, name, label.elements, element);
  }
  if (lost.size() > kNamed) list += fmt::format(" and {} more", lost.size() - kNamed);
  const bool covers = std::any_of(lost.begin(), lost.end(),
                                  [](const LostLabel& label) { return label.covers_faces; });
  const char* what =
      covers ? (one ? "has no vertex of its own" : "have no vertex or no face of their own")
             : (one ? "covers no face" : "cover no face");
  const std::string start = fmt::format("{} {} {}: ", one ? "Label" : "Labels", list, what);
  const char* them = one ? "it" : "them";
  if (by_face == of_faces) {
    return start + fmt::format("{} {} keep {}", one ? "its" : "their",
                               by_face ? "faces" : "vertices", them);
  }
  return start +
         fmt::format("the new labels of {} do not have {}", of_faces ? "faces" : "vertices", them);
}

}  // namespace talweg
