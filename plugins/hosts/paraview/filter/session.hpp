// A session is what a filter keeps between its runs: an instance of talweg.smooth, and what it was
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
/// The name of a point array of the mesh, empty for none; and which state of it.
struct FieldName {
  std::string name;
  std::uint64_t time = 0;
  friend bool operator==(const FieldName&, const FieldName&) = default;
};
using Setting = std::variant<double, Choice, VertexList, CurveNumbers, FieldName>;

/// Curves and when they were made: the same origin, the same curves.
struct Origin {
  const void* data = nullptr;
  std::uint64_t time = 0;
  std::uint64_t edits = 0;  ///< of the filter's own properties
  friend bool operator==(const Origin&, const Origin&) = default;
};

/// Methods throw host::Error for what the plugins refuse, std::runtime_error for the rest. After
/// that everything is given anew.
class Session {
 public:
  /// Progress returns false to cancel; both are called on the caller's thread.
  Session(host::Services::Progress progress, host::Services::Log log);

  /// False if the parameter had this value already.
  bool set(const std::string& id, Setting value);

  void take_mesh(vtkDataSet& input);
  /// Curves of vertices that are no neighbours are joined by shortest edge paths.
  void take_curves(const Origin& origin, const std::function<std::vector<host::Curve>()>& make);
  /// Smooths. `with_distance`: distance() is valid after it.
  host::Results run(bool with_distance);

  [[nodiscard]] MeshInput& mesh() { return mesh_; }
  /// Per vertex of the mesh; computed once for each drawing.
  [[nodiscard]] const std::vector<double>& distance() const { return distance_; }

  [[nodiscard]] int meshes_opened() const { return meshes_opened_; }
  [[nodiscard]] int curves_set() const { return curves_set_; }
  [[nodiscard]] int runs() const { return runs_; }

 private:
  host::Instance& smooth();
  void apply_settings();
  void apply(const talweg_parameter& parameter, const Setting& value);
  void apply_number(const talweg_parameter& parameter, double value);
  void apply_curve_numbers(const talweg_parameter& parameter, const std::string& text);
  void apply_field(const char* id, const std::string& array);
  [[nodiscard]] Setting current(Setting value);
  std::vector<host::Curve> drawn(std::vector<host::Curve> curves);

  host::Services services_;
  std::unique_ptr<host::Instance> smooth_, draw_;
  std::map<std::string, Setting> settings_, applied_;
  MeshInput mesh_;
  Origin origin_;
  bool has_mesh_ = false;
  bool has_curves_ = false;
  bool has_distance_ = false;
  std::vector<double> distance_;
  int meshes_opened_ = 0;
  int curves_set_ = 0;
  int runs_ = 0;
};

}  // namespace talweg::paraview
