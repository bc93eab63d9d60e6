#include "talweg/core/io/gltf_data.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "talweg/core/io/base64.hpp"
#include "talweg/core/io/byte_cursor.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/percent_escapes.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::formats {
namespace {

constexpr bool kTurned = std::endian::native == std::endian::big;

std::optional<NumberType> component_type(std::uint32_t code) {
  constexpr std::array<NumberType, 7> kTypes{
      NumberType::kInt8,  NumberType::kUint8,  NumberType::kInt16,  NumberType::kUint16,
      NumberType::kInt32, NumberType::kUint32, NumberType::kFloat32};
  if (code < 5120 || code > 5126 || code == 5124) return std::nullopt;
  return kTypes[code - 5120];
}

std::size_t components_of(std::string_view type) {
  if (type == "SCALAR") return 1;
  return type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 0;
}

/// Whether a required extension concerns only the appearance of surfaces, not their geometry.
bool is_appearance(std::string_view name) {
  for (const std::string_view start :
       {"KHR_mesh_quantization", "KHR_materials_", "KHR_texture_", "KHR_lights_", "KHR_xmp",
        "KHR_animation", "KHR_node_visibility", "EXT_texture_", "EXT_lights_", "MSFT_texture_",
        "ADOBE_materials_"}) {
    if (name.starts_with(start)) return true;
  }
  return false;
}

/// Whether a relative name stays inside the folder of the file.
bool stays_beside(const std::string& name) {
  if (name.empty() || name.find_first_of(std::string(":\\\0", 3)) != name.npos) return false;
  const std::filesystem::path path(name);
  if (path.is_absolute()) return false;
  return std::none_of(path.begin(), path.end(), [](const auto& part) { return part == ".."; });
}

}  // namespace

double GltfNumbers::real(std::size_t k) const {
  if (!normalized) return values[k];
  switch (type) {
    case NumberType::kInt8:
      return std::max(values[k] / 127, -1.0);
    case NumberType::kUint8:
      return values[k] / 255;
    case NumberType::kInt16:
      return std::max(values[k] / 32767, -1.0);
    case NumberType::kUint16:
      return values[k] / 65535;
    default:
      return values[k];
  }
}

GltfData::GltfData(const MeshFile& file) : file_(file), bytes_(file.bytes.size()) {
  std::string_view text = file.bytes;
  if (text.starts_with("glTF")) text = split_glb();
  json_ = parsed_json({file_.path, text, {}});
  check_version();
  if (root().has("buffers")) {
    loaded_.resize(root().member("buffers").size());
    is_loaded_.resize(loaded_.size(), false);
  }
}

/// A GLB file is a header of 12 bytes and chunks: the JSON, then perhaps a buffer.
std::string_view GltfData::split_glb() {
  const std::string_view all = file_.bytes;
  const auto word = [&](std::size_t at) -> std::size_t {
    if (at + 4 > all.size()) cannot_read(file_.path, "the file ends in the header of a chunk");
    return load<std::uint32_t>(all.data() + at, kTurned);
  };
  if (word(4) != 2) {
    cannot_read(file_.path,
                fmt::format("GLB files of version {} are not read, only of version 2", word(4)));
  }
  const auto chunk = [&](std::size_t at) {
    const std::size_t length = word(at);
    if (length > all.size() - at - 8) {
      cannot_read(file_.path, fmt::format("a chunk at byte {} has {} bytes, but the file ends {} "
                                          "bytes after its header",
                                          at, length, all.size() - at - 8));
    }
    return all.substr(at + 8, length);
  };
  if (word(16) != 0x4E4F534A) cannot_read(file_.path, "its first chunk is not JSON");
  const std::string_view text = chunk(12);
  const std::size_t next = 20 + text.size();
  if (next + 8 <= all.size() && word(next + 4) == 0x004E4942) chunk_ = chunk(next);
  return text;
}

void GltfData::check_version() const {
  const std::string version = root().member("asset").member("version").string();
  if (!version.starts_with("2.")) {
    cannot_read(file_.path,
                fmt::format("it is glTF {}; only version 2 is read", printable(version)));
  }
  if (!root().has("extensionsRequired")) return;
  const JsonPlace needed = root().member("extensionsRequired");
  for (std::size_t k = 0; k < needed.size(); ++k) {
    const std::string name = needed.element(k).string();
    if (is_appearance(name)) continue;
    cannot_read(file_.path, fmt::format("it needs the extension {}, which is not read; export it "
                                        "without compression or other extensions",
                                        printable(name)));
  }
}

std::string_view GltfData::buffer(std::uint32_t index) {
  const JsonPlace all = root().member("buffers");
  if (index >= all.size()) all.fail(fmt::format("there is no buffer {}", index));
  const JsonPlace place = all.element(index);
  const std::size_t length = place.member("byteLength").index();
  std::string_view bytes = chunk_;
  if (place.has("uri")) {
    if (!is_loaded_[index]) {
      loaded_[index] = read_uri(place.member("uri"));
      is_loaded_[index] = true;
      bytes_ += loaded_[index].size();
    }
    bytes = loaded_[index];
  } else if (index != 0 || chunk_.data() == nullptr) {
    place.fail("it has no uri, and the file has no buffer for it");
  }
  if (length > bytes.size()) {
    place.fail(fmt::format("it should have {} bytes, but has {}", length, bytes.size()));
  }
  return bytes.substr(0, length);
}

