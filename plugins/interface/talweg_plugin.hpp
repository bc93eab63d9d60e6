// For authors of plugins in C++20: a class becomes a plugin. Header-only; no C++ type crosses the
// boundary to the host. Exceptions become a status and last_error. docs/plugins.md shows a plugin
// made with it.
//
//   class Mine {
//    public:
//     static talweg_plugin about();                      // id, label, version, doc, flags
//     static std::vector<talweg_parameter> parameters();  // number(...), choice(...), ...
//     static std::vector<talweg_output> outputs();        // output(...)
//     explicit Mine(const talweg::plugin::Services& services);  // outlives the object
//     void set_mesh(const talweg_mesh& mesh);             // or (mesh, const Parameters&)
//     void set_curves(std::span<const talweg_curve* const> curves);  // with TALWEG_TAKES_CURVES
//     void prepare(const Parameters& parameters);         // before set_curves() and run(); may be
//                                                         // left out
//     void share_mesh(const Mine& other);                 // may be left out
//     void run(Parameters& parameters, Outputs& outputs); // compute all, then give
//     // To offer talweg_meshes.h:
//     static constexpr std::uint32_t kTakes = TALWEG_TAKES_ATTRIBUTES;
//     void set_attributes(std::span<const talweg_attribute* const> attributes);
//     void give_attributes(std::uint64_t mesh, const TakeAttribute& take) const;
//     void give_origin(std::uint64_t mesh, const TakeOrigin& take) const;
//     // To offer talweg_cut_plan.h:
//     void give_cut_plan(const TakeCutPlan& take) const;
//   };
//   TALWEG_PLUGIN_MODULE(Mine)
#pragma once

#include <atomic>
#include <concepts>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "talweg_arrays.hpp"
#include "talweg_cut_plan.h"
#include "talweg_meshes.h"
#include "talweg_parameters.hpp"
#include "talweg_plugin.h"

namespace talweg::plugin {

/// The host's services. If there is no host, or it does not offer a service, the call does nothing.
class Services {
 public:
  Services(const talweg_host* host, const std::atomic<bool>& cancelled)
      : host_(host),
        cancelled_(&cancelled),
        log_(extension<talweg_host_log>(TALWEG_HOST_LOG)),
        progress_(extension<talweg_host_progress>(TALWEG_HOST_PROGRESS)) {}

  void log(std::uint32_t severity, const std::string& message) const {
    if (log_ != nullptr && log_->log != nullptr) log_->log(host_, severity, message.c_str());
  }
  /// False if the host wants the call to end; the plugin must then throw cancelled().
  [[nodiscard]] bool go_on(const char* stage, double fraction) const {
    if (cancelled_->load(std::memory_order_relaxed)) return false;
    if (progress_ == nullptr || progress_->progress == nullptr) return true;
    return progress_->progress(host_, stage, fraction) != 0;
  }
  static Failure cancelled() { return {TALWEG_CANCELLED, "Cancelled."}; }

 private:
  /// Null if the host does not offer the extension, or offers a struct that is too small.
  template <class Extension>
  const Extension* extension(const char* id) const {
    if (host_ == nullptr || host_->get_extension == nullptr) return nullptr;
    const auto* found = static_cast<const Extension*>(host_->get_extension(host_, id));
    return found != nullptr && found->size >= sizeof(Extension) ? found : nullptr;
  }

  const talweg_host* host_;
  const std::atomic<bool>* cancelled_;
  const talweg_host_log* log_;
  const talweg_host_progress* progress_;
};

/// The host's sink for results. When one of its functions fails, the run ends.
class Outputs {
 public:
  explicit Outputs(const talweg_sink& sink) : sink_(sink) {}

  [[nodiscard]] bool wants_curves() const { return sink_.curve != nullptr; }
  [[nodiscard]] bool wants_point_fields() const {
    return wants_curves() && (sink_.wants & TALWEG_WANT_POINT_FIELDS) != 0;
  }
  [[nodiscard]] bool wants_fields() const { return sink_.field != nullptr; }
  [[nodiscard]] bool wants_report() const { return sink_.report != nullptr; }
  [[nodiscard]] bool wants_meshes() const { return sink_.mesh != nullptr; }

  void curve(talweg_curve curve) const {
    curve.size = sizeof curve;
    if (wants_curves()) check(sink_.curve(sink_.context, &curve));
  }
  void field(talweg_field field) const {
    field.size = sizeof field;
    if (wants_fields()) check(sink_.field(sink_.context, &field));
  }
  void mesh(talweg_mesh mesh) const {
    mesh.size = sizeof mesh;
    if (wants_meshes()) check(sink_.mesh(sink_.context, &mesh));
  }
  void report(std::int64_t curve, const char* key, double value,
              std::uint32_t type = TALWEG_VALUE_NUMBER) const {
    entry({sizeof(talweg_report_entry), type, curve, key, 0, 1, &value, nullptr});
  }
  void report(std::int64_t curve, const char* key, const char* text) const {
    entry({sizeof(talweg_report_entry), TALWEG_VALUE_TEXT, curve, key, 0, 1, nullptr, &text});
  }
  void entry(const talweg_report_entry& entry) const {
    if (wants_report()) check(sink_.report(sink_.context, &entry));
  }

