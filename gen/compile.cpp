#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <mutex>

#include "gen/gen.h"

namespace anteroom::gen {
namespace {

// glslang counts its users; the tables live as long as the process.
void initializeOnce() {
  static std::once_flag once;
  std::call_once(once, [] { glslang::InitializeProcess(); });
}

constexpr EShMessages kMessages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);

}  // namespace

CompileResult compile(Stage stage, const std::string& glsl) {
  initializeOnce();
  const EShLanguage language = stage == Stage::Vertex ? EShLangVertex : EShLangFragment;
  glslang::TShader shader(language);
  const char* text = glsl.c_str();
  shader.setStrings(&text, 1);
  shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
  CompileResult result;
  if (!shader.parse(GetDefaultResources(), 450, false, kMessages)) {
    result.log = shader.getInfoLog();
    return result;
  }
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(kMessages)) {
    result.log = program.getInfoLog();
    return result;
  }
  glslang::SpvOptions options;
  options.disableOptimizer = true;
  glslang::GlslangToSpv(*program.getIntermediate(language), result.spirv, &options);
  return result;
}

void warmCompiler() {
  compile(Stage::Vertex, "#version 450\nvoid main() { gl_Position = vec4(0.0); }\n");
  compile(Stage::Fragment, "#version 450\nvoid main() {}\n");
}

}  // namespace anteroom::gen
