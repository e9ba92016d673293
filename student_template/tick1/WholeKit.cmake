# The main tick inside of the whole kit, where its files lie beside the framework and not over it:
# raytracer_framework_tick1 for the grader's kit, and the programs tick1-template, tick1-reference.
set(own "${CMAKE_CURRENT_LIST_DIR}/framework")
set(shared "${CMAKE_CURRENT_LIST_DIR}/../framework")

add_library(raytracer_framework_tick1 STATIC
  "${own}/src/geometry/BumpySphere.cpp"
  "${own}/src/render/Render.cpp"
  "${own}/src/scene/Scene.cpp"
  "${shared}/src/math/Random.cpp"
  "${shared}/src/render/ForEachPixel.cpp"
  "${shared}/src/scene/Camera.cpp")
set_target_properties(raytracer_framework_tick1 PROPERTIES
  UNITY_BUILD OFF EXCLUDE_FROM_ALL ON)
target_include_directories(raytracer_framework_tick1 BEFORE PUBLIC "${own}/include")
target_link_libraries(raytracer_framework_tick1
  PUBLIC raytracer::data Threads::Threads PRIVATE raytracer::warnings)
target_compile_options(raytracer_framework_tick1 PUBLIC -fno-math-errno -fno-trapping-math)

get_target_property(sources raytracer_app SOURCES)
list(FILTER sources EXCLUDE REGEX PixelStory)
list(TRANSFORM sources PREPEND "${shared}/")
add_library(raytracer_app_tick1 OBJECT EXCLUDE_FROM_ALL ${sources} "${own}/app/PixelStory.cpp")
target_compile_definitions(raytracer_app_tick1 PRIVATE TICK1STAR_VERSION="${CMAKE_PROJECT_VERSION}")
target_include_directories(raytracer_app_tick1 PRIVATE "${shared}/app")
target_link_libraries(raytracer_app_tick1
  PUBLIC raytracer_framework_tick1 raytracer::io PRIVATE raytracer::warnings)

foreach(solution template reference)
  set(folder "${CMAKE_CURRENT_LIST_DIR}/exercise")
  if(solution STREQUAL reference)
    set(folder "${PROJECT_SOURCE_DIR}/reference_solution/tick1/exercise")
  endif()
  add_library(solution_tick1_${solution} OBJECT EXCLUDE_FROM_ALL
    "${folder}/Plane.cpp" "${folder}/Renderer.cpp" "${folder}/Sphere.cpp")
  target_link_libraries(solution_tick1_${solution}
    PUBLIC raytracer_framework_tick1 PRIVATE raytracer::warnings)
  add_executable(tick1-${solution} EXCLUDE_FROM_ALL)
  target_link_libraries(tick1-${solution} PRIVATE
    solution_tick1_${solution} raytracer_app_tick1 raytracer::console)
endforeach()
