#include "click_window.hpp"

#include <cstdlib>
#include <utility>

#ifdef TALWEG_HAS_XCB
#include <xcb/xcb.h>
#endif

namespace talweg::paraview {

#ifdef TALWEG_HAS_XCB

/// xcb instead of Xlib, whose errors end the program.
struct ClickWindow::Connection {
  Connection() : display(xcb_connect(nullptr, nullptr)) {}
  ~Connection() { xcb_disconnect(display); }  // closes the window, too
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  xcb_connection_t* display;
};

std::unique_ptr<ClickWindow> ClickWindow::make(std::uint32_t parent, int x, int y, int width,
                                               int height) {
  auto connection = std::make_unique<Connection>();
  xcb_connection_t* display = connection->display;
  if (xcb_connection_has_error(display) != 0 || width <= 0 || height <= 0) return nullptr;
  const xcb_window_t window = xcb_generate_id(display);
  const std::uint32_t events = XCB_EVENT_MASK_BUTTON_PRESS;
  xcb_create_window(display, 0, window, parent, static_cast<std::int16_t>(x),
                    static_cast<std::int16_t>(y), static_cast<std::uint16_t>(width),
                    static_cast<std::uint16_t>(height), 0, XCB_WINDOW_CLASS_INPUT_ONLY,
                    XCB_COPY_FROM_PARENT, XCB_CW_EVENT_MASK, &events);
  xcb_map_window(display, window);
  xcb_flush(display);
  return std::unique_ptr<ClickWindow>(new ClickWindow(std::move(connection)));
}

bool ClickWindow::clicked() {
  bool found = false;
  while (xcb_generic_event_t* event = xcb_poll_for_event(connection_->display)) {
    constexpr std::uint8_t kSent = 0x80;  // a flag in the type
    if ((event->response_type & ~kSent) == XCB_BUTTON_PRESS) found = true;
    std::free(event);
  }
  return found;
}

#else

struct ClickWindow::Connection {};

std::unique_ptr<ClickWindow> ClickWindow::make(std::uint32_t, int, int, int, int) {
  return nullptr;
}

bool ClickWindow::clicked() { return false; }

#endif

ClickWindow::ClickWindow(std::unique_ptr<Connection> connection)
    : connection_(std::move(connection)) {}

ClickWindow::~ClickWindow() = default;

}  // namespace talweg::paraview
