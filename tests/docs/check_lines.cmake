# check_lines(page problems): no line of a page is longer than 120 characters.
function(check_lines page problems_var)
  set(wrong ${${problems_var}})
  file(READ ${page} text)
  string(REGEX REPLACE "[][;\\]" "x" text "${text}")  # what CMake's lists take for their own
  # Bytes beyond ASCII, of which a character has up to four.
  string(REGEX REPLACE "[^\t\n -~][^\t\n -~]?[^\t\n -~]?[^\t\n -~]?" "x" text "${text}")
  string(REGEX MATCHALL "[^\n]+" lines "${text}")
  foreach(line IN LISTS lines)
    string(LENGTH "${line}" length)
    if(length GREATER 120)
      string(SUBSTRING "${line}" 0 60 start)
      list(APPEND wrong "${page}: a line of ${length} characters: ${start}...")
    endif()
  endforeach()
  set(${problems_var} ${wrong} PARENT_SCOPE)
endfunction()