 private:
  static void check(talweg_status status) {
    if (status != TALWEG_OK) throw Failure(TALWEG_HOST_FAILED, "The host refused a result.");
  }
  const talweg_sink& sink_;
};

/// A function of the host that takes results of an extension. If it fails, the call ends.
template <class Struct>
class Taker {
 public:
  using Function = talweg_status (*)(void* context, const Struct* given);
  Taker(Function take, void* context) : take_(take), context_(context) {}
  void operator()(Struct given) const {
    given.size = sizeof given;
    if (take_(context_, &given) != TALWEG_OK) {
      throw Failure(TALWEG_HOST_FAILED, "The host refused a result.");
    }
  }

 private:
  Function take_;
  void* context_;
};
using TakeAttribute = Taker<talweg_attribute>;
using TakeOrigin = Taker<talweg_origin>;
using TakeCutPlan = Taker<talweg_cut_plan>;

inline talweg_output output(std::uint32_t kind, const char* name, const char* label,
                            const char* unit, const char* doc) {
  return {sizeof(talweg_output), kind, name, label, unit, doc};
}

/// The C functions of a plugin class.
template <class T>
class Adapter {
 public:
  static const talweg_plugin* plugin() { return &table().plugin; }

 private:
  /// The plugin's descriptions, at addresses that stay valid.
  struct Table {
    std::vector<talweg_parameter> parameters = T::parameters();
    std::vector<talweg_output> outputs = T::outputs();
    std::vector<const talweg_parameter*> parameter_list = addresses(parameters);
    std::vector<const talweg_output*> output_list = addresses(outputs);
    talweg_plugin plugin = T::about();

    Table() {
      plugin.size = sizeof plugin;
      plugin.parameter_count = static_cast<std::uint32_t>(parameters.size());
      plugin.output_count = static_cast<std::uint32_t>(outputs.size());
      plugin.parameters = parameter_list.data();
      plugin.outputs = output_list.data();
      plugin.create = create;
      plugin.destroy = destroy;
      plugin.set_mesh = set_mesh;
      plugin.share_mesh = share_mesh;
      plugin.set_curves = set_curves;
      plugin.set_number = set_number;
      plugin.set_choice = set_choice;
      plugin.set_array = set_array;
      plugin.reset = reset;
      plugin.run = run;
      plugin.cancel = cancel;
      plugin.last_error = last_error;
      own_extension = plugin.get_extension;
      plugin.get_extension = get_extension;
    }
    const void* (*own_extension)(const char* id) = nullptr;
  };

  struct Instance {
    explicit Instance(const talweg_host* host)
        : services(host, cancelled), parameters(table().parameters), worker(services) {}

    const Table* kind = &table();  // tells instances of different plugins apart
    std::atomic<bool> cancelled = false;
    std::atomic<bool> busy = false;
    std::string error;
    Services services;
    Parameters parameters;
    T worker;
    bool has_mesh = false;
    bool has_curves = false;
  };

  static const Table& table() {
    static const Table table;
    return table;
  }
  template <class E>
  static std::vector<const E*> addresses(const std::vector<E>& list) {
    std::vector<const E*> result;
    for (const E& element : list) result.push_back(&element);
    return result;
  }
  static Instance* own(talweg_instance* instance) { return reinterpret_cast<Instance*>(instance); }
  static constexpr bool kHasMeshes = requires { T::kTakes; };
  static constexpr bool kHasCutPlan = requires(const T& worker, const TakeCutPlan& take) {
    worker.give_cut_plan(take);
  };
  static constexpr bool kHasAttributes = [] {
    if constexpr (kHasMeshes) return (T::kTakes & TALWEG_TAKES_ATTRIBUTES) != 0;
    return false;
  }();
  static const void* get_extension(const char* id) noexcept {
    if (id == nullptr) return nullptr;
    if constexpr (kHasMeshes) {
      static constexpr talweg_meshes kMeshes = {sizeof kMeshes, T::kTakes,
                                                kHasAttributes ? set_attributes : nullptr,
                                                kHasAttributes ? attributes : nullptr, origin};
      if (std::string_view(id) == TALWEG_MESHES) return &kMeshes;
    }
    if constexpr (kHasCutPlan) {
      static constexpr talweg_cut_plans kPlans = {sizeof kPlans, 0, cut_plan};
      if (std::string_view(id) == TALWEG_CUT_PLAN) return &kPlans;
    }
    return table().own_extension == nullptr ? nullptr : table().own_extension(id);
  }
  [[noreturn]] static void bad(const char* message) { throw Failure(TALWEG_BAD_USAGE, message); }
  [[noreturn]] static void takes_no_curves() {
    throw Failure(TALWEG_UNSUPPORTED, "This plugin takes no curves.");
  }

