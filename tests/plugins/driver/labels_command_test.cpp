// talweg labels, as a user runs it.
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/jagged_curves.hpp"
#include "core/small_meshes.hpp"
#include "core/voronoi_labels.hpp"
#include "plugins/driver_runs.hpp"
#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/label_file.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg {
namespace {

class LabelsCommand : public test::DriverRuns {
 protected:
  void SetUp() override {
    DriverRuns::SetUp();
    write_mesh(file("hills.ply"), test::hills(40));
    labels_ = test::voronoi_labels(SurfaceMesh::open(test::hills(40)), 12, 3);
    std::string text;
    for (const std::int64_t label : labels_) text += std::to_string(label) + "\n";
    write("labels.txt", text);
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name)) << text;
  }
  [[nodiscard]] std::vector<std::int64_t> labels_in(const std::string& name) const {
    std::ifstream in(file(name));
    std::vector<std::int64_t> labels;
    for (std::int64_t label = 0; in >> label;) labels.push_back(label);
    return labels;
  }

  std::vector<std::int64_t> labels_;
};

/// The area of each label.
std::map<std::int64_t, double> areas(const MeshLists& lists,
                                     const std::vector<std::int64_t>& labels) {
  std::map<std::int64_t, double> area;
  for (std::size_t f = 0; f < labels.size(); ++f) {
    const Triangle& t = lists.triangles[f];
    const Point& a = lists.points[t[0]];
    area[labels[f]] += (lists.points[t[1]] - a).cross(lists.points[t[2]] - a).norm() / 2;
  }
  return area;
}

TEST_F(LabelsCommand, WritesBordersLabelsTheCutMeshAndAReport) {
  const Outcome outcome =
      run("labels hills.ply labels.txt --tau 1 -o borders.vtp --labels-out new.txt --cut cut.ply "
          "--cut-labels exact.txt --report report.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("12 regions"), std::string::npos) << outcome.out;

  const auto report = nlohmann::json::parse(bytes_of(file("report.json")));
  EXPECT_LE(report["curvature_after"].get<double>(),
            0.2 * report["curvature_before"].get<double>());
  EXPECT_EQ(report["borders"].size(), read_curves(file("borders.vtp")).size());
  EXPECT_EQ(report["regions"].size(), 12U);
  EXPECT_GT(report["time_ms"]["load"].get<double>(), 0);
  EXPECT_GT(report["time_ms"]["measure"].get<double>(), 0);

  const MeshLists cut = read_mesh(file("cut.ply"));
  const auto exact = labels_in("exact.txt");
  // The cut mesh has them, too.
  const Outcome again = run("labels cut.ply cut.ply --labels-property label --report again.json");
  ASSERT_EQ(again.code, 0) << again.err;
  const auto again_report = nlohmann::json::parse(bytes_of(file("again.json")));
  for (const auto& region : again_report["regions"]) {
    const double area = areas(cut, exact)[region["label"].get<std::int64_t>()];
    EXPECT_NEAR(region["area_before"].get<double>(), area, 1e-9 * area);
  }
  ASSERT_EQ(exact.size(), cut.triangles.size());
  const auto area = areas(cut, exact);
  for (const auto& region : report["regions"]) {
    const double told = region["area_after"].get<double>();
    EXPECT_NEAR(area.at(region["label"].get<std::int64_t>()), told, 1e-9 * told);
    EXPECT_EQ(region["parts_before"], 1);
    EXPECT_EQ(region["parts_after"], 1);
  }
  EXPECT_EQ(labels_in("new.txt").size(), labels_.size());
}

TEST_F(LabelsCommand, EndsWithItsBudget) {
  for (const char* budget : {"--budget 1e-9", "--budget-work 1"}) {
    const Outcome outcome =
        run(std::string("labels hills.ply labels.txt --labels-out new.txt ") + budget);
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.err,
              "talweg: the budget was used up; the best result was written all the same.\n");
    EXPECT_EQ(labels_in("new.txt").size(), labels_.size());
  }
  EXPECT_EQ(run("labels hills.ply labels.txt --labels-out new.txt --budget 1e6").code, 0);
  for (const char* bad : {"--budget=0", "--budget=nan", "--budget-work=-1", "--budget-work=2.5"}) {
    expect_failure(std::string("labels hills.ply labels.txt --labels-out new.txt ") + bad, 1,
                   {"budget"});
  }
}

