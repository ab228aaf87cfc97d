ronda_test(actor_test SOURCES actor_config_test.cpp actor_test.cpp exploration_test.cpp n_step_adder_test.cpp
           LINKS ronda::actor ronda::environments)