  /// Runs one call: locks its instance, and turns exceptions into a status.
  template <class Body>
  static talweg_status call(talweg_instance* instance, Body body) noexcept {
    Instance* self = own(instance);
    if (self == nullptr || self->kind != &table()) return TALWEG_BAD_USAGE;
    if (self->busy.exchange(true)) return TALWEG_BAD_USAGE;
    const talweg_status status = attempt(*self, body);
    self->busy = false;
    return status;
  }
  template <class Body>
  static talweg_status attempt(Instance& self, Body body) noexcept {
    try {
      self.cancelled = false;
      self.error.clear();
      try {
        body(self);
        return TALWEG_OK;
      } catch (const Failure& failure) {
        self.error = failure.what();
        return failure.status();
      } catch (const std::bad_alloc&) {
        self.error = "There is not enough memory.";
        return TALWEG_OUT_OF_MEMORY;
      } catch (const std::exception& error) {
        self.error = error.what();
        if constexpr (requires { T::status_of(error); }) return T::status_of(error);
        return TALWEG_INTERNAL;
      } catch (...) {
        self.error = "An exception of an unknown kind was thrown.";
        return TALWEG_INTERNAL;
      }
    } catch (...) {  // no memory even for the message
      return TALWEG_OUT_OF_MEMORY;
    }
  }

