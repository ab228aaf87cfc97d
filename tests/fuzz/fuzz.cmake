# Runs the target FUZZ from the inputs in CORPUS with the words of DICT, always the same ones. What it finds (inputs with
# new coverage, and the one that fails) is put under FOUND, which is emptied first.
file(REMOVE_RECURSE ${FOUND})
file(MAKE_DIRECTORY ${FOUND})
execute_process(
  COMMAND ${FUZZ} -runs=30000 -seed=1 -max_len=2048 -timeout=5 -rss_limit_mb=1024 -dict=${DICT}
          -artifact_prefix=${FOUND}/ -print_final_stats=1 ${FOUND} ${CORPUS}
  COMMAND_ERROR_IS_FATAL ANY)
