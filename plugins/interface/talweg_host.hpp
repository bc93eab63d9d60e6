// For hosts in C++20: instances of plugins as objects, errors as exceptions, results as vectors.
// Header-only, nothing of it crosses the boundary.
//
//   talweg::host::Services services("my program", "1.0");
//   talweg::host::Instance smooth(plugin, services);       // plugin: from talweg_loader_find()
//   smooth.set_mesh(view(xyz, n, 3), view(triangles, m, 3));
//   smooth.set_curves({curve});
//   for (double tau : {1.0, 2.0}) {
//     smooth.set("tau", tau);
//     talweg::host::Results results = smooth.run();
//   }
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "talweg_arrays.hpp"
#include "talweg_cut_plan.h"
#include "talweg_meshes.h"
#include "talweg_plugin.h"
#include "talweg_way_points.h"

namespace talweg::host {

using plugin::view;

/// A call that failed; what() is the plugin's sentence.
class Error : public std::runtime_error {
 public:
  Error(talweg_status status, const std::string& message)
      : std::runtime_error(message), status_(status) {}
  [[nodiscard]] talweg_status status() const { return status_; }

 private:
  talweg_status status_;
};

/// The host's services for plugins. It must not move, and must outlive the instances made with it.
/// The functions are called on the thread of the call that they serve. An exception from the
/// progress function counts as cancelling; one from the log function is ignored.
class Services {
 public:
  using Log = std::function<void(std::uint32_t severity, const char* message)>;
  using Progress = std::function<bool(const char* stage, double fraction)>;

  Services(std::string name, std::string version, Progress progress = {}, Log log = {})
      : name_(std::move(name)),
        version_(std::move(version)),
        progress_(std::move(progress)),
        log_(std::move(log)) {
    host_ = {sizeof host_,  TALWEG_INTERFACE_MAJOR, TALWEG_INTERFACE_MINOR,
             name_.c_str(), version_.c_str(),       this,
             get_extension};
  }
  Services(const Services&) = delete;
  Services& operator=(const Services&) = delete;

  [[nodiscard]] const talweg_host* host() const { return &host_; }

 private:
  static const Services& own(const talweg_host* host) {
    return *static_cast<const Services*>(host->context);
  }
  static const void* get_extension(const talweg_host* host, const char* id) noexcept {
    static constexpr talweg_host_progress kProgress = {sizeof kProgress, on_progress};
    static constexpr talweg_host_log kLog = {sizeof kLog, on_log};
    if (id == nullptr) return nullptr;
    if (own(host).progress_ && std::string_view(id) == TALWEG_HOST_PROGRESS) return &kProgress;
    if (own(host).log_ && std::string_view(id) == TALWEG_HOST_LOG) return &kLog;
    return nullptr;
  }
  static std::uint32_t on_progress(const talweg_host* host, const char* stage,
                                   double fraction) noexcept {
    try {
      return own(host).progress_(stage, fraction) ? 1 : 0;
    } catch (...) {
      return 0;
    }
  }
  static void on_log(const talweg_host* host, std::uint32_t severity,
                     const char* message) noexcept {
    try {
      own(host).log_(severity, message);
    } catch (...) {  // a failed log message must not end the work
      return;
    }
  }

