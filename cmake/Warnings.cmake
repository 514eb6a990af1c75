# Warnings for our own targets: target_link_libraries(... PRIVATE anteroom_warnings).
add_library(anteroom_warnings INTERFACE)
target_compile_options(anteroom_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-align
  -Woverloaded-virtual -Wimplicit-fallthrough -Werror=return-type)
