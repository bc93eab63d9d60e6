#include "curve_files.hpp"

#include "talweg/plugin/talweg_curve_files.h"

namespace talweg::editing {
namespace {

const talweg_curve_files_3& files_of(const Plugins& plugins) {
  const auto* files = static_cast<const talweg_curve_files_3*>(
      plugins.find("talweg.draw").get_extension(TALWEG_CURVE_FILES_3));
  if (files == nullptr) {
    throw Error("The plugin talweg.draw that was found is too old to read and write curve files.");
  }
  return *files;
}

talweg_mesh view_of(const MeshArrays& mesh) {
  return {sizeof(talweg_mesh), 0, positions_of(mesh), triangles_of(mesh), nullptr};
}

talweg_status append(void* context, const talweg_curve* curve) {
  try {
    static_cast<std::vector<host::Curve>*>(context)->push_back(host::detail::copy(*curve));
    return TALWEG_OK;
  } catch (...) {
    return TALWEG_INTERNAL;
  }
}

}  // namespace

void write_curves(const Plugins& plugins, const std::string& path, const MeshArrays& mesh,
                  const std::vector<host::Curve>& curves, const std::string& frame) {
  const host::detail::CurveViews views(curves);
  const talweg_mesh view = view_of(mesh);
  std::string message(1000, 0);
  const talweg_status status =
      files_of(plugins).write(path.c_str(), frame.c_str(), &view, views.data(), views.size(),
                              message.data(), message.size());
  if (status != TALWEG_OK) throw host::Error(status, message.c_str());
}

std::vector<host::Curve> read_curves(const Plugins& plugins, const std::string& path,
                                     const MeshArrays& mesh, const std::string& frame) {
  std::vector<host::Curve> curves;
  const talweg_mesh view = view_of(mesh);
  const talweg_sink sink = {sizeof sink, 0, &curves, append, nullptr, nullptr, nullptr};
  std::string message(1000, 0);
  const talweg_status status = files_of(plugins).read(path.c_str(), frame.c_str(), &view, &sink,
                                                      message.data(), message.size());
  if (status != TALWEG_OK) throw host::Error(status, message.c_str());
  return curves;
}

std::vector<host::Curve> drawn_curves(const MeshArrays& mesh, const Drawing& drawing) {
  std::vector<host::Curve> curves = host_curves(drawing);
  for (host::Curve& curve : curves) {
    for (std::size_t k = 0; k < curve.faces.size(); ++k) {
      curve.positions.push_back(position_of(mesh, {curve.faces[k], curve.barycentrics[k], false}));
    }
  }
  return curves;
}

}  // namespace talweg::editing
