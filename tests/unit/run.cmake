ronda_program(run_test_helper SOURCES run_test_helper.cpp LINKS ronda::run)
ronda_test(run_test
  SOURCES run_child_process_test.cpp run_config_test.cpp run_folder_test.cpp run_process_test.cpp
          run_values_test.cpp
  LINKS ronda::run TIMEOUT 60)
add_dependencies(run_test run_test_helper)
