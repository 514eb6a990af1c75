# anteroom_compress(variable file): sets the variable to a compressed copy of the file, made at configuration and without
# a date: the same sources make the same package.
include_guard()
find_program(GZIP NAMES gzip REQUIRED)
mark_as_advanced(GZIP)
function(anteroom_compress variable file)
  get_filename_component(file ${file} ABSOLUTE)
  get_filename_component(name ${file} NAME)
  set(compressed ${PROJECT_BINARY_DIR}/compressed/${name}.gz)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/compressed)
  execute_process(COMMAND ${GZIP} -9nc ${file} OUTPUT_FILE ${compressed} COMMAND_ERROR_IS_FATAL ANY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  set(${variable} ${compressed} PARENT_SCOPE)
endfunction()
