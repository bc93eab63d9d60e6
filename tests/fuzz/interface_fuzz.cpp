// Bytes become calls of the plugin interface: in any order, with any arguments that a host could
// pass by mistake. Every call must return a status, and results must be finite and in range.
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz_bytes.hpp"
#include "places.hpp"
#include "talweg/loader/talweg_loader.h"
#include "talweg/plugin/talweg_arrays.hpp"
#include "talweg/plugin/talweg_cut_plan.h"
#include "talweg/plugin/talweg_meshes.h"

namespace {

using talweg::fuzz::Bytes;
using talweg::fuzz::require;

struct Mesh {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
};

/// A bumpy sheet, with some damaged numbers.
Mesh mesh_from(Bytes& bytes) {
  const std::uint32_t n = 2 + bytes.take<std::uint8_t>() % 7;
  Mesh mesh;
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i <= n; ++i) {
      for (const double x : {double(i), double(j), std::sin(3.0 * i + j)}) mesh.xyz.push_back(x);
    }
  }
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + n + 1;
      for (const std::uint32_t v : {a, a + 1, b + 1, a, b + 1, b}) mesh.triangles.push_back(v);
    }
  }
  for (std::uint32_t damage = bytes.take<std::uint8_t>() % 16; damage > 12; --damage) {
    mesh.xyz[bytes.take<std::uint16_t>() % mesh.xyz.size()] = bytes.take<double>();
    mesh.triangles[bytes.take<std::uint16_t>() % mesh.triangles.size()] = bytes.index(60);
  }
  return mesh;
}

/// A view of data, sometimes with a wrong description that reads nothing out of bounds.
template <class T>
talweg_array view_from(Bytes& bytes, const std::vector<T>& data, std::uint32_t columns) {
  talweg_array array = talweg::plugin::view(data.data(), data.size() / columns, columns);
  switch (bytes.take<std::uint8_t>() % 32) {
    case 0:
      array.data = nullptr;
      break;
    case 1:
      array.columns = bytes.take<std::uint32_t>() | 16U;
      break;
    case 2:
      array.type = bytes.take<std::uint32_t>() | 64U;
      break;
    case 3:
      array.stride = 1 + bytes.take<std::uint8_t>() % 3;
      break;
    case 4:
      array.rows = array.rows / 2;
      break;
    case 5:
      array.rows = UINT64_MAX - bytes.take<std::uint8_t>();
      break;
    default:
      break;
  }
  return array;
}

/// The sizes of the mesh of the instance.
struct Sizes {
  std::uint64_t vertices = 0, triangles = 0;
  std::uint64_t made = 0;  // number of meshes that the run made
  // The sizes of the made mesh in question.
  std::uint64_t made_vertices = 0, made_triangles = 0;
};
Sizes& sizes_of(void* context) { return *static_cast<Sizes*>(context); }

