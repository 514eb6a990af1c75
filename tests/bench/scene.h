#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pixels.h"

namespace bench {

// A steady workload. Each visit gets a fresh context: begin(), frame(0), frame(1), ..., then check().
class Scene {
 public:
  Scene(std::string name, std::string what) : name_(std::move(name)), what_(std::move(what)) {}
  virtual ~Scene() = default;

  const std::string& name() const { return name_; }
  const std::string& what() const { return what_; }

  virtual void begin() = 0;
  // Draws everything anew; the caller ends it with glFinish.
  virtual void frame(unsigned number) = 0;
  // Compares what frame(number) left with what it should have.
  virtual Verdict check(unsigned number) const = 0;

 private:
  std::string name_;
  std::string what_;
};

using Scenes = std::vector<std::unique_ptr<Scene>>;

void addDrawScenes(Scenes& scenes);
void addFillScenes(Scenes& scenes);
void addStateScenes(Scenes& scenes);
void addSkinningScenes(Scenes& scenes);
void addTargetScenes(Scenes& scenes);
Scenes allScenes();

// Projection in pixels, modelview identity: what every scene starts from.
void setPixelProjection();

}  // namespace bench