TEST_F(LabelsCommand, RefusesBadUse) {
  write("few.txt", "1 2 3\n");
  write("half.txt", "1\n2.5\n");
  expect_failure("labels hills.ply few.txt", 2, {"few.txt", "3 labels"});
  expect_failure("labels hills.ply half.txt", 2, {"half.txt", "line 2", "2.5"});
  expect_failure("labels hills.ply", 1, {"labels"});
  expect_failure("labels hills.ply labels.txt --max-deviation 0", 1, {"max_deviation"});
  expect_failure("labels hills.ply labels.txt --cut-labels x.txt", 1, {"--cut"});
}

TEST_F(LabelsCommand, ReadsLabelsOfTheMeshFileItself) {
  const MeshLists lists = test::hills(40);
  std::string ply = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(lists.points.size()) +
                    "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                    std::to_string(labels_.size()) +
                    "\nproperty list uchar int vertex_indices\nproperty int lobe\nend_header\n";
  std::ostringstream body;
  body.precision(17);
  for (const Point& p : lists.points) body << p.x() << " " << p.y() << " " << p.z() << "\n";
  for (std::size_t f = 0; f < labels_.size(); ++f) {
    const Triangle& t = lists.triangles[f];
    body << "3 " << t[0] << " " << t[1] << " " << t[2] << " " << labels_[f] << "\n";
  }
  write("with.ply", ply + body.str());
  ASSERT_EQ(run("labels with.ply labels.txt --labels-out a.txt").code, 0);
  const Outcome own = run("labels with.ply with.ply --labels-property lobe --labels-out b.txt");
  ASSERT_EQ(own.code, 0) << own.err;
  EXPECT_EQ(bytes_of(file("a.txt")), bytes_of(file("b.txt")));
  const Outcome none = run("labels with.ply with.ply");
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("lobe"), std::string::npos) << none.err;
}

TEST_F(LabelsCommand, NamesTheRegionsOfAnAnnotation) {
  const SurfaceMesh mesh = SurfaceMesh::open(test::hills(40));
  const auto of_vertices = test::on_vertices(mesh.surface(), labels_);
  std::string annot;
  const auto number = [&](std::int64_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) annot += static_cast<char>(value >> shift);
  };
  const auto text = [&](const std::string& name) {
    number(static_cast<std::int64_t>(name.size()) + 1);
    annot += name + '\0';
  };
  number(static_cast<std::int64_t>(of_vertices.size()));
  for (std::size_t v = 0; v < of_vertices.size(); ++v) {
    number(static_cast<std::int64_t>(v));
    number(of_vertices[v] + 1);  // red only
  }
  for (const int value : {1, -2, 12}) number(value);
  text("made");
  number(12);
  for (int k = 0; k < 12; ++k) {
    number(k);
    text("lobe_" + std::to_string(k));
    for (const int value : {k + 1, 0, 0, 0}) number(value);
  }
  std::ofstream(file("lh.annot"), std::ios::binary) << annot;
  const Outcome outcome = run("labels hills.ply lh.annot --report report.json --junctions free");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("junctions and ends moved"), std::string::npos) << outcome.out;
  const auto report = nlohmann::json::parse(bytes_of(file("report.json")));
  ASSERT_EQ(report["regions"].size(), 12U);
  for (const auto& region : report["regions"]) {
    EXPECT_EQ(region["name"], "lobe_" + std::to_string(region["label"].get<int>()));
  }
  EXPECT_GT(report["network"]["moved"].get<int>(), 0);
}

