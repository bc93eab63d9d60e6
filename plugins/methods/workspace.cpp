#include "workspace.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "talweg/core/version.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::plugins {
namespace {

bool same(const std::vector<SurfaceCurve>& a, const std::vector<SurfaceCurve>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const SurfaceCurve& p, const SurfaceCurve& q) {
                      return p.closed == q.closed && p.points == q.points;
                    });
}

}  // namespace

std::shared_ptr<const OpenedMesh> opened(const talweg_mesh& mesh) {
  MeshLists lists;
  try {
    plugin::check_array(mesh.positions, 3, "The mesh's positions");
    plugin::check_array(mesh.triangles, 3, "The mesh's triangles");
    lists.points.resize(mesh.positions.rows);
    lists.triangles.resize(mesh.triangles.rows);
    if (!lists.points.empty()) {
      plugin::copy_numbers(mesh.positions, 3, "The mesh's positions", lists.points.front().data());
    }
    if (!lists.triangles.empty()) {
      plugin::copy_indices(mesh.triangles, 3, "The mesh's triangles",
                           lists.triangles.front().data());
    }
  } catch (const plugin::Failure& failure) {
    throw plugin::Failure(TALWEG_BAD_MESH, failure.what());
  }
  return OpenedMesh::open(std::move(lists));
}

talweg_plugin about_curves(const char* id, const char* label, const char* doc) {
  talweg_plugin about = {};
  about.flags = TALWEG_TAKES_CURVES;
  about.id = id;
  about.label = label;
  about.version = version();
  about.doc = doc;
  return about;
}

talweg_status Workspace::status_of(const std::exception& error) {
  const auto* own = dynamic_cast<const Error*>(&error);
  if (own == nullptr) return TALWEG_INTERNAL;
  switch (own->code()) {
    case ErrorCode::kBadUsage:
      return TALWEG_BAD_USAGE;
    case ErrorCode::kBadMesh:
      return TALWEG_BAD_MESH;
    case ErrorCode::kBadCurve:
      return TALWEG_BAD_CURVE;
    case ErrorCode::kBadFile:
      return TALWEG_BAD_FILE;
    case ErrorCode::kNumerical:
      return TALWEG_NUMERICAL;
    case ErrorCode::kOutOfMemory:
      return TALWEG_OUT_OF_MEMORY;
  }
  return TALWEG_INTERNAL;
}

void Workspace::use(std::shared_ptr<const OpenedMesh> mesh) {
  lines_.reset();  // refers to the mesh
  mesh_ = std::move(mesh);
  drawing_ = {};
  ++drawings_;
  forget();
}

StraightLines& Workspace::lines() {
  if (!lines_) lines_.emplace(mesh_->surface());
  return *lines_;
}

void Workspace::draw(std::span<const talweg_curve* const> curves, const SnapOptions& options) {
  SnappedDrawing drawing = drawing_of(mesh(), lines(), curves, options);
  if (!same(drawing.curves, drawing_.curves)) ++drawings_;
  drawing_ = std::move(drawing);
}

Progress Workspace::progress() const {
  return [services = services_](const char* stage, double fraction) {
    return services->go_on(stage, fraction);
  };
}

}  // namespace talweg::plugins
