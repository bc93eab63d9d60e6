// glTF data are numbers in buffers: in the file, as text in its JSON, or in files beside the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "talweg/core/io/json_place.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/mesh/number_type.hpp"

namespace talweg::formats {

/// The numbers of an accessor.
struct GltfNumbers {
  std::size_t components = 1;
  NumberType type = NumberType::kFloat32;
  bool normalized = false;     ///< whole numbers that stand for reals in [0, 1] or [-1, 1]
  std::vector<double> values;  ///< as they are stored
  [[nodiscard]] std::size_t count() const { return values.size() / components; }
  /// Value k; a normalized value as a number in [0, 1] or [-1, 1].
  [[nodiscard]] double real(std::size_t k) const;
};

/// All errors are Error(kBadFile) with the place in the JSON.
class GltfData {
 public:
  /// Parses the JSON of a .gltf or .glb file. Throws Error(kBadFile) for versions other than 2 and
  /// for required extensions that change the geometry and are not known.
  explicit GltfData(const MeshFile& file);

  [[nodiscard]] JsonPlace root() const { return {file_.path, json_, ""}; }
  /// The numbers of an accessor. Its type must be one of `type` ("VEC3", or "VEC3 VEC4").
  [[nodiscard]] GltfNumbers numbers(std::uint32_t accessor, std::string_view type);
  /// Bytes of the file and of the buffers loaded so far.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  std::string_view split_glb();
  void check_version() const;
  std::string_view buffer(std::uint32_t index);
  std::string read_uri(const JsonPlace& place) const;
  std::string_view view(std::uint32_t index, std::size_t& stride);
  void replace_sparse(const JsonPlace& sparse, GltfNumbers& numbers);

  const MeshFile& file_;
  nlohmann::json json_;
  std::string_view chunk_;           // the buffer of a GLB file
  std::vector<std::string> loaded_;  // buffers outside the GLB file
  std::vector<bool> is_loaded_;
  std::size_t bytes_ = 0;
};

}  // namespace talweg::formats
