#include "server_manager_xml.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "property_xml.hpp"

namespace talweg::paraview {
namespace {

/// The input mesh; some parameters name its arrays.
constexpr const char* kMeshInput = R"(
<InputProperty name="Input" label="Mesh" command="SetInputConnection" port_index="0">
  <ProxyGroupDomain name="groups"><Group name="sources"/><Group name="filters"/></ProxyGroupDomain>
  <DataTypeDomain name="input_type"><DataType value="vtkDataSet"/></DataTypeDomain>
  <InputArrayDomain name="arrays" attribute_type="point" number_of_components="1" optional="1"/>
  <InputArrayDomain name="cell_arrays" attribute_type="cell" number_of_components="1" optional="1"/>
  <Documentation>The mesh: triangles. Polygons and strips are cut into triangles, and of other data
    sets the outer surface is taken; a warning says so.</Documentation>
</InputProperty>
)";

/// Curves as another pipeline object. The array with vertices is a text: with a list of arrays,
/// ParaView 5.11 would print "Index out of range: 0" three times until curves are chosen.
constexpr const char* kCurveInput = R"(
<InputProperty name="Curve" command="SetInputConnection" port_index="1">
  <ProxyGroupDomain name="groups"><Group name="sources"/><Group name="filters"/></ProxyGroupDomain>
  <DataTypeDomain name="input_type"><DataType value="vtkPointSet"/></DataTypeDomain>
  <Documentation>The curves: lines, each a curve, segments joined; or points in their order. They
    are moved to the nearest points of the mesh. For smoothing a point array named pin says which
    points stay, and one named exact which are meant exactly: a tolerance of 0 or more
    there.</Documentation>
</InputProperty>
<StringVectorProperty name="CurveIds" command="SetCurveIds" number_of_elements="1"
                      default_values="" panel_visibility="advanced">
  <Documentation>The name of a point array of the curve with vertex numbers of the mesh, used
    instead of positions. Smoothing joins them by shortest edge paths, other filters straight over
    the surface.</Documentation>
</StringVectorProperty>
)";

/// Curves for a comparison.
constexpr const char* kOthersInput = R"(
<InputProperty name="Others" command="SetInputConnection" port_index="2">
  <ProxyGroupDomain name="groups"><Group name="sources"/><Group name="filters"/></ProxyGroupDomain>
  <DataTypeDomain name="input_type"><DataType value="vtkPointSet"/></DataTypeDomain>
  <Documentation>Curves that the others are compared with: as many one by one in their order, else
    all together.</Documentation>
  <Hints><Optional/></Hints>
</InputProperty>
)";

/// The drawing as clicked points.
constexpr const char* kPoints = R"(
<DoubleVectorProperty name="Points" command="SetPoint" set_number_command="SetNumberOfPoints"
                      use_index="1" repeat_command="1" number_of_elements_per_command="3"
                      number_of_elements="0">
  <Documentation>Points of the drawing in their order: x, y, z of each. They are moved to the
    nearest points of the mesh and joined straight over the surface. They are meant exactly: the
    curve passes through them and is free between them, and slack and largest deviation do not
    apply, unless DrawnPoints is rough. A new filter begins with points on the mesh.</Documentation>
</DoubleVectorProperty>
<IntVectorProperty name="Closed" command="SetClosed" number_of_elements="1" default_values="0">
  <BooleanDomain name="bool"/>
  <Documentation>The last point is joined to the first.</Documentation>
</IntVectorProperty>
<PropertyGroup label="Drawing" panel_widget="TalwegDrawing">
  <Property name="Points" function="HandlePositions"/>
  <Property name="Closed" function="Closed"/>
</PropertyGroup>
)";

/// The drawing as vertex indices.
constexpr const char* kVertices = R"(
<StringVectorProperty name="PointIds" command="SetPointIds" number_of_elements="1"
                      default_values="">
  <Documentation>Vertices of the mesh, numbers from 0 separated by spaces or commas, joined by
    shortest edge paths. A list that repeats its first number is closed.</Documentation>
</StringVectorProperty>
)";

constexpr const char* kDistance = R"(
<IntVectorProperty name="DistanceField" command="SetDistanceField" number_of_elements="1"
                   default_values="0">
  <BooleanDomain name="bool"/>
  <Documentation>The second output has the distance to the drawing at every vertex, computed once
    for each drawing, in seconds on a million faces. Far from the drawing it is about a per cent off
    on meshes of more than 100,000 points.</Documentation>
</IntVectorProperty>
)";

