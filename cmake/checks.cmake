# SPDX-License-Identifier: Apache-2.0
# Tests of the source and of the objects: who includes whom, which names the core exports, and
# whether the contact kernels are vectorised.
set(tools ${CMAKE_SOURCE_DIR}/tools)
add_test(NAME checks/includes COMMAND ${tools}/check-includes ${CMAKE_SOURCE_DIR})
add_test(NAME checks/symbols COMMAND ${tools}/check-symbols $<TARGET_FILE:quern_core>)
set(checks checks/includes checks/symbols)

# Only gcc keeps each block function apart, and sanitizers leave nothing to vectorise.
if(CMAKE_C_COMPILER_ID STREQUAL GNU AND NOT QUERN_SANITIZE AND TARGET quern_kernel_v4)
    add_test(NAME checks/vectorised COMMAND ${tools}/check-vectorised
             ymm $<FILTER:$<TARGET_OBJECTS:quern_kernel_v3>,INCLUDE,block>
             zmm $<FILTER:$<TARGET_OBJECTS:quern_kernel_v4>,INCLUDE,block>)
    list(APPEND checks checks/vectorised)
endif()
set_tests_properties(${checks} PROPERTIES LABELS checks SKIP_RETURN_CODE 77)
