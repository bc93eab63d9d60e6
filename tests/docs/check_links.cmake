# Checks links of a Markdown file to other files of the project.

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
  set(${problems_variable} ${problems} PARENT_SCOPE)
endfunction()
