// The state of a filter between its runs: an instance of a plugin, and the input that it last got,
// so that only changed input is passed again.
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

/// Values of parameters in the form of ParaView's properties.
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
/// The name of an array of the mesh's points or cells, empty for none, and the array's state.
struct FieldName {
  std::string name;
  bool of_cells = false;
  std::uint64_t time = 0;
  friend bool operator==(const FieldName&, const FieldName&) = default;
};
using Setting = std::variant<double, Choice, VertexList, CurveNumbers, FieldName>;

/// The data sets of curves, with their times of change. Equal origins mean equal curves.
struct Origin {
  const void* data = nullptr;
  std::uint64_t time = 0;
  const void* others = nullptr;
  std::uint64_t time_of_others = 0;
  std::uint64_t edits = 0;  ///< changes of the filter's own properties
  friend bool operator==(const Origin&, const Origin&) = default;
};
/// Both arguments may be null.
Origin origin_of(vtkDataObject* curves, vtkDataObject* others);

/// Methods throw host::Error if a plugin refuses its input, and std::runtime_error for other
/// errors. After an error all input is passed again.
class Session {
 public:
  /// Progress returns false to cancel; both are called on the caller's thread.
  Session(const char* plugin, host::Services::Progress progress, host::Services::Log log);

  /// Changes the plugin, and drops parameters, mesh and curves.
  void use(const std::string& plugin);
  /// False if the parameter had this value already.
  bool set(const std::string& id, Setting value);

  /// A parameter's value, or `otherwise` if it was not set.
  [[nodiscard]] double number(const std::string& id, double otherwise) const;

  /// Sets the mesh, with the parameters for its repair. False if neither has changed, as in
  /// take_curves().
  bool take_mesh(vtkDataSet& input);
  bool take_curves(const Origin& origin, const std::function<std::vector<host::Curve>()>& make);
  /// Joins the vertices of curves by shortest paths along edges.
  std::vector<host::Curve> along_edges(std::vector<host::Curve> curves);
  /// Sets the parameters that have changed on the plugin.
  void apply_settings();
  host::Results run(const host::Wanted& wanted);

  /// Whether the last mesh, which was taken or refused, is not a surface but can be repaired by the
  /// plugin talweg.repair.
  [[nodiscard]] bool can_be_repaired();

  [[nodiscard]] MeshInput& mesh() { return mesh_; }
  /// The array of the mesh that a parameter names; null if it names none.
  [[nodiscard]] vtkDataArray* array_of(const std::string& id) const;
  [[nodiscard]] const talweg_plugin& plugin() const;
  /// The plugin's instance, for parameters that are not properties and for extensions about meshes.
  host::Instance& instance();
  /// A counter of changes before the stage of the run: of meshes, curves and parameters of these
  /// stages.
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