  std::string name_, version_;
  Progress progress_;
  Log log_;
  talweg_host host_ = {};
};

struct Field {
  std::string name, unit;
  std::vector<double> values;
};

/// Input has `vertices`, or `faces` and `barycentrics`, or `positions`. Output has all of them.
struct Curve {
  bool closed = false;
  std::vector<std::uint32_t> vertices;  ///< out: TALWEG_NO_VERTEX if the point is not at a vertex
  std::vector<std::uint32_t> faces;
  std::vector<std::array<double, 3>> barycentrics;
  std::vector<std::array<double, 3>> positions;
  std::vector<std::uint32_t> pins;  ///< in: indices of points
  std::vector<Field> fields;        ///< out: values per point
  /// Marks of way-points and painted points, one for each point (talweg_way_points.h); empty if
  /// nothing is said of any. Out: those of the field with this name.
  std::vector<double> exact = {};
};

struct Mesh {
  std::vector<std::array<double, 3>> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Field> fields;
};

/// Values at vertices, triangles or corners of a mesh (talweg_meshes.h).
struct Attribute {
  std::string name;
  std::uint32_t element = TALWEG_OF_VERTICES;
  std::uint32_t carry = TALWEG_CARRY_LINEAR;
  double fill = 0;
  std::uint32_t columns = 1;
  std::vector<double> values;                         ///< rows side by side
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< of shared entries; else empty
  std::uint32_t type = TALWEG_FLOAT64;                ///< out: of the numbers that came
};

/// Where a mesh that a run gave comes from; as talweg_origin.
struct Origin {
  std::vector<std::array<std::uint32_t, 3>> vertices;
  std::vector<std::array<double, 3>> weights;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> closed, lengths;
  std::vector<std::array<std::uint32_t, 3>> chains;
};

/// What a cut changes; as talweg_cut_plan.
struct CutPlan {
  std::uint64_t vertex_count = 0, triangle_count = 0;
  std::vector<std::array<std::uint32_t, 3>> vertices;
  std::vector<std::array<double, 3>> weights, positions;
  std::vector<std::uint32_t> divided, parts;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> closed, lengths, chains;
};

struct ReportEntry {
  std::int64_t curve = -1;
  std::string key;
  std::uint32_t type = TALWEG_VALUE_NUMBER;
  bool is_list = false;
  std::vector<double> numbers;
  std::vector<std::string> texts;
};

struct Results {
  std::vector<Curve> curves;
  std::vector<Field> fields;  ///< per vertex or triangle of the mesh
  std::vector<ReportEntry> report;
  std::vector<Mesh> meshes;

  /// Null if there is no such entry. `curve` -1: the entry for all curves.
  [[nodiscard]] const ReportEntry* find(std::string_view key, std::int64_t curve = -1) const {
    for (const ReportEntry& entry : report) {
      if (entry.curve == curve && entry.key == key) return &entry;
    }
    return nullptr;
  }
  /// The entry's only value, or the default if there is none.
  [[nodiscard]] double number(std::string_view key, std::int64_t curve = -1,
                              double otherwise = 0) const {
    const ReportEntry* entry = find(key, curve);
    return entry == nullptr || entry->numbers.empty() ? otherwise : entry->numbers.front();
  }
  [[nodiscard]] std::string text(std::string_view key, std::int64_t curve = -1) const {
    const ReportEntry* entry = find(key, curve);
    return entry == nullptr || entry->texts.empty() ? "" : entry->texts.front();
  }
};

/// The results that run() computes besides the curves and the report.
struct Wanted {
  bool point_fields = false;
  bool vertex_fields = false;
  bool meshes = false;
};

namespace detail {

template <std::size_t n>
talweg_array view_of(const std::vector<std::array<double, n>>& rows) {
  return view(rows.empty() ? nullptr : rows.front().data(), rows.size(), n);
}
inline talweg_array view_of(const std::vector<std::uint32_t>& values) {
  return view(values.data(), values.size());
}

/// Without the marks of the points.
inline talweg_curve view_of(const Curve& curve) {
  talweg_curve c = {};
  c.size = sizeof c;
  c.closed = curve.closed ? 1 : 0;
  c.vertices = view_of(curve.vertices);
  c.faces = view_of(curve.faces);
  c.barycentrics = view_of(curve.barycentrics);
  c.positions = view_of(curve.positions);
  c.pins = view_of(curve.pins);
  return c;
}

/// Views of curves, with the marks of their points. The curves must outlive it.
class CurveViews {
 public:
  explicit CurveViews(const std::vector<Curve>& curves) : fields_(curves.size()) {
    views_.reserve(curves.size());
    for (const Curve& curve : curves) add(curve, fields_[views_.size()]);
    for (const talweg_curve& curve : views_) list_.push_back(&curve);
  }
  CurveViews(const CurveViews&) = delete;
  CurveViews& operator=(const CurveViews&) = delete;

