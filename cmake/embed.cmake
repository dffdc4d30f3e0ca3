# SPDX-License-Identifier: Apache-2.0
# quern_embed(LIBRARY FILE...): puts text files into the library as zero-terminated char arrays,
# NAME.yaml as qn_NAME. The same file, run as a script (cmake -P), writes the C source of one.
if(CMAKE_SCRIPT_MODE_FILE)
    file(READ ${INPUT} bytes HEX)
    string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
    string(REPLACE "'\\x0a'," "'\\x0a',\n" bytes "${bytes}")
    file(WRITE ${OUTPUT} "extern const char ${SYMBOL}[];\nconst char ${SYMBOL}[] = {\n${bytes}0};\n")
    return()
endif()

set(quern_embed_script ${CMAKE_CURRENT_LIST_FILE})

function(quern_embed library)
    foreach(input IN LISTS ARGN)
        get_filename_component(name ${input} NAME_WE)
        set(output ${CMAKE_BINARY_DIR}/embedded/${name}.c)
        add_custom_command(OUTPUT ${output}
            COMMAND ${CMAKE_COMMAND} -DINPUT=${input} -DOUTPUT=${output} -DSYMBOL=qn_${name}
                    -P ${quern_embed_script}
            DEPENDS ${input} ${quern_embed_script} VERBATIM)
        target_sources(${library} PRIVATE ${output})
    endforeach()
endfunction()
