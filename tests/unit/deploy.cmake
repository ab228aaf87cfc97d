ronda_test(deploy_test SOURCES cell_journal_test.cpp compare_arguments_test.cpp configuration_page_test.cpp
                               known_run_test.cpp matrix_text_test.cpp run_state_test.cpp status_board_test.cpp
                               transition_ledger_test.cpp
           LINKS ronda::deploy)
ronda_test(view_test
  SOURCES live_view_test.cpp screen_test.cpp sparkline_test.cpp terminal_text_test.cpp
  LINKS ronda::deploy util)
