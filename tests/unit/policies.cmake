ronda_test(policies_test SOURCES policies_test.cpp checked_file_test.cpp LINKS ronda::policies)
