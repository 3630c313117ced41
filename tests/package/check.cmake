# cmake -D BUILD=... -D CONSUMER=... -D WORK=... -D GENERATOR=... [-D OPTIONS=...] -P check.cmake
# Installs the build into a folder of its own, moves that elsewhere (an installed tree must not know where it was
# built), builds the consumer project on it, and runs both the consumer and the installed program.
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/staged)
file(RENAME ${WORK}/staged ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -G ${GENERATOR} -D CMAKE_PREFIX_PATH=${WORK}/prefix ${OPTIONS})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
run(${WORK}/prefix/bin/bondstatic --version)
file(REMOVE_RECURSE ${WORK})
