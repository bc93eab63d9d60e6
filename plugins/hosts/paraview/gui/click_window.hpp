// A window that cannot be seen, and is asked whether it was clicked.
#pragma once

#include <cstdint>
#include <memory>

namespace talweg::paraview {

/// It lies on part of another window and takes the clicks there. It needs no event loop: it has a
/// connection of its own to the display.
class ClickWindow {
 public:
  /// Null if there is no X server, or none of its library.
  static std::unique_ptr<ClickWindow> make(std::uint32_t parent, int x, int y, int width,
                                           int height);
  ~ClickWindow();
  ClickWindow(const ClickWindow&) = delete;
  ClickWindow& operator=(const ClickWindow&) = delete;

  /// Whether a button went down on it since the last time.
  [[nodiscard]] bool clicked();

 private:
  struct Connection;
  explicit ClickWindow(std::unique_ptr<Connection> connection);

  std::unique_ptr<Connection> connection_;
};

}  // namespace talweg::paraview
