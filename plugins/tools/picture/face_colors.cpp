#include "tools/picture/face_colors.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "talweg/core/mesh/union_find.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::picture {
namespace {

/// A bright, slightly saturated colour of this hue in [0, 1).
Color of_hue(double hue) {
  constexpr double kValue = 0.95, kSaturation = 0.34;
  Color color{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = std::fmod(hue + static_cast<double>(3 - k) / 3, 1.0) * 6;
    const double part = std::clamp(std::abs(at - 3) - 1, 0.0, 1.0);
    color[k] = kValue * (1 - kSaturation * (1 - part));
  }
  return color;
}

}  // namespace

std::vector<Color> label_colors(const std::vector<std::int64_t>& labels) {
  constexpr double kGoldenPart = 0.38196601125010515;
  std::vector<Color> colors;
  colors.reserve(labels.size());
  for (const std::int64_t label : labels) {
    const double turns = 0.09 + kGoldenPart * static_cast<double>(label);
    colors.push_back(of_hue(turns - std::floor(turns)));
  }
  return colors;
}

std::vector<std::int64_t> read_label_file(const std::string& path) {
  std::ifstream in{std::filesystem::path(path)};
  if (!in) throw Error(ErrorCode::kBadFile, path + " cannot be opened");
  std::vector<std::int64_t> labels;
  for (std::int64_t label = 0; in >> label;) labels.push_back(label);
  if (!in.eof()) {
    throw Error(ErrorCode::kBadFile,
                path + ": label " + std::to_string(labels.size()) + " is not a whole number");
  }
  return labels;
}

std::vector<std::int64_t> pieces_of(const MeshLists& mesh) {
  UnionFind parts(mesh.points.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    parts.join(a, b);
    parts.join(b, c);
  }
  std::vector<std::size_t> size(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles) ++size[parts.find(t[0])];
  std::vector<std::size_t> by_size(size.size());
  std::iota(by_size.begin(), by_size.end(), std::size_t{0});
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](std::size_t a, std::size_t b) { return size[a] > size[b]; });
  std::vector<std::int64_t> number(size.size());
  for (std::size_t k = 0; k < by_size.size(); ++k) {
    number[by_size[k]] = static_cast<std::int64_t>(k);
  }
  std::vector<std::int64_t> pieces;
  for (const Triangle& t : mesh.triangles) pieces.push_back(number[parts.find(t[0])]);
  return pieces;
}

void move_apart(MeshLists& mesh, const Point& by) {
  const std::vector<std::int64_t> pieces = pieces_of(mesh);
  std::vector<bool> moves(mesh.points.size(), false);
  for (std::size_t f = 0; f < pieces.size(); ++f) {
    for (const std::uint32_t v : mesh.triangles[f]) moves[v] = pieces[f] > 0;
  }
  for (std::size_t v = 0; v < moves.size(); ++v) {
    if (moves[v]) mesh.points[v] += by;
  }
}

}  // namespace talweg::picture
