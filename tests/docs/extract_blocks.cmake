# Extracts the code blocks of a Markdown file, to compile and run them. The treatment of a block depends on
# its language, and on a comment on the line before it:
#
#   cpp                          a function body in OUT.cpp, behind PRELUDE
#   sh                           run by OUT.sh, in the order of the file
#   json                         parsed
#   python                       run by tests/hosts/python/test_docs.py, unless it is a file as below
#   text                         nothing: output, or how a command line looks
#   <!-- file: NAME -->          written to OUT.files/NAME, for the sh blocks to use
#   <!-- needs: PROGRAM -->      an sh block that is skipped, with a message, where PROGRAM is missing; a
#                                python block, where the module is
#   <!-- not run: REASON -->     nothing, for that reason
#
# Every other block is a problem, reported in one line.

# extract_blocks(MARKDOWN OUT PRELUDE PROBLEMS): PROBLEMS is a list variable that is appended to.
function(extract_blocks markdown out prelude problems_variable)
  cmake_path(GET markdown FILENAME name)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${markdown})
  file(READ ${markdown} rest)
  set(rest "\n${rest}")
  set(line 0)
  set(includes "")
  set(functions "")
  set(calls "")
  set(shell "")
  set(problems ${${problems_variable}})
  if(rest MATCHES "\n[ \t]+```")
    list(APPEND problems "${name}: a code block is indented")
  endif()

  while(TRUE)
    string(FIND "${rest}" "\n```" at)
    if(at LESS 0)
      break()
    endif()
    string(SUBSTRING "${rest}" 0 ${at} before)
    math(EXPR at "${at} + 4")
    string(SUBSTRING "${rest}" ${at} -1 rest)
    string(REGEX REPLACE "[^\n]" "" ends "${before}")
    string(LENGTH "${ends}" count)
    math(EXPR line "${line} + ${count} + 1")  # of the opening fence
    string(FIND "${rest}" "\n" at)
    string(SUBSTRING "${rest}" 0 ${at} language)
    string(FIND "${rest}" "\n```" end)
    if(end LESS 0)
      list(APPEND problems "${name}:${line}: the code block has no end")
      break()
    endif()
    math(EXPR at "${at} + 1")
    math(EXPR length "${end} + 1 - ${at}")
    string(SUBSTRING "${rest}" ${at} ${length} code)
    math(EXPR at "${end} + 4")
    string(SUBSTRING "${rest}" ${at} -1 rest)
    string(FIND "${before}" "\n" last REVERSE)
    math(EXPR last "${last} + 1")
    string(SUBSTRING "${before}" ${last} -1 comment)
    math(EXPR code_line "${line} + 1")

    if(comment MATCHES "^<!-- not run: .+ -->$" OR language STREQUAL "text")
    elseif(comment MATCHES "^<!-- file: ([A-Za-z0-9_.]+) -->$")
      file(CONFIGURE OUTPUT ${out}.files/${CMAKE_MATCH_1} CONTENT "${code}" @ONLY)
    elseif(language STREQUAL "python")
    elseif(language STREQUAL "cpp")
      string(REGEX MATCHALL "#include [^\n]*\n" block_includes "${code}")
      string(REGEX REPLACE "#include [^\n]*\n" "\n" body "${code}")
      string(APPEND includes ${block_includes})
      string(APPEND functions "void block_at_line_${line}() {\n#include \"${prelude}\"\n  {\n"
             "#line ${code_line} \"${markdown}\"\n${body}  }\n}\n\n")
      string(APPEND calls "  std::puts(\"${name}:${line}\");\n  block_at_line_${line}();\n")
    elseif(language STREQUAL "sh")
      set(block "echo '== ${name}:${line}'\n(\n${code})\n")
      if(comment MATCHES "^<!-- needs: ([A-Za-z0-9_-]+) -->$")
        string(CONCAT block "if command -v ${CMAKE_MATCH_1}; then\n${block}else\n"
               "echo 'skipped: ${name}:${line} needs ${CMAKE_MATCH_1}, which is not here'\nfi\n")
      endif()
      string(APPEND shell "${block}")
    elseif(language STREQUAL "json")
      string(JSON unused ERROR_VARIABLE error LENGTH "${code}")
      if(error)
        list(APPEND problems "${name}:${line}: not JSON: ${error}")
      endif()
    else()
      list(APPEND problems
           "${name}:${line}: a block of \"${language}\" needs a comment that says what becomes of it")
    endif()
    string(REGEX REPLACE "[^\n]" "" ends "${code}")
    string(LENGTH "${ends}" count)
    math(EXPR line "${line} + ${count} + 1")
  endwhile()

  if(functions)
    file(CONFIGURE OUTPUT ${out}.cpp @ONLY CONTENT
"// The code blocks of ${name}.
#include \"harness.hpp\"
#include <cstdio>
${includes}
namespace {

${functions}}  // namespace

int main() {
${calls}}
")
  else()
    file(REMOVE ${out}.cpp)
  endif()
  if(shell)
    file(CONFIGURE OUTPUT ${out}.sh CONTENT "set -eu -o pipefail\n${shell}" @ONLY)
  else()
    file(REMOVE ${out}.sh)
  endif()
  set(${problems_variable} ${problems} PARENT_SCOPE)
endfunction()
