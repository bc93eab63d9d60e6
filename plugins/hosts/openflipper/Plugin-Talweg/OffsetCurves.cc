#include "OffsetCurves.hh"

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>

#include "HostMesh.hh"

namespace talweg::openflipper {
namespace {

constexpr float kWidth = 3.0f;  // pixels

}  // namespace

std::vector<host::Curve> offset_of(const editing::Plugins& plugins,
                                   const editing::MeshArrays& arrays, editing::Defects defects,
                                   const std::vector<host::Curve>& curves, const Offset& offset,
                                   const std::function<void(const QString&)>& say) {
  const host::Services services("OpenFlipper", "Plugin-Talweg");
  host::Instance instance(plugins.find("talweg.offset"), services);
  if (defects == editing::Defects::kRepair) instance.set("repair", 1.0);
  instance.set("distance", offset.distance);
  instance.set("side", offset.side.toStdString());
  editing::set_mesh(instance, arrays);
  instance.set_curves(editing::courses(curves));
  host::Results results = instance.run();
  if (const host::ReportEntry* warnings = results.find("warnings")) {
    for (const std::string& sentence : warnings->texts) say(QString::fromStdString(sentence));
  }
  return std::move(results.curves);
}

std::vector<int> add_lines(HostCalls& host, const QString& name, const TriMesh& mesh,
                           const std::vector<host::Curve>& curves) {
  std::vector<int> ids;
  for (const host::Curve& curve : curves) {
    const int id = host.add_line(QString("%1 offset %2").arg(name).arg(ids.size() + 1));
    PolyLineObject* object = PluginFunctions::polyLineObject(id);
    if (object == nullptr) continue;
    fill(*object->line(), mesh, curve);
    object->materialNode()->set_line_width(kWidth);
    object->setObjectDrawMode(ACG::SceneGraph::DrawModes::WIREFRAME);
    host.show_line(id);
    ids.push_back(id);
  }
  return ids;
}

}  // namespace talweg::openflipper
