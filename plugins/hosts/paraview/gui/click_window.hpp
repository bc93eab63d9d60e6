// An invisible window that detects clicks.
#pragma once

#include <cstdint>
#include <memory>

namespace talweg::paraview {

/// The window covers a part of another window and gets the clicks there. It needs no event loop,
/// since it has its own connection to the display.
class ClickWindow {
 public:
  /// Null if there is no X server, or no library for it.
  static std::unique_ptr<ClickWindow> make(std::uint32_t parent, int x, int y, int width,
                                           int height);
  ~ClickWindow();
  ClickWindow(const ClickWindow&) = delete;
  ClickWindow& operator=(const ClickWindow&) = delete;

  /// Whether a button was pressed on the window since the last call.
  [[nodiscard]] bool clicked();

 private:
  struct Connection;
  explicit ClickWindow(std::unique_ptr<Connection> connection);

  std::unique_ptr<Connection> connection_;
};

}  // namespace talweg::paraview
