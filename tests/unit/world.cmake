ronda_test(world_test
  SOURCES patrol_world_test.cpp strategies_test.cpp
  LINKS ronda::world)
