ronda_test(replay_test
  SOURCES delivery_ledger_test.cpp rate_limiter_test.cpp replay_server_test.cpp sum_tree_test.cpp
  LINKS ronda::replay)
