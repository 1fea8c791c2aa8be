# How every target of Toile is built: warnings are errors, floating point is not contracted (results must not depend on
# the machine's fused multiply-add), sanitizers and coverage by preset.

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

find_package(Threads REQUIRED)
find_package(fmt REQUIRED)

add_library(toile_options INTERFACE)
target_include_directories(toile_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(toile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror -ffp-contract=off)
# gcc 12 sees an overlap in std::string's operator+ that is not there (gcc bug 105329).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(toile_options INTERFACE -Wno-restrict)
  # A unit of many sources needs more memory than gcc lets it have before it collects garbage, again and again: half a
  # gigabyte before the first time saves a sixth of the time.
  target_compile_options(toile_options INTERFACE "SHELL:--param ggc-min-heapsize=524288 --param ggc-min-expand=200")
endif()
target_link_libraries(toile_options INTERFACE fmt::fmt)
if(TOILE_SANITIZE)
  target_compile_options(toile_options INTERFACE -fsanitize=${TOILE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(toile_options INTERFACE -fsanitize=${TOILE_SANITIZE})
endif()
if(TOILE_COVERAGE)
  target_compile_options(toile_options INTERFACE --coverage)
  target_link_options(toile_options INTERFACE --coverage)
endif()

# toile_quick_to_build(NAME LEVEL): code that spends no time worth the optimiser's is built at -O1, in three fifths of
# the time; tests, which spend theirs in what they call, at -O0, in half of it.
function(toile_quick_to_build name level)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:${level}>)
endfunction()

# toile_library(NAME [QUICK level] DIRS a b c LINKS x y PRIVATE z): all sources directly in those folders; links are
# visible to users of the headers, private ones are not.
function(toile_library name)
  cmake_parse_arguments(ARG "" "QUICK" "DIRS;LINKS;PRIVATE" ${ARGN})
  set(sources "")
  foreach(dir IN LISTS ARG_DIRS)
    file(GLOB found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${dir}/*.cpp)
    list(APPEND sources ${found})
  endforeach()
  if(sources)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC toile_options ${ARG_LINKS} PRIVATE ${ARG_PRIVATE})
    if(ARG_QUICK)
      toile_quick_to_build(${name} ${ARG_QUICK})
    endif()
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE toile_options ${ARG_LINKS})
  endif()
endfunction()

# toile_test(NAME DIRS a b LINKS x y): one GoogleTest program of all *_test.cpp in those folders, known to CTest test by
# test. Few programs and large units: the headers of the tests' libraries cost every unit three seconds.
set(TOILE_TEST_UNIT 20)
function(toile_test name)
  cmake_parse_arguments(ARG "" "" "DIRS;LINKS" ${ARGN})
  set(sources "")
  foreach(dir IN LISTS ARG_DIRS)
    file(GLOB found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${dir}/*_test.cpp)
    list(APPEND sources ${found})
  endforeach()
  if(NOT sources)
    return()
  endif()
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE toile_options ${ARG_LINKS} rapidcheck GTest::gtest GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE TOILE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  toile_quick_to_build(${name} -O0)
  set_target_properties(${name} PROPERTIES UNITY_BUILD_BATCH_SIZE ${TOILE_TEST_UNIT})
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 300 ENVIRONMENT RC_PARAMS=seed=1)
endfunction()
