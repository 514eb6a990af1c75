// ANTEROOM_DEBUG: what somebody who looks for a fault wants to see. Words, separated by commas.
#pragma once

#include <string>
#include <string_view>

namespace anteroom::render {

struct DebugOptions {
  enum class Validation { Off, Log, Abort };

  Validation validation =
      Validation::Off;     // the Khronos layer: each message is logged; Abort: the first ends
  bool markers = false;    // objects of the device are named, its commands grouped by GL call
  bool errors = false;     // every GL and EGL error is logged
  bool stats = false;      // what a context has done is logged when it ends
  bool glsl = false;       // every shader is logged
  std::string glslFolder;  // a file each, here, instead
  int captureFrame = 0;    // the frame, from 1, that RenderDoc captures; 0: none
};

// `complaint`: lines for stderr about words that are not known, or the list that `help` asks for; else empty.
DebugOptions parseDebugOptions(std::string_view words, std::string& complaint);

// What ANTEROOM_DEBUG says when this process asks first; programs that run with another's rights have none.
// Thread-safe.
const DebugOptions& debugOptions();

}  // namespace anteroom::render