TEST_F(LabelsCommand, WritesWhatLiesBesideEachBorder) {
  ASSERT_EQ(run("labels hills.ply labels.txt -o b.vtp -o b.vtk -o b.json -o b.obj -o b.ply "
                "--report report.json")
                .code,
            0);
  const auto report = nlohmann::json::parse(bytes_of(file("report.json")));
  std::string left, right, groups;
  for (const auto& border : report["borders"]) {
    const std::string l = std::to_string(border["left"].get<int>());
    const std::string r = std::to_string(border["right"].get<int>());
    left += l + "\n";
    right += r + "\n";
    groups += "g " + l + "_" + r + "\n";
  }
  const std::string vtp = bytes_of(file("b.vtp"));
  for (const auto& [name, values] : {std::pair("left", left), std::pair("right", right)}) {
    const std::size_t at = vtp.find("Name=\"" + std::string(name) + "\"");
    ASSERT_NE(at, vtp.npos);
    EXPECT_EQ(vtp.compare(vtp.find('\n', at) + 1, values.size(), values), 0);
  }
  const std::string count = std::to_string(report["borders"].size());
  EXPECT_NE(bytes_of(file("b.vtk")).find("left 1 " + count + " long\n" + left), std::string::npos);
  EXPECT_NE(bytes_of(file("b.vtk")).find("right 1 " + count + " long\n" + right),
            std::string::npos);
  const auto json = nlohmann::json::parse(bytes_of(file("b.json")));
  std::string in_json, in_obj;
  for (const auto& curve : json["curves"]) {
    in_json += "g " + std::to_string(curve["left"].get<int>()) + "_" +
               std::to_string(curve["right"].get<int>()) + "\n";
  }
  EXPECT_EQ(in_json, groups);
  std::istringstream lines(bytes_of(file("b.obj")));
  for (std::string line; std::getline(lines, line);) {
    if (line[0] == 'g') in_obj += line + "\n";
  }
  EXPECT_EQ(in_obj, groups);
  for (const char* name : {"b.vtp", "b.vtk", "b.json"}) {  // and the curves come back
    EXPECT_EQ(read_curves(file(name)).size(), report["borders"].size()) << name;
  }
}

/// A sheet of 8 x 8 squares with labels of its vertices: 0 left of x = 4.5, 1 right of it, and an
/// island of one vertex in each.
class IslandLabels : public LabelsCommand {
 protected:
  void SetUp() override {
    LabelsCommand::SetUp();
    const MeshLists sheet = test::grid(8, 8);
    write_mesh(file("plane.off"), sheet);
    std::ostringstream whole, real;
    real << std::scientific;
    real.precision(18);
    for (std::size_t v = 0; v < sheet.points.size(); ++v) {
      drawn_.push_back(sheet.points[v].x() > 4.5 ? 1 : 0);
    }
    drawn_[2 * 9 + 2] = 7;
    drawn_[6 * 9 + 6] = 9;
    for (const std::int64_t label : drawn_) {
      whole << label << "\n";
      real << static_cast<double>(label) << "\n";
    }
    write("whole.txt", whole.str());
    write("real.txt", real.str());
  }

  std::vector<std::int64_t> drawn_;
};

