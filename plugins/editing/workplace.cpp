#include "workplace.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "clock.hpp"

namespace talweg::editing {
namespace {

bool has_parameter(const talweg_plugin& plugin, std::string_view id) {
  const talweg_parameter* const* end = plugin.parameters + plugin.parameter_count;
  return std::any_of(plugin.parameters, end,
                     [&](const talweg_parameter* parameter) { return parameter->id == id; });
}

/// The given points of a drawn curve, without the points that drawing added between them.
Curve given_points(const host::Curve& drawn) {
  const auto given = std::find_if(drawn.fields.begin(), drawn.fields.end(),
                                  [](const host::Field& field) { return field.name == "given"; });
  Curve curve;
  curve.closed = drawn.closed;
  for (std::size_t k = 0; k < drawn.faces.size(); ++k) {
    if (given != drawn.fields.end() && given->values[k] == 0) continue;
    const double exact = drawn.exact.empty() ? TALWEG_MARK_NONE : drawn.exact[k];
    curve.points.push_back({drawn.faces[k], drawn.barycentrics[k], false, exact});
  }
  return curve;
}

}  // namespace

LoadedPlugins::LoadedPlugins(talweg_loader* loader) : loader_(loader, talweg_loader_close) {
  if (loader_ == nullptr) throw std::bad_alloc();
}

Plugins::Plugins(const std::string& folders)
    : loaded_(talweg_loader_open(folders.empty() ? nullptr : folders.c_str())) {}

Plugins::Plugins(std::span<const talweg_linked_module> modules)
    : loaded_(talweg_loader_open_linked(modules.data(), modules.size(), nullptr)) {}

Plugins::~Plugins() {
  static auto& never_unloaded = *std::make_unique<std::vector<LoadedPlugins>>().release();
  if (!ending_.end()) never_unloaded.push_back(loaded_);
}

const talweg_plugin& LoadedPlugins::find(const char* id) const {
  if (const talweg_plugin* plugin = talweg_loader_find(loader_.get(), id)) return *plugin;
  throw Error(std::string("The plugin ") + id + " was not found in " +
              talweg_loader_folders(loader_.get()) +
              "; TALWEG_PLUGIN_PATH can name another folder.");
}

Workplace::Workplace(const Plugins& plugins, std::shared_ptr<const MeshArrays> mesh,
                     Defects defects, Ask ask)
    : plugins_(plugins.loaded()),
      mesh_(std::move(mesh)),
      defects_(defects),
      services_("Talweg editing", "1", std::move(ask),
                [this](std::uint32_t severity, const char* message) {
                  if (severity >= TALWEG_LOG_WARNING) notes_.emplace_back(message);
                }) {}

Outcome Workplace::work(const Request& request) {
  Outcome outcome;
  outcome.task = request.task;
  outcome.ticket = request.ticket;
  const double start = now_ms();
  try {
    do_task(request, outcome);
  } catch (const host::Error& error) {
    outcome.status = error.status();
    outcome.sentence = error.what();
  } catch (const Error& error) {
    outcome.status = TALWEG_BAD_USAGE;
    outcome.sentence = error.what();
  } catch (const std::exception& error) {
    outcome.status = TALWEG_INTERNAL;
    outcome.sentence = error.what();
  }
  outcome.milliseconds = now_ms() - start;
  outcome.notes = std::exchange(notes_, {});
  return outcome;
}

void Workplace::do_task(const Request& request, Outcome& outcome) {
  switch (request.task) {
    case Task::kOpen:
      return do_open(outcome);
    case Task::kSmooth:
      return do_smooth(request, outcome);
    case Task::kPlace:
      return do_place(request, outcome);
    case Task::kDistance:
      return do_distance(request, outcome);
    case Task::kDraw:
      return do_draw(request, outcome);
    case Task::kLeg:
      return do_leg(request, outcome);
    case Task::kSee:
      outcome.sight = std::make_shared<const Sight>(mesh_);
      return;
  }
}

const char* plugin_of(Task task) {
  switch (task) {
    case Task::kOpen:
    case Task::kSmooth:
      return "talweg.smooth";
    case Task::kPlace:
    case Task::kDraw:
    case Task::kLeg:
      return "talweg.draw";
    case Task::kDistance:
      return "talweg.distance";
    case Task::kSee:
      return "";
  }
  return "";
}

host::Instance& Workplace::opened(std::unique_ptr<host::Instance>& instance, const char* id) {
  if (!instance) {
    auto made = std::make_unique<host::Instance>(plugins_.find(id), services_);
    if (defects_ == Defects::kRepair) made->set("repair", 1.0);
    if (weld_within_ > 0) made->set("repair_weld_tolerance", weld_within_);
    set_mesh(*made, *mesh_);
    instance = std::move(made);
  }
  return *instance;
}

void Workplace::do_open(Outcome& outcome) {
  try {
    opened(smooth_, plugin_of(Task::kOpen));
  } catch (const host::Error& error) {
    if (error.status() != TALWEG_BAD_MESH) throw;
    outcome.status = error.status();
    outcome.sentence = error.what();
    if (defects_ == Defects::kRefuse) outcome.repair = repair_changes();
  }
}

/// The changes that a repair would make; empty if the mesh cannot be repaired, or if there is no
/// talweg.repair.
std::vector<std::string> Workplace::repair_changes() {
  try {
    host::Instance repair(plugins_.find("talweg.repair"), services_);
    set_mesh(repair, *mesh_);
    const host::Results results = repair.run();
    if (results.text("repair.verdict") != "usable") return {};
    const host::ReportEntry* changes = results.find("repair.changes");
    return changes == nullptr ? std::vector<std::string>() : changes->texts;
  } catch (const std::exception&) {
    return {};
  }
}

void Workplace::do_smooth(const Request& request, Outcome& outcome) {
  const std::vector<host::Curve> curves = host_curves(request.drawing);
  if (curves.empty()) return;
  host::Instance& instance = opened(smooth_, plugin_of(Task::kSmooth));
  if (!smoothed_ || stage_between(*smoothed_, request.drawing) == Stage::kCurves) {
    smoothed_.reset();
    instance.set_curves(curves);
  }
  smoothed_ = request.drawing;
  apply(request.drawing, instance);
  if (has_parameter(instance.plugin(), "preview")) {
    instance.set("preview", request.hand == Hand::kDrags ? 1.0 : 0.0);
  }
  if (request.hand == Hand::kRests) {
    instance.reset("deviation");
  } else {
    instance.set("deviation", "none");
  }
  outcome.results = instance.run(request.wanted);
}

void Workplace::do_place(const Request& request, Outcome& outcome) {
  host::Instance& instance = opened(draw_, plugin_of(Task::kDraw));
  instance.set("straight", 1.0);
  host::Wanted wanted;
  wanted.point_fields = true;
  for (const host::Curve& curve : request.curves) {
    // A curve without marks is a stroke: the user has not clicked its points.
    if (has_parameter(instance.plugin(), "points")) {
      instance.set("points", curve.exact.empty() ? "rough" : "exact");
    }
    instance.set_curves({curve});
    outcome.placed.push_back(given_points(instance.run(wanted).curves.at(0)));
  }
}

/// The curves are set only if they have changed, since the distance does not depend on tau.
void Workplace::do_distance(const Request& request, Outcome& outcome) {
  const std::vector<host::Curve> curves = host_curves(request.drawing);
  if (curves.empty()) throw Error("There is no curve to measure the distance to.");
  host::Instance& instance = opened(distance_, plugin_of(Task::kDistance));
  if (!measured_ || stage_between(*measured_, request.drawing) == Stage::kCurves) {
    measured_.reset();
    instance.set_curves(curves);
    measured_ = request.drawing;
  }
  instance.set("tau", request.drawing.settings.tau);
  if (request.drawing.settings.slack) {
    instance.set("slack", *request.drawing.settings.slack);
  } else {
    instance.reset("slack");
  }
  host::Wanted wanted;
  wanted.vertex_fields = true;
  outcome.results = instance.run(wanted);
}

host::Curve Workplace::drawn(const Curve& curve) {
  host::Instance& instance = opened(draw_, plugin_of(Task::kDraw));
  instance.set("straight", 1.0);
  Drawing alone;
  alone.curves.push_back(std::make_shared<const Curve>(curve));
  instance.set_curves(host_curves(alone));
  return std::move(instance.run().curves.at(0));
}

/// Draws the curves that are not in drawn_ yet. The plugin is opened even for a drawing without
/// curves, so that the first curve is drawn quickly.
void Workplace::do_draw(const Request& request, Outcome& outcome) {
  opened(draw_, plugin_of(Task::kDraw));
  decltype(drawn_) now;
  for (const auto& curve : request.drawing.curves) {
    if (curve->points.size() < 2) continue;
    const auto there = std::find_if(drawn_.begin(), drawn_.end(),
                                    [&](const auto& known) { return known.first == curve; });
    now.emplace_back(curve, there == drawn_.end() ? drawn(*curve) : there->second);
    outcome.results.curves.push_back(now.back().second);
  }
  drawn_ = std::move(now);
}

void Workplace::do_leg(const Request& request, Outcome& outcome) {
  for (const auto& curve : request.drawing.curves) {
    outcome.results.curves.push_back(drawn(*curve));
  }
}

}  // namespace talweg::editing
