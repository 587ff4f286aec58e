# tedavis_embed(TARGET HEADER NAMESPACE FILE...): writes HEADER below build/generated with one constexpr byte array a
# file, `k_<file name with _ for every other character>`, and its size. Binary-safe; regenerated when a file changes.
function(tedavis_embed target header namespace)
  set(output ${CMAKE_BINARY_DIR}/generated/${header})
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DNAMESPACE=${namespace} "-DFILES=${ARGN}" -P ${CMAKE_SOURCE_DIR}/toolchains/embed_files_script.cmake
    DEPENDS ${ARGN} ${CMAKE_SOURCE_DIR}/toolchains/embed_files_script.cmake
    VERBATIM COMMENT "Embedding ${header}")
  target_sources(${target} PRIVATE ${output})
endfunction()
