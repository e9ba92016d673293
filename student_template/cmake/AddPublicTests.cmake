# add_public_tests(SOURCE...): the public tests of tests/, where there is GoogleTest. They are the same
# for every solution, so that an edit compiles nothing here.
function(add_public_tests)
  if(NOT TARGET GTest::gtest)
    find_package(GTest QUIET)
  endif()
  if(NOT TARGET GTest::gtest)
    message(STATUS "GoogleTest is not there: no public tests")
    return()
  endif()
  # The suite and the title of each task, for support/main.cpp.
  set(rows "")
  string(JSON count LENGTH "${exercise_description}" tasks)
  math(EXPR last "${count} - 1")
  foreach(i RANGE ${last})
    if(count EQUAL 0) # RANGE -1 has two numbers
      break()
    endif()
    string(JSON suite GET "${exercise_description}" tasks ${i} suite)
    string(JSON title GET "${exercise_description}" tasks ${i} title)
    string(APPEND rows "{\"${suite}\", \"${title}\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT Tasks.inc CONTENT "${rows}" @ONLY)

  add_library(raytracer_public_tests OBJECT EXCLUDE_FROM_ALL
    ${ARGN} support/Complaint.cpp support/main.cpp)
  target_include_directories(raytracer_public_tests PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}")
  target_include_directories(raytracer_public_tests PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
  target_link_libraries(raytracer_public_tests
    PUBLIC raytracer::framework GTest::gtest PRIVATE raytracer::warnings)
  # They are compiled once and run for a moment.
  gnu_options(raytracer_public_tests PRIVATE -O0)
endfunction()