talweg_status on_curve(void* /*sizes*/, const talweg_curve* curve) {
  const std::uint64_t n = curve->faces.rows;
  require(n >= 2 && curve->positions.rows == n && curve->barycentrics.rows == n, "sizes");
  const auto* xyz = static_cast<const double*>(curve->positions.data);
  const auto* b = static_cast<const double*>(curve->barycentrics.data);
  for (std::uint64_t k = 0; k < 3 * n; ++k) {
    require(std::isfinite(xyz[k]), "finite positions");
    require(b[k] >= 0 && b[k] <= 1, "barycentrics in [0, 1]");
  }
  for (std::uint32_t k = 0; k < curve->field_count; ++k) {
    require(curve->fields[k]->values.rows == n, "one value per point");
  }
  return TALWEG_OK;
}
talweg_status on_field(void* sizes, const talweg_field* field) {
  const std::uint64_t rows = field->values.rows;
  require(rows == sizes_of(sizes).vertices || rows == sizes_of(sizes).triangles,
          "one value per vertex or triangle");
  const auto* values = static_cast<const double*>(field->values.data);
  for (std::uint64_t k = 0; k < field->values.rows; ++k) require(!std::isnan(values[k]), "no NaN");
  return TALWEG_OK;
}
talweg_status on_mesh(void* sizes, const talweg_mesh* mesh) {
  ++sizes_of(sizes).made;
  sizes_of(sizes).made_vertices = mesh->positions.rows;
  sizes_of(sizes).made_triangles = mesh->triangles.rows;
  const auto* corners = static_cast<const std::uint32_t*>(mesh->triangles.data);
  for (std::uint64_t k = 0; k < 3 * mesh->triangles.rows; ++k) {
    require(corners[k] < mesh->positions.rows, "corners are vertices");
  }
  return TALWEG_OK;
}
talweg_status on_attribute(void* sizes, const talweg_attribute* attribute) {
  const Sizes& s = sizes_of(sizes);
  if (attribute->corners.rows > 0) {
    require(attribute->corners.rows == s.made_triangles, "corners of each triangle");
    return TALWEG_OK;
  }
  const std::uint64_t rows = attribute->element == TALWEG_OF_VERTICES    ? s.made_vertices
                             : attribute->element == TALWEG_OF_TRIANGLES ? s.made_triangles
                                                                         : 3 * s.made_triangles;
  require(attribute->values.rows == rows, "a row for each element");
  return TALWEG_OK;
}
talweg_status on_origin(void* sizes, const talweg_origin* origin) {
  const Sizes& s = sizes_of(sizes);
  require(origin->vertices.rows == s.made_vertices && origin->weights.rows == s.made_vertices &&
              origin->triangles.rows == s.made_triangles,
          "an origin of everything");
  const auto* from = static_cast<const std::uint32_t*>(origin->vertices.data);
  const auto* weights = static_cast<const double*>(origin->weights.data);
  for (std::uint64_t k = 0; k < 3 * s.made_vertices; ++k) {
    require(from[k] == TALWEG_NO_VERTEX || from[k] < s.vertices, "vertices that came in");
    require(weights[k] >= 0 && weights[k] <= 1, "weights in [0, 1]");
  }
  const auto* triangles = static_cast<const std::uint32_t*>(origin->triangles.data);
  for (std::uint64_t k = 0; k < s.made_triangles; ++k) {
    require(triangles[k] == TALWEG_NO_TRIANGLE || triangles[k] < s.triangles,
            "triangles that came in");
  }
  return TALWEG_OK;
}
talweg_status on_report(void* /*sizes*/, const talweg_report_entry* entry) {
  require(entry->key != nullptr && (entry->is_list != 0 || entry->count == 1), "report");
  return TALWEG_OK;
}

void set_mesh(Bytes& bytes, const talweg_plugin& plugin, talweg_instance* instance, Sizes& sizes) {
  const Mesh mesh = mesh_from(bytes);
  talweg_mesh view = {sizeof view, 0, view_from(bytes, mesh.xyz, 3),
                      view_from(bytes, mesh.triangles, 3), nullptr};
  if (plugin.set_mesh(instance, &view) != TALWEG_OK) return;
  sizes.vertices = view.positions.rows;
  sizes.triangles = view.triangles.rows;
}

