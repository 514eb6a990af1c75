# anteroom_tell_version(source...): these sources of the calling folder see ANTEROOM_VERSION, the project's, as a string.
include_guard()
function(anteroom_tell_version)
  set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_DEFINITIONS ANTEROOM_VERSION="${PROJECT_VERSION}")
endfunction()
