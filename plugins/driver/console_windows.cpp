#include <cstdlib>

#include <fcntl.h>
#include <io.h>
#include <windows.h>
// This header needs the types of the header above.
#include <shellapi.h>

#include "console.hpp"

namespace talweg::driver {
namespace {

UINT g_code_page = 0;  // the console's own, restored at the end: the console outlives the program
void (*g_act)() = nullptr;

void put_code_page_back() { SetConsoleOutputCP(g_code_page); }

/// The system calls the handler on a thread of its own. When a console is closed, the process ends
/// as soon as the handler returns, so the handler gives the work time to end in order.
BOOL WINAPI on_event(DWORD event) {
  constexpr DWORD kTimeToEndMs = 4000;  // the system waits for 5 s
  g_act();
  if (event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT) Sleep(kTimeToEndMs);
  return TRUE;
}

std::string in_utf8(const wchar_t* text) {
  const int size = WideCharToMultiByte(CP_UTF8, 0, text, -1, nullptr, 0, nullptr, nullptr);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  WideCharToMultiByte(CP_UTF8, 0, text, -1, bytes.data(), size, nullptr, nullptr);
  bytes.pop_back();  // the end mark
  return bytes;
}

}  // namespace

std::vector<std::string> command_line(int /*argc*/, char** /*argv*/) {
  _setmode(_fileno(stdout), _O_BINARY);
  _setmode(_fileno(stderr), _O_BINARY);
  g_code_page = GetConsoleOutputCP();
  if (g_code_page != 0 && SetConsoleOutputCP(CP_UTF8) != 0) std::atexit(put_code_page_back);
  int count = 0;
  wchar_t** words = CommandLineToArgvW(GetCommandLineW(), &count);
  std::vector<std::string> line;
  for (int k = 0; k < count; ++k) line.push_back(in_utf8(words[k]));
  LocalFree(words);
  return line;
}

/// Whether a stream is a terminal. NUL is a device, but no terminal.
bool is_terminal(std::FILE& stream) {
  DWORD mode = 0;
  return GetConsoleMode(reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(&stream))), &mode) != 0;
}

void at_interrupts(void (*act)()) {
  g_act = act;
  SetConsoleCtrlHandler(nullptr, FALSE);  // a program started in the background ignores Ctrl-C
  SetConsoleCtrlHandler(on_event, TRUE);
}

}  // namespace talweg::driver
