// A plugin with OpenMesh: fewer faces, and the curves stay on them.
#include <iterator>
#include <vector>

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <talweg/plugin/talweg_plugin_openmesh.hpp>

namespace {

namespace tp = talweg::plugin;

class Decimate : public tp::OpenMeshWorker<OpenMesh::DefaultTraitsDouble> {
 public:
  using OpenMeshWorker::OpenMeshWorker;

  static talweg_plugin about() {
    talweg_plugin about = {};
    about.flags = TALWEG_TAKES_CURVES;
    about.id = "example.decimate";
    about.label = "Decimate";
    about.version = "1.0";
    about.doc = "Makes a mesh of fewer faces on which the curves still lie.";
    return about;
  }
  static std::vector<talweg_parameter> parameters() {
    return {tp::number("share", "Share of faces", "", 0.1, {0, 1, 0.01, 1},
                       "How many of the faces stay, if the curves let them go.")};
  }
  static std::vector<talweg_output> outputs() {
    return {tp::output(TALWEG_OUTPUT_MESH, "mesh", "Mesh", "", "With the mesh's attributes."),
            tp::output(TALWEG_OUTPUT_REPORT, "report", "Report", "", "How many faces it has.")};
  }

  void run(const tp::Parameters& parameters, const tp::Outputs& outputs) {
    Mesh mesh = this->mesh();  // its properties come along, and tell where everything is from
    mesh.request_vertex_status();
    mesh.request_edge_status();
    mesh.request_face_status();
    for (const Curve& curve : curves()) {
      for (const auto& point : curve.points) lock(mesh, point);
    }
    const auto faces = static_cast<double>(mesh.n_faces());
    Watch watch(services());
    OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
    decimater.add(quadric);
    decimater.initialize();
    decimater.set_observer(&watch);
    decimater.decimate_to_faces(0, static_cast<std::size_t>(parameters.number("share") * faces));
    if (watch.abort()) throw tp::Services::cancelled();
    const auto left = std::distance(mesh.faces_sbegin(), mesh.faces_end());
    outputs.report(-1, "faces", static_cast<double>(left), TALWEG_VALUE_INTEGER);
    give_mesh(outputs, mesh);
  }

 private:
  /// A vertex, or the corners of the face that a point lies in, stay where they are.
  static void lock(Mesh& mesh, const talweg::openmesh::CurvePoint& point) {
    if (point.vertex.is_valid()) mesh.status(point.vertex).set_locked(true);
    if (!point.face.is_valid()) return;
    for (const auto v : mesh.fv_range(point.face)) mesh.status(v).set_locked(true);
  }

  /// Asks the host now and then whether to go on.
  class Watch : public OpenMesh::Decimater::Observer {
   public:
    explicit Watch(const tp::Services& services) : Observer(1000), services_(services) {}
    void notify(std::size_t) override { stop_ = stop_ || !services_.go_on("decimate", 0.5); }
    bool abort() const override { return stop_; }

   private:
    const tp::Services& services_;
    bool stop_ = false;
  };
};

}  // namespace

TALWEG_PLUGIN_MODULE(Decimate)
