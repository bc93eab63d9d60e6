// Wrong calls of a host: each one gets a status and a sentence, without a crash or a leak.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "places.hpp"
#include "plugins/plugin_runs.hpp"

namespace talweg {
namespace {

/// The ids of all plugins of this build; CoverEveryPluginOfTheLoader compares them with the
/// loader's. Loading the module takes a second under a sanitizer, for each test of this program.
std::vector<std::string> all_plugins() {
  return {"talweg.bipartition", "talweg.cut",      "talweg.distance", "talweg.draw",
          "talweg.envelope",    "talweg.geodesic", "talweg.labels",   "talweg.measure",
          "talweg.midpoints",   "talweg.offset",   "talweg.repair",   "talweg.smooth"};
}

class Interface : public testing::TestWithParam<std::string> {
 protected:
  Interface() : plugin_(test::plugin_of_this_build(GetParam().c_str())) {
    plugin_.create(nullptr, &instance_);
    if (GetParam() != "talweg.bipartition") return;
    vertices_.clear();  // the method needs curves from boundary to boundary, which part the mesh
    for (std::uint32_t y = 0; y <= 40; ++y) vertices_.push_back(20 + 41 * y);
  }
  ~Interface() override { plugin_.destroy(instance_); }

  /// Expects that a call was refused with this status and a sentence.
  void expect(talweg_status expected, talweg_status status, const char* what) const {
    EXPECT_EQ(status, expected) << what << ": " << plugin_.last_error(instance_);
    EXPECT_STRNE(plugin_.last_error(instance_), "") << what;
  }
  [[nodiscard]] talweg_mesh mesh() const {
    return {sizeof(talweg_mesh), 0,
            host::view(subject_.lists.points.front().data(), subject_.lists.points.size(), 3),
            host::view(subject_.lists.triangles.front().data(), subject_.lists.triangles.size(), 3),
            nullptr};
  }
  void set_up() {
    const talweg_mesh good = mesh();
    ASSERT_EQ(plugin_.set_mesh(instance_, &good), TALWEG_OK);
    if (GetParam() == "talweg.labels") {
      const talweg_array halves = host::view(labels_.data(), labels_.size());
      ASSERT_EQ(plugin_.set_array(instance_, "vertex_labels", &halves), TALWEG_OK);
    }
    if (!takes_curves()) return;
    const talweg_curve curve = this->curve();
    const talweg_curve* list[] = {&curve};
    ASSERT_EQ(plugin_.set_curves(instance_, list, 1), TALWEG_OK) << plugin_.last_error(instance_);
  }
  [[nodiscard]] bool takes_curves() const { return (plugin_.flags & TALWEG_TAKES_CURVES) != 0; }
  /// The extension for meshes; null if the plugin makes no meshes.
  [[nodiscard]] const talweg_meshes* meshes() const {
    return static_cast<const talweg_meshes*>(plugin_.get_extension(TALWEG_MESHES));
  }
  [[nodiscard]] bool takes_any_mesh() const {
    return meshes() != nullptr && (meshes()->takes & TALWEG_TAKES_ANY_MESH) != 0;
  }
  /// Expects that a plugin without curves as input refuses curves.
  void expect_no_curves() {
    const talweg_curve curve = this->curve();
    const talweg_curve* list[] = {&curve};
    expect(TALWEG_UNSUPPORTED, plugin_.set_curves(instance_, list, 1), "curves");
  }
  /// Runs a plugin that accepted a mesh that is not a surface.
  void inspect(const char* what) {
    talweg_sink sink = {};
    sink.size = sizeof sink;
    sink.report = [](void*, const talweg_report_entry*) -> talweg_status { return TALWEG_OK; };
    EXPECT_EQ(plugin_.run(instance_, &sink), TALWEG_OK) << what;
  }
  [[nodiscard]] talweg_curve curve() const {
    talweg_curve c = {};
    c.size = sizeof c;
    c.vertices = host::view(vertices_.data(), vertices_.size());
    return c;
  }

