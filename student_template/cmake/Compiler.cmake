# What the compilers need to be told, in one place: they spell their options differently.

# gnu_options(TARGET PUBLIC|PRIVATE OPTION...): for GCC and Clang; Microsoft's compiler has none of
# them.
function(gnu_options target visibility)
  if(NOT MSVC)
    target_compile_options(${target} ${visibility} ${ARGN})
  endif()
endfunction()

# For what is not performance-critical and no student edits: compiled fast. UndefinedBehaviourSanitizer
# would more than double the time for the viewer's files.
function(compile_fast target)
  gnu_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O1>)
  if(TICK1STAR_HAS_SANITIZERS)
    gnu_options(${target} PRIVATE -fno-sanitize=undefined)
  endif()
endfunction()

# Called by a project that builds alone: the language, the warnings, and, where asked for, sanitizers.
macro(set_up_compiler)
  set(CMAKE_CXX_STANDARD 20)
  set(CMAKE_CXX_STANDARD_REQUIRED ON)
  set(CMAKE_CXX_EXTENSIONS OFF)
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
  endif()
  # What students do not edit compiles in batches: half of the work is reading the same headers.
  set(CMAKE_UNITY_BUILD ON)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 7)
  add_library(raytracer_warnings INTERFACE)
  add_library(raytracer::warnings ALIAS raytracer_warnings)
  if(MSVC)
    target_compile_options(raytracer_warnings INTERFACE /W3)
    # The files are UTF-8, and Windows.h shall not define min and max.
    add_compile_options(/utf-8 /EHsc /DNOMINMAX /D_CRT_SECURE_NO_WARNINGS)
  else()
    target_compile_options(raytracer_warnings INTERFACE -Wall -Wextra)
  endif()
  if(MINGW)
    enable_language(RC)
    add_link_options(-static)  # so that the program runs where no compiler is
  endif()
  option(TICK1STAR_SANITIZE "Find the line of a crash, where the compiler has sanitizers" OFF)
  if(TICK1STAR_SANITIZE)
    include(CheckCXXSourceCompiles)
    set(CMAKE_REQUIRED_FLAGS "-fsanitize=address,undefined")
    check_cxx_source_compiles("int main() {}" TICK1STAR_HAS_SANITIZERS)
    unset(CMAKE_REQUIRED_FLAGS)
    if(TICK1STAR_HAS_SANITIZERS)
      string(APPEND CMAKE_CXX_FLAGS " -fsanitize=address,undefined -fno-omit-frame-pointer")
    endif()
  endif()
endmacro()
