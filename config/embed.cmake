# embed_files(TARGET NAMESPACE FOLDER FILE...) compiles text files into TARGET, whose sources then
# include "<folder of the CMakeLists>/embedded_files.hpp" and call NAMESPACE::embeddedFiles().
# FILEs are relative to FOLDER; their names in the table are those relative paths, in the order
# given. A changed file is embedded anew by the next build. Texts arrive byte for byte, but for
# blanks between a backslash and its line's end, which g++ 12 drops from raw literals.
function(embed_files target namespace folder)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/embedded_files)
  list(TRANSFORM ARGN PREPEND ${folder}/ OUTPUT_VARIABLE paths)
  add_custom_command(OUTPUT ${output}.cpp ${output}.hpp VERBATIM
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DNAMESPACE=${namespace} -DFOLDER=${folder}
            "-DFILES=${ARGN}" -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    DEPENDS ${paths} ${CMAKE_CURRENT_FUNCTION_LIST_FILE})
  target_sources(${target} PRIVATE ${output}.cpp ${output}.hpp)
  if(NOT TARGET embedded_files) # all of them: enough for tools that only read sources
    add_custom_target(embedded_files)
  endif()
  add_custom_target(${target}_embedded_files DEPENDS ${output}.hpp)
  add_dependencies(embedded_files ${target}_embedded_files)
  target_include_directories(${target} PRIVATE ${PROJECT_BINARY_DIR})
endfunction()

if(NOT CMAKE_SCRIPT_MODE_FILE)
  return()
endif()

# From here on: cmake -DOUTPUT= -DNAMESPACE= -DFOLDER= -DFILES= -P embed.cmake
file(WRITE ${OUTPUT}.hpp "#pragma once

#include <span>
#include <string_view>

namespace ${NAMESPACE} {

struct EmbeddedFile {
    std::string_view name;
    std::string_view text;
};
[[nodiscard]] std::span<const EmbeddedFile> embeddedFiles();

} // namespace ${NAMESPACE}
")

# A compiler need not take more than 64 kB in one literal: longer texts are neighbouring literals.
set(longest 60000)
set(table "")
foreach(file IN LISTS FILES)
  file(READ ${FOLDER}/${file} text)
  string(LENGTH "${text}" length)
  set(literals "")
  set(start 0)
  while(start EQUAL 0 OR start LESS length)
    string(SUBSTRING "${text}" ${start} ${longest} part)
    string(APPEND literals "\n     R\"EMBEDDED(${part})EMBEDDED\"")
    math(EXPR start "${start} + ${longest}")
  endwhile()
  string(APPEND table "    {\"${file}\",${literals}},\n")
endforeach()
file(WRITE ${OUTPUT}.cpp "#include \"${OUTPUT}.hpp\"

namespace ${NAMESPACE} {

namespace {
constexpr EmbeddedFile kFiles[] = {
${table}};
} // namespace

std::span<const EmbeddedFile> embeddedFiles() { return kFiles; }

} // namespace ${NAMESPACE}
")