void set_curves(Bytes& bytes, const talweg_plugin& plugin, talweg_instance* instance) {
  std::vector<std::uint32_t> ids, pins;
  std::vector<double> numbers;
  std::uint32_t at = bytes.take<std::uint8_t>() % 64;
  for (std::uint32_t n = bytes.take<std::uint8_t>() % 16; n > 0; --n) {
    ids.push_back(at);
    at = bytes.take<std::uint8_t>() < 200 ? at + 1 : bytes.index(80);
    for (int k = 0; k < 3; ++k) numbers.push_back(bytes.take<std::uint8_t>() / 64.0);
  }
  if (bytes.take<std::uint8_t>() < 64) pins.push_back(bytes.index(16));
  talweg_curve curve = {};
  curve.size = sizeof curve;
  curve.closed = bytes.take<std::uint8_t>() % 4 == 0 ? 1 : 0;
  switch (bytes.take<std::uint8_t>() % 4) {
    case 0:
      for (std::size_t k = 0; k < numbers.size(); k += 3) {
        const double sum = numbers[k] + numbers[k + 1] + numbers[k + 2];
        for (int i = 0; sum > 0 && i < 3; ++i) numbers[k + static_cast<std::size_t>(i)] /= sum;
      }
      curve.faces = view_from(bytes, ids, 1);
      curve.barycentrics = view_from(bytes, numbers, 3);
      break;
    case 1:
      curve.positions = view_from(bytes, numbers, 3);
      break;
    default:
      curve.vertices = view_from(bytes, ids, 1);
  }
  curve.pins = view_from(bytes, pins, 1);
  const talweg_curve* list[] = {&curve, &curve};
  plugin.set_curves(instance, list, 1 + bytes.take<std::uint8_t>() % 8 / 7);
}

void set_parameter(Bytes& bytes, const talweg_plugin& plugin, talweg_instance* instance,
                   const Sizes& sizes) {
  const talweg_parameter& p =
      *plugin.parameters[bytes.take<std::uint8_t>() % plugin.parameter_count];
  const std::uint8_t how = bytes.take<std::uint8_t>();
  double value = how < 128 ? bytes.take<std::uint8_t>() / 16.0 : bytes.take<double>();
  if (p.type == TALWEG_INTEGER && how < 200) value = std::floor(value);
  if (p.type == TALWEG_INTEGER && value > 32) value = 32;  // large values would only take time
  const std::uint64_t rows = p.type == TALWEG_TRIANGLE_FIELD ? sizes.triangles : sizes.vertices;
  std::vector<double> field(how % 8 == 0 ? 3 : rows, value);
  if (std::string_view(p.id).ends_with("_labels") && how % 8 != 0) {
    for (std::uint64_t k = 0; k < rows; ++k)
      field[k] = static_cast<double>(8 * k / rows * (how % 3U));
  }
  const std::vector<std::uint32_t> ids = {bytes.index(64)};
  const talweg_array array =
      p.type == TALWEG_VERTICES ? view_from(bytes, ids, 1) : view_from(bytes, field, 1);
  switch (how % 16) {
    case 1:
      plugin.reset(instance, p.id);
      break;
    case 2:
      plugin.set_choice(instance, p.id, "nonsense");
      break;
    case 3:
      plugin.set_array(instance, p.id, &array);
      break;
    default:
      if (p.type == TALWEG_CHOICE) {
        plugin.set_choice(instance, p.id, p.choices[how % p.choice_count]);
      } else if (p.type >= TALWEG_VERTICES) {
        plugin.set_array(instance, p.id, &array);
      } else {
        plugin.set_number(instance, p.id, value);
      }
  }
}

void set_attributes(Bytes& bytes, const talweg_meshes& meshes, talweg_instance* instance,
                    const Sizes& sizes) {
  const std::uint32_t element = bytes.take<std::uint8_t>() % 4;
  const std::uint32_t columns = bytes.take<std::uint8_t>() % 4;
  const std::uint64_t rows = element == TALWEG_OF_VERTICES    ? sizes.vertices
                             : element == TALWEG_OF_TRIANGLES ? sizes.triangles
                                                              : 3 * sizes.triangles;
  const std::vector<double> values(rows * (columns + 1), bytes.take<std::uint8_t>());
  talweg_attribute attribute = {sizeof attribute,
                                element,
                                bytes.take<std::uint8_t>() % 6U,
                                0,
                                "a",
                                bytes.take<std::uint8_t>() / 16.0,
                                view_from(bytes, values, columns == 0 ? 1 : columns),
                                talweg::plugin::kNoArray};
  if (columns > 0 && attribute.values.columns == columns) attribute.values.rows = rows;
  const talweg_attribute* list[] = {&attribute, &attribute};
  meshes.set_attributes(instance, list, 1 + bytes.take<std::uint8_t>() % 8 / 7);
}

