// A depth node draws what hangs below it only where it is in front of the scene, or only where it
// is behind. Each viewer has its own front, and turning the view costs nothing.
#pragma once

#include <string>

#include <ACG/Scenegraph/BaseNode.hh>

namespace talweg::openflipper {

class DepthNode : public ACG::SceneGraph::BaseNode {
 public:
  /// `passes`: GL_LEQUAL in front, GL_GREATER behind, GL_ALWAYS both. It belongs below the node of
  /// a material that blends, which is drawn after the meshes and sets this for itself.
  DepthNode(GLenum passes, ACG::SceneGraph::BaseNode* parent, const std::string& name)
      : BaseNode(parent, name), passes_(passes) {}
  ACG_CLASSNAME(DepthNode)

  using BaseNode::enter;
  using BaseNode::leave;
  void enter(ACG::GLState& state, const ACG::SceneGraph::DrawModes::DrawMode& /*mode*/) override {
    before_ = state.depthFunc();
    state.set_depthFunc(passes_);
  }
  void leave(ACG::GLState& state, const ACG::SceneGraph::DrawModes::DrawMode& /*mode*/) override {
    state.set_depthFunc(before_);
  }

 private:
  GLenum passes_, before_ = GL_LESS;
};

}  // namespace talweg::openflipper
