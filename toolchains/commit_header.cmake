# Run at each build: writes OUTPUT with the commit of the checkout SOURCE, "+" after it where tracked files differ from it. The file is
# only touched where its text changes.
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 HEAD OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE
                ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit unknown)
else()
  execute_process(COMMAND git -C ${SOURCE} diff --quiet HEAD RESULT_VARIABLE is_changed ERROR_QUIET)
  if(is_changed)
    string(APPEND commit +)
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#define TEDAVIS_COMMIT \"${commit}\"\n" @ONLY)
