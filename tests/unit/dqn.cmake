ronda_test(dqn_test SOURCES dqn_test.cpp LINKS ronda::learner)
