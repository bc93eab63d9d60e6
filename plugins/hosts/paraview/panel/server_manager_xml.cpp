#include "server_manager_xml.hpp"

#include <cctype>
#include <stdexcept>

#include <fmt/format.h>

namespace talweg::paraview {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

/// max_deviation: MaxDeviation. One filter has points of its own, which are called so.
std::string property_name(std::string_view id) {
  if (id == "points") return "DrawnPoints";
  std::string result;
  bool first = true;
  for (const char c : id) {
    if (c != '_') result += first ? static_cast<char>(std::toupper(c)) : c;
    first = c == '_';
  }
  return result;
}

/// What the property and its command are called, before its default value and its domain. Scripts
/// name properties by their labels, so there is none: ParaView makes it from the name.
std::string opening(const talweg_parameter& p, const char* kind, const char* command) {
  return fmt::format(
      "<{} name=\"{}\" command=\"{}\" initial_string=\"{}\" number_of_elements=\"1\" "
      "panel_visibility=\"{}\"",
      kind, property_name(p.id), command, p.id,
      (p.flags & TALWEG_ADVANCED) != 0 ? "advanced" : "default");
}

std::string documentation(const talweg_parameter& p, const std::string& more = {}) {
  std::string text = fmt::format("{}. {}", p.label, p.doc);
  if (*p.unit != '\0') text += fmt::format(" In {}.", p.unit);
  return fmt::format("<Documentation>{}</Documentation>", escaped(text + more));
}

/// A slider's range: lengths go with the mesh, everything else has its own.
std::string number_domain(const talweg_parameter& p) {
  if (std::string_view(p.unit) != "mesh units") {
    return fmt::format("<DoubleRangeDomain name=\"range\" min=\"{}\" max=\"{}\"/>", p.soft_minimum,
                       p.soft_maximum);
  }
  return "<BoundsDomain name=\"range\" mode=\"scaled_extent\" scale_factor=\"0.05\">"
         "<RequiredProperties><Property name=\"Input\" function=\"Input\"/></RequiredProperties>"
         "</BoundsDomain>";
}

std::string number_property(const talweg_parameter& p) {
  const bool optional = (p.flags & TALWEG_OPTIONAL) != 0;
  if (optional && p.minimum < 0) {
    throw std::runtime_error(fmt::format("{}: -1 cannot stand for its absence.", p.id));
  }
  // The domain must not choose the default.
  return fmt::format(
      "{} default_values=\"{}\">{}{}<Hints><NoDefault/></Hints>"
      "</DoubleVectorProperty>\n",
      opening(p, "DoubleVectorProperty", "SetNumber"), optional ? -1 : p.default_number,
      number_domain(p), documentation(p, optional ? " Below 0: not given." : ""));
}

std::string integer_property(const talweg_parameter& p) {
  if ((p.flags & TALWEG_OPTIONAL) != 0) {
    throw std::runtime_error(fmt::format("{}: no property for optional integers.", p.id));
  }
  return fmt::format(
      "{} default_values=\"{}\">"
      "<IntRangeDomain name=\"range\" min=\"{}\" max=\"{}\"/>{}"
      "</IntVectorProperty>\n",
      opening(p, "IntVectorProperty", "SetNumber"), p.default_number, p.soft_minimum,
      p.soft_maximum, documentation(p));
}

std::string boolean_property(const talweg_parameter& p) {
  return fmt::format(
      "{} default_values=\"{}\"><BooleanDomain name=\"bool\"/>{}"
      "</IntVectorProperty>\n",
      opening(p, "IntVectorProperty", "SetNumber"), p.default_number, documentation(p));
}

std::string choice_property(const talweg_parameter& p) {
  std::string choices;
  std::string labels;
  for (std::uint32_t k = 0; k < p.choice_count; ++k) {
    choices += fmt::format("<String value=\"{}\"/>", escaped(p.choices[k]));
    labels += fmt::format(" {}: {}.", p.choices[k], p.choice_labels[k]);
  }
  return fmt::format(
      "{} default_values=\"{}\"><StringListDomain name=\"choices\">{}"
      "</StringListDomain>{}</StringVectorProperty>\n",
      opening(p, "StringVectorProperty", "SetChoice"), escaped(p.default_choice), choices,
      documentation(p, labels));
}

std::string vertices_property(const talweg_parameter& p) {
  return fmt::format("{} default_values=\"\">{}</StringVectorProperty>\n",
                     opening(p, "StringVectorProperty", "SetVertices"),
                     documentation(p, " Numbers from 0, separated by spaces or commas."));
}

/// A text, since how many curves there are is not known before the filter runs. Their order is that
/// of the output, since joined segments come behind lines of the input that are longer.
std::string per_curve_property(const talweg_parameter& p) {
  return fmt::format(
      "{} default_values=\"\">{}</StringVectorProperty>\n",
      opening(p, "StringVectorProperty", "SetCurveNumbers"),
      documentation(p,
                    " Numbers in the order of the output's lines, separated by spaces or commas. "
                    "Empty: not given."));
}

std::string field_property(const talweg_parameter& p) {
  return fmt::format(
      "{} default_values=\"None\"><ArrayListDomain name=\"array_list\" none_string=\"None\" "
      "attribute_type=\"Scalars\" input_domain_name=\"arrays\">"
      "<RequiredProperties><Property name=\"Input\" function=\"Input\"/></RequiredProperties>"
      "</ArrayListDomain>{}<Hints><NoDefault/></Hints></StringVectorProperty>\n",
      opening(p, "StringVectorProperty", "SetField"),
      documentation(p, " A point array of the mesh."));
}

std::string property(const talweg_parameter& p) {
  switch (p.type) {
    case TALWEG_NUMBER:
      return number_property(p);
    case TALWEG_INTEGER:
      return integer_property(p);
    case TALWEG_BOOLEAN:
      return boolean_property(p);
    case TALWEG_CHOICE:
      return choice_property(p);
    case TALWEG_VERTICES:
      return vertices_property(p);
    case TALWEG_FIELD:
      return field_property(p);
    case TALWEG_PER_CURVE:
      return per_curve_property(p);
    default:  // of a later version of the interface: it keeps its default
      return "";
  }
}

constexpr const char* kMeshInput = R"(
<InputProperty name="Input" command="SetInputConnection" port_index="0">
  <ProxyGroupDomain name="groups"><Group name="sources"/><Group name="filters"/></ProxyGroupDomain>
  <DataTypeDomain name="input_type"><DataType value="vtkDataSet"/></DataTypeDomain>
  <InputArrayDomain name="arrays" attribute_type="point" number_of_components="1" optional="1"/>
  <Documentation>The mesh: triangles. Polygons and strips are cut into triangles, and of other data
    sets the outer surface is taken; a warning says so.</Documentation>
</InputProperty>
)";