  [[nodiscard]] const talweg_curve* const* data() const { return list_.data(); }
  [[nodiscard]] std::uint64_t size() const { return list_.size(); }

 private:
  struct Exact {
    talweg_field field = {};
    const talweg_field* list = nullptr;
  };
  void add(const Curve& curve, Exact& exact) {
    views_.push_back(view_of(curve));
    if (curve.exact.empty()) return;
    exact.field = {sizeof exact.field, TALWEG_EXACT, "mesh units",
                   view(curve.exact.data(), curve.exact.size())};
    exact.list = &exact.field;
    views_.back().field_count = 1;
    views_.back().fields = &exact.list;
  }

  std::vector<Exact> fields_;
  std::vector<talweg_curve> views_;
  std::vector<const talweg_curve*> list_;
};

template <std::size_t n>
std::vector<std::array<double, n>> rows_of(const talweg_array& array, const char* what) {
  plugin::check_array(array, n, what);
  std::vector<std::array<double, n>> rows(plugin::count_of(array, 1));
  if (!rows.empty()) plugin::copy_numbers(array, n, what, rows.front().data());
  return rows;
}

inline Field copy(const talweg_field& field) {
  return {field.name, field.unit, plugin::numbers_of(field.values, 1, "A field")};
}

inline std::vector<Field> copy(const talweg_field* const* fields, std::uint32_t count) {
  std::vector<Field> result;
  for (std::uint32_t k = 0; k < count; ++k) result.push_back(copy(*fields[k]));
  return result;
}

/// Accepts TALWEG_NO_VERTEX as an index.
inline std::vector<std::uint32_t> vertices_of(const talweg_array& array) {
  plugin::check_array(array, 1, "The vertices");
  const auto* values = static_cast<const std::uint32_t*>(array.data);
  if (array.rows == 0) return {};
  return {values, values + array.rows};
}
inline std::vector<std::array<std::uint32_t, 3>> triples_of(const talweg_array& array) {
  plugin::check_array(array, 3, "The triples");
  std::vector<std::array<std::uint32_t, 3>> rows(plugin::count_of(array, 1));
  if (!rows.empty()) std::memcpy(rows.data(), array.data, sizeof rows[0] * rows.size());
  return rows;
}

inline talweg_attribute view_of(const Attribute& attribute) {
  const std::uint64_t rows =
      attribute.columns == 0 ? 0 : attribute.values.size() / attribute.columns;
  const talweg_array corners = attribute.corners.empty() ? plugin::kNoArray
                                                         : view(attribute.corners.front().data(),
                                                                attribute.corners.size(), 3);
  return {sizeof(talweg_attribute),
          attribute.element,
          attribute.carry,
          0,
          attribute.name.c_str(),
          attribute.fill,
          view(attribute.values.data(), rows, attribute.columns),
          corners};
}
inline Attribute copy(const talweg_attribute& attribute) {
  return {attribute.name,
          attribute.element,
          attribute.carry,
          attribute.fill,
          attribute.values.columns,
          plugin::numbers_of(attribute.values, attribute.values.columns, "An attribute"),
          triples_of(attribute.corners),
          attribute.values.type};
}
inline Origin copy(const talweg_origin& origin) {
  return {triples_of(origin.vertices),   rows_of<3>(origin.weights, "The weights"),
          vertices_of(origin.triangles), vertices_of(origin.closed),
          vertices_of(origin.lengths),   triples_of(origin.chains)};
}

inline CutPlan copy(const talweg_cut_plan& plan) {
  return {plan.vertex_count,
          plan.triangle_count,
          triples_of(plan.vertices),
          rows_of<3>(plan.weights, "The weights"),
          rows_of<3>(plan.positions, "The positions"),
          vertices_of(plan.divided),
          vertices_of(plan.parts),
          triples_of(plan.triangles),
          vertices_of(plan.closed),
          vertices_of(plan.lengths),
          vertices_of(plan.chains)};
}

inline Curve copy(const talweg_curve& curve) {
  Curve result{curve.closed != 0,
               vertices_of(curve.vertices),
               plugin::indices_of(curve.faces, 1, "The faces"),
               rows_of<3>(curve.barycentrics, "The barycentrics"),
               rows_of<3>(curve.positions, "The positions"),
               plugin::indices_of(curve.pins, 1, "The pins"),
               copy(curve.fields, curve.field_count),
               {}};
  for (const Field& field : result.fields) {
    if (field.name == TALWEG_EXACT) result.exact = field.values;
  }
  return result;
}

inline Mesh copy(const talweg_mesh& mesh) {
  Mesh result;
  result.positions = rows_of<3>(mesh.positions, "The positions");
  plugin::check_array(mesh.triangles, 3, "The triangles");
  result.triangles.resize(plugin::count_of(mesh.triangles, 1));
  if (!result.triangles.empty()) {
    plugin::copy_indices(mesh.triangles, 3, "The triangles", result.triangles.front().data());
  }
  result.fields = copy(mesh.fields, mesh.field_count);
  return result;
}

inline ReportEntry copy(const talweg_report_entry& entry) {
  ReportEntry result{entry.curve, entry.key, entry.type, entry.is_list != 0, {}, {}};
  for (std::uint32_t k = 0; k < entry.count; ++k) {
    if (entry.type == TALWEG_VALUE_TEXT) {
      result.texts.emplace_back(entry.texts[k]);
    } else {
      result.numbers.push_back(entry.numbers[k]);
    }
  }
  return result;
}

/// Copies a result into the list; if memory runs out, the run ends with TALWEG_HOST_FAILED.
template <class List, class View>
talweg_status append(List& list, const View& view) noexcept {
  try {
    list.push_back(copy(view));
    return TALWEG_OK;
  } catch (...) {
    return TALWEG_INTERNAL;
  }
}

}  // namespace detail

/// One workspace of a plugin. All methods except cancel() may be used by one thread at a time; they
/// throw Error.
class Instance {
 public:
  Instance(const talweg_plugin& plugin, const Services& services) : plugin_(&plugin) {
    const talweg_status status = plugin.create(services.host(), &instance_);
    if (status != TALWEG_OK) {
      throw Error(status, std::string(plugin.id) + ": an instance could not be made.");
    }
  }
  ~Instance() { plugin_->destroy(instance_); }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  [[nodiscard]] const talweg_plugin& plugin() const { return *plugin_; }

