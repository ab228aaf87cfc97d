ronda_test(world_test
  SOURCES conditions_test.cpp hard_world_test.cpp patrol_world_test.cpp strategies_test.cpp strategy_traces_test.cpp
    team_beliefs_test.cpp
  LINKS ronda::world)
