# Output, and the little that CMake's language lacks.

# say(TEXT): to stdout.
function(say text)
  execute_process(COMMAND "${CMAKE_COMMAND}" -E echo "${text}")
endfunction()

# title(TEXT): bold on a terminal.
function(title text)
  if(is_terminal AND "$ENV{NO_COLOR}" STREQUAL "")
    string(ASCII 27 escape)
    set(text "${escape}[1m${text}${escape}[0m")
  endif()
  say("${text}")
endfunction()

# finish(STATUS)
function(finish status)
  file(WRITE "${here}/build/check-status" "${status}\n")
endfunction()

# cut_line(TEXT LINE): moves the first line of one variable to another.
function(cut_line from to)
  set(whole "${${from}}\n")
  string(FIND "${whole}" "\n" end)
  string(SUBSTRING "${whole}" 0 ${end} first)
  math(EXPR end "${end} + 1")
  string(SUBSTRING "${whole}" ${end} -1 rest)
  string(REGEX REPLACE "\n$" "" rest "${rest}")
  set(${to} "${first}" PARENT_SCOPE)
  set(${from} "${rest}" PARENT_SCOPE)
endfunction()

# last_line(TEXT LINE): the last line that is not empty.
function(last_line text line)
  string(STRIP "${text}" text)
  string(FIND "${text}" "\n" end REVERSE)
  math(EXPR end "${end} + 1")
  string(SUBSTRING "${text}" ${end} -1 found)
  set(${line} "${found}" PARENT_SCOPE)
endfunction()

# json(VARIABLE KEY...): a member of check.json, or nothing.
macro(json variable)
  string(JSON ${variable} ERROR_VARIABLE ignored GET "${description}" ${ARGN})
  if(${variable} MATCHES "-NOTFOUND$")
    set(${variable} "")
  endif()
endmacro()

# indices(VARIABLE KEY...): 0;1;2 for an array of three.
macro(indices variable)
  string(JSON count LENGTH "${description}" ${ARGN})
  set(${variable} "")
  foreach(i RANGE ${count})
    if(i LESS count)
      list(APPEND ${variable} ${i})
    endif()
  endforeach()
endmacro()