/// The drawing as another pipeline object.
constexpr const char* kCurveInput = R"(
<InputProperty name="Curve" command="SetInputConnection" port_index="1">
  <ProxyGroupDomain name="groups"><Group name="sources"/><Group name="filters"/></ProxyGroupDomain>
  <DataTypeDomain name="input_type"><DataType value="vtkPointSet"/></DataTypeDomain>
  <InputArrayDomain name="arrays" attribute_type="point" number_of_components="1" optional="1"/>
  <Documentation>The drawing: lines, each a curve, segments joined; or points in their order. They
    are moved to the nearest points of the mesh. A point array named pin says which points stay,
    and one named exact which are meant exactly: a tolerance of 0 or more there.</Documentation>
</InputProperty>
<StringVectorProperty name="CurveIds" command="SetCurveIds" number_of_elements="1"
                      default_values="None" panel_visibility="advanced">
  <ArrayListDomain name="array_list" none_string="None" attribute_type="Scalars"
                   input_domain_name="arrays">
    <RequiredProperties><Property name="Curve" function="Input"/></RequiredProperties>
  </ArrayListDomain>
  <Documentation>A point array of the curve with vertex numbers of the mesh, used instead of
    positions and joined by shortest edge paths.</Documentation>
  <Hints><NoDefault/></Hints>
</StringVectorProperty>
)";