/// The text of the last run, for the panel.
constexpr const char* kOutcome = R"(
<StringVectorProperty name="Outcome" command="GetOutcome" information_only="1"
                      number_of_elements="1" default_values="" panel_widget="TalwegOutcome"
                      panel_visibility="default">
  <SimpleStringInformationHelper/>
  <Documentation>What the last run reached, what it warns of, or why there is no
    result.</Documentation>
</StringVectorProperty>
)";

/// Values of the last run, which the panel shows beside optional numbers.
constexpr const char* kReached = R"(
<DoubleVectorProperty name="SlackUsed" command="GetSlackUsed" information_only="1"
                      number_of_elements="1" default_values="0" panel_visibility="never">
  <SimpleDoubleInformationHelper/>
</DoubleVectorProperty>
<DoubleVectorProperty name="DeviationReached" command="GetDeviationReached" information_only="1"
                      number_of_elements="1" default_values="0" panel_visibility="never">
  <SimpleDoubleInformationHelper/>
</DoubleVectorProperty>
)";

/// Counters for scripts: the number of times that each stage was run.
constexpr const char* kCounts = R"(
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

/// The input stays visible, and the mesh of output 1 is hidden, so that the mesh is not shown
/// twice. Curves are output 0, since ParaView 5.11 places points only on objects of a first output.
constexpr const char* kSmoothEnd = R"(
<OutputPort index="0" name="Curve"/>
<OutputPort index="1" name="Mesh"/>
<OutputPort index="2" name="Report"/>
<Hints>
  <ShowInMenu category="Talweg"/>
  <Visibility replace_input="0"/>
  <View type="None" port="1"/>
  <View type="None" port="2"/>
  <InitializationHelper class="vtkSMTalwegStart" start_points="1" curves="0"/>
</Hints>
</SourceProxy>
)";

constexpr const char* kOffsetEnd = R"(
<OutputPort index="0" name="Curves"/>
<OutputPort index="1" name="Report"/>
<Hints>
  <ShowInMenu category="Talweg"/>
  <Visibility replace_input="0"/>
  <View type="None" port="1"/>
  <InitializationHelper class="vtkSMTalwegStart" curves="0"/>
</Hints>
</SourceProxy>
)";

constexpr const char* kCutEnd = R"(
<OutputPort index="0" name="Pieces"/>
<OutputPort index="1" name="Chains"/>
<Hints>
  <ShowInMenu category="Talweg"/>
  <InitializationHelper class="vtkSMTalwegStart" curves="1"/>
</Hints>
</SourceProxy>
)";

/// The cut mesh, with exact labels, is the visible one.
constexpr const char* kLabelsEnd = R"(
<OutputPort index="0" name="Borders"/>
<OutputPort index="1" name="Mesh"/>
<OutputPort index="2" name="Cut Mesh"/>
<OutputPort index="3" name="Report"/>
<Hints>
  <ShowInMenu category="Talweg"/>
  <View type="None" port="1"/>
  <View type="None" port="3"/>
  <InitializationHelper class="vtkSMTalwegStart" curves="0"/>
</Hints>
</SourceProxy>
)";

/// Any plugin that makes meshes; it need not exist when the panels are made.
constexpr const char* kRun = R"(
<SourceProxy name="TalwegPlugin" class="vtkTalwegRun" label="Talweg Plugin">
<Documentation short_help="Runs any plugin that makes meshes."
               long_help="Runs any plugin that makes meshes.">Runs any plugin that makes meshes,
  including plugins by others in the folders of TALWEG_PLUGIN_PATH.</Documentation>)";

constexpr const char* kRunProperties = R"(
<StringVectorProperty name="Plugin" command="SetPlugin" number_of_elements="1"
                      default_values="talweg.cut">
  <Documentation>The plugin's id; "talweg plugins" lists all plugins that were found.</Documentation>
</StringVectorProperty>
<StringVectorProperty name="Parameters" command="SetParameters" number_of_elements="1"
                      default_values="">
  <Documentation>Values of the plugin's parameters, such as share=0.1, separated by spaces; other
    parameters have their defaults. "talweg run PLUGIN --help" lists the parameters.</Documentation>
</StringVectorProperty>
)";

constexpr const char* kRepairEnd = R"(
<Hints><ShowInMenu category="Talweg"/></Hints>
</SourceProxy>
)";

constexpr const char* kMeasureEnd = R"(
<Hints>
  <ShowInMenu category="Talweg"/>
  <Visibility replace_input="0"/>
  <View type="SpreadSheetView"/>
</Hints>
</SourceProxy>
)";

