# cmake -DOUT=file.cpp -P GeneratorVersion.cmake -- a.cpp b.glsl ...
# Writes a hash over the names and contents of the files as the function behind layer/cache/generator_version.h.
set(lines)
set(after FALSE)
foreach(i RANGE ${CMAKE_ARGC})
  set(file "${CMAKE_ARGV${i}}")
  if(after AND NOT file STREQUAL "")
    get_filename_component(name "${file}" NAME)
    file(SHA256 "${file}" hash)
    list(APPEND lines "${name} ${hash}")
  elseif(file STREQUAL "--")
    set(after TRUE)
  endif()
endforeach()
list(SORT lines)
string(SHA256 hash "${lines}")
string(SUBSTRING ${hash} 0 16 hash)
file(WRITE "${OUT}" "// Made by GeneratorVersion.cmake.\n#include \"layer/cache/generator_version.h\"\n\n"
  "namespace anteroom::cache {\n\nstd::string_view generatorVersion() { return \"${hash}\"; }\n\n"
  "}  // namespace anteroom::cache\n")
