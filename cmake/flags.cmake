# SPDX-License-Identifier: Apache-2.0
# quern_flags: the language, the warnings and the sanitizers that everything of ours is built with.
#
# Contraction (fused multiply-add) is off everywhere, so that every compiler and instruction set
# gives the same bits.
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Release or Debug" FORCE)
endif()
set(CMAKE_C_FLAGS_RELEASE "-O2 -g")
set(CMAKE_C_STANDARD 17)
set(CMAKE_C_STANDARD_REQUIRED ON)
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

add_library(quern_flags INTERFACE)
target_include_directories(quern_flags INTERFACE ${CMAKE_SOURCE_DIR}/src ${CMAKE_SOURCE_DIR}/include)
target_compile_definitions(quern_flags INTERFACE _GNU_SOURCE)
target_compile_options(quern_flags INTERFACE
    -ffp-contract=off
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes
    # clang takes INFINITY and NAN, which are floats, for promotions
    $<$<C_COMPILER_ID:GNU>:-Wdouble-promotion>)
if(QUERN_WERROR)
    target_compile_options(quern_flags INTERFACE -Werror)
endif()
if(QUERN_SANITIZE)
    target_compile_options(quern_flags INTERFACE -fsanitize=${QUERN_SANITIZE}
                           -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(quern_flags INTERFACE -fsanitize=${QUERN_SANITIZE})
endif()
