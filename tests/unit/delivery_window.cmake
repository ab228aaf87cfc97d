ronda_test(delivery_window_test SOURCES ${CMAKE_CURRENT_LIST_DIR}/delivery_window_test.cpp LINKS ronda::rl)
