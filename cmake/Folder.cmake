# For code without inner loops, whose running time is negligible: -Og compiles in five sixths of the time of
# -O1, which takes three quarters of that of -O3.
function(ticker_optimise_little target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Og>)
endfunction()

# All such folders get the flags of fmt and of the framework's data, so that they share precompiled headers.
ticker_precompile(folders LIBRARIES raytracer::data fmt::fmt HEADERS <fmt/core.h>)
function(ticker_compile_quickly target)
  ticker_optimise_little(${target})
  target_link_libraries(${target} PRIVATE fmt::fmt)
  target_compile_options(${target} PRIVATE $<TARGET_PROPERTY:raytracer_data,INTERFACE_COMPILE_OPTIONS>)
  ticker_use_precompiled(${target} folders)
endfunction()

# Test programs all get the framework's flags, whether or not they link with it.
if(TICKER_BUILD_TESTS)
  ticker_precompile(tests LIBRARIES raytracer::framework GTest::gtest HEADERS <gtest/gtest.h>)
endif()

# One target for each folder of the grader.
#   ticker_folder(NAME metrics [HOT] SOURCES a.cpp b.cpp PUBLIC lib... PRIVATE lib...)
# makes the static library ticker::metrics, whose headers are included as <grader/metrics/X.h>. HOT:
# the folder processes rays, pixels or samples, so it is compiled with full optimisation.
function(ticker_folder)
  cmake_parse_arguments(ARG "HOT" "NAME" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(ticker_${ARG_NAME} STATIC ${ARG_SOURCES})
  add_library(ticker::${ARG_NAME} ALIAS ticker_${ARG_NAME})
  target_include_directories(ticker_${ARG_NAME} PUBLIC "${PROJECT_SOURCE_DIR}")
  target_link_libraries(ticker_${ARG_NAME}
    PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} raytracer::warnings)
  # Where everything is built once, headers cost more than code; tests keep the preset's batches.
  set_target_properties(ticker_${ARG_NAME} PROPERTIES UNITY_BUILD_BATCH_SIZE 16)
  if(NOT ARG_HOT)
    ticker_compile_quickly(ticker_${ARG_NAME})
  endif()
endfunction()

# For static programs that run in the sandbox: sanitizers do not work within its limits, and
# coverage counters cannot be written there.
function(ticker_no_instruments target)
  target_compile_options(${target} PRIVATE
    -fno-sanitize=all -fno-profile-arcs -fno-test-coverage)
  target_link_options(${target} PRIVATE -static -fno-sanitize=all)
endfunction()

# Adds a test that takes longer than tests should: only `./tick guard slow` runs it.
#   ticker_slow_test(NAME bump COMMAND test_bump --gtest_filter=BumpSelfTest.*)
# It can try more cases there: see grader/tests/support/SlowRun.h.
function(ticker_slow_test)
  cmake_parse_arguments(ARG "ALONE" "NAME" "COMMAND" ${ARGN})
  add_test(NAME slow.${ARG_NAME} CONFIGURATIONS Slow COMMAND ${ARG_COMMAND})
  set_tests_properties(slow.${ARG_NAME} PROPERTIES
    LABELS guard TIMEOUT 1200 RUN_SERIAL ${ARG_ALONE} ENVIRONMENT TICKER_SLOW_TESTS=1)
endfunction()

# Takes tests out of a filter in GoogleTest's notation: what follows its only '-' is left out.
function(ticker_without FILTER TESTS)
  if("${${FILTER}}" MATCHES "-")
    set(${FILTER} "${${FILTER}}:${TESTS}" PARENT_SCOPE)
  else()
    set(${FILTER} "${${FILTER}}-${TESTS}" PARENT_SCOPE)
  endif()
endfunction()

# One test program for each folder: ticker_test(NAME metrics SOURCES aTest.cpp LIBRARIES lib... [LABELS
# unit] [FILTER "-*/C"] [SLOW Suite.Name...] [PARTS a=Suite.*...] [ALONE] [COST 30]). Labels: unit, render,
# grader, slow. FILTER: the tests that ctest lists, in GoogleTest's notation. SLOW: those that only `./tick
# guard slow` runs. PARTS: one entry in ctest for each of these filters, so that its tests share expensive
# set-up; else each test has an entry. ALONE: no other test runs at the same time, since these inspect the
# whole machine. COST: tests of a high cost start first, so that no long one is left at the end. Programs of
# all labels but unit get the kits.
function(ticker_test)
  cmake_parse_arguments(ARG "ALONE" "NAME;TIMEOUT;FILTER;COST" "SOURCES;LIBRARIES;LABELS;PARTS;SLOW" ${ARGN})
  if(NOT ARG_LABELS)
    set(ARG_LABELS unit)
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize|coverage")
    math(EXPR ARG_TIMEOUT "10 * ${ARG_TIMEOUT}")
  endif()
  add_executable(test_${ARG_NAME} ${ARG_SOURCES})
  target_link_libraries(test_${ARG_NAME}
    PRIVATE ${ARG_LIBRARIES} raytracer::warnings GTest::gtest GTest::gtest_main)
  ticker_optimise_little(test_${ARG_NAME})
  target_compile_options(test_${ARG_NAME} PRIVATE
    $<TARGET_PROPERTY:raytracer_framework,INTERFACE_COMPILE_OPTIONS>)
  ticker_use_precompiled(test_${ARG_NAME} tests)
  if(NOT ARG_LABELS STREQUAL unit)
    add_dependencies(test_${ARG_NAME} ticker_kit)
  endif()
  target_compile_definitions(test_${ARG_NAME} PRIVATE
    TICKER_SOURCE_DIR="${PROJECT_SOURCE_DIR}" TICKER_BINARY_DIR="${PROJECT_BINARY_DIR}")
  if(NOT ARG_COST)
    set(ARG_COST 0)
  endif()
  set(properties LABELS "${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT} RUN_SERIAL ${ARG_ALONE} COST ${ARG_COST})
  if(ARG_SLOW)
    string(REPLACE ";" ":" slow "${ARG_SLOW}")
    ticker_slow_test(NAME ${ARG_NAME}.rest COMMAND test_${ARG_NAME} "--gtest_filter=${slow}")
    ticker_without(ARG_FILTER "${slow}")
  endif()
  foreach(part IN LISTS ARG_PARTS)
    string(REGEX MATCH "^([^=]+)=(.+)$" part "${part}")
    set(filter "${CMAKE_MATCH_2}")
    if(ARG_SLOW)
      ticker_without(filter "${slow}")
    endif()
    set(name "${ARG_NAME}.${CMAKE_MATCH_1}")
    add_test(NAME ${name} COMMAND test_${ARG_NAME} "--gtest_filter=${filter}")
    set_tests_properties(${name} PROPERTIES ${properties})
  endforeach()
  if(ARG_PARTS)
    return()
  endif()
  gtest_discover_tests(test_${ARG_NAME} TEST_PREFIX "${ARG_NAME}." TEST_FILTER "${ARG_FILTER}"
    NO_PRETTY_VALUES DISCOVERY_MODE PRE_TEST
    PROPERTIES ${properties})
endfunction()
