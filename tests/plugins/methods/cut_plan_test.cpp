// A host applies the plan of talweg.cut to its own OpenMesh mesh, as embed_curves() would.
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "core/openmesh_meshes.hpp"
#include "plugins/plugin_runs.hpp"
#include "talweg/core/openmesh/embed_curves.hpp"
#include "talweg/core/openmesh/plan_application.hpp"

namespace talweg {
namespace {

class PlanOfCut : public testing::Test {
 protected:
  PlanOfCut() {
    test::set_mesh(instance, subject.lists);
    instance.set_curves({subject.curve});
    std::mt19937 random(1);
    own.add_to(mesh, random);
  }
  /// A straight line through faces, from the middle of an edge to a quarter of that from a to b.
  [[nodiscard]] SurfaceCurve across_faces(std::uint32_t a, std::uint32_t b) const {
    const Surface& surface = subject.opened->surface();
    return StraightLines(surface).join(
        std::vector{test::between(surface, 0, 1, 0.5), test::between(surface, a, b, 0.25)}, false);
  }
  void expect_refused(const DivisionPlan& plan, const std::string& sentence) {
    const test::Written<test::DoubleMesh> before(mesh, own);
    try {
      apply_plan(mesh, plan);
      ADD_FAILURE() << "not refused: " << sentence;
    } catch (const PlanError& error) {
      EXPECT_EQ(error.what(), sentence);
    }
    EXPECT_EQ((test::Written<test::DoubleMesh>(mesh, own)), before);
  }

  test::Subject subject;
  host::Services services{"test", "1"};
  host::Instance instance{test::plugin_of_this_build("talweg.cut"), services};
  test::DoubleMesh mesh = test::openmesh_of<test::DoubleMesh>(subject.lists);
  test::OwnProperties own;
};

TEST_F(PlanOfCut, AppliedGivesTheEmbeddingOfTheLibrary) {
  const SurfaceCurve curve = across_faces(200, 201);
  instance.set_curves({test::as_host_curve(subject.opened->mesh(), curve)});
  instance.run();
  auto other = mesh;
  const AppliedPlan applied = apply_plan(mesh, division_from(instance.cut_plan()));
  const Embedding embedded = embed_curves(other, std::span(&curve, 1));
  EXPECT_GT(applied.vertices.size(), 5U);
  EXPECT_TRUE(test::is_sound(mesh));
  EXPECT_EQ((test::Written<test::DoubleMesh>(mesh, own)),
            (test::Written<test::DoubleMesh>(other, own)));
  EXPECT_EQ(applied.chains, embedded.chains);
}

TEST_F(PlanOfCut, IsRefusedByAnotherMesh) {
  instance.set_curves({test::as_host_curve(subject.opened->mesh(), across_faces(200, 201))});
  instance.run();
  const DivisionPlan plan = division_from(instance.cut_plan());
  auto missing = plan;
  missing.parts.pop_back();
  expect_refused(missing,
                 "The lists of the plan do not fit together: each new vertex needs weights and a "
                 "position, and the parts of the faces must add up to the number of triangles.");
  auto weightless = plan;
  weightless.weights[0][0] = 0;
  expect_refused(weightless, "New vertex 0 of the plan lies on no edge and in no face.");
  auto nowhere = plan;
  nowhere.positions[0][1] = HUGE_VAL;
  expect_refused(nowhere, "New vertex 0 of the plan has no position.");
  auto unknown = plan;
  unknown.triangles[0][0] = 4000000;
  EXPECT_THROW(apply_plan(mesh, unknown), PlanError);
  auto twisted = plan;
  std::swap(twisted.triangles[0][0], twisted.triangles[0][1]);
  expect_refused(twisted,
                 "Face " + std::to_string(plan.faces[0]) +
                     " does not have the sides that are to be divided: the mesh has changed since "
                     "the plan was made, or the plan belongs to another mesh.");
  auto one_sided = plan;  // the last face stays whole, and its neighbour is divided
  one_sided.triangles.resize(one_sided.triangles.size() - one_sided.parts.back());
  one_sided.parts.pop_back();
  one_sided.faces.pop_back();
  one_sided.chains.clear();
  EXPECT_THROW(apply_plan(mesh, one_sided), PlanError);
  mesh = test::openmesh_of<test::DoubleMesh>(test::grid(3, 3));
  std::mt19937 random(1);
  own.add_to(mesh, random);
  EXPECT_THROW(apply_plan(mesh, plan), PlanError);
  EXPECT_EQ(mesh.n_faces(), 18U);
}

/// Plans that were damaged at random are refused, or leave a mesh that is sound.
TEST_F(PlanOfCut, DamagedAtRandomNeverDamagesTheMesh) {
  instance.set_curves({test::as_host_curve(subject.opened->mesh(), across_faces(90, 91))});
  instance.run();
  const DivisionPlan plan = division_from(instance.cut_plan());
  std::mt19937 random(9);
  int refused = 0;
  for (int run = 0; run < 500; ++run) {
    DivisionPlan damaged = plan;
    auto& triangle = damaged.triangles[random() % damaged.triangles.size()];
    auto& vertices = damaged.vertices[random() % damaged.vertices.size()];
    const auto any = static_cast<std::uint32_t>(random() % (plan.old_vertices + 10));
    switch (random() % 5) {
      case 0:
        triangle[random() % 3] = any;
        break;
      case 1:
        triangle = damaged.triangles[random() % damaged.triangles.size()];
        break;
      case 2:
        vertices[random() % 3] = any;
        break;
      case 3:
        damaged.faces[random() % damaged.faces.size()] = any;
        break;
      default:
        damaged.chains[0].vertices[random() % damaged.chains[0].vertices.size()] = any;
    }
    auto changed = mesh;
    try {
      apply_plan(changed, damaged);
    } catch (const PlanError&) {
      ++refused;
      ASSERT_EQ(changed.n_vertices(), mesh.n_vertices());
    }
    ASSERT_TRUE(test::is_sound(changed)) << run;
  }
  EXPECT_GT(refused, 375);
}

}  // namespace
}  // namespace talweg
