ronda_test(graph_test
  SOURCES
    graph/patrol_graph_test.cpp
    graph/shortest_paths_test.cpp
    graph/dot_graph_file_test.cpp
    graph/node_link_file_test.cpp
    graph/shipped_maps_test.cpp
    graph/closed_walk_test.cpp
    graph/bounds_test.cpp
    graph/christofides_test.cpp
    graph/closed_walk_bound_test.cpp
    graph/covering_bound_test.cpp
    graph/fluid_bound_test.cpp
  LINKS ronda::world ${GLPK_LIBRARY})
target_include_directories(graph_test SYSTEM PRIVATE ${GLPK_INCLUDE_DIR})