  /// Both have rows of 3; see view() and talweg_array.
  void set_mesh(const talweg_array& positions, const talweg_array& triangles) {
    const talweg_mesh mesh = {sizeof mesh, 0, positions, triangles, nullptr};
    check(plugin_->set_mesh(instance_, &mesh));
  }
  void share_mesh(const Instance& other) { check(plugin_->share_mesh(instance_, other.instance_)); }
  void set_curves(const std::vector<Curve>& curves) {
    const detail::CurveViews views(curves);
    check(plugin_->set_curves(instance_, views.data(), views.size()));
  }

  /// Throws Error(TALWEG_UNSUPPORTED) if the plugin takes none.
  void set_attributes(const std::vector<Attribute>& attributes) {
    std::vector<talweg_attribute> views;
    std::vector<const talweg_attribute*> list;
    for (const Attribute& attribute : attributes) views.push_back(detail::view_of(attribute));
    for (const talweg_attribute& view : views) list.push_back(&view);
    set_attributes(std::span<const talweg_attribute* const>(list));
  }
  /// The same of views, in types of their own.
  void set_attributes(std::span<const talweg_attribute* const> attributes) {
    if ((meshes().takes & TALWEG_TAKES_ATTRIBUTES) == 0) unsupported("takes no attributes");
    check(meshes().set_attributes(instance_, attributes.data(), attributes.size()));
  }
  /// The attributes of a mesh of the last run that gave meshes.
  [[nodiscard]] std::vector<Attribute> attributes(std::uint64_t mesh) const {
    if ((meshes().takes & TALWEG_TAKES_ATTRIBUTES) == 0) unsupported("gives no attributes");
    std::vector<Attribute> result;
    check(meshes().attributes(instance_, mesh, on_given<talweg_attribute, Attribute>, &result));
    return result;
  }
  [[nodiscard]] Origin origin(std::uint64_t mesh) const {
    std::vector<Origin> result;
    check(meshes().origin(instance_, mesh, on_given<talweg_origin, Origin>, &result));
    return std::move(result.at(0));
  }

