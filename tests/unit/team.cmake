ronda_test(team_test SOURCES patrol_team_test.cpp policy_strategy_test.cpp LINKS ronda::evaluation ronda::team)