TEST_F(IslandLabels, ComeBackPerVertexAndNoneIsLost) {
  const Outcome outcome =
      run("labels plane.off whole.txt --labels-out new.txt --report report.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(labels_in("new.txt"), drawn_);
  const char* told =
      "Labels 7 (1 vertex) and 9 (1 vertex) cover no face: their vertices keep them.";
  EXPECT_NE(outcome.out.find(told), std::string::npos) << outcome.out;
  EXPECT_NE(bytes_of(file("report.json")).find(told), std::string::npos);
  // As numpy.savetxt writes them.
  ASSERT_EQ(run("labels plane.off real.txt --labels-out real-new.txt -o b.vtp").code, 0);
  EXPECT_EQ(bytes_of(file("real-new.txt")), bytes_of(file("new.txt")));
}

TEST_F(IslandLabels, AreNamedWhereFacesCannotHaveThem) {
  const Outcome outcome = run("labels plane.off whole.txt --labels-per face --labels-out new.txt");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(labels_in("new.txt").size(), 128U);
  EXPECT_NE(outcome.out.find("Labels 7 (1 vertex) and 9 (1 vertex) cover no face: the new labels "
                             "of faces do not have them (use --labels-per vertex)."),
            std::string::npos)
      << outcome.out;
}

TEST_F(IslandLabels, AreWrittenInTheFormatThatTheEndingNames) {
  for (const char* name : {"new.annot", "new.label.gii", "new.ply", "new.vtk", "new.vtp", "new.csv",
                           "new.npy", "new.dpv"}) {
    ASSERT_EQ(run(std::string("labels plane.off whole.txt --labels-out ") + name).code, 0) << name;
    EXPECT_EQ(read_label_file(file(name), {}).labels, drawn_) << name;
  }
  EXPECT_EQ(read_mesh(file("new.ply")).triangles, read_mesh(file("plane.off")).triangles);
  expect_failure("labels plane.off whole.txt --labels-out new.label", 2,
                 {"new.label", "one label"});
  expect_failure("labels plane.off whole.txt --labels-out new.nii", 2,
                 {"new.nii", "known are", ".annot"});
  expect_failure("labels plane.off whole.txt --labels-per face --labels-out new2.annot", 2,
                 {"new2.annot", "of vertices"});
  expect_failure("labels plane.off whole.txt --cut c.ply --cut-labels c.annot", 2, {"c.annot"});
  expect_failure("labels plane.off whole.txt --labels-per vertex", 1, {"--labels-out"});
}

TEST_F(IslandLabels, ComeWithABorderFileOfWorkbench) {
  ASSERT_EQ(run("labels plane.off whole.txt -o lh.border -o b.json").code, 0);
  const auto borders = read_curves(file("lh.border"));
  EXPECT_EQ(borders.size(), read_curves(file("b.json")).size());
  EXPECT_NE(bytes_of(file("lh.border")).find("SurfaceNumberOfVertices=\"81\""), std::string::npos);
  // A border is smoothed again, and measured.
  EXPECT_EQ(run("measure plane.off lh.border b.json --report m.json").code, 0);
  const auto report = nlohmann::json::parse(bytes_of(file("m.json")));
  EXPECT_LE(report["deviation_to_other_max"].get<double>(), 1e-12);
}

TEST_F(LabelsCommand, GivesADroppedFaceTheLabelThatItHad) {
  // A face at the end that uses a vertex twice; repair drops it.
  const MeshLists lists = test::hills(40);
  std::ostringstream off;
  off.precision(17);
  off << "OFF\n" << lists.points.size() << " " << lists.triangles.size() + 1 << " 0\n";
  for (const Point& p : lists.points) off << p.x() << " " << p.y() << " " << p.z() << "\n";
  for (std::size_t f = 0; f <= lists.triangles.size(); ++f) {
    const Triangle& five = lists.triangles[5];
    const Triangle t =
        f < lists.triangles.size() ? lists.triangles[f] : Triangle{five[0], five[0], five[1]};
    off << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  }
  write("twice.off", off.str());
  write("more.txt", bytes_of(file("labels.txt")) + "4711\n");
  const Outcome outcome = run("labels twice.off more.txt --repair --labels-out new.txt");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto faces = labels_in("new.txt");
  ASSERT_EQ(faces.size(), lists.triangles.size() + 1);
  EXPECT_EQ(faces.back(), 4711);
  // With labels of vertices, the dropped face has the label of its first corner.
  const auto of_vertices = test::on_vertices(SurfaceMesh::open(lists).surface(), labels_);
  std::string text;
  for (const std::int64_t label : of_vertices) text += std::to_string(label) + "\n";
  write("vertices.txt", text);
  ASSERT_EQ(
      run("labels twice.off vertices.txt --repair --labels-per face --labels-out new.txt").code, 0);
  EXPECT_EQ(labels_in("new.txt").back(), of_vertices[lists.triangles[5][0]]);
}

}  // namespace
}  // namespace talweg