  static talweg_status create(const talweg_host* host, talweg_instance** instance) noexcept {
    if (instance == nullptr) return TALWEG_BAD_USAGE;
    *instance = nullptr;
    if (host != nullptr && host->size < sizeof *host) return TALWEG_BAD_USAGE;
    try {
      *instance = reinterpret_cast<talweg_instance*>(new Instance(host));
      return TALWEG_OK;
    } catch (const std::bad_alloc&) {
      return TALWEG_OUT_OF_MEMORY;
    } catch (...) {
      return TALWEG_INTERNAL;
    }
  }
  static void destroy(talweg_instance* instance) noexcept {
    if (instance == nullptr || own(instance)->kind != &table()) return;
    delete own(instance);
  }
  static talweg_status set_mesh(talweg_instance* instance, const talweg_mesh* mesh) noexcept {
    return call(instance, [&](Instance& self) {
      if constexpr (requires { self.worker.set_mesh(*mesh, self.parameters); }) {
        self.worker.set_mesh(checked(mesh, "The mesh"), self.parameters);
      } else {
        self.worker.set_mesh(checked(mesh, "The mesh"));
      }
      self.has_mesh = true;
      self.has_curves = false;
    });
  }
  static talweg_status share_mesh(talweg_instance* instance,
                                  const talweg_instance* other) noexcept {
    return call(instance, [&](Instance& self) {
      const auto* from = reinterpret_cast<const Instance*>(other);
      if (from == nullptr || from->kind != &table())
        bad("other is not an instance of this plugin.");
      if (!from->has_mesh) bad("The other instance has no mesh.");
      if constexpr (requires { self.worker.share_mesh(from->worker); }) {
        self.worker.share_mesh(from->worker);
        self.has_mesh = true;
        self.has_curves = false;
      } else {
        throw Failure(TALWEG_UNSUPPORTED, "This plugin does not share meshes.");
      }
    });
  }
  static talweg_status set_curves(talweg_instance* instance, const talweg_curve* const* curves,
                                  std::uint64_t count) noexcept {
    return call(instance, [&](Instance& self) {
      if constexpr (requires { self.worker.set_curves({}); }) {
        if ((plugin()->flags & TALWEG_TAKES_CURVES) == 0) takes_no_curves();
        if (count == 0 || curves == nullptr) bad("There are no curves.");
        if (count >= UINT32_MAX) bad("There are too many curves.");
        for (std::uint64_t k = 0; k < count; ++k) checked(curves[k], "A curve");
        if (!self.has_mesh) bad("There is no mesh; set_mesh() comes first.");
        prepare(self);
        self.worker.set_curves({curves, static_cast<std::size_t>(count)});
        self.has_curves = true;
      } else {
        takes_no_curves();
      }
    });
  }
  static talweg_status set_number(talweg_instance* instance, const char* id,
                                  double value) noexcept {
    return call(instance, [&](Instance& self) { self.parameters.set_number(id, value); });
  }
  static talweg_status set_choice(talweg_instance* instance, const char* id,
                                  const char* value) noexcept {
    return call(instance, [&](Instance& self) { self.parameters.set_choice(id, value); });
  }
  static talweg_status set_array(talweg_instance* instance, const char* id,
                                 const talweg_array* values) noexcept {
    return call(instance, [&](Instance& self) { self.parameters.set_array(id, values); });
  }
  static talweg_status reset(talweg_instance* instance, const char* id) noexcept {
    return call(instance, [&](Instance& self) { self.parameters.reset(id); });
  }
  static talweg_status run(talweg_instance* instance, const talweg_sink* sink) noexcept {
    return call(instance, [&](Instance& self) {
      Outputs outputs(checked(sink, "The sink"));
      if (!self.has_mesh) bad("There is no mesh; set_mesh() comes first.");
      if ((plugin()->flags & TALWEG_TAKES_CURVES) != 0 && !self.has_curves) {
        bad("There are no curves; set_curves() comes first.");
      }
      prepare(self);
      self.worker.run(self.parameters, outputs);
    });
  }
  static void prepare(Instance& self) {
    if constexpr (requires { self.worker.prepare(self.parameters); }) {
      self.worker.prepare(self.parameters);
    }
  }
  static talweg_status set_attributes(talweg_instance* instance,
                                      const talweg_attribute* const* attributes,
                                      std::uint64_t count) noexcept {
    return call(instance, [&](Instance& self) {
      if (!self.has_mesh) bad("There is no mesh; set_mesh() comes first.");
      if (count > 0 && attributes == nullptr) bad("The list of attributes is null.");
      if (count >= UINT32_MAX) bad("There are too many attributes.");
      for (std::uint64_t k = 0; k < count; ++k) checked(attributes[k], "An attribute");
      if constexpr (kHasAttributes) {
        self.worker.set_attributes({attributes, static_cast<std::size_t>(count)});
      }
    });
  }
  static talweg_status attributes(talweg_instance* instance, std::uint64_t mesh,
                                  talweg_attribute_function take, void* context) noexcept {
    return call(instance, [&](Instance& self) {
      if (take == nullptr) bad("The function that takes attributes is null.");
      if constexpr (kHasAttributes) self.worker.give_attributes(mesh, {take, context});
    });
  }
  static talweg_status origin(talweg_instance* instance, std::uint64_t mesh,
                              talweg_origin_function take, void* context) noexcept {
    return call(instance, [&](Instance& self) {
      if (take == nullptr) bad("The function that takes the origin is null.");
      if constexpr (kHasMeshes) self.worker.give_origin(mesh, {take, context});
    });
  }
  static talweg_status cut_plan(talweg_instance* instance, talweg_cut_plan_function take,
                                void* context) noexcept {
    return call(instance, [&](Instance& self) {
      if (take == nullptr) bad("The function that takes the plan is null.");
      if constexpr (kHasCutPlan) self.worker.give_cut_plan({take, context});
    });
  }
  static void cancel(talweg_instance* instance) noexcept {
    if (instance != nullptr && own(instance)->kind == &table()) own(instance)->cancelled = true;
  }
  static const char* last_error(const talweg_instance* instance) noexcept {
    const auto* self = reinterpret_cast<const Instance*>(instance);
    if (self == nullptr || self->kind != &table()) return "This is not an instance of the plugin.";
    return self->busy ? "Another call on the instance is running." : self->error.c_str();
  }
};

/// The module that talweg_plugin_entry() returns, from functions that return its plugins.
template <const talweg_plugin* (*... plugins)()>
const talweg_module* module_of() noexcept {
  try {
    static const talweg_plugin* const list[] = {plugins()...};
    static const talweg_module module = {sizeof(talweg_module),  TALWEG_INTERFACE_MAJOR,
                                         TALWEG_INTERFACE_MINOR, 0,
                                         sizeof...(plugins),     list};
    return &module;
  } catch (...) {
    return nullptr;
  }
}

/// The module that talweg_plugin_entry() returns, from plugin classes.
template <class... Plugins>
const talweg_module* module_of() noexcept {
  return module_of<Adapter<Plugins>::plugin...>();
}

}  // namespace talweg::plugin

/// The module's entry point, written once in one source file. The arguments are all plugin classes
/// of the library. If the classes are in other source files, the arguments are functions, one for
/// each class, which return Adapter<Class>::plugin().
#define TALWEG_PLUGIN_MODULE(...)                                           \
  extern "C" TALWEG_PLUGIN_EXPORT const talweg_module* talweg_plugin_entry( \
      std::uint32_t host_major, std::uint32_t /*host_minor*/) {             \
    if (host_major != TALWEG_INTERFACE_MAJOR) return nullptr;               \
    return talweg::plugin::module_of<__VA_ARGS__>();                        \
  }