  test::Subject subject_;
  std::vector<std::uint32_t> vertices_ = {200, 201, 202, 243, 284};
  std::vector<double> labels_ = [this] {
    std::vector<double> halves(subject_.lists.points.size(), 1);
    std::fill(halves.begin(), halves.begin() + static_cast<std::ptrdiff_t>(halves.size() / 2), 2);
    return halves;
  }();
  const talweg_plugin& plugin_;
  talweg_instance* instance_ = nullptr;
};

TEST_P(Interface, DescriptionsAreComplete) {
  EXPECT_GE(plugin_.parameter_count, 1U);
  EXPECT_GE(plugin_.output_count, 1U);
  for (std::uint32_t k = 0; k < plugin_.parameter_count; ++k) {
    const talweg_parameter& p = *plugin_.parameters[k];
    EXPECT_STRNE(p.label, "") << p.id;
    EXPECT_STRNE(p.doc, "") << p.id;
    EXPECT_LE(p.soft_minimum, p.soft_maximum) << p.id;
    EXPECT_GE(p.soft_minimum, p.minimum) << p.id;
    EXPECT_LE(p.soft_maximum, p.maximum) << p.id;
  }
}

TEST_P(Interface, DefaultsCanBeSet) {
  set_up();
  for (std::uint32_t k = 0; k < plugin_.parameter_count; ++k) {
    const talweg_parameter& p = *plugin_.parameters[k];
    if (p.type == TALWEG_CHOICE) {
      EXPECT_EQ(plugin_.set_choice(instance_, p.id, p.default_choice), TALWEG_OK) << p.id;
    } else if (p.type <= TALWEG_BOOLEAN && (p.flags & TALWEG_OPTIONAL) == 0) {
      EXPECT_EQ(plugin_.set_number(instance_, p.id, p.default_number), TALWEG_OK) << p.id;
    }
    EXPECT_EQ(plugin_.reset(instance_, p.id), TALWEG_OK) << p.id;
  }
  set_up();  // labels are a parameter
  talweg_sink sink = {};
  sink.size = sizeof sink;
  EXPECT_EQ(plugin_.run(instance_, &sink), TALWEG_OK) << plugin_.last_error(instance_);
  EXPECT_STREQ(plugin_.last_error(instance_), "");
}

TEST_P(Interface, NullArgumentsAreRefused) {
  const talweg_plugin& p = plugin_;
  const talweg_mesh good = mesh();
  const talweg_curve curve = this->curve();
  const talweg_curve* list[] = {&curve};
  const talweg_curve* nulls[] = {nullptr};
  talweg_sink sink = {};
  sink.size = sizeof sink;
  const talweg_array array = plugin::kNoArray;

  EXPECT_NE(p.create(nullptr, nullptr), TALWEG_OK);
  p.destroy(nullptr);
  p.cancel(nullptr);
  EXPECT_NE(p.last_error(nullptr), nullptr);
  EXPECT_NE(p.set_mesh(nullptr, &good), TALWEG_OK);
  EXPECT_NE(p.share_mesh(nullptr, instance_), TALWEG_OK);
  EXPECT_NE(p.set_curves(nullptr, list, 1), TALWEG_OK);
  EXPECT_NE(p.set_number(nullptr, "tau", 1), TALWEG_OK);
  EXPECT_NE(p.set_choice(nullptr, "potential", "paper"), TALWEG_OK);
  EXPECT_NE(p.set_array(nullptr, "pin", &array), TALWEG_OK);
  EXPECT_NE(p.reset(nullptr, "tau"), TALWEG_OK);
  EXPECT_NE(p.run(nullptr, &sink), TALWEG_OK);
  EXPECT_EQ(p.get_extension("nonsense"), nullptr);
  EXPECT_EQ(p.get_extension(nullptr), nullptr);

  expect(TALWEG_BAD_USAGE, p.set_mesh(instance_, nullptr), "mesh");
  expect(TALWEG_BAD_USAGE, p.share_mesh(instance_, nullptr), "other");
  expect(TALWEG_BAD_USAGE, p.share_mesh(instance_, instance_), "itself, without a mesh");
  expect(TALWEG_BAD_USAGE, p.run(instance_, &sink), "no mesh");
  const talweg_status without = takes_curves() ? TALWEG_BAD_USAGE : TALWEG_UNSUPPORTED;
  expect(without, p.set_curves(instance_, list, 1), "curves before the mesh");
  ASSERT_EQ(p.set_mesh(instance_, &good), TALWEG_OK);
  if (takes_curves()) expect(TALWEG_BAD_USAGE, p.run(instance_, &sink), "no curves");
  expect(without, p.set_curves(instance_, nullptr, 1), "list");
  expect(without, p.set_curves(instance_, list, 0), "none");
  expect(without, p.set_curves(instance_, nulls, 1), "null in the list");
  expect(without, p.set_curves(instance_, list, UINT64_MAX), "too many");
  expect(TALWEG_BAD_USAGE, p.run(instance_, nullptr), "sink");
  expect(TALWEG_BAD_USAGE, p.set_number(instance_, nullptr, 1), "id");
  expect(TALWEG_BAD_USAGE, p.set_choice(instance_, nullptr, "a"), "id");
  expect(TALWEG_BAD_USAGE, p.set_array(instance_, nullptr, &array), "id");
  expect(TALWEG_BAD_USAGE, p.reset(instance_, nullptr), "id");
  for (std::uint32_t k = 0; k < p.parameter_count; ++k) {
    const char* id = p.parameters[k]->id;
    expect(TALWEG_BAD_USAGE, p.set_choice(instance_, id, nullptr), id);
    expect(TALWEG_BAD_USAGE, p.set_array(instance_, id, nullptr), id);
  }
}

TEST_P(Interface, BadParametersAreRefused) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (std::uint32_t k = 0; k < plugin_.parameter_count; ++k) {
    const talweg_parameter& p = *plugin_.parameters[k];
    for (const double value : {std::nan(""), kInfinity, -kInfinity}) {
      expect(TALWEG_BAD_USAGE, plugin_.set_number(instance_, p.id, value), p.id);
    }
    expect(TALWEG_BAD_USAGE, plugin_.set_choice(instance_, p.id, "nonsense"), p.id);
    const double real[] = {0.5};
    const talweg_array bad[] = {{nullptr, 3, 0, 1, TALWEG_FLOAT64},
                                {real, 1, 0, 1, 77},
                                {real, 1, 0, 2, TALWEG_FLOAT64},
                                {real, 1, 3, 1, TALWEG_FLOAT64},
                                {real, UINT64_MAX, 0, 1, TALWEG_FLOAT64}};
    for (const talweg_array& array : bad) {
      expect(TALWEG_BAD_USAGE, plugin_.set_array(instance_, p.id, &array), p.id);
    }
    if (std::isfinite(p.minimum) && p.type <= TALWEG_INTEGER) {
      expect(TALWEG_BAD_USAGE, plugin_.set_number(instance_, p.id, p.minimum - 1), p.id);
    }
    if (std::isfinite(p.maximum) && p.type <= TALWEG_INTEGER) {
      expect(TALWEG_BAD_USAGE, plugin_.set_number(instance_, p.id, p.maximum + 1), p.id);
    }
  }
  expect(TALWEG_BAD_USAGE, plugin_.set_number(instance_, "", 1), "empty id");
  expect(TALWEG_BAD_USAGE, plugin_.reset(instance_, std::string(100000, 'x').c_str()), "long id");
}

TEST_P(Interface, BadMeshesAreRefused) {
  const talweg_mesh good = mesh();
  const auto refuse = [&](talweg_status expected, const char* what, auto change) {
    talweg_mesh bad = good;
    change(bad);
    const talweg_status status = plugin_.set_mesh(instance_, &bad);
    if (status == TALWEG_OK && takes_any_mesh()) return inspect(what);
    expect(expected, status, what);
  };
  refuse(TALWEG_BAD_USAGE, "size", [](talweg_mesh& m) { m.size = 8; });
  refuse(TALWEG_BAD_MESH, "no points", [](talweg_mesh& m) { m.positions.rows = 0; });
  refuse(TALWEG_BAD_MESH, "no triangles", [](talweg_mesh& m) { m.triangles.rows = 0; });
  refuse(TALWEG_BAD_MESH, "fewer points", [](talweg_mesh& m) { m.positions.rows = 10; });
  refuse(TALWEG_BAD_MESH, "null points", [](talweg_mesh& m) { m.positions.data = nullptr; });
  refuse(TALWEG_BAD_MESH, "null triangles", [](talweg_mesh& m) { m.triangles.data = nullptr; });
  refuse(TALWEG_BAD_MESH, "rows", [](talweg_mesh& m) { m.positions.rows = UINT64_MAX / 2; });
  refuse(TALWEG_BAD_MESH, "rows", [](talweg_mesh& m) { m.triangles.rows = UINT32_MAX; });
  refuse(TALWEG_BAD_MESH, "columns", [](talweg_mesh& m) { m.positions.columns = 2; });
  refuse(TALWEG_BAD_MESH, "columns", [](talweg_mesh& m) { m.triangles.columns = 0; });
  refuse(TALWEG_BAD_MESH, "type", [](talweg_mesh& m) { m.positions.type = 0; });
  refuse(TALWEG_BAD_MESH, "stride", [](talweg_mesh& m) { m.positions.stride = 1; });
  refuse(TALWEG_BAD_MESH, "stride", [](talweg_mesh& m) { m.triangles.stride = UINT64_MAX; });
  refuse(TALWEG_BAD_MESH, "real indices", [](talweg_mesh& m) { m.triangles = m.positions; });
  const std::int32_t negative[] = {0, 1, -2};
  refuse(TALWEG_BAD_MESH, "negative index", [&](talweg_mesh& m) {
    m.triangles = {negative, 1, 0, 3, TALWEG_INT32};
  });
  const std::int64_t large[] = {0, 1, std::int64_t{1} << 40};
  refuse(TALWEG_BAD_MESH, "large index", [&](talweg_mesh& m) {
    m.triangles = {large, 1, 0, 3, TALWEG_INT64};
  });
  const double nan[] = {0, 0, 0, 1, 0, 0, 0, std::nan(""), 0};
  const std::uint32_t triangle[] = {0, 1, 2};
  refuse(TALWEG_BAD_MESH, "NaN", [&](talweg_mesh& m) {
    m.positions = host::view(nan, 3, 3);
    m.triangles = host::view(triangle, 1, 3);
  });
}

TEST_P(Interface, BadCurvesAreRefused) {
  set_up();
  if (!takes_curves()) return expect_no_curves();
  const auto refuse = [&](const char* what, auto change) {
    talweg_curve bad = curve();
    change(bad);
    const talweg_curve* list[] = {&bad};
    const talweg_status status = plugin_.set_curves(instance_, list, 1);
    EXPECT_TRUE(status == TALWEG_BAD_USAGE || status == TALWEG_BAD_CURVE) << what << " " << status;
    EXPECT_STRNE(plugin_.last_error(instance_), "") << what;
  };
  refuse("size", [](talweg_curve& c) { c.size = 16; });
  refuse("closed", [](talweg_curve& c) { c.closed = 2; });
  refuse("no points", [](talweg_curve& c) { c.vertices.rows = 0; });
  refuse("one point", [](talweg_curve& c) { c.vertices.rows = 1; });
  refuse("null", [](talweg_curve& c) { c.vertices.data = nullptr; });
  refuse("type", [](talweg_curve& c) { c.vertices.type = TALWEG_FLOAT64; });
  refuse("columns", [](talweg_curve& c) { c.vertices.columns = 3; });
  const std::uint32_t none[] = {1, 99999}, twice[] = {200, 201, 200}, faces[] = {1, 2};
  const double positions[] = {0, 0, 0, std::nan(""), 0, 0}, outside[] = {2, -1, 0, 0, 0, 1};
  refuse("no such vertex", [&](talweg_curve& c) { c.vertices = host::view(none, 2); });
  refuse("NaN", [&](talweg_curve& c) {
    c.vertices.rows = 0;
    c.positions = host::view(positions, 2, 3);
  });
  refuse("no barycentrics", [&](talweg_curve& c) {
    c.vertices.rows = 0;
    c.faces = host::view(faces, 2);
  });
  refuse("outside", [&](talweg_curve& c) {
    c.vertices.rows = 0;
    c.faces = host::view(faces, 2);
    c.barycentrics = host::view(outside, 2, 3);
  });
  refuse("no such face", [&](talweg_curve& c) {
    c.vertices.rows = 0;
    c.faces = host::view(none, 2);
    c.barycentrics = host::view(outside, 2, 3);
  });
  refuse("no such pin", [&](talweg_curve& c) { c.pins = host::view(none, 2); });
  refuse("real pins", [&](talweg_curve& c) { c.pins = host::view(positions, 1); });

  talweg_sink sink = {};  // the good curve is still set
  sink.size = sizeof sink;
  EXPECT_EQ(plugin_.run(instance_, &sink), TALWEG_OK) << plugin_.last_error(instance_);
  sink.size = 4;
  expect(TALWEG_BAD_USAGE, plugin_.run(instance_, &sink), "size of the sink");

  // A curve that goes out and back again is refused when it is set or when the plugin runs.
  sink.size = sizeof sink;
  talweg_curve back = curve();
  back.vertices = host::view(twice, 3);
  const talweg_curve* list[] = {&back};
  talweg_status status = plugin_.set_curves(instance_, list, 1);
  if (status == TALWEG_OK) status = plugin_.run(instance_, &sink);
  const std::set<std::string> any_curve{"talweg.cut", "talweg.draw", "talweg.measure",
                                        "talweg.offset"};
  if (any_curve.contains(GetParam())) {
    EXPECT_EQ(status, TALWEG_OK) << "out and back";
  } else {
    expect(TALWEG_BAD_CURVE, status, "out and back");
  }
}

/// A sink that counts results, and fails at the n-th result.
struct FailingSink {
  int fails_at = 1 << 30;
  int given = 0;
  bool throws = false;