void ask_for_meshes(const talweg_meshes& meshes, talweg_instance* instance, Sizes& sizes) {
  for (const std::uint64_t mesh : {sizes.made - 1, sizes.made}) {
    const bool is_there = mesh < sizes.made;
    const talweg_status given = meshes.attributes(instance, mesh, on_attribute, &sizes);
    const talweg_status told = meshes.origin(instance, mesh, on_origin, &sizes);
    require((given == TALWEG_OK) == is_there && (told == TALWEG_OK) == is_there,
            "attributes and origin of every mesh, and of no other");
  }
}

talweg_status on_plan(void* /*sizes*/, const talweg_cut_plan* plan) {
  require(plan->weights.rows == plan->vertices.rows &&
              plan->positions.rows == plan->vertices.rows &&
              plan->parts.rows == plan->divided.rows && plan->closed.rows == plan->curve_count &&
              plan->lengths.rows == plan->curve_count,
          "sizes of a plan");
  return TALWEG_OK;
}

void run(Bytes& bytes, const talweg_plugin& plugin, talweg_instance* instance, Sizes& sizes) {
  const std::uint8_t wants = bytes.take<std::uint8_t>();
  const auto* meshes = static_cast<const talweg_meshes*>(plugin.get_extension(TALWEG_MESHES));
  if (meshes != nullptr && (wants & 16) != 0) set_attributes(bytes, *meshes, instance, sizes);
  sizes.made = 0;
  talweg_sink sink = {sizeof sink,
                      wants % 2U,
                      &sizes,
                      (wants & 2) != 0 ? on_curve : nullptr,
                      (wants & 4) != 0 ? on_field : nullptr,
                      on_report,
                      (wants & 8) != 0 ? on_mesh : nullptr};
  const talweg_status status = plugin.run(instance, &sink);
  require(status != TALWEG_INTERNAL, plugin.last_error(instance));
  require((status == TALWEG_OK) == (*plugin.last_error(instance) == '\0'), "a sentence");
  if (meshes != nullptr && status == TALWEG_OK && (wants & 8) != 0) {
    ask_for_meshes(*meshes, instance, sizes);
  }
  const auto* plans = static_cast<const talweg_cut_plans*>(plugin.get_extension(TALWEG_CUT_PLAN));
  if (plans != nullptr) {
    const talweg_status given = plans->plan(instance, on_plan, &sizes);
    require(status != TALWEG_OK || given == TALWEG_OK || given == TALWEG_UNSUPPORTED,
            "a plan after every run");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const talweg_loader* const loader = talweg_loader_open(talweg::test::plugin_folder());
  Bytes bytes(data, size);
  const std::uint64_t count = talweg_loader_count(loader);
  require(count > 0, "there are plugins");
  const talweg_plugin& plugin = *talweg_loader_plugin(loader, bytes.take<std::uint8_t>() % count);
  talweg_instance* instance = nullptr;
  require(plugin.create(nullptr, &instance) == TALWEG_OK, "an instance");
  Sizes sizes;
  for (int calls = 0; calls < 40 && !bytes.empty(); ++calls) {
    switch (bytes.take<std::uint8_t>() % 8) {
      case 0:
        set_mesh(bytes, plugin, instance, sizes);
        break;
      case 1:
      case 2:
        set_curves(bytes, plugin, instance);
        break;
      case 3:
      case 4:
        set_parameter(bytes, plugin, instance, sizes);
        break;
      case 5:
        plugin.cancel(instance);
        break;
      default:
        run(bytes, plugin, instance, sizes);
    }
  }
  plugin.destroy(instance);
  return 0;
}
