// Shaders as text, for people: all of them where ANTEROOM_DEBUG=glsl asks, and those that fail always.
#pragma once

#include <volk.h>

#include <span>
#include <string>
#include <string_view>

#include "layer/cache/rows.h"

namespace anteroom::vulkan {

class VulkanDevice;

struct ShaderText {
  cache::KeyKind kind;
  cache::KeyBytes key;
};

// One line: the key in words, or the first comment of a shader that no key makes.
std::string describe(const ShaderText& shader);

// ANTEROOM_DEBUG=glsl.
void dumpShader(const VulkanDevice& device, const ShaderText& shader);

// One file of all that is known of what could not be made, anteroom-shader-<hash>.txt: in $ANTEROOM_DUMP_DIR,
// else beside the shader cache, else in the folder for temporary files. A line on stderr says where, once for
// each fault. `fault`: who refuses what; `state`: of a pipeline, else empty.
void reportFailure(const VulkanDevice& device, std::string_view fault, std::span<const ShaderText> shaders,
                   std::string_view state, std::string_view log);

// Whether a result says something of what was asked for, and not only of the memory or the device.
constexpr bool isFault(VkResult result) {
  return result != VK_SUCCESS && result != VK_ERROR_OUT_OF_HOST_MEMORY &&
         result != VK_ERROR_OUT_OF_DEVICE_MEMORY && result != VK_ERROR_DEVICE_LOST;
}

}  // namespace anteroom::vulkan