  /// The plan of the last run of talweg.cut.
  [[nodiscard]] CutPlan cut_plan() const {
    const auto* found =
        static_cast<const talweg_cut_plans*>(plugin_->get_extension(TALWEG_CUT_PLAN));
    if (found == nullptr || found->size < sizeof *found) unsupported("gives no plan of a cut");
    std::vector<CutPlan> result;
    check(found->plan(instance_, on_given<talweg_cut_plan, CutPlan>, &result));
    return std::move(result.at(0));
  }

  void set(const char* id, double value) { check(plugin_->set_number(instance_, id, value)); }
  void set(const char* id, const char* value) { check(plugin_->set_choice(instance_, id, value)); }
  void set(const char* id, const std::string& value) { set(id, value.c_str()); }
  void set(const char* id, const std::vector<double>& field) {
    const talweg_array array = view(field.data(), field.size());
    check(plugin_->set_array(instance_, id, &array));
  }
  void set(const char* id, const std::vector<std::uint32_t>& vertices) {
    const talweg_array array = detail::view_of(vertices);
    check(plugin_->set_array(instance_, id, &array));
  }
  void reset(const char* id) { check(plugin_->reset(instance_, id)); }

  Results run(const Wanted& wanted = {}) {
    Results results;
    talweg_sink sink = {sizeof sink,
                        wanted.point_fields ? TALWEG_WANT_POINT_FIELDS : 0,
                        &results,
                        on_curve,
                        wanted.vertex_fields ? on_field : nullptr,
                        on_report,
                        wanted.meshes ? on_mesh : nullptr};
    check(plugin_->run(instance_, &sink));
    return results;
  }
  /// May be called from any thread: a running call ends soon, with Error of TALWEG_CANCELLED.
  void cancel() { plugin_->cancel(instance_); }

 private:
  [[nodiscard]] const talweg_meshes& meshes() const {
    const auto* found = static_cast<const talweg_meshes*>(plugin_->get_extension(TALWEG_MESHES));
    if (found == nullptr || found->size < sizeof *found) unsupported("gives no meshes");
    return *found;
  }
  [[noreturn]] void unsupported(const char* what) const {
    throw Error(TALWEG_UNSUPPORTED, std::string(plugin_->id) + " " + what + ".");
  }
  template <class Given, class Own>
  static talweg_status on_given(void* context, const Given* given) {
    return detail::append(*static_cast<std::vector<Own>*>(context), *given);
  }
  static Results& results(void* context) { return *static_cast<Results*>(context); }
  static talweg_status on_curve(void* context, const talweg_curve* curve) {
    return detail::append(results(context).curves, *curve);
  }
  static talweg_status on_field(void* context, const talweg_field* field) {
    return detail::append(results(context).fields, *field);
  }
  static talweg_status on_report(void* context, const talweg_report_entry* entry) {
    return detail::append(results(context).report, *entry);
  }
  static talweg_status on_mesh(void* context, const talweg_mesh* mesh) {
    return detail::append(results(context).meshes, *mesh);
  }
  void check(talweg_status status) const {
    if (status != TALWEG_OK) throw Error(status, plugin_->last_error(instance_));
  }

  const talweg_plugin* plugin_;
  talweg_instance* instance_ = nullptr;
};

}  // namespace talweg::host
