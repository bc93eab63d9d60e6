# Checks links of a Markdown file to other files of the project, and paths of sources that it names in
# backticks: `core/io/mesh_off.cpp`, or `core/io/mesh_writer` for a header and its source.

# check_links(MARKDOWN PROBLEMS): PROBLEMS is a list variable that is appended to.
function(check_links markdown problems_variable)
  cmake_path(GET markdown PARENT_PATH folder)
  cmake_path(GET markdown FILENAME name)
  file(READ ${markdown} text)
  string(REGEX REPLACE "\n```[^`]*\n```" "" text "${text}")
  string(REPLACE "](" "\nlink:" text "${text}")
  string(REGEX REPLACE "[][;]" "" text "${text}")  # brackets and semicolons would break CMake's lists
  string(REGEX MATCHALL "\nlink:[^)# \n]+" links "${text}")
  set(problems ${${problems_variable}})
  foreach(link ${links})
    string(REPLACE "\nlink:" "" link "${link}")
    if(NOT link MATCHES "^[a-z]+:" AND NOT EXISTS ${folder}/${link})
      list(APPEND problems "${name}: the link to ${link} leads nowhere")
    endif()
  endforeach()
  string(REGEX MATCHALL "`(intrinsic|heat|core|plugins|tests|docs)/[^`* \n]+`" paths "${text}")
  foreach(path ${paths})
    string(REPLACE "`" "" path "${path}")
    set(file ${PROJECT_SOURCE_DIR}/${path})
    if(NOT path MATCHES "NAME|TARGET" AND NOT EXISTS ${file} AND NOT EXISTS ${file}.hpp)
      list(APPEND problems "${name}: there is no ${path}")
    endif()
  endforeach()
  set(${problems_variable} ${problems} PARENT_SCOPE)
endfunction()
