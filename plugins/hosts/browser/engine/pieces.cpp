#include "pieces.hpp"

#include <utility>

namespace talweg::browser {
namespace {

/// Appends the values of the same attribute of another mesh. Entries of corners are renumbered.
void append(host::Attribute& to, const host::Attribute& more) {
  const auto before = static_cast<std::uint32_t>(to.values.size() / to.columns);
  to.values.insert(to.values.end(), more.values.begin(), more.values.end());
  for (auto corner : more.corners) {
    for (std::uint32_t& entry : corner) {
      if (entry != TALWEG_NO_ENTRY) entry += before;
    }
    to.corners.push_back(corner);
  }
}

}  // namespace

Pieces::Pieces(const editing::Plugins& plugins, FileMesh mesh, editing::Defects defects,
               double weld_within)
    : services_("Talweg page", "1", {},
                [this](std::uint32_t severity, const char* message) {
                  if (severity >= TALWEG_LOG_WARNING) notes_.emplace_back(message);
                }),
      instance_(plugins.find("talweg.cut"), services_) {
  if (defects == editing::Defects::kRepair) instance_.set("repair", 1.0);
  if (weld_within > 0) instance_.set("repair_weld_tolerance", weld_within);
  editing::set_mesh(instance_, *mesh.arrays);
  instance_.set_attributes(mesh.attributes);
  instance_.set("split", 1.0);
}

void Pieces::cut(const std::vector<host::Curve>& curves) {
  instance_.set_curves(editing::courses(curves));
  run(false);
}

void Pieces::keep(std::size_t part, bool lids) {
  run(lids);
  if (part >= meshes_.size()) throw editing::Error("There is no part " + std::to_string(part + 1));
  meshes_ = {std::move(meshes_[part])};
  attributes_ = {std::move(attributes_[part])};
}

std::vector<FileMesh> Pieces::each(bool lids) {
  std::vector<FileMesh> all;
  for (Piece& piece : made(lids)) {
    auto arrays = std::make_shared<editing::MeshArrays>();
    arrays->positions = std::move(piece.mesh.positions);
    arrays->triangles = std::move(piece.mesh.triangles);
    all.push_back({std::move(arrays), std::move(piece.attributes), {}, {}});
  }
  return all;
}

void Pieces::run(bool lids) {
  notes_.clear();
  std::vector<Piece> pieces = made(lids);
  meshes_.clear();
  attributes_.clear();
  for (Piece& piece : pieces) {
    meshes_.push_back(std::move(piece.mesh));
    attributes_.push_back(std::move(piece.attributes));
  }
}

std::vector<Pieces::Piece> Pieces::made(bool lids) {
  instance_.set("cap", lids ? "auto" : "none");
  host::Wanted wanted;
  wanted.meshes = true;
  host::Results results = instance_.run(wanted);
  if (const host::ReportEntry* warnings = results.find("warnings")) {
    notes_.insert(notes_.end(), warnings->texts.begin(), warnings->texts.end());
  }
  std::vector<Piece> pieces;
  for (host::Mesh& mesh : results.meshes) {
    pieces.push_back({std::move(mesh), instance_.attributes(pieces.size())});
  }
  return pieces;
}

FileMesh Pieces::together() const {
  auto arrays = std::make_shared<editing::MeshArrays>();
  FileMesh whole;
  for (std::size_t k = 0; k < meshes_.size(); ++k) {
    const auto before = static_cast<std::uint32_t>(arrays->positions.size());
    const host::Mesh& piece = meshes_[k];
    arrays->positions.insert(arrays->positions.end(), piece.positions.begin(),
                             piece.positions.end());
    for (const auto& [a, b, c] : piece.triangles) {
      arrays->triangles.push_back({a + before, b + before, c + before});
    }
    for (std::size_t i = 0; i < attributes_[k].size(); ++i) {
      if (k == 0) {
        whole.attributes.push_back(attributes_[k][i]);
      } else {
        append(whole.attributes[i], attributes_[k][i]);
      }
    }
  }
  whole.arrays = std::move(arrays);
  return whole;
}

}  // namespace talweg::browser
