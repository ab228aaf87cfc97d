ronda_test(dqn_test SOURCES dqn_test.cpp LINKS ronda::learner)
ronda_test(allocation_test SOURCES allocation_test.cpp LINKS ronda::learner)
