find_package(nlohmann_json 3 REQUIRED)
ronda_test(evaluation_test
  SOURCES bounds_hold_test.cpp matrix_test.cpp protocol_test.cpp reference_values_test.cpp report_test.cpp
          statistics_test.cpp
  LINKS ronda::evaluation nlohmann_json::nlohmann_json)
ronda_test(ronda_command_test
  SOURCES compare_command_test.cpp ronda_command_test.cpp policy_command_test.cpp
  LINKS ronda::run ronda::team nlohmann_json::nlohmann_json)
add_dependencies(ronda_command_test ronda)