/// The drawing as points that are clicked.
constexpr const char* kPoints = R"(
<DoubleVectorProperty name="Points" command="SetPoint" set_number_command="SetNumberOfPoints"
                      use_index="1" repeat_command="1" number_of_elements_per_command="3"
                      number_of_elements="6" default_values="0 0 0 1 0 0">
  <Documentation>Points of the drawing in their order: x, y, z of each. They are moved to the
    nearest points of the mesh and joined straight over the surface. They are meant exactly: the
    curve passes through them and is free between them, and slack and largest deviation do not
    apply, unless DrawnPoints is rough.</Documentation>
</DoubleVectorProperty>
<IntVectorProperty name="Closed" command="SetClosed" number_of_elements="1" default_values="0">
  <BooleanDomain name="bool"/>
  <Documentation>The last point is joined to the first.</Documentation>
</IntVectorProperty>
<PropertyGroup label="Drawing" panel_widget="InteractivePolyLine">
  <Property name="Points" function="HandlePositions"/>
  <Property name="Closed" function="Closed"/>
</PropertyGroup>
)";

/// The drawing as numbers of vertices.
constexpr const char* kVertices = R"(
<StringVectorProperty name="PointIds" command="SetPointIds" number_of_elements="1"
                      default_values="">
  <Documentation>Vertices of the mesh, numbers from 0 separated by spaces or commas, joined by
    shortest edge paths. A list that repeats its first number is closed.</Documentation>
</StringVectorProperty>
)";

/// What else the filter does, and what a script can ask: how often each stage was done.
constexpr const char* kMore = R"(
<IntVectorProperty name="DistanceField" command="SetDistanceField" number_of_elements="1"
                   default_values="0">
  <BooleanDomain name="bool"/>
  <Documentation>The second output has the distance to the drawing at every vertex, computed once
    for each drawing: half a second on 100,000 faces, many seconds on a million.</Documentation>
</IntVectorProperty>
<IntVectorProperty name="MeshesOpened" command="GetMeshesOpened" information_only="1"
                   number_of_elements="1" default_values="0" panel_visibility="never">
  <SimpleIntInformationHelper/>
</IntVectorProperty>
<IntVectorProperty name="CurvesSet" command="GetCurvesSet" information_only="1"
                   number_of_elements="1" default_values="0" panel_visibility="never">
  <SimpleIntInformationHelper/>
</IntVectorProperty>
<IntVectorProperty name="Runs" command="GetRuns" information_only="1"
                   number_of_elements="1" default_values="0" panel_visibility="never">
  <SimpleIntInformationHelper/>
</IntVectorProperty>
)";

/// The input stays to be seen, and its mesh is not shown twice: ParaView 5.11 places points on what
/// comes out of a first output only.
constexpr const char* kEnd = R"(
<OutputPort index="0" name="Curve"/>
<OutputPort index="1" name="Mesh"/>
<Hints>
  <ShowInMenu category="Talweg"/>
  <Visibility replace_input="0"/>
  <View type="None" port="1"/>
</Hints>
</SourceProxy>
)";

/// The rest says what a plugin makes of curves that these filters give it otherwise.
std::string first_sentence(const std::string& text) { return text.substr(0, text.find(". ") + 1); }

std::string filter(const talweg_plugin& plugin, const char* name, const char* label,
                   const char* drawing) {
  const std::string doc = escaped(first_sentence(plugin.doc));
  std::string parameters;
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    parameters += property(*plugin.parameters[k]);
  }
  return fmt::format(
             "<SourceProxy name=\"{}\" class=\"vtkTalwegSmooth\" label=\"{}\">\n"
             "<Documentation short_help=\"{}\" long_help=\"{}\">{}</Documentation>",
             name, label, doc, doc, doc) +
         kMeshInput + drawing + parameters + kMore + kEnd;
}

}  // namespace

std::string server_manager_xml(const talweg_plugin& plugin) {
  return std::string("<ServerManagerConfiguration>\n<ProxyGroup name=\"filters\">\n") +
         filter(plugin, "TalwegSmoothCurve", "Talweg Smooth Curve", kCurveInput) +
         filter(plugin, "TalwegSmoothPoints", "Talweg Smooth Points", kPoints) +
         filter(plugin, "TalwegSmoothVertices", "Talweg Smooth Vertices", kVertices) +
         "</ProxyGroup>\n</ServerManagerConfiguration>\n";
}

}  // namespace talweg::paraview
