ronda_test(learner_test SOURCES learner_checkpoint_test.cpp learner_test.cpp LINKS ronda::learner)
