ronda_test(environments_test SOURCES observation_encoder_test.cpp observation_schemes_test.cpp
                   patrol_environment_test.cpp reward_test.cpp
           LINKS ronda::environments)
ronda_test(environment_allocation_test SOURCES environment_allocation_test.cpp LINKS ronda::environments)
