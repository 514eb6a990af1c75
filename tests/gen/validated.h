// Compiles, and has the result judged by SPIRV-Tools.
#pragma once

#include <gtest/gtest.h>

#include <spirv-tools/libspirv.hpp>
#include <string>

#include "gen/gen.h"

namespace anteroom::gen {

inline void expectCompiles(Stage stage, const std::string& glsl) {
  static const spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_1);
  const CompileResult result = compile(stage, glsl);
  ASSERT_FALSE(result.spirv.empty()) << result.log << glsl;
  EXPECT_TRUE(tools.Validate(result.spirv)) << glsl;
}

}  // namespace anteroom::gen
