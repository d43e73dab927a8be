# Runs the built drivers, in the current folder, on each file of cases/ and compares what they print
# with the file of the same name and .expected: cmake -P compare.cmake. Arguments stand in .args.
# SPDX-License-Identifier: MIT

set(cases ${CMAKE_CURRENT_LIST_DIR}/cases)
foreach(driver machine script tree)
    set(ending_machine scxml)
    set(ending_script scripts)
    set(ending_tree tree.xml)
    file(GLOB files ${cases}/*.${ending_${driver}})
    if(NOT files)
        message(FATAL_ERROR "no cases for ${driver}_driver")
    endif()
    foreach(file IN LISTS files)
        set(arguments "")
        if(EXISTS ${file}.args)
            file(STRINGS ${file}.args words)
            separate_arguments(arguments UNIX_COMMAND "${words}")
        endif()
        execute_process(COMMAND ./${driver}_driver ${file} ${arguments}
            OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
        file(READ ${file}.expected expected)
        if(NOT printed STREQUAL expected)
            message(FATAL_ERROR "${file}\nexpected:\n${expected}printed:\n${printed}")
        endif()
    endforeach()
endforeach()
