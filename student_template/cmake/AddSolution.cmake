set(framework_dir "${CMAKE_CURRENT_LIST_DIR}/../framework")

# Builds tick1star-<name> from one solution's folder, and public_tests-<name> where there is
# GoogleTest. Solutions define the same symbols, so no two of them may share a program.
function(add_solution name directory)
  # Names that begin with a dot are the systems' own: locks of Emacs, attributes of macOS.
  file(GLOB sources CONFIGURE_DEPENDS "${directory}/[!.]*.cpp")
  add_library(solution_${name} OBJECT ${sources})
  # Two files of a student may give two things the same name.
  set_target_properties(solution_${name} PROPERTIES UNITY_BUILD OFF)
  target_link_libraries(solution_${name} PUBLIC raytracer::framework PRIVATE raytracer::warnings)

  add_executable(tick1star-${name})
  target_link_libraries(tick1star-${name} PRIVATE
    solution_${name} raytracer::app raytracer::console)
  use_utf8(tick1star-${name})

  if(TARGET raytracer_public_tests)
    add_executable(public_tests-${name})
    target_link_libraries(public_tests-${name} PRIVATE solution_${name} raytracer_public_tests)
  endif()
  add_view_home(tick1star-${name} "${directory}")
endfunction()

# File names are UTF-8 inside the program: Windows has to be told.
function(use_utf8 target)
  if(MSVC)
    target_sources(${target} PRIVATE "${framework_dir}/app/utf8.manifest")
  elseif(WIN32)
    target_sources(${target} PRIVATE "${framework_dir}/app/utf8.rc")
  endif()
endfunction()