  talweg_status next() {
    if (++given < fails_at) return TALWEG_OK;
    if (throws) throw std::runtime_error("a host in C++ that forgot itself");
    return TALWEG_INTERNAL;
  }
  [[nodiscard]] talweg_sink sink() {
    talweg_sink s = {};
    s.size = sizeof s;
    s.wants = TALWEG_WANT_POINT_FIELDS;
    s.context = this;
    s.curve = [](void* own, const talweg_curve*) { return static_cast<FailingSink*>(own)->next(); };
    s.field = [](void* own, const talweg_field*) { return static_cast<FailingSink*>(own)->next(); };
    s.report = [](void* own, const talweg_report_entry*) {
      return static_cast<FailingSink*>(own)->next();
    };
    s.mesh = [](void* own, const talweg_mesh*) { return static_cast<FailingSink*>(own)->next(); };
    return s;
  }
};

TEST_P(Interface, OnlyFieldsOfCurvesWithKnownNamesAreRead) {
  const talweg_mesh good = mesh();
  ASSERT_EQ(plugin_.set_mesh(instance_, &good), TALWEG_OK);
  if (!takes_curves()) return expect_no_curves();
  const float other[] = {1, 2};  // an unknown name: type and number do not matter
  std::vector<double> marks(vertices_.size(), TALWEG_MARK_NONE);
  marks.front() = 0;
  const talweg_field noise = {sizeof noise, "deviation", "", {other, 2, 0, 1, TALWEG_FLOAT32}};
  talweg_field exact = {sizeof exact, TALWEG_EXACT, "mesh units",
                        host::view(marks.data(), marks.size())};
  const talweg_field* fields[] = {&noise, &exact};
  talweg_curve c = curve();
  c.field_count = 2;
  c.fields = fields;
  const talweg_curve* list[] = {&c};
  const auto set = [&] { return plugin_.set_curves(instance_, list, 1); };
  EXPECT_EQ(set(), TALWEG_OK) << plugin_.last_error(instance_);

  marks[1] = -7;
  expect(TALWEG_BAD_USAGE, set(), "no mark");
  marks[1] = std::nan("");
  expect(TALWEG_BAD_USAGE, set(), "a mark that is not a number");
  marks[1] = TALWEG_MARK_PAINTED;
  --exact.values.rows;
  expect(TALWEG_BAD_USAGE, set(), "too few marks");
  exact.values = {marks.data(), marks.size(), 0, 1, 77};
  expect(TALWEG_BAD_USAGE, set(), "marks of no type");
  exact.values = host::view(marks.data(), marks.size());
  EXPECT_EQ(set(), TALWEG_OK);
  exact.name = nullptr;
  EXPECT_EQ(set(), TALWEG_OK);  // the unknown field is ignored
  exact.size = 3;
  expect(TALWEG_BAD_USAGE, set(), "a field that is too small");
  fields[1] = nullptr;
  expect(TALWEG_BAD_USAGE, set(), "a null field");
  c.fields = nullptr;
  expect(TALWEG_BAD_USAGE, set(), "no list of fields");
}

TEST_P(Interface, AFailingSinkEndsTheRun) {
  set_up();
  FailingSink all;
  talweg_sink sink = all.sink();
  ASSERT_EQ(plugin_.run(instance_, &sink), TALWEG_OK) << plugin_.last_error(instance_);
  ASSERT_GT(all.given, 0);
  for (int k = 1; k <= all.given; k += 1 + all.given / 20) {
    for (const bool throws : {false, true}) {
      FailingSink failing{k, 0, throws};
      sink = failing.sink();
      const talweg_status status = plugin_.run(instance_, &sink);
      EXPECT_EQ(status,
                throws ? talweg_status{TALWEG_INTERNAL} : talweg_status{TALWEG_HOST_FAILED});
      EXPECT_EQ(failing.given, k) << "nothing is given after a failure";
    }
  }
  FailingSink again;
  sink = again.sink();
  EXPECT_EQ(plugin_.run(instance_, &sink), TALWEG_OK);
  EXPECT_EQ(again.given, all.given);
}

TEST_P(Interface, ACallFromACallbackIsRefused) {
  set_up();
  struct Context {
    const talweg_plugin& plugin;
    talweg_instance* instance;
    int refused = 0;
  } context{plugin_, instance_};
  talweg_sink sink = {};
  sink.size = sizeof sink;
  sink.context = &context;
  sink.report = [](void* own, const talweg_report_entry*) -> talweg_status {
    auto& c = *static_cast<Context*>(own);
    talweg_sink inner = {};
    inner.size = sizeof inner;
    if (c.plugin.run(c.instance, &inner) == TALWEG_BAD_USAGE) ++c.refused;
    if (c.plugin.reset(c.instance, c.plugin.parameters[0]->id) == TALWEG_BAD_USAGE) ++c.refused;
    EXPECT_STRNE(c.plugin.last_error(c.instance), "");
    return TALWEG_OK;
  };
  sink.curve = [](void* own, const talweg_curve*) -> talweg_status {
    ++static_cast<Context*>(own)->refused;
    return TALWEG_OK;
  };
  EXPECT_EQ(plugin_.run(instance_, &sink), TALWEG_OK);
  EXPECT_GT(context.refused, 0);
}

TEST_P(Interface, BadAttributesAreRefused) {
  const talweg_meshes* extension = meshes();
  if (extension == nullptr) {
    EXPECT_TRUE(GetParam() != "talweg.cut" && GetParam() != "talweg.labels" &&
                GetParam() != "talweg.repair");
    return;
  }
  ASSERT_GE(extension->size, sizeof *extension);
  const std::vector<double> values(subject_.lists.points.size(), 1);
  talweg_attribute good = {sizeof good,
                           TALWEG_OF_VERTICES,
                           TALWEG_CARRY_LINEAR,
                           0,
                           "a",
                           0,
                           host::view(values.data(), values.size()),
                           plugin::kNoArray};
  const talweg_attribute* list[] = {&good};
  const talweg_attribute* nulls[] = {nullptr};
  expect(TALWEG_BAD_USAGE, extension->set_attributes(instance_, list, 1), "before the mesh");
  set_up();
  EXPECT_EQ(extension->set_attributes(nullptr, list, 1), TALWEG_BAD_USAGE);
  expect(TALWEG_BAD_USAGE, extension->set_attributes(instance_, nullptr, 1), "no list");
  expect(TALWEG_BAD_USAGE, extension->set_attributes(instance_, nulls, 1), "null in the list");
  expect(TALWEG_BAD_USAGE, extension->set_attributes(instance_, list, UINT64_MAX), "too many");
  EXPECT_EQ(extension->set_attributes(instance_, nullptr, 0), TALWEG_OK);
  EXPECT_EQ(extension->set_attributes(instance_, list, 1), TALWEG_OK);
  const auto refuse = [&](const char* what, auto change) {
    talweg_attribute bad = good;
    change(bad);
    const talweg_attribute* one[] = {&bad};
    expect(TALWEG_BAD_USAGE, extension->set_attributes(instance_, one, 1), what);
  };
  refuse("size", [](talweg_attribute& a) { a.size = 8; });
  refuse("name", [](talweg_attribute& a) { a.name = nullptr; });
  refuse("element", [](talweg_attribute& a) { a.element = 0; });
  refuse("rule", [](talweg_attribute& a) { a.carry = 0; });
  refuse("fill", [](talweg_attribute& a) { a.fill = std::nan(""); });
  refuse("rows", [](talweg_attribute& a) { --a.values.rows; });
  refuse("columns", [](talweg_attribute& a) { a.values.columns = 0; });
  refuse("columns", [](talweg_attribute& a) { a.values.columns = 65; });
  refuse("type", [](talweg_attribute& a) { a.values.type = 77; });
  refuse("null", [](talweg_attribute& a) { a.values.data = nullptr; });
  refuse("corners", [](talweg_attribute& a) { a.corners = a.values; });

  const auto take = [](void*, const talweg_attribute*) -> talweg_status { return TALWEG_OK; };
  const auto fail = [](void*, const talweg_attribute*) -> talweg_status { return TALWEG_INTERNAL; };
  const auto take_origin = [](void*, const talweg_origin*) -> talweg_status { return TALWEG_OK; };
  expect(TALWEG_BAD_USAGE, extension->attributes(instance_, 0, take, nullptr), "before a run");
  expect(TALWEG_BAD_USAGE, extension->origin(instance_, 0, take_origin, nullptr), "before a run");
  FailingSink all;
  const talweg_sink sink = all.sink();
  ASSERT_EQ(plugin_.run(instance_, &sink), TALWEG_OK) << plugin_.last_error(instance_);
  EXPECT_EQ(extension->attributes(instance_, 0, take, nullptr), TALWEG_OK);
  EXPECT_EQ(extension->origin(instance_, 0, take_origin, nullptr), TALWEG_OK);
  expect(TALWEG_HOST_FAILED, extension->attributes(instance_, 0, fail, nullptr), "the host fails");
  expect(TALWEG_BAD_USAGE, extension->attributes(instance_, 1, take, nullptr), "no such mesh");
  expect(TALWEG_BAD_USAGE, extension->attributes(instance_, 0, nullptr, nullptr), "no function");
  expect(TALWEG_BAD_USAGE, extension->origin(instance_, 0, nullptr, nullptr), "no function");
}

TEST_P(Interface, AHostNeedNotOfferServices) {
  const auto null_extension = [](const talweg_host*, const char*) -> const void* {
    return nullptr;
  };
  const auto small = [](const talweg_host*, const char*) -> const void* {
    static const std::uint32_t size = 4;
    return &size;
  };
  const auto empty = [](const talweg_host*, const char* id) -> const void* {
    static const talweg_host_log log = {sizeof log, nullptr};
    static const talweg_host_progress progress = {sizeof progress, nullptr};
    return std::strcmp(id, TALWEG_HOST_LOG) == 0 ? static_cast<const void*>(&log) : &progress;
  };
  using Get = const void* (*)(const talweg_host*, const char*);
  for (const Get get : {Get{nullptr}, Get{null_extension}, Get{small}, Get{empty}}) {
    talweg_host host = {};
    host.size = sizeof host;
    host.interface_major = TALWEG_INTERFACE_MAJOR;
    host.get_extension = get;
    plugin_.destroy(instance_);
    ASSERT_EQ(plugin_.create(&host, &instance_), TALWEG_OK);
    set_up();
    FailingSink all;
    const talweg_sink sink = all.sink();
    EXPECT_EQ(plugin_.run(instance_, &sink), TALWEG_OK);
    plugin_.destroy(instance_);  // before the host is destroyed
    instance_ = nullptr;
  }
  talweg_host small_host = {};
  small_host.size = 4;
  EXPECT_EQ(plugin_.create(&small_host, &instance_), TALWEG_BAD_USAGE);
  EXPECT_EQ(instance_, nullptr);
}

TEST_P(Interface, InstancesOfOtherPluginsAreRefused) {
  for (const std::string& id : all_plugins()) {
    if (id == plugin_.id) continue;
    const talweg_plugin* other = &test::plugin_of_this_build(id.c_str());
    talweg_instance* foreign = nullptr;
    ASSERT_EQ(other->create(nullptr, &foreign), TALWEG_OK);
    EXPECT_EQ(plugin_.share_mesh(instance_, foreign), TALWEG_BAD_USAGE);
    EXPECT_EQ(plugin_.reset(foreign, "tau"), TALWEG_BAD_USAGE);
    plugin_.cancel(foreign);
    plugin_.destroy(foreign);  // an instance of another plugin
    other->destroy(foreign);
  }
}

TEST(InterfaceTests, CoverEveryPluginOfTheLoader) {
  const test::Loader loader = test::open_loader();
  std::vector<std::string> found;
  for (std::uint64_t k = 0; k < talweg_loader_count(loader.get()); ++k) {
    found.emplace_back(talweg_loader_plugin(loader.get(), k)->id);
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(all_plugins(), found);
}

INSTANTIATE_TEST_SUITE_P(Plugins, Interface, testing::ValuesIn(all_plugins()),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           for (char& c : name) c = c == '.' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace talweg
