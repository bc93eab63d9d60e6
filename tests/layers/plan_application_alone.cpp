// Compiles with only OpenMesh and the headers of core/openmesh, for meshes of any traits.
#include "talweg/core/openmesh/plan_application.hpp"

struct AnyTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Color = OpenMesh::Vec4f;
  VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};
template <class Traits>
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

void apply(Mesh<OpenMesh::DefaultTraits>& coarse, Mesh<AnyTraits>& fine) {
  talweg::apply_plan(coarse, talweg::DivisionPlan());
  talweg::apply_plan(fine, talweg::DivisionPlan());
}
