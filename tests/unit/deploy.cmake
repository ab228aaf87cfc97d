ronda_test(deploy_test SOURCES run_state_test.cpp transition_ledger_test.cpp LINKS ronda::deploy)
