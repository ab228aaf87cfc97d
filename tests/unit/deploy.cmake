ronda_test(deploy_test SOURCES configuration_page_test.cpp run_state_test.cpp transition_ledger_test.cpp LINKS ronda::deploy)
