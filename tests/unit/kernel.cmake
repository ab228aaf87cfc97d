ronda_test(kernel_test SOURCES kernel_test.cpp LINKS ronda::learner)
add_test(NAME "The kernel that every CPU has can be forced" COMMAND kernel_test)
set_tests_properties("The kernel that every CPU has can be forced" PROPERTIES ENVIRONMENT RONDA_KERNEL=baseline)
# The linker may keep any one of several inline functions of one name (gemm_tile.h).
add_test(NAME "Nothing but its table leaves a source compiled for one instruction set"
         COMMAND sh -c "! ${CMAKE_NM} -A --defined-only --extern-only $<JOIN:$<TARGET_OBJECTS:ronda_nn>, > | grep /loops_ | grep -v kLoops"
         COMMAND_EXPAND_LISTS)
