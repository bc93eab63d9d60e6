/*
 * Actions of other programs that affect talweg.exe on Windows.
 *   windows_habits hold FILE MS COMMAND...   COMMAND runs while FILE is being read for MS milliseconds
 *   windows_habits break MS COMMAND...       after MS milliseconds Ctrl-Break is pressed
 * Ends with COMMAND's exit code.
 */
#include <stdio.h>
#include <stdlib.h>
#include <wchar.h>
#include <windows.h>

/* The command line after the first `skipped` words, unchanged. */
static wchar_t *command_after(int skipped) {
  wchar_t *at = GetCommandLineW();
  for (int k = 0; k < skipped; ++k) {
    for (int quoted = 0; *at != 0 && (quoted || *at != L' '); ++at) quoted ^= *at == L'"';
    while (*at == L' ') ++at;
  }
  return at;
}

int wmain(int count, wchar_t **words) {
  STARTUPINFOW start = {sizeof start};
  PROCESS_INFORMATION child;
  DWORD code = 99;
  HANDLE held = INVALID_HANDLE_VALUE;
  const int hold = count > 4 && wcscmp(words[1], L"hold") == 0;
  if (count < 4) return 98;
  if (hold) {
    held = CreateFileW(words[2], GENERIC_READ, FILE_SHARE_READ, NULL, OPEN_EXISTING, 0, NULL);
    if (held == INVALID_HANDLE_VALUE) return 97;
  }
  if (!CreateProcessW(NULL, command_after(hold ? 4 : 3), NULL, NULL, TRUE, CREATE_NEW_PROCESS_GROUP, NULL, NULL,
                      &start, &child)) {
    return 96;
  }
  Sleep((DWORD)_wtoi(words[hold ? 3 : 2]));
  if (hold) {
    CloseHandle(held);
  } else if (!GenerateConsoleCtrlEvent(CTRL_BREAK_EVENT, child.dwProcessId)) {
    return 95;
  }
  WaitForSingleObject(child.hProcess, 60000);
  GetExitCodeProcess(child.hProcess, &code);
  return (int)code;
}
