// Curve files for tests are written to a temporary folder and read back.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "core/small_meshes.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::test {

/// A test with its own temporary folder.
class CurveFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    std::random_device device;
    folder_ = std::filesystem::temp_directory_path() /
              ("talweg_curves_" + std::to_string(device()) + std::to_string(device()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  std::filesystem::path put(const std::string& name, std::string_view bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

  static std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::vector<CurveInput> read(const std::string& name, std::string_view bytes) const {
    return read_curves(path(name), bytes);
  }

  /// The message of the Error(kBadFile) that reading a malformed file must throw.
  std::string refusal(const std::string& name, std::string_view bytes) const {
    const std::filesystem::path file = path(name);
    try {
      read_curves(file, bytes);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadFile);
      const std::string message = error.what();
      EXPECT_EQ(message.find("Cannot read " + file.string()), 0U) << message;
      EXPECT_EQ(message.back(), '.') << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message;
    }
    ADD_FAILURE() << "not refused: " << bytes.substr(0, 200);
    return {};
  }

  /// Expects an error whose message has all these parts.
  void expect_refused(const std::string& name, std::string_view bytes,
                      const std::vector<std::string>& parts) const {
    const std::string message = refusal(name, bytes);
    for (const std::string& part : parts) {
      EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' not in: " << message;
    }
  }

  /// Reads every prefix of a file. Reading must throw an Error or return curves.
  void try_every_prefix(const std::string& name, std::string_view bytes) const {
    for (std::size_t n = 1; n < bytes.size(); ++n) {
      try {
        EXPECT_FALSE(read(name, bytes.substr(0, n)).empty());
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::kBadFile) << error.what();
      }
    }
  }

  /// Reads copies of a file with bytes changed at random. Reading must throw an Error or return
  /// curves.
  void try_damaged(const std::string& name, std::string_view bytes, int rounds) const {
    std::mt19937 random(7);
    for (int round = 0; round < rounds; ++round) {
      std::string damaged(bytes);
      for (int k = 0; k < 1 + round % 4; ++k) {
        damaged[random() % damaged.size()] = static_cast<char>(random() & 0xFFU);
      }
      try {
        EXPECT_FALSE(read(name, damaged).empty());
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::kBadFile) << error.what();
      }
    }
  }

 private:
  std::filesystem::path folder_;
};

inline const std::vector<Point>& positions(const CurveInput& curve) {
  return std::get<std::vector<Point>>(curve.points);
}

inline std::vector<std::size_t> ids(const CurveInput& curve) {
  std::vector<std::size_t> result;
  for (const VertexId v : std::get<std::vector<VertexId>>(curve.points)) {
    result.push_back(v.index());
  }
  return result;
}

/// A sphere with coordinates that have no short decimal form.
inline SurfaceMesh odd_sphere() {
  MeshLists lists = sphere(3);
  for (Point& p : lists.points) p = Point(p.x() / 3 + 7, p.y() / 3 - 11, p.z() / 3 + 1e-3);
  return SurfaceMesh::open(lists);
}

/// A closed curve around vertex 0, on the edges to its neighbours, at different fractions.
inline SurfaceCurve ring(const SurfaceMesh& mesh) {
  const Surface& surface = mesh.surface();
  SurfaceCurve curve{true, {}};
  const HalfedgeId first = surface.halfedge(VertexId{0});
  HalfedgeId h = first;
  do {
    const double t = 1.0 / (3.0 + static_cast<double>(curve.points.size()));
    curve.points.push_back(SurfacePoint::on_edge(surface, edge_of(h), t));
    h = surface.turn_ccw(h);
  } while (h != first);
  return curve;
}

/// An open curve from inside a face over a side and a corner of the face, then along an edge.
inline SurfaceCurve walk(const SurfaceMesh& mesh) {
  const Surface& surface = mesh.surface();
  const FaceId face{17};
  const HalfedgeId h = surface.next(surface.halfedge(face));
  SurfaceCurve curve;
  curve.points.push_back(SurfacePoint::in_face(surface, face, {0.1, 0.2, 0.7}));
  curve.points.push_back(SurfacePoint::on_edge(surface, edge_of(h), 1e-14));
  curve.points.push_back(SurfacePoint::at_vertex(surface, surface.head(h)));
  curve.points.push_back(
      SurfacePoint::on_edge(surface, edge_of(surface.turn_ccw(surface.next(h))), 1.0 / 3));
  return curve;
}

/// An open curve along mesh vertices.
inline SurfaceCurve vertex_walk(const SurfaceMesh& mesh, std::size_t first, std::size_t steps) {
  const Surface& surface = mesh.surface();
  SurfaceCurve curve;
  VertexId at{first};
  std::vector<VertexId> seen;
  while (curve.points.size() < steps) {
    seen.push_back(at);
    curve.points.push_back(SurfacePoint::at_vertex(surface, at));
    HalfedgeId h = surface.halfedge(at);
    while (std::find(seen.begin(), seen.end(), surface.head(h)) != seen.end()) {
      h = surface.turn_ccw(h);
    }
    at = surface.head(h);
  }
  return curve;
}

}  // namespace talweg::test
