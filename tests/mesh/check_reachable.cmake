# SPDX-License-Identifier: MIT
# cmake -DNM=nm -DOBJECT=step.so -P check_reachable.cmake: fails if what a step on a mesh can reach calls for memory, locks, exceptions
# or trigonometry; or if the step reaches no mesh, for then nothing was checked.
execute_process(COMMAND ${NM} -C ${OBJECT} OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${NM} cannot read ${OBJECT}")
endif()
message("symbols:\n${symbols}")
# Clang ends every noexcept function that it cannot see through by a catch that terminates: begin_catch is not forbidden, throw is.
string(REGEX MATCHALL "U (operator (new|delete)|malloc|calloc|realloc|free|__cxa_(allocate_exception|throw|rethrow|guard[a-z_]*|atexit|bad[a-z_]*)|std::__throw[a-z_]*|pthread[a-z_]*|(sin|cos|tan|asin|acos|atan)[a-z0-9]*)[^\n]*"
  forbidden "${symbols}")
if(forbidden)
  message(FATAL_ERROR "forbidden in a servo loop: ${forbidden}")
endif()
foreach(function Mesh::settle Mesh::entry Mesh::nearest MeshSurface::contact)
  if(NOT symbols MATCHES " t [^\n]*${function}\\(")
    message(FATAL_ERROR "${OBJECT} does not reach ${function}")
  endif()
endforeach()
