#include "plugin_host.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "suggestion.hpp"
#include "talweg/core/drawing/point_marks.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg::driver {
namespace {

struct CloseLoader {
  void operator()(talweg_loader* loader) const { talweg_loader_close(loader); }
};

std::uint32_t number_of(std::size_t index) { return static_cast<std::uint32_t>(index); }

/// Whether a number fits an integer. A plugin may return any number as an integer, for example
/// infinity for an unknown value.
bool is_whole(double value) { return std::abs(value) < 0x1p63; }

ReportEntry entry_of(const host::ReportEntry& entry) {
  if (entry.type == TALWEG_VALUE_TEXT) {
    if (entry.is_list) return {entry.key, entry.texts};
    return {entry.key, entry.texts.at(0)};
  }
  const bool whole = entry.type == TALWEG_VALUE_INTEGER &&
                     std::all_of(entry.numbers.begin(), entry.numbers.end(), is_whole);
  if (entry.is_list && whole) {
    return {entry.key, std::vector<std::int64_t>(entry.numbers.begin(), entry.numbers.end())};
  }
  if (entry.is_list) return {entry.key, entry.numbers};
  const double value = entry.numbers.at(0);
  if (entry.type == TALWEG_VALUE_BOOLEAN) return {entry.key, value != 0};
  if (whole) return {entry.key, static_cast<std::int64_t>(value)};
  return {entry.key, value};
}

}  // namespace

const talweg_loader* plugin_loader() {
  static const std::unique_ptr<talweg_loader, CloseLoader> loader(talweg_loader_open(nullptr));
  if (!loader) throw std::bad_alloc();
  return loader.get();
}

const talweg_plugin& plugin_named(const std::string& id) {
  const talweg_plugin* plugin = talweg_loader_find(plugin_loader(), id.c_str());
  if (plugin != nullptr) return *plugin;
  std::vector<std::string> known;
  for (std::uint64_t k = 0; k < talweg_loader_count(plugin_loader()); ++k) {
    known.emplace_back(talweg_loader_plugin(plugin_loader(), k)->id);
  }
  throw Error(ErrorCode::kBadFile, "There is no plugin " + id + " in " +
                                       talweg_loader_folders(plugin_loader()) +
                                       suggestion(id, known) +
                                       " (TALWEG_PLUGIN_PATH names other folders; talweg plugins "
                                       "lists all that were found).");
}

void rethrow(const host::Error& error) {
  switch (error.status()) {
    case TALWEG_BAD_MESH:
      throw Error(ErrorCode::kBadMesh, error.what());
    case TALWEG_BAD_CURVE:
      throw Error(ErrorCode::kBadCurve, error.what());
    case TALWEG_BAD_FILE:
      throw Error(ErrorCode::kBadFile, error.what());
    case TALWEG_NUMERICAL:
      throw Error(ErrorCode::kNumerical, error.what());
    case TALWEG_BAD_USAGE:
    case TALWEG_UNSUPPORTED:
      throw Error(ErrorCode::kBadUsage, error.what());
    case TALWEG_OUT_OF_MEMORY:
      throw std::bad_alloc();
    case TALWEG_CANCELLED:
      throw Cancelled();
    default:
      throw std::runtime_error(error.what());
  }
}

host::Curve host_curve(const PlacedCurve& curve) {
  host::Curve result;
  result.closed = curve.closed;
  for (const FaceCoordinates& at : curve.faces) {
    result.faces.push_back(number_of(at.face.index()));
    result.barycentrics.push_back(at.barycentric);
  }
  return result;
}

host::Curve host_curve(const CurveInput& curve) {
  host::Curve result;
  result.closed = curve.closed;
  if (const auto* ids = std::get_if<std::vector<VertexId>>(&curve.points)) {
    for (const VertexId v : *ids) result.vertices.push_back(number_of(v.index()));
  } else if (const auto* at = std::get_if<std::vector<FaceCoordinates>>(&curve.points)) {
    result = host_curve(PlacedCurve{curve.closed, {}, *at, {}, {}});
  } else if (std::holds_alternative<std::vector<CornerCoordinates>>(curve.points)) {
    throw Error(ErrorCode::kBadUsage,
                "Plugins take no points between vertices (.border); `talweg smooth` does.");
  } else {
    for (const Point& p : std::get<std::vector<Point>>(curve.points)) {
      result.positions.push_back({p.x(), p.y(), p.z()});
    }
  }
  for (const std::size_t pin : curve.pins) result.pins.push_back(number_of(pin));
  result.exact = marks_of(curve);
  return result;
}

PlacedCurve placed_curve(const host::Curve& curve) {
  PlacedCurve result;
  result.closed = curve.closed;
  result.exact = curve.exact;
  for (std::size_t k = 0; k < curve.faces.size(); ++k) {
    const bool at_vertex = curve.vertices.at(k) != TALWEG_NO_VERTEX;
    result.vertices.push_back(at_vertex ? VertexId{curve.vertices[k]} : VertexId{});
    result.faces.push_back({FaceId{curve.faces[k]}, curve.barycentrics.at(k)});
    const auto& p = curve.positions.at(k);
    result.positions.emplace_back(p[0], p[1], p[2]);
  }
  return result;
}

std::vector<ReportEntry> entries_of(const host::Results& results, std::int64_t curve) {
  std::vector<ReportEntry> entries;
  for (const host::ReportEntry& entry : results.report) {
    if (entry.curve == curve) entries.push_back(entry_of(entry));
  }
  return entries;
}

void set_mesh(host::Instance& instance, std::span<const Point> points,
              std::span<const Triangle> triangles) {
  const double* xyz = points.empty() ? nullptr : points.front().data();
  const std::uint32_t* corners = triangles.empty() ? nullptr : triangles.front().data();
  instance.set_mesh(host::view(xyz, points.size(), 3), host::view(corners, triangles.size(), 3));
}

void set_mesh(host::Instance& instance, const MeshLists& lists) {
  if (!lists.single_precision) return set_mesh(instance, lists.points, lists.triangles);
  std::vector<float> xyz;
  xyz.reserve(3 * lists.points.size());
  for (const Point& p : lists.points) {
    for (const double x : p) {
      xyz.push_back(static_cast<float>(x));
      // Coordinates of text files may need doubles.
      if (xyz.back() != x) return set_mesh(instance, lists.points, lists.triangles);
    }
  }
  const std::uint32_t* corners = lists.triangles.empty() ? nullptr : lists.triangles.front().data();
  instance.set_mesh({xyz.data(), lists.points.size(), 0, 3, TALWEG_FLOAT32},
                    host::view(corners, lists.triangles.size(), 3));
}

}  // namespace talweg::driver
