# Fails if the page that PROGRAM writes into FOLDER is not PAGE, the one in the repository.
file(MAKE_DIRECTORY "${FOLDER}")
execute_process(COMMAND "${PROGRAM}" "${FOLDER}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND diff -u "${PAGE}" "${FOLDER}/examples.md" RESULT_VARIABLE differs)
if(differs)
  message(FATAL_ERROR "docs/examples.md is not what the mesher makes now: look at the difference, then run planar_figures docs")
endif()
