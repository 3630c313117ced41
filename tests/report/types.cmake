# cmake -D PAGE=... -D MODULES=... -D NODE=... -P types.cmake: checks the types of a copy of the page that lies where its
# modules are.
set(copy ${MODULES}/checked)
file(REMOVE_RECURSE ${copy})
file(GLOB_RECURSE files RELATIVE ${PAGE} ${PAGE}/*.ts ${PAGE}/*.css ${PAGE}/tsconfig.json)
list(FILTER files EXCLUDE REGEX "node_modules/")
foreach(file IN LISTS files)
  cmake_path(GET file PARENT_PATH folder)
  file(COPY ${PAGE}/${file} DESTINATION ${copy}/${folder})
endforeach()
execute_process(COMMAND ${NODE} ${MODULES}/node_modules/typescript/bin/tsc -p ${copy} COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${copy})
