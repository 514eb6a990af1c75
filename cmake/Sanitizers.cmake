# ANTEROOM_SANITIZE: what goes to -fsanitize=, for everything that is built ("address,undefined" or "thread").
set(ANTEROOM_SANITIZE "" CACHE STRING "sanitizers to build with")
if(ANTEROOM_SANITIZE)
  add_compile_options(-fsanitize=${ANTEROOM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${ANTEROOM_SANITIZE})
endif()
