# SPDX-License-Identifier: MIT
# cmake -DNM=nm -DOBJECT=step.o -P check_symbols.cmake: fails if the object calls for memory, locks, exceptions or
# trigonometry.
execute_process(COMMAND ${NM} -uC ${OBJECT} OUTPUT_VARIABLE undefined RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${NM} cannot read ${OBJECT}")
endif()
string(REGEX MATCHALL "U (operator (new|delete)|malloc|calloc|realloc|free|__cxa_[a-z_]+|std::__throw[a-z_]*|pthread[a-z_]*|(sin|cos|tan|asin|acos|atan)[a-z0-9]*)[^\n]*"
  forbidden "${undefined}")
message("undefined symbols:\n${undefined}")
if(forbidden)
  message(FATAL_ERROR "forbidden in a servo loop: ${forbidden}")
endif()
