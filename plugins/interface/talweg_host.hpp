// For hosts in C++20: instances of plugins as objects, errors as exceptions, results as vectors.
// Header-only; no C++ type crosses the boundary to the plugin.
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

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "talweg_arrays.hpp"
#include "talweg_checked_copies.hpp"
#include "talweg_cut_plan.h"
#include "talweg_meshes.h"
#include "talweg_plugin.h"
#include "talweg_results.hpp"
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
/// Its functions are called on the thread of the plugin's call during which they are called. An
/// exception from the progress function counts as cancelling; one from the log function is ignored.
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

/// A view of a curve without the marks of its points.
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

/// Checks the results of one call of a plugin. The first wrong result ends the call with an error,
/// even if the plugin continues.
class ResultCheck {
 public:
  explicit ResultCheck(const Limits& mesh) : limits_(mesh) {}

  template <class List, class View>
  talweg_status append(List& list, const View* view) noexcept {
    try {
      if (failed()) return TALWEG_INTERNAL;
      list.push_back(checked_copy(plugin::checked(view, "A result"), limits_));
      return TALWEG_OK;
    } catch (const plugin::Failure& failure) {
      mistake_ = failure.what();
    } catch (...) {
      no_memory_ = true;
    }
    return TALWEG_INTERNAL;
  }
  void count_curve() { limits_.curves = std::max(limits_.curves, ++given_curves_); }
  /// Throws Error, whose sentence names the plugin, or std::bad_alloc.
  void throw_failure(const talweg_plugin& plugin) const {
    if (no_memory_) throw std::bad_alloc();
    if (mistake_.empty()) return;
    throw Error(TALWEG_INTERNAL,
                "The plugin " + std::string(plugin.id) + " gave an invalid result. " + mistake_);
  }

 private:
  [[nodiscard]] bool failed() const { return no_memory_ || !mistake_.empty(); }
  Limits limits_;
  std::uint64_t given_curves_ = 0;
  std::string mistake_;
  bool no_memory_ = false;
};

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

  /// Both arrays have 3 columns; see view() and talweg_array.
  void set_mesh(const talweg_array& positions, const talweg_array& triangles) {
    const talweg_mesh mesh = {sizeof mesh, 0, positions, triangles, nullptr};
    check(plugin_->set_mesh(instance_, &mesh));
    limits_ = {positions.rows, triangles.rows, 0};
  }
  void share_mesh(const Instance& other) {
    check(plugin_->share_mesh(instance_, other.instance_));
    limits_ = other.limits_;
  }
  void set_curves(const std::vector<Curve>& curves) {
    const detail::CurveViews views(curves);
    check(plugin_->set_curves(instance_, views.data(), views.size()));
    limits_.curves = curves.size();
  }

  /// Throws Error(TALWEG_UNSUPPORTED) if the plugin takes no attributes.
  void set_attributes(const std::vector<Attribute>& attributes) {
    std::vector<talweg_attribute> views;
    std::vector<const talweg_attribute*> list;
    for (const Attribute& attribute : attributes) views.push_back(detail::view_of(attribute));
    for (const talweg_attribute& view : views) list.push_back(&view);
    set_attributes(std::span<const talweg_attribute* const>(list));
  }
  /// Sets attributes given as views, which may have any type of numbers.
  void set_attributes(std::span<const talweg_attribute* const> attributes) {
    if ((meshes().takes & TALWEG_TAKES_ATTRIBUTES) == 0) unsupported("takes no attributes");
    check(meshes().set_attributes(instance_, attributes.data(), attributes.size()));
  }
  /// The attributes of a mesh of the last run with meshes as results.
  [[nodiscard]] std::vector<Attribute> attributes(std::uint64_t mesh) const {
    if ((meshes().takes & TALWEG_TAKES_ATTRIBUTES) == 0) unsupported("gives no attributes");
    return all_given<Attribute, talweg_attribute>([&](auto take, void* context) {
      return meshes().attributes(instance_, mesh, take, context);
    });
  }
  [[nodiscard]] Origin origin(std::uint64_t mesh) const {
    return one_given<Origin, talweg_origin>(
        [&](auto take, void* context) { return meshes().origin(instance_, mesh, take, context); });
  }

  /// The plan of the last run of talweg.cut. Throws Error(TALWEG_UNSUPPORTED) if the plugin has no
  /// plans.
  [[nodiscard]] CutPlan cut_plan() const {
    const auto* found =
        static_cast<const talweg_cut_plans*>(plugin_->get_extension(TALWEG_CUT_PLAN));
    if (found == nullptr || found->size < sizeof *found) unsupported("gives no plan of a cut");
    return one_given<CutPlan, talweg_cut_plan>(
        [&](auto take, void* context) { return found->plan(instance_, take, context); });
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
    Gathering<Results> gathering{{}, detail::ResultCheck(limits_)};
    talweg_sink sink = {sizeof sink,
                        wanted.point_fields ? TALWEG_WANT_POINT_FIELDS : 0,
                        &gathering,
                        on_curve,
                        wanted.vertex_fields ? on_field : nullptr,
                        on_report,
                        wanted.meshes ? on_mesh : nullptr};
    const talweg_status status = plugin_->run(instance_, &sink);
    gathering.check.throw_failure(*plugin_);
    check(status);
    return std::move(gathering.list);
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

  template <class List>
  struct Gathering {
    List list;
    detail::ResultCheck check;
  };
  /// The values that an extension's function passes one by one.
  template <class Own, class Given, class Call>
  std::vector<Own> all_given(const Call& call) const {
    using List = Gathering<std::vector<Own>>;
    List gathering{{}, detail::ResultCheck(limits_)};
    const talweg_status status = call(
        [](void* context, const Given* given) {
          auto& to = *static_cast<List*>(context);
          return to.check.append(to.list, given);
        },
        &gathering);
    gathering.check.throw_failure(*plugin_);
    check(status);
    return std::move(gathering.list);
  }
  template <class Own, class Given, class Call>
  Own one_given(const Call& call) const {
    std::vector<Own> all = all_given<Own, Given>(call);
    if (all.empty()) unsupported("gave an empty list");
    return std::move(all.front());
  }
  static Gathering<Results>& own(void* context) {
    return *static_cast<Gathering<Results>*>(context);
  }
  static talweg_status on_curve(void* context, const talweg_curve* curve) {
    own(context).check.count_curve();
    return own(context).check.append(own(context).list.curves, curve);
  }
  static talweg_status on_field(void* context, const talweg_field* field) {
    return own(context).check.append(own(context).list.fields, field);
  }
  static talweg_status on_report(void* context, const talweg_report_entry* entry) {
    return own(context).check.append(own(context).list.report, entry);
  }
  static talweg_status on_mesh(void* context, const talweg_mesh* mesh) {
    return own(context).check.append(own(context).list.meshes, mesh);
  }
  void check(talweg_status status) const {
    if (status == TALWEG_OK) return;
    const char* why = plugin_->last_error(instance_);
    throw Error(status, why != nullptr && *why != 0
                            ? std::string(why)
                            : "The plugin " + std::string(plugin_->id) + " gave the status " +
                                  std::to_string(status) + " and no reason.");
  }

  const talweg_plugin* plugin_;
  talweg_instance* instance_ = nullptr;
  detail::Limits limits_;
};

}  // namespace talweg::host
