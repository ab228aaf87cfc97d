ronda_test(nn_test SOURCES gemm_test.cpp layers_test.cpp networks_test.cpp LINKS ronda::nn)
