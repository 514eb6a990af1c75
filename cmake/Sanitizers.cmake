# ANTEROOM_SANITIZE: what goes to -fsanitize=, for everything that is built ("address,undefined" or "thread").
set(ANTEROOM_SANITIZE "" CACHE STRING "sanitizers to build with")
if(ANTEROOM_SANITIZE)
  add_compile_options(-fsanitize=${ANTEROOM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${ANTEROOM_SANITIZE})
  add_library(anteroom_keep_loaded OBJECT ${CMAKE_CURRENT_LIST_DIR}/keep_loaded.c)
  link_libraries($<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:$<TARGET_OBJECTS:anteroom_keep_loaded>>)
  add_link_options(-Wl,--export-dynamic-symbol=dlclose)
endif()
