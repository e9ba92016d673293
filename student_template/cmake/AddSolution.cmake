# Builds tick1star-<name> from one solution's folder, and public_tests-<name> where there is
# GoogleTest. Solutions define the same symbols, so no two of them may share a program.
function(add_solution name directory)
  add_library(solution_${name} OBJECT
    "${directory}/BumpySphere.cpp" "${directory}/Renderer.cpp")
  target_link_libraries(solution_${name} PUBLIC raytracer::framework PRIVATE raytracer::warnings)

  add_executable(tick1star-${name})
  target_link_libraries(tick1star-${name} PRIVATE solution_${name} raytracer::app)

  if(TARGET raytracer_public_tests)
    add_executable(public_tests-${name})
    target_link_libraries(public_tests-${name} PRIVATE solution_${name} raytracer_public_tests)
  endif()
endfunction()
