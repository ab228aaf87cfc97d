ronda_test(team_test SOURCES patrol_team_test.cpp LINKS ronda::team)
