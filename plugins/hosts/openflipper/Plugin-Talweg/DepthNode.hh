// A node whose subtree is drawn only in front of the scene, or only behind it. The test is by
// depth, so every viewer has its own result, and a turn of the view costs nothing.
#pragma once

#include <string>

#include <ACG/Scenegraph/BaseNode.hh>

namespace talweg::openflipper {

class DepthNode : public ACG::SceneGraph::BaseNode {
 public:
  /// `passes` is GL_LEQUAL for the front, GL_GREATER for the back, GL_ALWAYS for both. The node
  /// belongs below a material node with blending, which is drawn after the meshes and sets the
  /// depth test, too.
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
