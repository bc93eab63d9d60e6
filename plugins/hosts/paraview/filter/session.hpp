// A session is what a filter keeps between its runs: an instance of a plugin, and what it was
// last given, so that only what has changed is given again.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "mesh_input.hpp"
#include "talweg/plugin/talweg_host.hpp"

namespace talweg::paraview {

/// Values of parameters as properties give them.
struct Choice {
  std::string id;
  friend bool operator==(const Choice&, const Choice&) = default;
};
struct VertexList {
  std::string numbers;
  friend bool operator==(const VertexList&, const VertexList&) = default;
};
/// A number for each curve; empty for none.
struct CurveNumbers {
  std::string numbers;
  friend bool operator==(const CurveNumbers&, const CurveNumbers&) = default;
};
/// The name of an array of the mesh, empty for none: of its points, or of its cells; and which
/// state of it.
struct FieldName {
  std::string name;
  bool of_cells = false;
  std::uint64_t time = 0;
  friend bool operator==(const FieldName&, const FieldName&) = default;
};
using Setting = std::variant<double, Choice, VertexList, CurveNumbers, FieldName>;

/// Data sets that curves were made of, and when these were: the same origin, the same curves.
struct Origin {
  const void* data = nullptr;
  std::uint64_t time = 0;
  const void* others = nullptr;
  std::uint64_t time_of_others = 0;
  std::uint64_t edits = 0;  ///< of the filter's own properties
  friend bool operator==(const Origin&, const Origin&) = default;
};
/// Either may be null.
Origin origin_of(vtkDataObject* curves, vtkDataObject* others);

/// Methods throw host::Error for what the plugins refuse, std::runtime_error for the rest. After
/// that everything is given anew.
class Session {
 public:
  /// Progress returns false to cancel; both are called on the caller's thread.
  Session(const char* plugin, host::Services::Progress progress, host::Services::Log log);

  /// From now on another plugin, without parameters, mesh and curves.
  void use(const std::string& plugin);
  /// False if the parameter had this value already.
  bool set(const std::string& id, Setting value);

  /// A parameter's value as it was set, else the other.
  [[nodiscard]] double number(const std::string& id, double otherwise) const;

  /// With what the parameters say of repair. False if there was nothing to do, as below.
  bool take_mesh(vtkDataSet& input);
  bool take_curves(const Origin& origin, const std::function<std::vector<host::Curve>()>& make);
  /// Curves of vertices that are no neighbours, joined by shortest edge paths.
  std::vector<host::Curve> along_edges(std::vector<host::Curve> curves);
  /// Gives what has changed of the parameters to the plugin.
  void apply_settings();
  host::Results run(const host::Wanted& wanted);

  /// Of the mesh that was taken last, or refused: it is no surface, but the plugin talweg.repair
  /// makes one of it.
  [[nodiscard]] bool can_be_repaired();

  [[nodiscard]] MeshInput& mesh() { return mesh_; }
  /// The array of the mesh that a parameter names; null if there is none.
  [[nodiscard]] vtkDataArray* array_of(const std::string& id) const;
  [[nodiscard]] const talweg_plugin& plugin() const;
  /// The plugin's, to set what is no property and to ask for what belongs to meshes.
  host::Instance& instance();
  /// Counts what changes more than a run: meshes, curves and parameters of these stages.
  [[nodiscard]] std::uint64_t state() const { return state_; }

  [[nodiscard]] int meshes_opened() const { return meshes_opened_; }
  [[nodiscard]] int curves_set() const { return curves_set_; }
  [[nodiscard]] int runs() const { return runs_; }

 private:
  void apply_settings_of_meshes();
  void apply_if_new(const talweg_parameter& parameter, const Setting& setting);
  void apply(const talweg_parameter& parameter, const Setting& value);
  void apply_number(const talweg_parameter& parameter, double value);
  void apply_curve_numbers(const talweg_parameter& parameter, const std::string& text);
  void apply_field(const char* id, const FieldName& field);
  [[nodiscard]] vtkDataArray* array(const FieldName& field) const;
  void check_is_one_number_each(const FieldName& field) const;
  [[nodiscard]] Setting current(Setting value) const;

  std::string id_;
  host::Services services_;
  std::unique_ptr<host::Instance> instance_, draw_;
  std::map<std::string, Setting> settings_, applied_;
  MeshInput mesh_;
  Origin origin_;
  bool has_mesh_ = false;
  bool has_curves_ = false;
  std::uint64_t state_ = 0;
  int meshes_opened_ = 0;
  int curves_set_ = 0;
  int runs_ = 0;
};

}  // namespace talweg::paraview