/// Whether the filter sets a parameter from an input: Measure counts the curves of its third input.
bool is_given_by_an_input(const talweg_plugin& plugin, const talweg_parameter& p) {
  return std::string_view(plugin.id) == "talweg.measure" && std::string_view(p.id) == "others";
}

/// The first sentence of a plugin's description. The rest describes input that these filters take
/// in another form.
std::string first_sentence(const std::string& text) { return text.substr(0, text.find(". ") + 1); }

struct Filter {
  const char* plugin;
  const char* name;
  const char* label;
  const char* class_name;
  std::vector<const char*> inputs, more;  ///< properties before and after the parameters
  const char* end;
  const char* first = "";  ///< a parameter that users change often, shown before an input with a
                           ///< long table
};

std::string xml_of(const Filter& filter, const talweg_plugin& plugin) {
  const std::string doc = escaped(first_sentence(plugin.doc));
  std::string xml = fmt::format(
      "<SourceProxy name=\"{}\" class=\"{}\" label=\"{}\">\n"
      "<Documentation short_help=\"{}\" long_help=\"{}\">{}</Documentation>",
      filter.name, filter.class_name, filter.label, doc, doc, doc);
  xml += kOutcome;
  const auto parameters = [&](bool first) {
    for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
      const talweg_parameter& parameter = *plugin.parameters[k];
      if ((std::string_view(parameter.id) == filter.first) != first) continue;
      if (!is_given_by_an_input(plugin, parameter)) xml += property_xml(parameter);
    }
  };
  parameters(true);
  for (const char* property : filter.inputs) xml += property;
  parameters(false);
  for (const char* property : filter.more) xml += property;
  return xml + kCounts + filter.end;
}

const std::vector<Filter>& filters() {
  static const std::vector<Filter> all = {{"talweg.smooth",
                                           "TalwegSmoothCurve",
                                           "Talweg Smooth Curve",
                                           "vtkTalwegSmooth",
                                           {kMeshInput, kCurveInput},
                                           {kDistance, kReached},
                                           kSmoothEnd},
                                          {"talweg.smooth",
                                           "TalwegSmoothPoints",
                                           "Talweg Smooth Points",
                                           "vtkTalwegSmooth",
                                           {kMeshInput, kPoints},
                                           {kDistance, kReached},
                                           kSmoothEnd,
                                           "tau"},
                                          {"talweg.smooth",
                                           "TalwegSmoothVertices",
                                           "Talweg Smooth Vertices",
                                           "vtkTalwegSmooth",
                                           {kMeshInput, kVertices},
                                           {kDistance, kReached},
                                           kSmoothEnd},
                                          {"talweg.cut",
                                           "TalwegCut",
                                           "Talweg Cut",
                                           "vtkTalwegCut",
                                           {kMeshInput, kCurveInput},
                                           {},
                                           kCutEnd},
                                          {"talweg.offset",
                                           "TalwegOffset",
                                           "Talweg Offset",
                                           "vtkTalwegOffset",
                                           {kMeshInput, kCurveInput},
                                           {},
                                           kOffsetEnd},
                                          {"talweg.labels",
                                           "TalwegLabelBorders",
                                           "Talweg Label Borders",
                                           "vtkTalwegLabels",
                                           {kMeshInput},
                                           {},
                                           kLabelsEnd},
                                          {"talweg.repair",
                                           "TalwegRepair",
                                           "Talweg Repair",
                                           "vtkTalwegRepair",
                                           {kMeshInput},
                                           {},
                                           kRepairEnd},
                                          {"talweg.measure",
                                           "TalwegMeasure",
                                           "Talweg Measure",
                                           "vtkTalwegMeasure",
                                           {kMeshInput, kCurveInput, kOthersInput},
                                           {},
                                           kMeasureEnd}};
  return all;
}

}  // namespace

std::string server_manager_xml(const FindPlugin& plugin_named, bool own_widgets) {
  std::string xml = "<ServerManagerConfiguration>\n<ProxyGroup name=\"filters\">\n";
  for (const Filter& filter : filters()) xml += xml_of(filter, plugin_named(filter.plugin));
  xml +=
      std::string(kRun) + kOutcome + kMeshInput + kCurveInput + kRunProperties + kCounts + kCutEnd;
  if (!own_widgets) {
    constexpr std::string_view kOurs = "TalwegDrawing";
    const std::size_t at = xml.find(kOurs);
    if (at != std::string::npos) xml.replace(at, kOurs.size(), "InteractivePolyLine");
  }
  return xml + "</ProxyGroup>\n</ServerManagerConfiguration>\n";
}

}  // namespace talweg::paraview