std::string GltfData::read_uri(const JsonPlace& place) const {
  const std::string uri = place.string();
  if (uri.starts_with("data:")) {
    constexpr std::string_view kMark = ";base64,";
    const std::size_t at = std::string_view(uri).substr(0, 200).find(kMark);
    if (at == std::string::npos) place.fail("expected data in base64");
    std::string bytes;
    if (!from_base64(std::string_view(uri).substr(at + kMark.size()), bytes)) {
      place.fail("its data are not base64");
    }
    return bytes;
  }
  const std::string name = without_escapes(uri);
  if (!stays_beside(name)) {
    place.fail(
        fmt::format("'{}' is outside the folder of the file; only files inside it are opened",
                    printable(name)));
  }
  try {
    return read_file(file_.path.parent_path() / name);
  } catch (const Error&) {
    place.fail(
        fmt::format("the file '{}', which should lie beside this one, cannot be read; a .glb "
                    "has everything in one file",
                    printable(name)));
  }
}

std::string_view GltfData::view(std::uint32_t index, std::size_t& stride) {
  const JsonPlace all = root().member("bufferViews");
  if (index >= all.size()) all.fail(fmt::format("there is no buffer view {}", index));
  const JsonPlace place = all.element(index);
  for (const char* packed : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    if (place.has("extensions") && place.member("extensions").has(packed)) {
      place.fail(
          fmt::format("its data are packed by {}, which is not read; export it without "
                      "compression",
                      packed));
    }
  }
  const std::string_view bytes = buffer(place.member("buffer").index());
  const std::size_t from = place.has("byteOffset") ? place.member("byteOffset").index() : 0;
  const std::size_t length = place.member("byteLength").index();
  if (from > bytes.size() || length > bytes.size() - from) {
    place.fail(fmt::format("it ends at byte {} of a buffer of {}", from + length, bytes.size()));
  }
  stride = place.has("byteStride") ? place.member("byteStride").index() : 0;
  return bytes.substr(from, length);
}

namespace {

/// `count` numbers of `components` each, `stride` bytes apart.
void load_all(const JsonPlace& place, std::string_view bytes, std::size_t from, std::size_t stride,
              std::size_t count, GltfNumbers& numbers) {
  const std::size_t size = size_of(numbers.type), each = size * numbers.components;
  if (stride == 0) stride = each;
  const bool fits = count == 0 || (from <= bytes.size() && each <= bytes.size() - from &&
                                   (count - 1) <= (bytes.size() - from - each) / stride);
  if (!fits) place.fail(fmt::format("its {} elements are more than the buffer view has", count));
  numbers.values.reserve(numbers.values.size() + count * numbers.components);
  for (std::size_t k = 0; k < count; ++k) {
    const char* at = bytes.data() + from + k * stride;
    for (std::size_t c = 0; c < numbers.components; ++c, at += size) {
      numbers.values.push_back(load_number(numbers.type, at, kTurned));
    }
  }
}

std::size_t offset_of(const JsonPlace& place) {
  return place.has("byteOffset") ? place.member("byteOffset").index() : 0;
}

NumberType type_at(const JsonPlace& place) {
  const auto type = component_type(place.member("componentType").index());
  if (!type) place.fail("expected a componentType of 5120 to 5126");
  return *type;
}

}  // namespace

GltfNumbers GltfData::numbers(std::uint32_t accessor, std::string_view type) {
  const JsonPlace all = root().member("accessors");
  if (accessor >= all.size()) all.fail(fmt::format("there is no accessor {}", accessor));
  const JsonPlace place = all.element(accessor);
  const std::string own = place.member("type").string();
  GltfNumbers numbers;
  numbers.components = components_of(own);
  if (numbers.components == 0 || type.find(own) == std::string_view::npos) {
    place.fail(fmt::format("expected the type {}, found '{}'", type, printable(own)));
  }
  numbers.type = type_at(place);
  numbers.normalized = place.has("normalized") && place.member("normalized").boolean();
  const std::size_t count = place.member("count").index();
  if (place.has("bufferView")) {
    std::size_t stride = 0;
    const std::string_view bytes = view(place.member("bufferView").index(), stride);
    load_all(place, bytes, offset_of(place), stride, count, numbers);
  } else {  // an accessor without data stands for zeros
    if (count > bytes_) place.fail(fmt::format("its {} elements have no data", count));
    numbers.values.resize(count * numbers.components, 0);
  }
  if (place.has("sparse")) replace_sparse(place.member("sparse"), numbers);
  return numbers;
}

void GltfData::replace_sparse(const JsonPlace& sparse, GltfNumbers& numbers) {
  const std::size_t count = sparse.member("count").index();
  const auto part = [&](const char* name, NumberType type, std::size_t components) {
    const JsonPlace place = sparse.member(name);
    GltfNumbers values{components, type, false, {}};
    std::size_t stride = 0;
    const std::string_view bytes = view(place.member("bufferView").index(), stride);
    load_all(place, bytes, offset_of(place), 0, count, values);
    return values.values;
  };
  const std::vector<double> indices = part("indices", type_at(sparse.member("indices")), 1);
  const std::vector<double> values = part("values", numbers.type, numbers.components);
  for (std::size_t k = 0; k < count; ++k) {
    if (!(indices[k] >= 0 && indices[k] < static_cast<double>(numbers.count())) ||
        indices[k] != std::floor(indices[k])) {
      sparse.fail(fmt::format("there is no element {:.17g} to replace", indices[k]));
    }
    const auto at = static_cast<std::size_t>(indices[k]) * numbers.components;
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(k * numbers.components),
                numbers.components, numbers.values.begin() + static_cast<std::ptrdiff_t>(at));
  }
}

}  // namespace talweg::formats
