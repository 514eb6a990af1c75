# Chapters of a GoogleTest binary as CTest entries: one process a chapter, since a display and a device are dearer
# than a case, and the first line of a failure names the chapter.

# some_chapter -> SomeChapter, the name of the test suites in some_chapter.cpp.
function(anteroom_suite_name result chapter)
  string(REPLACE "_" ";" words ${chapter})
  set(suite "")
  foreach(word ${words})
    string(SUBSTRING ${word} 0 1 initial)
    string(SUBSTRING ${word} 1 -1 rest)
    string(TOUPPER ${initial} initial)
    string(APPEND suite ${initial}${rest})
  endforeach()
  set(${result} ${suite} PARENT_SCOPE)
endfunction()

# anteroom_add_chapter(binary chapter filter [VARIANT name] [ENVIRONMENT ...]): binary.chapter or binary.chapter.name.
function(anteroom_add_chapter binary chapter filter)
  cmake_parse_arguments(ARG "" "VARIANT" "ENVIRONMENT" ${ARGN})
  string(REPLACE "_conformance" "" prefix ${binary})
  set(name ${prefix}.${chapter})
  if(ARG_VARIANT)
    string(APPEND name .${ARG_VARIANT})
  endif()
  add_test(NAME ${name} COMMAND ${binary} --gtest_brief=1 --gtest_filter=${filter})
  # A filter that matches nothing would pass.
  set_tests_properties(${name} PROPERTIES LABELS "${prefix}" FAIL_REGULAR_EXPRESSION "] 0 tests from"
    ENVIRONMENT "EGL_PLATFORM=surfaceless;ANTEROOM_DEBUG=validation=fatal;ANTEROOM_CACHE=off;${ARG_ENVIRONMENT}")
endfunction()

# anteroom_add_suites(folder chapter...): the files of chapters are added to the binary folder_tests, whose suites are
# folder.chapter. In some_chapter.cpp a suite's name begins with SomeChapter.
function(anteroom_add_suites folder)
  foreach(chapter IN LISTS ARGN)
    target_sources(${folder}_tests PRIVATE ${chapter}.cpp)
    anteroom_suite_name(suite ${chapter})
    add_test(NAME ${folder}.${chapter} COMMAND ${folder}_tests --gtest_brief=1 --gtest_filter=${suite}*:*/${suite}*)
    # A filter that matches nothing would pass.
    set_tests_properties(${folder}.${chapter} PROPERTIES FAIL_REGULAR_EXPRESSION "] 0 tests from")
  endforeach()
endfunction()
