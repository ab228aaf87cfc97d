# Installs BUILD and puts what the other tests need under FOLDER: the prefix (moved after the installation, so nothing
# may remember where it was), a map that only the prefix has, and the example away from the sources.
file(REMOVE_RECURSE ${FOLDER})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}/elsewhere
                COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${FOLDER}/elsewhere ${FOLDER}/prefix)
file(COPY_FILE ${FOLDER}/prefix/share/ronda/maps/4nodes.json
               ${FOLDER}/prefix/share/ronda/maps/installed.json)
file(COPY ${SOURCE}/examples DESTINATION ${FOLDER})
