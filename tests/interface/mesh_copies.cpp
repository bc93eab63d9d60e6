// set_mesh copies the host's arrays once: counts the memory blocks of their sizes. A separate
// program, because it replaces operator new for plugins, too.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <utility>
#include <vector>

#include "places.hpp"
#include "talweg/core/mesh/opened_mesh.hpp"
#include "talweg/loader/talweg_loader.h"
#include "talweg/plugin/talweg_arrays.hpp"
#include "talweg/plugin/talweg_meshes.h"

namespace {

constexpr std::uint32_t kSize = 100;
constexpr std::size_t kPositions = (kSize + 1) * (kSize + 1) * 3 * sizeof(double);
constexpr std::size_t kTriangles = kSize * kSize * 6 * sizeof(std::uint32_t);
int g_positions = 0, g_triangles = 0;

/// Blocks of the triangles' size that opening a mesh allocates for its own arrays, when it takes
/// over the lists.
int blocks_of_opening(const std::vector<double>& xyz, const std::vector<std::uint32_t>& triangles) {
  talweg::MeshLists lists;
  for (std::size_t k = 0; k < xyz.size(); k += 3) lists.points.emplace_back(&xyz[k]);
  for (std::size_t k = 0; k < triangles.size(); k += 3) {
    lists.triangles.push_back({triangles[k], triangles[k + 1], triangles[k + 2]});
  }
  g_triangles = 0;
  static_cast<void>(talweg::OpenedMesh::open(std::move(lists)));
  return g_triangles;
}

/// Whether the plugin takes any mesh, and so opens none.
bool takes_any_mesh(const talweg_plugin& plugin) {
  const auto* meshes = static_cast<const talweg_meshes*>(plugin.get_extension(TALWEG_MESHES));
  return meshes != nullptr && (meshes->takes & TALWEG_TAKES_ANY_MESH) != 0;
}

}  // namespace

void* operator new(std::size_t size) {
  if (size == kPositions) ++g_positions;
  if (size == kTriangles) ++g_triangles;
  if (void* block = std::malloc(size)) return block;
  throw std::bad_alloc();
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t /*size*/) noexcept { std::free(block); }

int main() {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t j = 0; j <= kSize; ++j) {
    for (std::uint32_t i = 0; i <= kSize; ++i) {
      for (const double x : {double(i), double(j), 0.1 * (i % 3)}) xyz.push_back(x);
      const std::uint32_t a = j * (kSize + 1) + i, b = a + kSize + 1;
      if (i == kSize || j == kSize) continue;
      for (const std::uint32_t v : {a, a + 1, b + 1, a, b + 1, b}) triangles.push_back(v);
    }
  }
  const talweg_mesh mesh = {sizeof mesh, 0, talweg::plugin::view(xyz.data(), xyz.size() / 3, 3),
                            talweg::plugin::view(triangles.data(), triangles.size() / 3, 3),
                            nullptr};
  const int own = blocks_of_opening(xyz, triangles);
  talweg_loader* loader = talweg_loader_open(talweg::test::plugin_folder());
  int wrong = talweg_loader_count(loader) == 0 ? 1 : 0;
  for (std::uint64_t k = 0; k < talweg_loader_count(loader); ++k) {
    const talweg_plugin& plugin = *talweg_loader_plugin(loader, k);
    talweg_instance* instance = nullptr;
    plugin.create(nullptr, &instance);
    g_positions = g_triangles = 0;
    const bool set = plugin.set_mesh(instance, &mesh) == TALWEG_OK;
    const int opening = takes_any_mesh(plugin) ? 0 : own;
    std::printf("%s: positions %d, triangles %d\n", plugin.id, g_positions, g_triangles - opening);
    if (!set || g_positions != 1 || g_triangles != opening + 1) wrong = 1;
    talweg_instance* second = nullptr;
    plugin.create(nullptr, &second);
    g_positions = g_triangles = 0;
    if (plugin.share_mesh(second, instance) != TALWEG_OK) wrong = 1;
    if (g_positions + g_triangles > 0) wrong = 1;
    plugin.destroy(second);
    plugin.destroy(instance);
  }
  talweg_loader_close(loader);
  return wrong;
}
