#include "tools/picture/scene_check.hpp"

#include <cmath>
#include <cstdint>
#include <string>

#include "talweg/intrinsic/error.hpp"
#include "tools/picture/camera.hpp"

namespace talweg::picture {
namespace {

void check_mesh(const MeshLists& mesh) {
  if (mesh.triangles.empty()) {
    throw Error(ErrorCode::kBadMesh, "the mesh to be drawn has no faces");
  }
  Extent extent;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (const std::uint32_t v : mesh.triangles[f]) {
      if (v >= mesh.points.size()) {
        throw Error(ErrorCode::kBadMesh, "face " + std::to_string(f) + " has the vertex " +
                                             std::to_string(v) + ", but the mesh has only " +
                                             std::to_string(mesh.points.size()));
      }
      if (!mesh.points[v].allFinite()) {
        throw Error(ErrorCode::kBadMesh, "vertex " + std::to_string(v) + " is not finite");
      }
      extent.add(mesh.points[v]);
    }
  }
  if (!(extent.size().maxCoeff() > 0)) {
    throw Error(ErrorCode::kBadMesh, "the mesh to be drawn has no extent: all vertices coincide");
  }
}

void check_curves(const Scene& scene) {
  for (std::size_t c = 0; c < scene.curves.size(); ++c) {
    for (const Point& p : scene.curves[c].points) {
      if (!p.allFinite()) {
        throw Error(ErrorCode::kBadCurve,
                    "curve " + std::to_string(c + 1) + " has a point that is not finite");
      }
    }
    if (!(scene.curves[c].width > 0)) {
      throw Error(ErrorCode::kBadUsage,
                  "the width of curve " + std::to_string(c + 1) + " is not above 0");
    }
  }
}

void check_panels(const Scene& scene) {
  for (const Panel& panel : scene.panels) {
    for (const std::size_t c : panel.curves) {
      if (c >= scene.curves.size()) {
        throw Error(ErrorCode::kBadUsage, "a panel shows curve " + std::to_string(c + 1) +
                                              ", but there are only " +
                                              std::to_string(scene.curves.size()));
      }
    }
    if (!(panel.zoom > 0) || !std::isfinite(panel.zoom)) {
      throw Error(ErrorCode::kBadUsage, "the zoom of a panel is not above 0");
    }
    if (panel.view && (!panel.view->allFinite() || panel.view->isZero(0))) {
      throw Error(ErrorCode::kBadUsage, "a view direction is zero or not finite");
    }
  }
}

}  // namespace

void check_scene(const Scene& scene) {
  if (!scene.face_colors.empty() && scene.face_colors.size() != scene.mesh.triangles.size()) {
    throw Error(ErrorCode::kBadUsage, "there are " + std::to_string(scene.face_colors.size()) +
                                          " colours for " +
                                          std::to_string(scene.mesh.triangles.size()) + " faces");
  }
  check_mesh(scene.mesh);
  check_curves(scene);
  check_panels(scene);
  if (scene.up && (!scene.up->allFinite() || scene.up->isZero(0))) {
    throw Error(ErrorCode::kBadUsage, "the up direction is zero or not finite");
  }
}

}  // namespace talweg::picture
