// From GL's state to the plan of a draw: only what changed is looked at again. Nothing is recorded here.
#pragma once

#include <array>
#include <cstdint>

#include "layer/render/state.h"
#include "layer/vulkan/pipelines/vertex_layout.h"
#include "layer/vulkan/plan/draw_plan.h"

namespace anteroom::vulkan {

class DrawPlanner {
 public:
  explicit DrawPlanner(VulkanDevice& device) : device_(device) {}

  DrawPlan& plan() { return plan_; }
  // The plan's target alone.
  void updateTarget(const render::State& state, gen::Groups changed);
  // All of the plan. `changed`: groups that changed since the last call that succeeded; `carried`: what each
  // vertex brings. False: a shader cannot be made.
  bool update(const render::State& state, gen::Groups changed, Carried carried);
  // Whether the arrays have the form, wherever they lie, that the keys were made for.
  bool sameArrays(const gen::State& state) const { return formsOf(state) == forms_; }
  // The plan's push constants alone, which the vertices of a draw carry that joins those before it.
  void packCarried(const render::State& state);

 private:
  struct ArrayForm {
    bool array = false;
    uint8_t size = 0;
    GLenum type = 0;
    bool operator==(const ArrayForm&) const = default;
  };
  using ArrayForms = std::array<ArrayForm, gen::kAttributeCount>;
  struct NewKeys {
    bool vertex, fragment;
  };
  static ArrayForms formsOf(const gen::State& state);

  bool keysChanged(const render::State& state, gen::Groups changed) const;
  bool updateKeys(const render::State& state, Carried carried, NewKeys& made);
  void updateConstants(const render::State& state, gen::Groups changed, const NewKeys& made);
  void updateTextures(const render::State& state);

  VulkanDevice& device_;
  DrawPlan plan_;
  ArrayForms forms_{};
  bool complete_ = false;  // it follows from the state of the last update()
};

}  // namespace anteroom::vulkan
