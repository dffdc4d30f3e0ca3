# SPDX-License-Identifier: Apache-2.0
# quern_add_kernel(LIBRARY SOURCE...): compiles the contact kernel once for each instruction set.
#
# QN_ISA (base, v3 or v4) ends the kernel's public names; src/step/cpu/dispatch.c picks one when
# the program starts. gcc leaves square roots scalar without the two -fno flags. Machines other
# than x86-64 get base alone. tools/build-core-alone compiles the kernel with the same flags.
set(quern_kernel_flags -O3 -fopenmp-simd -fno-math-errno -fno-trapping-math)
set(quern_isa_flags_base "")
set(quern_isa_flags_v3 -march=x86-64-v3)
set(quern_isa_flags_v4 -march=x86-64-v4 -mprefer-vector-width=512)

if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set(quern_isas base v3 v4)
else()
    set(quern_isas base)
endif()

function(quern_add_kernel library)
    foreach(isa IN LISTS quern_isas)
        add_library(quern_kernel_${isa} OBJECT ${ARGN})
        target_compile_definitions(quern_kernel_${isa} PRIVATE QN_ISA=${isa})
        target_link_libraries(quern_kernel_${isa} PRIVATE quern_flags)
        target_compile_options(quern_kernel_${isa} PRIVATE ${quern_kernel_flags}
                               ${quern_isa_flags_${isa}})
        target_sources(${library} PRIVATE $<TARGET_OBJECTS:quern_kernel_${isa}>)
    endforeach()
endfunction()
