# What ./check and check.cmd do, on every system: see ./check --help. The exit status goes to
# build/check-status, since a script of CMake's has only 0 and 1.
cmake_minimum_required(VERSION 3.24)
include("${CMAKE_CURRENT_LIST_DIR}/check/Words.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/check/Build.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/check/Ask.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/check/Draw.cmake")

cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH here)
set(log "build/release/check.log")
set(scenes "scenes")
if(NOT EXISTS "${here}/scenes")
  set(scenes "../scenes")
endif()
file(READ "${here}/check.json" description)
json(program program)

set(quick OFF)
set(only_build OFF)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE 4 ${last})
  if(CMAKE_ARGC LESS 5)
    break()
  elseif(CMAKE_ARGV${i} STREQUAL "--quick")
    set(quick ON)
  elseif(CMAKE_ARGV${i} STREQUAL "--build")
    set(only_build ON)  # before ./check --view
  else()
    say("check [--quick]: builds your solution, asks it the public tests' questions, renders the scenes of
what you attempted, and says in a few lines how things stand. --quick leaves the pictures out.
check --view [SCENE]: the picture and its rays in the browser; a save builds, tests and renders again.
Exit status: 0 every task that you attempted passes, 1 not yet, 2 something is missing here.")
    if(CMAKE_ARGV${i} STREQUAL "--help")
      finish(0)
    endif()
    return()
  endif()
endforeach()

set(first OFF)
if(NOT EXISTS "${here}/build/release/programs.cmake")
  set(first ON)
  say("The first time, everything is built: the kit, its tests and your files. That takes about
half a minute, this once; later calls build only what you changed.")
endif()
configure()
include("${here}/build/release/programs.cmake")
compile()
if(NOT built)
  finish(1)
  return()
elseif(only_build)
  return()
endif()

set(passes ON)
set(passed "")      # tasks of which every test passes
set(attempted "")   # tasks of which tests had something to ask
set(untested "")    # tasks that no public test asks
set(crashed "")     # a suite
set(details "")
set(summary "")
if(EXISTS "${here}/build/public_tests${suffix}")
  ask_all()
  print_summary()
else()
  title("No public tests: install GoogleTest, remove build/, and call check again.")
endif()
if(NOT quick)
  draw_pictures()
endif()
print_end()
if(passes)
  finish(0)
else()
  finish(1)
endif()
