#include "CurveNodes.hh"

#include <OpenFlipper/BasePlugin/PluginFunctions.hh>

#include "DepthNode.hh"

namespace talweg::openflipper {
namespace {

using ACG::SceneGraph::BaseNode;
using ACG::SceneGraph::LineNode;
using ACG::SceneGraph::MaterialNode;
using ACG::SceneGraph::PointNode;

constexpr float kFaint = 0.3f;

PointNode* point_node(BaseNode* parent, const char* name) {
  auto* made = new PointNode(parent, name);
  made->drawMode(ACG::SceneGraph::DrawModes::POINTS_COLORED);
  made->enablePicking(false);
  return made;
}

LineNode* line_node(BaseNode* parent, const char* name, float width) {
  auto* made = new LineNode(LineNode::LineSegmentsMode, parent, name);
  made->set_line_width(width);
  made->enablePicking(false);
  return made;
}

PointNode* mark_node(BaseNode* parent, const char* name, float size) {
  auto* material = new MaterialNode(parent, std::string(name) + ": look", MaterialNode::PointSize);
  material->set_point_size(size);
  return point_node(material, name);
}

void add(LineNode& node, const LineLook& line) {
  const std::size_t n = line.points.size();
  for (std::size_t k = 0; k + 1 < n + (line.closed ? 1 : 0); ++k) {
    node.add_line(line.points[k], line.points[(k + 1) % n]);
    node.add_color(line.colour);
  }
}

}  // namespace

CurveNodes::CurveNodes()
    : root_(new MaterialNode(
          nullptr, "Talweg: drawing",
          MaterialNode::PointSize | MaterialNode::RoundPoints | MaterialNode::Blending)) {
  root_->set_point_size(6.0f);
  root_->set_round_points(true);
  root_->enable_blending(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  auto* behind = new DepthNode(GL_GREATER, root_, "Talweg: behind the body");
  auto* front = new DepthNode(GL_LEQUAL, root_, "Talweg: in front of it");
  auto* always = new DepthNode(GL_ALWAYS, root_, "Talweg: before everything");
  faint_comb_ = line_node(behind, "Talweg: hidden comb", 1.0f);
  faint_points_ = point_node(behind, "Talweg: hidden points");
  lines_ = line_node(front, "Talweg: drawn lines", 1.5f);
  leg_ = line_node(front, "Talweg: next leg", 1.0f);
  comb_ = line_node(front, "Talweg: comb", 1.0f);
  points_ = point_node(front, "Talweg: points");
  mark_rim_ = mark_node(always, "Talweg: mark's rim", 15.0f);
  mark_ = mark_node(always, "Talweg: mark", 10.0f);
  PluginFunctions::addGlobalNode(root_);
}

CurveNodes::~CurveNodes() { root_->delete_subtree(); }

void CurveNodes::set_visible(bool visible) {
  root_->set_status(visible ? BaseNode::Active : BaseNode::HideSubtree);
}

void CurveNodes::show_points(const std::vector<PointLook>& points) {
  points_->clear();
  faint_points_->clear();
  for (const PointLook& point : points) {
    points_->add_point(point.at);
    points_->add_color(point.colour);
    faint_points_->add_point(point.at);
    faint_points_->add_color(
        {point.colour[0], point.colour[1], point.colour[2], kFaint * point.colour[3]});
  }
}

void CurveNodes::show_lines(const std::vector<LineLook>& lines) {
  lines_->clear();
  for (const LineLook& line : lines) add(*lines_, line);
}

void CurveNodes::show_leg(const LineLook& leg) {
  leg_->clear();
  add(*leg_, leg);
}

void CurveNodes::show_comb(const std::vector<LineLook>& lines) {
  comb_->clear();
  faint_comb_->clear();
  for (LineLook line : lines) {
    add(*comb_, line);
    line.colour[3] *= kFaint;
    add(*faint_comb_, line);
  }
}

void CurveNodes::show_mark(const std::optional<ACG::Vec3d>& at) {
  mark_rim_->clear();
  mark_->clear();
  if (!at) return;
  mark_rim_->add_point(*at);
  mark_rim_->add_color({1, 1, 1, 1});
  mark_->add_point(*at);
  mark_->add_color({0.8f, 0.0f, 0.7f, 1});
}

}  // namespace talweg::openflipper
